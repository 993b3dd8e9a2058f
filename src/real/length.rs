//! Lengths and directions that neither overflow nor vanish: the defaults of [`Real`]'s methods for
//! vectors.

use super::{Exponent, Real};

type Triple<T> = [T; 3];

/// A vector in the direction of v that squares well, its length, and the length of v.
#[inline(always)]
pub(super) fn direction<T: Real>(v: Triple<T>) -> (Triple<T>, T, T) {
    let square = T::dot(v, v);
    if !is_extreme(square) {
        let length = square.sqrt();
        return (v, length, length);
    }
    let (w, power) = tamed_by(v, [T::ZERO; 3], square);
    let square = T::dot(w, w);
    let length = square.sqrt();
    // the square is neither zero nor infinite nor NaN
    let exists = square.if_positive(T::MAX - square, T::ZERO);
    let size = (length / power).at_most(T::MAX);
    let or = |a, b| exists.if_positive(a, b);
    (w, or(length, T::ZERO), or(size, length))
}

/// The power of the cosine between n and v, from the square of the cosine, which needs no root.
#[inline(always)]
pub(super) fn cosine_power<T: Real>(n: Triple<T>, v: Triple<T>, m: impl Exponent<T>) -> T {
    let n_dot_v = T::dot(n, v);
    let cosine_squared = n_dot_v * n_dot_v / T::dot(v, v);
    // at most 1; 0/0 counts as 1, too
    let cosine_squared = T::ONE.if_above(cosine_squared, cosine_squared, T::ONE);
    n_dot_v.if_positive(m.raise_root(cosine_squared), T::ZERO)
}

/// The vector from `origin` to `v`, times a power of two that makes it fit for squares and products.
#[inline(always)]
pub(crate) fn tamed<T: Real>(v: Triple<T>, origin: Triple<T>) -> Triple<T> {
    let way = difference(v, origin);
    let square = T::dot(way, way);
    if is_extreme(square) {
        tamed_by(v, origin, square).0
    } else {
        way
    }
}

/// The vector from `origin` to `v` times a power of two, and the power.
///
/// Scaling it up is exact. Scaling it down rounds only components below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰
/// (`f64`) of the largest one, which is far below the unit roundoff.
#[inline(always)]
fn tamed_by<T: Real>(v: Triple<T>, origin: Triple<T>, square: T) -> (Triple<T>, T) {
    let grow = (T::ONE / T::EXTREME).if_above(square, T::EXTREME, T::ONE);
    let power = T::EXTREME.if_above(square, grow, T::ONE / T::EXTREME);
    let times = |[x, y, z]: Triple<T>, factor: T| [x * factor, y * factor, z * factor];
    // scaled down before the subtraction, which may overflow, and up after it, because the points
    // may be far from the origin
    let (shrink, grow) = (power.at_most(T::ONE), power.at_least(T::ONE));
    let way = difference(times(v, shrink), times(origin, shrink));
    (times(way, grow), power)
}

/// Whether |v|² overflowed, underflowed or may be inexact, in any lane.
#[inline(always)]
pub(crate) fn is_extreme<T: Real>(square: T) -> bool {
    square.any_outside(T::ONE / T::EXTREME, T::EXTREME)
}

#[inline(always)]
fn difference<T: Real>([a, b, c]: Triple<T>, [x, y, z]: Triple<T>) -> Triple<T> {
    [a - x, b - y, c - z]
}
