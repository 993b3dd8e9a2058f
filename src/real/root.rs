//! Square roots and quotients. This is the only file with unsafe code, apart from the `bytemuck` feature.
//!
//! IEEE 754 requires a correctly rounded root, so an instruction and a software routine give the
//! same bits. `libm`'s roots are the best choice except on two kinds of processors:
//!
//! - **x86-64.** `libm` emits the SSE instruction as assembly code, which stays an SSE instruction
//!   in a build for AVX. Switching between the two made a sum over lights ten times slower on an
//!   Intel processor. The compiler turns the intrinsic into the instruction that fits the build.
//! - **Arm with an FPU.** `libm` computes the root in software, in 55 instructions.

use core::ops::Div;

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(crate) use x86_64::{dividedf, sqrt, sqrtf};

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[allow(unsafe_code)]
mod x86_64 {
    use core::arch::x86_64::{
        _mm_cvtsd_f64, _mm_cvtss_f32, _mm_div_ps, _mm_set_sd, _mm_set_ss, _mm_set1_ps, _mm_setr_ps,
        _mm_sqrt_sd, _mm_sqrt_ss,
    };

    #[inline]
    pub(crate) fn sqrtf(x: f32) -> f32 {
        // SAFETY: This is compiled only for processors with SSE2.
        unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
    }

    #[inline]
    pub(crate) fn sqrt(x: f64) -> f64 {
        // SAFETY: This is compiled only for processors with SSE2.
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }

    /// Three quotients by one instruction, where the compiler would take two. The order of the lanes
    /// lets it keep x and y side by side, as it loads them.
    #[inline(always)]
    pub(crate) fn dividedf([x, y, z]: [f32; 3], divisor: f32) -> [f32; 3] {
        // SAFETY: This is compiled only for processors with SSE2. Four numbers in a register are four
        // numbers in an array.
        let [z, _, x, y]: [f32; 4] = unsafe {
            let quotients = _mm_div_ps(_mm_setr_ps(z, 1.0, x, y), _mm_set1_ps(divisor));
            core::mem::transmute(quotients)
        };
        [x, y, z]
    }
}

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(crate) use divided as dividedf;
#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(crate) use libm::sqrt;

/// Three numbers divided by one.
#[inline(always)]
pub(crate) fn divided<T: Copy + Div<Output = T>>([x, y, z]: [T; 3], divisor: T) -> [T; 3] {
    [x / divisor, y / divisor, z / divisor]
}

#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "arm", target_abi = "eabihf")
)))]
pub(crate) use libm::sqrtf;

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(crate) fn sqrtf(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // The compiler passes floating-point registers to assembly code only if the FPU has double
    // precision, and the Cortex-M4's has not. The number is therefore passed through a core
    // register.
    //
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
#[allow(
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]
pub(crate) const fn const_sqrtf(x: f32) -> f32 {
    // x = n 2^(2h), where n has 53 or 54 bits
    let exponent = (x.to_bits() >> 23) as i32 - 127 - 23 - 29;
    let n = ((x.to_bits() & 0x007F_FFFF | 0x0080_0000) as u64) << (29 + (exponent & 1));
    let root = n.isqrt();
    let sticky = (root * root != n) as u64;
    (root | sticky) as f32 * f32::from_bits(((127 + (exponent >> 1)) as u32) << 23)
}

/// The same in double precision.
#[allow(
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]
pub(crate) const fn const_sqrt(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52) as i64 - 1023 - 52 - 59;
    let n = ((x.to_bits() & ((1 << 52) - 1) | 1 << 52) as u128) << (59 + (exponent & 1));
    let root = n.isqrt();
    let sticky = (root * root != n) as u128;
    (root | sticky) as f64 * f64::from_bits(((1023 + (exponent >> 1)) as u64) << 52)
}
