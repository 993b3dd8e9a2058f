//! The same by hand on `glam`, with the powers of the standard library.

use crate::race::{Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S, List};
use std::hint::black_box;

macro_rules! hand {
    ($name:ident, $float:ident, $vector:ty) => {
        pub mod $name {
            use super::*;
            type V = $vector;

            pub fn vector(v: List<f64>) -> V {
                V::from(v.map(|x| x as $float))
            }

            pub struct Lamp {
                position: V,
                intensity: V,
                abc: [$float; 3],
            }

            pub struct Material {
                k_a: V,
                k_d: V,
                k_s: V,
            }

            pub fn lamps(positions: &[List<f64>]) -> Vec<Lamp> {
                let lamp = |&position: &_| Lamp {
                    position: vector(position),
                    intensity: V::ONE,
                    abc: ATTENUATION.map(|x| x as $float),
                };
                positions.iter().map(lamp).collect()
            }

            pub fn material() -> Material {
                let [k_a, k_d, k_s] = [K_A, K_D, K_S].map(vector);
                Material { k_a, k_d, k_s }
            }

            #[inline]
            pub fn blinn(n: V, v: V, l: V, _: $float) -> $float {
                n.dot((l + v).normalize())
            }

            #[inline]
            pub fn phong(n: V, v: V, l: V, n_dot_l: $float) -> $float {
                (n * (2.0 * n_dot_l) - l).dot(v)
            }

            /// Adds what a lamp gives. `share` is how much of the light arrives, from L and q.
            #[inline]
            pub fn add(
                sum: &mut V,
                n: V,
                p: V,
                material: &Material,
                lamp: &Lamp,
                highlight: impl Fn(V, $float) -> $float,
                share: impl Fn(V, $float) -> $float,
            ) {
                let way = lamp.position - p;
                let q = way.length();
                let l = way / q;
                let n_dot_l = n.dot(l);
                if n_dot_l > 0.0 {
                    let share = share(l, q);
                    if share > 0.0 {
                        let [a, b, c] = lamp.abc;
                        let reflected =
                            material.k_d * n_dot_l + material.k_s * highlight(l, n_dot_l);
                        *sum += lamp.intensity * share * reflected / (a + b * q + c * q * q);
                    }
                }
            }

            /// The sums of Blinn by an even m, an odd m and a real m, and of Phong.
            pub fn sums<'a, const CALL: bool>(
                points: &'a [[V; 3]],
                lamps: &'a [Lamp],
            ) -> [Pass<'a>; 4] {
                macro_rules! sum {
                    ($cosine:ident, $power:ident, $m:expr) => {{
                        let material = material();
                        pass::<CALL, _, _>(points, lamps.len(), move |&[n, v, p]| {
                            let (material, m) = (black_box(&material), black_box($m));
                            let mut sum = material.k_a * 0.2;
                            let highlight =
                                |l, n_dot_l| $cosine(n, v, l, n_dot_l).max(0.0).$power(m);
                            for lamp in lamps {
                                add(&mut sum, n, p, material, lamp, highlight, |_, _| 1.0);
                            }
                            <[$float; 3]>::from(sum)
                        })
                    }};
                }
                [
                    sum!(blinn, powi, 50),
                    sum!(blinn, powi, 51),
                    sum!(blinn, powf, 50.5),
                    sum!(phong, powi, 50),
                ]
            }
        }
    };
}

hand!(vec3, f32, glam::Vec3);
hand!(vec3a, f32, glam::Vec3A);
hand!(dvec3, f64, glam::DVec3);
