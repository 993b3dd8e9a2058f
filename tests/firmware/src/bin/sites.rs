//! Calls a sum over lights in one place, or in five, as the variable `SITES` says at build time, in
//! the number that `NUMBER` names, for the flash of the sums. The five differ as those of a
//! renderer do.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::sync::atomic::AtomicU32;

use firmware::is_same;
use shading::fixed::Fixed;
use shading::shade::{blinn_phong, lambert, phong};
use shading::{DirectionalLight, Light, Material, PointLight, Real, Rgb, Shaded, UnitVec3, Vec3};

struct Scene<T> {
    p: Vec3<T>,
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: Material<T>,
    i_a: Rgb<T>,
    sun: DirectionalLight<T>,
    lamps: [PointLight<T>; 4],
    lights: [Light<T>; 8],
}

#[inline(never)]
fn one<T: Real>(scene: &Scene<T>) -> Shaded<T> {
    let Scene {
        p,
        n,
        v,
        material,
        i_a,
        ..
    } = scene;
    let lamps = scene.lamps.iter().map(|lamp| lamp.at(*p));
    blinn_phong(*n, *v, material, *i_a, lamps)
}

#[inline(never)]
fn four_more<T: Real>(scene: &Scene<T>) -> Shaded<T> {
    let Scene {
        p,
        n,
        v,
        material,
        i_a,
        ..
    } = scene;
    let lamps = || scene.lamps.iter().map(|lamp| lamp.at(*p));
    let lights = scene.lights.iter().map(|light| light.at(*p));
    blinn_phong(*n, *v, material, *i_a, lights)
        + blinn_phong(*n, *v, material, *i_a, [scene.sun.at(*p)])
        + phong(*n, *v, material, *i_a, lamps())
        + lambert(*n, material, *i_a, lamps())
}

fn shade<T: Real>(memory: *const AtomicU32) {
    // SAFETY: zeros are a valid value of every type in them, and nothing writes to them.
    let scene: &Scene<T> = unsafe { &*memory.cast() };
    let _ = black_box(one(scene));
    if const { is(option_env!("SITES"), "5") } {
        let _ = black_box(four_more(scene));
    }
}

const fn is(variable: Option<&str>, value: &str) -> bool {
    match variable {
        Some(text) => is_same(text.as_bytes(), value.as_bytes()),
        None => false,
    }
}

/// The scene is zeros in RAM about which the compiler knows nothing.
#[firmware::board::entry]
fn main() -> ! {
    static MEMORY: [AtomicU32; 512] = [const { AtomicU32::new(0) }; 512];
    const { assert!(size_of::<Scene<Fixed>>() <= size_of_val(&MEMORY)) }
    loop {
        let memory = black_box(MEMORY.as_ptr());
        if const { is(option_env!("NUMBER"), "fixed") } {
            shade::<Fixed>(memory);
        } else {
            shade::<f32>(memory);
        }
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
