//! The checked constructors, as `f32` has them.

use super::{Fixed, ONE, vector};
use crate::attenuation::Attenuation;
use crate::cone::Cone;
use crate::range::Ranged;
use crate::soft_cone::SoftCone;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// How far rounding may take a cosine or the length of a direction from 1.
const SLACK: i32 = 4;

impl UnitVec3<Fixed> {
    /// The direction (x, y, z) if its length is 1 up to rounding (|v|² within 4 steps of 1), otherwise
    /// `None`. For vectors of any length, use [`normalized`](Self::normalized) or [`Vec3::unit`].
    ///
    /// ```
    /// use shading::fixed::{Fixed, UnitVec3};
    ///
    /// const UP_AND_RIGHT: UnitVec3 =
    ///     UnitVec3::new(Fixed::new(0.6), Fixed::new(0.0), Fixed::new(0.8)).unwrap();
    /// assert_eq!(UnitVec3::new(Fixed::new(1.0), Fixed::new(0.0), Fixed::new(1.0)), None);
    /// ```
    #[inline]
    #[must_use]
    pub const fn new(x: Fixed, y: Fixed, z: Fixed) -> Option<Self> {
        let v = [x, y, z];
        let square = vector::dot(&v, &v).0;
        if ONE - SLACK <= square && square <= ONE + SLACK {
            Some(Self::assume_unit(Vec3 { x, y, z }))
        } else {
            None
        }
    }

    /// The direction of the vector (x, y, z), of any length, for literals in constants.
    ///
    /// ```text
    /// v / |v|
    /// ```
    ///
    /// It has the same bits as [`Vec3::unit`] and is `None` for the zero vector.
    ///
    /// ```
    /// use shading::fixed::{Fixed, UnitVec3, Vec3};
    ///
    /// const fn x(literal: f64) -> Fixed {
    ///     Fixed::new(literal)
    /// }
    /// const ASIDE: UnitVec3 = UnitVec3::normalized(x(1.0), x(-3.0), x(0.5)).unwrap();
    /// assert_eq!(Some(ASIDE), Vec3::new(x(1.0), x(-3.0), x(0.5)).unit());
    /// ```
    #[doc(alias = "normalize")]
    #[must_use]
    pub const fn normalized(x: Fixed, y: Fixed, z: Fixed) -> Option<Self> {
        let ([x, y, z], length) = vector::unit_and_length(&[x, y, z]);
        if length.0 > 0 {
            Some(Self::assume_unit(Vec3 { x, y, z }))
        } else {
            None
        }
    }
}

impl Attenuation<Fixed> {
    /// The attenuation 1/(a + bq + cq²). Returns `None` if a coefficient is negative, or if all are 0.
    ///
    /// ```
    /// use shading::fixed::{Attenuation, Fixed};
    ///
    /// let x = Fixed::new;
    /// let inverse_square = Attenuation::new(x(0.0), x(0.0), x(1.0)).unwrap();
    /// assert_eq!(inverse_square.at(x(2.0)), x(0.25));
    /// assert_eq!(Attenuation::new(x(1.0), x(-0.5), x(0.0)), None);
    /// ```
    #[inline]
    #[must_use]
    pub const fn new(a: Fixed, b: Fixed, c: Fixed) -> Option<Self> {
        if (a.0 | b.0 | c.0) > 0 {
            Some(Self::unchecked(a, b, c))
        } else {
            None
        }
    }

    /// The same attenuation, ended by a range: the factor is 0 from the distance r on. Returns `None`
    /// if r is 0 or negative. [`Fixed::MAX`] means no range. [`Ranged::at`] gives the formula.
    ///
    /// ```
    /// use shading::fixed::{Attenuation, Fixed};
    ///
    /// let lamp = Attenuation::NONE.within(Fixed::new(8.0)).unwrap();
    /// assert_eq!(lamp.at(Fixed::new(8.0)), Fixed::new(0.0));
    /// ```
    #[inline]
    #[must_use]
    pub const fn within(self, r: Fixed) -> Option<Ranged<Fixed>> {
        if r.0 > 0 {
            Some(Ranged::unchecked(self, r))
        } else {
            None
        }
    }
}

