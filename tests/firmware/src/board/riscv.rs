//! Counts instructions with the core's own counter.

use core::arch::asm;

pub fn start() {}

/// The instructions so far.
#[inline(always)]
pub fn now() -> u32 {
    let retired;
    // SAFETY: every RISC-V core has this counter, and reading it changes nothing.
    unsafe { asm!("csrr {}, minstret", out(reg) retired, options(nomem, nostack)) }
    retired
}

pub fn since(start: u32) -> u32 {
    now().wrapping_sub(start)
}

/// Takes as many instructions as its name says.
#[inline(never)]
pub fn thousand_instructions() {
    // SAFETY: the instructions do nothing. Compressed or not, each counts as one.
    unsafe { asm!(".rept 1000", "nop", ".endr", options(nomem, nostack)) }
}

/// The current end of the stack.
#[inline(always)]
pub fn stack_pointer() -> *mut u32 {
    let pointer;
    // SAFETY: this only reads a register.
    unsafe { asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack)) }
    pointer
}
