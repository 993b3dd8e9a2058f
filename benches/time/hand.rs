//! The same by hand on `glam`, with other crates, and with the powers of the standard library.

use crate::race::{Pass, pass};
use crate::scene::{ATTENUATION, K_A, K_D, K_S, List};
use glam::Vec3;
use std::hint::black_box;

macro_rules! hand {
    ($name:ident, $float:ident, $vector:ty) => {
        pub mod $name {
            use super::*;
            pub type V = $vector;
            /// N, V and p, and the lamps.
            pub type Scene = (Vec<[V; 3]>, Vec<Lamp>);

            pub fn vector(v: List<f64>) -> V {
                V::from(v.map(|x| x as $float))
            }

            #[derive(Clone, Copy)]
            pub struct Lamp {
                pub position: V,
                pub intensity: V,
                pub abc: [$float; 3],
            }

            pub fn scene(points: &[List<List<f64>>], positions: &[List<f64>]) -> Scene {
                let lamp = |&position: &_| Lamp {
                    position: vector(position),
                    intensity: V::ONE,
                    abc: ATTENUATION.map(|x| x as $float),
                };
                let points = points.iter().map(|point| point.map(vector)).collect();
                (points, positions.iter().map(lamp).collect())
            }

            /// k_a, k_d and k_s.
            pub type Material = [V; 3];

            pub fn material() -> Material {
                [K_A, K_D, K_S].map(vector)
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
                    let sum = material[0] * 0.2;
                    Self {
                        n,
                        v,
                        p,
                        material,
                        highlight,
                        sum,
                    }
                }

                /// Adds a lamp. `fraction` is how much of its light arrives, from L and q.
                #[inline(always)]
                pub fn add(&mut self, lamp: &Lamp, fraction: impl Fn(V, $float) -> $float) {
                    let to_light = lamp.position - self.p;
                    let q = to_light.length();
                    let l = to_light / q;
                    let n_dot_l = self.n.dot(l);
                    if n_dot_l > 0.0 {
                        let fraction = fraction(l, q);
                        if fraction > 0.0 {
                            let [a, b, c] = lamp.abc;
                            let reflected = self.reflected(l, n_dot_l) * fraction;
                            self.sum += lamp.intensity * reflected / (a + b * q + c * q * q);
                        }
                    }
                }

                /// Adds a lamp as an expert does: the sign of N·L comes before the root, and each vector is
                /// divided by one reciprocal.
                #[inline(always)]
                pub fn add_as_expert(&mut self, lamp: &Lamp) {
                    let to_light = lamp.position - self.p;
                    if self.n.dot(to_light) > 0.0 {
                        let q = to_light.length();
                        let l = to_light * (1.0 / q);
                        let [a, b, c] = lamp.abc;
                        let reflected = self.reflected(l, self.n.dot(l));
                        self.sum += lamp.intensity * reflected * (1.0 / (a + b * q + c * q * q));
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
                    self.material[1] * n_dot_l + self.material[2] * highlight
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

            /// The sums of Blinn by an even m, an odd m and a real m, and of Phong, as a newcomer or as an
            /// expert writes them.
            pub fn sums<const CALL: bool, const EXPERT: bool>(
                (points, lamps): &Scene,
            ) -> [Pass<'_>; 4] {
                macro_rules! sum {
                    ($cosine:ident, $power:ident, $m:expr) => {{
                        let material = material();
                        pass::<CALL, _, _>(points, lamps.len(), move |point| {
                            let m = black_box($m);
                            let highlight = |n, v, l, n_dot_l| $cosine(n, v, l, n_dot_l).$power(m);
                            let mut point = Point::new(point, black_box(&material), highlight);
                            for lamp in lamps {
                                if EXPERT {
                                    point.add_as_expert(lamp);
                                } else {
                                    point.add(lamp, |_, _| 1.0);
                                }
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

fn encoded(linear: f32) -> f32 {
    match linear.clamp(0.0, 1.0) {
        x if x <= 0.003_130_8 => 12.92 * x,
        x => 1.055 * x.powf(1.0 / 2.4) - 0.055,
    }
}

/// Colors to bytes by `fast-srgb8` and by a power, and normals on `glam`.
pub fn loops<'a, const CALL: bool>(
    colors: &'a [List<f32>],
    triangles: &'a [List<List<f32>>],
) -> [Pass<'a>; 7] {
    let level = |channel: f32, highest: f32| (encoded(channel) * highest + 0.5) as u16;
    let rgb565 =
        move |&[r, g, b]: &List<f32>| level(r, 31.0) << 11 | level(g, 63.0) << 5 | level(b, 31.0);
    macro_rules! normal {
        (|$a:ident, $b:ident, $c:ident| $normal:expr) => {
            pass::<CALL, _, _>(triangles, 1, |triangle| {
                let [$a, $b, $c] = triangle.map(Vec3::from);
                $normal.try_normalize().map(<[f32; 3]>::from)
            })
        };
    }
    let corner = pass::<CALL, _, _>(triangles, 1, |triangle| {
        let [a, b, c] = triangle.map(Vec3::from);
        let (e1, e2) = (b - a, c - a);
        let angle = (e1.dot(e2) / (e1.length() * e2.length())).acos();
        <[f32; 3]>::from(
            e1.cross(e2)
                .try_normalize()
                .map_or(Vec3::ZERO, |n| n * angle),
        )
    });
    [
        pass::<CALL, _, _>(colors, 1, |c| c.map(fast_srgb8::f32_to_srgb8)),
        pass::<CALL, _, _>(colors, 1, rgb565),
        normal!(|a, _b, _c| a),
        normal!(|a, b, c| (b - a).cross(c - a)),
        corner,
        normal!(|a, _b, _c| {
            let from_axis = a.truncate().length();
            let ring = 2.0 * (from_axis - 2.0) / from_axis;
            Vec3::new(ring * a.x, ring * a.y, 2.0 * a.z)
        }),
        normal!(|a, _b, _c| Vec3::new(1.0, 0.0, 2.0 * a.x).cross(Vec3::new(0.0, 1.0, -2.0 * a.y))),
    ]
}
