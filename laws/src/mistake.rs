//! The mistakes that renderers make, and the color that each would give.

use std::fmt;

macro_rules! mistakes {
    ($($(#[$attribute:meta])* $mistake:ident = $name:literal,)*) => {
        /// A known mistake. Where a renderer breaks a law, the report names the mistake that makes
        /// the same colors.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Mistake {
            $($(#[$attribute])* $mistake,)*
        }

        impl Mistake {
            /// All known mistakes.
            pub const ALL: &[Self] = &[$(Self::$mistake,)*];

            /// What is wrong, in words.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$mistake => $name,)*
                }
            }
        }
    };
}

mistakes! {
    /// N·L ≤ 0 does not turn the highlight off.
    HighlightNotGated = "the highlight is not gated on N·L > 0, so faces turned away from a light have one",
    /// R = L − 2(N·L)N.
    ReflectionReversed = "R points the wrong way: reflect() of GLSL and HLSL takes −L",
    /// H = L + V.
    HalfVectorNotNormalized = "H = L + V is not normalized",
    /// H = (L + V)/2.
    HalfVectorHalved = "H = (L + V)/2 is not normalized: half of a sum is not its direction",
    /// V has the length that it was given.
    ViewNotNormalized = "V is not normalized",
    /// N has the length that it was given.
    NormalNotNormalized = "N is not normalized after interpolation",
    /// L has the length of the way to the lamp.
    LightNotNormalized = "L is not normalized",
    /// L points from the light to the surface.
    LightReversed = "L points from the light to the surface",
    /// (R·V)^m or (N·H)^m of a negative cosine.
    PowerNotClamped = "the cosine of the highlight is not clamped to 0 before the power",
    /// N·L without max(0, …).
    DiffuseNotClamped = "N·L is not clamped to 0, so light from behind is subtracted",
    /// |N·L| in place of max(0, N·L).
    DiffuseTwoSided = "the diffuse term takes |N·L|, so light from behind is added",
    /// k_d I N·L/π.
    DiffuseOverPi = "the diffuse term is divided by π",
    /// 1/(a + bq² + cq⁴).
    SquaredDistance = "the attenuation gets q² for q",
    /// 1/(c + bq + aq²).
    CoefficientsReversed = "the coefficients of the attenuation are in reverse order",
    /// No 1/(a + bq + cq²).
    NotAttenuated = "the light is not attenuated",
    /// The highlight lacks the attenuation.
    HighlightNotAttenuated = "the highlight is not attenuated",
    /// The highlight has the square of the attenuation.
    HighlightAttenuatedTwice = "the highlight is attenuated twice",
    /// The edge of the cone is at an angle of π/180 of what it should be.
    DegreesForRadians = "the angle of the cone is taken for degrees",
    /// The edge of the cone is at half of the half-angle.
    HalfAngleHalved = "the half-angle of the cone is taken for the whole one, and halved",
    /// The edge of the cone is at twice the half-angle.
    WholeAngleForHalf = "the whole angle of the cone is used where the half belongs",
    /// The cone opens away from the axis.
    ConeReversed = "the cone opens against its axis",
    /// Spots light everything.
    ConeForgotten = "the cone of a spot is ignored",
    /// The encoding is applied to what is already encoded.
    SrgbTwice = "sRGB is applied twice",
    /// The renderer says that its colors are sRGB, and they are linear.
    SrgbForgotten = "sRGB is not applied: the colors are linear",
    /// The renderer says that its colors are linear, and they are sRGB.
    SrgbUnasked = "sRGB is applied where linear light was promised",
    /// x^(1/2.2) in place of the encoding of sRGB.
    Gamma22ForSrgb = "a gamma of 2.2 is applied for sRGB",
    /// ⌊255 c⌋/255.
    LevelsTruncated = "levels are truncated, not rounded",
    /// k_s k_d in place of k_s.
    HighlightTimesDiffuse = "k_s is multiplied by k_d",
    /// k_s I (N·H)^m N·L.
    HighlightTimesCosine = "the highlight is multiplied by N·L",
    /// k_s (N·H)^m, whatever the color of the light.
    HighlightWithoutLight = "the highlight does not have the color of the light",
    /// Phong's highlight for Blinn's, and the other way round.
    OtherModel = "Phong's highlight is used for Blinn's, or Blinn's for Phong's",
    /// k_a I_a for each light.
    AmbientPerLight = "the ambient term is added once for each light",
    /// k_a I_a/(a + bq + cq²) for each light.
    AmbientAttenuated = "the ambient term is added for each light, attenuated",
    /// k_d I_a in place of k_a I_a.
    AmbientByDiffuse = "the ambient term takes k_d for k_a",
    /// No k_a I_a.
    AmbientForgotten = "the ambient term is missing",
    /// Blue, green, red.
    ChannelsSwapped = "red and blue are swapped",
    /// Every channel gets the mean of the light's.
    LightInGray = "the light's color is averaged, so channels bleed into each other",
    /// clamp(light 1) + clamp(light 2).
    EachLightClamped = "each light is clamped before the sum, in place of the sum",
    /// Only the first light counts.
    FirstLightOnly = "only the first light counts",
    /// Only the last light counts.
    LastLightOnly = "only the last light counts: = for +=",
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.name())
    }
}
