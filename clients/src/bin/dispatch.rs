//! One program for all x86-64 processors, which shades in AVX2 where the processor has it. It
//! compares every bit with that of one point at a time, and fails if AVX2 takes more than 0.75 of
//! the time of SSE2.
//!
//! A function is compiled for AVX2 if it says so, or is inlined into one that does. `Cargo.toml` sets `lto` and
//! `codegen-units`, so that the sum is inlined into its only caller.
#![allow(
    clippy::inline_always,
    reason = "a function that is not inlined is compiled for SSE2"
)]

use std::arch::x86_64::{
    __m256, _CMP_GT_OQ, _mm256_add_ps, _mm256_blendv_ps, _mm256_cmp_ps, _mm256_div_ps,
    _mm256_movemask_ps, _mm256_mul_ps, _mm256_set1_ps, _mm256_sqrt_ps, _mm256_sub_ps,
    _mm256_xor_ps,
};
use std::array::from_fn;
use std::mem::transmute;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::time::{Duration, Instant};

use shading::number::Mask;
use shading::{Attenuation, Material, PointLight, Real, Rgb, UnitVec3, Vec3, shade};
use wide::f32x8;

const COUNT: usize = 8;

/// Eight numbers in a register. Only `for_avx2` computes with them, and it runs only where there is
/// AVX2: each `unsafe` here relies on that.
#[derive(Clone, Copy)]
struct Lanes(__m256);

impl Lanes {
    const fn all(x: f32) -> Self {
        Self(unsafe { transmute::<[f32; COUNT], __m256>([x; COUNT]) })
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident $intrinsic:ident),*) => {
        $(impl $trait for Lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        })*
    };
}

operators!(Add add _mm256_add_ps, Sub sub _mm256_sub_ps, Mul mul _mm256_mul_ps, Div div _mm256_div_ps);

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(unsafe { _mm256_xor_ps(self.0, _mm256_set1_ps(-0.0)) })
    }
}

impl Real for Lanes {
    type Mask = Above;
    type Sum = Rgb<Self>;

    const ZERO: Self = Self::all(0.0);
    const ONE: Self = Self::all(1.0);
    const NEG_ONE: Self = Self::all(-1.0);
    const MAX: Self = Self::all(f32::MAX);
    const EXTREME: Self = Self::all(<f32 as Real>::EXTREME);

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self::all(f32::of(literal))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { _mm256_sqrt_ps(self.0) })
    }

    #[inline(always)]
    fn above(self, other: Self) -> Above {
        Above(unsafe { _mm256_cmp_ps::<_CMP_GT_OQ>(self.0, other.0) })
    }
}

/// The lanes in which a comparison holds.
#[derive(Clone, Copy)]
struct Above(__m256);

impl Mask<Lanes> for Above {
    #[inline(always)]
    fn any(self) -> bool {
        unsafe { _mm256_movemask_ps(self.0) != 0 }
    }

    #[inline(always)]
    fn all(self) -> bool {
        unsafe { _mm256_movemask_ps(self.0) == 0xFF }
    }

    #[inline(always)]
    fn select(self, then: Lanes, otherwise: Lanes) -> Lanes {
        Lanes(unsafe { _mm256_blendv_ps(otherwise.0, then.0, self.0) })
    }
}

struct Scene<T> {
    /// p, and N and V, which are not normalized yet.
    points: Vec<[Vec3<T>; 3]>,
    lights: [PointLight<T>; 4],
    material: Material<T>,
    image: Vec<Rgb<T>>,
}

