//! Prints the digests on the machine that builds it.

use firmware::digest;

fn main() {
    println!("{:016x}-{:016x}", digest::single(), digest::double());
}
