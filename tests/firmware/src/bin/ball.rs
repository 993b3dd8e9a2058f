//! Draws the ball, by the program that the variable `BALL` names at build time, and does nothing
//! else: for its flash.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::ball::{self, SIDE};

#[firmware::board::entry]
fn main() -> ! {
    loop {
        for row in 0..SIDE {
            ball::draw_row(row, const { ball::chosen() }, |_, color| {
                black_box(color); // a display would take it
            });
        }
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
