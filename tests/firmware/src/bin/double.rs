//! Prints the digest in double precision. It is a separate program, since the two unoptimized
//! digests do not fit in 256 KiB.
#![no_std]
#![no_main]

use firmware::{board, digest};

#[board::entry]
fn main() -> ! {
    board::println!("{:016x}", digest::double());
    board::done()
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    board::fail(info)
}
