//! Structs and their fields, constants, and functions that take a function or store a number.

use shading::shade::Shaded;
use shading::{
    Attenuation, Beam, Cone, DirectionalLight, Dual, Falloff, IncidentLight, Light, Material,
    PointLight, Ranged, Real, Rgb, SoftCone, SpotLight, UnitVec3, Vec3,
};

const SUN: DirectionalLight = DirectionalLight {
    l: UnitVec3::Z,
    intensity: Rgb::WHITE,
};
const LAMP: PointLight = PointLight {
    position: Vec3::new(0.0, 0.0, 2.0),
    intensity: Rgb::gray(1.0),
    attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.25).unwrap(),
};
const SPOT: SpotLight = SpotLight {
    point: LAMP,
    axis: UnitVec3::NEG_Z,
    cone: Cone::<f32>::from_cosine(0.5).unwrap(),
};
const CLAY: Material = Material {
    k_a: Rgb::BLACK,
    k_d: Rgb::new(0.5, 0.5, 0.5),
    k_s: Rgb::BLACK,
    m: 2,
};

#[test]
fn fields() {
    let Vec3 { x, y, z } = LAMP.position;
    let Rgb { r, g, b } = LAMP.intensity;
    let IncidentLight {
        l,
        intensity,
        distance,
    } = SPOT.at(Vec3::ZERO);
    let Shaded {
        ambient,
        diffuse,
        specular,
    } = Shaded::default();
    let Dual { value, gradient } = Dual::point(LAMP.position).z;
    assert_eq!(
        [x, y, z, r, g, b, distance, value],
        [0.0, 0.0, 2.0, 1.0, 1.0, 1.0, 2.0, 2.0]
    );
    assert_eq!((l, gradient), (UnitVec3::Z, *UnitVec3::Z));
    assert_eq!([intensity, ambient], [Rgb::gray(0.5), diffuse + specular]);
}

#[test]
fn any_light() {
    for light in [
        Light::Directional(SUN),
        Light::Point(LAMP),
        Light::Spot(SPOT),
    ] {
        let l = match light {
            Light::Directional(sun) => sun.l,
            Light::Point(lamp) => lamp.at(Vec3::ZERO).l,
            Light::Spot(spot) => -spot.axis,
        };
        assert_eq!(
            l,
            Light::cast(light, f64::from)
                .at(Vec3::ZERO)
                .l
                .cast(|x| x as f32)
        );
    }
}

#[test]
fn casts() {
    let soft = SoftCone::from(SPOT.cone);
    let ranged = Ranged::from(LAMP.attenuation);
    assert_eq!(Vec3::map(LAMP.position, f64::from).z, 2.0);
    assert_eq!(Rgb::map(LAMP.intensity, f64::from).r, 1.0);
    assert_eq!(UnitVec3::cast(SUN.l, f64::from), UnitVec3::Z);
    assert_eq!(Attenuation::cast(LAMP.attenuation, f64::from).at(2.0), 0.5);
    assert_eq!(Ranged::cast(ranged, f64::from).at(2.0), 0.5);
    assert_eq!(Cone::cast(SPOT.cone, f64::from).cosine(), 0.5);
    assert_eq!(SoftCone::cast(soft, f64::from).cosines(), [0.5, 0.5]);
    assert_eq!(DirectionalLight::cast(SUN, f64::from).l, UnitVec3::Z);
    assert_eq!(PointLight::cast(LAMP, f64::from).position.z, 2.0);
    assert_eq!(SpotLight::cast(SPOT, f64::from).cone.cosine(), 0.5);
    assert_eq!(
        IncidentLight::cast(SUN.at(Vec3::ZERO), f64::from).l,
        UnitVec3::Z
    );
    assert_eq!(Material::cast(CLAY, f64::from).k_d, Rgb::gray(0.5));
    beam(soft);
    falloff(ranged);
}

