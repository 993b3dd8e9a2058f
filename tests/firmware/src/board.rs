//! The board: text and the exit status by way of the debugger, and a count of instructions.

use core::panic::PanicInfo;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::println;

/// Ends the program as a success.
pub fn done() -> ! {
    semihosting::process::exit(0)
}

/// Reports a panic and ends the program as a failure.
pub fn fail(info: &PanicInfo) -> ! {
    println!("{info}");
    semihosting::process::exit(1)
}
