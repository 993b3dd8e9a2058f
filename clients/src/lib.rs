//! What the programs share.

mod patch;

use std::error::Error;
use std::fs::File;

use patch::Patch;
use shading::f32::{UnitVec3, Vec3};

/// Writes rows of red, green and blue bytes.
pub fn write_png(path: &str, width: usize, pixels: &[u8]) -> Result<(), Box<dyn Error>> {
    let file = File::create(path).map_err(|error| format!("{path}: {error}"))?;
    let height = pixels.len() / width / 3;
    let mut encoder = png::Encoder::new(file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(pixels)?;
    println!("{path}");
    Ok(())
}

/// The Utah teapot in triangles: points, and the normals of its Bézier patches.
pub fn teapot() -> Vec<(Vec3, UnitVec3)> {
    const N: usize = 16; // squares along each side of a patch
    let lines = include_str!("../../examples/gallery/data/teapot.bezier").lines();
    let numbers = |kind: &'static str| {
        let lines = lines
            .clone()
            .filter_map(move |line| line.strip_prefix(kind));
        lines.map(|line| {
            line.split(' ')
                .map(|word| word.parse().expect("a number"))
                .collect()
        })
    };
    let points: Vec<Vec3> = numbers("v ")
        .map(|p: Vec<f32>| Vec3::new(p[0], p[1], p[2]))
        .collect();
    let patches =
        numbers("p ").map(|indices| Patch(std::array::from_fn(|i| points[indices[i] as usize])));
    let mut corners = Vec::new();
    for patch in patches {
        for (i, j) in (0..N * N).map(|square| (square / N, square % N)) {
            // counter-clockwise from outside
            corners.extend(
                [(0, 0), (1, 1), (1, 0), (0, 0), (0, 1), (1, 1)].map(|(k, l)| {
                    let [u, v] = [i + k, j + l].map(|k| k as f32 / N as f32);
                    (patch.at(u, v), patch.normal(u, v).unwrap_or(UnitVec3::Z))
                }),
            );
        }
    }
    corners
}
