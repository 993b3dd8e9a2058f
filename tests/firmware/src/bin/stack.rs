//! Prints how many bytes of the stack, below the caller, the sum over a slice of lights takes: with
//! a whole shininess and with a real one, then again with only the lights in front of the surface.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LIGHTS, brass};
use firmware::{board, broken};
use shading::{Exponent, Light, Material, Rgb, Shaded, UnitVec3, Vec3, shade};

#[board::entry]
fn main() -> ! {
    let (whole, real) = (&brass(32), &brass(32.5));
    board::println!(
        "{} {} {} {}",
        depth(whole, sum::<_, false>),
        depth(real, sum::<_, false>),
        depth(whole, sum::<_, true>),
        depth(real, sum::<_, true>)
    );
    board::done()
}

/// What is measured, as firmware has it: one function, given all that it needs.
type Sum<M> = fn(
    p: Vec3<f32>,
    n: UnitVec3<f32>,
    v: UnitVec3<f32>,
    material: &Material<f32, M>,
    i_a: Rgb<f32>,
    lights: &[Light<f32>],
) -> Shaded<f32>;

fn sum<M: Exponent<f32>, const IN_FRONT: bool>(
    p: Vec3<f32>,
    n: UnitVec3<f32>,
    v: UnitVec3<f32>,
    material: &Material<f32, M>,
    i_a: Rgb<f32>,
    lights: &[Light<f32>],
) -> Shaded<f32> {
    if IN_FRONT {
        let lights = lights.iter().filter_map(|light| light.in_front(p, n));
        shade::blinn_phong(n, v, material, i_a, lights)
    } else {
        broken::promise(0.0);
        shade::blinn_phong(n, v, material, i_a, lights.iter().map(|light| light.at(p)))
    }
}

fn depth<M>(material: &Material<f32, M>, sum: Sum<M>) -> usize {
    let [n, v] = black_box([CAP[1], CAP[0]]);
    let (i_a, lights) = (black_box(AMBIENT), black_box(&LIGHTS[..]));
    let sum = black_box(sum); // a call that cannot be in line
    board::stack(|| _ = black_box(&sum(*n, n, v, material, i_a, lights)))
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
