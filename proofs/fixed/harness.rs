//! Claims about the integers of `Fixed`, over the files of the source that compute with them. Each is true for every input,
//! and nothing in it overflows; `prove.py` proves that from LLVM's code, by a solver.
#![no_std]
#![allow(dead_code, clippy::all)]

#[path = "../../src/features/fixed/arithmetic.rs"]
mod arithmetic;
#[path = "../../src/features/fixed/falloff.rs"]
mod falloff;
#[path = "../../src/features/fixed/product.rs"]
mod product;
#[path = "../../src/features/fixed/vector.rs"]
mod vectors;

/// The reciprocals are called, not inlined, so that `prove.py` can take them for what `every.rs` has found of them.
#[path = "."]
mod reciprocal {
    use super::product;
    #[path = "../../src/features/fixed/reciprocal.rs"]
    mod shipped;

    #[inline(never)]
    pub const fn reciprocal_root(bits: u32) -> i32 {
        shipped::reciprocal_root(bits)
    }

    #[inline(never)]
    pub fn reciprocal(steps: u32) -> u32 {
        shipped::reciprocal(steps)
    }

    pub const fn pairs_of_zeros(bits: u32) -> u32 {
        shipped::pairs_of_zeros(bits)
    }
}

include!("crate.rs");

use {product as p, vectors as v};

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

/// A number times a factor below 1, as a vector or a color is scaled, is rounded as by `*`.
#[unsafe(no_mangle)]
pub fn claim_short_part(number: i32, share: u16) -> bool {
    p::short_part(number, share) as i64 == (exact(number, share as i32) + HALF) >> 16
}

/// `/` is rounded to the nearest step, a tie goes away from 0, and it saturates; 0/0 is 0.
#[unsafe(no_mangle)]
pub fn claim_quotient(a: i32, b: i32) -> bool {
    let quotient = (Fixed(a) / Fixed(b)).0;
    if a == 0 {
        return quotient == 0;
    }
    let is_negative = (a ^ b) < 0;
    let end = if is_negative { i32::MIN } else { i32::MAX };
    if b == 0 {
        return quotient == end;
    }
    let magnitude = quotient.unsigned_abs();
    let divisor = b.unsigned_abs() as u64;
    let [twice, product] = [(a.unsigned_abs() as u64) << 17, magnitude as u64 * divisor];
    // within half a divisor, and a tie away from 0, but for what is beyond the end
    let is_below = product <= (twice + divisor) >> 1;
    let is_above = twice < divisor || product > (twice - divisor) >> 1 || quotient == end;
    let has_sign = quotient == 0 || (quotient < 0) == is_negative;
    is_below && is_above && has_sign
}

/// The halves of a product are the upper one, and what is left where a multiplication wraps.
#[unsafe(no_mangle)]
pub fn claim_product64(a: i32, b: i32) -> bool {
    let product = p::product64(a, b);
    product >> 32 == p::upper_signed(a, b) as i64 && product as u32 == a.wrapping_mul(b) as u32
}

/// Whether each component is from −4 to 4: those have code of their own where products are by halves.
fn is_short(v: &[Fixed; 3]) -> bool {
    v[0].is_short() && v[1].is_short() && v[2].is_short()
}

impl Fixed {
    fn is_short(self) -> bool {
        -4 * ONE <= self.0 && self.0 < 4 * ONE
    }
}

fn is_dot(a: [Fixed; 3], b: [Fixed; 3], product: fn(i32, i32) -> i64) -> bool {
    let product = |i: usize| product(a[i].0, b[i].0) as i128;
    let steps = (product(0) + product(1) + product(2) + HALF as i128) >> 16;
    v::dot(&a, &b).0 as i128 == steps.clamp(i32::MIN as i128, i32::MAX as i128)
}

/// Σ ab is rounded once, to the nearest step, a tie goes up, and it saturates.
#[unsafe(no_mangle)]
pub fn claim_dot_of_short(a: i32, b: i32, c: i32, d: i32, e: i32, f: i32) -> bool {
    let [v, w] = [[Fixed(a), Fixed(b), Fixed(c)], [Fixed(d), Fixed(e), Fixed(f)]];
    !(is_short(&v) && is_short(&w)) || is_dot(v, w, exact)
}

