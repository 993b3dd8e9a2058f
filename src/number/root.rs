//! The square root of floats. This is the only file with unsafe code, apart from the `bytemuck` feature.
//!
//! IEEE 754 requires a correctly rounded root, so an instruction and `libm`'s routine give the same
//! bits. `libm`'s are best except on x86-64, where they are assembly code that stays an SSE
//! instruction in a build for AVX (switching between the two made a sum ten times slower), and on Arm
//! with an FPU, where they take 55 instructions.

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(super) use libm::sqrt;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(super) use x86_64::{sqrt, sqrtf};

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[allow(unsafe_code)]
mod x86_64 {
    use core::arch::x86_64::{
        _mm_cvtsd_f64, _mm_cvtss_f32, _mm_set_sd, _mm_set_ss, _mm_sqrt_sd, _mm_sqrt_ss,
    };

    #[inline]
    pub(in crate::number) fn sqrtf(x: f32) -> f32 {
        // SAFETY: This is compiled only for processors with SSE2.
        unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
    }

    #[inline]
    pub(in crate::number) fn sqrt(x: f64) -> f64 {
        // SAFETY: This is compiled only for processors with SSE2.
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }
}

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(super) fn sqrtf(x: f32) -> f32 {
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

/// Without an FPU, each copy of the routine takes 230 bytes on a Cortex-M0.
#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "arm", target_abi = "eabihf")
)))]
#[inline]
pub(super) fn sqrtf(x: f32) -> f32 {
    #[inline(never)]
    fn called(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    let fpu = crate::target::FPU;
    if fpu { libm::sqrtf(x) } else { called(x) }
}

/// The correctly rounded root of a positive normal number, for constants. The integer root has at
/// least three bits more than the result. Its lowest bit is set: a root that is not exact lies above
/// the integer one, and an exact one has at most 27 bits, so that rounding drops the bit. Rounded
/// again, it is the correctly rounded root of an `f32`.
#[allow(
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]
pub(crate) const fn const_sqrt(x: f64) -> f64 {
    // x = n 2^(2h)
    let exponent = (x.to_bits() >> 52) as i64 - 1023 - 52 - 59;
    let n = ((x.to_bits() & ((1 << 52) - 1) | 1 << 52) as u128) << (59 + (exponent & 1));
    (n.isqrt() | 1) as f64 * f64::from_bits(((1023 + (exponent >> 1)) as u64) << 52)
}
