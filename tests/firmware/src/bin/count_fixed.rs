//! Prints how many instructions a point light costs in fixed point, with an integer shininess: the
//! scene and the points of `count`.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LAMPS, brass};
use firmware::{board, broken};
use shading::fixed::{Fixed, UnitVec3};
use shading::shade;

#[board::entry]
fn main() -> ! {
    let lamps = LAMPS.map(|lamp| lamp.cast(Fixed::from_f32));
    let material = brass(32).cast(Fixed::from_f32);
    let i_a = AMBIENT.map(Fixed::from_f32);
    let calls = CAP.map(|n| {
        let n = n.cast(Fixed::from_f32);
        let (n, v, material) = (black_box(&n), black_box(&UnitVec3::Z), black_box(&material));
        let (i_a, lamps) = (black_box(&i_a), black_box(&lamps));
        board::instructions(|| {
            let lights = lamps.iter().map(|lamp| lamp.at(**n));
            black_box(&shade::blinn_phong(*n, *v, material, *i_a, lights));
            broken::promise(0.0);
        })
    });
    let lights = (CAP.len() * LAMPS.len()) as u32;
    board::println!("{}", (calls.iter().sum::<u32>() + lights / 2) / lights);
    board::done()
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
