//! Labels on a picture.

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::iso_8859_1::{
    FONT_4X6, FONT_5X8, FONT_6X10, FONT_8X13, FONT_10X20,
};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::{DrawTarget, Drawable, Pixel};
use embedded_graphics::text::{Baseline, Text};
use shading::Rgb;

use super::film::Film;

/// The distance from the edge in pixels.
const MARGIN: i32 = 12;

/// The fonts, from large to small.
const FONTS: [MonoFont; 5] = [FONT_10X20, FONT_8X13, FONT_6X10, FONT_5X8, FONT_4X6];

/// Writes each label at the bottom left of its part of the picture's width.
pub fn write(film: &mut Film, labels: &[&str]) {
    let longest = labels.iter().map(|label| label.chars().count()).max();
    let room = (film.width / labels.len().max(1)).saturating_sub(MARGIN as usize);
    let fits = |font: &&MonoFont| longest.unwrap_or(0) * font.character_size.width as usize <= room;
    let font = FONTS.iter().find(fits).unwrap_or(&FONT_4X6);
    let style = MonoTextStyle::new(font, BinaryColor::On);
    for (i, label) in labels.iter().enumerate() {
        let left = (i * film.width / labels.len()) as i32 + MARGIN;
        let at = Point::new(left, film.height as i32 - MARGIN);
        // a shadow makes the words readable on any background
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
