//! Proves, if it links, that nothing which the crate computes in `f32` or in fixed point can panic:
//! a panic would call an undefined function. The finished program is searched for double-precision
//! routines.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::absorb_all;
use kit::digest::{Fnv, Of};
use shading::fixed::Fixed;

#[firmware::board::entry]
fn main() -> ! {
    let mut digest = Fnv::EMPTY;
    absorb_all(Of::<f32>::WITHOUT_DOUBLES, &mut digest);
    absorb_all(Of::<f32>::OF_FLOATS, &mut digest);
    absorb_all(Of::<Fixed>::WITHOUT_DOUBLES, &mut digest);
    loop {
        black_box(digest.0);
    }
}

unsafe extern "C" {
    fn a_panic_can_happen() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: none is needed, since a program that gets here does not link.
    unsafe { a_panic_can_happen() }
}
