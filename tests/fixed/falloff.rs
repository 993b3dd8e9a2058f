//! What distance leaves of a light.

use shading::fixed::{Attenuation, Fixed, PointLight, Rgb, Vec3};
use shading::{Real, attenuation};

use crate::{Random, exact, steps};

fn x(literal: f64) -> Fixed {
    Fixed::new(literal)
}

/// A number from `low` to `high`, as often between 1 and 2 as between 2 and 4.
fn of_any_size(random: &mut Random, low: f64, high: f64) -> Fixed {
    x(low * (high / low).powf(random.fraction()))
}

/// Where the denominator d is above 1, it is off by 1 + q/2 steps; elsewhere and beyond the range the
/// quotient is computed from all digits. The reciprocal is off by 2⁻²¹ of itself and 2⁻³¹, and a product
/// with the color by less than a step.
fn assert_near_the_exact_one(color: Fixed, [a, b, c]: [Fixed; 3], q: Fixed) {
    let [wide_a, wide_b, wide_c, wide_q] = [a, b, c, q].map(exact);
    let d = wide_a + wide_q * (wide_b + wide_c * wide_q);
    if d == 0.0 {
        return;
    }
    let expected = exact(color) / d;
    let attenuated = |limit| {
        let dimmed = Fixed::attenuated(Rgb::gray(color), [a, b, c], q, limit);
        dimmed.color.r * dimmed.factor
    };
    let actual = attenuated(Fixed::MAX);
    let error = steps(actual) - (65536.0 * expected).min(steps(Fixed::MAX));
    let of_denominator = if d > 0.999 {
        expected / d * (1.0 + wide_q / 2.0)
    } else {
        0.0
    };
    let bound =
        1.0 + exact(color) / 32_768.0 + of_denominator + 65536.0 * expected / f64::from(1 << 21);
    assert!(
        error.abs() <= bound,
        "{color} at {q} of {a}, {b}, {c}: {error} steps of {bound}"
    );
    let error = (attenuated(Fixed::ONE) - actual.at_most(color))
        .to_bits()
        .abs();
    assert!(error <= 1 + color.to_bits() / 65536);
}

#[test]
fn attenuated_colors_are_near_the_exact_ones() {
    let mut random = Random(7);
    for _ in 0..300_000 {
        let mut coefficient = |share| {
            let some = of_any_size(&mut random, 1e-4, 100.0);
            if random.fraction() < share {
                Fixed::ZERO
            } else {
                some
            }
        };
        let coefficients = [coefficient(0.5), coefficient(0.5), coefficient(0.1)];
        let q = of_any_size(&mut random, 0.01, 200.0);
        let color = of_any_size(&mut random, 1e-4, 30_000.0);
        assert_near_the_exact_one(color, coefficients, q);
    }
}

/// The slope b + cq and the denominator leave the range at once.
#[test]
fn steep_falloff_is_near_the_exact_one() {
    let mut random = Random(18);
    for _ in 0..30_000 {
        let c = of_any_size(&mut random, 1000.0, 32_000.0);
        let q = of_any_size(&mut random, 0.5, 200.0);
        assert_near_the_exact_one(x(32_000.0), [Fixed::ZERO, Fixed::ZERO, c], q);
    }
}

/// A step from the lamp, 1 − (q/r)⁴ is 1 to the last digit, even where the reciprocal of r² is rounded up.
#[test]
fn a_range_takes_nothing_from_a_near_light() {
    for range in (65_536..i32::MAX).step_by(100_003).map(Fixed::from_bits) {
        let ranged = Attenuation::NONE.within(range).unwrap();
        for attenuation in [ranged, Attenuation::NONE.within_gltf(range).unwrap()] {
            let lamp = PointLight {
                position: Vec3::new(Fixed::STEP, x(0.0), x(0.0)),
                intensity: Rgb::WHITE,
                attenuation,
            };
            assert_eq!(lamp.at(Vec3::ZERO).intensity(), Rgb::WHITE, "{range}");
        }
    }
}

#[test]
fn falloff_ends_where_the_formula_has_no_answer() {
    let [zero, one] = [Fixed::ZERO, Fixed::ONE];
    assert_eq!(attenuation(one, zero, zero, Fixed::MAX), one);
    assert_eq!(attenuation(zero, zero, one, zero), Fixed::MAX);
    assert_eq!(attenuation(zero, zero, one, Fixed::MAX), zero);
    assert_eq!(attenuation(-one, zero, zero, one), zero);
    let lamp = PointLight {
        position: Vec3::splat(x(3.0)),
        intensity: Rgb::WHITE,
        attenuation: Attenuation::new(zero, zero, one).unwrap(),
    };
    assert_eq!(lamp.at(lamp.position).intensity(), Rgb::BLACK);
    let beyond = PointLight {
        position: Vec3::splat(Fixed::MAX),
        ..lamp
    };
    let light = beyond.at(Vec3::splat(Fixed::MIN));
    assert_eq!(
        (light.distance(), light.intensity()),
        (Fixed::MAX, Rgb::BLACK)
    );
}

