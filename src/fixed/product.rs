//! Products of 32 bits by 32 bits. A Cortex-M0 multiplies to 32 bits, and the compiler would call a
//! routine for 64, so each function is written twice: with the processor's [`long`] products, and
//! by [`halves`] of the factors.
//!
//! A test compares the two for every kind of argument, so this file uses nothing of the crate.

macro_rules! either {
    ($($(#[$doc:meta])* $name:ident($($argument:ident: $type:ty),*) -> $result:ty;)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub(super) const fn $name($($argument: $type),*) -> $result {
            if crate::target::NARROW_PRODUCT { halves::$name($($argument),*) } else { long::$name($($argument),*) }
        }
    )*};
}

either! {
    /// The whole product.
    product(a: i32, b: i32) -> i64;
    /// The whole product of unsigned numbers.
    product_unsigned(a: u32, b: u32) -> u64;
    /// The whole product with a number of at most 2¹⁶.
    product_by_fraction(a: u32, fraction: u32) -> u64;
    /// The product with a number of at most 2¹⁶, over 2¹⁶, rounded to the nearest.
    times_fraction(a: i32, fraction: i32) -> i32;
    /// The upper half of a product, rounded down.
    upper(a: i32, b: i32) -> i32;
    /// The upper half of a product of unsigned numbers, the second below 2³¹, rounded down.
    upper_unsigned(a: u32, b: u32) -> u32;
    /// The upper half of a product of unsigned numbers, rounded to the nearest.
    upper_rounded(a: u32, b: u32) -> u32;
}

/// How many bits of a number other than 0 are 0 before the first 1.
#[inline(always)]
pub(super) const fn zeros(bits: u32) -> u32 {
    if crate::target::COUNTS_ZEROS {
        bits.leading_zeros()
    } else {
        zeros_by_product(bits)
    }
}

/// One copy, by half as many instructions as the compiler's routine for a Cortex-M0 takes, and its inline code
/// for RISC-V. All bits after the first 1 become 1. The products of the factor with these 32 numbers differ in
/// their highest five bits, which find the count in the table.
///
/// Source: Sean Eron Anderson, *Bit Twiddling Hacks*, "Find the log base 2 of an N-bit integer in O(lg(N))
/// operations with multiply and lookup".
#[inline(never)]
pub const fn zeros_by_product(mut bits: u32) -> u32 {
    static ZEROS: [u8; 32] = [
        31, 22, 30, 21, 18, 10, 29, 2, 20, 17, 15, 13, 9, 6, 28, 1, 23, 19, 11, 3, 16, 14, 7, 24,
        12, 4, 8, 25, 5, 26, 27, 0,
    ];
    bits |= bits >> 1;
    bits |= bits >> 2;
    bits |= bits >> 4;
    bits |= bits >> 8;
    bits |= bits >> 16;
    ZEROS[(bits.wrapping_mul(0x07C4_ACDD) >> 27) as usize] as u32
}

/// By the processor's long products.
pub mod long {
    pub const fn product(a: i32, b: i32) -> i64 {
        a as i64 * b as i64
    }

    pub const fn product_unsigned(a: u32, b: u32) -> u64 {
        a as u64 * b as u64
    }

    pub const fn product_by_fraction(a: u32, fraction: u32) -> u64 {
        product_unsigned(a, fraction)
    }

    pub const fn times_fraction(a: i32, fraction: i32) -> i32 {
        ((product(a, fraction) + (1 << 15)) >> 16) as i32
    }

    pub const fn upper(a: i32, b: i32) -> i32 {
        (product(a, b) >> 32) as i32
    }

    pub const fn upper_unsigned(a: u32, b: u32) -> u32 {
        (product_unsigned(a, b) >> 32) as u32
    }

    pub const fn upper_rounded(a: u32, b: u32) -> u32 {
        ((product_unsigned(a, b) + (1 << 31)) >> 32) as u32
    }
}

/// By products of 16 bits by 16 bits, as on paper.
pub mod halves {
    // one copy, because each takes 50 bytes
    #[inline(never)]
    pub const fn product(a: i32, b: i32) -> i64 {
        (upper(a, b) as i64) << 32 | a.wrapping_mul(b) as u32 as i64
    }

    pub const fn product_unsigned(a: u32, b: u32) -> u64 {
        let upper = upper_unsigned(a, b).wrapping_add((b as i32 >> 31) as u32 & a);
        (upper as u64) << 32 | a.wrapping_mul(b) as u64
    }

    pub const fn product_by_fraction(a: u32, fraction: u32) -> u64 {
        // both fit 32 bits
        let (high, low) = ((a >> 16) * fraction, (a & 0xFFFF) * fraction);
        ((high as u64) << 16) + low as u64
    }

    pub const fn times_fraction(a: i32, fraction: i32) -> i32 {
        let (high, low) = (a >> 16, a as u32 & 0xFFFF);
        high * fraction + ((low * fraction as u32 + (1 << 15)) >> 16) as i32
    }

    pub const fn upper(a: i32, b: i32) -> i32 {
        let (a_1, a_0, b_1, b_0) = (a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF);
        let low = (a_0 as u32).wrapping_mul(b_0 as u32) >> 16;
        let middle = a_1 * b_0 + low as i32;
        let other = (a_0 * b_1).wrapping_add(middle & 0xFFFF);
        a_1 * b_1 + (middle >> 16) + (other >> 16)
    }

    /// The sign of a stands for 2³², which b takes part in. Without a sign, the compiler would see
    /// that this is the half of a product of 64 bits, and call the routine.
    pub const fn upper_unsigned(a: u32, b: u32) -> u32 {
        let product = upper(a as i32, b as i32) as u32;
        product.wrapping_add((a as i32 >> 31) as u32 & b)
    }

    pub const fn upper_rounded(a: u32, b: u32) -> u32 {
        let (a_1, a_0, b_1, b_0) = (a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF);
        // no sum exceeds 32 bits
        let middle = a_1 * b_0 + ((a_0 * b_0) >> 16);
        let other = a_0 * b_1 + (middle & 0xFFFF) + (1 << 15);
        a_1 * b_1 + (middle >> 16) + (other >> 16)
    }
}
