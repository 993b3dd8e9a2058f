//! Prints how many instructions a color takes: to sRGB bytes, from them, and to RGB565. The figures
//! are means over the colors of `c/count_encode.c`, which cover the whole range.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::board;
use shading::Rgb;

#[board::entry]
fn main() -> ! {
    board::println!(
        "{} {} {}",
        color(|color| _ = black_box(color.to_srgb8())),
        color(|color| _ = black_box(Rgb::from_srgb8(black_box([color.r.to_bits() as u8; 3])))),
        color(|color| _ = black_box(color.to_rgb565()))
    );
    board::done()
}

fn color(encode: impl Fn(Rgb<f32>)) -> u32 {
    let colors = [0.0, 1e-3, 0.01, 0.04, 0.1, 0.3, 0.7, 1.0].map(|c| Rgb::new(c, 0.5 * c, 1.0 - c));
    let calls = colors.map(|color| board::instructions(|| encode(black_box(color))));
    (calls.iter().sum::<u32>() + 4) / 8
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
