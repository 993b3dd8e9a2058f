//! A turning ball on a display of 160 × 128 pixels, a common size among hobbyists. Here, the
//! display is simulated: it writes a picture of each frame, and an animation of all frames.
//!
//! ```text
//! cargo run -p display -- [FOLDER]
//! cargo run -p display -- --beside FRAME.txt PICTURE.png
//! ```
//!
//! With `--features fixed`, it draws in fixed point, for chips without floating point.
//!
//! The second form shows a frame drawn by a chip (`tests/firmware/frame.sh`), the same frame drawn
//! here, and their difference, side by side.
//!
//! Besides the driver of its display, firmware needs only `ball.rs` and, as its module `number`,
//! `float.rs` or `fixed.rs`: `tests/firmware` compiles the same files for a Cortex-M0.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "a display has few pixels, and literals are in double precision"
)]

mod ball;
mod beside;
#[cfg_attr(feature = "fixed", path = "fixed.rs")]
#[cfg_attr(not(feature = "fixed"), path = "float.rs")]
mod number;

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::{OriginDimensions, Size};
use embedded_graphics_simulator::{OutputImage, OutputSettingsBuilder, SimulatorDisplay};
use png::{BitDepth, ColorType, Encoder};

const SIZE: Size = Size::new(160, 128);
const FRAMES: u32 = 12;

type Frame = OutputImage<Rgb888>;

fn main() -> ExitCode {
    let arguments: Vec<PathBuf> = env::args_os().skip(1).map(PathBuf::from).collect();
    let result = match &arguments[..] {
        [] => write_frames(Path::new("target/display")),
        [option, frame, picture] if option.as_os_str() == "--beside" => {
            beside::write(frame, picture)
        }
        [folder] if !folder.as_os_str().as_encoded_bytes().starts_with(b"-") => {
            write_frames(folder)
        }
        _ => Err("usage: display [FOLDER], or display --beside FRAME.txt PICTURE.png".into()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("display: {message}");
            ExitCode::FAILURE
        }
    }
}

fn about(path: &Path, error: &dyn Display) -> String {
    format!("{}: {error}", path.display())
}

fn write_frames(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| about(folder, &error))?;
    let mut turn = ball::Turn::NONE;
    let mut frames = Vec::new();
    for number in 0..FRAMES {
        let frame = enlarged(&drawn(turn));
        let path = folder.join(format!("ball-{number:02}.png"));
        frame
            .save_png(&path)
            .map_err(|error| about(&path, &error))?;
        frames.push(frame);
        turn = turn.next();
    }
    let path = folder.join("ball.png");
    let animation = animated(&frames).map_err(|error| about(&path, &error))?;
    fs::write(&path, animation).map_err(|error| about(&path, &error))?;
    println!("{FRAMES} frames and their animation in {}", path.display());
    Ok(())
}

fn drawn(turn: ball::Turn) -> SimulatorDisplay<Rgb565> {
    let mut display = SimulatorDisplay::new(SIZE);
    let Ok(()) = ball::draw(&mut display, turn);
    display
}

fn enlarged(display: &SimulatorDisplay<Rgb565>) -> Frame {
    display.to_rgb_output_image(&OutputSettingsBuilder::new().scale(2).build())
}

/// All frames in one file, in an endless loop at eight frames per second.
fn animated(frames: &[Frame]) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let Size { width, height } = frames[0].size();
    let mut encoder = Encoder::new(&mut file, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_animated(frames.len() as u32, 0)?;
    encoder.set_frame_delay(1, 8)?;
    let mut writer = encoder.write_header()?;
    for frame in frames {
        writer.write_image_data(frame.as_image_buffer().as_raw())?;
    }
    writer.finish()?;
    Ok(file)
}
