//! Prints the frame that the display example draws, as a display receives it: four hexadecimal
//! digits per pixel, one line per row.
#![no_std]
#![no_main]

use core::str;

use firmware::board;
use firmware::picture::Display;
#[cfg(feature = "frame-in-fixed")]
use firmware::picture::fixed::ball;
#[cfg(not(feature = "frame-in-fixed"))]
use firmware::picture::float::ball;

const WIDTH: usize = 160;

#[board::entry]
fn main() -> ! {
    let mut row = [0; 4 * WIDTH];
    let mut column = 0;
    let print = |bits: u16| {
        for (i, digit) in row[4 * column..][..4].iter_mut().enumerate() {
            *digit = b"0123456789abcdef"[usize::from(bits >> (12 - 4 * i) & 15)];
        }
        column = (column + 1) % WIDTH;
        if column == 0 {
            board::println!("{}", str::from_utf8(&row).unwrap_or_default());
        }
    };
    let Ok(()) = ball::draw(&mut Display(print), ball::Turn::NONE.next());
    board::done()
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
