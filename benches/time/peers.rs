//! What else a user would pick: other vector crates, arrays, and C. The loop of a newcomer, one formula for all.

use crate::race::{Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S, List};
use std::hint::black_box;
use std::ops::{Add, AddAssign, Div, Mul, Sub};

/// The operations of the formulas on a vector of three `f32`.
trait Vector:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<f32, Output = Self>
    + Div<f32, Output = Self>
    + AddAssign
{
    fn new(v: List<f32>) -> Self;
    fn list(self) -> List<f32>;
    fn dot(self, other: Self) -> f32;
    fn times(self, other: Self) -> Self;
    fn length(self) -> f32;
    fn normalized(self) -> Self;
}

macro_rules! vectors {
    ($($vector:ty: |$v:ident, $w:ident| $dot:expr, $times:expr, $length:expr, $normalized:expr;)*) => {$(
        impl Vector for $vector {
            #[inline]
            fn new([x, y, z]: List<f32>) -> Self { Self::new(x, y, z) }
            #[inline]
            fn list(self) -> List<f32> { [self.x, self.y, self.z] }
            #[inline]
            fn dot(self, $w: Self) -> f32 { let $v = self; $dot }
            #[inline]
            fn times(self, $w: Self) -> Self { let $v = self; $times }
            #[inline]
            fn length(self) -> f32 { let $v = self; $length }
            #[inline]
            fn normalized(self) -> Self { let $v = self; $normalized }
        }
    )*};
}

vectors! {
    glam::Vec3: |v, w| glam::Vec3::dot(v, w), v * w, glam::Vec3::length(v), v.normalize();
    ultraviolet::Vec3: |v, w| ultraviolet::Vec3::dot(&v, w), v * w, v.mag(), ultraviolet::Vec3::normalized(&v);
    nalgebra::Vector3<f32>: |v, w| nalgebra::Vector3::dot(&v, &w), v.component_mul(&w), v.norm(), v.normalize();
    vek::Vec3<f32>: |v, w| vek::Vec3::dot(v, w), v * w, v.magnitude(), vek::Vec3::normalized(v);
}

/// Plain arrays.
#[derive(Clone, Copy)]
struct Plain(List<f32>);

macro_rules! plain {
    ($($trait:ident $method:ident $op:tt $other:ty, |$i:ident, $w:ident| $at:expr;)*) => {$(
        impl $trait<$other> for Plain {
            type Output = Self;
            #[inline]
            fn $method(self, $w: $other) -> Self {
                Self([0, 1, 2].map(|$i| self.0[$i] $op $at))
            }
        }
    )*};
}

plain! {
    Add add + Self, |i, w| w.0[i];
    Sub sub - Self, |i, w| w.0[i];
    Mul mul * f32, |i, w| { let _ = i; w };
    Div div / f32, |i, w| { let _ = i; w };
}

impl AddAssign for Plain {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Vector for Plain {
    #[inline]
    fn new(v: List<f32>) -> Self {
        Self(v)
    }
    #[inline]
    fn list(self) -> List<f32> {
        self.0
    }
    #[inline]
    fn dot(self, Self(w): Self) -> f32 {
        self.0[0] * w[0] + self.0[1] * w[1] + self.0[2] * w[2]
    }
    #[inline]
    fn times(self, Self(w): Self) -> Self {
        Self([0, 1, 2].map(|i| self.0[i] * w[i]))
    }
    #[inline]
    fn length(self) -> f32 {
        self.dot(self).sqrt()
    }
    #[inline]
    fn normalized(self) -> Self {
        self / self.length()
    }
}

fn single(v: List<f64>) -> List<f32> {
    v.map(|x| x as f32)
}

fn shaded<'a, V: Vector + 'a>(
    points: &'a [List<List<f64>>],
    positions: &[List<f64>],
    power: impl Fn(f32) -> f32 + 'a,
) -> Pass<'a> {
    let vector = |v: List<f64>| V::new(single(v));
    let points: Vec<[V; 3]> = points.iter().map(|point| point.map(vector)).collect();
    let lamps: Vec<V> = positions.iter().copied().map(vector).collect();
    let (material, abc) = ([K_A, K_D, K_S].map(vector), single(ATTENUATION));
    let white = V::new([1.0; 3]);
    let count = lamps.len();
    pass::<false, _, _>(Vec::leak(points), count, move |&[n, v, p]| {
        let [k_a, k_d, k_s] = *black_box(&material);
        let [a, b, c] = *black_box(&abc);
        let mut sum = k_a * 0.2;
        for &lamp in &lamps {
            let to_light = lamp - p;
            let q = to_light.length();
            let l = to_light / q;
            let n_dot_l = n.dot(l);
            if n_dot_l > 0.0 {
                let n_dot_h = n.dot((l + v).normalized()).max(0.0);
                let reflected = k_d * n_dot_l + k_s * power(n_dot_h);
                sum += black_box(white).times(reflected) / (a + b * q + c * q * q);
            }
        }
        sum.list()
    })
}

