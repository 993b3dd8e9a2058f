//! Counts instructions with SysTick: under `-icount`, QEMU's clock advances by the same step for
//! each instruction, and the core's timer counts that clock.

use core::arch::asm;
use core::ptr::{read_volatile, write_volatile};

const CONTROL: *mut u32 = 0xe000_e010 as *mut u32;
const RELOAD: *mut u32 = 0xe000_e014 as *mut u32;
const CURRENT: *mut u32 = 0xe000_e018 as *mut u32;
const WIDTH: u32 = 0x00ff_ffff; // the timer has 24 bits

/// Starts the timer: enabled, driven by the core clock, without an interrupt.
pub fn start() {
    // SAFETY: these registers are in every Cortex-M, and nothing else here uses them.
    unsafe {
        write_volatile(RELOAD, WIDTH);
        write_volatile(CURRENT, 0);
        write_volatile(CONTROL, 0b101);
    }
    while now() == WIDTH {} // it counts from the next reload on
}

/// The ticks so far, which wrap at 24 bits.
#[inline(always)]
pub fn now() -> u32 {
    // SAFETY: as in `start`. The timer counts down.
    WIDTH - unsafe { read_volatile(CURRENT) }
}

pub fn since(start: u32) -> u32 {
    now().wrapping_sub(start) & WIDTH
}

/// Takes as many instructions as its name says.
#[inline(never)]
pub fn thousand_instructions() {
    // SAFETY: the instructions do nothing.
    unsafe { asm!(".rept 1000", "nop", ".endr", options(nomem, nostack)) }
}

/// The current end of the stack.
#[inline(always)]
pub fn stack_pointer() -> *mut u32 {
    let pointer;
    // SAFETY: this only reads a register.
    unsafe { asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack)) }
    pointer
}
