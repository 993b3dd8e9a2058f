//! The optional features, each against the crate that it is for.

#[cfg(feature = "approx")]
pub mod approx {
    use approx::UlpsEq;
    use shading::{IncidentLight, Rgb, Shaded, UnitVec3, Vec3};

    use crate::scenes::SUN;

    pub fn call() {
        near::<Vec3>(Vec3::ZERO);
        near::<UnitVec3>(UnitVec3::X);
        near::<Rgb>(Rgb::WHITE);
        near::<IncidentLight>(SUN.at(Vec3::ZERO));
        near::<Shaded>(Shaded::default());
    }

    fn near<V: UlpsEq<Epsilon = f32> + approx::RelativeEq>(v: V) {
        let (epsilon, relative) = (V::default_epsilon(), V::default_max_relative());
        assert!(V::abs_diff_eq(&v, &v, epsilon) && V::relative_eq(&v, &v, epsilon, relative));
        assert!(V::ulps_eq(&v, &v, epsilon, V::default_max_ulps()));
    }
}

#[cfg(feature = "bytemuck")]
pub mod bytemuck {
    use bytemuck::{NoUninit, Pod, Zeroable};
    use shading::{Rgb, UnitVec3, Vec3};

    pub fn call() {
        both_ways::<Vec3>(Vec3::new(1.0, 2.0, 3.0));
        both_ways::<Rgb>(Rgb::WHITE);
        #[cfg(feature = "fixed")]
        {
            use shading::fixed::Fixed;
            both_ways::<Fixed>(Fixed::STEP);
            assert_eq!(<Fixed as Zeroable>::zeroed(), Fixed::from(0));
        }
        assert_eq!(<Vec3 as Zeroable>::zeroed(), Vec3::ZERO);
        assert_eq!(<Rgb as Zeroable>::zeroed(), Rgb::BLACK);
        one_way::<UnitVec3>(UnitVec3::X);
    }

    fn both_ways<V: Pod + PartialEq>(v: V) {
        assert!(bytemuck::pod_read_unaligned::<V>(bytemuck::bytes_of(&v)) == v);
    }

    fn one_way<V: NoUninit>(v: V) {
        assert_eq!(bytemuck::bytes_of(&v).len(), 12);
    }
}

#[cfg(feature = "defmt")]
pub mod defmt {
    use defmt::Format;
    use shading::{
        Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Light, Material, PointLight,
        Ranged, Rgb, Shaded, SoftCone, SpotLight, UnitVec3, Vec3,
    };

    use crate::scenes::{CLAY, LAMP, SPOT, SUN};

    pub fn call() {
        #[cfg(feature = "fixed")]
        {
            use shading::fixed::Fixed;
            log::<Fixed>(Fixed::STEP);
        }
        log::<Vec3>(Vec3::ZERO);
        log::<UnitVec3>(UnitVec3::X);
        log::<Rgb>(Rgb::WHITE);
        log::<Dual>(Dual::constant(1.0));
        log::<Attenuation>(Attenuation::NONE);
        log::<Ranged>(Attenuation::NONE.into());
        log::<Cone>(SPOT.cone);
        log::<SoftCone>(SPOT.cone.into());
        log::<IncidentLight>(SUN.at(Vec3::ZERO));
        log::<DirectionalLight>(SUN);
        log::<PointLight>(LAMP);
        log::<SpotLight>(SPOT);
        log::<Light>(SPOT.into());
        log::<Material>(CLAY);
        log::<Shaded>(Shaded::default());
    }

    fn log<V: Format>(value: V) {
        defmt::println!("{}", value);
    }
}

#[cfg(feature = "fixed")]
pub mod fixed {
    use core::fmt::Display;
    use core::hash::Hash;
    use core::ops::{Add, Div, Mul, Neg, Sub};

    use shading::fixed::Fixed;
    use shading::{Attenuation, Cone, Ranged, Rgb, SoftCone, UnitVec3, Vec3};

    use crate::numbers::{elementary, real};
    use crate::types::{same, value};

    const X: fn(f64) -> Fixed = Fixed::new;
    const UP: UnitVec3<Fixed> =
        UnitVec3::<Fixed>::normalized(Fixed::STEP, Fixed::STEP, Fixed::MAX).unwrap();

    pub fn call() {
        value::<Fixed>(Fixed::STEP);
        number::<Fixed>(Fixed::STEP);
        real::<Fixed>();
        elementary::<Fixed>();
        conversions();
        operators();
        constructors();
        encodings();
        short_names();
    }

    fn encodings() {
        assert_eq!(Rgb::<Fixed>::to_srgb8(Rgb::gray(X(1.0))), [255; 3]);
        assert_eq!(Rgb::<Fixed>::to_rgb565(Rgb::gray(X(1.0))), u16::MAX);
        assert_eq!(Rgb::<Fixed>::to_linear8(Rgb::gray(X(1.0))), [255; 3]);
        assert_eq!(Rgb::<Fixed>::to_linear565(Rgb::gray(X(1.0))), u16::MAX);
    }

