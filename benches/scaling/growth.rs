//! The time over points × lights, and with each number type.

use std::error::Error;

use plotters::chart::SeriesLabelPosition;
use shading::Real;
use wide::{f32x8, f32x16, f64x8};

use crate::TARGET;
use crate::chart::Chart;
use crate::measure::nanoseconds;

pub fn draw() -> Result<(), Box<dyn Error>> {
    let one = |[x]: [f64; 1]| f32::of(x);
    let eight = |x: [f64; 8]| f32x8::new(x.map(f32::of));
    let sixteen = |x: [f64; 16]| f32x16::new(x.map(f32::of));

    let lights = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000];
    let by_lights = |lights: usize| {
        let points = (0..=6)
            .map(|power| 10_usize.pow(power))
            .filter(|p| p * lights <= 1_000_000);
        let times = points.map(|points| {
            let time = nanoseconds(one, points, lights);
            (
                (points * lights) as f64,
                time * (points * lights) as f64 * 1e-9,
            )
        });
        (format!("lights: {lights}"), times.collect())
    };
    Chart {
        title: "seconds by points × lights, f32",
        x: 1.0..1e6,
        y: 1e-9..1e-1,
        legend: SeriesLabelPosition::LowerRight,
        lines: lights.map(by_lights).into(),
    }
    .draw(&format!("{TARGET}scaling.svg"))?;

    let products = || (2..=18).step_by(2).map(|power| 1 << power);
    let with_four_lights = |nanoseconds: &dyn Fn(usize) -> f64| {
        products()
            .map(move |product| (product as f64, nanoseconds(product / 4)))
            .collect()
    };
    Chart {
        title: "nanoseconds per point and light by points × 4 lights",
        x: 4.0..262_144.0,
        y: 0.1..100.0,
        legend: SeriesLabelPosition::LowerLeft,
        lines: vec![
            (
                "f64".into(),
                with_four_lights(&|points| nanoseconds(|[x]| x, points, 4)),
            ),
            (
                "f32".into(),
                with_four_lights(&|points| nanoseconds(one, points, 4)),
            ),
            (
                "f64x8".into(),
                with_four_lights(&|points| nanoseconds(f64x8::new, points, 4)),
            ),
            (
                "f32x8".into(),
                with_four_lights(&|points| nanoseconds(eight, points, 4)),
            ),
            (
                "f32x16".into(),
                with_four_lights(&|points| nanoseconds(sixteen, points, 4)),
            ),
        ],
    }
    .draw(&format!("{TARGET}numbers.svg"))?;
    Ok(())
}
