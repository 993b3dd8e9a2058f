//! Writes pictures to files.

use std::path::Path;
use std::{fs, io};

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, ScaledFloat};

use super::film::Film;

/// Writes a picture as a PNG file, either completely or not at all: it first writes under another
/// name.
pub fn write(film: &Film, path: &Path) -> io::Result<()> {
    let png = encoded(film).map_err(io::Error::other)?;
    let unfinished = path.with_extension("png.part");
    fs::write(&unfinished, png)
        .and_then(|()| fs::rename(&unfinished, path))
        .inspect_err(|_| {
            // the file may not exist, and the first error says more
            let _ = fs::remove_file(&unfinished);
        })
}

fn encoded(film: &Film) -> Result<Vec<u8>, EncodingError> {
    let bytes: Vec<u8> = film
        .pixels
        .iter()
        .flat_map(|pixel| pixel.to_srgb8())
        .collect();
    let mut png = Vec::new();
    let mut encoder = Encoder::new(&mut png, film.width as u32, film.height as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    // for readers that do not support sRGB
    encoder.set_source_gamma(ScaledFloat::from_scaled(45455));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    Ok(png)
}
