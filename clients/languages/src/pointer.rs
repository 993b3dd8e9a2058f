//! Pointers from another language, checked as far as a pointer can be.

use std::ops::Range;
use std::slice::{from_raw_parts, from_raw_parts_mut};

use crate::problem::{Problem, Status};

fn check<T>(data: *const T, count: usize) -> Result<(), Problem> {
    let size = count.checked_mul(size_of::<T>());
    if data.is_null() {
        Err(Problem::of(Status::Null))
    } else if !data.is_aligned() {
        Err(Problem::of(Status::Alignment))
    } else if size.is_none_or(|size| isize::try_from(size).is_err()) {
        Err(Problem::of(Status::Size))
    } else {
        Ok(())
    }
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values.
pub unsafe fn input<'a, T>(data: *const T, count: usize) -> Result<&'a [T], Problem> {
    if count == 0 {
        return Ok(&[]);
    }
    check(data, count)?;
    // SAFETY: the pointer is neither null nor misaligned, and valid as the caller promises
    Ok(unsafe { from_raw_parts(data, count) })
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values, which nothing else uses meanwhile.
pub unsafe fn output<'a, T>(
    data: *mut T,
    count: usize,
    inputs: &[Range<usize>],
) -> Result<&'a mut [T], Problem> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(data, count)?;
    let start = data.addr();
    let end = start + count * size_of::<T>();
    let overlaps = |input: &Range<usize>| start < input.end && input.start < end;
    if inputs.iter().any(overlaps) {
        return Err(Problem::of(Status::Overlap));
    }
    // SAFETY: as above, and no input overlaps it
    Ok(unsafe { from_raw_parts_mut(data, count) })
}

/// The addresses of a buffer.
pub fn addresses<T>(buffer: &[T]) -> Range<usize> {
    let Range { start, end } = buffer.as_ptr_range();
    start.addr()..end.addr()
}
