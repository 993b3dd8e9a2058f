//! Numbers converted to another type, which may be coarser and end earlier.

use super::{Mask, Real, least};

/// The nearest finite number of another type.
pub(crate) fn nearest<T: Real, U: Real>(x: T, f: &mut impl FnMut(T) -> U) -> U {
    f(x).at_most(U::MAX)
}

/// Where a comparison of numbers holds, in another type.
fn holds<T: Real, U: Real>(mask: T::Mask, f: &mut impl FnMut(T) -> U) -> U::Mask {
    f(mask.select(T::ONE, T::ZERO)).above(U::ZERO)
}

/// The nearest number above 0 of another type, and 0 for 0.
pub(crate) fn positive<T: Real, U: Real>(x: T, f: &mut impl FnMut(T) -> U) -> U {
    let number = nearest(x, f);
    let is_positive = number.above(U::ZERO);
    if is_positive.all() {
        return number;
    }
    let least = holds(x.above(T::ZERO), f).select(least(), U::ZERO);
    is_positive.select(number, least)
}

/// A range or a limit in another type, where [`MAX`](Real::MAX) means that there is none.
pub(crate) fn end<T: Real, U: Real>(x: T, f: &mut impl FnMut(T) -> U) -> U {
    holds(T::MAX.above(x), f).select(positive(x, f), U::MAX)
}
