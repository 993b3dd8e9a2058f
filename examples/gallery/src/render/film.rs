//! Renders a view to a picture of linear light, with anti-aliasing, on all cores.

use std::sync::{Mutex, PoisonError};
use std::thread;

use shading::Rgb;

/// Something that can be rendered.
pub trait View: Sync {
    /// The linear light at a point of the picture: x and y go from −1 to 1, to the right and up;
    /// `aspect` is the width of the picture over its height.
    fn color(&self, x: f32, y: f32, aspect: f32) -> Rgb<f32>;
}

/// A picture of linear light, row by row from the top.
pub struct Film {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<Rgb<f32>>,
}

/// The number of samples of a pixel for which one sample is not enough.
const SAMPLES: u32 = 16;
/// One sample is enough if the neighbors differ by at most this many levels of the display.
const CONTRAST: f32 = 3.0;

impl Film {
    /// Takes one sample in the middle of each pixel, and more where that is not enough.
    pub fn of(view: &dyn View, width: usize, height: usize) -> Self {
        let aspect = width as f32 / height as f32;
        let sample = |column: usize, row: usize, dx: f32, dy: f32| {
            let x = (column as f32 + dx) / width as f32 * 2.0 - 1.0;
            let y = 1.0 - (row as f32 + dy) / height as f32 * 2.0;
            // each sample is clamped on its own, so that the edge of a highlight brighter than
            // white stays smooth
            view.color(x, y, aspect).clamped()
        };
        let rough = Self::filled(width, height, |column, row| sample(column, row, 0.5, 0.5));
        let encoded = Self::filled(width, height, |column, row| {
            Rgb::from(rough.at(column, row).to_srgb8().map(f32::from))
        });
        Self::filled(width, height, |column, row| {
            if encoded.has_contrast(column, row) {
                let sum: Rgb<f32> = spread(SAMPLES)
                    .map(|(dx, dy)| sample(column, row, dx, dy))
                    .sum();
                sum * (1.0 / SAMPLES as f32)
            } else {
                rough.at(column, row)
            }
        })
    }

    /// Computes each pixel. Each thread takes the next row when it has finished one.
    fn filled(
        width: usize,
        height: usize,
        pixel: impl Fn(usize, usize) -> Rgb<f32> + Sync,
    ) -> Self {
        let mut pixels = vec![Rgb::BLACK; width * height];
        let rows = Mutex::new(pixels.chunks_mut(width).enumerate());
        // a panic on one thread ends the program without a second panic here
        let next_row = || rows.lock().unwrap_or_else(PoisonError::into_inner).next();
        thread::scope(|scope| {
            for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
                scope.spawn(|| {
                    while let Some((row, pixels)) = next_row() {
                        for (column, color) in pixels.iter_mut().enumerate() {
                            *color = pixel(column, row);
                        }
                    }
                });
            }
        });
        Self {
            width,
            height,
            pixels,
        }
    }

    fn at(&self, column: usize, row: usize) -> Rgb<f32> {
        self.pixels[row * self.width + column]
    }

    /// Whether a pixel differs visibly from one of its eight neighbors.
    fn has_contrast(&self, column: usize, row: usize) -> bool {
        let here = self.at(column, row);
        let columns = column.saturating_sub(1)..=(column + 1).min(self.width - 1);
        let mut rows = row.saturating_sub(1)..=(row + 1).min(self.height - 1);
        rows.any(|row| {
            columns.clone().any(|column| {
                let difference = here - self.at(column, row);
                <[f32; 3]>::from(difference)
                    .into_iter()
                    .any(|d| d.abs() > CONTRAST)
            })
        })
    }
}

/// A number of points, which is a power of two, spread over the unit square with no two in the same
/// row or column: the Hammersley set.
pub fn spread(count: u32) -> impl Iterator<Item = (f32, f32)> {
    let bits = count.trailing_zeros();
    (0..count).map(move |i| {
        let mirrored = i.reverse_bits() >> (u32::BITS - bits);
        [i, mirrored]
            .map(|n| (n as f32 + 0.5) / count as f32)
            .into()
    })
}
