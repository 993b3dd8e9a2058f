//! The board: text and the exit status through the debugger, an instruction counter, and the depth of the stack.

use core::arch::asm;
use core::hint::black_box;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::{print, println, process::exit};

/// A program that prints numbers.
#[macro_export]
macro_rules! program {
    ($($number:expr),+) => {
        #[firmware::board::entry]
        fn main() -> ! {
            $(firmware::board::print!("{} ", $number);)+
            firmware::board::println!();
            firmware::board::exit(0)
        }

        #[panic_handler]
        fn panic(info: &core::panic::PanicInfo) -> ! {
            firmware::board::println!("{info}");
            firmware::board::exit(1)
        }
    };
}

/// Counts with SysTick: under `-icount`, QEMU's clock advances by the same step for each
/// instruction, and the core's timer counts that clock, down, in 24 bits.
#[cfg(target_arch = "arm")]
mod counter {
    const CONTROL: *mut u32 = 0xe000_e010 as *mut u32;
    const RELOAD: *mut u32 = 0xe000_e014 as *mut u32;
    const CURRENT: *mut u32 = 0xe000_e018 as *mut u32;
    const WIDTH: u32 = 0x00ff_ffff;

    /// Enabled, driven by the core clock, without an interrupt.
    pub fn start() {
        // SAFETY: these registers are in every Cortex-M, and nothing else here uses them.
        unsafe {
            RELOAD.write_volatile(WIDTH);
            CURRENT.write_volatile(0);
            CONTROL.write_volatile(0b101);
        }
        while now() == WIDTH {} // it counts from the next reload on
    }

    #[inline(always)]
    pub fn now() -> u32 {
        // SAFETY: as in `start`.
        WIDTH - unsafe { CURRENT.read_volatile() }
    }

    pub fn since(start: u32) -> u32 {
        now().wrapping_sub(start) & WIDTH
    }
}

/// Counts with the core's own counter.
#[cfg(target_arch = "riscv32")]
mod counter {
    pub fn start() {}

    #[inline(always)]
    pub fn now() -> u32 {
        let retired;
        // SAFETY: every RISC-V core has this counter, and reading it changes nothing.
        unsafe { core::arch::asm!("csrr {}, minstret", out(reg) retired, options(nomem, nostack)) }
        retired
    }

    pub fn since(start: u32) -> u32 {
        now().wrapping_sub(start)
    }
}

/// Counts the instructions of pieces of work.
pub struct Stopwatch {
    /// The ticks of no work, and of a thousand instructions.
    nothing: u32,
    thousand: u32,
    ticks: u64,
}

impl Stopwatch {
    pub fn start() -> Self {
        counter::start();
        let nothing = ticks(|| {});
        let thousand = ticks(thousand_instructions) - nothing;
        Self {
            nothing,
            thousand,
            ticks: 0,
        }
    }

    /// Counts one piece of work, the call included. The timer of an Arm core wraps: QEMU's `-icount
    /// shift=10` lets it count half a million instructions, and `shift=7` five million.
    #[inline(always)]
    pub fn count(&mut self, work: impl FnOnce()) {
        self.ticks += u64::from(ticks(work).wrapping_sub(self.nothing));
    }

    pub fn instructions(&self) -> u64 {
        let thousand = u64::from(self.thousand);
        (self.ticks * 1000 + thousand / 2) / thousand
    }
}

#[inline(always)]
fn ticks(work: impl FnOnce()) -> u32 {
    let start = black_box(counter::now());
    work();
    black_box(counter::since(start))
}

/// How many instructions `work` takes.
pub fn instructions(work: impl FnOnce()) -> u32 {
    let mut stopwatch = Stopwatch::start();
    stopwatch.count(work);
    stopwatch.instructions() as u32
}

#[inline(never)]
fn thousand_instructions() {
    // SAFETY: the instructions do nothing. Compressed or not, each counts as one.
    unsafe { asm!(".rept 1000", "nop", ".endr", options(nomem, nostack)) }
}

/// How many bytes of stack the one function that `work` calls takes, measured by painting the
/// memory below the stack pointer. This function is inlined, so the stack pointer is the caller's,
/// and the caller's own frame does not count.
#[inline(always)]
pub fn stack(work: impl FnOnce()) -> usize {
    const PAINT: u32 = 0xa5a5_5a5a;
    const WORDS: usize = 512;
    let top: *mut u32;
    // SAFETY: this only reads a register.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!("mov {}, sp", out(reg) top, options(nomem, nostack))
    }
    #[cfg(target_arch = "riscv32")]
    unsafe {
        asm!("mv {}, sp", out(reg) top, options(nomem, nostack))
    }
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
