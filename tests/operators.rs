//! What surrounds the formulas: operators, sums, defaults, and short names.

use std::any::TypeId;

use shading::f32::{Cone, DirectionalLight, Light, PointLight, Ranged, SoftCone, SpotLight};
use shading::{Attenuation, Real, Rgb, Shaded, UnitVec3, Vec3};
use support::number::{Float, for_f32_and_f64, vector};

for_f32_and_f64!(
    operators_act_on_each_component,
    assignment_operators_agree_with_the_operators,
    sums_go_from_first_to_last,
    named_directions_are_the_axes,
    parts_of_a_result_add_up_and_scale,
    attenuation_returns_its_coefficients,
    selections_take_what_is_above_zero,
);

fn rgb<T: Real>(channels: [f64; 3]) -> Rgb<T> {
    Rgb::from(channels).map(T::of)
}

/// 0, −0 and NaN are not above 0; the smallest number is.
fn selections_take_what_is_above_zero<T: Float>() {
    let above = [T::of(T::TINIEST), T::ONE, T::MAX, T::INFINITY];
    let other = [T::ZERO, -T::ZERO, -T::of(T::TINIEST), -T::INFINITY, T::NAN];
    for x in above {
        assert!(x.any_positive());
        assert_eq!(x.if_positive(T::ONE, T::ZERO), T::ONE);
    }
    for x in other {
        assert!(!x.any_positive());
        assert_eq!(x.if_positive(T::ZERO, T::ONE), T::ONE);
    }
    assert_eq!(T::of_f32(0.1), T::of(f64::from(0.1_f32)));
}

#[test]
fn literals_are_rounded_to_the_nearest_number() {
    assert_eq!(f32::of(0.1).to_bits(), 0x3DCC_CCCD);
    assert_eq!(f64::of(0.1).to_bits(), 0x3FB9_9999_9999_999A);
}

fn operators_act_on_each_component<T: Float>() {
    let (a, b, two) = ([1.0, -2.0, 6.0], [4.0, 8.0, -1.0], T::of(2.0));
    let (v, w) = (vector::<T>(a), vector(b));
    assert_eq!(v + w, vector([5.0, 6.0, 5.0]));
    assert_eq!(v - w, vector([-3.0, -10.0, 7.0]));
    assert_eq!(v * two, vector([2.0, -4.0, 12.0]));
    assert_eq!(v / two, vector([0.5, -1.0, 3.0]));
    assert_eq!(-v, vector([-1.0, 2.0, -6.0]));
    let (c, d) = (rgb::<T>(a), rgb(b));
    assert_eq!(c + d, rgb([5.0, 6.0, 5.0]));
    assert_eq!(c - d, rgb([-3.0, -10.0, 7.0]));
    assert_eq!(c * d, rgb([4.0, -16.0, -6.0]));
    assert_eq!(c * two, rgb([2.0, -4.0, 12.0]));
    assert_eq!(c / two, rgb([0.5, -1.0, 3.0]));
    // a quotient is the result of a division, not of a multiplication by a rounded reciprocal
    let [seven, ten] = [7.0, 10.0].map(T::of);
    assert_eq!(Vec3::new(seven, seven, seven) / ten, vector([0.7; 3]));
    assert_eq!(Rgb::gray(seven) / ten, rgb([0.7; 3]));
}

fn assignment_operators_agree_with_the_operators<T: Float>() {
    let (a, b, third) = ([0.1, 0.2, 0.3], [3.0, -0.7, 11.0], T::of(1.0 / 3.0));
    let (v, w) = (vector::<T>(a), vector(b));
    let [mut sum, mut difference, mut product] = [v; 3];
    sum += w;
    difference -= w;
    product *= third;
    assert_eq!([sum, difference, product], [v + w, v - w, v * third]);
    let (c, d) = (rgb::<T>(a), rgb(b));
    let [mut sum, mut difference, mut product] = [c; 3];
    sum += d;
    difference -= d;
    product *= third;
    assert_eq!([sum, difference, product], [c + d, c - d, c * third]);
}

