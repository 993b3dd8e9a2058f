//! Floor 3: the cone of a spot light with a soft edge.

use crate::cone::{Beam, Cone};
use crate::real::Real;
use crate::unit::UnitVec3;

/// The cone of a spot light with a soft edge: full light up to an inner **half**-angle, none from an
/// outer one on, and less and less between.
///
/// It takes the place of the hard [`Cone`] in a [`SpotLight`](crate::SpotLight). Equal angles make
/// the hard cone, to the bit, so one scene may have both.
///
/// ```
/// use shading::{Attenuation, PointLight, Rgb, SoftCone, SpotLight, UnitVec3, Vec3};
///
/// static SPOT: SpotLight<f32, SoftCone<f32>> = SpotLight {
///     point: PointLight {
///         position: Vec3::new(0.0, 0.0, 2.0),
///         intensity: Rgb::WHITE,
///         attenuation: Attenuation::NONE,
///     },
///     axis: UnitVec3::<f32>::NEG_Z,
///     cone: SoftCone::<f32>::from_half_angles(0.3, 0.6).unwrap(),
/// };
/// let brightness = |x| SPOT.at(Vec3::new(x, 0.0, 0.0)).intensity.r;
/// assert_eq!(brightness(0.5), 1.0); // 14° off the axis
/// assert!(0.0 < brightness(1.0) && brightness(1.0) < 0.5); // 27°
/// assert_eq!(brightness(1.5), 0.0); // 37°
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftCone<T = f32> {
    inner: T,
    outer: T,
    /// Whether the edge is a smoothstep, and not a square.
    smoothstep: bool,
}

impl<T: Real> SoftCone<T> {
    /// 1 inside the inner cone and on its edge, 0 on the outer edge and outside, the square of t
    /// between.
    ///
    /// ```text
    /// t²,  t = (−L·axis − cos(outer)) / (cos(inner) − cos(outer)) within [0, 1]
    /// ```
    ///
    /// It does not fall towards the axis, to the bit. Where the angles are equal, it is 1 on the edge
    /// and the factor of the hard [`Cone`]. glTF's and Filament's sample code keeps the edge a little
    /// soft there.
    ///
    /// Source: Khronos, *KHR_lights_punctual*, a glTF 2.0 extension, “Inner and Outer Cone Angles”;
    /// Filament does the same.
    #[inline]
    #[must_use]
    pub fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        // 0 on the inner edge, 1 on the outer; where they are one, ∞ outside and NaN on it
        let outward = (self.inner - (-axis).dot(l)) / (self.inner - self.outer);
        let t = outward
            .if_positive(T::ONE - outward, T::ONE)
            .at_least(T::ZERO);
        if self.smoothstep {
            (t * t * (T::ONE + T::ONE + T::ONE - (t + t))).at_most(T::ONE)
        } else {
            t * t
        }
    }

    /// The same cone with an edge that begins as smoothly as it ends: t²(3 − 2t) in place of t². Towards
    /// the axis it does not fall by more than a unit in the last place.
    ///
    /// Source: three.js, `getSpotAttenuation`; POV-Ray 3.7, `radius` and `falloff` with a
    /// `tightness` of 0.
    ///
    /// ```
    /// use shading::{SoftCone, UnitVec3};
    ///
    /// let cone = SoftCone::<f32>::from_cosines(1.0, 0.0).unwrap();
    /// let l = UnitVec3::<f32>::new(0.866_025_4, 0.0, 0.5).unwrap();
    /// let [squared, smooth] = [cone, cone.smoothstep()].map(|cone| cone.factor(-UnitVec3::Z, l));
    /// assert!((squared - 0.25).abs() < 1e-6 && (smooth - 0.5).abs() < 1e-6);
    /// ```
    #[inline]
    #[must_use]
    pub const fn smoothstep(self) -> Self
    where
        T: Copy,
    {
        Self {
            smoothstep: true,
            ..self
        }
    }

    /// The cosines of the inner and of the outer half-angle.
    #[inline]
    #[must_use]
    pub fn cosines(self) -> [T; 2] {
        [self.inner, self.outer].map(|cosine| cosine.at_least(T::NEG_ONE))
    }

    /// Whether the edge is that of [`smoothstep`](SoftCone::smoothstep).
    #[inline]
    #[must_use]
    pub const fn is_smoothstep(self) -> bool
    where
        T: Copy,
    {
        self.smoothstep
    }

    /// The same cone in another number type: `f` converts each number, and may do no more
    /// than round it.
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> SoftCone<U> {
        SoftCone {
            inner: f(self.inner),
            outer: f(self.outer),
            smoothstep: self.smoothstep,
        }
    }
}

impl<T: Real> Beam<T> for SoftCone<T> {
    type In<U> = SoftCone<U>;

    #[inline]
    fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        self.factor(axis, l)
    }

    #[inline]
    fn cast<U>(self, f: impl FnMut(T) -> U) -> SoftCone<U> {
        self.cast(f)
    }
}

/// A hard edge.
impl<T: Copy> From<Cone<T>> for SoftCone<T> {
    #[inline]
    fn from(cone: Cone<T>) -> Self {
        Self::between(cone, cone)
    }
}

impl<T: Copy> SoftCone<T> {
    const fn between(inner: Cone<T>, outer: Cone<T>) -> Self {
        Self {
            inner: inner.cosine,
            outer: outer.cosine,
            smoothstep: false,
        }
    }
}

macro_rules! checked {
    ($float:ident) => {
        impl SoftCone<$float> {
            /// The cone of an inner and an outer half-angle in radians, 0 ≤ inner ≤ outer ≤ π. `None`
            /// for others, and for NaN.
            ///
            /// It takes each as [`Cone::from_half_angle`] does, also in a constant.
            #[must_use]
            pub const fn from_half_angles(inner: $float, outer: $float) -> Option<Self> {
                let cones = (
                    Cone::<$float>::from_half_angle(inner),
                    Cone::<$float>::from_half_angle(outer),
                );
                match cones {
                    (Some(inner_cone), Some(outer_cone)) if inner <= outer => {
                        // next to each other their cosines may have changed places by rounding
                        let inner_cone = if inner_cone.cosine < outer_cone.cosine {
                            outer_cone
                        } else {
                            inner_cone
                        };
                        Some(Self::between(inner_cone, outer_cone))
                    }
                    _ => None,
                }
            }

            /// The cone of an inner and an outer half-angle given by their cosines,
            /// 1 ≥ inner ≥ outer ≥ −1. `None` for others, and for NaN.
            ///
            /// It takes each as [`Cone::from_cosine`] does.
            #[must_use]
            pub const fn from_cosines(inner: $float, outer: $float) -> Option<Self> {
                match (
                    Cone::<$float>::from_cosine(inner),
                    Cone::<$float>::from_cosine(outer),
                ) {
                    (Some(inner_cone), Some(outer_cone)) if inner >= outer => {
                        Some(Self::between(inner_cone, outer_cone))
                    }
                    _ => None,
                }
            }
        }
    };
}

checked!(f32);
checked!(f64);