impl<T: Real> Scene<T> {
    /// A wavy surface; `gather` makes one number of those of `COUNT` points.
    fn new(gather: impl Fn([f32; COUNT]) -> T) -> Self {
        let point = |i: usize| {
            let (x, y) = ((i % 64) as f32 / 32.0 - 1.0, (i / 64) as f32 / 32.0 - 1.0);
            let z = 0.3 * (3.0 * x).sin() + 0.3 * (2.0 * y).cos();
            let normal = [-0.9 * (3.0 * x).cos(), 0.6 * (2.0 * y).sin(), 1.0];
            let unit = |v: [f32; 3]| <[f32; 3]>::from(*Vec3::from(v).unit_or(UnitVec3::Z));
            [[x, y, z], unit(normal), unit([-x, -y, 4.0 - z])]
        };
        let points: Vec<[Vec3<T>; 3]> = (0..4096 / COUNT)
            .map(|k| {
                let points: [_; COUNT] = from_fn(|i| point(COUNT * k + i));
                from_fn(|which| from_fn(|c| gather(points.map(|point| point[which][c]))).into())
            })
            .collect();
        let lamp = |x, y, z| {
            let lamp = PointLight {
                position: Vec3::new(x, y, z),
                intensity: Rgb::new(1.0, 0.9, 0.8),
                attenuation: Attenuation::new(1.0, 0.1, 0.05).expect("valid"),
            };
            lamp.cast(T::of_f32)
        };
        let (k_a, k_d, k_s) = (Rgb::gray(0.3), Rgb::new(0.6, 0.5, 0.4), Rgb::gray(0.4));
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
                k_a,
                k_d,
                k_s,
                m: 50,
            }
            .cast(T::of_f32),
        }
    }

    #[inline(always)]
    fn shade(&mut self) {
        for (&[p, n, v], pixel) in self.points.iter().zip(&mut self.image) {
            let (n, v) = (UnitVec3::assume_unit(n), UnitVec3::assume_unit(v));
            let lights = self.lights.iter().map(|light| light.at(p));
            *pixel = shade::blinn_phong(n, v, &self.material, Rgb::BLACK, lights).total();
        }
    }

    fn bits(&self, lanes: impl Fn(T) -> [f32; COUNT]) -> Vec<[u32; COUNT]> {
        let channels = self.image.iter().flat_map(|color| <[T; 3]>::from(*color));
        channels
            .map(|channel| lanes(channel).map(f32::to_bits))
            .collect()
    }
}

/// For every x86-64 processor: `wide` has the lanes of SSE2.
#[inline(never)]
fn for_any(scene: &mut Scene<f32x8>) {
    scene.shade();
}

/// For processors with AVX2: everything it calls is inlined, and so compiled for AVX2.
#[target_feature(enable = "avx2")]
fn for_avx2(scene: &mut Scene<Lanes>) {
    scene.shade();
}

/// Lowers the least time so far.
fn timed(least: &mut Duration, work: impl FnOnce()) {
    let start = Instant::now();
    work();
    *least = start.elapsed().min(*least);
}

fn main() {
    if !is_x86_feature_detected!("avx2") {
        println!("This processor has no AVX2, so the program would shade in SSE2.");
        return;
    }
    let mut sse2 = Scene::new(f32x8::new);
    let mut avx2 = Scene::new(|x| Lanes(unsafe { transmute::<[f32; COUNT], __m256>(x) }));
    let [mut in_sse2, mut in_avx2] = [Duration::MAX; 2];
    for _ in 0..1000 {
        timed(&mut in_sse2, || for_any(&mut sse2));
        // SAFETY: The processor has AVX2.
        timed(&mut in_avx2, || unsafe { for_avx2(&mut avx2) });
    }
    println!("4,096 points under 4 lights: {in_sse2:.0?} in SSE2, {in_avx2:.0?} in AVX2");

    let mut alone: [_; COUNT] = from_fn(|i| Scene::new(|lanes| lanes[i]));
    alone.iter_mut().for_each(Scene::shade);
    let alone = alone.map(|scene| scene.bits(|x| [x; COUNT]));
    let expected: Vec<_> = (0..alone[0].len())
        .map(|k| from_fn(|i| alone[i][k][i]))
        .collect();
    assert_eq!(sse2.bits(f32x8::to_array), expected, "the bits of SSE2");
    let of_avx2 = avx2.bits(|x| unsafe { transmute::<__m256, [f32; COUNT]>(x.0) });
    assert_eq!(of_avx2, expected, "the bits of AVX2");
    println!("Every bit is that of one point at a time.");
    assert!(
        in_avx2 < in_sse2.mul_f32(0.75),
        "not all is compiled for AVX2"
    );
}
