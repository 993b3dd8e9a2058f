//! Compiles the kernel to a SPIR-V module for Vulkan 1.2: `compiler MODULE`.

use std::error::Error;
use std::{env, fs};

use spirv_builder::SpirvBuilder;

fn main() -> Result<(), Box<dyn Error>> {
    let to = env::args().nth(1).ok_or("usage: compiler MODULE")?;
    let kernel = env!("CARGO_MANIFEST_DIR");
    // spirv-opt fuses products with sums, and factors constants out of sums
    let mut builder =
        SpirvBuilder::new(kernel, "spirv-unknown-vulkan1.2").extra_arg("--no-spirv-opt");
    builder.toolchain_overwrite = env::var("RUSTUP_TOOLCHAIN").ok(); // the one that runs this
    fs::copy(builder.build()?.module.unwrap_single(), to)?;
    Ok(())
}
