//! Shows a frame drawn on this machine, the same frame drawn on a chip, and their difference.

use std::fs;
use std::path::Path;

use embedded_graphics::Pixel;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_6X10;
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::prelude::{DrawTarget, Drawable, Point, Size};
use embedded_graphics::text::Text;
use embedded_graphics_simulator::SimulatorDisplay;

use crate::{SIZE, about, ball, drawn, enlarged};

/// Writes the picture, and fails if a pixel differs.
pub fn write(frame: &Path, picture: &Path) -> Result<(), String> {
    let text = fs::read_to_string(frame).map_err(|error| about(frame, &error))?;
    let chip = parsed(&text).ok_or_else(|| about(frame, &"not a frame of 160 × 128 pixels"))?;
    let desktop = drawn(ball::Turn::NONE.next());

    let Size { width, height } = SIZE;
    let mut side_by_side = SimulatorDisplay::<Rgb565>::new(Size::new(3 * width, height));
    let mut different = 0;
    for (i, &on_chip) in chip.iter().enumerate() {
        let at = Point::new(i as i32 % width as i32, i as i32 / width as i32);
        let here = desktop.get_pixel(at);
        different += usize::from(here != on_chip);
        let difference = Rgb565::new(
            here.r().abs_diff(on_chip.r()),
            here.g().abs_diff(on_chip.g()),
            here.b().abs_diff(on_chip.b()),
        );
        let columns = [here, on_chip, difference].into_iter().zip(0..);
        let pixels = columns.map(|(color, i)| Pixel(at + Point::new(i * width as i32, 0), color));
        let Ok(()) = side_by_side.draw_iter(pixels);
    }
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::new(20, 40, 20));
    for (label, i) in ["desktop", "Cortex-M0", "difference"].into_iter().zip(0..) {
        let at = Point::new(i * width as i32 + 4, height as i32 - 5);
        let Ok(_) = Text::new(label, at, style).draw(&mut side_by_side);
    }
    enlarged(&side_by_side)
        .save_png(picture)
        .map_err(|error| about(picture, &error))?;
    println!(
        "{}: {different} of {} pixels differ",
        picture.display(),
        chip.len()
    );
    if different > 0 {
        return Err("the chip draws a different picture".into());
    }
    Ok(())
}

/// Parses four hexadecimal digits per pixel and one line per row.
fn parsed(text: &str) -> Option<Vec<Rgb565>> {
    let rows: Vec<_> = text.lines().filter(|line| !line.is_empty()).collect();
    let is_whole = rows.len() == SIZE.height as usize
        && rows
            .iter()
            .all(|row| row.len() == 4 * SIZE.width as usize && row.is_ascii());
    let pixels = rows.iter().flat_map(|row| row.as_bytes().chunks(4));
    let pixel = |digits| {
        let bits = u16::from_str_radix(str::from_utf8(digits).ok()?, 16).ok()?;
        Some(RawU16::new(bits).into())
    };
    is_whole.then(|| pixels.map(pixel).collect()).flatten()
}
