//! Proves by being linked that nothing which the crate computes with `f32` can panic: a panic
//! would call a function that is nowhere defined. The finished program is searched for routines
//! for doubles.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::{board, digest};

#[board::entry]
fn main() -> ! {
    black_box(digest::without_doubles());
    loop {}
}

unsafe extern "C" {
    fn a_panic_can_happen() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: none; a program that gets here does not link.
    unsafe { a_panic_can_happen() }
}
