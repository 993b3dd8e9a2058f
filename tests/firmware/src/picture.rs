//! The picture of the display example, drawn on the chip by the same code, in both number types.

#[path = "../../../examples/display/src"]
pub mod float {
    pub mod ball;
    #[path = "float.rs"]
    mod number;
}

#[path = "../../../examples/display/src"]
pub mod fixed {
    pub mod ball;
    #[path = "fixed.rs"]
    mod number;
}

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Size};

use crate::digest::Fnv;

/// A display that hands on each pixel.
pub struct Display<F>(pub F);

impl<F> OriginDimensions for Display<F> {
    fn size(&self) -> Size {
        Size::new(160, 128)
    }
}

impl<F: FnMut(u16)> DrawTarget for Display<F> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        for Pixel(_, color) in pixels {
            (self.0)(RawU16::from(color).into_inner());
        }
        Ok(())
    }
}

/// Absorbs a frame of the picture.
pub fn absorb(digest: &mut Fnv) {
    let pixel = |bits: u16| digest.bytes(bits.to_le_bytes());
    let Ok(()) = float::ball::draw(&mut Display(pixel), float::ball::Turn::NONE.next());
}
