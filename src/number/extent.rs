//! The finest steps of a number type: ε, and the least number.

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
