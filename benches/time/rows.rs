//! A row of pixels, from arrays of structures: eight pixels in lanes, beside one after the other.
//! All bits are equal.

use crate::ours::f32::{material, scene, unit};
use crate::race::{Pass, pass};
use crate::scene::List;
use shading::f32::{PointLight, Rgb, UnitVec3, Vec3};
use shading::{Lobe, shade};
use std::hint::black_box;
use wide::f32x8;

/// What a renderer knows of a pixel.
#[derive(Clone, Copy)]
struct Pixel {
    n: UnitVec3,
    v: UnitVec3,
    p: Vec3,
}

/// Ours in lanes, beside ours one by one.
pub fn both<M: Lobe<f32> + Lobe<f32x8>>(
    points: &[List<List<f64>>],
    positions: &[List<f64>],
    m: M,
    race: impl FnOnce([Pass; 2]),
) {
    let (points, lamps) = scene(points, positions);
    let pixel = |&[n, v, p]: &[List<f32>; 3]| Pixel {
        n: unit(n),
        v: unit(v),
        p: p.into(),
    };
    let pixels: Vec<Pixel> = points.iter().map(pixel).collect();
    let eights: Vec<[Pixel; 8]> = pixels.as_chunks().0.to_vec();
    let material = material(m);
    let one_by_one = pass::<false, _, _>(&pixels, lamps.len(), |&Pixel { n, v, p }| {
        let lights = lamps.iter().map(|lamp| lamp.at(p));
        let shaded = shade::blinn_phong(n, v, black_box(&material), Rgb::gray(0.2), lights);
        <[f32; 3]>::from(shaded.total())
    });
    let lights: Vec<_> = lamps
        .iter()
        .map(|lamp: &PointLight| lamp.cast(f32x8::splat))
        .collect();
    let wide = material.cast(f32x8::splat);
    let in_lanes = pass::<false, _, _>(&eights, 8 * lamps.len(), |pixels| {
        let n = shading::UnitVec3::<f32x8>::from_lanes(pixels.map(|pixel| pixel.n));
        let v = shading::UnitVec3::<f32x8>::from_lanes(pixels.map(|pixel| pixel.v));
        let p = shading::Vec3::<f32x8>::from_lanes(pixels.map(|pixel| pixel.p));
        let lights = lights.iter().map(|light| light.at(p));
        let i_a = shading::Rgb::gray(f32x8::splat(0.2));
        let shaded = shade::blinn_phong(n, v, black_box(&wide), i_a, lights);
        shaded.total().to_lanes().map(<[f32; 3]>::from)
    });
    race([in_lanes, one_by_one]);
}
