//! Pointers from another language, checked as far as a pointer can be.

use std::ops::Range;
use std::slice::{from_raw_parts, from_raw_parts_mut};

use crate::problem::{Problem, Status};

fn check<T>(name: &str, data: *const T, count: usize) -> Result<(), Problem> {
    let size = count.checked_mul(size_of::<T>());
    let status = if data.is_null() {
        Status::Null
    } else if !data.is_aligned() {
        Status::Alignment
    } else if size.is_none_or(|size| isize::try_from(size).is_err()) {
        Status::Size
    } else {
        return Ok(());
    };
    Err(Problem::of(status, name))
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values.
pub unsafe fn input<'a, T>(name: &str, data: *const T, count: usize) -> Result<&'a [T], Problem> {
    if count == 0 {
        return Ok(&[]);
    }
    check(name, data, count)?;
    // SAFETY: the pointer is neither null nor misaligned, and valid as the caller promises
    Ok(unsafe { from_raw_parts(data, count) })
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values, which nothing else uses meanwhile.
pub unsafe fn output<'a, T>(
    data: *mut T,
    count: usize,
    inputs: &[Taken],
) -> Result<&'a mut [T], Problem> {
    if count == 0 {
        return Ok(&mut []);
    }
    check("out", data, count)?;
    let start = data.addr();
    let end = start + count * size_of::<T>();
    for (name, input) in inputs {
        if start < input.end && input.start < end {
            return Err(Problem::of(Status::Overlap, name));
        }
    }
    // SAFETY: as above, and no input overlaps it
    Ok(unsafe { from_raw_parts_mut(data, count) })
}

/// An argument, and the addresses of its buffer.
pub type Taken = (&'static str, Range<usize>);

pub fn taken<T>(name: &'static str, buffer: &[T]) -> Taken {
    let Range { start, end } = buffer.as_ptr_range();
    (name, start.addr()..end.addr())
}