/// What a spot asks of its cone.
fn beam<C: Beam<f32>>(beam: C) {
    let _: <C as Beam<f32>>::In<f64> = Beam::cast(beam, f64::from);
}

/// What a lamp asks of its falloff.
fn falloff<A: Falloff<f32>>(falloff: A) {
    let _: <A as Falloff<f32>>::In<f64> = Falloff::cast(falloff, f64::from);
}

#[test]
fn numbers() {
    fn constants<T: Real>() -> [T; 7] {
        let (zero, one) = (<T as Real>::ZERO, <T as Real>::ONE);
        let (minus_one, max, extreme) =
            (<T as Real>::NEG_ONE, <T as Real>::MAX, <T as Real>::EXTREME);
        [
            zero,
            one,
            minus_one,
            max,
            extreme,
            <T as Real>::of(2.0),
            <T as Real>::of_f32(2.0),
        ]
    }
    assert_eq!(constants::<f32>()[5..], [2.0; 2]);
    assert_eq!(constants::<Dual>()[0], Dual::constant(0.0));
}

#[test]
fn axes() {
    let axes: [[UnitVec3; 2]; 3] = [
        [UnitVec3::X, UnitVec3::NEG_X],
        [UnitVec3::Y, UnitVec3::NEG_Y],
        [UnitVec3::Z, UnitVec3::NEG_Z],
    ];
    assert!(axes.iter().all(|[axis, opposite]| -*axis == *opposite));
    assert_eq!(Attenuation::<f32>::NONE.at(2.0), 1.0);
}

#[test]
fn encodings() {
    const SKY: Rgb = Rgb::<f32>::from_srgb8([0, 128, 255]);
    assert_eq!(Rgb::<f32>::to_srgb8(SKY), [0, 128, 255]);
    assert_eq!(Rgb::<f32>::from_rgb565(0xf81f), Rgb::new(1.0, 0.0, 1.0));
}

macro_rules! encodings {
    ($($number:ident)*) => {
        #[test]
        fn encodings_of_each_number() {$({
            const PINK: Rgb<$number> = Rgb::new(1.0, 0.0, 1.0);
            const BYTES: [[u8; 3]; 2] = [Rgb::<$number>::to_srgb8(PINK), Rgb::<$number>::to_linear8(PINK)];
            const SHORT: [u16; 2] = [Rgb::<$number>::to_rgb565(PINK), Rgb::<$number>::to_linear565(PINK)];
            assert_eq!((BYTES, SHORT), ([[255, 0, 255]; 2], [0xf81f; 2]));
        })*}
    };
}
encodings!(f32 f64);

/// The checked constructors, in constants of each number.
macro_rules! constructors {
    ($($number:ident)*) => {
        #[test]
        fn constructors() {$({
            const HALF: $number = 0.5;
            const NONE: Attenuation<$number> = Attenuation::<$number>::new(1.0, 0.0, 0.0).unwrap();
            const RANGED: Ranged<$number> = Attenuation::<$number>::within(NONE, HALF).unwrap();
            const CONE: Cone<$number> = Cone::<$number>::from_cosine(HALF).unwrap();
            const WIDE: Option<Cone<$number>> = Cone::<$number>::from_half_angle(4.0);
            const SOFT: SoftCone<$number> = SoftCone::<$number>::from_cosines(HALF, HALF).unwrap();
            const WRONG: Option<SoftCone<$number>> = SoftCone::<$number>::from_half_angles(HALF, 0.25);
            const UP: UnitVec3<$number> = UnitVec3::<$number>::new(0.0, 0.0, 1.0).unwrap();
            const LONG: UnitVec3<$number> = UnitVec3::<$number>::normalized(0.0, 0.0, HALF).unwrap();
            assert_eq!((NONE, RANGED.range(), UP), (Attenuation::NONE, HALF, LONG));
            assert_eq!((SOFT, WIDE, WRONG), (CONE.into(), None, None));
        })*}
    };
}
constructors!(f32 f64);
