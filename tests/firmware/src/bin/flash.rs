//! Calls one function of the table and nothing else. Compared with a program that calls `nothing`,
//! this program grows by the flash that the function takes, with everything that it pulls in. The
//! variable `MEASURED` names the function at build time.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::sync::atomic::AtomicU32;

use kit::{Given, row};
use shading::fixed::Fixed;

const MEASURED: &str = env!("MEASURED");

/// Keeps only the named call, and rejects a name that is not in the table at compile time.
macro_rules! measured {
    ($($section:ident: $bound:ident {
        $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
    })*) => {
        #[inline(never)]
        fn measured(given: &Given<f32>) {
            const { assert!(is_named("nothing") || is_named(FIXED) $($(|| is_named($name))*)*) }
            $($(if const { is_named($name) } {
                black_box(&row::$row(given));
            })*)*
        }
    };
}
kit::for_each_function!(measured);

const FIXED: &str = "shade::blinn_phong, integer m, fixed point";

const fn is_named(name: &str) -> bool {
    let (measured, name) = (MEASURED.as_bytes(), name.as_bytes());
    let mut i = 0;
    while i < measured.len() && i < name.len() && measured[i] == name[i] {
        i += 1;
    }
    i == measured.len() && i == name.len()
}

/// The arguments are zeros in RAM about which the compiler knows nothing.
#[firmware::board::entry]
fn main() -> ! {
    static MEMORY: [AtomicU32; 512] = [const { AtomicU32::new(0) }; 512];
    const { assert!(size_of::<Given<f32>>() <= size_of_val(&MEMORY)) }
    loop {
        let memory = black_box(MEMORY.as_ptr());
        // SAFETY: zeros are a valid value of every type in them, and nothing writes to them.
        unsafe { measured(&*memory.cast()) };
        if const { is_named(FIXED) } {
            black_box(&row::shade_blinn_phong(unsafe {
                &*memory.cast::<Given<Fixed>>()
            }));
        }
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
