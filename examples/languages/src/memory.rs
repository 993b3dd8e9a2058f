//! Memory for JavaScript, which has no pointers of its own into a module.

use std::alloc::{Layout, alloc, dealloc};
use std::ptr::null_mut;

/// What every structure of `shading.h` needs.
const ALIGNMENT: usize = 4;

/// Room for so many bytes, or null.
#[unsafe(no_mangle)]
pub extern "C" fn shading_alloc(size: usize) -> *mut u8 {
    match Layout::from_size_align(size, ALIGNMENT) {
        // SAFETY: the size is not 0
        Ok(layout) if size > 0 => unsafe { alloc(layout) },
        _ => null_mut(),
    }
}

/// # Safety
///
/// The room must come from [`shading_alloc`] with the same size, or be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_free(room: *mut u8, size: usize) {
    if let (false, Ok(layout)) = (room.is_null(), Layout::from_size_align(size, ALIGNMENT)) {
        // SAFETY: as the caller promises
        unsafe { dealloc(room, layout) }
    }
}
