//! Lengths and directions that neither overflow nor vanish, the defaults of [`Real`]'s methods for
//! vectors.

use super::Real;

type Triple<T> = [T; 3];

/// A vector times a power of two that brings its square into range.
///
/// Scaling it up is exact. Scaling it down rounds only components below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰
/// (`f64`) of the largest one, which is far below the unit roundoff.
#[derive(Clone, Copy)]
pub(crate) struct Tamed<T> {
    pub(crate) v: Triple<T>,
    pub(crate) square: T,
    power: T,
    /// Above 0 if the vector has a direction.
    pub(crate) exists: T,
}

/// The vector from `origin` to `v`, made fit for squares and products.
#[inline(always)]
pub(crate) fn tamed<T: Real>(v: Triple<T>, origin: Triple<T>) -> Tamed<T> {
    let difference = |[a, b, c]: Triple<T>, [x, y, z]: Triple<T>| [a - x, b - y, c - z];
    let times = |[x, y, z]: Triple<T>, factor: T| [x * factor, y * factor, z * factor];
    let way = difference(v, origin);
    let square = dot(way, way);
    if !is_extreme(square) {
        let [power, exists] = [T::ONE; 2];
        return Tamed {
            v: way,
            square,
            power,
            exists,
        };
    }
    let power = power(square);
    // scaled down before the subtraction, which may overflow, and up after it, because the points
    // may be far from the origin
    let (shrink, grow) = (power.at_most(T::ONE), power.at_least(T::ONE));
    let v = times(difference(times(v, shrink), times(origin, shrink)), grow);
    let square = dot(v, v);
    // the square is neither zero nor infinite nor NaN
    let exists = square.if_positive(T::MAX - square, T::ZERO);
    Tamed {
        v,
        square,
        power,
        exists,
    }
}

#[inline(always)]
pub(super) fn unit_and_length<T: Real>(v: Triple<T>) -> (Triple<T>, T, T) {
    let tamed = tamed(v, [T::ZERO; 3]);
    let length = tamed.square.sqrt();
    let [x, y, z] = tamed.v;
    let share = |x: T| tamed.exists.if_positive(x / length, T::ZERO);
    (
        [share(x), share(y), share(z)],
        length / tamed.power,
        tamed.exists,
    )
}

#[inline(always)]
pub(super) fn cosine<T: Real>(n: Triple<T>, v: Triple<T>) -> T {
    let Tamed {
        v, square, exists, ..
    } = tamed(v, [T::ZERO; 3]);
    exists.if_positive(dot(n, v) / square.sqrt(), T::ZERO)
}

#[inline(always)]
pub(crate) fn dot<T: Real>([a, b, c]: Triple<T>, [x, y, z]: Triple<T>) -> T {
    a * x + b * y + c * z
}

/// Whether |v|² overflowed, underflowed or may be inexact, in any lane.
#[inline(always)]
pub(crate) fn is_extreme<T: Real>(square: T) -> bool {
    let not_small = square.if_above(T::ONE / T::EXTREME, T::ZERO, T::ONE);
    T::EXTREME
        .if_above(square, not_small, T::ONE)
        .any_positive()
}

/// The power of two that brings |v|² into range.
#[inline(always)]
fn power<T: Real>(square: T) -> T {
    let grow = (T::ONE / T::EXTREME).if_above(square, T::EXTREME, T::ONE);
    T::EXTREME.if_above(square, grow, T::ONE / T::EXTREME)
}
