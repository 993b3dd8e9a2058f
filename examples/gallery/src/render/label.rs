//! Words on a picture.

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_1::FONT_10X20;
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::{DrawTarget, Drawable, Pixel};
use embedded_graphics::text::{Baseline, Text};
use shading::Rgb;

use super::film::Film;

/// The distance from the edge, in pixels.
const MARGIN: i32 = 12;

/// Writes each label at the bottom left of its share of the picture's width.
pub fn write(film: &mut Film, labels: &[&str]) {
    let style = MonoTextStyle::new(&FONT_10X20, BinaryColor::On);
    for (i, label) in labels.iter().enumerate() {
        let left = (i * film.width / labels.len()) as i32 + MARGIN;
        let at = Point::new(left, film.height as i32 - MARGIN);
        // a shadow, so that the words can be read on any ground
        for (offset, color) in [(1, Rgb::BLACK), (0, Rgb::gray(0.7))] {
            let mut ink = Ink { film, color };
            let Ok(_) = Text::with_baseline(
                label,
                at + Point::new_equal(offset),
                style,
                Baseline::Bottom,
            )
            .draw(&mut ink);
        }
    }
}

struct Ink<'a> {
    film: &'a mut Film,
    color: Rgb,
}

impl OriginDimensions for Ink<'_> {
    fn size(&self) -> Size {
        Size::new(self.film.width as u32, self.film.height as u32)
    }
}

impl DrawTarget for Ink<'_> {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, _) in pixels {
            let (Ok(column), Ok(row)) = (usize::try_from(x), usize::try_from(y)) else {
                continue;
            };
            if column < self.film.width && row < self.film.height {
                self.film.pixels[row * self.film.width + column] = self.color;
            }
        }
        Ok(())
    }
}
