//! Pointers from another language, checked as far as a pointer can be.

use std::ops::Range;
use std::slice::{from_raw_parts, from_raw_parts_mut};

use crate::Status;

fn check<T>(data: *const T, count: usize) -> Result<(), Status> {
    if data.is_null() {
        Err(Status::Null)
    } else if !data.is_aligned() {
        Err(Status::Alignment)
    } else if count
        .checked_mul(size_of::<T>())
        .is_none_or(|size| isize::try_from(size).is_err())
    {
        Err(Status::Size)
    } else {
        Ok(())
    }
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values.
pub unsafe fn input<'a, T>(data: *const T, count: usize) -> Result<&'a [T], Status> {
    if count == 0 {
        return Ok(&[]);
    }
    check(data, count)?;
    // SAFETY: the pointer is neither null nor misaligned, and valid as the caller promises
    Ok(unsafe { from_raw_parts(data, count) })
}

/// # Safety
///
/// A pointer that is not null must be valid.
pub unsafe fn one<'a, T>(data: *const T) -> Result<&'a T, Status> {
    check(data, 1)?;
    // SAFETY: as above
    Ok(unsafe { &*data })
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values, which nothing else uses meanwhile.
pub unsafe fn output<'a, T>(
    data: *mut T,
    count: usize,
    inputs: &[Range<usize>],
) -> Result<&'a mut [T], Status> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(data, count)?;
    let own = bytes(&(data.cast_const()..data.cast_const().wrapping_add(count)));
    let overlaps = |other: &Range<usize>| own.start < other.end && other.start < own.end;
    if inputs.iter().any(overlaps) {
        return Err(Status::Overlap);
    }
    // SAFETY: as above, and no input overlaps it
    Ok(unsafe { from_raw_parts_mut(data, count) })
}

/// The addresses of a buffer.
pub fn bytes<T>(buffer: &Range<*const T>) -> Range<usize> {
    buffer.start.addr()..buffer.end.addr()
}
