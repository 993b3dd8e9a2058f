//! The gallery: each formula of `shading` at work, as pictures and a page that shows them.
//!
//! `cargo run --release -p gallery [FOLDER] [NAME]` draws all pictures, or those whose names contain NAME.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "pixels are counted with integers and placed with floating-point numbers"
)]

mod mesh;
mod render;
mod scenes;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

use scenes::Picture;

fn write_png(
    path: &Path,
    [width, height]: [usize; 2],
    pixels: &[u8],
) -> Result<(), Box<dyn Error>> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(pixels)?;
    fs::write(path, file).map_err(|error| format!("{}: {error}", path.display()).into())
}

fn figure(
    Picture {
        name,
        caption,
        size: [width, height],
        ..
    }: &Picture,
) -> String {
    format!(
        "<figure><img src=\"{name}.png\" width={width} height={height} alt=\"\"><figcaption>{caption}</figcaption></figure>\n"
    )
}

const HEAD: &str = "<!doctype html>
<html lang=en><meta charset=utf-8><meta name=viewport content=\"width=device-width\"><title>The gallery of shading</title>
<style>
body { background: #16181c; color: #d4d7dc; font: 1rem/1.5 sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem }
figure { margin: 0 0 3rem } img { display: block; max-width: 100%; height: auto }
</style>
<h1>The gallery</h1>
";

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let folder = arguments.next().unwrap_or_else(|| "target/gallery".into());
    let only = arguments.next().unwrap_or_default();
    let folder = PathBuf::from(folder);
    let mut pictures = scenes::all();
    pictures.retain(|picture| picture.name.contains(&only));
    if pictures.is_empty() {
        return Err(format!("no picture has a name that contains {only}").into());
    }
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for picture in &pictures {
        let path = folder.join(picture.name).with_extension("png");
        write_png(
            &path,
            picture.size,
            &render::draw(&picture.rows, picture.size),
        )?;
        println!("{}", path.display());
    }
    let page = folder.join("index.html");
    fs::write(
        &page,
        pictures
            .iter()
            .map(figure)
            .fold(HEAD.into(), |page: String, figure| page + &figure),
    )?;
    println!("Open {} to see them with their captions.", page.display());
    Ok(())
}
