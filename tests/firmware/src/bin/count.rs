//! Prints how many instructions a point light costs, with an integer and with a real shininess, and
//! with an integer one in fixed point: Blinn–Phong, three channels, attenuation; 8 points, each lit
//! by all of 4 lights.
#![no_std]
#![no_main]

use core::convert::identity;
use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LAMPS, brass};
use firmware::{board, broken};
use shading::fixed::Fixed;
use shading::{Exponent, Real, UnitVec3, shade};

#[board::entry]
fn main() -> ! {
    let whole = point_light(identity, 32);
    let real = point_light(identity, 32.0);
    let fixed = point_light(Fixed::from_f32, 32);
    board::println!("{whole} {real} {fixed}");
    board::done()
}

fn point_light<T: Real, M: Exponent<T>>(number: fn(f32) -> T, m: M) -> u32 {
    let material = brass(m).cast(number);
    let lamps = LAMPS.map(|lamp| lamp.cast(number));
    let i_a = AMBIENT.map(number);
    let calls = CAP.map(|n| {
        let [n, v] = [n.cast(number), UnitVec3::Z];
        let (n, v, material) = (black_box(&n), black_box(&v), black_box(&material));
        let (i_a, lamps) = (black_box(&i_a), black_box(&lamps));
        board::instructions(|| {
            let lights = lamps.iter().map(|lamp| lamp.at(**n));
            black_box(&shade::blinn_phong(*n, *v, material, *i_a, lights));
            broken::promise(0.0);
        })
    });
    let lights = (CAP.len() * LAMPS.len()) as u32;
    (calls.iter().sum::<u32>() + lights / 2) / lights
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
