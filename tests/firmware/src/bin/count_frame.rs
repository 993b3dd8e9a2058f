//! Prints how many instructions the frame of the display example takes, in floating point and in
//! fixed point.
#![no_std]
#![no_main]

use core::cell::Cell;
use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Size};
use embedded_graphics::primitives::Rectangle;
use firmware::board;

// in this crate rather than in the library, since the compiler then knows the scene's numbers, as in
// firmware
#[path = "../../../../examples/display/src"]
mod float {
    pub mod ball;
    #[path = "float.rs"]
    mod number;
}

#[path = "../../../../examples/display/src"]
mod fixed {
    pub mod ball;
    #[path = "fixed.rs"]
    mod number;
}

/// A display that counts the instructions of each row, since the timer is too short for a frame.
struct Counter(u64);

impl OriginDimensions for Counter {
    fn size(&self) -> Size {
        Size::new(160, 128)
    }
}

impl DrawTarget for Counter {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, _: I) -> Result<(), Infallible> {
        unreachable!("the example draws row by row")
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        _: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        let colors = Cell::new(Some(colors));
        self.0 += board::many_instructions(|| {
            for color in colors.take().into_iter().flatten() {
                black_box(color);
            }
        });
        Ok(())
    }
}

#[board::entry]
fn main() -> ! {
    let [mut in_float, mut in_fixed] = [Counter(0), Counter(0)];
    let Ok(()) = float::ball::draw(&mut in_float, black_box(float::ball::Turn::NONE.next()));
    let Ok(()) = fixed::ball::draw(&mut in_fixed, black_box(fixed::ball::Turn::NONE.next()));
    board::println!("{} {}", in_float.0, in_fixed.0);
    board::done()
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
