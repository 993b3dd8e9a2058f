//! Early exit: whether a light may light a surface, decided without computing a root.

use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// Whether a light in the direction P_light − p may light a surface. It is `false` if N·L would not
/// be positive in any lane.
#[inline]
pub(super) fn is_in_front<T: Real>(n: UnitVec3<T>, to_light: Vec3<T>) -> bool {
    // The light is left out if the dot product is below zero by more than 2⁻⁹ of |x| + |y| + |z|,
    // which is at least the distance. In any number type of 12 bits or more, this dot product and
    // N·L have smaller rounding errors, so N·L is not positive either. A product that may have lost
    // bits below the range of the type keeps the light.
    let size = to_light.x.abs() + to_light.y.abs() + to_light.z.abs();
    let beyond_doubt = size * T::of_f32(-1.0 / 512.0) - T::ONE / T::EXTREME;
    let in_front = beyond_doubt.if_above(n.dot(to_light), T::ZERO, T::ONE);
    in_front.any_positive()
}
