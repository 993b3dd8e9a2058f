// What users write with this crate, in terms that earlier versions of it know too: `slower.rs`
// compiles this file twice.

use super::subject::{self, Dual, Real, Vec3, normal, shade};
use crate::race::{Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S, List};
use std::hint::black_box;

macro_rules! sums {
    ($float:ident) => {
        pub mod $float {
            use super::*;
            use subject::$float as s;

            /// N, V and p, and the lamps.
            pub type Scene = (Vec<[[$float; 3]; 3]>, Vec<s::PointLight>);

            pub fn scene(points: &[List<List<f64>>], positions: &[List<f64>]) -> Scene {
                let list = |v: &List<f64>| v.map(|x| x as $float);
                let [a, b, c] = list(&ATTENUATION);
                let lamp = |position| s::PointLight {
                    position: list(position).into(),
                    intensity: s::Rgb::gray(1.0),
                    attenuation: s::Attenuation::new(a, b, c).unwrap(),
                };
                let point = |point: &List<_>| point.each_ref().map(list);
                let points = points.iter().map(point).collect();
                (points, positions.iter().map(lamp).collect())
            }

            pub fn material<M>(m: M) -> s::Material<M> {
                let [k_a, k_d, k_s] = [K_A, K_D, K_S].map(|k| k.map(|x| x as $float).into());
                s::Material { k_a, k_d, k_s, m }
            }

            #[inline]
            pub fn unit(v: [$float; 3]) -> s::UnitVec3 {
                s::UnitVec3::assume_unit(s::Vec3::from(v))
            }

            /// The sums of Blinn by an even m, an odd m and a real m, and of Phong.
            pub fn sums<const CALL: bool>((points, lamps): &Scene) -> [Pass<'_>; 4] {
                macro_rules! sum {
                    ($sum:ident, $m:literal) => {{
                        let (material, i_a) = (material($m), s::Rgb::gray(0.2));
                        pass::<CALL, _, _>(points, lamps.len(), move |&[n, v, p]| {
                            let (n, v, material) = (unit(n), unit(v), black_box(&material));
                            let lights = lamps.iter().map(|lamp| lamp.at(s::Vec3::from(p)));
                            <[$float; 3]>::from(shade::$sum(n, v, material, i_a, lights).total())
                        })
                    }};
                }
                [
                    sum!(blinn_phong, 50),
                    sum!(blinn_phong, 51),
                    sum!(blinn_phong, 50.5),
                    sum!(phong, 50),
                ]
            }
        }
    };
}

sums!(f32);
sums!(f64);

fn torus<T: Real>(p: Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

fn saddle<T: Real>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u, v, u * u - v * v)
}

/// Colors to bytes, and the normals of a vector, a triangle, its corner, a torus and a saddle.
pub fn loops<'a, const CALL: bool>(
    colors: &'a [List<f32>],
    triangles: &'a [List<List<f32>>],
) -> [Pass<'a>; 7] {
    macro_rules! encoding {
        ($to:ident) => {
            pass::<CALL, _, _>(colors, 1, |&c| subject::Rgb::from(c).$to())
        };
    }
    macro_rules! normal {
        (|$a:ident, $b:ident, $c:ident| $normal:expr) => {
            pass::<CALL, _, _>(triangles, 1, move |triangle| {
                let [$a, $b, $c] = triangle.map(Vec3::from);
                $normal
            })
        };
    }
    let list = |n: Option<subject::UnitVec3<f32>>| n.map(|n| <[f32; 3]>::from(*n));
    [
        encoding!(to_srgb8),
        encoding!(to_rgb565),
        normal!(|a, _b, _c| list(a.unit())),
        normal!(|a, b, c| list(normal::triangle(a, b, c))),
        normal!(|a, b, c| <[f32; 3]>::from(normal::corner(a, b, c))),
        normal!(|a, _b, _c| list(normal::implicit(torus::<Dual>, a))),
        normal!(|a, _b, _c| list(normal::parametric(saddle::<Dual>, a.x, a.y))),
    ]
}
