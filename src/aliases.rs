//! The types of a scene in one number type, so that constants need not name the number type.

macro_rules! types {
    ($number:ty) => {
        pub type Vec3 = crate::Vec3<$number>;
        pub type UnitVec3 = crate::UnitVec3<$number>;
        pub type Rgb = crate::Rgb<$number>;
        pub type Dual = crate::Dual<$number>;
        pub type Attenuation = crate::Attenuation<$number>;
        pub type Cone = crate::Cone<$number>;
        pub type Arrival = crate::Arrival<$number>;
        pub type IncidentLight = crate::IncidentLight<$number>;
        pub type DirectionalLight = crate::DirectionalLight<$number>;
        pub type PointLight = crate::PointLight<$number>;
        pub type SpotLight = crate::SpotLight<$number>;
        pub type Light = crate::Light<$number>;
        pub type Material<M = u32> = crate::Material<$number, M>;
        pub type Shaded = crate::Shaded<$number>;
    };
}

#[cfg(feature = "fixed")]
pub(crate) use types;

macro_rules! aliases {
    ($float:ident) => {
        #[doc = concat!("The types of a scene in `", stringify!($float), "`.")]
        ///
        /// Constructors that work in constants begin with `const_` and exist for each number type.
        /// With the types of this module, the compiler need not infer which one is meant.
        ///
        /// ```
        #[doc = concat!("use shading::", stringify!($float), "::{Attenuation, PointLight, Rgb, Vec3};")]
        ///
        /// static LAMP: PointLight = PointLight {
        ///     position: Vec3::new(0.0, 3.0, 0.0),
        ///     intensity: Rgb::WHITE,
        ///     attenuation: Attenuation::const_new(1.0, 0.0, 0.25).unwrap(),
        /// };
        /// ```
        #[allow(missing_docs)] // each is documented where it is defined
        pub mod $float {
            types!($float);
        }
    };
}

aliases!(f32);
aliases!(f64);
