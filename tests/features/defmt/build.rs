//! Links the tests as the program of a microcontroller is linked: the texts of log lines get numbers.

fn main() {
    println!("cargo::rerun-if-changed=linux.x");
    println!(
        "cargo::rustc-link-arg-tests=-T{}/linux.x",
        env!("CARGO_MANIFEST_DIR")
    );
    println!("cargo::rustc-link-arg-tests=-no-pie"); // the numbers are addresses
}
