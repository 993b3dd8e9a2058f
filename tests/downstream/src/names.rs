//! The short names of types.

/// Two names of one type.
pub trait Same<T> {}
impl<T> Same<T> for T {}
pub const fn same<A: Same<B>, B>() {}

macro_rules! short_names {
    ($(#[$if:meta] $module:ident $number:ty;)*) => {$(
        #[$if]
        const _: () = {
            same::<shading::$module::Vec3, shading::Vec3<$number>>();
            same::<shading::$module::UnitVec3, shading::UnitVec3<$number>>();
            same::<shading::$module::Rgb, shading::Rgb<$number>>();
            same::<shading::$module::Dual, shading::Dual<$number>>();
            same::<shading::$module::Attenuation, shading::Attenuation<$number>>();
            same::<shading::$module::Ranged, shading::Ranged<$number>>();
            same::<shading::$module::Cone, shading::Cone<$number>>();
            same::<shading::$module::SoftCone, shading::SoftCone<$number>>();
            same::<shading::$module::IncidentLight, shading::IncidentLight<$number>>();
            same::<shading::$module::DirectionalLight, shading::DirectionalLight<$number>>();
            same::<shading::$module::PointLight, shading::PointLight<$number>>();
            same::<shading::$module::SpotLight, shading::SpotLight<$number>>();
            same::<shading::$module::Light, shading::Light<$number>>();
            same::<shading::$module::Material, shading::Material<$number>>();
            same::<shading::$module::Shaded, shading::Shaded<$number>>();
        };
    )*};
}

short_names! {
    #[cfg(all())] f32 f32;
    #[cfg(all())] f64 f64;
    #[cfg(feature = "fixed")] fixed shading::fixed::Fixed;
}
