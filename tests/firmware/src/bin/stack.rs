//! Prints how many bytes of stack, below the caller, the sum over a slice of lights takes: for
//! Lambert, and for Phong and Blinn–Phong with an integer and a real shininess; each over all
//! lights, and over only those in front of the surface.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LIGHTS, brass};
use firmware::{board, broken};
use shading::{
    Attenuation, Exponent, IncidentLight, Light, Material, PointLight, Rgb, Shaded, UnitVec3, Vec3,
    shade,
};

#[board::entry]
fn main() -> ! {
    let (whole, real) = (&brass(32), &brass(32.5));
    board::println!(
        "{} {} {} {} {} {} {} {} {} {}",
        depth(whole, sum::<_, 'L', false>),
        depth(whole, sum::<_, 'L', true>),
        depth(whole, sum::<_, 'P', false>),
        depth(whole, sum::<_, 'P', true>),
        depth(real, sum::<_, 'P', false>),
        depth(real, sum::<_, 'P', true>),
        depth(whole, sum::<_, 'B', false>),
        depth(whole, sum::<_, 'B', true>),
        depth(real, sum::<_, 'B', false>),
        depth(real, sum::<_, 'B', true>)
    );
    board::done()
}

/// The measured call, as firmware makes it: one function that gets everything it needs.
type Sum<M> = fn(
    p: Vec3<f32>,
    n: UnitVec3<f32>,
    v: UnitVec3<f32>,
    material: &Material<f32, M>,
    i_a: Rgb<f32>,
    lights: &[Light<f32>],
) -> Shaded<f32>;

fn sum<M: Exponent<f32>, const MODEL: char, const IN_FRONT: bool>(
    p: Vec3<f32>,
    n: UnitVec3<f32>,
    v: UnitVec3<f32>,
    material: &Material<f32, M>,
    i_a: Rgb<f32>,
    lights: &[Light<f32>],
) -> Shaded<f32> {
    if IN_FRONT {
        let lights = lights.iter().filter_map(|light| light.in_front(p, n));
        shaded::<_, MODEL>(n, v, material, i_a, lights)
    } else {
        broken::promise(0.0);
        shaded::<_, MODEL>(n, v, material, i_a, lights.iter().map(|light| light.at(p)))
    }
}

#[inline(always)]
fn shaded<M: Exponent<f32>, const MODEL: char>(
    n: UnitVec3<f32>,
    v: UnitVec3<f32>,
    material: &Material<f32, M>,
    i_a: Rgb<f32>,
    lights: impl Iterator<Item = IncidentLight<f32>>,
) -> Shaded<f32> {
    match MODEL {
        'L' => shade::lambert(n, material, i_a, lights),
        'P' => shade::phong(n, v, material, i_a, lights),
        _ => shade::blinn_phong(n, v, material, i_a, lights),
    }
}

/// A light far away, one so far away that the vector to it overflows, one at the lit point, and one that
/// is nowhere.
static OUTLYING: [Light<f32>; 4] = [
    lamp(Vec3::new(1e25, 2e25, 3e25)),
    lamp(Vec3::new(f32::MAX, f32::MAX, f32::MAX)),
    lamp(Vec3::new(0.28, 0.0, 0.96)),
    lamp(Vec3::new(f32::INFINITY, f32::NAN, 0.0)),
];

const fn lamp(position: Vec3<f32>) -> Light<f32> {
    Light::Point(PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation: Attenuation::<f32>::new(0.0, 0.0, 1.0).unwrap(),
    })
}

fn depth<M>(material: &Material<f32, M>, sum: Sum<M>) -> usize {
    let [n, v] = black_box([CAP[1], CAP[0]]);
    let i_a = black_box(AMBIENT);
    let sum = black_box(sum); // a call that cannot be inlined
    let depth_with = |lights: &[Light<f32>]| {
        board::stack(|| _ = black_box(&sum(*n, n, v, material, i_a, lights)))
    };
    depth_with(black_box(&LIGHTS)).max(depth_with(black_box(&OUTLYING)))
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
