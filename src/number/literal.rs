//! Numbers of every type that the code knows: whole ones, and constants in three parts.

use super::Real;

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
