//! Lengths and directions that neither overflow nor vanish: the defaults of [`Real`]'s hooks for
//! vectors.

use super::triple::Vec3;
use super::{Lobe, Mask, Measured, Real, Toward};
use crate::target::FPU;

#[inline(always)]
pub(super) fn measured<T: Real>(v: Vec3<T>) -> Measured<T> {
    let square = T::dot(v, v);
    if is_extreme(square) {
        cold();
        return rescued(v, square);
    }
    plain(v, square)
}

/// n·w is the product that told that v faces the surface, unless v had to be scaled.
#[inline(always)]
pub(super) fn toward<T: Real>(n: Vec3<T>, v: Vec3<T>) -> Toward<T> {
    let square = T::dot(v, v);
    let (measured, n_dot_w) = if is_extreme(square) {
        cold();
        let measured = rescued(v, square);
        (measured, T::dot(n, measured.w))
    } else {
        (plain(v, square), T::dot(n, v))
    };
    Toward { measured, n_dot_w }
}

/// The cosine between n and w.
#[inline(always)]
pub(crate) fn cosine<T: Real>(n_dot_w: T, w_length: T) -> T {
    // w that overflowed gives ∞, and its light is black
    (n_dot_w / w_length).at_least(T::ZERO).at_most(T::ONE)
}

/// The power of the cosine between n and h = w + |w| v from its square, which needs no root.
#[inline(always)]
pub(super) fn halfway_power<T: Real>(
    n: Vec3<T>,
    Measured { w, w_length, .. }: Measured<T>,
    v: Vec3<T>,
    m: impl Lobe<T>,
) -> T {
    let h = w + v * w_length;
    let n_dot_h = T::dot(n, h);
    let power = m.raise_quotient(n_dot_h * n_dot_h, T::dot(h, h));
    n_dot_h.above(T::ZERO).select(power, T::ZERO)
}

/// Marks a path as rare, so that the compiler does not compute it beside the other and choose.
#[cold]
#[inline]
pub(crate) const fn cold() {}

#[inline(always)]
fn plain<T: Real>(v: Vec3<T>, square: T) -> Measured<T> {
    let length = square.sqrt();
    Measured {
        w: v,
        w_length: length,
        length,
    }
}

/// A call without an FPU: inline, the compiler would compute it for every vector, beside the other, and choose.
/// It takes the components: in a vector, which is passed by its address, each of them would be stored for every
/// light (measured: 7,457 instructions became 7,471 on a Cortex-M0, and five sums 36 bytes longer).
#[inline(always)]
fn rescued<T: Real>(v: Vec3<T>, square: T) -> Measured<T> {
    #[inline(never)]
    fn called<T: Real>(x: T, y: T, z: T, square: T) -> Measured<T> {
        scaled_and_measured(Vec3::new(x, y, z), square)
    }
    if FPU {
        scaled_and_measured(v, square)
    } else {
        called(v.x, v.y, v.z, square)
    }
}

#[inline(always)]
fn scaled_and_measured<T: Real>(v: Vec3<T>, square: T) -> Measured<T> {
    let power = taming(square);
    // w = v · power, in a loop, out of which the compiler moves nothing: in a sum over an array of one light,
    // it would compute all that follows for each light.
    let (mut w, mut step) = (v, power.at_most(T::ONE));
    for _ in 0..2 {
        (w, step) = (w * step, power.at_least(T::ONE));
    }
    let square = T::dot(w, w);
    let w_length = square.sqrt();
    let length = (w_length / power).at_most(T::MAX);
    // the square is neither zero nor infinite nor NaN
    let or = |a, b| {
        let finite = T::MAX.above(square).select(a, b);
        square.above(T::ZERO).select(finite, b)
    };
    Measured {
        w,
        w_length: or(w_length, T::ZERO),
        length: or(length, w_length),
    }
}

#[inline(always)]
pub(crate) fn between<T: Real>(origin: Vec3<T>, v: Vec3<T>) -> Vec3<T> {
    let from_origin = v - origin;
    let square = T::dot(from_origin, from_origin);
    if !is_extreme(square) {
        return from_origin;
    }
    // scaled down before the subtraction, which may overflow, and up after it, because the points may be
    // far from the origin
    let power = taming(square);
    let (shrink, grow) = (power.at_most(T::ONE), power.at_least(T::ONE));
    (v * shrink - origin * shrink) * grow
}

#[inline(always)]
pub(crate) fn crossed<T: Real>(origin: Vec3<T>, a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    let cross = (a - origin).cross(b - origin);
    if is_extreme(T::dot(cross, cross)) {
        T::between(origin, a).cross(T::between(origin, b))
    } else {
        cross
    }
}

/// The power of two that makes a vector fit for squares and products, by the square of its length.
///
/// Scaling it up is exact. Scaling it down rounds only components below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰
/// (`f64`) of the largest one, which is far below the unit roundoff.
#[inline(always)]
fn taming<T: Real>(square: T) -> T {
    let least = T::ONE / T::EXTREME;
    let grow = least.above(square).select(T::EXTREME, T::ONE);
    T::EXTREME.above(square).select(grow, least)
}

/// Whether |v|² overflowed, underflowed or may be inexact, in any lane.
#[inline(always)]
pub(crate) fn is_extreme<T: Real>(square: T) -> bool {
    square.any_outside(T::ONE / T::EXTREME, T::EXTREME)
}