    fn number<N: Display + Eq + Hash>(number: N) {
        assert!(number == number);
    }

    fn conversions() {
        assert_eq!(Fixed::from_bits(Fixed::to_bits(Fixed::MIN)), Fixed::MIN);
        assert_eq!(Fixed::to_f32(Fixed::from_f32(0.5)), 0.5);
        assert_eq!(<f64 as From<Fixed>>::from(Fixed::new(0.5)), 0.5);
        assert_eq!(<Fixed as From<i16>>::from(1), X(1.0));
        assert_eq!(<Fixed as Default>::default(), X(0.0));
    }

    fn operators() {
        let (two, three) = (X(2.0), X(3.0));
        assert_eq!(<Fixed as Add>::add(two, three), X(5.0));
        assert_eq!(<Fixed as Sub>::sub(two, three), X(-1.0));
        assert_eq!(<Fixed as Mul>::mul(two, three), X(6.0));
        assert_eq!(<Fixed as Div>::div(three, two), X(1.5));
        assert_eq!(<Fixed as Neg>::neg(two), X(-2.0));
        let (v, gray) = (Vec3::new(two, two, two), Rgb::gray(two));
        assert_eq!(<Fixed as Mul<Vec3<Fixed>>>::mul(three, v), v * three);
        assert_eq!(<Fixed as Mul<Rgb<Fixed>>>::mul(three, gray).g, X(6.0));
        assert!(<Fixed as Ord>::cmp(&two, &three).is_lt());
        assert!(<Fixed as PartialOrd>::partial_cmp(&two, &three).is_some());
    }

    fn constructors() {
        assert_eq!(UP, UnitVec3::Z);
        assert_eq!(
            UnitVec3::<Fixed>::new(X(1.0), X(0.0), X(0.0)),
            Some(UnitVec3::X)
        );
        let one = Attenuation::<Fixed>::new(X(1.0), X(0.0), X(0.0)).unwrap();
        assert_eq!(one, Attenuation::NONE);
        let ranged = Attenuation::<Fixed>::within(one, Fixed::MAX);
        assert_eq!(ranged, Some(Ranged::from(one)));
        let cone = Cone::<Fixed>::from_cosine(X(0.5)).unwrap();
        assert!(Cone::<Fixed>::from_half_angle(X(4.0)).is_none());
        let soft = SoftCone::<Fixed>::from_cosines(X(0.5), X(0.5));
        assert_eq!(soft, Some(SoftCone::from(cone)));
        assert!(SoftCone::<Fixed>::from_half_angles(X(0.5), X(0.25)).is_none());
    }

    fn short_names() {
        same::<shading::fixed::Vec3, Vec3<Fixed>>();
        same::<shading::fixed::UnitVec3, UnitVec3<Fixed>>();
        same::<shading::fixed::Rgb, Rgb<Fixed>>();
        same::<shading::fixed::Dual, shading::Dual<Fixed>>();
        same::<shading::fixed::Attenuation, Attenuation<Fixed>>();
        same::<shading::fixed::Ranged, Ranged<Fixed>>();
        same::<shading::fixed::Cone, Cone<Fixed>>();
        same::<shading::fixed::SoftCone, SoftCone<Fixed>>();
        same::<shading::fixed::IncidentLight, shading::IncidentLight<Fixed>>();
        same::<shading::fixed::DirectionalLight, shading::DirectionalLight<Fixed>>();
        same::<shading::fixed::PointLight, shading::PointLight<Fixed>>();
        same::<shading::fixed::SpotLight, shading::SpotLight<Fixed>>();
        same::<shading::fixed::Light, shading::Light<Fixed>>();
        same::<shading::fixed::Material, shading::Material<Fixed>>();
        same::<shading::fixed::Shaded, shading::Shaded<Fixed>>();
    }
}

#[cfg(feature = "mint")]
pub mod mint {
    use mint::{IntoMint, Point3, Vector3};
    use shading::{UnitVec3, Vec3};

    pub fn call() {
        let v = Vec3::new(1.0, 2.0, 3.0);
        let vector = <Vector3<f32> as From<Vec3>>::from(v);
        let point = <Point3<f32> as From<Vec3>>::from(v);
        assert_eq!(<Vec3 as From<Vector3<f32>>>::from(vector), v);
        assert_eq!(<Vec3 as From<Point3<f32>>>::from(point), v);
        assert_eq!(<Vector3<f32> as From<UnitVec3>>::from(UnitVec3::Y).y, 1.0);

        let like_vector: <Vec3 as IntoMint>::MintType = v.into();
        let like_direction: <UnitVec3 as IntoMint>::MintType = UnitVec3::Y.into();
        assert_eq!((like_vector.z, like_direction.y), (3.0, 1.0));
    }
}

