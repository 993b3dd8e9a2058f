// `on_unimplemented` of the bound on `From` names the type that holds every light.
use shading::f32::{Attenuation, Light, PointLight, Rgb, SoftCone, SpotLight, UnitVec3, Vec3};

fn main() {
    let point = PointLight {
        position: Vec3::ZERO,
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    };
    let cone = SoftCone::from_half_angles(0.25, 0.5).unwrap();
    let _lights: [Light; 1] = [SpotLight { point, axis: UnitVec3::Z, cone }.into()];
}