fn sums_go_from_first_to_last<T: Float>() {
    // 1 + u + u is 1, and u + u + 1 is 1 + 2u, so the result shows the order
    let (one, u) = ([1.0; 3], [T::U; 3]);
    let (first, last) = (one, [1.0 + 2.0 * T::U; 3]);
    for (terms, sum) in [([one, u, u], first), ([u, u, one], last)] {
        let vectors = terms.map(vector::<T>);
        assert_eq!(vectors.iter().sum::<Vec3<T>>(), vector(sum));
        assert_eq!(vectors.into_iter().sum::<Vec3<T>>(), vector(sum));
        let colors = terms.map(rgb::<T>);
        assert_eq!(colors.iter().sum::<Rgb<T>>(), rgb(sum));
        assert_eq!(colors.into_iter().sum::<Rgb<T>>(), rgb(sum));
    }
    assert_eq!([].iter().sum::<Vec3<T>>(), Vec3::ZERO);
    assert_eq!([].iter().sum::<Rgb<T>>(), Rgb::BLACK);
}

fn named_directions_are_the_axes<T: Float>() {
    let axes = [UnitVec3::<T>::X, UnitVec3::Y, UnitVec3::Z];
    let against = [UnitVec3::<T>::NEG_X, UnitVec3::NEG_Y, UnitVec3::NEG_Z];
    for i in 0..3 {
        let mut axis = [0.0; 3];
        axis[i] = 1.0;
        assert_eq!(*axes[i], vector(axis));
        axis[i] = -1.0;
        assert_eq!(*against[i], vector(axis));
        assert_eq!(-axes[i], against[i]);
    }
}

fn parts_of_a_result_add_up_and_scale<T: Float>() {
    let shaded = |[ambient, diffuse, specular]: [f64; 3]| Shaded {
        ambient: rgb::<T>([ambient, 0.5, 4.0]),
        diffuse: rgb([diffuse, 0.25, 4.0]),
        specular: rgb([specular, 0.125, 4.0]),
    };
    let (a, b) = (shaded([1.0, 2.0, 3.0]), shaded([10.0, 20.0, 30.0]));
    let sum = a + b;
    assert_eq!(sum.ambient, rgb([11.0, 1.0, 8.0]));
    assert_eq!(sum.diffuse, rgb([22.0, 0.5, 8.0]));
    assert_eq!(sum.specular, rgb([33.0, 0.25, 8.0]));
    assert_eq!([a, b].into_iter().sum::<Shaded<T>>(), sum);

    let half = sum * T::of(0.5);
    assert_eq!(half.ambient, rgb([5.5, 0.5, 4.0]));
    assert_eq!(half.diffuse, rgb([11.0, 0.25, 4.0]));
    assert_eq!(half.specular, rgb([16.5, 0.125, 4.0]));
    assert_eq!(half.total(), rgb([33.0, 0.875, 12.0]));

    let none = Shaded::<T>::default();
    assert_eq!([].into_iter().sum::<Shaded<T>>(), none);
    assert_eq!([none.ambient, none.diffuse, none.specular], [Rgb::BLACK; 3]);
    assert_eq!(none + a, a);
}

fn attenuation_returns_its_coefficients<T: Float>() {
    let abc = [0.25, 0.0, 3.0].map(T::of);
    let attenuation = Attenuation::of(abc[0], abc[1], abc[2]).expect("coefficients");
    assert_eq!(attenuation.coefficients(), abc);
    assert!(!attenuation.is_clamped());
    assert_eq!(attenuation.clamped().coefficients(), abc);
    assert!(attenuation.clamped().is_clamped());

    let none = Attenuation::<T>::default();
    assert_eq!(none, Attenuation::NONE);
    assert_eq!(none.coefficients(), [T::ONE, T::ZERO, T::ZERO]);
    assert!(!none.is_clamped());
}

