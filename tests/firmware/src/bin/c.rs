//! Prints how many instructions a point light costs in Blinn–Phong, with a real m: by the crate, by the
//! crate as a light of any kind, by the header for C, whose lights are of any kind, and by the header in a
//! program with lamps alone. Four points, each lit by four lamps. Fails if a bit differs. Then, how many
//! bytes of stack the header takes below the caller.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::{AMBIENT, CAP, LAMPS, board, brass};
use shading::f32::{IncidentLight, Light as Any, PointLight, Rgb, UnitVec3, Vec3};
use shading::{Material, shade};

/// As in shading.h.
#[repr(C)]
struct Light {
    position: Vec3,
    is_sun: f32,
    intensity: Rgb,
    limit: f32,
    coefficients: [f32; 3],
    range: f32,
    axis: Vec3,
    is_smoothstep: f32,
    cosines: [f32; 2],
    is_gltf: f32,
}

/// As in in_f32.c.
#[repr(C)]
struct Lamp {
    position: Vec3,
    intensity: Rgb,
    limit: f32,
    coefficients: [f32; 3],
    range: f32,
    is_gltf: f32,
}

#[repr(C)]
struct CMaterial {
    k_a: Rgb,
    m: f32,
    k_d: Rgb,
    k_s: Rgb,
}

unsafe extern "C" {
    safe fn point_in_c(
        n: &UnitVec3,
        v: &UnitVec3,
        material: &CMaterial,
        i_a: &Rgb,
        lamps: &Light,
        count: u32,
        color: &mut Rgb,
    );
    safe fn lamps_in_c(
        n: &UnitVec3,
        v: &UnitVec3,
        material: &CMaterial,
        i_a: &Rgb,
        lamps: &Lamp,
        count: u32,
        color: &mut Rgb,
    );
}

firmware::program!(
    by_the_crate(LAMPS, PointLight::at),
    by_the_crate(LAMPS.map(Any::from), Any::at),
    by_the_header(lights_of_any_kind(), point_in_c),
    by_the_header(lamps(), lamps_in_c),
    stack_of_the_header()
);

const M: f32 = 32.0;

fn shaded(n: UnitVec3, material: &Material<f32, f32>, lamps: &[PointLight; 4]) -> Rgb {
    let lights = lamps.iter().map(|lamp| lamp.at(*n));
    shade::blinn_phong(n, UnitVec3::Z, material, AMBIENT, lights).total()
}

/// The mean of the calls, for one light.
fn by_each(mut call: impl FnMut(UnitVec3) -> u32) -> u32 {
    let lights = (CAP.len() * LAMPS.len()) as u32;
    (CAP.map(&mut call).iter().sum::<u32>() + lights / 2) / lights
}

fn by_the_crate<L>(lamps: [L; 4], at: impl Fn(&L, Vec3) -> IncidentLight) -> u32 {
    let material = brass::<f32, _>(M);
    by_each(|n| {
        let (n, v, i_a) = (black_box(&n), black_box(&UnitVec3::Z), black_box(&AMBIENT));
        let (material, lamps) = (black_box(&material), black_box(&lamps));
        board::instructions(|| {
            let lights = lamps.iter().map(|lamp| at(lamp, **n));
            black_box(&shade::blinn_phong(*n, *v, material, *i_a, lights).total());
        })
    })
}

fn lights_of_any_kind() -> [Light; 4] {
    LAMPS.map(|lamp| Light {
        position: lamp.position,
        is_sun: 0.0,
        intensity: lamp.intensity,
        limit: f32::MAX,
        coefficients: lamp.attenuation.coefficients(),
        range: f32::MAX,
        axis: *UnitVec3::Z,
        is_smoothstep: 0.0,
        cosines: [-1.0, -1.0],
        is_gltf: 0.0,
    })
}

fn lamps() -> [Lamp; 4] {
    LAMPS.map(|lamp| Lamp {
        position: lamp.position,
        intensity: lamp.intensity,
        limit: f32::MAX,
        coefficients: lamp.attenuation.coefficients(),
        range: f32::MAX,
        is_gltf: 0.0,
    })
}

/// A function of the header's program, which shades a point by some lights.
type InC<L> = extern "C" fn(&UnitVec3, &UnitVec3, &CMaterial, &Rgb, &L, u32, &mut Rgb);

fn material_in_c() -> CMaterial {
    let Material { k_a, k_d, k_s, m } = brass::<f32, _>(M);
    CMaterial { k_a, m, k_d, k_s }
}

/// With a sun, a lamp that has a range, one far away, and a spot with a soft edge.
fn stack_of_the_header() -> usize {
    let (material, mut lights, mut color) = (material_in_c(), lights_of_any_kind(), Rgb::BLACK);
    lights[0].is_sun = 1.0;
    (lights[1].range, lights[1].is_gltf) = (20.0, 1.0);
    lights[2].position = Vec3::new(1e25, 2e25, 3e25);
    (lights[3].cosines, lights[3].is_smoothstep) = ([0.99, -0.99], 1.0);
    let (n, v, i_a) = (&CAP[1], &UnitVec3::Z, &AMBIENT);
    board::stack(|| point_in_c(n, v, &material, i_a, &lights[0], 4, &mut color))
}

fn by_the_header<L>(lights: [L; 4], point: InC<L>) -> u32 {
    let material = material_in_c();
    by_each(|n| {
        let mut color = Rgb::BLACK;
        let count = board::instructions(|| {
            let (v, i_a) = (&UnitVec3::Z, &AMBIENT);
            point(&n, v, &material, i_a, &lights[0], 4, &mut color);
        });
        let expected = shaded(n, &brass(M), &LAMPS);
        assert!(color.map(f32::to_bits) == expected.map(f32::to_bits));
        count
    })
}
