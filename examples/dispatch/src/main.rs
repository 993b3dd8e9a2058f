//! One program for all x86-64 processors, which shades in AVX2 where the processor has it.
//!
//! `cargo run --release -p dispatch` shades the same points in each way, checks that the bits are the same, and
//! prints the times. It fails if AVX2 takes more than 0.55 of the time in the lanes of `wide`, which are those of
//! SSE2 in such a program. A debug build compares the bits alone.

#![allow(clippy::inline_always)] // a function that is not inlined is compiled for SSE2

mod lanes;

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use lanes::Lanes;
use shading::{
    Attenuation, IncidentLight, Material, PointLight, Real, Rgb, Shaded, UnitVec3, Vec3, shade,
};
use wide::f32x16;

const POINTS: usize = 4096;
/// The number of lanes of every type here.
const COUNT: usize = 16;
const LIMIT: f64 = 0.55;

struct Scene<T> {
    points: Vec<[Vec3<T>; 3]>, // p, N and V
    lights: [PointLight<T>; 4],
    material: Material<T, u32>,
    image: Vec<Rgb<T>>,
}

impl<T: Real> Scene<T> {
    fn new(gather: impl Fn(&[f32]) -> T) -> Self {
        let color = |r, g, b| Rgb::new(r, g, b).map(T::of_f32);
        let lamp = |x, y, z| PointLight {
            position: Vec3::new(x, y, z).map(T::of_f32),
            intensity: color(1.0, 0.9, 0.8),
            attenuation: Attenuation::<f32>::new(1.0, 0.1, 0.05)
                .unwrap_or_default()
                .cast(T::of_f32),
        };
        let points: Vec<_> = surface()
            .chunks(COUNT)
            .map(|points| {
                [0, 1, 2].map(|which| {
                    let lanes = |k: usize| points.iter().map(|p| p[which][k]).collect::<Vec<_>>();
                    Vec3::from([0, 1, 2].map(|k| gather(&lanes(k))))
                })
            })
            .collect();
        Self {
            image: vec![Rgb::BLACK; points.len()],
            points,
            lights: [
                lamp(3.0, 1.0, 2.0),
                lamp(-3.0, 2.0, 1.0),
                lamp(0.5, -3.0, 2.0),
                lamp(1.0, 2.0, -3.5),
            ],
            material: Material {
                k_a: color(0.3, 0.25, 0.2),
                k_d: color(0.6, 0.5, 0.4),
                k_s: color(0.4, 0.4, 0.35),
                m: 50,
            },
        }
    }

    #[inline(always)]
    fn shade(
        &mut self,
        shaded: impl Fn([Vec3<T>; 3], &[PointLight<T>], &Material<T, u32>) -> Shaded<T>,
    ) {
        for (&point, pixel) in self.points.iter().zip(&mut self.image) {
            *pixel = shaded(point, &self.lights, &self.material).total();
        }
    }
}

/// What the lights give at p. Its loop is always inlined; that of `map` may be a function of its own, for SSE2.
struct At<'a, T> {
    lights: &'a [PointLight<T>],
    p: Vec3<T>,
}

impl<T: Real> Iterator for At<'_, T> {
    type Item = IncidentLight<T>;

    #[inline(always)]
    fn next(&mut self) -> Option<IncidentLight<T>> {
        let (light, rest) = self.lights.split_first()?;
        self.lights = rest;
        Some(light.at(self.p))
    }

    #[inline(always)]
    fn fold<B, F: FnMut(B, IncidentLight<T>) -> B>(self, mut sum: B, mut f: F) -> B {
        for light in self {
            sum = f(sum, light);
        }
        sum
    }
}

/// Points of a wavy surface, with N and V.
#[allow(clippy::cast_precision_loss)]
fn surface() -> Vec<[[f32; 3]; 3]> {
    let unit = |[x, y, z]: [f32; 3]| {
        let length = (x * x + y * y + z * z).sqrt();
        [x / length, y / length, z / length]
    };
    let point = |i: usize| {
        let (x, y) = ((i % 64) as f32 / 32.0 - 1.0, (i / 64) as f32 / 32.0 - 1.0);
        let normal = [-0.9 * (3.0 * x).cos(), 0.6 * (2.0 * y).sin(), 1.0];
        [
            [x, y, 0.3 * (3.0 * x).sin() + 0.3 * (2.0 * y).cos()],
            unit(normal),
            unit([-x, -y, 4.0]),
        ]
    };
    (0..POINTS).map(point).collect()
}

