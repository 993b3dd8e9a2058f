//! Puts the memory map of the target where the linker finds it.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
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
