//! The Utah teapot as it was designed: as bicubic Bézier patches.

use shading::{Real, Vec3};

const FILE: &str = include_str!("../../examples/gallery/data/teapot.bezier");

/// Four rows of four control points each.
pub type Patch = [[Vec3<f32>; 4]; 4];

pub fn patches() -> Vec<Patch> {
    let numbers = |tag| {
        let lines = FILE.lines().filter_map(move |line| line.strip_prefix(tag));
        lines.map(|line| {
            line.split_whitespace()
                .map(|number| number.parse().expect("a number"))
        })
    };
    let points: Vec<[f32; 3]> = numbers("v ")
        .map(|mut line| std::array::from_fn(|_| line.next().expect("three coordinates")))
        .collect();
    numbers("p ")
        .map(|mut line| {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let mut point = || Vec3::from(points[line.next().expect("sixteen points") as usize]);
            std::array::from_fn(|_| std::array::from_fn(|_| point()))
        })
        .collect()
}

/// The patch, u, and v of each point of a grid over every patch.
pub fn parameters(patches: usize, steps: u16) -> impl Iterator<Item = (usize, f32, f32)> {
    let at = move |i: u16| (f32::from(i) + 0.5) / f32::from(steps);
    let grid = move || (0..steps).flat_map(move |i| (0..steps).map(move |j| (at(i), at(j))));
    (0..patches).flat_map(move |patch| grid().map(move |(u, v)| (patch, u, v)))
}

/// The point of a patch at (u, v), in any number type.
pub fn point<T: Real>(patch: &Patch, u: T, v: T) -> Vec3<T> {
    let row = |row: &[Vec3<f32>; 4]| cubic(row.map(|p| p.map(|x| T::of(x.into()))), v);
    cubic(patch.each_ref().map(row), u)
}

/// A cubic Bézier curve in terms of Bernstein polynomials.
fn cubic<T: Real>([a, b, c, d]: [Vec3<T>; 4], t: T) -> Vec3<T> {
    let (s, three) = (T::ONE - t, T::of(3.0));
    a * (s * s * s) + b * (three * s * s * t) + c * (three * s * t * t) + d * (t * t * t)
}
