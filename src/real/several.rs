//! One number, or lanes with a number for each of several lights.

use super::Real;

/// The numbers of one light, `T`, or of several at the same point: SIMD lanes of `T`.
pub trait Several<T>: Real {
    /// The same number in each lane.
    #[must_use]
    fn in_each(x: T) -> Self;

    /// sum + a + b + …, from the left.
    #[must_use]
    fn added_to(self, sum: T) -> T;

    /// The same, three times. The fourth number is not used: four fit a register.
    #[inline(always)]
    #[must_use]
    fn all_added_to([a, b, c]: [Self; 3], [x, y, z, w]: [T; 4]) -> [T; 4] {
        [a.added_to(x), b.added_to(y), c.added_to(z), w]
    }
}

impl<T: Real> Several<T> for T {
    #[inline(always)]
    fn in_each(x: T) -> T {
        x
    }

    #[inline(always)]
    fn added_to(self, sum: T) -> T {
        sum + self
    }
}
