//! A ball on a small display. `cargo run --release` in this folder runs it on an emulated
//! Cortex-M4, whose display is the terminal; `cargo run --manifest-path chip/Cargo.toml` in the
//! folder above runs it on this machine. Both print the same.
//!
//! Besides the driver of its display, firmware needs only `ball.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::convert::Infallible;

use chip::ball;
#[cfg(target_os = "none")]
use cortex_m_semihosting::{hprint as print, hprintln as println};
use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, RgbColor, Size};

const SIDE: usize = 64;

/// Shows each pixel as half a character. It takes them row by row, as displays do.
struct Terminal {
    upper: [Rgb565; SIDE],
}

impl OriginDimensions for Terminal {
    fn size(&self) -> Size {
        Size::new_equal(SIDE as u32)
    }
}

impl DrawTarget for Terminal {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(at, lower) in pixels {
            let upper = core::mem::replace(&mut self.upper[at.x as usize], lower);
            if at.y % 2 == 1 {
                let [a, b] = [upper, lower].map(Rgb888::from);
                print!("\x1b[38;2;{};{};{}m", a.r(), a.g(), a.b());
                print!("\x1b[48;2;{};{};{}m▀", b.r(), b.g(), b.b());
                if at.x as usize == SIDE - 1 {
                    println!("\x1b[m");
                }
            }
        }
        Ok(())
    }
}

/// The turning ball, each frame in the place of the one before.
fn draw() {
    let mut display = Terminal {
        upper: [Rgb565::BLACK; SIDE],
    };
    let mut turn = ball::Turn::NONE;
    for frame in 0..12 {
        if frame > 0 {
            print!("\x1b[{}A", SIDE / 2);
        }
        let Ok(()) = ball::draw(&mut display, turn);
        turn = turn.next();
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    draw();
}

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    draw();
    cortex_m_semihosting::debug::exit(cortex_m_semihosting::debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}
