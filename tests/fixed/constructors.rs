//! Constructors for constants have the bits of those that any number has.

use shading::Real;
use shading::fixed::{Attenuation, Cone, Fixed};

use crate::{Random, edges, exact, steps};

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

/// Every angle within [0, π], and some outside: a constant has the bits of any other cone, and its cosine
/// is within half a step and the 2⁻¹³ of a step that the series may add, unless it is widened because it is
/// near 1 or −1.
#[test]
fn cones_of_every_angle_are_those_of_any_number() {
    let pi = Fixed::new(core::f64::consts::PI);
    let outside = [
        -Fixed::STEP,
        Fixed::MIN,
        pi + Fixed::STEP,
        pi + pi,
        Fixed::MAX,
    ];
    for radians in outside {
        assert_eq!(Cone::const_from_half_angle(radians), None, "{radians}");
        assert_eq!(Cone::from_half_angle(radians), None, "{radians}");
    }
    let mut worst = 0.0_f64;
    for radians in (0..=pi.to_bits()).map(Fixed::from_bits) {
        let constant = Cone::const_from_half_angle(radians).expect("an angle");
        assert_eq!(Some(constant), Cone::from_half_angle(radians), "{radians}");
        let exactly = 65_536.0 * exact(radians).cos();
        if exactly.abs() < 65_531.0 {
            worst = worst.max((steps(constant.cosines()[0]) - exactly).abs());
        }
    }
    println!("{worst:.4} steps");
    assert!(worst <= 0.5 + 1.0 / 8192.0, "{worst} steps");
    let mut random = Random(10);
    for _ in 0..100_000 {
        let [inner, outer] = [random.fixed(), random.fixed()];
        let constant = Cone::const_from_half_angles(inner, outer);
        assert_eq!(
            constant,
            Cone::from_half_angles(inner, outer),
            "{inner} {outer}"
        );
    }
    let [inner, outer] = [0.25, 0.5].map(Fixed::new);
    let soft = Cone::const_from_half_angles(inner, outer).expect("angles");
    assert_eq!(
        soft.cosines(),
        [0.25_f64, 0.5].map(|angle| Fixed::new(angle.cos()))
    );
    assert_eq!(Cone::const_from_half_angles(outer, inner), None);
}
