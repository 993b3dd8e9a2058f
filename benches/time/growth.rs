//! How the time grows with the lights, and with the threads.

use crate::ours::f32::{material, scene, unit};
use crate::scene::{lamps, points};
use rayon::prelude::*;
use shading::f32::{Material, PointLight, Rgb, Vec3};
use shading::shade;
use std::hint::black_box;
use std::time::Instant;

/// A picture of 3840 × 2160 pixels.
const PIXELS: usize = 3840 * 2160;

type Point = [[f32; 3]; 3];

fn shaded(&[n, v, p]: &Point, lamps: &[PointLight], material: &Material) -> [f32; 3] {
    let lights = lamps.iter().map(|lamp| lamp.at(Vec3::from(p)));
    shade::blinn_phong(
        unit(n),
        unit(v),
        black_box(material),
        Rgb::gray(0.2),
        lights,
    )
    .total()
    .into()
}

fn least(times: usize, mut pass: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        pass();
        start.elapsed().as_secs_f64()
    };
    (0..times).map(time).fold(f64::MAX, f64::min)
}

pub fn print() {
    let material = material(50);
    println!("\n**Growth**\n\n| f32 Blinn, m = 50, sphere | time |\n|---|---|");
    for count in [1, 64, 1024] {
        let (points, lamps) = scene(&points("sphere", count), &lamps(count));
        let mut image = vec![[0.0; 3]; points.len()];
        let seconds = least(50, || {
            for (pixel, point) in image.iter_mut().zip(black_box(&points)) {
                *pixel = shaded(point, &lamps, &material);
            }
        });
        let nanoseconds = seconds * 1e9 / (points.len() * count) as f64;
        println!("| {count} lights, one thread | {nanoseconds:.2} ns a light |");
    }
    let (points, lamps) = scene(&points("sphere", 4), &lamps(4));
    let mut image = vec![[0.0; 3]; PIXELS];
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let seconds = pool.install(|| {
            least(5, || {
                let rows = image.par_chunks_mut(3840).enumerate();
                rows.for_each(|(y, row)| {
                    for (x, pixel) in row.iter_mut().enumerate() {
                        *pixel = shaded(&points[(y * 3840 + x) % points.len()], &lamps, &material);
                    }
                });
            })
        });
        println!(
            "| 3840 × 2160 pixels, 4 lights, {threads} threads | {:.0} ms |",
            seconds * 1e3
        );
    }
}
