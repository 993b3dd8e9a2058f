//! Writes the files, and copies those for C into the library for Arduino.

use std::fs;
use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, text) in shading_languages::files() {
        fs::write(folder.join(name), text)?;
    }
    for name in ["shading.h", "shading_fixed.h"] {
        fs::copy(folder.join(name), folder.join("arduino/src").join(name))?;
    }
    Ok(())
}
