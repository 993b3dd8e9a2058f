//! Measures the time of a sum over lights at many points.

#![allow(clippy::cast_precision_loss)]

use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

use shading::{Attenuation, Material, PointLight, Real, Rgb, UnitVec3, Vec3, shade};

use crate::allocations;

/// The shortest time per point and light: Blinn–Phong with m = 50 over `points` points and `lights`
/// lights. `number` packs one coordinate of `N` points into a number.
///
/// # Panics
///
/// If anything is allocated.
pub fn nanoseconds<T: Real, const N: usize>(
    number: impl Fn([f64; N]) -> T,
    points: usize,
    lights: usize,
) -> f64 {
    let random = RefCell::new(fastrand::Rng::with_seed(1975));
    let coordinate = || random.borrow_mut().f64() * 2.0 - 1.0;
    let vector = || Vec3::from([(); 3].map(|()| number([(); N].map(|()| coordinate()))));
    let places: Vec<_> = (0..points.div_ceil(N))
        .map(|_| {
            (
                vector(),
                vector().unit_or(UnitVec3::Z),
                vector().unit_or(UnitVec3::X),
            )
        })
        .collect();
    let attenuation = Attenuation::<f64>::new(1.0, 0.1, 0.05)
        .expect("valid")
        .cast(T::of);
    let intensity = Rgb::WHITE;
    let lamps: Vec<_> = (0..lights)
        .map(|_| PointLight {
            position: Vec3::from([(); 3].map(|()| T::of(4.0 * coordinate()))),
            intensity,
            attenuation,
        })
        .collect();
    let k = Rgb::gray(T::of(0.5));
    let material = Material {
        k_a: k,
        k_d: k,
        k_s: k,
        m: 50,
    };

    let before = allocations::count();
    let (begin, mut least, mut repetitions) = (Instant::now(), f64::INFINITY, 0);
    while repetitions < 3 || begin.elapsed().as_millis() < 30 {
        let start = Instant::now();
        // several passes, since one may be too short for the clock
        let passes = 1 + 10_000 / (points * lights);
        for _ in 0..passes {
            for &(p, n, v) in black_box(&places) {
                let lit = black_box(&lamps)
                    .iter()
                    .filter_map(|lamp| lamp.in_front(p, n));
                black_box(shade::blinn_phong(n, v, &material, k, lit));
            }
        }
        least = least.min(start.elapsed().as_secs_f64() / passes as f64);
        repetitions += 1;
    }
    assert_eq!(allocations::count(), before, "something was allocated");
    least * 1e9 / (points * lights) as f64
}
