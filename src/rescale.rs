//! Vectors of any length, even if their squared lengths overflow, underflow or lose bits.
//!
//! Such a vector is called *extreme*. Before it is squared, it is *tamed*: multiplied by a power of
//! two. Scaling it up is exact. Scaling it down rounds only components below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰
//! (`f64`) of the largest one, which is far below the unit roundoff.

use crate::real::Real;
use crate::vector::Vec3;

/// Whether `square` = |v|² overflowed, underflowed or may be inexact, in any lane.
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
    if T::IS_FIXED {
        let [tame] = T::tamed([v.into()]);
        tame.into()
    } else if is_extreme(v.dot(v)) {
        v * cold(v)
    } else {
        v
    }
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
    if T::IS_FIXED {
        tame(difference)
    } else if is_extreme(difference.dot(difference)) {
        cold(to, from)
    } else {
        difference
    }
}

/// [`tame_difference`] for an extreme `square` = |to − from|², with the power of two that tamed the
/// difference.
///
/// The points are scaled down before the subtraction, since their difference may overflow. The
/// difference is scaled up after it, since the points may be far from the origin.
#[inline]
pub(crate) fn extreme_difference<T: Real>(to: Vec3<T>, from: Vec3<T>, square: T) -> (Vec3<T>, T) {
    let [shrink, grow] = scales(square);
    ((to * shrink - from * shrink) * grow, shrink * grow)
}

/// The power of two that tames a vector, from its |v|²: one factor of at most 1 and one of at least
/// 1.
#[inline]
fn scales<T: Real>(square: T) -> [T; 2] {
    [
        T::EXTREME.if_above(square, T::ONE, T::ONE / T::EXTREME),
        (T::ONE / T::EXTREME).if_above(square, T::EXTREME, T::ONE),
    ]
}
