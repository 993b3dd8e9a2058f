//! What fixed point gives where a formula has no answer, or one out of range: the rows for `Fixed`
//! of the table in `docs/totality.md` that no other test here covers.

use shading::fixed::{
    Attenuation, Cone, DirectionalLight, Dual, Fixed, Material, PointLight, Ranged, Rgb, SoftCone,
    UnitVec3, Vec3,
};
use shading::{Elementary, Real, attenuation, half_vector, normal, shade};

use crate::{Random, exact};

const fn x(literal: f64) -> Fixed {
    Fixed::new(literal)
}

fn at_z(z: Fixed) -> Vec3 {
    Vec3::new(Fixed::ZERO, Fixed::ZERO, z)
}

fn lamp(position: Vec3, [a, b, c]: [f64; 3]) -> PointLight {
    PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation: Attenuation::new(x(a), x(b), x(c)).expect("coefficients"),
    }
}

const WHITE: Material = Material {
    k_a: Rgb::WHITE,
    k_d: Rgb::WHITE,
    k_s: Rgb::WHITE,
    m: 1,
};

#[test]
fn root_and_logarithm_have_a_limit_or_zero() {
    for below in [-Fixed::STEP, Fixed::NEG_ONE, Fixed::MIN] {
        assert_eq!([below.sqrt(), below.ln()], [Fixed::ZERO; 2]);
    }
    assert_eq!(Fixed::ZERO.ln(), Fixed::MIN);
    assert_eq!(Fixed::MAX.exp(), Fixed::MAX);
    assert_eq!(Fixed::MIN.exp(), Fixed::ZERO);
}

#[test]
fn the_zero_vector_has_no_direction() {
    assert_eq!(Vec3::ZERO.unit(), None);
    assert_eq!(UnitVec3::normalized(x(0.0), x(0.0), x(0.0)), None);
    assert_eq!(Vec3::ZERO.unit_or(UnitVec3::Y), UnitVec3::Y);
    assert_eq!(Vec3::ZERO.length(), Fixed::ZERO);
    assert_eq!(normal::plane(x(0.0), x(0.0), x(0.0)), None);
    let p = Vec3::new(x(1.0), x(2.0), x(3.0));
    assert_eq!(normal::sphere(p, p), None);
    assert_eq!(normal::triangle(p, p, at_z(x(1.0))), None);
    assert_eq!(normal::implicit(|p| p.dot(p), Vec3::ZERO), None);
}

#[test]
fn cross_products_saturate() {
    let [a, b] = [x(1000.0), x(-1000.0)].map(|c| Vec3::new(c, x(1000.0), x(0.0)));
    assert_eq!(a.cross(b), at_z(Fixed::MAX));
    assert_eq!(b.cross(a), at_z(Fixed::MIN));
    assert_eq!(a.cross(a), Vec3::ZERO);
    // but the normal is right, as the edges are rescaled
    assert_eq!(normal::from_tangents(a, b), Some(UnitVec3::Z));
    assert_eq!(normal::from_tangents(a, a), None);
}

#[test]
fn opposite_directions_have_no_half_vector() {
    for l in [UnitVec3::X, UnitVec3::NEG_Z] {
        assert_eq!(half_vector(l, -l), None);
        let sun = DirectionalLight {
            l,
            intensity: Rgb::WHITE,
        };
        let shaded = shade::blinn_phong(l, -l, &WHITE, Rgb::BLACK, [sun.at(Vec3::ZERO)]);
        assert_eq!(shaded.specular, Rgb::BLACK);
    }
}

/// An attenuation that is out of range at one end or the other.
#[test]
fn attenuation_is_at_most_the_largest_number() {
    assert_eq!(attenuation(x(0.0), x(0.0), x(0.0), x(1.0)), Fixed::MAX);
    let square = Attenuation::new(x(0.0), x(0.0), x(1.0)).expect("coefficients");
    assert_eq!(square.at(x(0.0)), Fixed::MAX);
    assert_eq!(square.at(Fixed::STEP), Fixed::MAX);
    assert_eq!(square.clamped().at(x(0.0)), x(1.0));
    // 1/(2¹⁵ − 2⁻¹⁶) is 2 steps
    assert_eq!(square.at(Fixed::MAX), Fixed::from_bits(2));
    assert_eq!(square.at(x(1000.0)), Fixed::from_bits(2));

    let black = PointLight {
        intensity: Rgb::BLACK,
        ..lamp(at_z(Fixed::STEP), [0.0, 0.0, 1.0])
    };
    assert_eq!(black.at(Vec3::ZERO).intensity, Rgb::BLACK);
    let near = lamp(at_z(Fixed::STEP), [0.0, 0.0, 1.0]);
    assert_eq!(near.at(Vec3::ZERO).intensity, Rgb::gray(Fixed::MAX));
}

