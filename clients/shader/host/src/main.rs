//! Runs the kernels on a Vulkan device and compares every number with the CPU's:
//! `host MODULE FOLDER [DEVICE]`. It exits with 1 where they differ by more than docs/shader.md states.

mod inputs;
mod module;
mod picture;
mod still_life;
mod tally;
mod vulkan;

use std::error::Error;
use std::path::Path;
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use bytemuck::Zeroable;
use kernel::buffers::{Point, Reflected};
use kernel::functions::{NAMES, Output, call};
use kernel::{BLINN_PHONG, INTEGER, LAMBERT, PHONG, shaded};

use picture::Picture;
use tally::Tally;
use vulkan::Gpu;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// What docs/shader.md derives for drivers that Vulkan allows to be less exact than the CPU: the difference of a
/// number of the scene, and that of a quotient or root in units in the last place.
const SCENE_BOUND: f32 = 1.0 / 2048.0;
const DRIVER_BOUND: u64 = 9;

/// Pixels of each of the four pictures, and samples along each side of a pixel.
const SIZE: [usize; 2] = [200, 125];
const SAMPLES: usize = 4;

/// Functions that neither divide nor take a root, and so have the CPU's bits on every device.
const WITHOUT_DIVISION: [&str; 6] = [
    "reflection",
    "term::ambient",
    "term::lambert",
    "normal::facing",
    "DirectionalLight::at",
    "DirectionalLight::in_front",
];

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (module, folder, device) = match &arguments[..] {
        [module, folder] => (module, folder, 0),
        [module, folder, device] => (module, folder, device.parse()?),
        _ => return Err("usage: host MODULE FOLDER [DEVICE]".into()),
    };
    let gpu = Gpu::new(
        device,
        &bytemuck::allocation::pod_collect_to_vec(&fs::read(module)?),
    )?;
    println!("device: {}; {:?}", gpu.name, gpu.controls);
    fs::create_dir_all(folder)?;

    let is_exact = functions(&gpu)?;
    still_life(&gpu, is_exact, Path::new(folder))
}

/// Compares every function on random inputs. Returns whether the driver rounds ÷ and √ correctly.
fn functions(gpu: &Gpu) -> Result<bool> {
    const BATCH: usize = 1 << 16;
    const BATCHES: usize = 16;
    println!("\nevery function, {} times:", BATCH * BATCHES);
    let mut inputs = gpu.buffer(BATCH)?;
    let mut outputs = gpu.buffer::<Output>(BATCH)?;
    let mut kernels = Vec::new();
    for function in 0..NAMES.len() as u32 {
        kernels.push(gpu.kernel(
            "vulkan::one_function",
            function,
            &[(&inputs).into(), (&outputs).into()],
        )?);
    }
    let mut tallies: Vec<Tally> = NAMES.iter().map(|_| Tally::default()).collect();
    let mut expected = vec![Output::zeroed(); BATCH];
    for seed in 0..BATCHES as u64 {
        inputs
            .numbers()
            .copy_from_slice(&inputs::random(seed, BATCH));
        for (function, (kernel, tally)) in (0..).zip(kernels.iter().zip(&mut tallies)) {
            gpu.run(kernel, BATCH)?;
            on_all_cores(inputs.numbers(), &mut expected, |input| {
                call(function, input)
            });
            tally.compare(
                bytemuck::cast_slice(outputs.numbers()),
                bytemuck::cast_slice(&expected),
            );
        }
    }
    for (name, tally) in NAMES.iter().zip(&tallies) {
        println!("{name}: {tally}");
    }
    // the first is the driver's own division and root
    let is_exact = tallies[0].is_exact();
    println!("the driver rounds ÷ and √ correctly: {is_exact}");
    if tallies[0].units > DRIVER_BOUND {
        return Err("÷ or √ is less exact than Vulkan allows".into());
    }
    for (name, tally) in NAMES.iter().zip(&tallies) {
        if (is_exact || WITHOUT_DIVISION.contains(name)) && !tally.is_exact() {
            return Err(format!("{name} differs from the CPU").into());
        }
    }
    Ok(is_exact)
}

