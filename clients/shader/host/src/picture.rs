//! The four pictures, of the GPU above those of the CPU; below them white where a bit differs.

use std::fs::File;
use std::path::Path;

use kernel::buffers::Reflected;
use shading::f32::Rgb;

/// Between the pictures, in pixels.
const GAP: usize = 4;
const GRAY: [u8; 3] = [64; 3];

pub struct Picture {
    size: [usize; 2],
    /// From the GPU, from the CPU, the difference: each the four parts, pixel by pixel.
    rows: [Vec<[Rgb; 4]>; 3],
}

impl Picture {
    pub fn new(size: [usize; 2]) -> Self {
        let black = || vec![[Rgb::BLACK; 4]; size[0] * size[1]];
        Self {
            size,
            rows: [black(), black(), black()],
        }
    }

    pub fn add(&mut self, pixel: usize, gpu: &Reflected, cpu: &Reflected, weight: f32) {
        let [of_gpu, of_cpu, difference] = &mut self.rows;
        for (part, (gpu, cpu)) in parts(gpu).into_iter().zip(parts(cpu)).enumerate() {
            of_gpu[pixel][part] += gpu * weight;
            of_cpu[pixel][part] += cpu * weight;
            if bytemuck::bytes_of(&gpu) != bytemuck::bytes_of(&cpu) {
                difference[pixel][part] = Rgb::WHITE;
            }
        }
    }

    pub fn write(&self, path: &Path) -> Result<(), png::EncodingError> {
        let [width, height] = [
            4 * (self.size[0] + GAP) - GAP,
            3 * (self.size[1] + GAP) - GAP,
        ];
        let mut pixels = Vec::new();
        for row in &self.rows {
            if !pixels.is_empty() {
                pixels.extend([GRAY; GAP].repeat(width));
            }
            for line in row.chunks(self.size[0]) {
                for part in 0..4 {
                    if part > 0 {
                        pixels.extend([GRAY; GAP]);
                    }
                    pixels.extend(line.iter().map(|parts| parts[part].to_srgb8()));
                }
            }
        }
        let mut encoder = png::Encoder::new(File::create(path)?, width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(pixels.as_flattened())?;
        writer.finish()
    }
}

fn parts(reflected: &Reflected) -> [Rgb; 4] {
    [
        reflected.ambient,
        reflected.diffuse,
        reflected.specular,
        reflected.total,
    ]
}
