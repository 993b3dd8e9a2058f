//! Measures the time of a sum over lights at many points.

#![allow(clippy::cast_precision_loss)]

use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

use shading::{
    Attenuation, Cone, DirectionalLight, Lanes, Light, Material, PointLight, Real, Rgb, Shaded,
    SpotLight, UnitVec3, Vec3, shade,
};

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
    let random = Random::default();
    let places = random.places(number, points.div_ceil(N));
    let lamps = random.lamps(lights);
    let material = material();
    let k = material.k_a;
    least(points * lights, || {
        for &(p, n, v) in black_box(&places) {
            let lit = black_box(&lamps)
                .iter()
                .filter_map(|lamp| lamp.in_front(p, n));
            black_box(shade::blinn_phong(n, v, &material, k, lit));
        }
    })
}

/// The same with lights of three kinds in turn.
pub fn of_three_kinds(points: usize, count: usize) -> f64 {
    let lights = Random::default().kinds(count);
    one_at_a_time(points, count, &material(), |p, n, v, material| {
        let lit = lights.iter().filter_map(|light| light.in_front(p, n));
        shade::blinn_phong(n, v, material, material.k_a, lit)
    })
}

/// The same one point at a time, with the lights in the lanes of `L`.
pub fn packed<L: Lanes<Lane = f32>>(points: usize, count: usize) -> f64 {
    let packs: Vec<_> = PointLight::packed::<L>(&Random::default().lamps(count)).collect();
    one_at_a_time(points, count, &material(), |p, n, v, material| {
        let (p, n, v) = (p.map(splat), n.cast(splat), v.cast(splat));
        let lit = packs.iter().filter_map(|pack| pack.in_front(p, n));
        shade::blinn_phong(n, v, material, material.k_a, lit).sum_of_lanes()
    })
}

/// The same with lights of three kinds in turn.
pub fn packed_of_three_kinds<L: Lanes<Lane = f32>>(points: usize, count: usize) -> f64 {
    let packs: Vec<_> = Light::packed::<L>(&Random::default().kinds(count)).collect();
    one_at_a_time(points, count, &material(), |p, n, v, material| {
        let (p, n, v) = (p.map(splat), n.cast(splat), v.cast(splat));
        let lit = packs.iter().filter_map(|pack| pack.in_front(p, n));
        shade::blinn_phong(n, v, material, material.k_a, lit).sum_of_lanes()
    })
}

fn splat<L: Lanes<Lane = f32>>(x: f32) -> L {
    L::from_fn(|_| x)
}

fn one_at_a_time<M>(
    points: usize,
    lights: usize,
    material: &M,
    shade: impl Fn(Vec3<f32>, UnitVec3<f32>, UnitVec3<f32>, &M) -> Shaded<f32>,
) -> f64 {
    let places = Random::default().places(|[x]: [f64; 1]| f32::of(x), points);
    least(points * lights, || {
        for &(p, n, v) in black_box(&places) {
            black_box(shade(p, n, v, black_box(material)));
        }
    })
}

struct Random(RefCell<fastrand::Rng>);

impl Default for Random {
    fn default() -> Self {
        Self(RefCell::new(fastrand::Rng::with_seed(1975)))
    }
}

impl Random {
    fn coordinate(&self) -> f64 {
        self.0.borrow_mut().f64() * 2.0 - 1.0
    }

    /// Points with N and V.
    fn places<T: Real, const N: usize>(
        &self,
        number: impl Fn([f64; N]) -> T,
        count: usize,
    ) -> Vec<(Vec3<T>, UnitVec3<T>, UnitVec3<T>)> {
        let number = || number([(); N].map(|()| self.coordinate()));
        let vector = || Vec3::from([(); 3].map(|()| number()));
        let place = |_| {
            (
                vector(),
                vector().unit_or(UnitVec3::Z),
                vector().unit_or(UnitVec3::X),
            )
        };
        (0..count).map(place).collect()
    }

    fn lamps<T: Real>(&self, count: usize) -> Vec<PointLight<T>> {
        let attenuation = Attenuation::<f64>::new(1.0, 0.1, 0.05).expect("valid");
        let lamp = |_| PointLight {
            position: Vec3::from([(); 3].map(|()| T::of(4.0 * self.coordinate()))),
            intensity: Rgb::WHITE,
            attenuation: attenuation.cast(T::of),
        };
        (0..count).map(lamp).collect()
    }

    /// A lamp, a spot, a sun, and so on.
    fn kinds(&self, count: usize) -> Vec<Light<f32>> {
        let cone = Cone::<f32>::from_half_angle(1.5).expect("a cone");
        let kind = |(i, point): (usize, PointLight<f32>)| {
            let l = point.position.unit_or(UnitVec3::Z);
            match (i % 3, point.intensity) {
                (0, _) => Light::Point(point),
                (1, _) => Light::Spot(SpotLight {
                    point,
                    axis: -l,
                    cone,
                }),
                (_, intensity) => Light::Directional(DirectionalLight { l, intensity }),
            }
        };
        self.lamps(count)
            .into_iter()
            .enumerate()
            .map(kind)
            .collect()
    }
}

fn material<T: Real>() -> Material<T, u32> {
    let k = Rgb::gray(T::of(0.5));
    Material {
        k_a: k,
        k_d: k,
        k_s: k,
        m: 50,
    }
}

/// The least time of `pass` for each of `count`.
fn least(count: usize, pass: impl Fn()) -> f64 {
    let before = allocations::count();
    let (begin, mut least, mut repetitions) = (Instant::now(), f64::INFINITY, 0);
    while repetitions < 3 || begin.elapsed().as_millis() < 30 {
        let start = Instant::now();
        // several passes, since one may be too short for the clock
        let passes = 1 + 10_000 / count;
        for _ in 0..passes {
            pass();
        }
        least = least.min(start.elapsed().as_secs_f64() / passes as f64);
        repetitions += 1;
    }
    assert_eq!(allocations::count(), before, "something was allocated");
    least * 1e9 / count as f64
}
