//! Cases with the edges in them: axes, opposites, the horizon, a light at the point, m = 0,
//! subnormal and huge sizes. What stands first in each is the simplest, to which proptest shrinks.

use std::f64::consts::TAU;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use shading::{Attenuation, Cone, Light, Material, PointLight, Rgb, UnitVec3, Vec3, reflection};

use crate::given::{Beam, Directions, Falloff, Frame, Numbers, Scene, Sizes, Triangle};
use crate::given::{coefficients, cone, down, lamp, spot, sun, unit, up};
use crate::simplest::simplest;

/// A factor: mostly 1, and otherwise of any size that the number has.
fn size(sizes: Sizes) -> impl Strategy<Value = f64> {
    let any = (sizes.least..sizes.most - 4).prop_map(|e| f64::exp2(e.into()));
    prop_oneof![4 => Just(1.0), 1 => any]
}

/// A number of few decimal digits, so that it prints short and shrinks to a whole one.
fn decimal(least: i32, most: i32) -> impl Strategy<Value = f64> + Clone {
    const DIGITS: i32 = 1_000_000;
    (least * DIGITS..=most * DIGITS).prop_map(|k| f64::from(k) / f64::from(DIGITS))
}

/// An axis, or a direction by two of its coordinates, so that none shrinks to zero.
fn direction() -> impl Strategy<Value = UnitVec3<f64>> + Clone {
    let simple = [
        UnitVec3::Z,
        UnitVec3::X,
        UnitVec3::Y,
        UnitVec3::NEG_Z,
        UnitVec3::NEG_X,
        UnitVec3::NEG_Y,
        unit(0.6, 0.0, 0.8),
        unit(0.6, 0.0, -0.8),
        unit(0.8, 0.0, 0.6),
        unit(0.0, 0.6, 0.8),
        unit(-0.6, 0.0, 0.8),
        unit(0.0, -0.8, 0.6),
        unit(0.6, 0.8, 0.0),
        unit(0.28, 0.0, 0.96),
        unit(0.48, 0.6, 0.64),
        unit(0.36, 0.48, 0.8),
        unit(-0.48, 0.64, -0.6),
    ];
    // of few digits, so that it prints short; the horizon is among the simple ones
    let any = (0.0..0.99999, 0.0..TAU, any::<bool>()).prop_map(|(square, azimuth, is_up)| {
        let (sine, cosine) = f64::sin_cos(azimuth);
        let digits = |x: f64| (x * f64::sqrt(square) * 1e6).round() / 1e6;
        let [x, y] = [cosine, sine].map(digits);
        if is_up { up(x, y) } else { down(x, y) }
    });
    simplest(simple, any)
}

/// Three directions. The second may lie on the horizon of the first; the third may be the second,
/// its opposite, or where it is reflected to.
fn three_directions() -> impl Strategy<Value = [UnitVec3<f64>; 3]> {
    let on_the_horizon = select(&[false, false, false, false, false, false, true][..]);
    let relation = select(&[0, 0, 0, 0, 0, 1, 2, 3][..]);
    let directions = [direction(), direction(), direction()];
    (directions, on_the_horizon, relation).prop_map(|([n, l, v], on_the_horizon, relation)| {
        let l = match Vec3::new(-n.y, n.x, 0.0).unit() {
            Some(horizontal) if on_the_horizon => horizontal,
            _ => l,
        };
        let v = match relation {
            1 => l,
            2 => -l,
            3 => reflection(n, l),
            _ => v,
        };
        [n, l, v]
    })
}

/// A number within [0, 1], often one that is simple.
fn fraction() -> impl Strategy<Value = f64> + Clone {
    simplest([0.0, 1.0, 0.5, 0.25, 0.75, 0.1], decimal(0, 1))
}

fn color() -> impl Strategy<Value = Rgb<f64>> + Clone {
    let simple = [[1.0; 3], [1.0, 0.0, 0.0], [0.0; 3], [2.0, 1.0, 0.5]].map(Rgb::from);
    simplest(
        simple,
        [decimal(0, 2), decimal(0, 2), decimal(0, 2)].prop_map(Rgb::from),
    )
}

fn shininess() -> impl Strategy<Value = u32> {
    select(&[1, 0, 2, 3, 8, 33, 100][..])
}

