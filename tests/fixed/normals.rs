//! Normals of triangles, tangents and spheres of every size, beside exact integers.

use shading::fixed::{Fixed, Vec3};
use shading::{Real, UnitVec3, normal};

use crate::{Random, exact};

/// A triangle of any size, short or long, thick or thin, near the origin or far from it.
#[allow(clippy::cast_possible_truncation)] // any bits will do
fn triangle(random: &mut Random) -> [[Fixed; 3]; 3] {
    match random.below(8) {
        0 => return [random.three(), random.three(), random.three()],
        // edges that leave the range in several coordinates at once
        1 => return [(); 3].map(|()| [(); 3].map(|()| Fixed::from_bits(random.bits() as i32))),
        _ => {}
    }
    let size = random.below(31);
    let mut vector = |shift: usize| [(); 3].map(|()| random.fixed().to_bits() >> shift);
    let (origin, a, mut b) = (vector(0), vector(size), vector(size));
    match random.below(3) {
        // an edge that is almost a multiple of the other
        0 => {
            let factor = i32::try_from(random.below(4)).unwrap() - 2;
            b = core::array::from_fn(|i| {
                let off = i32::try_from(random.below(3)).unwrap() - 1;
                a[i].wrapping_mul(factor).wrapping_add(off)
            });
        }
        1 => b = b.map(|x| x >> random.below(31)),
        _ => {}
    }
    let corner = |edge: [i32; 3]| core::array::from_fn(|i| origin[i].saturating_add(edge[i]));
    [origin, corner(a), corner(b)].map(|v| v.map(Fixed::from_bits))
}

fn edge(from: [Fixed; 3], to: [Fixed; 3]) -> [i128; 3] {
    core::array::from_fn(|i| i128::from(to[i].to_bits()) - i128::from(from[i].to_bits()))
}

fn cross([a, b, c]: [i128; 3], [x, y, z]: [i128; 3]) -> [i128; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

#[allow(clippy::cast_precision_loss)] // a rounding of 2⁻⁵³
fn length(v: [i128; 3]) -> f64 {
    v.iter().map(|&x| (x as f64).powi(2)).sum::<f64>().sqrt()
}

/// The largest error of a coordinate, in steps.
#[allow(clippy::cast_precision_loss)]
fn error(is: shading::fixed::UnitVec3, should: [i128; 3]) -> f64 {
    let length = length(should);
    let off = |is: Fixed, should: i128| 65_536.0 * (exact(is) - should as f64 / length).abs();
    let [x, y, z] = should;
    off(is.x, x).max(off(is.y, y)).max(off(is.z, z))
}

/// Half a step, 2⁻⁶ of one from the root, and what 21 bits round before it: each component by d, half
/// of a 2²⁰th of the largest, which is d(1 + √3)/2 across the vector at most, 0.043 of a step. An
/// edge that does not fit 32 bits is halved, which may turn it by 2⁻³¹.
#[test]
fn the_normal_of_a_triangle_of_any_size_is_near_the_exact_one() {
    let mut random = Random(14);
    let (mut degenerate, mut halved) = (0, 0);
    for _ in 0..300_000 {
        let [a, b, c] = triangle(&mut random);
        let (e1, e2) = (edge(a, b), edge(a, c));
        let should = cross(e1, e2);
        let is_halved = [e1, e2]
            .iter()
            .flatten()
            .any(|&x| i32::try_from(x).is_err());
        halved += i32::from(is_halved);
        let is = normal::triangle(a.into(), b.into(), c.into());
        if should == [0; 3] {
            degenerate += 1;
            assert!(is.is_none() || is_halved, "{a:?} {b:?} {c:?}");
            continue;
        }
        let conditioning = length(e1) * length(e2) / length(should);
        let turned = if is_halved {
            65_536.0 * conditioning * 4.0 * 0.5_f64.powi(31)
        } else {
            0.0
        };
        if turned > 1.0 {
            continue; // a few thin triangles of which an edge is longer than 32,768
        }
        let is = is.unwrap_or_else(|| panic!("{a:?} {b:?} {c:?} has a normal"));
        let error = error(is, should);
        assert!(error <= 0.56 + turned, "{a:?} {b:?} {c:?}: {error} steps");
    }
    assert!(degenerate > 1000 && halved > 100, "{degenerate}, {halved}");
}

/// The edges (2³⁰, 2³⁰ − 1, 0) and (2³⁰ + 1, 2³⁰, 0), in steps, have the cross product (0, 0, 1).
#[test]
fn the_least_cross_product_has_a_direction() {
    let corner = |x, y| Vec3::from([x, y, 0].map(Fixed::from_bits));
    let (b, c) = (
        corner(1 << 30, (1 << 30) - 1),
        corner((1 << 30) + 1, 1 << 30),
    );
    assert_eq!(normal::triangle(Vec3::ZERO, b, c), Some(UnitVec3::Z));
    assert_eq!(normal::triangle(Vec3::ZERO, c, b), Some(UnitVec3::NEG_Z));
}

#[test]
fn tangents_of_any_size_have_the_exact_normal() {
    let mut random = Random(15);
    for _ in 0..100_000 {
        let [s_u, s_v] = [random.three(), random.three()];
        let should = cross(edge([Fixed::ZERO; 3], s_u), edge([Fixed::ZERO; 3], s_v));
        let is = normal::from_tangents(Vec3::from(s_u), Vec3::from(s_v));
        assert_eq!(is.is_none(), should == [0; 3], "{s_u:?} {s_v:?}");
        if let Some(is) = is {
            let error = error(is, should);
            assert!(error <= 0.56, "{s_u:?} {s_v:?}: {error} steps");
        }
    }
}

#[test]
fn the_normal_of_a_sphere_of_any_size_is_near_the_exact_one() {
    let mut random = Random(16);
    for _ in 0..100_000 {
        let [center, p] = [random.three(), random.three()];
        let should = edge(center, p);
        let is = normal::sphere(center.into(), p.into());
        assert_eq!(is.is_none(), should == [0; 3], "{center:?} {p:?}");
        if let Some(is) = is {
            let error = error(is, should);
            assert!(error <= 0.56, "{center:?} {p:?}: {error} steps");
        }
    }
}

/// The sides of a right angle are 90° apart, however long they are.
#[test]
fn a_corner_of_any_size_has_its_angle() {
    for size in (1..32_000).step_by(7).chain(1..400) {
        let size = Fixed::from_bits(size * 65_536 / 100);
        let [x, y] = [*UnitVec3::X * size, *UnitVec3::Y * size];
        let right = normal::corner(Vec3::ZERO, x, y);
        assert_eq!(
            right,
            *UnitVec3::Z * Fixed::new(core::f64::consts::FRAC_PI_2),
            "{size:?}"
        );
        let half = normal::corner(Vec3::ZERO, x, x + y).z;
        let error = exact(half) - core::f64::consts::FRAC_PI_4;
        assert!(error.abs() <= 2.0 / 65_536.0, "{size:?}: {half:?}");
    }
}
