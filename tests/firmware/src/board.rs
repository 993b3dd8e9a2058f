//! The board: text and the exit status through the debugger, an instruction counter, and the depth
//! of the stack.

use core::hint::black_box;
use core::panic::PanicInfo;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::println;

#[cfg_attr(target_arch = "arm", path = "board/arm.rs")]
#[cfg_attr(target_arch = "riscv32", path = "board/riscv.rs")]
mod chip;

pub use chip::thousand_instructions;

/// Ends the program with success.
pub fn done() -> ! {
    semihosting::process::exit(0)
}

/// Reports a panic and ends the program with failure.
pub fn fail(info: &PanicInfo) -> ! {
    println!("{info}");
    semihosting::process::exit(1)
}

/// How many instructions `work` takes, including the call: fewer than four million.
pub fn instructions(work: impl Fn()) -> u32 {
    let [work, thousand] = ticks(work);
    (work * 1000 + thousand / 2) / thousand
}

/// The same for work of any length.
pub fn many_instructions(work: impl Fn()) -> u64 {
    let [work, thousand] = ticks(work).map(u64::from);
    (work * 1000 + thousand / 2) / thousand
}

/// How long `work` takes, and how long a thousand instructions take.
#[inline(always)]
fn ticks(work: impl Fn()) -> [u32; 2] {
    let ticks = |work: &dyn Fn()| {
        let start = black_box(chip::now());
        work();
        black_box(chip::since(start))
    };
    chip::start();
    let nothing = ticks(&|| {});
    let thousand = ticks(&chip::thousand_instructions) - nothing;
    [ticks(&work) - nothing, thousand]
}

/// How many bytes of stack are taken by the one function that `work` calls, measured by painting
/// the memory below the stack pointer. This function is inlined, so the stack pointer is the
/// caller's, and the caller's own frame does not count.
#[inline(always)]
pub fn stack(work: impl FnOnce()) -> usize {
    const PAINT: u32 = 0xa5a5_5a5a;
    const WORDS: usize = 512;
    let top = chip::stack_pointer();
    let mut depth = WORDS;
    // SAFETY: the memory below the stack pointer is unused, nothing interrupts, and nothing is
    // called before `work`.
    while depth > 0 {
        unsafe { top.wrapping_sub(depth).write_volatile(PAINT) };
        depth -= 1;
    }
    work();
    depth = WORDS;
    // SAFETY: as above.
    while depth > 0 && unsafe { top.wrapping_sub(depth).read_volatile() } == PAINT {
        depth -= 1;
    }
    depth * size_of::<u32>()
}
