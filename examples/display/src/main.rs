//! A turning ball on a display of 160 × 128 pixels, as hobbyists have it; here the display is a
//! simulated one that writes a picture for each frame.
//!
//! ```text
//! cargo run -p display -- [FOLDER]
//! ```
//!
//! `ball.rs` is all that a firmware needs besides the driver of its display: `tests/firmware`
//! compiles the same file for a Cortex-M0.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "pixels are counted with whole numbers and placed with floating-point ones"
)]

mod ball;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::Size;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};

const FRAMES: usize = 12;

fn main() -> ExitCode {
    let mut arguments = env::args_os().skip(1);
    let folder = arguments
        .next()
        .map_or_else(|| "target/display".into(), PathBuf::from);
    let result = match arguments.next() {
        None => write_frames(&folder),
        Some(extra) => Err(format!("{}: one folder is enough", extra.to_string_lossy())),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("display: {message}");
            ExitCode::FAILURE
        }
    }
}

fn write_frames(folder: &Path) -> Result<(), String> {
    let about = |path: &Path, error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    fs::create_dir_all(folder).map_err(|error| about(folder, &error))?;
    let settings = OutputSettingsBuilder::new().scale(2).build();
    let mut turn = ball::Turn::NONE;
    for frame in 0..FRAMES {
        let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(160, 128));
        let Ok(()) = ball::draw(&mut display, turn);
        let path = folder.join(format!("ball-{frame:02}.png"));
        let picture = display.to_rgb_output_image(&settings);
        picture
            .save_png(&path)
            .map_err(|error| about(&path, &error))?;
        turn = turn.next();
    }
    Ok(())
}
