//! Proves, if it links, that nothing which the crate computes with `f32` or in fixed point can panic: a panic would
//! call an undefined function. The finished program is searched for double-precision routines.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::{board, digest};

#[board::entry]
fn main() -> ! {
    black_box(digest::without_doubles());
    black_box(digest::fixed_without_doubles());
    loop {}
}

unsafe extern "C" {
    fn a_panic_can_happen() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: none is needed, since a program that gets here does not link.
    unsafe { a_panic_can_happen() }
}
