//! The three ways to shade a point with many lights.

use std::error::Error;

use plotters::chart::SeriesLabelPosition;
use shading::Real;
use wide::{f32x4, f32x8};

use crate::TARGET;
use crate::chart::Chart;
use crate::measure::{nanoseconds, of_three_kinds, packed, packed_of_three_kinds};

const LIGHTS: [usize; 18] = [
    1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 16, 24, 32, 64, 128, 256, 512, 1000,
];

pub fn draw(file: &str) -> Result<(), Box<dyn Error>> {
    let line = |name: &str, nanoseconds: &dyn Fn(usize, usize) -> f64| {
        // more than the processor can memorize which lights are in front
        let time = |lights: usize| nanoseconds((65_536 / lights).next_multiple_of(8), lights);
        let times = LIGHTS.map(|lights| (lights as f64, time(lights)));
        (name.to_owned(), times.to_vec())
    };
    Chart {
        title: "nanoseconds per point and light by lights",
        x: 1.0..1000.0,
        y: 1.0..100.0,
        legend: SeriesLabelPosition::UpperRight,
        lines: vec![
            line("one by one", &|points, lights| {
                nanoseconds(|[x]| f32::of(x), points, lights)
            }),
            line("lights in f32x4", &packed::<f32x4>),
            line("lights in f32x8", &packed::<f32x8>),
            line("points in f32x8", &|points, lights| {
                nanoseconds(|x| f32x8::new(x.map(f32::of)), points, lights)
            }),
            line("three kinds, one by one", &of_three_kinds),
            line("three kinds in f32x4", &packed_of_three_kinds::<f32x4>),
        ],
    }
    .draw(&format!("{TARGET}{file}"))
}