impl Cone<Fixed> {
    /// The cone of a half-angle in radians, from 0 to π rounded up to a step. Returns `None` for other
    /// angles.
    ///
    /// The constructor computes in double precision, so on a small processor use it in constants.
    ///
    /// ```
    /// use shading::fixed::{Cone, Fixed};
    ///
    /// const CONE: Cone = Cone::from_half_angle(Fixed::new(0.5)).unwrap();
    /// assert_eq!(CONE.cosine(), Fixed::new(0.87758));
    /// assert_eq!(Cone::from_half_angle(Fixed::new(60.0)), None); // degrees
    /// ```
    #[must_use]
    pub const fn from_half_angle(radians: Fixed) -> Option<Self> {
        // π rounds up to a step
        let radians = radians.0 as f64 / ONE as f64;
        let pi = core::f64::consts::PI;
        match Cone::<f64>::from_half_angle(if radians > pi && radians < pi + 1e-5 {
            pi
        } else {
            radians
        }) {
            Some(cone) => Self::from_cosine(Fixed::new(cone.cosine)),
            None => None,
        }
    }

    /// The cone whose half-angle has the given cosine, within [−1, 1]. Returns `None` for other
    /// cosines.
    ///
    /// A cosine close to 1 is stored as 1 less 4 steps (a half-angle of 0.6°), and a cosine close to −1
    /// as a cone of every direction, for the reason that [`Cone::<f32>::from_cosine`] gives.
    ///
    /// ```
    /// use shading::fixed::{Cone, Fixed, UnitVec3};
    ///
    /// let hemisphere = Cone::from_cosine(Fixed::new(0.0)).unwrap();
    /// assert_eq!(hemisphere.factor(UnitVec3::Z, UnitVec3::X), Fixed::new(1.0)); // on its edge
    /// assert_eq!(Cone::from_cosine(Fixed::new(1.5)), None);
    /// ```
    ///
    /// [`Cone::<f32>::from_cosine`]: Cone#method.from_cosine
    #[must_use]
    pub const fn from_cosine(cosine: Fixed) -> Option<Self> {
        let steps = cosine.0;
        if steps < -ONE || steps > ONE {
            return None;
        }
        Some(Self {
            cosine: Fixed(if steps > ONE - SLACK {
                ONE - SLACK
            } else if steps < SLACK - ONE {
                -ONE - 2 * SLACK
            } else {
                steps
            }),
        })
    }
}

impl SoftCone<Fixed> {
    /// The cone of an inner and an outer half-angle in radians, 0 ≤ inner ≤ outer ≤ π. Returns `None`
    /// for other angles.
    ///
    /// The constructor computes in double precision, so on a small processor use it in constants.
    ///
    /// ```
    /// use shading::fixed::{Fixed, SoftCone};
    ///
    /// const CONE: SoftCone =
    ///     SoftCone::from_half_angles(Fixed::new(0.0), Fixed::new(0.6)).unwrap();
    /// assert!(CONE.cosines()[0] > CONE.cosines()[1]);
    /// ```
    #[must_use]
    pub const fn from_half_angles(inner: Fixed, outer: Fixed) -> Option<Self> {
        match (
            Cone::<Fixed>::from_half_angle(inner),
            Cone::<Fixed>::from_half_angle(outer),
        ) {
            (Some(inner_cone), Some(outer_cone)) if inner.0 <= outer.0 => {
                Some(Self::between(inner_cone, outer_cone))
            }
            _ => None,
        }
    }

    /// The cone whose inner and outer half-angles have the given cosines, 1 ≥ inner ≥ outer ≥ −1.
    /// Returns `None` for other cosines. Each cosine is treated as in [`Cone::from_cosine`].
    ///
    /// ```
    /// use shading::fixed::{Fixed, SoftCone};
    ///
    /// let x = Fixed::new;
    /// assert!(SoftCone::from_cosines(x(0.75), x(0.5)).is_some());
    /// assert_eq!(SoftCone::from_cosines(x(0.5), x(0.75)), None); // the inner cosine is the larger one
    /// ```
    #[must_use]
    pub const fn from_cosines(inner: Fixed, outer: Fixed) -> Option<Self> {
        match (
            Cone::<Fixed>::from_cosine(inner),
            Cone::<Fixed>::from_cosine(outer),
        ) {
            (Some(inner_cone), Some(outer_cone)) if inner.0 >= outer.0 => {
                Some(Self::between(inner_cone, outer_cone))
            }
            _ => None,
        }
    }
}
