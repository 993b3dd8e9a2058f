//! Prints the digest in fixed point.
#![no_std]
#![no_main]

use firmware::{board, digest};

#[board::entry]
fn main() -> ! {
    board::println!("{:016x}", digest::fixed());
    board::done()
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
