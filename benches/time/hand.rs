//! The same by hand on `glam`, with the powers of the standard library.

use crate::race::{Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S, List};
use std::hint::black_box;

macro_rules! hand {
    ($name:ident, $float:ident, $vector:ty) => {
        pub mod $name {
            use super::*;
            pub type V = $vector;

            pub fn vector(v: List<f64>) -> V {
                V::from(v.map(|x| x as $float))
            }

            #[derive(Clone, Copy)]
            pub struct Lamp {
                pub position: V,
                intensity: V,
                abc: [$float; 3],
            }

            pub fn lamp(position: List<f64>) -> Lamp {
                let abc = ATTENUATION.map(|x| x as $float);
                Lamp {
                    position: vector(position),
                    intensity: V::ONE,
                    abc,
                }
            }

            pub struct Material {
                ambient: V,
                diffuse: V,
                specular: V,
            }

            pub fn material() -> Material {
                let [ambient, diffuse, specular] = [K_A, K_D, K_S].map(vector);
                Material {
                    ambient,
                    diffuse,
                    specular,
                }
            }

            /// The sum over the lights of a point. `highlight` has N, V, L and N·L.
            pub struct Point<'a, H> {
                n: V,
                v: V,
                pub p: V,
                material: &'a Material,
                highlight: H,
                pub sum: V,
            }

            impl<'a, H: Fn(V, V, V, $float) -> $float> Point<'a, H> {
                #[inline(always)]
                pub fn new(&[n, v, p]: &[V; 3], material: &'a Material, highlight: H) -> Self {
                    let sum = material.ambient * 0.2;
                    Self {
                        n,
                        v,
                        p,
                        material,
                        highlight,
                        sum,
                    }
                }

                /// Adds a lamp. `share` is how much of its light arrives, from L and q.
                #[inline(always)]
                pub fn add(&mut self, lamp: &Lamp, share: impl Fn(V, $float) -> $float) {
                    let way = lamp.position - self.p;
                    let q = way.length();
                    let l = way / q;
                    let n_dot_l = self.n.dot(l);
                    if n_dot_l > 0.0 {
                        let share = share(l, q);
                        if share > 0.0 {
                            let [a, b, c] = lamp.abc;
                            let reflected = self.reflected(l, n_dot_l) * share;
                            self.sum += lamp.intensity * reflected / (a + b * q + c * q * q);
                        }
                    }
                }

                /// Adds a white light from the direction L.
                #[allow(dead_code)] // `Vec3A` has lamps alone
                #[inline(always)]
                pub fn add_sun(&mut self, l: V) {
                    let n_dot_l = self.n.dot(l);
                    if n_dot_l > 0.0 {
                        self.sum += self.reflected(l, n_dot_l);
                    }
                }

                #[inline(always)]
                fn reflected(&self, l: V, n_dot_l: $float) -> V {
                    let highlight = (self.highlight)(self.n, self.v, l, n_dot_l);
                    self.material.diffuse * n_dot_l + self.material.specular * highlight
                }
            }

            #[inline(always)]
            pub fn blinn(n: V, v: V, l: V, _: $float) -> $float {
                n.dot((l + v).normalize()).max(0.0)
            }

            #[inline(always)]
            fn phong(n: V, v: V, l: V, n_dot_l: $float) -> $float {
                (n * (2.0 * n_dot_l) - l).dot(v).max(0.0)
            }

            /// The sums of Blinn by an even m, an odd m and a real m, and of Phong.
            pub fn sums<'a, const CALL: bool>(
                points: &'a [[V; 3]],
                lamps: &'a [Lamp],
            ) -> [Pass<'a>; 4] {
                macro_rules! sum {
                    ($cosine:ident, $power:ident, $m:expr) => {{
                        let material = material();
                        pass::<CALL, _, _>(points, lamps.len(), move |point| {
                            let m = black_box($m);
                            let highlight = |n, v, l, n_dot_l| $cosine(n, v, l, n_dot_l).$power(m);
                            let mut point = Point::new(point, black_box(&material), highlight);
                            for lamp in lamps {
                                point.add(lamp, |_, _| 1.0);
                            }
                            <[$float; 3]>::from(point.sum)
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
