//! The cone of a spot light with a soft edge.

use crate::cone::{Beam, Cone};
use crate::flag::{Flag, NO, YES};
use crate::real::{Real, Scalar};
use crate::unit::UnitVec3;

/// The cone of a spot light with a soft edge: the light is full up to an inner **half**-angle,
/// falls off beyond it, and is 0 from an outer half-angle on.
///
/// Use it in place of the hard [`Cone`] in a [`SpotLight`](crate::SpotLight). Equal angles make the
/// hard cone, to the bit, so one scene may have both.
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
#[doc(alias = "penumbra")]
#[doc(alias = "spotlight")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftCone<T = f32> {
    pub(crate) inner: T,
    pub(crate) outer: T,
    /// Whether the edge is a smoothstep instead of a square.
    smoothstep: Flag,
}

impl<T: Real> SoftCone<T> {
    /// The share of the light that arrives: 1 inside the inner cone and on its edge, 0 on the outer
    /// edge and outside it, and the square of t between the edges.
    ///
    /// ```text
    /// t²,  t = (−L·axis − cos(outer)) / (cos(inner) − cos(outer)) within [0, 1]
    /// ```
    ///
    /// `axis` is the direction in which the spot shines, away from the light, and L the direction
    /// from the surface to the light. inner and outer are the half-angles.
    /// [`smoothstep`](SoftCone::smoothstep) replaces t² with t²(3 − 2t).
    ///
    /// The factor never falls, to the bit, as L turns toward the axis. If the two angles are equal,
    /// the factor is that of the hard [`Cone`], 1 on the edge. The sample code of glTF and Filament
    /// keeps the edge slightly soft there.
    ///
    /// Source: Khronos, *KHR_lights_punctual*, a glTF 2.0 extension, “Inner and Outer Cone Angles”;
    /// Filament uses the same formula.
    ///
    /// ```
    /// use shading::{SoftCone, UnitVec3};
    ///
    /// let cone = SoftCone::<f32>::from_cosines(0.8, 0.0).unwrap();
    /// let between = UnitVec3::<f32>::new(0.916_515_1, 0.0, 0.4).unwrap();
    /// let inside = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
    /// assert!((cone.factor(UnitVec3::NEG_Z, between) - 0.25).abs() < 1e-6); // t = ½
    /// assert_eq!(cone.factor(UnitVec3::NEG_Z, inside), 1.0);
    /// assert_eq!(cone.factor(UnitVec3::NEG_Z, UnitVec3::X), 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        // Counted from the outer edge, a faint light keeps its digits. If the edges coincide, 0/0 on
        // them is not used, as it may be any number.
        let cosine = (-axis).dot(l);
        let t = (cosine - self.outer) / (self.inner - self.outer);
        let t = t.at_least(T::ZERO).at_most(T::ONE);
        let t = (self.inner - cosine).if_positive(t, T::ONE);
        if self.smoothstep == YES {
            (t * t * (T::ONE + T::ONE + T::ONE - (t + t))).at_most(T::ONE)
        } else {
            t * t
        }
    }

    /// The same cone, with an edge that begins as smoothly as it ends: t²(3 − 2t) in place of t².
    /// As L turns toward the axis, the factor never falls by more than a unit in the last place.
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
            smoothstep: YES,
            ..self
        }
    }

    /// The cosines of the inner and the outer half-angle, in this order, within [−1, 1].
    ///
    /// ```
    /// use shading::f32::SoftCone;
    ///
    /// assert_eq!(SoftCone::from_cosines(0.75, 0.5).unwrap().cosines(), [0.75, 0.5]);
    /// ```
    #[inline]
    #[must_use]
    pub fn cosines(self) -> [T; 2] {
        // not by `map` on the array, which rust-gpu cannot compile
        let cosine = |cosine: T| cosine.at_least(T::NEG_ONE);
        [cosine(self.inner), cosine(self.outer)]
    }

    /// Whether the edge is that of [`smoothstep`](SoftCone::smoothstep).
    ///
    /// ```
    /// use shading::f32::SoftCone;
    ///
    /// let cone = SoftCone::from_cosines(0.75, 0.5).unwrap();
    /// assert!(!cone.is_smoothstep() && cone.smoothstep().is_smoothstep());
    /// ```
    #[inline]
    #[must_use]
    pub const fn is_smoothstep(self) -> bool
    where
        T: Copy,
    {
        self.smoothstep == YES
    }

    /// [`from_half_angles`](SoftCone#method.from_half_angles) for any number type, in generic code. It
    /// has the same bits.
    ///
    /// ```
    /// use shading::{Real, SoftCone};
    ///
    /// fn torch<T: Real + PartialOrd>(half_angle: T) -> Option<SoftCone<T>> {
    ///     SoftCone::of_half_angles(half_angle * T::of(0.5), half_angle)
    /// }
    /// assert_eq!(torch(0.6_f32), SoftCone::<f32>::from_half_angles(0.3, 0.6));
    /// ```
    #[must_use]
    pub fn of_half_angles(inner: T, outer: T) -> Option<Self>
    where
        T: Scalar,
    {
        let inner_cone = Cone::of_half_angle(inner)?;
        let outer_cone = Cone::of_half_angle(outer)?;
        (inner <= outer).then(|| Self::in_order(inner_cone, outer_cone))
    }

    /// [`from_cosines`](SoftCone#method.from_cosines) for any number type, in generic code. It has the
    /// same bits.
    ///
    /// ```
    /// use shading::{Real, SoftCone};
    ///
    /// fn half_shadow<T: Real + PartialOrd>(cosine: T) -> Option<SoftCone<T>> {
    ///     SoftCone::of_cosines(T::ONE, cosine)
    /// }
    /// assert_eq!(half_shadow(0.5_f64), SoftCone::<f64>::from_cosines(1.0, 0.5));
    /// ```
    #[must_use]
    pub fn of_cosines(inner: T, outer: T) -> Option<Self>
    where
        T: Scalar,
    {
        let inner_cone = Cone::of_cosine(inner)?;
        let outer_cone = Cone::of_cosine(outer)?;
        (inner >= outer).then(|| Self::between(inner_cone, outer_cone))
    }

    /// A soft cone whose angles are in order. Rounding may have swapped the cosines of nearly equal
    /// ones.
    #[inline]
    fn in_order(inner: Cone<T>, outer: Cone<T>) -> Self {
        let cosine = inner.cosine.at_least(outer.cosine);
        Self::between(Cone { cosine }, outer)
    }

    /// The same cone in another number type. `f` converts each cosine and may only round it.
    ///
    /// The new cone, too, contains its axis, and every direction if its outer half-angle is π, as
    /// with [`Cone::cast`].
    ///
    /// ```
    /// use shading::f32::SoftCone;
    ///
    /// let cone = SoftCone::from_cosines(0.75, 0.5).unwrap();
    /// assert_eq!(cone.cast(f64::from).cosines(), [0.75_f64, 0.5]);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> SoftCone<U> {
        let inner = Cone::with_slack(f(self.inner));
        SoftCone {
            smoothstep: self.smoothstep,
            ..SoftCone::between(inner, Cone::with_slack(f(self.outer)))
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
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> SoftCone<U> {
        self.cast(f)
    }
}

