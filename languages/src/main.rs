//! Writes the files.

fn main() -> std::io::Result<()> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, text) in shading_languages::files() {
        std::fs::write(folder.join(name), text)?;
    }
    Ok(())
}
