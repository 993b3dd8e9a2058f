//! The constructors that check, and scenes in constants.

use shading::fixed::{
    Attenuation, Cone, DirectionalLight, Fixed, Light, Material, PointLight, Ranged, Rgb, SoftCone,
    SpotLight, UnitVec3, Vec3,
};
use shading::{Real, shade};

use crate::{Random, edges, exact, steps};

const fn x(literal: f64) -> Fixed {
    Fixed::new(literal)
}

const LAMP: PointLight = PointLight {
    position: Vec3::new(x(0.0), x(0.0), x(2.0)),
    intensity: Rgb::gray(x(1.0)),
    attenuation: Attenuation::new(x(1.0), x(0.0), x(0.25)).unwrap(),
};

static LIGHTS: [Light; 3] = [
    Light::Directional(DirectionalLight {
        l: UnitVec3::new(x(0.6), x(0.0), x(0.8)).unwrap(),
        intensity: Rgb::gray(x(0.5)),
    }),
    Light::Point(LAMP),
    Light::Spot(SpotLight {
        point: LAMP,
        axis: UnitVec3::normalized(x(0.0), x(3.0), x(-4.0)).unwrap(),
        cone: Cone::from_half_angle(x(0.5)).unwrap(),
    }),
];

static SOFT: SpotLight<SoftCone> = SpotLight {
    point: LAMP,
    axis: UnitVec3::NEG_Z,
    cone: SoftCone::from_half_angles(x(0.25), x(0.5)).unwrap(),
};

static CLAY: Material = Material {
    k_a: Rgb::gray(x(0.25)),
    k_d: Rgb::gray(x(0.5)),
    k_s: Rgb::BLACK,
    m: 1,
};

#[test]
fn a_static_scene_is_shaded() {
    // 1/4 · 1/2 + 1/2 (1/2 · 4/5 + 1/2); the spot shines past the point
    let lights = LIGHTS.iter().map(|light| light.at(Vec3::ZERO));
    let shaded = shade::lambert(UnitVec3::Z, &CLAY, Rgb::gray(x(0.5)), lights);
    assert!((steps(shaded.total().r) - 0.575 * 65536.0).abs() <= 1.5);
    assert_eq!(SOFT.at(Vec3::ZERO), LAMP.at(Vec3::ZERO));
}

#[test]
fn a_scene_in_single_precision_is_cast() {
    let lamp = shading::f32::PointLight {
        position: shading::Vec3::new(0.0, 0.0, 2.0),
        intensity: shading::Rgb::WHITE,
        attenuation: shading::f32::Attenuation::new(1.0, 0.0, 0.25).expect("valid"),
    };
    assert_eq!(lamp.cast(Fixed::from_f32), LAMP);
}

/// Half a step of each coordinate changes |v|² by up to √3 steps, and the square is rounded.
#[test]
fn new_takes_directions_whose_square_is_within_four_steps() {
    let mut random = Random(20);
    for i in 0..100_000 {
        let v = [(); 3].map(|()| random.within(-1.0, 1.0));
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        let [a, b, c] = v.map(|c| x(c / length));
        let unit = UnitVec3::new(a, b, c).expect("length 1");
        assert_eq!([unit.x, unit.y, unit.z], [a, b, c]);

        // up to 10 steps too long or too short
        let a = a + Fixed::from_bits(i % 21 - 10);
        let square: i64 = [a, b, c]
            .map(|c| i64::from(c.to_bits()).pow(2))
            .iter()
            .sum();
        let excess = ((square + 0x8000) >> 16) - 0x1_0000;
        assert_eq!(
            UnitVec3::new(a, b, c).is_some(),
            excess.abs() <= 4,
            "{excess}"
        );
    }
    assert_eq!(UnitVec3::new(Fixed::MIN, Fixed::MIN, Fixed::MAX), None);
}

#[test]
fn coefficients_and_ranges_are_checked() {
    let edges = edges();
    for &a in &edges {
        for &b in &edges {
            let coefficients = [a, b, x(0.25)];
            for [a, b, c] in [coefficients, [b, x(0.25), a], [x(0.0), a, b]] {
                let is_valid = [a, b, c].iter().all(|c| c.to_bits() >= 0)
                    && [a, b, c].iter().any(|c| c.to_bits() > 0);
                let attenuation = Attenuation::new(a, b, c);
                let expected = is_valid.then_some([a, b, c]);
                assert_eq!(attenuation.map(Attenuation::coefficients), expected);
                assert!(attenuation.is_none_or(|attenuation| !attenuation.is_clamped()));
            }
        }
        let ranged = LAMP.attenuation.within(a);
        assert_eq!(ranged.map(Ranged::range), (a.to_bits() > 0).then_some(a));
        assert!(ranged.is_none_or(|ranged| ranged.attenuation() == LAMP.attenuation));
    }
}

