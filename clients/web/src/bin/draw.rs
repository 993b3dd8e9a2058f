//! Draws what the page draws, on this machine: `draw PART WIDTH HEIGHT SETTING...`, as many settings as
//! the page has controls. Writes the picture's bytes to standard output: red, green, blue and opacity of
//! each pixel.

use std::io::{self, Write};
use std::process::ExitCode;

use web::page::Page;
use web::scene::SETTINGS;

fn main() -> ExitCode {
    let Some(([part, width, height], mut page)) = arguments() else {
        eprintln!("usage: draw PART WIDTH HEIGHT and {SETTINGS} settings");
        return ExitCode::FAILURE;
    };
    let pixels = page.draw(web::numbered(part), width as usize, height as usize);
    let written = io::stdout().write_all(pixels);
    let message = page.message();
    match written {
        Ok(()) if message.is_empty() => ExitCode::SUCCESS,
        Ok(()) => {
            eprintln!("{message}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("draw: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The part and the size, and a page with these settings.
fn arguments() -> Option<([u32; 3], Page)> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (numbers, settings) = words.split_at_checked(3)?;
    let numbers: Option<Vec<u32>> = numbers.iter().map(|word| word.parse().ok()).collect();
    let settings: Option<Vec<f32>> = settings.iter().map(|word| word.parse().ok()).collect();
    let mut page = Page::EMPTY;
    page.settings = settings?.try_into().ok()?;
    Some((numbers?.try_into().ok()?, page))
}
