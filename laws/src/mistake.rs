//! The mistakes that renderers make, and the color that each would give.

use std::f64::consts::{FRAC_1_PI, PI};
use std::fmt;

macro_rules! mistakes {
    ($($(#[$attribute:meta])* $mistake:ident $([$($value:expr),*])? = $name:literal,)*) => {
        /// A known mistake. Where a renderer breaks a law, the report names the mistake that makes
        /// the same colors.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Mistake {
            $($(#[$attribute])* $mistake,)*
        }

        impl Mistake {
            /// All known mistakes.
            pub const ALL: &[Self] = &[$(Self::$mistake,)*];

            /// What is wrong, in words; `{}` stands for a number that the renderer has in its code.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$mistake => $name,)*
                }
            }

            /// The name in JSON, which does not change.
            #[must_use]
            pub fn id(self) -> &'static str {
                match self {
                    $(Self::$mistake => stringify!($mistake),)*
                }
            }

            /// The numbers that are tried for `{}`.
            #[must_use]
            pub fn values(self) -> &'static [f64] {
                match self {
                    $($(Self::$mistake => &[$($value),*],)?)*
                    _ => &[],
                }
            }
        }
    };
}

impl Mistake {
    /// Whether it explains any color that is off by little, so that others beside it explain no more.
    pub(crate) fn is_loose(self) -> bool {
        self.is_rough() || self == Self::ExpandedSquares
    }

    /// Whether it explains any color that is off by so little.
    pub(crate) fn is_rough(self) -> bool {
        matches!(self, Self::InBits | Self::Imprecise)
    }
}

/// A mistake with its number, if it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// The mistake.
    pub mistake: Mistake,
    /// The number in it; 0 if it has none.
    pub value: f64,
}

impl Fault {
    /// Every mistake with every number that is tried for it.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        Mistake::ALL.iter().flat_map(|&mistake| {
            let values = match mistake.values() {
                [] => &[0.0],
                values => values,
            };
            values.iter().map(move |&value| Self { mistake, value })
        })
    }
}