fn material() -> impl Strategy<Value = Material<f64>> {
    let all = (color(), color(), color(), shininess());
    all.prop_map(|(k_a, k_d, k_s, m)| Material { k_a, k_d, k_s, m })
}

/// A vector of few bits, whose sums and products every number has.
fn grid() -> impl Strategy<Value = Vec3<f64>> + Clone {
    [-8..=8, -8..=8, -8..=8].prop_map(|v| Vec3::from(v.map(|x| f64::from(x) / 4.0)))
}

/// A vector of few bits, or of any.
fn vector() -> impl Strategy<Value = Vec3<f64>> + Clone {
    let axes = [UnitVec3::Z, UnitVec3::X, UnitVec3::Y, UnitVec3::NEG_Z].map(|axis| *axis);
    let any = [decimal(-4, 4), decimal(-4, 4), decimal(-4, 4)].prop_map(Vec3::from);
    let simple = [&[Vec3::ZERO][..], &axes].concat();
    simplest(simple, prop_oneof![1 => grid(), 3 => any])
}

fn attenuation() -> impl Strategy<Value = Attenuation<f64>> {
    let simple = [
        Attenuation::NONE,
        coefficients(1.0, 0.0, 1.0),
        coefficients(0.0, 0.0, 1.0),
    ];
    let any =
        (fraction(), fraction(), fraction()).prop_map(|(a, b, c)| coefficients(a + 0.125, b, c));
    simplest(simple, any)
}

fn any_cone() -> impl Strategy<Value = Cone<f64>> {
    (fraction(), fraction(), any::<bool>()).prop_map(|(inner, width, is_smooth)| {
        let inner = 0.875 * inner;
        let cone = cone(inner, inner - 0.875 * width);
        if is_smooth { cone.smoothstep() } else { cone }
    })
}

fn any_lamp() -> impl Strategy<Value = PointLight<f64>> {
    let range = select(&[None, Some(1.0), Some(5.0)][..]);
    (vector(), color(), attenuation(), range).prop_map(|(position, intensity, falloff, range)| {
        let ranged = range.map(|r| falloff.within(r).expect("a range"));
        lamp(position, intensity, ranged.unwrap_or(falloff))
    })
}

/// A light at some place seen from the point.
fn light() -> impl Strategy<Value = Light<f64>> {
    let simple = [
        sun(UnitVec3::Z, Rgb::WHITE),
        sun(unit(0.6, 0.0, 0.8), Rgb::WHITE),
        lamp(*UnitVec3::Z, Rgb::WHITE, Attenuation::NONE).into(),
        lamp(*UnitVec3::Z * 2.0, Rgb::WHITE, coefficients(0.0, 0.0, 1.0)).into(),
    ];
    let suns = (direction(), color()).prop_map(|(l, color)| sun(l, color));
    let spots = (any_lamp(), direction(), any_cone());
    let spots = spots.prop_map(|(lamp, axis, cone)| spot(lamp, axis, cone));
    let any = prop_oneof![2 => suns, 2 => any_lamp().prop_map(Light::from), 2 => spots];
    simplest(simple, any)
}

/// At most four lights. Of twenty lamps, one is at the point. The eye may be where a sun is,
/// opposite, or reflected.
pub fn scenes(sizes: Sizes) -> BoxedStrategy<Scene> {
    let is_here = prop_oneof![19 => Just(false), 1 => Just(true)];
    let lights = vec((light(), is_here), 0..=4);
    let ambient = simplest([Rgb::BLACK], color());
    let surface = (
        three_directions(),
        vector(),
        size(sizes),
        material(),
        ambient,
    );
    let scene =
        |((directions, p, size, material, ambient), lights, sun_is_at_l): (_, Vec<_>, _)| {
            let ([n, l, v], p): ([UnitVec3<f64>; 3], Vec3<f64>) = (directions, p * size);
            let place = |from: Vec3<f64>, is_here| if is_here { p } else { p + from * size };
            let put = |(mut light, is_here): (Light<f64>, bool)| {
                match &mut light {
                    Light::Directional(sun) if sun_is_at_l => sun.l = l,
                    Light::Directional(_) => {}
                    Light::Point(lamp) => lamp.position = place(lamp.position, is_here),
                    Light::Spot(spot) => spot.point.position = place(spot.point.position, is_here),
                }
                light
            };
            Scene {
                n,
                v,
                p,
                material,
                ambient,
                lights: lights.into_iter().map(put).collect(),
            }
        };
    (surface, lights, any::<bool>()).prop_map(scene).boxed()
}

