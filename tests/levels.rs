//! The two ways to the level of a channel: by steps on a desktop, by a climb on a chip. A processor
//! takes one of them, so a difference would show only on the other. Here both run, for every kind of
//! number.

#[allow(dead_code)]
#[path = "../src/target.rs"]
mod target; // which the others read

mod number {
    pub(crate) const fn cold() {}
}

macro_rules! included {
    ($($name:ident $path:literal)*) => {$(
        #[allow(dead_code, clippy::pedantic)]
        #[path = $path]
        mod $name;
    )*};
}
included! {
    clamp "../src/color/clamp.rs"
    climb "../src/color/climb.rs"
    levels "../src/color/levels.rs"
    steps "../src/color/steps.rs"
    table "../src/color/table.rs"
}

use levels::Levels;
use table::Way;

/// Every edge of every encoding and the numbers beside it; every 997th number of either sign, and
/// NaN; both zeros and the ends.
fn numbers() -> impl Iterator<Item = f32> {
    let edges = Levels::<256>::NEXT.into_iter();
    let edges = edges.chain(Levels::<64>::NEXT);
    let edges = edges.chain(Levels::<32>::NEXT);
    let beside = edges.flat_map(|bits| [bits.wrapping_sub(1), bits, bits.wrapping_add(1)]);
    let ends = [
        0.0,
        1.0,
        f32::MIN_POSITIVE,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    let ends = ends.into_iter().flat_map(|x| {
        let bits = x.to_bits();
        [bits.wrapping_sub(1), bits, bits + 1, bits | 1 << 31]
    });
    let all = (0..=u32::MAX).step_by(997);
    beside.chain(ends).chain(all).map(f32::from_bits)
}

fn assert_one_level(by: fn(Way, f32) -> u32) {
    for x in numbers() {
        assert_eq!(by(Way::Climb, x), by(Way::Steps, x), "{x:e}");
    }
}

#[test]
fn eight_bits_are_the_same_by_every_way() {
    assert_one_level(table::eight_bits_by);
}

#[test]
fn six_bits_are_the_same_by_every_way() {
    assert_one_level(table::six_bits_by);
}

#[test]
fn five_bits_are_the_same_by_every_way() {
    assert_one_level(table::five_bits_by);
}

#[test]
fn bits_compare_as_floats_do() {
    for x in numbers() {
        for (low, high) in [(1.0 / 512.0, 1.0), (clamp::DARKEST, clamp::BRIGHTEST)] {
            assert_eq!(
                clamp::clamped_by_bits(x, low, high),
                clamp::clamped(x, low, high),
                "{x:e}"
            );
        }
    }
}

/// The light of a level that is not whole, by the formula of sRGB.
fn decoded(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// As the encoders of `f64` say: what is farther than 2⁻²⁴ of itself from an edge is on its right side.
#[test]
fn double_precision_misses_an_edge_by_the_roundoff_of_single_at_most() {
    const ROUNDOFF: f64 = 1.0 / 16_777_216.0;
    let gray = shading::Rgb::<f64>::gray;
    let edge = |levels: u16, level: u16| (f64::from(level) - 0.5) / f64::from(levels - 1);
    let assert_edge = |edge: f64, level: u16, encoded: &dyn Fn(f64) -> u16| {
        let [below, above] = [edge * (1.0 - ROUNDOFF), edge * (1.0 + ROUNDOFF)].map(encoded);
        assert_eq!([below, above], [level - 1, level], "{edge:e}");
    };
    for level in 1..256 {
        let srgb = |x| gray(x).to_srgb8()[0].into();
        assert_edge(decoded(edge(256, level)), level, &srgb);
        assert_edge(edge(256, level), level, &|x| gray(x).to_linear8()[0].into());
    }
    for level in 1..64 {
        let green = |x| gray(x).to_rgb565() >> 5 & 63;
        assert_edge(decoded(edge(64, level)), level, &green);
    }
    for level in 1..32 {
        let red = |x| gray(x).to_rgb565() >> 11;
        assert_edge(decoded(edge(32, level)), level, &red);
    }
    // 127.5/255 is nearer than half of that, and on the wrong side, since the nearest `f32` is
    assert_eq!(gray(0.503_921_598_196_029_6).to_linear8(), [128; 3]);
}
