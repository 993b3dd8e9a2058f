//! Prints the frame that the display example draws, as a display receives it: four hexadecimal
//! digits per pixel, one line per row.
#![no_std]
#![no_main]

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Size};
use firmware::board;
#[cfg(feature = "frame-in-fixed")]
use firmware::picture::fixed::ball;
#[cfg(not(feature = "frame-in-fixed"))]
use firmware::picture::float::ball;

const WIDTH: usize = 160;

/// A display that holds one row and prints it when it is full.
struct Printer {
    row: [u8; 4 * WIDTH],
    column: usize,
}

impl OriginDimensions for Printer {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, 128)
    }
}

impl DrawTarget for Printer {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        for Pixel(_, color) in pixels {
            let bits = RawU16::from(color).into_inner();
            for (i, digit) in self.row[4 * self.column..][..4].iter_mut().enumerate() {
                *digit = b"0123456789abcdef"[usize::from(bits >> (12 - 4 * i) & 15)];
            }
            self.column = (self.column + 1) % WIDTH;
            if self.column == 0 {
                board::println!("{}", core::str::from_utf8(&self.row).unwrap_or_default());
            }
        }
        Ok(())
    }
}

#[board::entry]
fn main() -> ! {
    let row = [0; 4 * WIDTH];
    let Ok(()) = ball::draw(&mut Printer { row, column: 0 }, ball::Turn::NONE.next());
    board::done()
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
