//! Draws a frame on the emulated board and prints what goes to the panel: x, y, width, height and color of
//! each rectangle. The first line is the number of instructions, in which a pixel takes one store, as to
//! the register of a serial port.
//!
//! On a desktop it prints the same, without a count.
#![cfg_attr(target_os = "none", no_std, no_main)]

use bunny::{Panel, Turn, draw_bunny};

/// The angle of the Pythagorean triple 7, 24, 25.
const TURN: Turn = Turn(0.96, 0.28);

macro_rules! print_frame {
    ($println:path) => {{
        let Ok(()) = draw_bunny(
            &mut Panel(
                |area: embedded_graphics::primitives::Rectangle, color: u16| {
                    let (at, size) = (area.top_left, area.size);
                    $println!(
                        "{} {} {} {} {color:04x}",
                        at.x,
                        at.y,
                        size.width,
                        size.height
                    );
                },
            ),
            TURN,
        );
    }};
}

#[cfg(target_os = "none")]
mod board {
    use super::{Panel, TURN, draw_bunny};
    use core::hint::black_box;
    use firmware::board;

    #[board::entry]
    fn main() -> ! {
        let instructions = board::many_instructions(|| {
            let Ok(()) = draw_bunny(
                &mut Panel(
                    |area: embedded_graphics::primitives::Rectangle, color: u16| {
                        for _ in 0..area.size.width * area.size.height {
                            black_box(color);
                        }
                    },
                ),
                black_box(TURN),
            );
        });
        board::println!("{instructions}");
        print_frame!(board::println);
        board::done()
    }

    #[panic_handler]
    fn panic(info: &core::panic::PanicInfo) -> ! {
        board::fail(info)
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("0");
    print_frame!(std::println);
}
