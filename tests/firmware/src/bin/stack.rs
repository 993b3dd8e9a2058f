//! Prints how many bytes of the stack the sum over a slice of lights takes, with a whole shininess
//! and with a real one.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::scene::{AMBIENT, CAP, LIGHTS, brass};
use firmware::{board, broken};
use shading::{Exponent, Material, shade};

#[board::entry]
fn main() -> ! {
    board::println!("{} {}", depth(&brass(32)), depth(&brass(32.5)));
    board::done()
}

fn depth<M: Exponent<f32>>(material: &Material<f32, M>) -> usize {
    let (lights, n, v) = (black_box(&LIGHTS), black_box(&CAP[1]), black_box(&CAP[0]));
    board::stack(&|| {
        let incident = lights.iter().map(|light| light.at(**n));
        black_box(&shade::blinn_phong(*n, *v, material, AMBIENT, incident));
        broken::promise(0.0);
    })
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
