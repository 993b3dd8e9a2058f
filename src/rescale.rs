//! Floor 1: vectors of any size, whose squared lengths overflow, vanish or lose bits.
//!
//! Such a vector is *extreme*. Before it is squared it is tamed: multiplied by a power of two, which
//! keeps its direction and rounds nothing but what the power makes subnormal.

use crate::real::Real;
use crate::vector::Vec3;

/// Whether |v|², given as `square`, over- or underflowed or may be inexact, in any lane.
#[inline]
pub(crate) fn is_extreme<T: Real>(square: T) -> bool {
    square.any_outside(T::ONE / T::RESCALE, T::RESCALE)
}

/// `to` − `from`, tamed.
#[inline]
pub(crate) fn tame_difference<T: Real>(to: Vec3<T>, from: Vec3<T>) -> Vec3<T> {
    #[cold]
    #[inline(never)]
    fn cold<T: Real>(to: Vec3<T>, from: Vec3<T>, square: T) -> Vec3<T> {
        extreme_difference(to, from, square).0
    }
    let difference = to - from;
    let square = difference.dot(difference);
    if is_extreme(square) {
        cold(to, from, square)
    } else {
        difference
    }
}

/// [`tame_difference`] where |to − from|² = `square` is extreme, and the power of two. The points
/// shrink before they are subtracted, since the difference may overflow, and it grows afterwards, since
/// the points may be far out.
#[inline]
pub(crate) fn extreme_difference<T: Real>(to: Vec3<T>, from: Vec3<T>, square: T) -> (Vec3<T>, T) {
    let shrink = T::RESCALE.if_above(square, T::ONE, T::ONE / T::RESCALE);
    let grow = (T::ONE / T::RESCALE).if_above(square, T::RESCALE, T::ONE);
    ((to * shrink - from * shrink) * grow, shrink * grow)
}
