//! Prints the digests on the machine that builds it.

use firmware::digest;

fn main() {
    let [single, double, fixed] = [digest::single(), digest::double(), digest::fixed()];
    println!("{single:016x}-{double:016x}-{fixed:016x}");
}
