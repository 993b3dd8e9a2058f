//! The two ways to each product, by long products and by halves, and to the zeros before a number, for every
//! kind of argument: a processor computes by one of them alone, so a difference would show only on it.

use crate::Random;
use crate::product::{halves, long, zeros_by_product};

/// Zero, the powers of two and their neighbors, numbers of any magnitude, and halves of all zeros or ones.
fn numbers() -> Vec<u32> {
    let powers = (0..32).map(|k| 1_u32 << k);
    let near = powers.flat_map(|power| [power.wrapping_sub(1), power, power + 1]);
    let near = near.flat_map(|x| [x, x.wrapping_neg()]);
    let halves = [0, 1, 2, 0x7FFF, 0x8000, 0x8001, 0xFFFE, 0xFFFF_u32];
    let of_halves = halves
        .into_iter()
        .flat_map(|high| halves.map(|low| high << 16 | low));
    let mut random = Random(13);
    let some = (0..600).map(|_| {
        let bits = random.bits();
        u32::try_from(bits >> 32).expect("32 bits") >> (bits & 31)
    });
    near.chain(of_halves).chain(some).collect()
}

#[test]
fn halves_give_the_long_products() {
    let numbers = numbers();
    for &a in &numbers {
        for &b in &numbers {
            let (x, y) = (a.cast_signed(), b.cast_signed());
            assert_eq!(halves::product(x, y), long::product(x, y), "{x} {y}");
            assert_eq!(halves::upper(x, y), long::upper(x, y), "{x} {y}");
            assert_eq!(
                halves::upper_rounded(a, b),
                long::upper_rounded(a, b),
                "{a} {b}"
            );
            assert_eq!(
                halves::product_unsigned(a, b),
                long::product_unsigned(a, b),
                "{a} {b}"
            );
            let half = b >> 1;
            assert_eq!(
                halves::upper_unsigned(a, half),
                long::upper_unsigned(a, half),
                "{a} {half}"
            );
            let fraction = b % ((1 << 16) + 1);
            assert_eq!(
                halves::product_by_fraction(a, fraction),
                long::product_by_fraction(a, fraction),
                "{a} {fraction}"
            );
            let fraction = fraction.cast_signed();
            assert_eq!(
                halves::times_fraction(x, fraction),
                long::times_fraction(x, fraction),
                "{x} {fraction}"
            );
        }
    }
}

#[test]
fn a_product_counts_the_zeros() {
    for bits in numbers().into_iter().filter(|&bits| bits != 0) {
        assert_eq!(zeros_by_product(bits), bits.leading_zeros(), "{bits:#x}");
    }
}
