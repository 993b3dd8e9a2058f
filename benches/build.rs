//! Builds the peers in C: over arrays, for the processor of this machine; and one point after the
//! other, as it is written first.

fn main() {
    println!("cargo:rerun-if-changed=c");
    cc::Build::new()
        .file("c/lanes.c")
        .opt_level_str("fast")
        .flag("-march=native")
        .debug(false)
        .compile("peer");
    for (level, name) in [("2", "shade_o2"), ("fast", "shade_ofast")] {
        cc::Build::new()
            .file("c/points.c")
            .opt_level_str(level)
            .define("SHADE", name)
            .debug(false)
            .compile(name);
    }
    // the power functions, for one number and for many at a time
    println!("cargo:rustc-link-lib=mvec");
    println!("cargo:rustc-link-lib=m");
}