pub const COUNT: usize = 7;

/// The peers by name.
pub fn peers<'a>(
    points: &'a [List<List<f64>>],
    positions: &[List<f64>],
    power: impl Fn(f32) -> f32 + Copy + 'a,
    m: f32,
) -> [(&'static str, Pass<'a>); COUNT] {
    [
        ("`glam`", shaded::<glam::Vec3>(points, positions, power)),
        (
            "`ultraviolet`",
            shaded::<ultraviolet::Vec3>(points, positions, power),
        ),
        (
            "`nalgebra`",
            shaded::<nalgebra::Vector3<f32>>(points, positions, power),
        ),
        ("`vek`", shaded::<vek::Vec3<f32>>(points, positions, power)),
        ("plain arrays", shaded::<Plain>(points, positions, power)),
        ("C, `-O2`", in_c(points, positions, m, shade_o2)),
        ("C, `-Ofast`", in_c(points, positions, m, shade_ofast)),
    ]
}

type Shade = unsafe extern "C" fn(
    material: &[f32; 13],
    lamp_count: usize,
    lamps: *const List<f32>,
    count: usize,
    points: *const [List<f32>; 3],
    image: *mut List<f32>,
);

unsafe extern "C" {
    fn shade_o2(
        _: &[f32; 13],
        _: usize,
        _: *const List<f32>,
        _: usize,
        _: *const [List<f32>; 3],
        _: *mut List<f32>,
    );
    fn shade_ofast(
        _: &[f32; 13],
        _: usize,
        _: *const List<f32>,
        _: usize,
        _: *const [List<f32>; 3],
        _: *mut List<f32>,
    );
}

fn in_c(points: &[List<List<f64>>], lamps: &[List<f64>], m: f32, shade: Shade) -> Pass<'static> {
    let points: Vec<_> = points.iter().map(|point| point.map(single)).collect();
    let lamps: Vec<_> = lamps.iter().copied().map(single).collect();
    let numbers = [K_A.map(|x| 0.2 * x), K_D, K_S, ATTENUATION];
    let mut numbers = numbers.into_iter().flatten().map(|x| x as f32).chain([m]);
    let material = [(); 13].map(|()| numbers.next().unwrap());
    let mut image = vec![[0.0; 3]; points.len()];
    Box::new(move |sum| {
        let start = std::time::Instant::now();
        // SAFETY: both arrays have as many elements as is said.
        unsafe {
            shade(
                &material,
                lamps.len(),
                lamps.as_ptr(),
                points.len(),
                points.as_ptr(),
                image.as_mut_ptr(),
            );
        }
        let nanoseconds = start.elapsed().as_secs_f64() * 1e9;
        let total = if sum {
            image.iter().map(crate::race::Output::sum).sum()
        } else {
            0.0
        };
        [nanoseconds / (points.len() * lamps.len()) as f64, total]
    })
}