/// The hard cone, as a soft cone with equal angles.
impl<T: Copy> From<Cone<T>> for SoftCone<T> {
    #[inline]
    fn from(cone: Cone<T>) -> Self {
        Self::between(cone, cone)
    }
}

impl<T: Copy> SoftCone<T> {
    pub(crate) const fn between(inner: Cone<T>, outer: Cone<T>) -> Self {
        Self {
            inner: inner.cosine,
            outer: outer.cosine,
            smoothstep: NO,
        }
    }
}

macro_rules! checked {
    ($float:ident) => {
        impl SoftCone<$float> {
            /// The cone of an inner and an outer half-angle in radians, 0 ≤ inner ≤ outer ≤ π.
            /// Returns `None` for other angles and for NaN.
            ///
            /// Each angle is converted as in [`Cone::from_half_angle`], and the constructor works
            /// in constants.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::SoftCone;")]
            ///
            /// const CONE: SoftCone = SoftCone::from_half_angles(0.0, 0.6).unwrap();
            /// assert!(CONE.cosines()[0] > CONE.cosines()[1]);
            /// assert_eq!(SoftCone::from_half_angles(0.6, 0.3), None); // the inner angle comes first
            /// ```
            #[must_use]
            pub const fn from_half_angles(inner: $float, outer: $float) -> Option<Self> {
                let cones = (
                    Cone::<$float>::from_half_angle(inner),
                    Cone::<$float>::from_half_angle(outer),
                );
                match cones {
                    (Some(inner_cone), Some(outer_cone)) if inner <= outer => {
                        // rounding may have swapped the cosines of nearly equal angles
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

            /// The cone whose inner and outer half-angles have the given cosines,
            /// 1 ≥ inner ≥ outer ≥ −1. Returns `None` for other cosines and for NaN.
            ///
            /// Each cosine is treated as in [`Cone::from_cosine`], and the constructor works in
            /// constants.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::SoftCone;")]
            ///
            /// assert!(SoftCone::from_cosines(0.75, 0.5).is_some());
            /// assert_eq!(SoftCone::from_cosines(0.5, 0.75), None); // the inner cosine is the larger one
            /// ```
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
