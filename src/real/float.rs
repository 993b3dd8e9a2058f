//! The floats, whose operations the processor or `libm` has. This is the only file with unsafe code,
//! apart from the `bytemuck` feature.

use super::Real;
#[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
use super::{Toward, length::toward};
#[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
use crate::triple::Vec3;

/// Whether a comparison of floats is a call, so that one of their bits is shorter.
const SOFT: bool = cfg!(any(
    all(target_arch = "arm", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", not(target_feature = "f"))
));

macro_rules! float {
    ($float:ident $integer:ident, $extreme:expr, $sqrt:path) => {
        #[diagnostic::do_not_recommend] // the trait's own message names the types
        impl Real for $float {
            type Mask = bool;
            type Sum = Self;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const NEG_ONE: Self = -1.0;
            const MAX: Self = $float::MAX;
            const EXTREME: Self = $extreme;

            #[inline]
            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            fn of(literal: f64) -> Self {
                literal as Self
            }

            #[inline]
            #[allow(clippy::useless_conversion)]
            fn of_f32(literal: f32) -> Self {
                literal.into()
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline]
            fn above(self, other: Self) -> bool {
                if !SOFT {
                    return self > other;
                }
                if other.to_bits() == 0 {
                    // a constant, as a rule; neither 0, nor NaN, nor negative
                    return self.to_bits().wrapping_sub(1) < $float::INFINITY.to_bits();
                }
                // the order of numbers is that of their bits, with NaN at both ends
                let order = |x: Self| {
                    let bits = x.to_bits().cast_signed();
                    let sign = bits >> ($integer::BITS - 1);
                    (bits ^ (sign & $integer::MAX)) - sign
                };
                let (x, than, infinity) = (order(self), order(other), order($float::INFINITY));
                x > than && x <= infinity && than >= -infinity
            }

            // the product with 1 is a call
            #[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
            #[inline]
            fn whole_power(mut self, mut m: u32) -> Self {
                if m == 0 {
                    return 1.0;
                }
                while m & 1 == 0 {
                    self = self * self;
                    m >>= 1;
                }
                let mut power = self;
                while m > 1 {
                    self = self * self;
                    m >>= 1;
                    if m & 1 == 1 {
                        power = power * self;
                    }
                }
                power
            }

            // A desktop computes the product anew while it waits for the root.
            #[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
            #[inline(always)]
            fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
                toward(n, v)
            }

            #[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
            #[inline(always)]
            fn cosine(_: Vec3<Self>, toward: &Toward<Self>) -> Self {
                let cosine = toward.n_dot_v / toward.way.w_length;
                cosine.at_least(0.0).at_most(1.0)
            }

            // Positive floats are ordered as their bits are, so one integer comparison replaces two.
            #[inline]
            fn any_outside(self, low: Self, high: Self) -> bool {
                let range = high.to_bits().wrapping_sub(low.to_bits());
                self.to_bits().wrapping_sub(low.to_bits()) >= range
            }
        }
    };
}

// 2^100 and 2^720, as their bits
float!(f32 i32, f32::from_bits((127 + 100) << 23), sqrtf);
float!(f64 i64, f64::from_bits((1023 + 720) << 52), sqrt);

// IEEE 754 requires a correctly rounded root, so an instruction and `libm`'s routine give the same
// bits. `libm`'s are best except on x86-64, where they are assembly code that stays an SSE
// instruction in a build for AVX (switching between the two made a sum ten times slower), and on Arm
// with an FPU, where they take 55 instructions.

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use self::x86_64::{sqrt, sqrtf};
#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
use libm::sqrt;
#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "arm", target_abi = "eabihf")
)))]
use libm::sqrtf;

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[allow(unsafe_code)]
mod x86_64 {
    use core::arch::x86_64::{
        _mm_cvtsd_f64, _mm_cvtss_f32, _mm_set_sd, _mm_set_ss, _mm_sqrt_sd, _mm_sqrt_ss,
    };

    #[inline]
    pub(super) fn sqrtf(x: f32) -> f32 {
        // SAFETY: This is compiled only for processors with SSE2.
        unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
    }

    #[inline]
    pub(super) fn sqrt(x: f64) -> f64 {
        // SAFETY: This is compiled only for processors with SSE2.
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }
}

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
fn sqrtf(x: f32) -> f32 {
    // The compiler passes floating-point registers to assembly code only if the FPU has double
    // precision, and the Cortex-M4's has not. The number therefore passes through a core register.
    let mut bits = x.to_bits();
    // SAFETY: The hard-float ABI exists only for cores with an FPU, and every Arm FPU has
    // `vsqrt.f32`. The code writes only the two declared registers. It touches neither memory nor
    // the stack nor the flags.
    #[allow(unsafe_code)]
    unsafe {
        core::arch::asm!(
            "vmov s0, {bits}",
            "vsqrt.f32 s0, s0",
            "vmov {bits}, s0",
            bits = inout(reg) bits,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags)
        );
    }
    f32::from_bits(bits)
}

/// The correctly rounded root of a positive normal number, for constants. The integer root has at
/// least three bits more than the result; its lowest bit also records whether the root is inexact.
/// Rounded again, it is the correctly rounded root of an `f32`.
#[allow(
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]
pub(crate) const fn const_sqrt(x: f64) -> f64 {
    // x = n 2^(2h)
    let exponent = (x.to_bits() >> 52) as i64 - 1023 - 52 - 59;
    let n = ((x.to_bits() & ((1 << 52) - 1) | 1 << 52) as u128) << (59 + (exponent & 1));
    let root = n.isqrt();
    let sticky = (root * root != n) as u128;
    (root | sticky) as f64 * f64::from_bits(((1023 + (exponent >> 1)) as u64) << 52)
}
