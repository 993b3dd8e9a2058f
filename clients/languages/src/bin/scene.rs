//! Shades the dome of the callers with the crate itself, and writes the colors as floats: `scene FILE`.

use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Rgb, SpotLight, Vec3,
};
use shading::shade;

fn lights() -> Option<[Light; 3]> {
    let sun = DirectionalLight {
        l: Vec3::new(-1.0, 2.0, 2.0).unit()?,
        intensity: Rgb::new(0.25, 0.25, 0.375),
    };
    let lamp = PointLight {
        position: Vec3::new(2.0, 1.0, 2.0),
        intensity: Rgb::new(1.0, 0.75, 0.5),
        attenuation: Attenuation::new(1.0, 0.0, 0.25)?,
    };
    let spot = SpotLight {
        point: PointLight {
            position: Vec3::new(0.0, 3.0, 3.0),
            intensity: Rgb::new(3.0, 1.0, 1.0),
            attenuation: Attenuation::new(1.0, 0.5, 0.0)?.within(8.0)?,
        },
        axis: Vec3::new(0.0, -1.0, -1.0).unit()?,
        cone: Cone::from_half_angles(0.25, 0.375)?,
    };
    Some([sun.into(), lamp.into(), spot.into()])
}

fn main() -> std::io::Result<()> {
    let lights = lights().expect("valid lights");
    let (k_a, k_d, k_s) = (Rgb::gray(0.125), Rgb::new(0.5, 0.375, 0.25), Rgb::gray(0.5));
    let clay = Material {
        k_a,
        k_d,
        k_s,
        m: 32,
    };
    let color = |i: i16| {
        let (x, y) = (f32::from(i % 64 - 32) / 32.0, f32::from(32 - i / 64) / 32.0);
        let p = Vec3::new(x, y, 1.0 - x * x - y * y);
        let n = Vec3::new(2.0 * x, 2.0 * y, 1.0).unit().expect("a normal");
        let v = (Vec3::new(0.0, 0.0, 5.0) - p)
            .unit()
            .expect("away from the eye");
        let light = shade::blinn_phong(n, v, &clay, Rgb::gray(0.5), lights.iter().map(|l| l.at(p)));
        <[f32; 3]>::from(light.total())
    };
    let numbers = (0..64 * 64).flat_map(color).flat_map(f32::to_le_bytes);
    let path = std::env::args().nth(1).expect("usage: scene FILE");
    std::fs::write(path, numbers.collect::<Vec<u8>>())
}
