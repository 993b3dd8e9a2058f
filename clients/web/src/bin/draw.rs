//! Draws what the page draws, on this machine: `draw PART WIDTH HEIGHT SETTING...` writes the
//! picture's bytes to standard output, red, green, blue and opacity of each pixel.

use std::io::{self, Write};

use web::page::Page;

fn main() -> io::Result<()> {
    let number = |word: String| word.parse().expect("numbers");
    let numbers: Vec<f32> = std::env::args().skip(1).map(number).collect();
    let [part, width, height, ref settings @ ..] = numbers[..] else {
        panic!("usage: draw PART WIDTH HEIGHT SETTING...");
    };
    let mut page = Page::EMPTY;
    page.settings.copy_from_slice(settings);
    let pixels = page.draw(web::numbered(part as u32), width as usize, height as usize);
    io::stdout().write_all(pixels)
}
