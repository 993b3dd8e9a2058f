//! Floor 0: the square root of an `f32`, and the one place where unsafe code is allowed.
//!
//! `libm` takes the root in software on Arm, in 55 instructions. A core with an FPU has an
//! instruction for it, which IEEE 754 requires to round correctly, as the software does: the bits
//! are the same. On every other target `libm` already is the instruction or the best there is.

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
pub(crate) use libm::sqrtf;

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(crate) fn sqrtf(x: f32) -> f32 {
    let root: f32;
    // SAFETY: the hard-float ABI is only for cores with an FPU, and every Arm FPU has
    // `vsqrt.f32`. It reads one register, writes one, and touches neither memory nor the stack.
    #[allow(unsafe_code)]
    unsafe {
        core::arch::asm!("vsqrt.f32 {}, {}", out(sreg) root, in(sreg) x,
            options(pure, nomem, nostack, preserves_flags));
    }
    root
}
