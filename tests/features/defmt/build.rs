//! Links the tests in the way a microcontroller's program is linked: the strings of log lines
//! become numbers.

fn main() {
    println!("cargo::rerun-if-changed=linux.x");
    println!(
        "cargo::rustc-link-arg-tests=-T{}/linux.x",
        env!("CARGO_MANIFEST_DIR")
    );
    println!("cargo::rustc-link-arg-tests=-no-pie"); // the numbers are addresses
}
