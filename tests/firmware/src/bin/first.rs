#![no_std]
#![no_main]

use cortex_m_rt::entry;

use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
use shading::shade;

static LAMPS: [PointLight; 2] = [
    PointLight {
        position: Vec3::new(2.0, 3.0, 4.0),
        intensity: Rgb::new(1.0, 0.9, 0.8),
        attenuation: Attenuation::new(0.5, 0.0, 0.03).unwrap(), // checked by the compiler
    },
    PointLight {
        position: Vec3::new(-3.0, 0.0, 1.0),
        intensity: Rgb::new(0.1, 0.2, 0.6),
        attenuation: Attenuation::NONE,
    },
];
static AMBIENT: Rgb = Rgb::new(0.05, 0.05, 0.07);
static BRASS: Material = Material {
    k_a: Rgb::new(0.33, 0.22, 0.03),
    k_d: Rgb::new(0.78, 0.57, 0.11),
    k_s: Rgb::new(0.99, 0.94, 0.81),
    m: 28, // an integer: the fast path
};

/// The display color of the point p on the unit sphere, seen from far away.
fn pixel(p: Vec3) -> u16 {
    let Some(n) = p.unit() else { return 0 };
    let lights = LAMPS.iter().filter_map(|lamp| lamp.in_front(p, n));
    let light = shade::blinn_phong(n, UnitVec3::Z, &BRASS, AMBIENT, lights).total();
    light.to_rgb565() // clamped and sRGB-encoded
}

#[entry]
fn main() -> ! {
    let mut color = pixel(Vec3::new(0.6, 0.0, 0.8));
    loop {
        color = core::hint::black_box(color); // to the display
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