/// For every x86-64 processor, as one writes it: `wide` has the lanes of SSE2.
#[inline(never)]
fn for_any<T: Real>(scene: &mut Scene<T>) {
    scene.shade(|[p, n, v], lights, material| {
        let [n, v] = [n, v].map(UnitVec3::assume_unit);
        let lights = lights.iter().map(|light| light.at(p));
        shade::blinn_phong(n, v, material, Rgb::BLACK, lights)
    });
}

/// For processors with AVX2: everything it calls is inlined, and so compiled for AVX2.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn for_avx2(scene: &mut Scene<Lanes>) {
    scene.shade(|[p, n, v], lights, material| {
        let [n, v] = [n, v].map(UnitVec3::assume_unit);
        shade::blinn_phong(n, v, material, Rgb::BLACK, At { lights, p })
    });
}

fn bits<T: Copy, const N: usize>(image: &[Rgb<T>], lanes: impl Fn(T) -> [f32; N]) -> Vec<u32> {
    let of_one = |c: &Rgb<T>| {
        let channels = <[T; 3]>::from(*c).map(&lanes);
        (0..N).flat_map(move |i| channels.map(|channel| channel[i].to_bits()))
    };
    image.iter().flat_map(of_one).collect()
}

/// The least time of many, in nanoseconds for a point and a light.
fn least(times: &mut f64, work: impl FnOnce()) {
    let start = Instant::now();
    work();
    #[allow(clippy::cast_precision_loss)]
    let each = start.elapsed().as_secs_f64() * 1e9 / (4 * POINTS) as f64;
    *times = times.min(each);
}

fn main() -> ExitCode {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") {
        // SAFETY: The processor has AVX2.
        return compare(|scene| unsafe { for_avx2(scene) });
    }
    println!("this processor has no AVX2, so a program would shade in SSE2");
    ExitCode::SUCCESS
}

/// Compares bits and times with those of SSE2. A renderer would make one of the two scenes, once, and shade it.
fn compare(in_avx2: impl Fn(&mut Scene<Lanes>)) -> ExitCode {
    let lanes = |x: &[f32]| std::array::from_fn(|i| x[i]);
    let mut sse2 = Scene::new(|x| f32x16::new(lanes(x)));
    let mut avx2 = Scene::new(|x| Lanes(lanes(x)));
    let mut alone: Vec<_> = (0..COUNT).map(|i| Scene::new(|x| x[i])).collect();

    for_any(&mut sse2);
    in_avx2(&mut avx2);
    alone.iter_mut().for_each(for_any);
    let one_by_one: Vec<_> = (0..POINTS / COUNT)
        .flat_map(|k| alone.iter().map(move |scene| scene.image[k]))
        .collect();
    let expected = bits(&one_by_one, |x| [x]);
    if bits(&sse2.image, f32x16::to_array) != expected || bits(&avx2.image, |x| x.0) != expected {
        eprintln!("dispatch: the bits differ");
        return ExitCode::FAILURE;
    }

    let mut ratio = f64::INFINITY;
    for _ in 0..3 {
        let [mut of_sse2, mut of_avx2] = [f64::INFINITY; 2];
        for _ in 0..300 {
            least(&mut of_sse2, || for_any(black_box(&mut sse2)));
            least(&mut of_avx2, || in_avx2(black_box(&mut avx2)));
        }
        println!("{of_sse2:.2} ns for a point and a light in SSE2, {of_avx2:.2} ns in AVX2");
        ratio = ratio.min(of_avx2 / of_sse2);
        if ratio <= LIMIT {
            break;
        }
    }
    println!("ratio {ratio:.2}, and every bit is the same");
    if ratio > LIMIT && !cfg!(debug_assertions) {
        eprintln!("dispatch: AVX2 takes more than {LIMIT} of the time in SSE2");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
