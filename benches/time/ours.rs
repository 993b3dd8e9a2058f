// What users write with this crate, in terms that earlier versions of it know too: `slower.rs` compiles this file twice.

use super::subject::{self, Dual, Real, Vec3, normal, shade};
use crate::race::{Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S};
use std::hint::black_box;

macro_rules! sums {
    ($float:ident) => {
        pub mod $float {
            use super::*;
            use subject::$float as s;

            pub fn lamps(positions: &[[$float; 3]]) -> Vec<s::PointLight> {
                let [a, b, c] = ATTENUATION.map(|x| x as $float);
                let lamp = |&position: &[$float; 3]| s::PointLight {
                    position: position.into(),
                    intensity: s::Rgb::gray(1.0),
                    attenuation: s::Attenuation::new(a, b, c).unwrap(),
                };
                positions.iter().map(lamp).collect()
            }

            pub fn material<M>(m: M) -> s::Material<M> {
                let [k_a, k_d, k_s] = [K_A, K_D, K_S].map(|k| k.map(|x| x as $float).into());
                s::Material { k_a, k_d, k_s, m }
            }

            /// N or V.
            #[inline]
            pub fn unit(v: [$float; 3]) -> s::UnitVec3 {
                s::UnitVec3::assume_unit(s::Vec3::from(v))
            }

            /// The sums of Blinn by an even m, an odd m and a real m, and of Phong.
            pub fn sums<'a, const CALL: bool>(
                points: &'a [[[$float; 3]; 3]],
                lamps: &'a [s::PointLight],
            ) -> [Pass<'a>; 4] {
                let (even, odd, real) = (material(50), material(51), material(50.5));
                let i_a = s::Rgb::gray(0.2);
                macro_rules! sum {
                    ($sum:ident, $material:ident) => {
                        pass::<CALL, _, _>(points, lamps.len(), move |&[n, v, p]| {
                            let lights = lamps.iter().map(|lamp| lamp.at(s::Vec3::from(p)));
                            let material = black_box(&$material);
                            <[$float; 3]>::from(
                                shade::$sum(unit(n), unit(v), material, i_a, lights).total(),
                            )
                        })
                    };
                }
                [
                    sum!(blinn_phong, even),
                    sum!(blinn_phong, odd),
                    sum!(blinn_phong, real),
                    sum!(phong, even),
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

/// Colors to bytes.
pub fn encodings<const CALL: bool>(colors: &[[f32; 3]]) -> [Pass<'_>; 2] {
    let rgb = |&c: &[f32; 3]| subject::Rgb::from(c);
    [
        pass::<CALL, _, _>(colors, 1, move |c| rgb(c).to_srgb8()),
        pass::<CALL, _, _>(colors, 1, move |c| rgb(c).to_rgb565()),
    ]
}

/// Normals of a vector, a triangle, its corner, a torus and a saddle.
pub fn normals<const CALL: bool>(triangles: &[[[f32; 3]; 3]]) -> [Pass<'_>; 5] {
    let list = |n: Option<subject::UnitVec3<f32>>| n.map(|n| <[f32; 3]>::from(*n));
    [
        pass::<CALL, _, _>(triangles, 1, move |&[a, ..]| list(Vec3::from(a).unit())),
        pass::<CALL, _, _>(triangles, 1, move |&[a, b, c]| {
            list(normal::triangle(
                Vec3::from(a),
                Vec3::from(b),
                Vec3::from(c),
            ))
        }),
        pass::<CALL, _, _>(triangles, 1, move |&[a, b, c]| {
            <[f32; 3]>::from(normal::corner(Vec3::from(a), Vec3::from(b), Vec3::from(c)))
        }),
        pass::<CALL, _, _>(triangles, 1, move |&[a, ..]| {
            list(normal::implicit(torus::<Dual>, Vec3::from(a)))
        }),
        pass::<CALL, _, _>(triangles, 1, move |&[a, ..]| {
            list(normal::parametric(saddle::<Dual>, a[0], a[1]))
        }),
    ]
}
