//! What a light proved stays proved in every other number type.

use std::fmt::Debug;

use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Light, PointLight, Real, Rgb, SpotLight, UnitVec3,
    Vec3,
};

#[allow(clippy::cast_possible_truncation)]
fn single(x: f64) -> f32 {
    x as f32
}

/// Directions between the axes and around them, and the diagonal.
fn directions() -> impl Iterator<Item = UnitVec3<f64>> {
    let numbers = [0.0, 1e-20, 1e-9, 1e-4, 0.3, -0.577, 0.9, 1.0, -1.0];
    let vectors = numbers.into_iter().flat_map(move |x| {
        numbers
            .into_iter()
            .flat_map(move |y| numbers.map(|z| Vec3::new(x, y, z)))
    });
    vectors.filter_map(Vec3::unit)
}

/// A cone of half-angle 0 contains its axis, and one of π every direction, after a cast from T to U.
fn cones_stay<T: Real + PartialOrd + Debug, U: Real + PartialOrd + Debug>(
    from: impl Fn(f64) -> T,
    to: impl Fn(T) -> U,
) {
    let none = Cone::from_cosine(T::ONE).expect("a cosine").cast(&to);
    let all = Cone::from_cosine(T::NEG_ONE).expect("a cosine").cast(&to);
    for axis in directions() {
        let axis = axis.cast(&from).cast(&to);
        assert!(none.factor(axis, -axis) == U::ONE, "{axis:?}, {none:?}");
        assert!(all.factor(axis, axis) == U::ONE, "{axis:?}, {all:?}");
    }
    // once more changes nothing
    assert_eq!(none.cast(|x| x), none);
    assert_eq!(all.cast(|x| x), all);
}

#[test]
fn a_cone_contains_its_axis_after_each_pair_of_casts() {
    cones_stay(|x| x, single);
    cones_stay(single, f64::from);
    cones_stay(single, |x| single(f64::from(x)));
    cones_stay(single, Dual::constant);
    cones_stay(|x| x, Dual::constant);
    cones_stay(|x| x, |x| Dual::constant(single(x)));
    cones_stay(|x| Dual::constant(single(x)), |x| f64::from(x.value));
    cones_stay(Dual::constant, |x: Dual<f64>| Dual::constant(x));
}

#[cfg(feature = "fixed")]
#[test]
fn a_cone_contains_its_axis_after_each_pair_of_casts_with_fixed_point() {
    use shading::fixed::Fixed;
    let fixed = |x: f64| Fixed::from_f32(single(x));
    cones_stay(|x| x, fixed);
    cones_stay(single, Fixed::from_f32);
    cones_stay(fixed, f64::from);
    cones_stay(fixed, |x| single(x.into()));
    cones_stay(fixed, Dual::constant);
}

/// A cast before a light arrives and one after it give the same, as `==` and to the bit.
#[test]
fn a_light_may_be_cast_before_it_arrives_or_after() {
    let position = Vec3::new(1.0_f32, 2.0, 3.0);
    let intensity = Rgb::new(1.0, 0.5, 0.25);
    let attenuation = Attenuation::new(0.0, 0.5, 0.25)
        .expect("not 0")
        .within(8.0)
        .expect("above 0");
    let point = PointLight {
        position,
        intensity,
        attenuation,
    };
    let l = UnitVec3::Y;
    for cosine in [-1.0, 0.5, 1.0] {
        let cone = Cone::from_cosine(cosine).expect("a cosine");
        let spot = SpotLight {
            point,
            axis: -l,
            cone,
        };
        let sun = DirectionalLight { l, intensity };
        for light in [Light::from(sun), point.into(), spot.into()] {
            let before = light.cast(f64::from).at(Vec3::new(0.5, 0.0, 0.0));
            let after = light.at(Vec3::new(0.5, 0.0, 0.0)).cast(f64::from);
            assert_eq!(before, after);
            assert_eq!(after.cast(single), light.at(Vec3::new(0.5, 0.0, 0.0)));
            assert_eq!(before.intensity(), after.intensity());
        }
    }
}
