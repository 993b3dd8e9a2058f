//! What is computed of three numbers at once, for floating-point numbers: even if squared lengths
//! overflow, underflow or lose bits.
//!
//! Such a vector is called *extreme*. Before it is squared, it is *rescaled*: multiplied by a power of
//! two. Scaling it up is exact. Scaling it down rounds only components below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰
//! (`f64`) of the largest one, which is far below the unit roundoff.

use super::Real;

type Triple<T> = [T; 3];

#[inline(always)]
fn minus<T: Real>([ax, ay, az]: Triple<T>, [bx, by, bz]: Triple<T>) -> Triple<T> {
    [ax - bx, ay - by, az - bz]
}

/// Whether `square` = |v|² overflowed, underflowed or may be inexact, in any lane.
#[inline(always)]
fn is_extreme<T: Real>(square: T) -> bool {
    square.any_outside(T::ONE / T::EXTREME, T::EXTREME)
}

/// Whether a vector may be extreme, given the sizes of the largest components of two. For firmware the
/// answer is always yes: rescaling changes no result, and one way through a formula takes less flash than
/// two.
#[inline(always)]
pub(super) fn is_any_extreme<T: Real>([less, more]: [T; 2]) -> bool {
    // 2⁴⁸, or less if EXTREME is below 2¹⁰⁰: its square is far below EXTREME, and that of its reciprocal
    // far above 1/EXTREME
    let limit = (T::EXTREME * T::of_f32(1.0 / 4_503_599_627_370_496.0))
        .at_most(T::of_f32(281_474_976_710_656.0));
    cfg!(target_os = "none")
        || less.any_outside(T::ONE / limit, T::MAX)
        || more.any_outside(T::ZERO, limit)
}

/// The power of two that rescales a vector, from its |v|²: one factor of at most 1 and one of at least
/// 1.
#[inline(always)]
fn scales<T: Real>(square: T) -> [T; 2] {
    [
        T::EXTREME.if_above(square, T::ONE, T::ONE / T::EXTREME),
        (T::ONE / T::EXTREME).if_above(square, T::EXTREME, T::ONE),
    ]
}

/// [`rescaled_difference`] for an extreme `square` = |to − from|².
///
/// The points are scaled down before the subtraction, since their difference may overflow. The
/// difference is scaled up after it, since the points may be far from the origin.
#[cfg_attr(target_os = "none", inline(always))]
#[cfg_attr(not(target_os = "none"), inline)]
fn extreme_difference<T: Real>(to: Triple<T>, from: Triple<T>, square: T) -> (Triple<T>, T) {
    let [shrink, grow] = scales(square);
    let difference = minus(T::scaled(to, shrink), T::scaled(from, shrink));
    (T::scaled(difference, grow), shrink * grow)
}

#[inline]
pub(super) fn length<T: Real>(v: Triple<T>) -> T {
    let square = T::dot(v, v);
    if is_extreme(square) {
        let (rescaled, scale) = extreme_difference(v, [T::ZERO; 3], square);
        T::dot(rescaled, rescaled).sqrt() / scale
    } else {
        square.sqrt()
    }
}

/// The power of two that rescales a vector. A cold function takes and returns numbers: a vector would be written
/// to memory even if the function is not called, and reading it back would wait for the store.
#[cold]
#[inline(never)]
fn power<T: Real>(x: T, y: T, z: T) -> T {
    let v = [x, y, z];
    let [shrink, grow] = scales(T::dot(v, v));
    shrink * grow
}

#[inline(always)]
pub(super) fn unit<T: Real>(v @ [x, y, z]: Triple<T>) -> (Triple<T>, T) {
    let square = T::dot(v, v);
    // for firmware, one way takes less flash than two
    if cfg!(target_os = "none") || is_extreme(square) {
        unit_of_any_size(x, y, z)
    } else {
        (T::divided(v, square.sqrt()), T::ONE)
    }
}

#[cfg_attr(target_os = "none", inline(always))]
#[cfg_attr(not(target_os = "none"), cold, inline(never))]
fn unit_of_any_size<T: Real>(x: T, y: T, z: T) -> (Triple<T>, T) {
    let v = [x, y, z];
    let v = if is_extreme(T::dot(v, v)) {
        T::scaled(v, power(x, y, z))
    } else {
        v
    };
    let length = T::dot(v, v).sqrt();
    let valid = length.if_above(T::MAX, T::ZERO, length);
    (T::divided(v, length), valid)
}

#[cfg_attr(target_os = "none", inline)]
#[cfg_attr(not(target_os = "none"), inline(always))]
pub(super) fn rescaled_difference<T: Real>(to: Triple<T>, from: Triple<T>) -> (Triple<T>, T) {
    let difference = minus(to, from);
    if is_extreme(T::dot(difference, difference)) {
        let [x, y, z] = difference;
        let power = power(x, y, z);
        let (shrink, grow) = (power.at_most(T::ONE), power.at_least(T::ONE));
        let difference = minus(T::scaled(to, shrink), T::scaled(from, shrink));
        (T::scaled(difference, grow), power)
    } else {
        (difference, T::ONE)
    }
}

