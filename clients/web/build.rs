//! Turns the teapot's file into arrays: a program that reads decimal numbers is 20 KB larger.

use std::path::Path;
use std::{env, fs};

const FILE: &str = "../../examples/gallery/data/teapot.bezier";

fn main() {
    println!("cargo::rerun-if-changed={FILE}");
    let file = fs::read_to_string(FILE).expect("the teapot of the gallery");
    let array = |name, kind, element, suffix| {
        let lines = file.lines().filter_map(|line| line.strip_prefix(kind));
        let row = |line: &str| format!("[{}{suffix}]", line.replace(' ', &format!("{suffix}, ")));
        let rows: Vec<String> = lines.map(row).collect();
        format!(
            "static {name}: [{element}; {}] = [{}];\n",
            rows.len(),
            rows.join(", ")
        )
    };
    let points = array("POINTS", "v ", "[f32; 3]", "_f32");
    let patches = array("PATCHES", "p ", "[u16; 16]", "");
    let out = env::var_os("OUT_DIR").expect("cargo's folder");
    fs::write(Path::new(&out).join("teapot.rs"), points + &patches).expect("a file in it");
}
