//! Numbers that every type has: ε, the least, whole ones, and constants in three parts.

use super::{Mask, Real, magnitude};

/// ε, the distance from 1 to the next number above: in any binary float, 4/3 is rounded by a third
/// of it (Kahan).
#[inline]
pub(crate) fn epsilon<T: Real>() -> T {
    let three = T::ONE + T::ONE + T::ONE;
    magnitude(three * ((T::ONE + three) / three - T::ONE) - T::ONE)
}

/// The least number above 0, by halving 1 until nothing is left, or until rounding ends it.
#[cold]
pub(crate) fn least<T: Real>() -> T {
    let (half, mut least) = (T::of_f32(0.5), T::ONE);
    loop {
        let next = least * half;
        if !(next.above(T::ZERO).all() && least.above(next).all()) {
            return least;
        }
        least = next;
    }
}

/// A whole number. A literal in double precision would link its routines on a chip.
#[inline]
#[allow(clippy::cast_precision_loss)] // sixteen bits fit
pub(crate) fn whole<T: Real>(n: u32) -> T {
    let low = T::of_f32((n & 0xFFFF) as f32);
    if n >> 16 == 0 {
        low
    } else {
        T::of_f32((n >> 16) as f32) * T::of_f32(65_536.0) + low
    }
}

/// A constant as the sum of three numbers in single precision, split by the compiler.
/// `constant(const { parts(PI) })` uses no `f64` on the path of `f32`.
#[inline]
pub(crate) fn constant<T: Real>([first, second, third]: [f32; 3]) -> T {
    T::of_f32(first) + T::of_f32(second) + T::of_f32(third)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
pub(crate) const fn parts(constant: f64) -> [f32; 3] {
    let first = constant as f32;
    let rest = constant - first as f64;
    let second = rest as f32;
    [first, second, (rest - second as f64) as f32]
}
