//! Prints the digest of every function in the number type that the variable `NUMBER` names at build
//! time: on the host and on a chip, whose flash does not hold all of them at once.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
firmware::program!(digest());

#[cfg(not(target_os = "none"))]
fn main() {
    println!("{} ", digest());
}

fn digest() -> u64 {
    match env!("NUMBER").as_bytes() {
        b"f32" => firmware::digest::<f32>(),
        b"f64" => firmware::digest::<f64>(),
        b"fixed" => firmware::digest_of_fixed(),
        _ => unreachable!("a number type"),
    }
}
