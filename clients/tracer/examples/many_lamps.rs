//! Draws the scene under 32 lamps, shaded one by one and in SIMD lanes, and prints how long each way takes:
//!
//! `cargo run --release -p tracer --example many_lamps`

use std::array;
use std::time::{Duration, Instant};

use glam::Vec3;
use indicatif::ProgressBar;
use shading::f32::{Attenuation, IncidentLight, Light, PointLight, Rgb, Shaded};
use shading::shade;
use tracer::mesh::Mesh;
use tracer::picture::draw_by;
use tracer::scene::{Hit, Scene};
use tracer::vector::{direction, ours};
use wide::f32x8;

type Pack = shading::Light<f32x8>;

const LAMPS: u8 = 32;
const RUNS: usize = 7;
const WIDTH: usize = 640;
const HEIGHT: usize = 400;
const BUNNY: &str = include_str!("../../../examples/gallery/data/bunny.obj");

fn main() -> Result<(), String> {
    let mut scene = Scene::new(Some(Mesh::read(BUNNY, 1.7, [-0.3, 0.0, 0.0])?));
    scene.lights = (0..LAMPS).map(lamp).collect();
    let packs: Vec<Pack> = Light::packed(&scene.lights).collect();

    println!("{WIDTH} × {HEIGHT} pixels, {LAMPS} lamps, the fastest of {RUNS} runs");
    for shadows in [true, false] {
        let (one_by_one, picture) = timed(|from, along| seen(&scene, shadows, from, along));
        let in_lanes = |from, along| seen_in_lanes(&scene, &packs, shadows, from, along);
        let (in_lanes, same) = timed(in_lanes);
        let differ = picture.iter().zip(&same).map(|(a, b)| a.abs_diff(*b)).max();
        println!(
            "{} shadows: one by one {:.1} frames/s, in lanes {:.1} frames/s; largest difference {}",
            if shadows { "with" } else { "without" },
            1.0 / one_by_one.as_secs_f64(),
            1.0 / in_lanes.as_secs_f64(),
            differ.unwrap_or(0)
        );
        if differ > Some(1) {
            return Err("the two pictures are not the same".into());
        }
    }
    Ok(())
}

/// A lamp in a ring above the scene.
fn lamp(i: u8) -> Light {
    let (sine, cosine) = (std::f32::consts::TAU * f32::from(i) / f32::from(LAMPS)).sin_cos();
    let light = PointLight {
        position: shading::Vec3::new(4.0 * cosine, 3.0, 4.0 * sine),
        intensity: Rgb::new(1.5 + sine, 1.5, 1.5 - sine) * (1.0 / f32::from(LAMPS)),
        attenuation: Attenuation::new(0.5, 0.0, 0.06).unwrap_or_default(),
    };
    light.into()
}

/// The fastest run, and its picture.
fn timed(seen: impl Fn(Vec3, Vec3) -> Option<Shaded> + Sync) -> (Duration, Vec<u8>) {
    let runs = (0..RUNS).map(|_| {
        let start = Instant::now();
        let picture = draw_by(&seen, WIDTH, HEIGHT, &ProgressBar::hidden());
        (start.elapsed(), picture)
    });
    runs.min_by_key(|(time, _)| *time).unwrap_or_default()
}

fn seen(scene: &Scene<Vec3>, shadows: bool, from: Vec3, along: Vec3) -> Option<Shaded> {
    let Hit { t, n, material } = scene.nearest(from, along, f32::MAX)?;
    let p = from + along * t;
    let lights = scene.lights.iter();
    let lit = lights
        .filter_map(|light| light.in_front(ours(p), direction(n)))
        .filter(|light| !shadows || is_unblocked(scene, p, n, light));
    let (n, v) = (direction(n), -direction(along));
    Some(shade::blinn_phong(n, v, material, Rgb::gray(0.08), lit))
}

fn seen_in_lanes(
    scene: &Scene<Vec3>,
    packs: &[Pack],
    shadows: bool,
    from: Vec3,
    along: Vec3,
) -> Option<Shaded> {
    let Hit { t, n, material } = scene.nearest(from, along, f32::MAX)?;
    let p = from + along * t;
    // the same point in each lane
    let p8 = ours(p).map(f32x8::splat);
    let [n8, v8] = [n, -along].map(|d| direction(d).cast(f32x8::splat));
    let lit = packs
        .iter()
        .filter_map(|pack| pack.in_front(p8, n8))
        .map(|lights| {
            if shadows {
                unblocked(scene, p, n, lights)
            } else {
                lights
            }
        });
    let material = material.cast(f32x8::splat);
    let ambient = Rgb::gray(0.08).map(f32x8::splat);
    Some(shade::blinn_phong(n8, v8, &material, ambient, lit).sum_of_lanes())
}

/// These lights, black if they are behind the surface or in shadow.
fn unblocked(
    scene: &Scene<Vec3>,
    p: Vec3,
    n: Vec3,
    lights: shading::IncidentLight<f32x8>,
) -> shading::IncidentLight<f32x8> {
    let arrives = array::from_fn(|lane| {
        let light = lights.cast(|x| x.to_array()[lane]).in_front(direction(n));
        f32::from(light.is_some_and(|light| is_unblocked(scene, p, n, &light)))
    });
    shading::IncidentLight {
        intensity: lights.intensity * f32x8::new(arrives),
        ..lights
    }
}

fn is_unblocked(scene: &Scene<Vec3>, p: Vec3, n: Vec3, light: &IncidentLight) -> bool {
    let start = p + n * 1e-3; // off the surface, so that it does not shadow itself
    let toward = <[f32; 3]>::from(light.l).into();
    scene.nearest(start, toward, light.distance).is_none()
}
