//! Thins the gallery's bunny out to a few hundred triangles: the vertices in one cell of a grid are replaced by
//! their mean.
//!
//! Source: Rossignac and Borrel, *Multi-resolution 3D approximations for rendering complex scenes*, 1993.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

const FILE: &str = "../../examples/gallery/data/bunny.obj";
const CELLS: f32 = 10.0;

fn main() {
    println!("cargo::rerun-if-changed={FILE}");
    let file = fs::read_to_string(FILE).expect("the bunny of the gallery");
    let lines = |kind| {
        file.lines()
            .filter_map(move |line| line.strip_prefix(kind))
            .map(str::split_whitespace)
    };
    let vertices: Vec<[f32; 3]> = lines("v ")
        .map(|mut words| {
            std::array::from_fn(|_| {
                words
                    .next()
                    .and_then(|word| word.parse().ok())
                    .expect("a number")
            })
        })
        .collect();
    let end = |axis: usize, choose: fn(f32, f32) -> f32| {
        vertices
            .iter()
            .map(|v| v[axis])
            .reduce(choose)
            .expect("a vertex")
    };
    let [low, high] = [f32::min as fn(f32, f32) -> f32, f32::max]
        .map(|choose| [0, 1, 2].map(|axis| end(axis, choose)));
    let size = (0..3).map(|i| high[i] - low[i]).fold(0.0, f32::max);

    let cell = |v: &[f32; 3]| [0, 1, 2].map(|i| ((v[i] - low[i]) / size * CELLS) as u16);
    let mut cells: BTreeMap<[u16; 3], ([f32; 3], f32)> = BTreeMap::new();
    for v in &vertices {
        let (sum, count) = cells.entry(cell(v)).or_default();
        // in the cube from −1 to 1
        (0..3).for_each(|i| sum[i] += (2.0 * v[i] - low[i] - high[i]) / size);
        *count += 1.0;
    }
    let number: BTreeMap<_, _> = cells.keys().zip(0_u16..).collect();
    let mut faces = BTreeSet::new();
    for words in lines("f ") {
        let index = |word: &str| {
            word.split('/')
                .next()
                .and_then(|word| word.parse::<usize>().ok())
                .expect("an index")
        };
        let face: Vec<u16> = words
            .map(|word| number[&cell(&vertices[index(word) - 1])])
            .collect();
        if let [a, b, c] = face[..]
            && a != b
            && b != c
            && c != a
        {
            // as one triangle, whichever corner comes first
            faces.insert(
                [[a, b, c], [b, c, a], [c, a, b]]
                    .into_iter()
                    .min()
                    .expect("three"),
            );
        }
    }
    let mut code = format!("pub static VERTICES: [Vec3; {}] = [", cells.len());
    for (sum, count) in cells.values() {
        let [x, y, z] = sum.map(|c| c / count);
        write!(code, "Vec3::new({x:?}, {y:?}, {z:?}), ").expect("a string");
    }
    write!(
        code,
        "];\npub static FACES: [[u16; 3]; {}] = {faces:?};",
        faces.len()
    )
    .expect("a string");
    let code = code.replace("= {[", "= [[").replace("]};", "]];");
    let out = env::var_os("OUT_DIR").expect("cargo's folder");
    fs::write(Path::new(&out).join("bunny.rs"), code).expect("a file in it");
    if env::var_os("CARGO_CFG_TARGET_OS").is_some_and(|system| system == "none") {
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
}
