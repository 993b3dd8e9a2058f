//! `rasterizer [PICTURE.png]`

use std::fs::File;
use std::process::ExitCode;

const WIDTH: usize = 640;
const HEIGHT: usize = 480;

fn main() -> ExitCode {
    let path = std::env::args()
        .nth(1)
        .unwrap_or_else(|| "teapot.png".into());
    let vertices = rasterizer::vertices();
    let pixels = rasterizer::draw(&vertices, WIDTH, HEIGHT);
    match write(&path, &pixels) {
        Ok(()) => {
            println!(
                "wrote {path}, {WIDTH} × {HEIGHT} pixels of {} triangles",
                vertices.len() / 3
            );
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("rasterizer: {path}: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write(path: &str, pixels: &[u8]) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(File::create(path)?, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(pixels)
}
