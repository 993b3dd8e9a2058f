//! Constructors for constants have the bits of those that any number has.

use shading::Real;
use shading::fixed::{Attenuation, Cone, Fixed};

use crate::{Random, edges, steps};

fn numbers() -> impl Iterator<Item = Fixed> {
    let mut random = Random(9);
    let near_one = (-70_000..70_000).step_by(7).map(Fixed::from_bits);
    let slack = [-65536, 65536]
        .into_iter()
        .flat_map(|one| (-9..10).map(move |near| one + near));
    let slack = slack.map(Fixed::from_bits);
    edges()
        .into_iter()
        .chain(near_one)
        .chain(slack)
        .chain((0..1000).map(move |_| random.fixed()))
}

#[test]
fn attenuations_are_those_of_any_number() {
    let valid = Attenuation::const_new(Fixed::ONE, Fixed::ZERO, Fixed::ZERO).unwrap();
    for x in numbers() {
        for [a, b, c] in [
            [x, Fixed::ZERO, Fixed::ZERO],
            [Fixed::ZERO, x, Fixed::ONE],
            [x, x, Fixed::ZERO],
            [-x, x, x],
        ] {
            assert_eq!(Attenuation::const_new(a, b, c), Attenuation::new(a, b, c));
        }
        let gltf = valid.within_gltf(Fixed::ONE).unwrap();
        for falloff in [valid, gltf] {
            assert_eq!(falloff.const_within(x), falloff.within(x), "{x}");
        }
    }
}

#[test]
fn cones_of_cosines_are_those_in_order() {
    const ONE: i32 = 1 << 16;
    // one close to 1 is stored as 1 − 4ε, and a cone of every direction as below −1, which counts as −1
    let stored = |cosine: Fixed| cosine.to_bits().min(ONE - 4);
    for (inner, outer) in numbers().zip(numbers().skip(3)) {
        let [a, b] = [inner, outer].map(Fixed::to_bits);
        let cone = Cone::from_cosines(inner, outer);
        assert_eq!(
            cone.is_some(),
            ONE >= a && a >= b && b >= -ONE,
            "{inner} {outer}"
        );
        if let Some(cone) = cone {
            let expected = if a < 4 - ONE {
                [-ONE; 2]
            } else {
                [stored(inner), stored(outer)]
            };
            assert_eq!(
                cone.cosines().map(Fixed::to_bits),
                expected,
                "{inner} {outer}"
            );
        }
    }
}

/// The cosine of a constant is rounded once, and any other in fixed point.
#[test]
fn cones_of_angles_are_near_those_of_any_number() {
    let pi = Fixed::new(core::f64::consts::PI);
    for radians in (0..=pi.to_bits() + 1)
        .step_by(5)
        .map(Fixed::from_bits)
        .chain([pi, -Fixed::STEP])
    {
        let (constant, other) = (
            Cone::const_from_half_angle(radians),
            Cone::from_half_angle(radians),
        );
        assert_eq!(
            constant.is_some(),
            (Fixed::ZERO..=pi).contains(&radians),
            "{radians}"
        );
        assert_eq!(constant.is_some(), other.is_some(), "{radians}");
        if let (Some(constant), Some(other)) = (constant, other) {
            let error = steps(constant.cosines()[0]) - steps(other.cosines()[0]);
            // a cosine near 1 or −1 may be widened for one of them
            let is_near = steps(constant.cosines()[0]).abs() > 65530.0;
            let bound = if is_near { 4.0 } else { 2.0 };
            assert!(error.abs() <= bound, "{radians}: {error} steps");
        }
    }
    let [inner, outer] = [0.25, 0.5].map(Fixed::new);
    let soft = Cone::const_from_half_angles(inner, outer).expect("angles");
    assert_eq!(
        soft.cosines(),
        [0.25_f64, 0.5].map(|angle| Fixed::new(angle.cos()))
    );
    assert_eq!(Cone::const_from_half_angles(outer, inner), None);
}
