//! Instructions by the core's own counter of them.

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

/// As many instructions as its name says.
#[inline(never)]
pub fn thousand_instructions() {
    // SAFETY: they do nothing. Compressed or not, each counts as one.
    unsafe { asm!(".rept 1000", "nop", ".endr", options(nomem, nostack)) }
}

/// Where the stack ends.
#[inline(always)]
pub fn stack_pointer() -> *mut u32 {
    let pointer;
    // SAFETY: it reads a register.
    unsafe { asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack)) }
    pointer
}
