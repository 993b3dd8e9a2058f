//! Claims about the integers of `Fixed`, over the file of the source that multiplies. Each is true for every input, and
//! nothing in it overflows; `prove.py` proves that from LLVM's code, by a solver.
#![no_std]
#![allow(dead_code, clippy::all)]

#[path = "../../src/features/fixed/product.rs"]
mod product;

use product as p;

const HALF: i64 = 0x8000;

/// The product of two numbers by halves, which is a sum of products that need no proof: those of the halves.
fn exact(a: i32, b: i32) -> i64 {
    if p::LONG_MULTIPLY {
        return a as i64 * b as i64;
    }
    let [a1, b1] = [a >> 16, b >> 16];
    let [a0, b0] = [a & 0xFFFF, b & 0xFFFF];
    let low = (a0 as u32 * b0 as u32) as i64;
    ((a1 * b1) as i64) * (1 << 32) + ((a1 * b0) as i64 + (a0 * b1) as i64) * (1 << 16) + low
}

fn exact_unsigned(a: u32, b: u32) -> u64 {
    if p::LONG_MULTIPLY {
        return a as u64 * b as u64;
    }
    let [a1, a0, b1, b0] = [a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF];
    // the whole is below 2⁶⁴, though not every sum of four such products is
    let middle = (a1 * b0) as u64 + (a0 * b1) as u64;
    (((a1 * b1) as u64) << 32).wrapping_add(middle << 16).wrapping_add((a0 * b0) as u64)
}

fn saturated(steps: i64) -> i32 {
    if steps < i32::MIN as i64 {
        i32::MIN
    } else if steps > i32::MAX as i64 {
        i32::MAX
    } else {
        steps as i32
    }
}

/// `*` is rounded to the nearest step, a tie goes up, and it saturates.
#[unsafe(no_mangle)]
pub fn claim_product(a: i32, b: i32) -> bool {
    p::product(a, b) == saturated((exact(a, b) + HALF) >> 16)
}

/// A product with sign is that without, less 2³² times one number for each sign of the other.
#[unsafe(no_mangle)]
pub fn claim_upper_signed(a: i32, b: i32) -> bool {
    let of_signs = if a < 0 { b as u32 as u64 } else { 0 } + if b < 0 { a as u32 as u64 } else { 0 };
    let by_halves = exact_unsigned(a as u32, b as u32).wrapping_sub(of_signs << 32) as i64;
    let exact = if p::LONG_MULTIPLY { exact(a, b) } else { by_halves };
    p::upper_signed(a, b) as i64 == exact >> 32
}

#[unsafe(no_mangle)]
pub fn claim_upper(a: u32, b: u32) -> bool {
    p::upper(a, b) as u64 == exact_unsigned(a, b) >> 32
}

/// A share of a number is rounded to the nearest, and a tie goes up.
#[unsafe(no_mangle)]
pub fn claim_part(number: i32, share: u32) -> bool {
    let of_sign = if number < 0 { share as u64 } else { 0 };
    let by_halves = exact_unsigned(number as u32, share).wrapping_sub(of_sign << 32) as i64;
    let exact = if p::LONG_MULTIPLY { number as i64 * share as i64 } else { by_halves };
    let rounded = (exact >> 32) + (exact >> 31 & 1);
    p::part(number, share) as i64 == rounded
}
