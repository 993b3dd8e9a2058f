//! The picture, row by row on all cores.

use indicatif::ProgressBar;
use rayon::prelude::*;
use shading::Shaded;

use crate::scene::Scene;
use crate::vector::{Number, Vector};

pub const EYE: [f32; 3] = [0.0, 2.0, 6.0];

/// The bytes of its rows: red, green and blue of each pixel.
pub fn draw<V: Vector>(
    scene: &Scene<V>,
    width: usize,
    height: usize,
    progress: &ProgressBar,
) -> Vec<u8> {
    let seen = |from, along| scene.seen(from, along);
    draw_by(seen, width, height, progress)
}

/// The same, with another function in place of [`Scene::seen`].
pub fn draw_by<V: Vector>(
    seen: impl Fn(V, V) -> Option<Shaded<V::Number>> + Sync,
    width: usize,
    height: usize,
    progress: &ProgressBar,
) -> Vec<u8> {
    let mut pixels = vec![0; width * height * 3];
    if pixels.is_empty() {
        return pixels;
    }
    progress.set_length(height as u64);
    pixels
        .par_chunks_mut(width * 3)
        .enumerate()
        .for_each(|(y, row)| {
            for (x, pixel) in row.chunks_exact_mut(3).enumerate() {
                if let Some(shaded) = seen(V::of_f32(EYE), ray(x, y, width, height)) {
                    pixel.copy_from_slice(&shaded.total().map(Number::to_f32).to_srgb8());
                }
            }
            progress.inc(1);
        });
    progress.finish_and_clear();
    pixels
}

/// From the eye through a pixel.
pub fn ray<V: Vector>(x: usize, y: usize, width: usize, height: usize) -> V {
    let (x, y) = (
        x as f32 - 0.5 * width as f32,
        0.5 * height as f32 - y as f32,
    );
    V::of_f32([x / width as f32, y / width as f32 - 0.19, -1.0]).normalized()
}
