//! The board: text and the exit status by way of the debugger, and a count of instructions.

use core::hint::black_box;
use core::panic::PanicInfo;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::println;

#[cfg_attr(target_arch = "arm", path = "board/arm.rs")]
#[cfg_attr(target_arch = "riscv32", path = "board/riscv.rs")]
mod counter;

/// Ends the program as a success.
pub fn done() -> ! {
    semihosting::process::exit(0)
}

/// Reports a panic and ends the program as a failure.
pub fn fail(info: &PanicInfo) -> ! {
    println!("{info}");
    semihosting::process::exit(1)
}

/// How many instructions `work` takes, its call included.
pub fn instructions(work: impl Fn()) -> u32 {
    let ticks = |work: &dyn Fn()| {
        let start = black_box(counter::now());
        work();
        black_box(counter::since(start))
    };
    counter::start();
    let nothing = ticks(&|| {});
    let thousand = ticks(&counter::thousand_instructions) - nothing;
    let ticks = ticks(&work) - nothing;
    (ticks * 1000 + thousand / 2) / thousand
}
