//! The cone of a spot light.

use core::f64::consts::PI;

use crate::color::Rgb;
use crate::number::cosine::{cosine_f32, cosine_f64};
use crate::number::{Dimmed, Mask, Measured, Real, Scalar, constant, epsilon, parts};
use crate::vector::{UnitVec3, Vec3};

/// The cone of a spot light, given by its **half**-angle: the angle between the axis and the edge,
/// as in OpenGL, glTF and three.js. Unity and Blender give twice that angle.
///
/// Its edge is hard, or soft between an inner and an outer half-angle.
///
/// ```
/// use shading::f32::{Cone, UnitVec3};
/// use std::f32::consts::FRAC_PI_6;
///
/// const CONE: Cone = Cone::const_from_half_angle(FRAC_PI_6).unwrap(); // 60° wide from edge to edge
///
/// let straight_down = UnitVec3::NEG_Z;
/// assert_eq!(CONE.factor(straight_down, UnitVec3::Z), 1.0); // right below: L points up
/// assert_eq!(CONE.factor(straight_down, UnitVec3::X), 0.0);
/// ```
///
/// For a beam of your own, multiply the [`intensity`](crate::IncidentLight::intensity) that arrives.
#[doc(alias("cutoff", "penumbra", "spotlight"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Cone<T = f32> {
    pub(crate) inner: T,
    pub(crate) outer: T,
    /// 1 if the soft edge is a smoothstep, 0 if it is a square, or hard.
    pub(crate) smooth: T,
}

impl<T: Real> Cone<T> {
    pub(crate) const EVERYWHERE: Self = Self {
        inner: T::NEG_ONE,
        outer: T::NEG_ONE,
        smooth: T::ZERO,
    };

