//! The ring on an ST7789, a display of 240 × 240 pixels on an SPI bus. In this folder, `cargo run
//! --release --bin ring` draws it on an emulated chip, and prints the digest of the pixels on the
//! bus and how many instructions each frame takes. In the folder above, `cargo run --manifest-path
//! chip/Cargo.toml --bin ring -- ring.png` draws the same frames on the simulator of
//! `embedded-graphics`, prints the digests of its pixels, and writes the picture.
#![cfg_attr(target_os = "none", no_std, no_main)]

const SIDE: u16 = 240;
/// The steps of the turn that are drawn.
const FRAMES: [usize; 4] = [0, 8, 15, 24];

/// FNV-1a. A pixel is two bytes, the upper one first, on the bus and in the simulator.
fn digest(so_far: u32, bytes: &[u8]) -> u32 {
    let absorb = |digest: u32, byte: &u8| (digest ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
    bytes.iter().fold(so_far, absorb)
}
const NOTHING: u32 = 0x811c_9dc5;

#[cfg(not(target_os = "none"))]
fn main() {
    use embedded_graphics::prelude::{DrawTargetExt, Point, Size};
    use embedded_graphics::primitives::Rectangle;
    use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

    let side = u32::from(SIDE);
    let mut together = SimulatorDisplay::new(Size::new(FRAMES.len() as u32 * side, side));
    for (i, step) in FRAMES.into_iter().enumerate() {
        let mut display = SimulatorDisplay::new(Size::new_equal(side));
        let Ok(()) = chip::ring::draw(&mut display, step);
        println!(
            "step {step}: {:08x}",
            digest(NOTHING, &display.to_be_bytes())
        );
        let place = Rectangle::new(
            Point::new(i as i32 * i32::from(SIDE), 0),
            Size::new_equal(side),
        );
        let Ok(()) = chip::ring::draw(&mut together.cropped(&place), step);
    }
    if let Some(path) = std::env::args_os().nth(1) {
        let picture = together.to_rgb_output_image(&OutputSettings::default());
        picture.save_png(path).expect("the picture is written");
    }
}

#[cfg(target_os = "none")]
mod on_chip {
    use core::cell::Cell;
    use core::convert::Infallible;
    use core::hint::black_box;

    use cortex_m::Peripherals;
    use cortex_m::peripheral::SYST;
    use cortex_m::peripheral::syst::SystClkSource;
    use cortex_m_semihosting::{debug, hprintln};
    use embedded_hal::delay::DelayNs;
    use embedded_hal::digital::{self, OutputPin};
    use embedded_hal::spi::{self, Operation, SpiDevice};
    use mipidsi::Builder;
    use mipidsi::interface::SpiInterface;
    use mipidsi::models::ST7789;
    use mipidsi::options::ColorInversion;

    use super::{FRAMES, NOTHING, SIDE, digest};

    /// In place of the bus and the pins of a chip, which its HAL has: takes the digest of the pixels.
    #[derive(Default)]
    struct Board {
        is_data: Cell<bool>,
        command: Cell<u8>,
        /// `None` while the instructions are counted.
        pixels: Cell<Option<u32>>,
    }

    impl digital::ErrorType for &Board {
        type Error = Infallible;
    }

    /// The pin that tells data from commands.
    impl OutputPin for &Board {
        fn set_low(&mut self) -> Result<(), Infallible> {
            self.is_data.set(false);
            Ok(())
        }

        fn set_high(&mut self) -> Result<(), Infallible> {
            self.is_data.set(true);
            Ok(())
        }
    }

    impl spi::ErrorType for &Board {
        type Error = Infallible;
    }

    impl SpiDevice for &Board {
        fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
            const WRITE_MEMORY: u8 = 0x2c;
            for operation in operations {
                let Operation::Write(bytes) = operation else {
                    continue;
                };
                if !self.is_data.get() {
                    self.command.set(bytes[0]);
                } else if self.command.get() == WRITE_MEMORY {
                    self.pixels.set(
                        self.pixels
                            .get()
                            .map(|so_far| digest(so_far, black_box(bytes))),
                    );
                }
            }
            Ok(())
        }
    }

    impl DelayNs for &Board {
        fn delay_ns(&mut self, _: u32) {}
    }

    /// How many ticks of the core's timer the work takes. On a chip, a tick is a cycle.
    fn ticks(work: impl FnOnce()) -> u32 {
        let start = SYST::get_current();
        work();
        start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff // it counts down, in 24 bits
    }

    #[inline(never)]
    fn thousand_instructions() {
        // SAFETY: the instructions do nothing.
        unsafe { core::arch::asm!(".rept 1000", "nop", ".endr") }
    }

    #[cortex_m_rt::entry]
    fn main() -> ! {
        let mut timer = Peripherals::take().expect("called once").SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0x00ff_ffff);
        timer.clear_current();
        timer.enable_counter();
        let hundred_thousand = ticks(|| (0..100).for_each(|_| thousand_instructions()));

        let (board, mut buffer) = (Board::default(), [0; 512]);
        let bus = SpiInterface::new(&board, &board, &mut buffer);
        let builder = Builder::new(ST7789, bus).display_size(SIDE, SIDE);
        let builder = builder.invert_colors(ColorInversion::Inverted);
        let Ok(mut display) = builder.init(&mut &board) else {
            panic!("the display")
        };
        for step in FRAMES {
            let ticks = ticks(|| _ = chip::ring::draw(&mut display, step));
            let thousands = u64::from(ticks) * 100 / u64::from(hundred_thousand);
            board.pixels.set(Some(NOTHING));
            _ = chip::ring::draw(&mut display, step);
            let pixels = board.pixels.take().unwrap_or_default();
            hprintln!(
                "step {}: {:08x}, {} thousand instructions",
                step,
                pixels,
                thousands
            );
        }
        debug::exit(debug::EXIT_SUCCESS);
        loop {
            cortex_m::asm::wfi();
        }
    }

    #[panic_handler]
    fn panic(info: &core::panic::PanicInfo) -> ! {
        hprintln!("{}", info);
        debug::exit(debug::EXIT_FAILURE);
        loop {
            cortex_m::asm::wfi();
        }
    }
}
