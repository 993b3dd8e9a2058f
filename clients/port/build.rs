//! Takes the pipeline from the example `teapot` in the package of `euc`, as it is and with the ported
//! `frag.rs` in place of its formulas.

use std::{env, error::Error, fs, path::Path};

/// The text between two others, which it must contain.
fn cut<'a>(text: &'a str, from: &str, to: &str) -> Result<[&'a str; 3], Box<dyn Error>> {
    let start = text.find(from).ok_or_else(|| format!("no {from:?}"))?;
    let length = text[start..].find(to).ok_or_else(|| format!("no {to:?}"))?;
    Ok([
        &text[..start],
        &text[start..start + length],
        &text[start + length..],
    ])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=frag.rs");
    let packages = cargo_metadata::MetadataCommand::new().exec()?.packages;
    let euc = packages
        .iter()
        .find(|package| package.name.as_str() == "euc")
        .ok_or("no euc")?;
    let examples = euc.manifest_path.with_file_name("examples");
    println!(
        "cargo::rustc-env=TEAPOT={}",
        examples.join("data/teapot.obj")
    );

    let example = fs::read_to_string(examples.join("teapot.rs"))?;
    let [_, pipeline, _] = cut(&example, "struct Teapot<'a>", "const W: usize")?;
    let [before, _, after] = cut(pipeline, "    fn frag(", "        let color =")?;
    let ported = fs::read_to_string("frag.rs")?;
    let out = env::var("OUT_DIR")?;
    fs::write(Path::new(&out).join("before.rs"), pipeline)?;
    fs::write(
        Path::new(&out).join("after.rs"),
        [before, &ported, after].concat(),
    )?;
    Ok(())
}
