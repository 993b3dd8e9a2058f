//! Floor 0: the square roots, and the one place where unsafe code is allowed.
//!
//! IEEE 754 requires a root to be rounded correctly, so an instruction and software give the same
//! bits. Those of `libm` are the best there are, but on two processors:
//!
//! - **x86-64.** `libm` writes the instruction of SSE as assembly code. In a build for AVX it stays one
//!   of SSE, and a processor of Intel that goes from one to the other and back took ten times as
//!   long for a sum over lights. Of the intrinsic a compiler makes the instruction that fits.
//! - **Arm with an FPU.** `libm` takes the root in software, in 55 instructions.

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(crate) use x86_64::{sqrt, sqrtf};

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[allow(unsafe_code)]
mod x86_64 {
    use core::arch::x86_64::{
        _mm_cvtsd_f64, _mm_cvtss_f32, _mm_set_sd, _mm_set_ss, _mm_sqrt_sd, _mm_sqrt_ss,
    };

    #[inline]
    pub(crate) fn sqrtf(x: f32) -> f32 {
        // SAFETY: this is compiled for processors with SSE2 alone.
        unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
    }

    #[inline]
    pub(crate) fn sqrt(x: f64) -> f64 {
        // SAFETY: this is compiled for processors with SSE2 alone.
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }
}

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(crate) use libm::sqrt;

#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "arm", target_abi = "eabihf")
)))]
pub(crate) use libm::sqrtf;

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(crate) fn sqrtf(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // The compiler gives floating-point registers to assembly code only where the FPU has
    // doubles, and the Cortex-M4's has none. So the number comes and goes by a core register.
    //
    // SAFETY: the hard-float ABI is only for cores with an FPU, and every Arm FPU has
    // `vsqrt.f32`. It writes the two registers that are declared, and touches neither memory nor
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
