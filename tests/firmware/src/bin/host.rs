//! Prints the digest, on the machine that builds it.

fn main() {
    println!("{:016x}", firmware::digest::everything());
}