#[cfg_attr(target_os = "none", inline)]
#[cfg_attr(not(target_os = "none"), inline(always))]
pub(super) fn rescaled_together<T: Real>([a, b, c]: [Triple<T>; 3]) -> Option<([Triple<T>; 3], T)> {
    let is_extreme = |v| is_extreme(T::dot(v, v));
    let is_any_extreme = is_extreme(a) || is_extreme(b) || is_extreme(c);
    (!is_any_extreme).then_some(([a, b, c], T::ONE))
}

#[inline(always)]
pub(super) fn direction_and_distance<T: Real>(
    light_and_p: impl FnOnce() -> [Triple<T>; 2],
    to_light: Triple<T>,
) -> (Triple<T>, [T; 2], T) {
    let square = T::dot(to_light, to_light);
    if is_extreme(square) {
        let (l, q, distance) = extreme_direction_and_distance(light_and_p(), square);
        (l, [q, q], distance)
    } else {
        let q = square.sqrt();
        (T::scaled(to_light, T::ONE / q), [q, q], q)
    }
}

/// L, q and the distance if q² is out of range. A light without a direction counts as infinitely far
/// away, which makes it black. Its distance is still the largest finite number.
///
/// For firmware the function is inlined, because the call would take more flash and more stack.
#[cfg_attr(target_os = "none", inline(always))]
#[cfg_attr(not(target_os = "none"), cold, inline(never))]
fn extreme_direction_and_distance<T: Real>(
    [light, p]: [Triple<T>; 2],
    square: T,
) -> (Triple<T>, T, T) {
    let (way, scale) = extreme_difference(light, p, square);
    let q = T::dot(way, way).sqrt();
    let reciprocal = T::ONE / q;
    // positive if the reciprocal is neither zero nor infinite nor NaN
    let valid = reciprocal * (T::MAX - reciprocal);
    let component = |c, otherwise| valid.if_positive(c * reciprocal, otherwise);
    let [x, y, z] = way;
    let l = [
        component(x, T::ZERO),
        component(y, T::ZERO),
        component(z, T::ONE),
    ];
    let infinity = T::ONE / T::ZERO;
    let q_or = |otherwise| valid.if_positive((q / scale).at_most(T::MAX), otherwise);
    (l, q_or(infinity), q_or(T::MAX))
}

#[inline]
pub(crate) fn window<T: Real>(q: T, r: T, is_squared: bool) -> T {
    let share = q.ratio(r);
    let square = share * share;
    let root = (T::ONE - square * square).at_least(T::ZERO);
    if is_squared { root * root } else { root }
}

#[inline(always)]
pub(super) fn attenuated<T: Real>(
    v: Triple<T>,
    [a, b, c]: Triple<T>,
    q: T,
    limit: impl FnOnce() -> T,
) -> Triple<T> {
    let factor = T::ONE / (a + q * (b + c * q));
    // a factor of up to 1 can neither exceed the limit nor overflow
    if factor.any_outside(T::ZERO, T::ONE) {
        let [x, y, z] = T::scaled(v, factor.at_least(T::ZERO).at_most(limit()));
        [x.at_most(T::MAX), y.at_most(T::MAX), z.at_most(T::MAX)]
    } else {
        T::scaled(v, factor)
    }
}

/// R = 2(N·L)N − L
#[inline]
pub(crate) fn reflection<T: Real>(n: Triple<T>, l: Triple<T>) -> Triple<T> {
    let n_dot_l = T::dot(n, l);
    minus(T::scaled(n, n_dot_l + n_dot_l), l)
}

#[inline(always)] // on a Cortex-M0 a call from the sum would take 56 bytes of stack
pub(super) fn half_cosine<T: Real>(
    n: Triple<T>,
    [lx, ly, lz]: Triple<T>,
    [vx, vy, vz]: Triple<T>,
    squared: bool,
) -> T {
    let mut h = [lx + vx, ly + vy, lz + vz];
    // Not dot(h, h): LLVM would pack two sums of the same order into one SIMD register, and moving
    // the operands there costs more than the second sum.
    let square = |[x, y, z]: Triple<T>| z * z + y * y + x * x;
    let mut h_dot_h = square(h);
    // if L is close to −V, the square loses some or all of its bits
    let least = T::ONE / T::EXTREME;
    if least.if_above(h_dot_h, T::ONE, T::ZERO).any_positive() {
        h = T::scaled(h, least.if_above(h_dot_h, T::EXTREME, T::ONE));
        h_dot_h = square(h);
    }
    let n_dot_h = T::dot(n, h);
    // NaN if L = −V; NaN counts as 0
    let cosine_squared = n_dot_h * n_dot_h.abs() / h_dot_h;
    if squared {
        cosine_squared
    } else {
        cosine_squared.sqrt()
    }
}
