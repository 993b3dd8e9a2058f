//! The types themselves: what every value can do, and their short names.

use core::fmt::{Debug, Result, Write};

use shading::shade::Shaded;
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Light, Material, PointLight, Ranged,
    Rgb, SoftCone, SpotLight, UnitVec3, Vec3,
};

use crate::scenes::{CLAY, LAMP, SPOT, SUN};

pub fn call() {
    value::<Vec3>(Vec3::ZERO);
    value::<UnitVec3>(UnitVec3::X);
    value::<Rgb>(Rgb::WHITE);
    value::<Dual>(Dual::constant(1.0));
    value::<Attenuation>(Attenuation::NONE);
    value::<Ranged>(Attenuation::NONE.into());
    value::<Cone>(SPOT.cone);
    value::<SoftCone>(SPOT.cone.into());
    value::<IncidentLight>(SUN.at(Vec3::ZERO));
    value::<DirectionalLight>(SUN);
    value::<PointLight>(LAMP);
    value::<SpotLight>(SPOT);
    value::<Light>(SPOT.into());
    value::<Material>(CLAY);
    value::<Shaded>(Shaded::default());
    short_names();
}

/// Counts what is written.
struct Length(usize);

impl Write for Length {
    fn write_str(&mut self, text: &str) -> Result {
        self.0 += text.len();
        Ok(())
    }
}

pub(crate) fn value<V: Copy + Debug + PartialEq>(value: V) {
    let copy = value;
    assert!(V::clone(&value) == copy);
    let mut text = Length(0);
    write!(text, "{value:?}").unwrap();
    assert!(text.0 > 0);
}

/// Two names of one type.
pub(crate) trait Same<T> {}
impl<T> Same<T> for T {}
pub(crate) fn same<A: Same<B>, B>() {}

fn short_names() {
    same::<shading::f32::Vec3, Vec3<f32>>();
    same::<shading::f32::UnitVec3, UnitVec3<f32>>();
    same::<shading::f32::Rgb, Rgb<f32>>();
    same::<shading::f32::Dual, Dual<f32>>();
    same::<shading::f32::Attenuation, Attenuation<f32>>();
    same::<shading::f32::Ranged, Ranged<f32>>();
    same::<shading::f32::Cone, Cone<f32>>();
    same::<shading::f32::SoftCone, SoftCone<f32>>();
    same::<shading::f32::IncidentLight, IncidentLight<f32>>();
    same::<shading::f32::DirectionalLight, DirectionalLight<f32>>();
    same::<shading::f32::PointLight<Ranged>, PointLight<f32, Ranged>>();
    same::<shading::f32::SpotLight<SoftCone, Ranged>, SpotLight<f32, SoftCone, Ranged>>();
    same::<shading::f32::Light, Light<f32>>();
    same::<shading::f32::Material<f32>, Material<f32, f32>>();
    same::<shading::f32::Shaded, shading::Shaded<f32>>();

    same::<shading::f64::Vec3, Vec3<f64>>();
    same::<shading::f64::UnitVec3, UnitVec3<f64>>();
    same::<shading::f64::Rgb, Rgb<f64>>();
    same::<shading::f64::Dual, Dual<f64>>();
    same::<shading::f64::Attenuation, Attenuation<f64>>();
    same::<shading::f64::Ranged, Ranged<f64>>();
    same::<shading::f64::Cone, Cone<f64>>();
    same::<shading::f64::SoftCone, SoftCone<f64>>();
    same::<shading::f64::IncidentLight, IncidentLight<f64>>();
    same::<shading::f64::DirectionalLight, DirectionalLight<f64>>();
    same::<shading::f64::PointLight, PointLight<f64>>();
    same::<shading::f64::SpotLight, SpotLight<f64>>();
    same::<shading::f64::Light, Light<f64>>();
    same::<shading::f64::Material, Material<f64>>();
    same::<shading::f64::Shaded, shading::Shaded<f64>>();
}
