//! Calls one function of the table and nothing else. Compared with a program that calls `nothing`,
//! this program grows by the flash that the function takes, with everything that it pulls in. The
//! variable `MEASURED` names the function at build time, after `fixed: ` in fixed point.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::sync::atomic::AtomicU32;

use firmware::{board, broken};
use functions::{Given, row};
use shading::fixed::Fixed;

const MEASURED: &str = env!("MEASURED");

/// Keeps only the named call, and rejects a name that is not in the list at compile time.
macro_rules! measured {
    (
        ARITHMETIC: Number $arithmetic:tt SWEEPS: Number $sweeps:tt SERIES: Float $series:tt
        $($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*
    ) => {
        #[inline(never)]
        fn measured(given: &Given<f32>, fixed: &Given<Fixed>) {
            const { assert!($($(is_named("", $name) || is_named("fixed: ", $name) ||)*)* is_named("", "nothing")) }
            if const { is_named("", "nothing") } {
                keep(());
            }
            $($(
                if const { is_named("", $name) } {
                    keep(row::$row(given));
                }
                measured!(@fixed $bound $row $name fixed);
            )*)*
        }
    };
    (@fixed Number $row:ident $name:literal $given:ident) => {
        if const { is_named("fixed: ", $name) } {
            keep(row::$row($given));
        }
    };
    (@fixed Float $row:ident $name:literal $given:ident) => {};
}
functions::for_each_function!(measured);

/// Whether the measured function has this name, after this prefix.
const fn is_named(prefix: &str, name: &str) -> bool {
    let measured = MEASURED.as_bytes();
    let (prefix, name) = (prefix.as_bytes(), name.as_bytes());
    let mut i = 0;
    while i < measured.len() {
        let expected = if i < prefix.len() {
            prefix[i]
        } else if i < prefix.len() + name.len() {
            name[i - prefix.len()]
        } else {
            return false;
        };
        if measured[i] != expected {
            return false;
        }
        i += 1;
    }
    i == prefix.len() + name.len()
}

/// The arguments are zeros in RAM about which the compiler knows nothing.
#[board::entry]
fn main() -> ! {
    const SIZE: usize = size_of::<Given<f32>>();
    const { assert!(size_of::<Given<Fixed>>() == SIZE) };
    static MEMORY: [AtomicU32; SIZE / 4] = [const { AtomicU32::new(0) }; SIZE / 4];
    loop {
        let memory = black_box(MEMORY.as_ptr());
        // SAFETY: zeros are a valid value of every type in them, and nothing writes to them.
        unsafe { measured(&*memory.cast(), &*memory.cast()) };
    }
}

/// Keeps a result that would otherwise be optimized away.
#[inline(always)]
fn keep<T>(result: T) {
    black_box(&result);
    if size_of::<T>() > 0 {
        broken::promise(0.0);
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
