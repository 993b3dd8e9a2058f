//! The forms in which a user writes lights, beside the same by hand on `glam`: Blinn, m = 50, in a loop.

use crate::race::{Races, pass};
use crate::scene::List;
use std::hint::black_box;
use std::iter::once;

macro_rules! forms {
    ($float:ident, $hand:ident) => {
        pub mod $float {
            use super::*;
            use crate::hand::$hand::{self as hand, Lamp, Point, V};
            use crate::ours::$float::{material, scene, unit};
            use shading::{$float as s, shade};

            const RANGE: $float = 4.0;
            const INNER: $float = 0.95;
            const OUTER: $float = 0.8;

            enum Kind {
                Sun(V),
                Lamp(Lamp),
                Spot(Lamp, V),
            }

            /// Whether the ceiling z = 1.5 stands between a point and a light.
            #[inline(always)]
            fn blocked(p_z: $float, l_z: $float, q: $float) -> bool {
                let t = (1.5 - p_z) / l_z;
                0.0 < t && t < q
            }

            fn window(q: $float) -> $float {
                let square = (q / RANGE) * (q / RANGE);
                let window = (1.0 - square * square).max(0.0);
                window * window
            }

            fn hard(axis: V, l: V) -> $float {
                if -axis.dot(l) < OUTER { 0.0 } else { 1.0 }
            }

            fn soft(axis: V, l: V) -> $float {
                let t = ((-axis.dot(l) - OUTER) / (INNER - OUTER)).clamp(0.0, 1.0);
                t * t
            }

            /// Four lamps.
            pub fn race(races: &mut Races, data: &str, points: &[List<List<f64>>], positions: &[List<f64>]) {
                let (inputs, lamps) = &scene(points, positions);
                let aimed = |cone: Option<s::Cone>| -> Vec<_> {
                    let axis = |lamp: &s::PointLight| (-lamp.position).unit().unwrap();
                    let spot = |&point| s::SpotLight { axis: axis(&point), cone: cone.unwrap(), point };
                    lamps.iter().map(spot).collect()
                };
                let spots = &aimed(s::Cone::from_cosine(OUTER));
                let soft_spots = &aimed(s::Cone::from_cosines(INNER, OUTER));
                let ranged = &mut lamps.clone();
                for lamp in ranged.iter_mut() {
                    lamp.attenuation = lamp.attenuation.within(RANGE).unwrap();
                }
                let sun = &s::DirectionalLight { l: s::UnitVec3::X, intensity: s::Rgb::gray(1.0) };
                let mixed: &[s::Light] = &[(*sun).into(), lamps[1].into(), spots[2].into(), lamps[3].into()];
                let ours = &material(50);

                let (points, by_hand) = &hand::scene(points, positions);
                let with_axis = |lamp: &Lamp| (*lamp, -lamp.position.normalize());
                let hand_spots: &Vec<_> = &by_hand.iter().map(with_axis).collect();
                let spot = |(lamp, axis)| Kind::Spot(lamp, axis);
                let lamp = |i: usize| Kind::Lamp(by_hand[i]);
                let kinds = &[Kind::Sun(V::X), lamp(1), spot(hand_spots[2]), lamp(3)];
                let theirs = &hand::material();

                macro_rules! form {
                    (
                        $name:literal * $lights:literal:
                        |$p:ident, $n:pat_param| $lit:expr; |$sum:ident| $added:expr
                    ) => {
                        let pair = [
                            pass::<false, _, _>(inputs, $lights, |&[n, v, p]| {
                                let ($p, $n, m) = (s::Vec3::from(p), unit(n), black_box(ours));
                                let i_a = s::Rgb::gray(0.2);
                                <[$float; 3]>::from(shade::blinn_phong(unit(n), unit(v), m, i_a, $lit).total())
                            }),
                            pass::<false, _, _>(points, $lights, |point| {
                                let m = black_box(50);
                                let highlight = |n, v, l, n_dot_l| hand::blinn(n, v, l, n_dot_l).powi(m);
                                let mut $sum = Point::new(point, black_box(theirs), highlight);
                                $added;
                                <[$float; 3]>::from($sum.sum)
                            }),
                        ];
                        let name = format!("{} `{}`, {data}", stringify!($float), $name);
                        races.row(&name, 0.95, [pair]);
                    };
                }
                form!("[lamp.at(p)]" * 1: |p, _| [lamps[0].at(p)]; |sum| sum.add(&by_hand[0], |_, _| 1.0));
                form!("[sun.at(p), lamp.at(p)]" * 2: |p, _| [sun.at(p), lamps[0].at(p)]; |sum| {
                    sum.add_sun(black_box(V::X));
                    sum.add(&by_hand[0], |_, _| 1.0);
                });
                form!("once(sun).chain(lamps)" * 5: |p, _|
                    once(sun.at(p)).chain(lamps.iter().map(|l| l.at(p))); |sum| {
                    sum.add_sun(black_box(V::X));
                    for lamp in by_hand { sum.add(lamp, |_, _| 1.0); }
                });
                form!("lamps.filter(not blocked)" * 4:
                    |p, _| lamps.iter().map(|l| l.at(p)).filter(|l| !blocked(p.z, l.l().z, l.distance())); |sum| {
                    let z = sum.p.z;
                    let fraction = |l: V, q| if blocked(z, l.z, q) { 0.0 } else { 1.0 };
                    for lamp in by_hand { sum.add(lamp, fraction); }
                });
                form!("lamps.filter(in front, not blocked)" * 4: |p, n|
                    lamps.iter().map(|l| l.at(p)).filter(|l| {
                        l.is_in_front(n) && !blocked(p.z, l.l().z, l.distance())
                    }); |sum| {
                    let z = sum.p.z;
                    let fraction = |l: V, q| if blocked(z, l.z, q) { 0.0 } else { 1.0 };
                    for lamp in by_hand { sum.add(lamp, fraction); }
                });
                form!("lights of mixed kinds" * 4: |p, _| mixed.iter().map(|l| l.at(p)); |sum| for kind in kinds {
                    match kind {
                        Kind::Sun(l) => sum.add_sun(*l),
                        Kind::Lamp(lamp) => sum.add(lamp, |_, _| 1.0),
                        Kind::Spot(lamp, axis) => sum.add(lamp, |l, _| hard(*axis, l)),
                    }
                });
                form!("spots" * 4: |p, _| spots.iter().map(|l| l.at(p)); |sum| for (lamp, axis) in hand_spots {
                    sum.add(lamp, |l, _| hard(*axis, l));
                });
                form!("spots, soft edges" * 4: |p, _| soft_spots.iter().map(|l| l.at(p)); |sum| {
                    for (lamp, axis) in hand_spots { sum.add(lamp, |l, _| soft(*axis, l)); }
                });
                form!("lamps with ranges" * 4: |p, _| ranged.iter().map(|l| l.at(p)); |sum| {
                    for lamp in by_hand { sum.add(lamp, |_, q| window(q)); }
                });
            }
        }
    };
}

forms!(f32, vec3);
forms!(f64, dvec3);
