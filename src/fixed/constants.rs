//! The constructors for constants, as `f32` has them.

use super::cosine::{PI, cosine};
use super::real::dot;
use super::root::unit_and_length;
use super::{Fixed, ONE};
use crate::light::{Attenuation, Cone};
use crate::vector::{UnitVec3, Vec3};

impl UnitVec3<Fixed> {
    /// [`new`](UnitVec3::new) for constants: the direction of the vector (x, y, z), of any length but 0.
    #[must_use]
    pub const fn const_new(x: Fixed, y: Fixed, z: Fixed) -> Option<Self> {
        const SLACK: u32 = 4;
        let v = Vec3::new(x, y, z);
        if dot(v, v).0.abs_diff(ONE) <= SLACK {
            return Some(Self::assume_unit(v));
        }
        let ([x, y, z], length) = unit_and_length([x, y, z]);
        if length.0 > 0 {
            Some(Self::assume_unit(Vec3::new(x, y, z)))
        } else {
            None
        }
    }
}

impl Attenuation<Fixed> {
    /// [`new`](Attenuation#method.new) for constants.
    #[must_use]
    pub const fn const_new(a: Fixed, b: Fixed, c: Fixed) -> Option<Self> {
        // the sign of a | b | c is − if that of one is
        if (a.0 | b.0 | c.0) > 0 {
            Some(Self::unchecked(a, b, c))
        } else {
            None
        }
    }

    /// [`within`](Attenuation#method.within) for constants.
    #[must_use]
    pub const fn const_within(self, r: Fixed) -> Option<Self> {
        if r.0 > 0 {
            Some(self.ended(r, Fixed(ONE)))
        } else {
            None
        }
    }
}

impl Cone<Fixed> {
    /// [`from_half_angle`](Cone::from_half_angle) for constants.
    #[must_use]
    pub const fn const_from_half_angle(radians: Fixed) -> Option<Self> {
        Self::const_from_half_angles(radians, radians)
    }

    /// [`from_half_angles`](Cone::from_half_angles) for constants.
    #[must_use]
    pub const fn const_from_half_angles(inner: Fixed, outer: Fixed) -> Option<Self> {
        if 0 <= inner.0 && inner.0 <= outer.0 && outer.0 <= PI {
            Some(Self::stored(cosine(inner), cosine(outer)))
        } else {
            None
        }
    }

    /// A cone that contains its axis, or everything, in spite of rounding, as for any number.
    const fn stored(inner: Fixed, outer: Fixed) -> Self {
        /// How far rounding may take a cosine or the length of a direction from 1, in steps.
        const SLACK: i32 = 4;
        const NARROWEST: i32 = ONE - SLACK;
        const fn limited(cosine: Fixed) -> Fixed {
            if cosine.0 > NARROWEST {
                Fixed(NARROWEST)
            } else {
                cosine
            }
        }
        let [inner, outer] = if inner.0 < -NARROWEST {
            [Fixed(-2 * ONE); 2]
        } else {
            [limited(inner), limited(outer)]
        };
        Self {
            inner,
            outer,
            smooth: Fixed(0),
        }
    }
}