/// Compares the gallery's scene, with every model, an integer m and a real m.
fn still_life(gpu: &Gpu, is_exact: bool, folder: &Path) -> Result<()> {
    let (pixels, points) = seen();
    println!("\nthe scene of four pictures, {} points:", points.len());

    let (materials, lights) = (still_life::materials(), still_life::lights());
    let mut outputs = gpu.buffer::<Reflected>(points.len())?;
    let buffers = [
        (&gpu.buffer_of(&points)?).into(),
        (&outputs).into(),
        (&gpu.buffer_of(&materials)?).into(),
        (&gpu.buffer_of(&lights)?).into(),
    ];
    let mut expected = vec![Reflected::zeroed(); points.len()];
    let ways = [
        ("Lambert", LAMBERT),
        ("Phong", PHONG),
        ("Phong, m an integer", PHONG + INTEGER),
        ("Blinn-Phong", BLINN_PHONG),
        ("Blinn-Phong, m an integer", BLINN_PHONG + INTEGER),
    ];
    let mut all = Tally::default();
    for (name, how) in ways {
        let kernel = gpu.kernel("vulkan::draw", how, &buffers)?;
        gpu.run(&kernel, points.len())?; // the first run compiles
        let on_gpu = gpu.run(&kernel, points.len())?;
        let on_cpu = |point: &Point| shaded(how, point, &materials, &lights).into();
        let on_one_core = timed(|| on_cores(1, &points, &mut expected, on_cpu));
        let on_cores = timed(|| on_all_cores(&points, &mut expected, on_cpu));
        let mut tally = Tally::default();
        for (point, (gpu, cpu)) in points.iter().zip(outputs.numbers().iter().zip(&expected)) {
            if is_exact || !still_life::is_on_horizon(point) {
                tally.compare(bytemuck::cast_slice(&[*gpu]), bytemuck::cast_slice(&[*cpu]));
            }
        }
        println!(
            "{name}: {tally}; {on_gpu:.1?}, one core {on_one_core:.1?}, {} cores {on_cores:.1?}",
            cores()
        );
        all.add(&tally);
    }
    println!("in all: {all}");

    // the last picture drawn
    let mut picture = Picture::new(SIZE);
    for ((pixel, point), (gpu, cpu)) in pixels
        .iter()
        .zip(&points)
        .zip(outputs.numbers().iter().zip(&expected))
    {
        let weight = still_life::visible(point) / (SAMPLES * SAMPLES) as f32;
        picture.add(*pixel, gpu, cpu, weight);
    }
    picture.write(&folder.join("shader.png"))?;

    if is_exact && !all.is_exact() || all.difference > SCENE_BOUND {
        return Err("the scene differs from the CPU's by more than docs/shader.md states".into());
    }
    Ok(())
}

/// The visible points, with their pixels.
fn seen() -> (Vec<usize>, Vec<Point>) {
    let [width, height] = SIZE.map(|side| side * SAMPLES);
    let places: Vec<usize> = (0..width * height).collect();
    let mut seen = vec![None; places.len()];
    on_all_cores(&places, &mut seen, |i| {
        let from_middle =
            |k: usize, side: usize| (k as f32 + 0.5 - 0.5 * side as f32) * 2.0 / width as f32;
        still_life::seen(
            from_middle(i % width, width),
            -from_middle(i / width, height),
        )
    });
    let pixel = |i: usize| i / width / SAMPLES * SIZE[0] + i % width / SAMPLES;
    let hits = (0..)
        .zip(seen)
        .filter_map(|(i, point)| Some((pixel(i), point?)));
    hits.unzip()
}

fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

fn on_all_cores<A: Sync, B: Send>(from: &[A], to: &mut [B], f: impl Fn(&A) -> B + Sync) {
    on_cores(cores(), from, to, f);
}

fn on_cores<A: Sync, B: Send>(cores: usize, from: &[A], to: &mut [B], f: impl Fn(&A) -> B + Sync) {
    let (share, f) = (from.len().div_ceil(cores).max(1), &f);
    thread::scope(|scope| {
        for (from, to) in from.chunks(share).zip(to.chunks_mut(share)) {
            scope.spawn(move || to.iter_mut().zip(from).for_each(|(to, from)| *to = f(from)));
        }
    });
}

fn timed(work: impl FnOnce()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}
