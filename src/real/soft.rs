//! Floats where each operation is a call. The results have the bits of the operations that they replace.

/// Whether a comparison of floats is a call, so that one of their bits is shorter.
pub(super) const SOFT: bool = cfg!(any(
    all(target_arch = "arm", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", not(target_feature = "f"))
));

macro_rules! soft {
    ($float:ident $integer:ident) => {
        pub(super) mod $float {
            /// x > other, by a comparison of bits: the order of numbers is that of their bits, with NaN
            /// at both ends.
            #[inline]
            #[allow(clippy::cast_possible_wrap)] // only the bits matter
            pub(in crate::real) fn above(x: $float, other: $float) -> bool {
                if other.to_bits() == 0 {
                    // a constant, as a rule; neither 0, nor NaN, nor negative
                    return x.to_bits().wrapping_sub(1) < $float::INFINITY.to_bits();
                }
                let order = |x: $float| {
                    let bits = x.to_bits() as $integer;
                    let sign = bits >> ($integer::BITS - 1);
                    (bits ^ (sign & $integer::MAX)) - sign
                };
                let (x, than, infinity) = (order(x), order(other), order($float::INFINITY));
                x > than && x <= infinity && than >= -infinity
            }

            /// [`by_squaring`](crate::real::by_squaring) without the product with 1.
            #[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
            #[inline]
            pub(in crate::real) fn whole_power(mut base: $float, mut m: u32) -> $float {
                if m == 0 {
                    return 1.0;
                }
                while m & 1 == 0 {
                    base = base * base;
                    m >>= 1;
                }
                let mut power = base;
                while m > 1 {
                    base = base * base;
                    m >>= 1;
                    if m & 1 == 1 {
                        power = power * base;
                    }
                }
                power
            }
        }
    };
}

soft!(f32 i32);
soft!(f64 i64);
