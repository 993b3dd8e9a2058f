//! Directions, lengths and cosines of vectors of any size.

use shading::Real;
use shading::fixed::{Fixed, UnitVec3, Vec3};

use crate::{Random, edges, exact, steps};

/// Vectors of any size, with components of the same and of different sizes, and of edges.
fn vectors() -> impl Iterator<Item = [Fixed; 3]> {
    let mut random = Random(6);
    let edges = edges();
    (0..300_000).map(move |i| {
        let [x, y, z] = random.three();
        match i % 3 {
            0 => [x, y, z],
            1 => [x, y, z].map(|c| Fixed::from_bits(c.to_bits() >> 12)),
            _ => {
                [(); 3].map(|()| edges[usize::try_from(random.bits() >> 40).unwrap() % edges.len()])
            }
        }
    })
}

/// A coordinate is rounded to half a step; what rounds before it adds 2⁻⁶ of a step.
#[test]
fn directions_and_lengths_are_near_the_exact_ones() {
    for v in vectors() {
        let wide = shading::f64::Vec3::from(v.map(exact));
        let Some(unit) = Vec3::from(v).unit() else {
            assert_eq!(v, [Fixed::ZERO; 3]);
            continue;
        };
        let error = *unit.cast(exact) - *wide.unit().expect("a length");
        let error = 65536.0 * error.x.abs().max(error.y.abs()).max(error.z.abs());
        assert!(error <= 0.52, "{v:?}: {error} steps");
        assert!(UnitVec3::new(unit.x, unit.y, unit.z).is_some(), "{v:?}");
        let [x, y, z] = v;
        assert_eq!(UnitVec3::const_new(x, y, z), UnitVec3::new(x, y, z));

        let length = 65536.0 * wide.length();
        let actual = Vec3::from(v).length();
        let bound = 0.5 + length / f64::from(1 << 24);
        let error = steps(actual) - length.min(steps(Fixed::MAX));
        assert!(error.abs() <= bound, "{v:?}: {error} steps");
    }
    assert_eq!(Vec3::ZERO.length(), Fixed::ZERO);
    assert_eq!(Vec3::ZERO.unit_or(UnitVec3::X), UnitVec3::X);
}

/// n is off by nothing, as both computations are given the same one.
#[test]
fn cosines_are_near_the_exact_ones() {
    let mut directions = vectors().filter_map(|v| Vec3::from(v).unit());
    let mut others = vectors().skip(1);
    while let (Some(n), Some(v)) = (directions.next(), others.next()) {
        let Some(wide) = shading::f64::Vec3::from(v.map(exact)).unit() else {
            continue;
        };
        let expected = n.cast(exact).dot(wide);
        let actual = Fixed::cosine(*n, &Fixed::toward(*n, v.into()));
        let error = steps(actual) - 65536.0 * expected.clamp(0.0, 1.0);
        assert!(error.abs() <= 0.52, "{n:?} {v:?}: {error} steps");
    }
}

/// The direction halfway is computed with 24 bits: beside the rounding of the result, that is 2⁻²²
/// of |h|⁻² at most.
#[test]
fn halfway_cosines_are_near_the_exact_ones() {
    let directions = || vectors().filter_map(|v| Vec3::from(v).unit());
    let (mut normals, mut others) = (directions(), directions().skip(1));
    let mut lights = directions().skip(2);
    while let (Some(n), Some(l), Some(v)) = (normals.next(), lights.next(), others.next()) {
        let measured = Fixed::measured(*l);
        let h = measured.w.map(exact) + *v.cast(exact);
        let Some(wide) = h.unit() else {
            assert_eq!(Fixed::halfway_power(*n, measured, *v, 1), Fixed::ZERO);
            continue;
        };
        let expected = n.cast(exact).dot(wide);
        let actual = Fixed::halfway_power(*n, measured, *v, 1);
        let error = steps(actual) - 65536.0 * expected.clamp(0.0, 1.0);
        let bound = 0.52 + 0.016 / h.dot(h).min(1.0);
        assert!(error.abs() <= bound, "{n:?} {l:?} {v:?}: {error} steps");
    }
}

/// A vector and its negative are as long, whatever the bits of a negative number are.
#[test]
fn lengths_do_not_depend_on_the_sign() {
    for v in vectors() {
        let length = Vec3::from(v).length();
        for signs in 1..8 {
            let signed = [0, 1, 2].map(|i| if signs >> i & 1 == 1 { -v[i] } else { v[i] });
            if v.iter().all(|x| *x > Fixed::MIN) {
                assert_eq!(Vec3::from(signed).length(), length, "{v:?} {signed:?}");
            }
        }
    }
}

/// No operation overflows, in a build that would panic, whatever the numbers are.
#[test]
fn anything_has_a_result() {
    let (mut n, mut others) = (vectors(), vectors().skip(2));
    while let (Some(n), Some(v)) = (n.next(), others.next()) {
        let _ = <Fixed as Real>::dot(n.into(), v.into());
        let measured = Fixed::measured(v.into());
        let power = Fixed::halfway_power(n.into(), measured, v.into(), 128);
        assert!(Fixed::ZERO <= power && power <= Fixed::ONE);
        let [a, b, c] = n;
        let [q, limit, color] = v;
        let _ = Fixed::attenuated(shading::Rgb::gray(color), [a, b, c], q, limit);
    }
}
