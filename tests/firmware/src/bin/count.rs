//! Prints how many instructions a point light costs, with an integer and with a real shininess:
//! Blinn–Phong, three channels, attenuation; 8 points, each lit by all of 4 lights.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LAMPS, brass};
use firmware::{board, broken};
use shading::{Exponent, Material, UnitVec3, shade};

#[board::entry]
fn main() -> ! {
    let whole = point_light(&brass(32));
    let real = point_light(&brass(32.0));
    board::println!("{whole} {real}");
    board::done()
}

fn point_light<M: Exponent<f32>>(material: &Material<f32, M>) -> u32 {
    let calls = CAP.map(|n| {
        let (n, v, material) = (black_box(&n), black_box(&UnitVec3::Z), black_box(material));
        let (i_a, lamps) = (black_box(&AMBIENT), black_box(&LAMPS));
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