/// The cosine that a constructor stores for one that is rounded to a step: at most 1 less 4 steps,
/// and every direction from there to −1.
fn stored(cosine: Fixed) -> Fixed {
    let slack = Fixed::from_bits(4);
    if cosine < Fixed::NEG_ONE + slack {
        Fixed::NEG_ONE
    } else {
        cosine.min(Fixed::ONE - slack)
    }
}

#[test]
fn cones_have_the_cosine_of_their_angle() {
    let angles: Vec<Fixed> = (-3..=205_890).map(Fixed::from_bits).collect();
    // twice π/2 is π, although π/2 is rounded up to a step
    let pi = x(std::f64::consts::FRAC_PI_2) + x(std::f64::consts::FRAC_PI_2);
    assert_eq!(pi, x(std::f64::consts::PI) + Fixed::STEP);
    for &angle in &angles {
        let expected = (Fixed::ZERO..=pi).contains(&angle);
        let Some(cone) = Cone::from_half_angle(angle) else {
            assert!(!expected, "{angle}");
            continue;
        };
        assert!(expected, "{angle}");
        let error = steps(cone.cosine()) - steps(stored(x(exact(angle).cos())));
        assert!(
            error.abs() <= 1.0,
            "the cosine of {angle} is off by {error} steps"
        );
        let soft = SoftCone::from_half_angles(angle, pi).expect("angles");
        assert_eq!(soft.cosines(), [cone.cosine(), Fixed::NEG_ONE]);
        let soft = SoftCone::from_half_angles(Fixed::ZERO, angle).expect("angles");
        assert_eq!(
            soft.cosines(),
            [Fixed::ONE - Fixed::from_bits(4), cone.cosine()]
        );
        assert!(!soft.is_smoothstep());
    }
    for (inner, outer) in [(1.0, 0.5), (-0.5, 1.0), (0.5, 4.0), (4.0, 4.0)] {
        assert_eq!(SoftCone::from_half_angles(x(inner), x(outer)), None);
    }
}

#[test]
fn cones_have_their_cosine() {
    for cosine in edges() {
        let is_valid = (Fixed::NEG_ONE..=Fixed::ONE).contains(&cosine);
        let cone = Cone::from_cosine(cosine);
        assert_eq!(cone.map(Cone::cosine), is_valid.then(|| stored(cosine)));
        for inner in edges() {
            let is_valid = is_valid && inner <= Fixed::ONE && inner >= cosine;
            let soft = SoftCone::from_cosines(inner, cosine);
            let expected = is_valid.then(|| [stored(inner), stored(cosine)]);
            assert_eq!(soft.map(SoftCone::cosines), expected, "{inner}, {cosine}");
        }
    }
}

#[test]
fn a_cone_of_zero_lights_its_axis_and_one_of_pi_everything() {
    let narrow = Cone::from_half_angle(Fixed::ZERO).expect("an angle");
    let wide = Cone::from_half_angle(x(std::f64::consts::PI)).expect("an angle");
    let mut random = Random(21);
    for _ in 0..100_000 {
        let [d, e] = [(); 2].map(|()| {
            let v = Vec3::from([(); 3].map(|()| random.fixed()));
            v.unit_or(UnitVec3::X)
        });
        assert_eq!(narrow.factor(d, -d), Fixed::ONE, "{d:?}");
        assert_eq!(wide.factor(d, d), Fixed::ONE, "{d:?}");
        assert_eq!(wide.factor(d, e), Fixed::ONE, "{d:?}, {e:?}");
        assert_eq!(SoftCone::from(wide).factor(d, d), Fixed::ONE, "{d:?}");
    }
}

/// Toward the axis, the square of t never falls, and t²(3 − 2t) by one step at most. With edges one apart,
/// t is every number from 0 to 1; that of another cone is one of these, and rises with the cosine, because
/// quotients are rounded once.
#[test]
fn toward_the_axis_a_smoothstep_falls_by_one_step_at_most() {
    let half = 1 << 15;
    let [inner, outer] = [half, -half].map(Fixed::from_bits);
    let cone = SoftCone::from_cosines(inner, outer).expect("cosines");
    for (cone, expected) in [(cone, 0), (cone.smoothstep(), 1)] {
        let (mut brightest, mut fall) = (0, 0);
        for cosine in -half..=half {
            let l = Vec3::new(Fixed::from_bits(cosine), Fixed::ZERO, Fixed::ZERO);
            let factor = cone.factor(-UnitVec3::X, UnitVec3::assume_unit(l));
            let factor = factor.to_bits();
            fall = fall.max(brightest - factor);
            brightest = brightest.max(factor);
        }
        assert_eq!(fall, expected);
        assert_eq!(brightest, Fixed::ONE.to_bits());
    }
}

#[test]
fn a_range_is_kept_in_a_type_with_infinities() {
    let range = Fixed::from_bits(5 << 16);
    let ranged = Attenuation::NONE.within(range).expect("a range");
    assert!((ranged.cast(Fixed::to_f32).range() - 5.0).abs() < f32::EPSILON);
    let endless = Ranged::from(Attenuation::NONE);
    assert!(endless.cast(Fixed::to_f32).range().is_infinite());
}
