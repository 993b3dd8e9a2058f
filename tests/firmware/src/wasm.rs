//! The digests as functions of a WebAssembly module.
#![no_std]

use firmware::digest;

#[unsafe(no_mangle)]
extern "C" fn single() -> u64 {
    digest::single()
}

#[unsafe(no_mangle)]
extern "C" fn double() -> u64 {
    digest::double()
}

#[unsafe(no_mangle)]
extern "C" fn fixed() -> u64 {
    digest::fixed()
}

#[cfg(target_family = "wasm")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    core::arch::wasm32::unreachable()
}
