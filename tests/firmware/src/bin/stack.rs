//! Prints how many bytes of stack, below the caller, the sum over a slice of lights takes: for
//! Lambert, and for Phong and Blinn–Phong with an integer and a real shininess; each over all
//! lights, and over only those in front of the surface. Then the same in fixed point, with an
//! integer shininess.
#![no_std]
#![no_main]

use core::convert::identity;
use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LIGHTS, brass};
use firmware::{board, broken};
use shading::fixed::Fixed;
use shading::{
    Attenuation, Exponent, IncidentLight, Light, Material, PointLight, Real, Rgb, Shaded, UnitVec3,
    Vec3, shade,
};

#[board::entry]
fn main() -> ! {
    let (whole, real) = (32, 32.5);
    board::println!(
        "{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}",
        depth(identity, whole, sum::<_, _, 'L', false>),
        depth(identity, whole, sum::<_, _, 'L', true>),
        depth(identity, whole, sum::<_, _, 'P', false>),
        depth(identity, whole, sum::<_, _, 'P', true>),
        depth(identity, real, sum::<_, _, 'P', false>),
        depth(identity, real, sum::<_, _, 'P', true>),
        depth(identity, whole, sum::<_, _, 'B', false>),
        depth(identity, whole, sum::<_, _, 'B', true>),
        depth(identity, real, sum::<_, _, 'B', false>),
        depth(identity, real, sum::<_, _, 'B', true>),
        depth(Fixed::from_f32, whole, sum::<_, _, 'L', false>),
        depth(Fixed::from_f32, whole, sum::<_, _, 'L', true>),
        depth(Fixed::from_f32, whole, sum::<_, _, 'P', false>),
        depth(Fixed::from_f32, whole, sum::<_, _, 'P', true>),
        depth(Fixed::from_f32, whole, sum::<_, _, 'B', false>),
        depth(Fixed::from_f32, whole, sum::<_, _, 'B', true>)
    );
    board::done()
}

/// The measured call, as firmware makes it: one function that gets everything it needs.
type Sum<T, M> = fn(
    p: Vec3<T>,
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: &[Light<T>],
) -> Shaded<T>;

fn sum<T: Real, M: Exponent<T>, const MODEL: char, const IN_FRONT: bool>(
    p: Vec3<T>,
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: &[Light<T>],
) -> Shaded<T> {
    if IN_FRONT {
        let lights = lights.iter().filter_map(|light| light.in_front(p, n));
        shaded::<_, _, MODEL>(n, v, material, i_a, lights)
    } else {
        broken::promise(0.0);
        shaded::<_, _, MODEL>(n, v, material, i_a, lights.iter().map(|light| light.at(p)))
    }
}

#[inline(always)]
fn shaded<T: Real, M: Exponent<T>, const MODEL: char>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl Iterator<Item = IncidentLight<T>>,
) -> Shaded<T> {
    match MODEL {
        'L' => shade::lambert(n, material, i_a, lights),
        'P' => shade::phong(n, v, material, i_a, lights),
        _ => shade::blinn_phong(n, v, material, i_a, lights),
    }
}

/// A light far away, one so far away that the vector to it overflows, one at the lit point, and one that
/// is nowhere. In fixed point, all but the third are at the ends of the range.
static OUTLYING: [Light<f32>; 4] = [
    lamp(Vec3::new(1e25, 2e25, 3e25)),
    lamp(Vec3::new(f32::MAX, -f32::MAX, f32::MAX)),
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

fn depth<T: Real, M: Exponent<T>>(number: fn(f32) -> T, m: M, sum: Sum<T, M>) -> usize {
    let [n, v] = black_box([CAP[1].cast(number), CAP[0].cast(number)]);
    let material = &brass(m).cast(number);
    let i_a = black_box(AMBIENT.map(number));
    let sum = black_box(sum); // a call that cannot be inlined
    let depth_with = |lights: &[Light<f32>; 4]| {
        let lights = lights.map(|light| light.cast(number));
        board::stack(|| _ = black_box(&sum(*n, n, v, material, i_a, black_box(&lights))))
    };
    depth_with(&LIGHTS).max(depth_with(&OUTLYING))
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
