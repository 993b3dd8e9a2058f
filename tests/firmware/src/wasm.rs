//! The digest as a function of a WebAssembly module.
#![no_std]

#[unsafe(no_mangle)]
extern "C" fn digest() -> u64 {
    firmware::digest::everything()
}

#[cfg(target_family = "wasm")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    core::arch::wasm32::unreachable()
}