    /// The fraction of the light that arrives: 1 inside the inner cone and on its edge, 0 outside the
    /// outer cone, and the square of t between the edges.
    ///
    /// ```text
    /// t²,  t = (−L·axis − cos(outer)) / (cos(inner) − cos(outer)) within [0, 1]
    /// ```
    ///
    /// `axis` is the direction in which the spot shines, away from the light, and L the direction
    /// from the surface to the light. inner and outer are the half-angles, and equal for a hard edge.
    /// [`smoothstep`](Cone::smoothstep) replaces t² with t²(3 − 2t). On the axis, and if a direction is
    /// NaN, the factor is 1 for every cone.
    ///
    /// As the computed −L·axis increases, the factor never decreases, not by a single bit. That product
    /// itself may decrease by a unit in the last place or two while L turns toward the axis.
    ///
    /// Source: OpenGL 2.1, §2.14.1, with a spot exponent of 0; KHR_lights_punctual (glTF 2.0),
    /// “Inner and Outer Cone Angles”, whose sample code and Filament keep a hard edge slightly
    /// soft.
    ///
    /// ```
    /// use shading::f32::{Cone, UnitVec3};
    ///
    /// let soft = Cone::from_cosines(0.8, 0.4).unwrap();
    /// let l = UnitVec3::new(0.8, 0.0, 0.6).unwrap(); // from below, at a cosine halfway
    /// assert!((soft.factor(UnitVec3::NEG_Z, l) - 0.25).abs() < 1e-6); // t = ½
    /// ```
    #[inline]
    #[must_use]
    pub fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        let light = Dimmed::full(Rgb::WHITE);
        let measured = Measured::along(*l, T::ONE);
        self.dimmed(light, axis, *l, &measured).multiplied().r
    }

    /// A light at the end of the vector v, whose direction is measured.
    #[inline(always)]
    pub(crate) fn dimmed(
        &self,
        light: Dimmed<T>,
        axis: UnitVec3<T>,
        v: Vec3<T>,
        measured: &Measured<T>,
    ) -> Dimmed<T> {
        let (edges, is_smooth) = ([self.inner, self.outer], self.smooth.above(T::ZERO));
        T::beamed(light, *axis, edges, is_smooth, v, measured)
    }

    /// The same cone, with a soft edge that begins as smoothly as it ends: t²(3 − 2t) in place of t².
    /// As the computed −L·axis rises, the factor never falls by more than a unit in the last place. A
    /// hard edge stays as it is.
    ///
    /// Source: three.js, `getSpotAttenuation`; POV-Ray 3.7, `radius` and `falloff` with a
    /// `tightness` of 0.
    #[inline]
    pub fn smoothstep(self) -> Self {
        Self {
            smooth: self.inner.above(self.outer).select(T::ONE, T::ZERO),
            ..self
        }
    }

    /// Whether the soft edge is a smoothstep.
    #[inline]
    #[must_use]
    pub fn is_smoothstep(self) -> bool
    where
        T: Scalar,
    {
        self.smooth > T::ZERO
    }

    /// The cosines of the inner and the outer half-angle, in this order, within [−1, 1].
    #[inline]
    #[must_use]
    pub fn cosines(self) -> [T; 2] {
        [
            self.inner.at_least(T::NEG_ONE),
            self.outer.at_least(T::NEG_ONE),
        ]
    }

    /// The hard cone of a half-angle in radians, within [0, π]. Returns `None` for other angles and for
    /// NaN. In a constant, use [`const_from_half_angle`](Cone#method.const_from_half_angle).
    ///
    /// ```
    /// use shading::Cone;
    ///
    /// let cone = Cone::from_half_angle(60_f64.to_radians()).unwrap(); // 60° on each side of the axis
    /// assert!((cone.cosines()[0] - 0.5).abs() < 1e-15);
    /// assert_eq!(Cone::from_half_angle(60.0), None); // degrees
    /// ```
    #[inline]
    #[must_use]
    pub fn from_half_angle(radians: T) -> Option<Self>
    where
        T: Scalar,
    {
        Self::from_half_angles(radians, radians)
    }

    /// The cone of an inner and an outer half-angle in radians, 0 ≤ inner ≤ outer ≤ π. Returns `None`
    /// for other angles and for NaN.
    #[inline]
    #[must_use]
    pub fn from_half_angles(inner: T, outer: T) -> Option<Self>
    where
        T: Scalar,
    {
        let pi = constant(const { parts(PI) });
        if !(T::ZERO <= inner && inner <= outer && outer <= pi) {
            return None;
        }
        let (inner, outer) = (inner.half_angle_cosine(), outer.half_angle_cosine());
        // rounding may have swapped the cosines of nearly equal angles
        Self::from_cosines(inner.at_least(outer), outer)
    }

    /// The hard cone whose half-angle has the given cosine, within [−1, 1]. Returns `None` for other
    /// cosines and for NaN.
    ///
    /// A cosine close to 1 is stored as 1 − 4ε (a half-angle of 0.06° in `f32`), and a cosine close to
    /// −1 as a cone of every direction. Otherwise the rounding of directions could put the axis outside
    /// its own cone, or a direction outside the cone of half-angle π.
    #[inline]
    #[must_use]
    pub fn from_cosine(cosine: T) -> Option<Self>
    where
        T: Scalar,
    {
        Self::from_cosines(cosine, cosine)
    }

    /// The cone whose inner and outer half-angles have the given cosines, 1 ≥ inner ≥ outer ≥ −1.
    /// Returns `None` for other cosines and for NaN.
    ///
    /// A cosine close to 1 is stored as 1 − 4ε, as in [`from_cosine`](Cone::from_cosine). If the inner one is
    /// close to −1, so is the outer one, and the cone is that of every direction. Otherwise, an outer cosine
    /// close to −1 is stored as it is, because the factor near such an edge is near 0.
    #[inline]
    #[must_use]
    pub fn from_cosines(inner: T, outer: T) -> Option<Self>
    where
        T: Scalar,
    {
        // −0 would flip the sign of the edge's width
        (T::ONE >= inner && inner >= outer && outer >= T::NEG_ONE)
            .then(|| Self::with_slack(inner + T::ZERO, outer + T::ZERO, T::ZERO))
    }

    /// The cone of cosines within [−1, 1], or of another cone's: it contains its axis, even if both
    /// directions are as long as they may be. The slack of another number type stays where it is
    /// larger, because directions bring the roundoff of that type along.
    ///
    /// A cone of every direction has the cosine −2 in every number type, which no two directions reach.
    #[inline]
    fn with_slack(inner: T, outer: T, smooth: T) -> Self {
        let two = T::ONE + T::ONE;
        let slack = two * two * epsilon();
        let is_everywhere = (slack - T::ONE).above(inner);
        let stored = |cosine: T| is_everywhere.select(-two, cosine.at_most(T::ONE - slack));
        let (inner, outer) = (stored(inner), stored(outer));
        Self {
            inner,
            outer,
            smooth: inner.above(outer).select(smooth, T::ZERO),
        }
    }

    /// The same cone in another number type. `f` converts each cosine and may only round it.
    ///
    /// The new cone, too, contains its axis, and every direction if its half-angle is π: a cosine
    /// close to 1 or −1 is treated as in [`from_cosine`](Cone#method.from_cosine), with the larger ε of
    /// the two types.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> Cone<U> {
        Cone::with_slack(f(self.inner), f(self.outer), f(self.smooth))
    }
}

macro_rules! constants {
    ($float:ident, $cosine:ident) => {
        impl Cone<$float> {
            /// [`from_half_angle`](Cone::from_half_angle) for constants, with the same bits.
            #[must_use]
            pub const fn const_from_half_angle(radians: $float) -> Option<Self> {
                Self::const_from_half_angles(radians, radians)
            }

            /// [`from_half_angles`](Cone::from_half_angles) for constants.
            #[must_use]
            pub const fn const_from_half_angles(inner: $float, outer: $float) -> Option<Self> {
                if !(0.0 <= inner && inner <= outer && outer <= core::$float::consts::PI) {
                    return None;
                }
                let (inner, outer) = ($cosine(inner), $cosine(outer));
                // rounding may have swapped the cosines of nearly equal angles
                let inner = if inner < outer { outer } else { inner };
                let is_everywhere = inner < Self::SLACK - 1.0;
                Some(Self {
                    inner: Self::stored(inner, is_everywhere),
                    outer: Self::stored(outer, is_everywhere),
                    smooth: 0.0,
                })
            }

            const SLACK: $float = 4.0 * $float::EPSILON;

            const fn stored(cosine: $float, is_everywhere: bool) -> $float {
                if is_everywhere {
                    -2.0
                } else if cosine > 1.0 - Self::SLACK {
                    1.0 - Self::SLACK
                } else {
                    cosine + 0.0 // −0 would flip the sign of the edge's width
                }
            }
        }
    };
}

constants!(f32, cosine_f32);
constants!(f64, cosine_f64);
