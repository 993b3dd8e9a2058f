//! `tracer glam|nalgebra [MODEL.obj] [PICTURE.png]`: single or double precision; without a model, the bunny.

use std::fs::{self, File};
use std::path::Path;
use std::process::ExitCode;

use indicatif::ProgressBar;
use tracer::mesh::Mesh;
use tracer::picture::draw;
use tracer::scene::Scene;
use tracer::vector::Vector;

const WIDTH: usize = 640;
const HEIGHT: usize = 400;
const BUNNY: &str = include_str!("../../../examples/gallery/data/bunny.obj");

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match words[..] {
        ["glam", ref files @ ..] => run::<glam::Vec3>(files),
        ["nalgebra", ref files @ ..] => run::<nalgebra::Vector3<f64>>(files),
        _ => Err("usage: tracer glam|nalgebra [MODEL.obj] [PICTURE.png]".into()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("tracer: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run<V: Vector>(files: &[&str]) -> Result<(), String> {
    let (model, picture) = match files {
        [] => (None, "tracer.png"),
        [file] if Path::new(file).extension().is_some_and(|end| end == "obj") => {
            (Some(*file), "tracer.png")
        }
        [file] => (None, *file),
        [model, picture] => (Some(*model), *picture),
        _ => return Err("one model and one picture".into()),
    };
    let obj = match model {
        Some(file) => &fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?,
        None => BUNNY,
    };
    let mesh = Mesh::<V>::read(obj, 1.7, [-0.3, 0.0, 0.0]);
    let mesh = mesh.map_err(|error| format!("{}: {error}", model.unwrap_or("the bunny")))?;
    if mesh.without_area > 0 {
        eprintln!(
            "tracer: {} triangles have no area and are not seen",
            mesh.without_area
        );
    }
    let pixels = draw(
        &Scene::new(Some(mesh)),
        WIDTH,
        HEIGHT,
        &ProgressBar::no_length(),
    );
    write(picture, &pixels).map_err(|error| format!("{picture}: {error}"))?;
    println!("wrote {picture}, {WIDTH} × {HEIGHT} pixels");
    Ok(())
}

fn write(path: &str, pixels: &[u8]) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(File::create(path)?, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(pixels)
}
