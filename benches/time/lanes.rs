//! Points in lanes, beside `wide` by hand and C over arrays; and lights in lanes.

use crate::race::{Output, Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S, List};
use shading::{Lanes, Lobe, Material, PointLight, Rgb, UnitVec3, Vec3, shade};
use std::hint::black_box;
use std::time::Instant;
use wide::f32x8;

type V = [f32x8; 3];
const EIGHT: usize = 8;

/// N, V and p of eight points at a time.
pub fn eight_points(points: &[List<List<f64>>]) -> Vec<[V; 3]> {
    let eight = |some: &[List<List<f64>>]| {
        [0, 1, 2].map(|i| {
            [0, 1, 2].map(|k| f32x8::from([0, 1, 2, 3, 4, 5, 6, 7].map(|j| some[j][i][k] as f32)))
        })
    };
    points.chunks_exact(EIGHT).map(eight).collect()
}

fn splat<L: Lanes>(x: L::Lane) -> L {
    L::from_fn(|_| x)
}

/// Ours: points in lanes.
pub fn ours<'a, M: Lobe<f32x8> + 'a>(
    points: &'a [[V; 3]],
    lamps: &'a [PointLight<f32>],
    material: Material<f32, M>,
) -> Pass<'a> {
    let lights: Vec<_> = lamps.iter().map(|lamp| lamp.cast(f32x8::splat)).collect();
    let material = material.cast(f32x8::splat);
    pass::<false, _, _>(points, EIGHT * lamps.len(), move |&[n, v, p]| {
        let [n, v] = [n, v].map(|v| UnitVec3::assume_unit(Vec3::from(v)));
        let lights = lights.iter().map(|light| light.at(Vec3::from(p)));
        let i_a = Rgb::gray(f32x8::splat(0.2));
        let total = shade::blinn_phong(n, v, black_box(&material), i_a, lights).total();
        <V>::from(total).map(f32x8::to_array)
    })
}

fn dot(a: V, b: V) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// By hand on `wide`, with its power.
pub fn by_hand<'a>(points: &'a [[V; 3]], lamps: &'a [List<f64>], m: f32) -> Pass<'a> {
    let splat = |v: List<f64>| v.map(|x| f32x8::splat(x as f32));
    let lamps: Vec<V> = lamps.iter().copied().map(splat).collect();
    let material = [K_A.map(|x| 0.2 * x), K_D, K_S, ATTENUATION].map(splat);
    pass::<false, _, _>(points, EIGHT * lamps.len(), move |&[n, v, p]| {
        let [mut sum, k_d, k_s, [a, b, c]] = *black_box(&material);
        let m = f32x8::splat(black_box(m));
        for lamp in &lamps {
            let way = [0, 1, 2].map(|k| lamp[k] - p[k]);
            let q = dot(way, way).sqrt();
            let l = way.map(|x| x * (f32x8::ONE / q));
            let n_dot_l = dot(n, l).max(f32x8::ZERO);
            let lit = n_dot_l.simd_gt(f32x8::ZERO);
            if lit.any() {
                let h = [0, 1, 2].map(|k| l[k] + v[k]);
                let n_dot_h = (dot(n, h) / dot(h, h).sqrt()).max(f32x8::ZERO);
                let highlight = n_dot_h.powf_simd(m) & lit;
                let arriving = f32x8::ONE / (a + q * (b + c * q));
                for k in 0..3 {
                    sum[k] += arriving * (k_d[k] * n_dot_l + k_s[k] * highlight);
                }
            }
        }
        sum.map(f32x8::to_array)
    })
}

unsafe extern "C" {
    fn shade_lanes(
        material: &[f32; 13],
        lamp_count: usize,
        lamps: *const [f32; 3],
        count: usize,
        inputs: &[*mut f32; 9],
        image: &[*mut f32; 3],
    );
}

/// In C, over arrays.
pub fn in_c(points: &[List<List<f64>>], lamps: &[List<f64>], m: f32) -> Pass<'static> {
    let arrays = [0, 1, 2, 3, 4, 5, 6, 7, 8]
        .map(|i| points.iter().map(|p| p[i / 3][i % 3] as f32).collect());
    let (mut inputs, count): ([Vec<f32>; 9], _) = (arrays, points.len());
    let lamps: Vec<_> = lamps.iter().map(|lamp| lamp.map(|x| x as f32)).collect();
    let numbers = [K_A.map(|x| 0.2 * x), K_D, K_S, ATTENUATION];
    let mut numbers = numbers.into_iter().flatten().map(|x| x as f32).chain([m]);
    let material = [(); 13].map(|()| numbers.next().unwrap());
    let mut image = [(); 3].map(|()| vec![0.0_f32; count]);
    Box::new(move |sum| {
        let start = Instant::now();
        let inputs = inputs.each_mut().map(Vec::as_mut_ptr);
        let channels = image.each_mut().map(Vec::as_mut_ptr);
        // SAFETY: every array has `count` elements, and the inputs are only read.
        unsafe {
            shade_lanes(
                &material,
                lamps.len(),
                lamps.as_ptr(),
                count,
                &inputs,
                &channels,
            );
        }
        let nanoseconds = start.elapsed().as_secs_f64() * 1e9;
        let total = if sum {
            image.iter().flatten().map(Output::sum).sum()
        } else {
            0.0
        };
        [nanoseconds / (count * lamps.len()) as f64, total]
    })
}

/// Ours: one point at a time, and its lights in lanes.
pub fn packed<'a, L: Lanes + 'a, M: Lobe<L> + 'a>(
    points: &'a [[[L::Lane; 3]; 3]],
    lamps: &'a [PointLight<L::Lane>],
    material: Material<L::Lane, M>,
) -> Pass<'a>
where
    L::Lane: Output + Default,
{
    let packs: Vec<PointLight<L>> = PointLight::packed(lamps).collect();
    let material = material.cast(splat::<L>);
    pass::<false, _, _>(points, lamps.len(), move |&[n, v, p]| {
        let [n, v] = [n, v].map(|v| UnitVec3::assume_unit(Vec3::from(v)).cast(splat));
        let p = Vec3::from(p).map(splat);
        let lights = packs.iter().map(|pack| pack.at(p));
        let i_a = Rgb::gray(L::of(0.2));
        let shaded = shade::blinn_phong(n, v, black_box(&material), i_a, lights);
        <[L::Lane; 3]>::from(shaded.sum_of_lanes().total())
    })
}
