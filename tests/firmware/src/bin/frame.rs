//! Draws the ball by the program that the variable `BALL` names at build time, and prints how many
//! instructions the frame takes and the digest of the picture. On the host, it draws by every
//! program, prints the digest of each, and compares the pictures with that in `f64`: the greatest
//! difference of a channel in levels of RGB565, and how many pixels differ by more than one.
#![cfg_attr(target_os = "none", no_std, no_main)]

use firmware::ball::{self, SIDE};
use kit::digest::{Fnv, Sink};

#[cfg(target_os = "none")]
#[firmware::board::entry]
fn main() -> ! {
    let (mut digest, mut colors) = (Fnv::EMPTY, [0; 256]);
    let mut stopwatch = firmware::board::Stopwatch::start();
    for row in 0..SIDE {
        stopwatch.count(|| {
            ball::draw_row(row, const { ball::chosen() }, |column, color| {
                colors[usize::from(column)] = color;
            });
        });
        absorb(&colors[..SIDE as usize], &mut digest);
    }
    firmware::board::println!("{} {}", stopwatch.instructions(), digest.0);
    firmware::board::exit(0)
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    firmware::board::println!("{info}");
    firmware::board::exit(1)
}

fn absorb(colors: &[u16], digest: &mut Fnv) {
    for color in colors {
        digest.bytes(color.to_le_bytes());
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    let picture = |pixel| {
        let mut colors = Vec::new();
        for row in 0..SIDE {
            ball::draw_row(row, pixel, |_, color| colors.push(color));
        }
        colors
    };
    let exact = picture(ball::F64);
    for (name, pixel) in ball::PROGRAMS {
        let (colors, mut digest) = (picture(pixel), Fnv::EMPTY);
        absorb(&colors, &mut digest);
        let channels = |color: u16| [color >> 11, color >> 5 & 63, color & 31];
        let difference = |(a, b): (&u16, &u16)| {
            let pairs = channels(*a).into_iter().zip(channels(*b));
            pairs.map(|(a, b)| a.abs_diff(b)).max().expect("channels")
        };
        let differences = || colors.iter().zip(&exact).map(difference);
        let worst = differences().max().expect("pixels");
        let wrong = differences().filter(|levels| *levels > 1).count();
        println!("{name} {} {worst} {wrong}", digest.0);
    }
}
