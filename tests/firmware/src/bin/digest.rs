//! Prints the digests of every function in `f32`, in `f64` and in fixed point: on the host and on a chip.
#![cfg_attr(target_os = "none", no_std, no_main)]

use firmware::digest;

#[cfg(target_os = "none")]
firmware::program!(digest::<f32>(), digest::<f64>(), FIXED());

#[cfg(not(target_os = "none"))]
fn main() {
    println!("{} {} {} ", digest::<f32>(), digest::<f64>(), FIXED());
}

#[cfg(feature = "fixed")]
const FIXED: fn() -> u64 = firmware::digest_of_fixed;
#[cfg(not(feature = "fixed"))]
const FIXED: fn() -> u64 = || 0;
