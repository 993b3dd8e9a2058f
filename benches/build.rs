//! Builds the peer in C, for the processor of this machine.

fn main() {
    println!("cargo:rerun-if-changed=c");
    cc::Build::new()
        .file("c/lanes.c")
        .opt_level_str("fast")
        .flag("-march=native")
        .debug(false)
        .compile("peer");
    // the power functions, for one number and for many at a time
    println!("cargo:rustc-link-lib=mvec");
    println!("cargo:rustc-link-lib=m");
}
