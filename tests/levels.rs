//! The ways to the level of a channel: by steps on a desktop, by a search on a chip, by one
//! comparison on a chip with an FPU. A processor takes one of them, so a difference would show only
//! on it. Here all three run, for every kind of number.

#[allow(dead_code)]
#[path = "../src/target.rs"]
mod target; // which the others read

#[allow(dead_code, clippy::pedantic)]
#[path = "../src/color/levels.rs"]
mod levels;
#[allow(dead_code, clippy::pedantic)]
#[path = "../src/color/steps.rs"]
mod steps;

use steps::Way;

/// Every edge of every encoding and the numbers beside it; every 997th number of either sign, and
/// NaN; both zeros and the ends.
fn numbers() -> impl Iterator<Item = f32> {
    let edges = levels::next_edges::<256>().into_iter();
    let edges = edges.chain(levels::next_edges::<64>());
    let edges = edges.chain(levels::next_edges::<32>());
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
        let level = by(Way::Steps, x);
        assert_eq!(by(Way::Search, x), level, "the search: {x:e}");
        assert_eq!(by(Way::Near, x), level, "one comparison: {x:e}");
    }
}

#[test]
fn eight_bits_are_the_same_by_every_way() {
    assert_one_level(steps::eight_bits_by);
}

#[test]
fn six_bits_are_the_same_by_every_way() {
    assert_one_level(steps::six_bits_by);
}

#[test]
fn five_bits_are_the_same_by_every_way() {
    assert_one_level(steps::five_bits_by);
}

#[test]
fn bits_compare_as_floats_do() {
    for x in numbers() {
        for low in [1.0 / 512.0, 1.0 / 2048.0, 1.0 / 8192.0] {
            assert_eq!(
                steps::at_least_by_bits(x, low),
                steps::at_least(x, low),
                "{x:e}"
            );
        }
    }
}
