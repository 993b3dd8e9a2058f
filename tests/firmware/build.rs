//! Puts the memory map of the target where the linker finds it, and compiles the ball in C.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "c")]
    compile_ball();
    let variable = |name| env::var(name).map_err(io::Error::other);
    if variable("CARGO_CFG_TARGET_OS")? != "none" {
        return Ok(());
    }
    let map = format!("memory-{}.x", variable("CARGO_CFG_TARGET_ARCH")?);
    println!("cargo::rerun-if-changed={map}");
    let out = variable("OUT_DIR")?;
    fs::copy(&map, Path::new(&out).join("memory.x"))?;
    println!("cargo::rustc-link-search={out}");
    Ok(())
}

/// Compiles the headers' programs at the same level of optimization as the crate's.
#[cfg(feature = "c")]
fn compile_ball() {
    let (headers, example) = ("../../languages", "../../languages/arduino/examples/Ball");
    println!("cargo::rerun-if-changed={headers}/shading.h");
    println!("cargo::rerun-if-changed={headers}/shading_fixed.h");
    println!("cargo::rerun-if-changed={example}");
    println!("cargo::rerun-if-changed=src/ball");
    let mut build = cc::Build::new();
    // Debian's compiler for RISC-V has no library of its own
    if env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|target| target == "riscv32") {
        build.flag("--specs=picolibc.specs");
    }
    build
        .files(["src/ball/in_fixed.c", "src/ball/in_f32.c"])
        .include(headers)
        .include(example)
        .flag("-std=c99")
        .flag("-pedantic")
        .flag("-Wdouble-promotion")
        .warnings_into_errors(true)
        .flag("-ffp-contract=off")
        .flag("-fno-math-errno")
        .flag("-fno-trapping-math")
        .compile("ball");
}