impl From<Mistake> for Fault {
    /// The first of its numbers.
    fn from(mistake: Mistake) -> Self {
        let value = mistake.values().first().copied().unwrap_or(0.0);
        Self { mistake, value }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.mistake.name().replace("{}", &self.value.to_string()))
    }
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
    /// As of a point light.
    RightAngleForgotten = "the cone of a spot is ignored where its half-angle is 90°",
    /// The edge is at the cosine of an angle whose cosine was not taken.
    ConeAngleForCosine = "the angle of the cone is compared with a cosine",
    /// The sine of the angle.
    ConeBySine = "the edge of the cone is at the sine of its angle",
    /// L is not normalized there.
    ConeByWay = "the cone is tested with the way to the lamp, which is not normalized",
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
    /// N·L ≤ 0 does not turn the highlight of a directional light off.
    HighlightNotGatedOfSuns = "the highlight of a directional light is not gated on N·L > 0",
    /// N·L ≤ 0 does not turn the highlight of a point light off.
    HighlightNotGatedOfPoints = "the highlight of a point light is not gated on N·L > 0",
    /// N·L ≤ 0 does not turn the highlight of a spot off.
    HighlightNotGatedOfSpots = "the highlight of a spot is not gated on N·L > 0",
    /// V has the length that it was given, in (R·V)^m.
    ViewNotNormalizedOfPhong = "V is not normalized in Phong's highlight",
    /// V has the length that it was given, in H.
    ViewNotNormalizedOfBlinn = "V is not normalized in Blinn's highlight",
    /// N has the length that it was given, in N·L.
    NormalNotNormalizedInDiffuse = "N is not normalized in the diffuse term",
    /// N has the length that it was given, in the highlight.
    NormalNotNormalizedInHighlight = "N is not normalized in the highlight",
    /// L has the length of the way to the lamp, in N·L.
    LightNotNormalizedInDiffuse = "L is not normalized in the diffuse term",
    /// L has the length of the way to the lamp, in the highlight.
    LightNotNormalizedInHighlight = "L is not normalized in the highlight",
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
    /// k_a I_a, and once more for each light.
    AmbientPerLightToo = "the ambient term is added once more for each light",
    /// k_a I_a for each light with N·L > 0.
    AmbientPerLightInFront = "the ambient term is added once for each light with N·L > 0",
    /// k_a I_a, and once more for each light with N·L > 0.
    AmbientPerLightInFrontToo = "the ambient term is added once more for each light with N·L > 0",
    /// k_a I_a for each light, as much as arrives of it.
    AmbientArriving = "the ambient term is added for each light, attenuated and within its cone",
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
    /// The first light is black.
    FirstLightForgotten = "the first light is left out",
    /// The last light is black.
    LastLightForgotten = "the last light is left out",
    /// Other lights have no highlight.
    HighlightOfFirstLightOnly = "only the first light has a highlight",
    /// N·V < 0 turns N to the other side.
    NormalTowardEye = "N is turned toward the eye, so the back of a surface is lit like its front",
    /// N·L < 0 turns N to the other side.
    NormalTowardLight = "N is turned toward each light",
    /// −N in place of N.
    NormalReversed = "N points into the surface",
    /// −V in place of V.
    ViewReversed = "V points from the eye to the surface",
    /// V = −p.
    EyeAtOrigin = "the eye is taken to be at the origin: V = -p",
    /// V = v − p.
    ViewTakenForEye = "v is taken for the position of the eye: V = v - p",
    /// V = (0, 0, 1).
    ViewAlongZ = "V is always (0, 0, 1)",
    /// L = position.
    PointForgotten = "L is the position of the lamp, from which p is not subtracted",
    /// q = |position|.
    DistanceFromOrigin = "the distance is that of the lamp to the origin, not to p",
    /// L of a directional light points from the light to the surface.
    SunReversed = "L of a directional light points from the light to the surface",
    /// L of a lamp points from the light to the surface.
    LampReversed = "L of a lamp points from the lamp to the surface",
    /// R = (N·L)N − L.
    ReflectionWithoutTwo = "R lacks the factor 2 of 2(N·L)N - L",
    /// (L + V)/0.
    HalfVectorUnguarded = "H is NaN where L = -V: the length of L + V is not checked before the division",
    /// (N·L + 1)/2.
    HalfLambert = "the diffuse term takes half-Lambert, (N·L + 1)/2",
    /// ((N·L + 1)/2)².
    HalfLambertSquared = "the diffuse term takes half-Lambert squared, ((N·L + 1)/2)²",
    /// (N·L + w)/(1 + w).
    Wrapped [0.5, 0.25, 0.2, 0.1, 0.3, 0.4, 0.6, 0.75] = "the diffuse term is wrapped: (N·L + {})/(1 + {})",
    /// (N·L)².
    CosineSquared = "N·L is squared",
    /// k_d I without N·L.
    CosineForgotten = "the diffuse term is not multiplied by N·L",
    /// No k_d I N·L.
    DiffuseForgotten = "the diffuse term is missing",
    /// k_d π I N·L.
    DiffuseTimesPi = "the diffuse term is multiplied by π",
    /// k_d (1 − k_s) I N·L.
    DiffuseMinusSpecular = "the diffuse term is multiplied by 1 - k_s",
    /// k_d (1 − max k_s) I N·L.
    DiffuseMinusLargest = "the diffuse term is multiplied by 1 - the largest channel of k_s",
    /// The diffuse term lacks the attenuation.
    DiffuseNotAttenuated = "the diffuse term is not attenuated",
    /// k_d N·L.
    DiffuseWithoutLight = "the diffuse term does not have the color of the light",
    /// max(0, k_d I N·L + highlight), with N·L below 0 and the highlight not gated.
    LightClampedBelow = "each light is clamped at 0, in place of its N·L: light from behind is subtracted from its highlight",
    /// max(0, the sum), with N·L below 0.
    TotalClampedBelow = "the sum of the light is clamped at 0, in place of N·L: light from behind is subtracted from that of others",
    /// 1/(a + bq + cq²)².
    AttenuatedTwice = "the light is attenuated twice",
    /// 1/q².
    InverseSquareAlone = "the attenuation is 1/q², whatever a, b and c",
    /// 1/q.
    InverseAlone = "the attenuation is 1/q, whatever a, b and c",
    /// min(limit, 1/(a + bq + cq²)).
    AttenuationAtMost [1.0, 2.0, 4.0, 10.0, 100.0] = "the attenuation is at most {}",
    /// max(limit, 1/(a + bq + cq²)).
    AttenuationAtLeast [0.01, 0.05, 0.1, 0.2, 0.25, 0.5, 0.001] = "the attenuation is at least {}",
    /// 1/(a + bq + cq² + d).
    DenominatorPlus [1.0, 0.1, 0.01, 0.001, 1e-4, 1e-5, 1e-6] = "{} is added to a + bq + cq²",
    /// max(q, least).
    DistanceAtLeast [0.01, 0.001, 0.0001, 0.1, 0.25, 0.5, 1.0] = "the distance is at least {}",
    /// 0 from this distance on.
    CulledBeyond [1000.0, 2.0, 4.0, 5.0, 8.0, 10.0, 16.0, 20.0, 25.0, 32.0, 50.0, 64.0, 100.0, 128.0, 200.0, 250.0, 256.0, 500.0, 512.0, 1024.0, 2000.0, 4096.0, 10000.0] = "lamps farther away than {} are left out",
    /// (1 − (q/r)⁴)².
    Windowed [10.0, 5.0, 8.0, 16.0, 20.0, 25.0, 32.0, 50.0, 64.0, 100.0, 200.0, 256.0, 500.0, 1000.0, 1024.0, 10000.0] = "the attenuation is windowed by (1 - (q/{})⁴)²",
    /// 1 − q/r.
    FadedTo [10.0, 5.0, 8.0, 16.0, 20.0, 25.0, 32.0, 50.0, 64.0, 100.0, 200.0, 256.0, 500.0, 1000.0, 1024.0, 10000.0] = "the attenuation fades by 1 - q/{}",
    /// max(q, least), and L is the way divided by that.
    LampDistanceAtLeast [0.01, 0.001, 0.1, 0.0001, 0.5, 1.0] = "the distance is at least {}, and L is the way to the lamp divided by it",
    /// 0 below this.
    AttenuationCutBelow [0.004, 0.01, 1.0 / 256.0, 1.0 / 255.0, 0.001, 0.005, 0.02, 0.05] = "an attenuation below {} is taken for 0",
    /// 1/(bq + cq²) has a = 1.
    ZeroConstantOne = "the attenuation takes 1 for a where a is 0",
    /// Spots have no 1/(a + bq + cq²).
    SpotsNotAttenuated = "spots are not attenuated",
    /// Point lights have no 1/(a + bq + cq²).
    PointsNotAttenuated = "point lights are not attenuated",
    /// 1/(bq + cq²).
    ConstantForgotten = "the attenuation lacks a",
    /// 1/(a + cq²).
    LinearForgotten = "the attenuation lacks bq",
    /// 1/(a + bq).
    QuadraticForgotten = "the attenuation lacks cq²",
    /// 1/(a + bq + cq).
    QuadraticByDistance = "the attenuation has cq for cq²",
    /// 1/(a + cq + bq²).
    LinearForQuadratic = "b and c of the attenuation are exchanged",
    /// 1/(1 + bq + cq²).
    ConstantOne = "the attenuation takes 1 for a",
    /// a + bq + cq².
    AttenuationInverted = "the light is multiplied by a + bq + cq², not divided",
    /// 1/√(a + bq + cq²).
    AttenuationRoot = "the attenuation is 1/√(a + bq + cq²)",
    /// ⌊m⌋.
    ShininessTruncated = "the shininess is cut to an integer",
    /// m, rounded.
    ShininessRounded = "the shininess is rounded to an integer",
    /// m + 1, m − 1.
    ShininessOff [1.0, -1.0, 2.0, 0.5] = "the shininess is off by {}",
    /// 2m, 4m, m/2, m/4.
    ShininessTimes [4.0, 2.0, 0.5, 0.25, 3.0, 128.0] = "the shininess is multiplied by {}",
    /// min(m, limit).
    ShininessAtMost [128.0, 127.0, 100.0, 64.0, 50.0, 32.0, 96.0, 120.0, 200.0, 255.0, 256.0, 500.0, 512.0, 1000.0, 1024.0, 2048.0] = "the shininess is at most {}",
    /// max(m, limit).
    ShininessAtLeast [2.0, 5.0, 10.0, 4.0, 8.0, 16.0] = "the shininess is at least {}",
    /// 2^⌊log₂ m⌋.
    ShininessToPowerOfTwo = "the shininess is cut to a power of two",
    /// 4m for Blinn's highlight.
    ShininessOfBlinnTimes [4.0, 2.0, 0.25, 0.5, 3.0] = "the shininess of Blinn's highlight is multiplied by {}",
    /// max(least, N·H)^m.
    CosineOfHighlightAtLeast [0.00001, 0.0001, 0.001, 0.01, 0.000_001] = "the cosine of the highlight is at least {}",
    /// c/(m − mc + c).
    PowerOfSchlick = "the power is Schlick's approximation, c/(m - mc + c)",
    /// |N·H|^m.
    CosineOfHighlightAbsolute = "the highlight takes the absolute value of its cosine",
    /// The factor (m + 8)/(8π).
    NormalizedByEight = "the highlight is normalized by (m + 8)/(8π)",
    /// The factor (m + 2)/(2π).
    NormalizedByTwo = "the highlight is normalized by (m + 2)/(2π)",
    /// The factor (m + 1)/(2π).
    NormalizedByOne = "the highlight is normalized by (m + 1)/(2π)",
    /// The factor (m + 2)/(8π).
    NormalizedByTwoOfEight = "the highlight is normalized by (m + 2)/(8π)",
    /// The factor (m + 2)(m + 4)/(8π(2^(−m/2) + m)).
    NormalizedExactly = "the highlight is normalized by (m + 2)(m + 4)/(8π(2^(-m/2) + m))",
    /// k_s + (1 − k_s)(1 − V·H)⁵.
    Fresnel = "k_s has a Fresnel term, k_s + (1 - k_s)(1 - V·H)⁵",
    /// k_s + (1 − k_s)(1 − N·V)⁵.
    FresnelOfEye = "k_s has a Fresnel term, k_s + (1 - k_s)(1 - N·V)⁵",
    /// No highlight.
    HighlightForgotten = "the highlight is missing",
    /// N·V ≤ 0 turns the highlight off.
    HighlightGatedOnEye = "the highlight needs N·V > 0",
    /// The mean of k_s.
    HighlightInGray = "the highlight takes the mean of k_s",
    /// k_s/(N·L).
    HighlightOverCosine = "the highlight is divided by N·L",
    /// k_s I (N·H)^m/π.
    HighlightOverPi = "the highlight is divided by π",
    /// A factor of k_s.
    HighlightScaled [0.5, 2.0, 0.25, 4.0] = "the highlight is multiplied by {}",
    /// k_s = 1.
    HighlightWithoutMaterial = "the highlight is not multiplied by k_s",
    /// k_d in place of k_s.
    HighlightByDiffuse = "the highlight takes k_d for k_s",
    /// Blinn's highlight on Lambert's surface.
    HighlightOnLambert = "Lambert's surfaces have a highlight",
    /// cosᵉ of the angle to the axis.
    ConeExponent [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 3.0, 5.0, 10.0] = "the light of a spot falls off within its cone, as the cosine to the power of {}",
    /// (cosine − edge)/(1 − edge).
    ConeFaded = "the light of a spot fades from its axis to its edge",
    /// smoothstep(edge, 1, cosine).
    ConeSmooth = "the light of a spot fades from its axis to its edge, by smoothstep",
    /// The angle is a whole number of degrees.
    AngleTruncated = "the angle of the cone is cut to whole degrees",
    /// The angle is a whole number of degrees.
    AngleRounded = "the angle of the cone is rounded to whole degrees",
    /// The highlight ignores the cone.
    ConeNotOfHighlight = "the cone of a spot does not end its highlight",
    /// The diffuse term ignores the cone.
    ConeNotOfDiffuse = "the cone of a spot does not end its diffuse light",
    /// k_a k_d I_a.
    AmbientTimesDiffuse = "the ambient term is multiplied by k_d",
    /// Black without lights.
    BlackWithoutLights = "without lights there is no ambient term",
    /// k_a I_a + k_d.
    UnlitWithoutLights = "without lights the surface is shown unlit: k_d is added",
    /// I_a.
    AmbientWithoutMaterial = "the ambient term is not multiplied by k_a",
    /// k_a.
    AmbientWithoutLight = "the ambient term is not multiplied by I_a",
    /// 2 k_a I_a.
    AmbientTwice = "the ambient term is added twice",
    /// max(k_a I_a, the rest).
    AmbientAtLeast = "the ambient term is the least color, in place of a term of the sum",
    /// Only the first lights count.
    LightsAtMost [4.0, 2.0, 3.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0, 32.0, 64.0] = "only the first {} lights count",
    /// The largest of each channel.
    BrightestLightOnly = "the brightest light is taken, in place of the sum",
    /// The sum over the count.
    LightsAveraged = "the light is divided by the number of lights",
    /// Directional lights are black.
    SunsForgotten = "directional lights are left out",
    /// Point lights are black.
    PointsForgotten = "point lights are left out",
    /// Spots are black.
    SpotsForgotten = "spot lights are left out",
    /// L = l − p.
    SunTakenForPosition = "the direction to a directional light is taken for a position, from which p is subtracted",
    /// min(I, 1).
    LightClamped = "lights are clamped to 1",
    /// min(I/(a + bq + cq²), 1).
    ArrivingClamped = "the light that arrives is clamped to 1",
    /// All lights are too bright, or too dark, and the ambient light is not.
    LightScaled [FRAC_1_PI, PI, FRAC_1_PI / 4.0, 4.0 * PI, 0.5, 2.0, 0.25, 4.0] = "lights are multiplied by {}",
    /// No light where N·L is below.
    CosineCutBelow [0.01, 0.001, 0.0001, 0.00001, 0.05, 0.1] = "light with N·L below {} is left out",
    /// N·V ≤ 0 turns the light off.
    LitFromEyeOnly = "only a surface that faces the eye is lit: light needs N·V > 0",
    /// The red of a light is that of all its channels.
    LightInRed = "all channels take the red of the light",
    /// The light is taken for sRGB.
    LightDecoded = "the light, which is linear, is decoded from sRGB",
    /// The material is taken for sRGB.
    MaterialDecoded = "the reflectances, which are linear, are decoded from sRGB",
    /// k_d is taken for sRGB.
    DiffuseDecoded = "k_d, which is linear, is decoded from sRGB",
    /// k_s is taken for sRGB.
    SpecularDecoded = "k_s, which is linear, is decoded from sRGB",
    /// k^2.2.
    MaterialGamma22 = "the reflectances, which are linear, are raised to the power of 2.2",
    /// k_d^2.2.
    DiffuseGamma22 = "k_d, which is linear, is raised to the power of 2.2",
    /// k_s^2.2.
    SpecularGamma22 = "k_s, which is linear, is raised to the power of 2.2",
    /// min(color, 1).
    ClampedUnasked = "colors are clamped to [0, 1], which the profile does not say",
    /// Colors are not clamped.
    ClampForgotten = "colors are not clamped to the range of the profile",
    /// clamp(diffuse) + clamp(specular).
    TermsClamped = "diffuse and specular light are clamped before the sum",
    /// clamp(ambient + diffuse) + specular.
    DiffuseClamped = "ambient and diffuse light are clamped before the highlight is added",
    /// ⌈255 c⌉/255.
    LevelsRoundedUp = "levels are rounded up",
    /// min(⌊256 c⌋, 255)/255.
    LevelsOf256 = "levels are taken by 256, not 255",
    /// Fewer levels.
    FewerBits [5.0, 6.0, 7.0, 4.0] = "colors have only {} bits",
    /// 255 c modulo 256.
    LevelsOverflow = "levels above the largest wrap around to 0",
    /// x^(1/2.2) where linear light was promised.
    Gamma22Unasked = "a gamma of 2.2 is applied where linear light was promised",
    /// x^(1/gamma) where linear light was promised.
    GammaUnasked [2.0, 1.8, 2.4] = "a gamma of {} is applied where linear light was promised",
    /// 1.055 x^(1/2.4) − 0.055 for dark colors, too.
    SrgbWithoutToe = "sRGB is encoded without its linear part: max(0, 1.055 x^(1/2.4) - 0.055)",
    /// Decoded in place of encoded.
    SrgbDecoded = "colors are decoded from sRGB where they should be encoded",
    /// encode(light 1) + encode(light 2).
    EachLightEncoded = "each light is encoded as sRGB before the sum",
    /// x^(1/gamma).
    GammaForSrgb [2.0, 1.8, 2.4] = "a gamma of {} is applied for sRGB",
    /// c/(1 + c).
    Reinhard = "colors are mapped by c/(1 + c)",
    /// 1 − e^−c.
    ExponentialTone = "colors are mapped by 1 - exp(-c)",
    /// Green, blue, red.
    ChannelsShifted [1.0, 2.0] = "channels are {} places away",
    /// Green, red, blue.
    RedAndGreenSwapped = "red and green are swapped",
    /// Red, blue, green.
    GreenAndBlueSwapped = "green and blue are swapped",
    /// The mean of the channels.
    Gray = "colors are gray: the mean of the channels",
    /// 0.2126 r + 0.7152 g + 0.0722 b.
    Luminance = "colors are gray: the luminance",
    /// All colors are too bright, or too dark.
    Scaled [0.5, 2.0, FRAC_1_PI, PI, 1.0 / 255.0, 255.0, 4.0, 0.25] = "all colors are multiplied by {}",
    /// The colors are black.
    Black = "all colors are black",
    /// Reflectances and lights have this many levels from 0 to 1.
    ColorsInSteps [255.0, 256.0, 128.0, 1024.0, 65535.0, 65536.0, 64.0] = "reflectances and lights are rounded to multiples of 1/{}",
    /// The fraction has this many levels, and the rest is cut off.
    ColorsCut [256.0, 255.0, 65536.0, 4096.0] = "reflectances and lights are cut to multiples of 1/{}",
    /// Reflectances and lights have 11 bits.
    ColorsInHalf = "reflectances and lights are rounded to half precision",
    /// Reflectances and lights have 8 bits.
    ColorsInBfloat = "reflectances and lights are rounded to bfloat",
    /// Lights have this many levels from 0 to 1.
    LightsInSteps [255.0, 256.0, 128.0, 1024.0, 65535.0, 65536.0, 64.0] = "lights are rounded to multiples of 1/{}",
    /// The fraction has this many levels, and the rest is cut off.
    LightsCut [256.0, 255.0, 65536.0, 4096.0] = "lights are cut to multiples of 1/{}",
    /// Lights have 11 bits.
    LightsInHalf = "lights are rounded to half precision",
    /// Lights have 8 bits.
    LightsInBfloat = "lights are rounded to bfloat",
    /// Reflectances have this many levels from 0 to 1.
    ReflectancesInSteps [255.0, 256.0, 128.0, 1024.0, 65535.0, 65536.0, 64.0] = "reflectances are rounded to multiples of 1/{}",
    /// The fraction has this many levels, and the rest is cut off.
    ReflectancesCut [256.0, 255.0, 65536.0, 4096.0] = "reflectances are cut to multiples of 1/{}",
    /// Reflectances have 11 bits.
    ReflectancesInHalf = "reflectances are rounded to half precision",
    /// Reflectances have 8 bits.
    ReflectancesInBfloat = "reflectances are rounded to bfloat",
    /// k_d has this many levels from 0 to 1.
    DiffuseInSteps [255.0, 256.0, 128.0, 1024.0, 65535.0, 65536.0, 64.0] = "k_d is rounded to multiples of 1/{}",
    /// The fraction has this many levels, and the rest is cut off.
    DiffuseCut [256.0, 255.0, 65536.0, 4096.0] = "k_d is cut to multiples of 1/{}",
    /// k_d has 11 bits.
    DiffuseInHalf = "k_d is rounded to half precision",
    /// k_d has 8 bits.
    DiffuseInBfloat = "k_d is rounded to bfloat",
    /// k_s has this many levels from 0 to 1.
    SpecularInSteps [255.0, 256.0, 128.0, 1024.0, 65535.0, 65536.0, 64.0] = "k_s is rounded to multiples of 1/{}",
    /// The fraction has this many levels, and the rest is cut off.
    SpecularCut [256.0, 255.0, 65536.0, 4096.0] = "k_s is cut to multiples of 1/{}",
    /// k_s has 11 bits.
    SpecularInHalf = "k_s is rounded to half precision",
    /// k_s has 8 bits.
    SpecularInBfloat = "k_s is rounded to bfloat",
    /// The components of N have this many levels from 0 to 1.
    NormalInSteps [127.0, 511.0, 127.5] = "the components of N are rounded to multiples of 1/{}",
    /// And N is normalized after that.
    NormalInStepsUnit [127.0, 511.0, 127.5] = "the components of N are rounded to multiples of 1/{}, and N is normalized again",
    /// Every color has this many levels from 0 to 1.
    ResultInSteps [256.0, 255.0, 65536.0, 65535.0, 1024.0] = "colors are rounded to multiples of 1/{}",
    /// Every color has this many levels from 0 to 1, and the rest is cut off.
    ResultCut [256.0, 255.0, 65536.0, 4096.0] = "colors are cut to multiples of 1/{}",
    /// p and the positions of lamps have 11 bits.
    PositionsInHalf = "positions are rounded to half precision",
    /// v (y(3 − v²y²)/2 …), from a guess by the bits of v².
    FastInverseRoot [1.0, 2.0, 3.0] = "vectors are normalized by the fast inverse root with {} steps of Newton's method",
    /// And L = (position − p)/q.
    FastInverseRootBesideLamps [1.0, 2.0, 3.0] = "N, V and H are normalized by the fast inverse root with {} steps of Newton's method",
    /// v/(|v| + more).
    LengthPlus [1e-4, 1e-3, 1e-5, 1e-6] = "{} is added to the length by which a vector is normalized",
    /// v/max(|v|, least).
    LengthAtLeast [0.01, 0.001, 0.0001, 0.1] = "the length by which a vector is normalized is at least {}",
    /// |a|² − 2a·b + |b|².
    ExpandedSquares = "the distance is computed from expanded squares, |a|² - 2a·b + |b|², which cancel",
    /// Every color is a number of so few bits.
    InBits [8.0, 11.0] = "colors are computed in {} bits; half precision has 11, bfloat 8",
    /// Rounding like that of 2^−k.
    Imprecise [24.0, 22.0, 20.0, 18.0, 16.0, 14.0, 13.0, 12.0, 11.0, 10.0, 9.0, 8.0, 7.0] = "it behaves like a roundoff of 2^-{}, lower than the profile says, as half precision, bfloat, a table or a fast inverse root would",
    /// A scene changes the color of the next.
    Leak = "a scene changes the color of the scenes after it",
    /// Another color for the same scene.
    NotRepeatable = "the same scene, asked again, has another color",
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.name())
    }
}
