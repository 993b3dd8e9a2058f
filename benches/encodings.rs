//! sRGB bytes from this crate, from `powf`, and from `palette`'s table: the time per color, and how
//! many of all `f32` from 0 to 1 get a byte other than the nearest.
//!
//! `cargo bench -p shading-benches --bench encodings`. This crate gives the nearest byte: `tests/numerics/exhaustive.rs` checks
//! that against the standard's formula in 60 digits.

use std::hint::black_box;
use std::thread;
use std::time::Instant;

use palette::{LinSrgb, Srgb};
use shading::Rgb;

/// The number of colors encoded in a pass, and the number of passes.
const COLORS: usize = 4096;
const PASSES: usize = 500;

type Encode = fn([f32; 3]) -> [u8; 3];

fn ours(color: [f32; 3]) -> [u8; 3] {
    Rgb::from(color).to_srgb8()
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn by_powf(color: [f32; 3]) -> [u8; 3] {
    color.map(|linear| {
        let linear = linear.clamp(0.0, 1.0);
        let encoded = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * encoded + 0.5) as u8
    })
}

fn by_palette(color: [f32; 3]) -> [u8; 3] {
    Srgb::<u8>::from_linear(LinSrgb::from(color)).into()
}

fn main() {
    let mut random = fastrand::Rng::with_seed(1996);
    let colors: Vec<_> = (0..COLORS)
        .map(|_| [(); 3].map(|()| random.f32()))
        .collect();
    println!("| | ns per color | wrong, of all f32 from 0 to 1 |\n|---|---|---|");
    let contestants: [(&str, Encode); 3] = [
        ("this crate", ours),
        ("`powf`", by_powf),
        ("`palette`", by_palette),
    ];
    for (name, encode) in contestants {
        println!(
            "| {name} | {:.1} | {} |",
            nanoseconds(encode, &colors),
            wrong(encode)
        );
    }
}

/// The shortest time of all passes, per color.
#[allow(clippy::cast_precision_loss)]
fn nanoseconds(encode: Encode, colors: &[[f32; 3]]) -> f64 {
    let pass = |_| {
        let start = Instant::now();
        for &color in colors {
            black_box(encode(color));
        }
        start.elapsed().as_secs_f64()
    };
    (0..PASSES).map(pass).fold(f64::INFINITY, f64::min) * 1e9 / colors.len() as f64
}

fn wrong(encode: Encode) -> usize {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let is_wrong = |&bits: &u32| {
        let color = [f32::from_bits(bits); 3];
        encode(color) != ours(color)
    };
    thread::scope(|scope| {
        let counts: Vec<_> = (0..threads)
            .map(|first| {
                let bits = (0..=1.0_f32.to_bits()).skip(first).step_by(threads);
                scope.spawn(move || bits.filter(is_wrong).count())
            })
            .collect();
        counts
            .into_iter()
            .map(|count| count.join().unwrap_or(0))
            .sum()
    })
}