macro_rules! of_each_float {
    ($($float:ident: $number_first:ident, $aliases:ident);*) => {
        $(#[test]
        fn $number_first() {
            let half: $float = 0.5;
            assert_eq!(half * Vec3::new(1.0, -2.0, 6.0), Vec3::new(0.5, -1.0, 3.0));
            assert_eq!(half * Rgb::new(1.0, 0.0, 6.0), Rgb::new(0.5, 0.0, 3.0));
        }

        /// Each short name is the type for that number, and needs no other parameter.
        #[test]
        fn $aliases() {
            use shading::$float as of;
            fn id<T: 'static>() -> TypeId {
                TypeId::of::<T>()
            }
            assert_eq!(id::<of::Vec3>(), id::<shading::Vec3<$float>>());
            assert_eq!(id::<of::UnitVec3>(), id::<shading::UnitVec3<$float>>());
            assert_eq!(id::<of::Rgb>(), id::<shading::Rgb<$float>>());
            assert_eq!(id::<of::Dual>(), id::<shading::Dual<$float>>());
            assert_eq!(id::<of::Attenuation>(), id::<shading::Attenuation<$float>>());
            assert_eq!(id::<of::Cone>(), id::<shading::Cone<$float>>());
            assert_eq!(id::<of::IncidentLight>(), id::<shading::IncidentLight<$float>>());
            assert_eq!(id::<of::DirectionalLight>(), id::<shading::DirectionalLight<$float>>());
            assert_eq!(id::<of::PointLight>(), id::<shading::PointLight<$float>>());
            assert_eq!(id::<of::SpotLight>(), id::<shading::SpotLight<$float>>());
            assert_eq!(id::<of::Light>(), id::<shading::Light<$float>>());
            assert_eq!(id::<of::Material>(), id::<shading::Material<$float, u32>>());
            assert_eq!(id::<of::Material<$float>>(), id::<shading::Material<$float, $float>>());
            assert_eq!(id::<of::Shaded>(), id::<shading::Shaded<$float>>());
        })*
    };
}

of_each_float!(
    f32: f32_times_a_vector, names_in_f32;
    f64: f64_times_a_vector, names_in_f64
);

/// In the type of soft lights with ranges, each light keeps what arrives, to the bit.
#[test]
fn every_light_fits_into_the_widest_type() {
    type Widest = Light<SoftCone, Ranged>;
    let sun = DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::WHITE,
    };
    let lamp = PointLight {
        position: Vec3::new(0.5, -0.25, 2.0),
        intensity: Rgb::new(1.0, 0.5, 0.25),
        attenuation: Attenuation::<f32>::new(1.0, 0.5, 0.25).unwrap(),
    };
    let spot = SpotLight {
        point: lamp,
        axis: UnitVec3::NEG_Z,
        cone: Cone::from_half_angle(0.5).unwrap(),
    };
    let soft_spot = SpotLight {
        point: lamp,
        axis: UnitVec3::NEG_Z,
        cone: SoftCone::from_half_angles(0.25, 0.5).unwrap(),
    };
    let ranged = PointLight {
        position: lamp.position,
        intensity: lamp.intensity,
        attenuation: lamp.attenuation.within(4.0).unwrap(),
    };
    let p = Vec3::new(0.125, 0.25, -0.5);
    let fit = [
        sun.into(),
        lamp.into(),
        spot.into(),
        soft_spot.into(),
        ranged.into(),
    ];
    let arriving = [
        sun.at(p),
        lamp.at(p),
        spot.at(p),
        soft_spot.at(p),
        ranged.at(p),
    ];
    assert_eq!(fit.map(|light: Widest| light.at(p)), arriving);

    let hard: [Light; 3] = [sun.into(), lamp.into(), spot.into()];
    assert_eq!(
        hard.map(|light| Widest::from(light).at(p)),
        [arriving[0], arriving[1], arriving[2]]
    );
}