#[unsafe(no_mangle)]
pub fn claim_dot_of_long(a: i32, b: i32, c: i32, d: i32, e: i32, f: i32) -> bool {
    let [v, w] = [[Fixed(a), Fixed(b), Fixed(c)], [Fixed(d), Fixed(e), Fixed(f)]];
    is_short(&v) && is_short(&w) || is_dot(v, w, p::product64)
}

/// What a direction is made of: the components, shifted up so that the largest is 2²⁹ or more, the upper half of their
/// square, and the reciprocal of its root, which is 2⁴³/√square.
#[cfg(not(target_arch = "arm"))]
#[inline(always)]
fn parts(v: [i32; 3]) -> Option<([i32; 3], i64, i32, u32)> {
    let [x, y, z] = v.map(|c| (c ^ c >> 31) as u32);
    let shift = (x | y | z | 1).leading_zeros() - 1 & !1;
    let [a, b, c] = [v[0] << shift, v[1] << shift, v[2] << shift];
    let is_whole = a >> shift == v[0] && b >> shift == v[1] && c >> shift == v[2];
    let is_large = |c: i32| c >= 1 << 29 || c <= -1 << 29;
    let upper_of_square = |c: i32| c as i64 * c as i64 >> 32;
    let square = upper_of_square(a) + upper_of_square(b) + upper_of_square(c);
    let pairs = (square as u32).leading_zeros() / 2;
    let root = reciprocal::reciprocal_root((square as u32) << 2 * pairs);
    let is_exact = (root << pairs) >> pairs == root && (square as u32) << 2 * pairs >= 1 << 30;
    let is_right = is_whole && is_exact && (is_large(a) || is_large(b) || is_large(c)) && square <= 3 << 30;
    is_right.then_some(([a, b, c], square, root << pairs, shift))
}

/// A component of a direction is the product of these, rounded down and then to the nearest step. That of the zero vector is z.
#[cfg(not(target_arch = "arm"))]
#[unsafe(no_mangle)]
pub fn claim_direction(x: i32, y: i32, z: i32) -> bool {
    let ([u, v, w], length) = v::unit_and_fine_length(&[Fixed(x), Fixed(y), Fixed(z)]);
    if x | y | z == 0 {
        return u.0 == 0 && v.0 == 0 && w.0 == ONE && length.0 == 0;
    }
    let Some(([a, b, c], _, root, _)) = parts([x, y, z]) else { return false };
    let component = |c: i32| (c as i64 * root as i64 >> 32) + (1 << 10) >> 11;
    u.0 as i64 == component(a) && v.0 as i64 == component(b) && w.0 as i64 == component(c)
}

/// A length is the root of the square, in units of 2^(5 − shift) steps, rounded down and then to the nearest step, or
/// to 2⁻¹⁵ steps if it is below 1, which its sign says. It ends near the largest number.
#[cfg(not(target_arch = "arm"))]
#[unsafe(no_mangle)]
pub fn claim_length(x: i32, y: i32, z: i32) -> bool {
    let (_, length) = v::unit_and_fine_length(&[Fixed(x), Fixed(y), Fixed(z)]);
    if x | y | z == 0 {
        return length.0 == 0;
    }
    let Some((_, square, root, shift)) = parts([x, y, z]) else { return false };
    let units = p::upper(square as u32, root as u32) as u64;
    let is_short = units << 5 >> shift < 1 << 16;
    let finer = units << if is_short { 20 } else { 5 };
    let rounded = (finer + (1 << shift >> 1)) >> shift;
    let end = i32::MAX as u64 >> 5 << 5;
    let magnitude = if length.0 < 0 { -(length.0 as i64) } else { length.0 as i64 } as u64;
    (length.0 < 0) == is_short && (magnitude == rounded || !is_short && rounded > end && magnitude >= end)
}

/// What arrives from a lamp without a range is not negative, for any checked attenuation, distance and intensity.
#[cfg(not(target_arch = "arm"))]
#[unsafe(no_mangle)]
pub fn claim_arrives(a: i32, b: i32, c: i32, q: i32, intensity: i32) -> bool {
    let is_checked = (a | b | c) > 0;
    if !is_checked || intensity < 0 || q << 1 == 0 {
        return true;
    }
    let mut v = [Fixed(intensity); 3];
    falloff::Factor::of(Fixed(a), Fixed(b), Fixed(c), Fixed(q)).scale(&mut v);
    v[0].0 >= 0
}
