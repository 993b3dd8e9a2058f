//! The files of `languages/` at work: `gpu scene FOLDER` writes a scene of points and what the crate makes of it;
//! `gpu compare FILE exact|nearly` compares with it what another program has written; `gpu run [MODULE]` computes
//! every function and the scene on a Vulkan device, and the scene by a SPIR-V module, if one is named, and tries
//! the laws of local illumination on the files; `gpu laws PROGRAM [mistaken]` tries them on a program that shades
//! scenes; `gpu calls` prints a page's calls of every function in GLSL, and `gpu answers FILE exact|nearly` judges
//! their results; `gpu hlsl FOLDER exact|nearly` and `gpu metal FOLDER exact|nearly` compare every function in
//! these languages, with what they translate in a folder.

mod buffers;
#[path = "../../../languages/tests/support/mod.rs"]
mod draw;
mod gpu;
mod laws;
mod rows;
mod scene;
mod translated;

use std::borrow::Cow;
use std::error::Error;
use std::path::Path;
use std::{env, fs, process};

use wgpu::ShaderSource;

use buffers::{GpuLight, GpuMaterial};
use gpu::Gpu;
use rows::Power;
use scene::{SIZE, color, lights, material, points};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// What a shader reads: lights, a material and points.
fn inputs() -> [Vec<u8>; 3] {
    let lights: Vec<_> = lights().iter().map(GpuLight::from).collect();
    let material = GpuMaterial::from(&material());
    [
        bytemuck::cast_slice(&lights).to_vec(),
        bytemuck::bytes_of(&material).to_vec(),
        bytemuck::cast_slice(&points()).to_vec(),
    ]
}

/// What the crate makes of the scene, as red, green, blue and 1.
fn expected() -> Vec<f32> {
    let pixel = |color: shading::f32::Rgb| [color.r, color.g, color.b, 1.0];
    points()
        .iter()
        .flat_map(|point| pixel(color(point)))
        .collect()
}

/// Compares two pictures, and says how many numbers and how many levels of 8 bits differ.
fn compare(name: &str, found: &[f32], least_equal: usize) -> Result<()> {
    let expected = expected();
    if found.len() != expected.len() {
        return Err(format!("{name}: {} numbers, not {}", found.len(), expected.len()).into());
    }
    let level = |x: f32| (255.0 * x.clamp(0.0, 1.0)).round() as i32;
    let channels = || {
        found
            .chunks(4)
            .zip(expected.chunks(4))
            .flat_map(|(a, b)| (0..3).map(|i| (a[i], b[i])))
    };
    let (all, bits) = (
        channels().count(),
        channels().filter(|(a, b)| a == b).count(),
    );
    let levels = channels().filter(|(a, b)| level(*a) == level(*b)).count();
    let largest = channels().map(|(a, b)| (level(a) - level(b)).abs()).max();
    println!("{name}: of {all} numbers {bits} are equal, and {levels} as levels of 8 bits");
    if channels().filter(|(_, b)| *b > 0.0).count() < SIZE * SIZE {
        return Err("the picture is dark".into());
    }
    if levels < least_equal.min(all) || largest > Some(1) {
        return Err(format!("{name}: too few are equal").into());
    }
    Ok(())
}

/// Nearly all: where a device rounds ÷ and √ otherwise, one level in a thousand may be another.
const NEARLY_ALL: usize = 2 * SIZE * SIZE * 3 * 999 / 1000;
const ALL: usize = usize::MAX;

fn run(module: Option<&str>) -> Result<()> {
    let gpu = Gpu::new()?;
    println!("device: {}", gpu.name);
    let inputs = inputs();
    let inputs: Vec<&[u8]> = inputs.iter().map(Vec::as_slice).collect();
    let count = 2 * SIZE * SIZE;
    for (name, power) in [
        ("shading_exact.wgsl", Power::Own),
        ("shading.wgsl", Power::BuiltIn),
    ] {
        let file = &rows::of_file(name)?;
        println!("{name}");
        let source = format!("{file}{}", include_str!("../shaders/scene.wgsl"));
        let kernel = gpu.kernel(ShaderSource::Wgsl(source.into()));
        let colors = kernel.run(&inputs, count, 4);
        compare(
            name,
            &alpha(colors),
            if power == Power::Own { ALL } else { NEARLY_ALL },
        )?;
        rows::compare(&gpu, file, power)?;
        laws::of_file(&gpu, name, file)?;
    }
    if let Some(module) = module {
        let bytes = fs::read(module)?;
        let words = bytes
            .chunks_exact(4)
            .map(|word| u32::from_le_bytes(word.try_into().expect("four")));
        let source = ShaderSource::SpirV(Cow::from(words.collect::<Vec<_>>()));
        let colors = gpu.kernel(source).run(&inputs, count, 4);
        compare(module, &alpha(colors), ALL)?;
    }
    Ok(())
}

/// Where nothing is seen, a shader writes nothing.
fn alpha(mut colors: Vec<f32>) -> Vec<f32> {
    colors.chunks_mut(4).for_each(|pixel| pixel[3] = 1.0);
    colors
}

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match arguments[..] {
        ["scene", folder] => write(Path::new(folder)),
        ["compare", file, how] => read(file).and_then(|numbers| {
            compare(
                file,
                &numbers,
                if how == "exact" { ALL } else { NEARLY_ALL },
            )
        }),
        ["calls"] => {
            print!("{}", rows::calls());
            Ok(())
        }
        ["answers", file, how] => {
            read(file).and_then(|numbers| rows::judge_all(&numbers, Power::of(how)))
        }
        ["hlsl", folder, how] => translated::compare_hlsl(Path::new(folder), Power::of(how)),
        ["metal", folder, how] => translated::compare_metal(Path::new(folder), Power::of(how)),
        ["laws", program] => laws::of_program(program, false),
        ["laws", program, "mistaken"] => laws::of_program(program, true),
        ["run"] => run(None),
        ["run", module] => run(Some(module)),
        _ => {
            let compare = "gpu compare FILE exact|nearly";
            let laws = "gpu laws PROGRAM [mistaken]";
            let translated = "gpu hlsl|metal FOLDER exact|nearly";
            let calls = "gpu calls | gpu answers FILE exact|nearly";
            Err(format!(
                "usage: gpu scene FOLDER | {compare} | {calls} | {translated} | {laws} | gpu run [MODULE]"
            )
            .into())
        }
    };
    if let Err(error) = result {
        eprintln!("{error}");
        process::exit(1);
    }
}

fn read(file: &str) -> Result<Vec<f32>> {
    let bytes = fs::read(file).map_err(|error| format!("{file}: {error}"))?;
    Ok(bytes
        .chunks_exact(4)
        .map(|x| f32::from_le_bytes(x.try_into().expect("four")))
        .collect())
}

fn write(folder: &Path) -> Result<()> {
    fs::write(folder.join("scene.bin"), inputs().concat())?;
    Ok(())
}
