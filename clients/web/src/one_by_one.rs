//! The picture, one point at a time, for browsers without SIMD.

use shading::Shaded;

use crate::scene::{Part, Scene};
use crate::surface::Point;

/// Nothing: single points need no preparation.
pub struct Prepared;

impl Prepared {
    #[must_use]
    pub fn new(_points: &[Point]) -> Self {
        Self
    }

    /// The light from a point.
    #[must_use]
    pub fn shaded(&Point { p, n, v, .. }: &Point, scene: &Scene) -> Shaded {
        scene.shaded(p, n, v)
    }

    /// Writes the pixels of the points.
    pub fn draw(&self, points: &[Point], scene: &Scene, part: Part, pixels: &mut [u8]) {
        for &Point { pixel, p, n, v } in points {
            let [r, g, b] = part.of(scene.shaded(p, n, v)).to_srgb8();
            pixels[4 * pixel..][..4].copy_from_slice(&[r, g, b, 255]);
        }
    }
}