pub fn directions(_: Sizes) -> BoxedStrategy<Directions> {
    let directions = |([n, l, v], m): ([_; 3], _)| Directions { n, l, v, m };
    (three_directions(), shininess())
        .prop_map(directions)
        .boxed()
}

pub fn triangles(sizes: Sizes) -> BoxedStrategy<Triangle> {
    let points = [vector(), vector(), vector()];
    let grid = [grid(), grid(), grid(), grid(), grid(), grid()];
    let triangle = |(points, grid, size): ([Vec3<f64>; 3], _, f64)| {
        let [a, b, c] = points.map(|p| p * size);
        let [d, e, f, offset, s, t]: [Vec3<f64>; 6] = grid;
        Triangle {
            a,
            b,
            c,
            corners: [d, e, f],
            offset,
            map: [[s.x, t.x], [s.y, t.y], [s.z, t.z]],
        }
    };
    (points, grid, size(sizes)).prop_map(triangle).boxed()
}

pub fn frames(_: Sizes) -> BoxedStrategy<Frame> {
    let axes = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(|axis| *axis);
    let columns = simplest([axes], [grid(), grid(), grid()]);
    let tangent = simplest([*UnitVec3::X], vector());
    let frame = |(n, v, tangent, sample, columns)| Frame {
        n,
        v,
        tangent,
        sample,
        columns,
    };
    (direction(), direction(), tangent, vector(), columns)
        .prop_map(frame)
        .boxed()
}

/// A falloff and a distance at which its factor is nearly 1, where two ways to compute it may meet. The
/// numbers are long, and of those that the number has.
fn near_1(sizes: Sizes) -> impl Strategy<Value = (Attenuation<f64>, f64)> {
    let step = f64::exp2(sizes.least.max(-24).into());
    let rounded = move |x: f64| {
        if sizes.least == -16 {
            (x / step).round() * step
        } else {
            x
        }
    };
    let shares = (0.0..1.0_f64, 0.0..1.0_f64);
    (1.0..2.0_f64, -4..9_i32, shares, -3..=3_i32).prop_map(
        move |(q, exponent, (of_q, of_b), steps)| {
            let q = rounded(q * f64::exp2(exponent.into()));
            let b = rounded(of_q * of_b / q);
            let c = rounded(of_q * (1.0 - of_b) / (q * q));
            let a = 1.0 - q * (b + c * q) + f64::from(steps) * step;
            (coefficients(a.max(step), b, c), q)
        },
    )
}

pub fn falloffs(sizes: Sizes) -> BoxedStrategy<Falloff> {
    let fractions = [fraction(), fraction(), fraction()];
    let falloff = |(falloff, [r, q, further], size): (_, [f64; 3], f64)| Falloff {
        falloff,
        r: 4.0 * r + 0.5,
        q: 8.0 * q * size,
        further: further * size,
    };
    let any = (attenuation(), fractions, size(sizes)).prop_map(falloff);
    let near_1 = (near_1(sizes), fraction(), fraction()).prop_map(
        |((falloff, q), r, further): ((_, f64), f64, f64)| {
            let r = 4.0 * r * q + 0.5;
            Falloff {
                falloff,
                r,
                q,
                further,
            }
        },
    );
    prop_oneof![1 => any, 1 => near_1].boxed()
}

pub fn beams(_: Sizes) -> BoxedStrategy<Beam> {
    let beam = |(cone, [axis, l, other]): (_, [_; 3])| Beam {
        cone,
        axis,
        l,
        other,
    };
    (any_cone(), three_directions()).prop_map(beam).boxed()
}

pub fn numbers(sizes: Sizes) -> BoxedStrategy<Numbers> {
    let signed = simplest([0.0, 1.0, -1.0, 0.5], decimal(-1, 1));
    let numbers = |(x, y, z, size, m): (_, _, f64, _, _)| Numbers {
        x,
        y,
        z: z * size,
        m,
    };
    (fraction(), fraction(), signed, size(sizes), shininess())
        .prop_map(numbers)
        .boxed()
}