#[cfg(feature = "serde")]
pub mod serde {
    use serde_core::Serialize;
    use serde_core::de::DeserializeOwned;
    use shading::{
        Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Ranged, Rgb, SoftCone,
        SpotLight, UnitVec3, Vec3,
    };

    use crate::scenes::{CLAY, LAMP, SPOT, SUN};

    pub fn call() {
        survives::<Vec3>(Vec3::ZERO);
        survives::<UnitVec3>(UnitVec3::X);
        survives::<Rgb>(Rgb::WHITE);
        survives::<Attenuation>(Attenuation::NONE);
        survives::<Ranged>(Attenuation::NONE.into());
        survives::<Cone>(SPOT.cone);
        survives::<SoftCone>(SPOT.cone.into());
        survives::<DirectionalLight>(SUN);
        survives::<PointLight>(LAMP);
        survives::<SpotLight>(SPOT);
        survives::<Light>(SPOT.into());
        survives::<Material>(CLAY);

        let point = PointLight {
            position: LAMP.position,
            intensity: LAMP.intensity,
            attenuation: LAMP.attenuation.within(8.0).unwrap(),
        };
        survives::<Light<f32, SoftCone, Ranged>>(Light::Spot(SpotLight {
            point,
            axis: SPOT.axis,
            cone: SPOT.cone.into(),
        }));
        survives::<Light<f64>>(Light::Spot(SPOT.cast(f64::from)));
        survives::<Material<f64>>(CLAY.cast(f64::from));
    }

    fn survives<V: Serialize + DeserializeOwned + PartialEq>(value: V) {
        let mut buffer = [0; 256];
        let bytes = postcard::to_slice(&value, &mut buffer).unwrap();
        assert!(postcard::from_bytes::<V>(bytes).unwrap() == value);
    }
}

#[cfg(feature = "wide")]
pub mod wide {
    use shading::{DirectionalLight, Exponent, Lanes, Light, PointLight, Rgb, Shaded, SpotLight};
    use wide::{f32x4, f32x8, f32x16, f64x4, f64x8};

    use crate::numbers::real;
    use crate::scenes::{LAMP, SPOT, SUN};

    pub fn call() {
        real::<f32x4>();
        real::<f32x8>();
        real::<f32x16>();
        real::<f64x4>();
        real::<f64x8>();
        assert_eq!(<f32 as Exponent<f32x4>>::raise(0.0, f32x4::ONE), f32x4::ONE);
        assert_eq!(<f32 as Exponent<f32x8>>::raise(0.0, f32x8::ONE), f32x8::ONE);
        assert_eq!(
            <f32 as Exponent<f32x16>>::raise(0.0, f32x16::ONE),
            f32x16::ONE
        );
        assert_eq!(<f64 as Exponent<f64x4>>::raise(0.0, f64x4::ONE), f64x4::ONE);
        assert_eq!(<f64 as Exponent<f64x8>>::raise(0.0, f64x8::ONE), f64x8::ONE);
        assert_eq!(<u32 as Exponent<f32x8>>::raise(2, f32x8::ONE), f32x8::ONE);
        lights_in_lanes();
    }

    fn lights_in_lanes() {
        type Lane = <f32x4 as Lanes>::Lane;
        let counts = [
            <f32x4 as Lanes>::COUNT,
            <f32x8 as Lanes>::COUNT,
            <f32x16 as Lanes>::COUNT,
            <f64x4 as Lanes>::COUNT,
            <f64x8 as Lanes>::COUNT,
        ];
        assert_eq!(counts, [4, 8, 16, 4, 8]);
        let twos = <f32x4 as Lanes>::from_fn(|_| 2.0);
        let first: Lane = <f32x4 as Lanes>::first(twos);
        assert_eq!((first, <f32x4 as Lanes>::sum(twos)), (2.0, 8.0));

        assert_eq!(DirectionalLight::packed::<f32x4>(&[SUN; 5]).count(), 2);
        assert_eq!(PointLight::packed::<f32x4>(&[LAMP; 5]).count(), 2);
        assert_eq!(SpotLight::packed::<f32x4>(&[SPOT; 5]).count(), 2);
        let lights: [Light; 2] = [SUN.into(), LAMP.into()];
        assert_eq!(Light::packed::<f32x4>(&lights).count(), 2);
        let [ambient, diffuse, specular] = [Rgb::gray(twos); 3];
        let shaded = Shaded {
            ambient,
            diffuse,
            specular,
        };
        assert_eq!(Shaded::sum_of_lanes(shaded).diffuse, Rgb::gray(8.0));
    }
}