#[test]
fn the_largest_range_is_no_range() {
    let none = Ranged::from(Attenuation::NONE);
    assert_eq!(Attenuation::NONE.within(Fixed::MAX), Some(none));
    let mut random = Random(30);
    for _ in 0..10_000 {
        let q = Real::abs(random.fixed());
        assert_eq!(none.at(q), Fixed::ONE, "{q}");
    }
    assert_eq!(none.at(Fixed::MAX), Fixed::ONE);
    assert_eq!(none.unsquared().at(Fixed::MAX), Fixed::ONE);
    let short = Attenuation::NONE.within(x(2.0)).expect("a range");
    for q in [x(2.0), x(2.5), Fixed::MAX] {
        assert_eq!(short.at(q), Fixed::ZERO, "{q}");
        assert_eq!(short.unsquared().at(q), Fixed::ZERO, "{q}");
    }
}

#[test]
fn a_light_at_the_point_is_black() {
    let p = Vec3::new(x(1.0), x(-2.0), x(3.0));
    for coefficients in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]] {
        let arriving = lamp(p, coefficients).at(p);
        assert_eq!(arriving.intensity, Rgb::BLACK);
        assert_eq!(arriving.distance, Fixed::MAX);
    }
}

/// A difference that saturates still points to the side where the light is.
#[test]
fn a_light_too_far_away_is_at_the_end_of_the_range() {
    let far = lamp(at_z(Fixed::MAX), [0.0, 1.0, 0.0]).at(at_z(Fixed::MIN));
    assert_eq!(far.l, UnitVec3::Z);
    let near_the_end = exact(Fixed::MAX) * (1.0 - 1.0 / f64::from(1 << 26));
    assert!(exact(far.distance) >= near_the_end, "{}", far.distance);
    assert_eq!(far.intensity, Rgb::gray(Fixed::from_bits(2)));

    let corner = Vec3::new(Fixed::MAX, Fixed::MAX, Fixed::MAX);
    let far = lamp(corner, [1.0, 0.0, 0.0]).at(-corner);
    assert!(exact(far.distance) >= near_the_end, "{}", far.distance);
    assert_eq!(far.intensity, Rgb::WHITE);
    // 1/√3 is 37837.2 steps
    assert_eq!(far.l.x, Fixed::from_bits(37_837));
}

#[test]
fn a_sun_is_at_the_largest_distance() {
    let sun = DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::WHITE,
    };
    assert_eq!(sun.at(Vec3::ZERO).distance, Fixed::MAX);
}

#[test]
fn a_soft_cone_of_one_angle_is_the_hard_cone() {
    for cosine in [x(-1.0), x(-0.5), x(0.0), x(0.6), x(1.0)] {
        let hard = Cone::from_cosine(cosine).expect("a cosine");
        let mut random = Random(31);
        for i in 0..10_000 {
            let v = Vec3::from([(); 3].map(|()| random.fixed()));
            // one direction in 10,000 is on the edge of 0.6
            let l = if i == 0 {
                UnitVec3::new(x(0.8), x(0.0), x(0.6)).expect("a direction")
            } else {
                v.unit_or(UnitVec3::Z)
            };
            for soft in [SoftCone::from(hard), SoftCone::from(hard).smoothstep()] {
                let factor = soft.factor(UnitVec3::NEG_Z, l);
                assert_eq!(factor, hard.factor(UnitVec3::NEG_Z, l), "{l:?}");
            }
        }
    }
}

#[test]
fn overflowing_sums_are_the_largest_number() {
    let sun = DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(Fixed::MAX),
    };
    let lights = || [sun, sun, sun].map(|sun| sun.at(Vec3::ZERO));
    let z = UnitVec3::Z;
    let half = Material {
        k_d: Rgb::gray(x(0.5)),
        k_s: Rgb::BLACK,
        ..WHITE
    };
    for shaded in [
        shade::lambert(z, &half, Rgb::BLACK, lights()),
        shade::phong(z, z, &half, Rgb::BLACK, lights()),
        shade::blinn_phong(z, z, &half, Rgb::BLACK, lights()),
    ] {
        assert_eq!(shaded.diffuse, Rgb::gray(Fixed::MAX * x(0.5)));
        assert_eq!(shaded.specular, Rgb::BLACK);
    }
    let full = shade::phong(z, z, &WHITE, Rgb::WHITE, lights());
    assert_eq!(full.total(), Rgb::gray(Fixed::MAX));
}

/// There is no infinity, so a slope that does not exist is the largest number.
#[test]
fn dual_slopes_saturate() {
    let zero = Dual::point(Vec3::ZERO).x;
    for steep in [zero.sqrt(), zero.ln(), Dual::ONE / zero] {
        assert_eq!(steep.gradient.x.abs(), Fixed::MAX, "{steep:?}");
        assert_eq!([steep.gradient.y, steep.gradient.z], [Fixed::ZERO; 2]);
    }
    assert_eq!((Dual::ONE / zero).value, Fixed::MAX);
}

#[test]
fn channels_out_of_range_get_the_last_level() {
    for dark in [Fixed::MIN, Fixed::NEG_ONE, -Fixed::STEP] {
        let dark = Rgb::gray(dark);
        assert_eq!((dark.to_srgb8(), dark.to_rgb565()), ([0; 3], 0));
    }
    for bright in [Fixed::ONE + Fixed::STEP, Fixed::MAX] {
        let bright = Rgb::gray(bright);
        assert_eq!(
            (bright.to_srgb8(), bright.to_rgb565()),
            ([255; 3], u16::MAX)
        );
    }
}
