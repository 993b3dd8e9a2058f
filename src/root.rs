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
