//! Links anew where the memory of the chip is described anew.

fn main() {
    println!("cargo::rerun-if-changed=memory.x");
}
