//! `port [FOLDER] [FRAME]` draws the two pictures of a frame: `before.png` and `after.png`.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use port::{SIDE, after, before, teapot};

fn write(path: &Path, pixels: &[u32]) -> Result<(), Box<dyn Error>> {
    let file =
        std::fs::File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut encoder = png::Encoder::new(file, SIDE[0] as u32, SIDE[1] as u32);
    encoder.set_color(png::ColorType::Rgb);
    let rgb = pixels
        .iter()
        .flat_map(|pixel| pixel.to_be_bytes().into_iter().skip(1));
    encoder
        .write_header()?
        .write_image_data(&rgb.collect::<Vec<_>>())?;
    Ok(())
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().unwrap_or_else(|| ".".into());
    let frame = arguments.next().map_or(Ok(150), |frame| frame.parse())?;
    let (folder, model) = (Path::new(&folder), teapot()?);
    write(&folder.join("before.png"), &before(&model, frame))?;
    write(&folder.join("after.png"), &after(&model, frame))
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("port: {error}");
            ExitCode::FAILURE
        }
    }
}
