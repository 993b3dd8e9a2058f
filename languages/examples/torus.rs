//! A torus, written once: its distance and its exact normal in the language that you name, by default WGSL.

use shading::{Real, Vec3};
use shading_languages::dialect::{C, GLSL, HLSL, METAL, WGSL};
use shading_languages::implicit;

/// (√(x² + y²) − 2)² + z² − ¼
fn torus<T: Real>(p: Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

fn main() {
    let dialect = match std::env::args().nth(1).as_deref() {
        None | Some("wgsl") => &WGSL,
        Some("glsl") => &GLSL,
        Some("hlsl") => &HLSL,
        Some("metal") => &METAL,
        Some("c") => &C,
        Some(other) => {
            eprintln!("there is no language {other}; there are wgsl, glsl, hlsl, metal and c");
            std::process::exit(2);
        }
    };
    print!("{}", implicit(dialect, "torus", torus, torus));
}
