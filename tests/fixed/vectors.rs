//! Vectors, directions and lamps.

use shading::fixed::{Attenuation, Dual, Fixed, PointLight, Rgb, UnitVec3, Vec3};
use shading::{Real, normal};

use crate::{Random, assert_documented, edges, exact, steps};

fn vector(mut component: impl FnMut() -> Fixed) -> Vec3 {
    Vec3::new(component(), component(), component())
}

/// Vectors from one step to the ends of the range: every vector of a few steps, vectors of edges,
/// and vectors whose components are of any magnitude, each of its own or all of one.
fn vectors() -> impl Iterator<Item = Vec3> {
    let few = (0..17 * 17 * 17).map(|i| {
        Vec3::from([i % 17, i / 17 % 17, i / 289].map(|steps| Fixed::from_bits(steps - 8)))
    });
    let (mut random, edges) = (Random(6), edges());
    let some = (0..1_000_000).map(move |i| match i % 3 {
        0 => vector(|| edges[random.below(edges.len())]),
        1 => vector(|| random.fixed()),
        _ => {
            let shift = random.below(32);
            #[allow(clippy::cast_possible_truncation)] // any bits will do
            vector(|| Fixed::from_bits(random.bits() as i32 >> shift))
        }
    });
    few.chain(some)
}

#[test]
fn dot_products_are_rounded_once() {
    let mut others = vectors().collect::<Vec<_>>();
    others.rotate_left(3); // of the same kind
    let ends = [Fixed::MIN, Fixed::MAX, Fixed::ZERO, Fixed::STEP];
    let of_ends = (0..4096_usize).map(|i| {
        let end = |k: usize| ends[i >> (2 * k) & 3];
        (
            Vec3::new(end(0), end(1), end(2)),
            Vec3::new(end(3), end(4), end(5)),
        )
    });
    for (a, b) in vectors().zip(others).chain(of_ends) {
        let product = |a: Fixed, b: Fixed| i128::from(a.to_bits()) * i128::from(b.to_bits());
        let sum = product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z);
        let steps = (sum + 0x8000).div_euclid(0x1_0000);
        let steps = steps.clamp(i32::MIN.into(), i32::MAX.into());
        assert_eq!(i128::from(a.dot(b).to_bits()), steps, "{a:?} · {b:?}");
    }
}

#[test]
fn a_factor_multiplies_each_component() {
    let mut random = Random(7);
    for v in vectors() {
        let factor = random.fixed();
        let expected = [v.x * factor, v.y * factor, v.z * factor];
        assert_eq!(v * factor, Vec3::from(expected), "{v:?} × {factor}");
        assert_eq!(factor * v, Vec3::from(expected));
        let color = Rgb::new(v.x, v.y, v.z);
        assert_eq!(color * factor, Rgb::from(expected));
        assert_eq!(factor * color, Rgb::from(expected));
        let quotient = [v.x / factor, v.y / factor, v.z / factor];
        assert_eq!(v / factor, Vec3::from(quotient));
    }
}

/// The components are shifted up until one takes 30 or 31 bits. The reciprocal of the length is off by
/// less than 2⁻²⁵, and so a component by less than half a step and 0.01. The length is cut off to
/// units of 32 shifted steps, which is less than 2⁻²⁴ of it.
#[test]
fn directions_and_lengths_are_within_their_bounds() {
    let (mut largest, mut longest) = (0.0_f64, 0.0_f64);
    for v in vectors().filter(|v| *v != Vec3::ZERO) {
        let [x, y, z] = [v.x, v.y, v.z].map(steps);
        let length = (x * x + y * y + z * z).sqrt();

        let unit = v.unit().expect("a direction");
        for (component, part) in [(unit.x, x), (unit.y, y), (unit.z, z)] {
            let error = (steps(component) - part / length * 65536.0).abs();
            assert!(error <= 0.505, "the unit of {v:?} is off by {error} steps");
            largest = largest.max(error);
        }
        assert_eq!(v.unit_or(UnitVec3::X), unit);
        assert_eq!(UnitVec3::normalized(v.x, v.y, v.z), Some(unit));

        let expected = length.min(steps(Fixed::MAX));
        let error = (steps(v.length()) - expected).abs();
        let excess = (error - 0.5).max(0.0) / expected * f64::from(1 << 23);
        assert!(excess <= 1.0, "|{v:?}| is off by {error} steps");
        longest = longest.max(excess);
    }
    assert_documented("a direction", largest, 0.505, "steps");
    let unit = "2⁻²³ of the length, and half a step";
    assert_documented("a length", longest, 1.0, unit);
}

/// The denominator is the distance that the light reports. Before its reciprocal is computed, the
/// denominator is rounded to 19 bits or more, and after it, a unit of 2⁻³² is cut off. From 2¹⁴ on, the
/// light may be the largest number.
#[test]
fn lamps_divide_their_light_by_the_denominator() {
    let mut random = Random(8);
    for _ in 0..300_000 {
        let [q, r, g, b] = std::array::from_fn(|_| Real::abs(random.fixed()));
        let q = q.at_least(Fixed::STEP);
        let lamp = PointLight {
            position: Vec3::new(Fixed::ZERO, q, Fixed::ZERO),
            intensity: Rgb::new(r, g, b),
            attenuation: Attenuation::new(Fixed::ZERO, Fixed::ONE, Fixed::ZERO).expect("valid"),
        };
        let arriving = lamp.at(Vec3::ZERO);
        let q = steps(arriving.distance);
        for (intensity, arriving) in [
            (r, arriving.intensity.r),
            (g, arriving.intensity.g),
            (b, arriving.intensity.b),
        ] {
            let expected = (steps(intensity) / q * 65536.0).min(steps(Fixed::MAX));
            let error = (steps(arriving) - expected).abs();
            let bound = 0.5 + expected / f64::from(1 << 18) + steps(intensity) / 2_f64.powi(32);
            let is_near_the_end = expected >= f64::from(1 << 30) && arriving == Fixed::MAX;
            assert!(
                error <= bound || is_near_the_end,
                "{intensity}/{} is off by {error} steps",
                q / 65536.0
            );
        }
    }
}

/// ∇(x³ + yz) is (3x², z, y). The slope 2x·x and the value x² are rounded to half a step each, so the
/// gradient is off by one step, and the direction by as much over |∇f|.
#[test]
fn normals_of_a_polynomial_agree_with_double_precision() {
    let mut random = Random(9);
    for _ in 0..100_000 {
        let p = vector(|| Fixed::new(random.within(-100.0, 100.0)));
        let f = |p: shading::Vec3<Dual>| p.x * p.x * p.x + p.y * p.z;
        let n = normal::implicit(f, p).expect("a normal");

        let [x, y, z] = [p.x, p.y, p.z].map(exact);
        let gradient = [3.0 * x * x, z, y];
        let length = gradient.iter().map(|c| c * c).sum::<f64>().sqrt();
        let bound = 0.51 + 1.0 / length;
        for (component, slope) in [n.x, n.y, n.z].into_iter().zip(gradient) {
            let error = (steps(component) - slope / length * 65536.0).abs();
            assert!(
                error <= bound,
                "the normal at {p:?} is off by {error} steps"
            );
        }
    }
}