/// A coefficient that a cast rounds to 0 would make the light infinite everywhere or, with all of them 0, the
/// attenuation invalid.
#[test]
fn cast_keeps_an_attenuation_valid() {
    let faint = shading::f64::Attenuation::new(0.0, 0.0, 7e-6).unwrap();
    let cast = faint.cast(Fixed::new);
    let least = Fixed::from_bits(1);
    assert_eq!(cast.coefficients(), [x(0.0), x(0.0), least]);
    let near = shading::f64::Attenuation::new(0.0, 0.0, 0.25)
        .unwrap()
        .within_gltf(8.0)
        .unwrap();
    let near = near.clamped().cast(Fixed::new);
    assert_eq!(near.coefficients(), [x(0.0), x(0.0), x(0.25)]);
    assert_eq!(
        (near.range(), near.limit(), near.is_gltf()),
        (Some(x(8.0)), Some(x(1.0)), true)
    );
    let endless = faint.cast(Fixed::new);
    assert_eq!((endless.range(), endless.limit()), (None, None));
}

/// Sweeps the hundred distances from many on: no light is brighter than a nearer one by more than a level.
#[test]
fn light_is_not_brighter_with_distance_by_more_than_a_level() {
    let level = |light: Fixed| i32::from(Rgb::gray(light).to_srgb8()[0]);
    let mut random = Random(8);
    for i in 0..6000 {
        let [a, b, c] = [(); 3].map(|()| of_any_size(&mut random, 1e-4, 2.0));
        let [a, b] = [[a, b], [x(0.0), x(0.0)], [x(1.0), x(0.0)]][i % 3];
        let some = Attenuation::new(a, b, c).unwrap();
        let q = of_any_size(&mut random, 0.01, 200.0);
        let intensity = Rgb::gray(x(random.fraction() / some.cast(exact).at(exact(q))));
        let range = q + of_any_size(&mut random, 0.001, 100.0);
        for attenuation in [some, some.within(range).unwrap()] {
            let mut darkest = Fixed::MAX;
            for bits in (q.to_bits()..).take(100) {
                let position = Vec3::new(Fixed::from_bits(bits), x(0.0), x(0.0));
                let lamp = PointLight {
                    position,
                    intensity,
                    attenuation,
                };
                let here = lamp.at(Vec3::ZERO).intensity().r;
                assert!(
                    level(here) - level(darkest) <= 1,
                    "{attenuation:?} at {bits} steps"
                );
                darkest = darkest.min(here);
            }
        }
    }
}

/// Where a range or a soft edge ends, a factor near 0 meets a light that is still large.
#[test]
fn faint_ends_of_bright_lights_are_within_a_level() {
    use shading::fixed::{Cone, IncidentLight, SpotLight, UnitVec3};
    use shading::{Material, shade};

    let levels = |light: f64| {
        255.0
            * if light <= 0.003_130_8 {
                12.92 * light
            } else {
                1.055 * light.min(1.0).powf(1.0 / 2.4) - 0.055
            }
    };
    let white = Material {
        k_a: Rgb::BLACK,
        k_d: Rgb::WHITE,
        k_s: Rgb::BLACK,
        m: 1,
    };
    let error = |light: IncidentLight, exactly: shading::f64::IncidentLight| {
        let n = UnitVec3::Z;
        let fixed = shade::lambert(n, &white, Rgb::BLACK, [light]).diffuse.r;
        let white = white.cast(exact);
        let double = shade::lambert(n.cast(exact), &white, shading::Rgb::BLACK, [exactly]);
        (levels(exact(fixed)) - levels(double.diffuse.r)).abs()
    };
    let mut worst = 0.0_f64;
    for intensity in [64, 256, 1024, 4096] {
        let mut point = PointLight {
            position: Vec3::new(x(0.0), x(0.0), x(2.0)),
            intensity: Rgb::gray(Fixed::from(intensity)),
            attenuation: Attenuation::NONE,
        };
        // every step along the last quarter of the radius, where the light ends at 1.5 and at cosines of 0.75
        for p in (70_000..120_000).map(|steps| Vec3::new(Fixed::from_bits(steps), x(0.0), x(0.0))) {
            let ranged = Attenuation::NONE.within(x(2.5)).unwrap();
            for attenuation in [ranged, Attenuation::NONE.within_gltf(x(2.5)).unwrap()] {
                point.attenuation = attenuation;
                let wide = point.cast(exact).at(p.map(exact));
                worst = worst.max(error(point.at(p), wide));
            }
            point.attenuation = Attenuation::NONE;
            let cone = Cone::from_cosines(x(0.9), x(0.75)).unwrap();
            for cone in [cone, cone.smoothstep()] {
                let axis = UnitVec3::NEG_Z;
                let spot = SpotLight { point, axis, cone };
                let wide = spot.cast(exact).at(p.map(exact));
                worst = worst.max(error(spot.at(p), wide));
            }
        }
    }
    println!("{worst:.3} levels");
    assert!(worst <= 1.0, "{worst} levels");
}

/// min(1, 1/d) is 1/d for d above the largest number, too.
#[test]
fn a_limit_of_1_leaves_darker_light_alone() {
    let [a, b, c] = [x(0.0), x(0.0), x(30.0)];
    let lamp = Attenuation::new(a, b, c).unwrap();
    let point = |attenuation| PointLight {
        position: Vec3::new(x(40.0), x(0.0), x(0.0)),
        intensity: Rgb::gray(x(1000.0)),
        attenuation,
    };
    let light = point(lamp).at(Vec3::ZERO).intensity();
    assert_eq!(point(lamp.clamped()).at(Vec3::ZERO).intensity(), light);
    assert!((exact(light.r) - 1000.0 / 48_000.0).abs() < 1.0 / 65536.0);
}
