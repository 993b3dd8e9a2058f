//! Floor 1: vectors of any size, whose squared lengths overflow, vanish or lose bits.
//!
//! Such a vector is *extreme*. Before it is squared it is tamed: multiplied by a power of two. Growing rounds
//! nothing. Shrinking rounds only a component below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰ (`f64`) of the largest, far below
//! the unit roundoff.

use crate::real::Real;
use crate::vector::Vec3;

/// Whether |v|², given as `square`, over- or underflowed or may be inexact, in any lane.
#[inline]
pub(crate) fn is_extreme<T: Real>(square: T) -> bool {
    square.any_outside(T::ONE / T::EXTREME, T::EXTREME)
}

/// v, tamed.
#[inline]
pub(crate) fn tame<T: Real>(v: Vec3<T>) -> Vec3<T> {
    #[cold]
    #[inline(never)]
    fn cold<T: Real>(v: Vec3<T>) -> T {
        let [shrink, grow] = scales(v.dot(v));
        shrink * grow
    }
    if is_extreme(v.dot(v)) { v * cold(v) } else { v }
}

/// `to` − `from`, tamed.
#[inline]
pub(crate) fn tame_difference<T: Real>(to: Vec3<T>, from: Vec3<T>) -> Vec3<T> {
    #[cold]
    #[inline(never)]
    fn cold<T: Real>(to: Vec3<T>, from: Vec3<T>) -> Vec3<T> {
        let difference = to - from;
        extreme_difference(to, from, difference.dot(difference)).0
    }
    let difference = to - from;
    if is_extreme(difference.dot(difference)) {
        cold(to, from)
    } else {
        difference
    }
}

/// [`tame_difference`] where |to − from|² = `square` is extreme, and the power of two. The points
/// shrink before they are subtracted, since the difference may overflow, and it grows afterwards, since
/// the points may be far out.
#[inline]
pub(crate) fn extreme_difference<T: Real>(to: Vec3<T>, from: Vec3<T>, square: T) -> (Vec3<T>, T) {
    let [shrink, grow] = scales(square);
    ((to * shrink - from * shrink) * grow, shrink * grow)
}

/// The power of two that tames a vector of that |v|², as a factor of at most 1 and one of at least 1.
#[inline]
fn scales<T: Real>(square: T) -> [T; 2] {
    [
        T::EXTREME.if_above(square, T::ONE, T::ONE / T::EXTREME),
        (T::ONE / T::EXTREME).if_above(square, T::EXTREME, T::ONE),
    ]
}
