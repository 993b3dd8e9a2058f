//! Tries every input of the reciprocals and of the root of `Fixed`, from their own source, with checks for overflow.

#![allow(dead_code)]

#[path = "../../src/features/fixed/arithmetic.rs"]
mod arithmetic;
#[path = "../../src/features/fixed/product.rs"]
mod product;
#[path = "../../src/features/fixed/reciprocal.rs"]
mod reciprocal;

use std::thread;

include!("crate.rs");

/// 2⁴⁸ over a number from 1 to the largest. The number is rounded to 19 bits or more, in up to three steps, which takes
/// 2⁻¹⁹ + 2⁻²³ + 2⁻²⁷ of it at most, less than 9 · 2⁻²². Then a unit is cut off. The result never rises.
fn reciprocals(from: u64, to: u64) {
    let mut last = u32::MAX;
    for steps in from..to {
        let result = reciprocal::reciprocal(steps as u32);
        let (low, high) = (u128::from(result) * u128::from(steps), (u128::from(result) + 1) * u128::from(steps));
        let [smaller, larger] = [(1 << 22) - 9, (1 << 22) + 9];
        assert!(low * smaller <= 1 << 70 && high * larger >= 1 << 70, "reciprocal({steps}) = {result}");
        assert!(result <= last, "reciprocal({steps}) rises");
        last = result;
    }
}

/// √x is rounded to the nearest step: the square of the step below by half is less, and of that above by half more. The root
/// of a number below 0 is that of 0.
fn square_roots(from: u64, to: u64) {
    for steps in from..to {
        let root = Fixed(steps as u32 as i32).root().0 as u64;
        // (root ± ½)² = root² ± root + ¼, and the number is whole
        let exact = if steps >> 31 == 1 { 0 } else { steps << 16 };
        assert!((root == 0 || root * root < exact + root) && exact <= root * root + root, "√{steps} = {root}");
    }
}

/// 2²⁷/√x for x from ¼ to 1 is off by 2⁻²⁵ of itself at most, so that its square times x is off by 2⁻²⁴.
fn roots(from: u64, to: u64) {
    for bits in from..to {
        let result = reciprocal::reciprocal_root(bits as u32) as u128;
        let square = result * result * u128::from(bits);
        assert!(square.abs_diff(1 << 86) <= 1 << (86 - 24), "reciprocal_root({bits}) = {result}");
    }
}

fn main() {
    let in_parts = |from: u64, to: u64, each: fn(u64, u64)| {
        thread::scope(|scope| {
            let middle = u64::midpoint(from, to);
            scope.spawn(move || each(from, middle + 1));
            scope.spawn(move || each(middle, to));
        });
    };
    in_parts((1 << 16) + 1, 1 << 31, reciprocals);
    in_parts(1 << 30, 1 << 32, roots);
    in_parts(0, 1 << 32, square_roots);
    println!("reciprocals and roots: every input tried");
}
