//! How long the crate takes beside the same by hand: on `glam`, on `wide`, in C and with the standard library.
//!
//! `cargo bench -p shading-benches --features peers --bench time` prints tables in Markdown; with `-- judge`, a
//! ratio above its limit is measured again, and is an error if it stays there. `-- quick` takes a
//! quarter of the time; `-- forms lanes` runs these tables alone.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

#[path = "time/brdf.rs"]
mod brdf;
#[path = "time/forms.rs"]
mod forms;
#[path = "time/growth.rs"]
mod growth;
#[path = "time/hand.rs"]
mod hand;
#[path = "time/lanes.rs"]
mod lanes;
#[path = "time/ours.rs"]
mod ours;
#[path = "time/peers.rs"]
mod peers;
#[path = "time/race.rs"]
mod race;
#[path = "time/rows.rs"]
mod rows;
#[path = "time/scene.rs"]
mod scene;

use race::{Races, pass};
use scene::{COUNTS, DATA, KINDS, LIGHTS, LOOPS, MODELS, WAYS};
use shading::{self as subject, Lobe};
use std::hint::black_box;
use std::process::{Command, ExitCode};

/// Set where the bench was built for the processor of this machine.
const NATIVE: &str = "SHADING_BENCH_NATIVE";

type Table = fn(&mut Races);

/// The tables by name.
const TABLES: [(&str, Table); 13] = [
    ("sums", sums),
    ("expert", expert),
    ("peers", peers),
    ("brdf", brdf),
    ("calls", calls),
    ("vec3a", vec3a),
    ("forms", forms),
    ("rows", rows),
    ("lanes", lanes),
    ("packed", packed),
    ("powers", powers),
    ("loops", loops),
    ("growth", growth),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let given = |word: &str| arguments.iter().any(|a| a == word);
    let all = !TABLES.iter().any(|(name, _)| given(name));
    let mut races = Races::new(if given("quick") { 0.05 } else { 0.2 }, given("judge"));
    println!("{}", processor());
    for (_, table) in TABLES.iter().filter(|(name, _)| all || given(name)) {
        table(&mut races);
    }
    races.report()
}

/// The name of the processor, and how busy it is.
fn processor() -> String {
    let read = |path| std::fs::read_to_string(path).unwrap_or_default();
    let (processors, load) = (read("/proc/cpuinfo"), read("/proc/loadavg"));
    let name = processors
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let load = load.split_whitespace().next().unwrap_or("unknown");
    format!(
        "{}, load {load}",
        name.map_or(std::env::consts::ARCH, |(_, name)| name)
    )
}

/// The sums in a loop, or by a call, beside a vector type of `glam`.
macro_rules! sums {
    ($races:ident, $call:literal, $expert:literal, $limit:literal, $($float:ident $hand:ident),*) => {$(
        for data in DATA {
            let scenes = COUNTS.map(|count| (scene::points(data, count), scene::lamps(count)));
            let ours = scenes.each_ref().map(|(points, lamps)| ours::$float::scene(points, lamps));
            let theirs = scenes.each_ref().map(|(points, lamps)| hand::$hand::scene(points, lamps));
            let both = |(ours, theirs)| [
                ours::$float::sums::<$call>(ours),
                hand::$hand::sums::<$call, $expert>(theirs),
            ];
            let name = |model| (format!("{} {model}, {data}", stringify!($float)), $limit);
            $races.rows(MODELS.map(name), ours.iter().zip(&theirs).map(both));
        }
    )*};
}

fn sums(races: &mut Races) {
    races.table("A sum in a loop, beside `glam`", &LIGHTS);
    sums!(races, false, false, 0.90, f32 vec3, f64 dvec3);
    races.mean(0.72, |row| !row.contains("m = 51"));
}

fn expert(races: &mut Races) {
    races.table("A sum in a loop, beside an expert's on `glam`", &LIGHTS);
    sums!(races, false, true, 1.0, f32 vec3, f64 dvec3);
    races.mean(0.85, |row| !row.contains("m = 51"));
}

/// Beside what a user would pick instead, in the loop of a newcomer.
fn peers(races: &mut Races) {
    races.table("Beside other vectors and C, 4 lights", &DATA);
    let scenes = DATA.map(|data| (scene::points(data, 4), scene::lamps(4)));
    let ours = scenes
        .each_ref()
        .map(|(points, lamps)| ours::f32::scene(points, lamps));
    let (whole, real) = (black_box(50), black_box(50.5));
    macro_rules! rows {
        ($name:literal, $index:literal, |$c:ident| $power:expr, $m:expr) => {
            for peer in 0..peers::COUNT {
                let mut name = String::new();
                let mut pairs = Vec::new();
                for ((points, lamps), ours) in scenes.iter().zip(&ours) {
                    let mut sums = Vec::from(ours::f32::sums::<false>(ours));
                    let mut all = Vec::from(peers::peers(points, lamps, |$c: f32| $power, $m));
                    let (title, theirs) = all.swap_remove(peer);
                    name = format!("{}, {title}", $name);
                    pairs.push([sums.swap_remove($index), theirs]);
                }
                races.row(&name, 1.0, pairs);
            }
        };
    }
    rows!("m = 50", 0, |c| c.powi(whole), 50.0);
    rows!("m = 50.5", 2, |c| c.powf(real), 50.5);
}

/// A reflection of the user's own.
fn brdf(races: &mut Races) {
    races.table("GGX over 4 lamps, beside an expert's", &["in a loop"]);
    for data in DATA {
        brdf::both(&scene::points(data, 4), &scene::lamps(4), |pair| {
            races.row(&format!("f32, {data}"), 1.02, [pair]);
        });
    }
}

/// Rows of pixels in lanes, beside ours one by one.
fn rows(races: &mut Races) {
    let native = cfg!(target_feature = "avx2");
    let (title, limit) = if native {
        (
            "A row of pixels in `f32x8`, beside the same loop over pixels, AVX2",
            0.2,
        )
    } else {
        (
            "A row of pixels in `f32x8`, beside the same loop over pixels, SSE2",
            0.33,
        )
    };
    let tolerance = std::mem::replace(&mut races.tolerance, 1e-13); // the bits are equal
    races.table(title, &["4 lights"]);
    for data in DATA {
        let (points, lamps) = (scene::points(data, 4), scene::lamps(4));
        rows::both(&points, &lamps, 50_u32, |pair| {
            races.row(&format!("m = 50, {data}"), limit, [pair]);
        });
        rows::both(&points, &lamps, 50.5_f32, |pair| {
            races.row(&format!("m = 50.5, {data}"), limit, [pair]);
        });
    }
    races.tolerance = tolerance;
}

fn growth(_: &mut Races) {
    growth::print();
}

fn calls(races: &mut Races) {
    races.table("A sum by a call, beside `glam`", &LIGHTS);
    sums!(races, true, false, 0.95, f32 vec3, f64 dvec3);
}

fn vec3a(races: &mut Races) {
    races.table("A sum in a loop, beside `glam::Vec3A`", &LIGHTS);
    sums!(races, false, false, 1.0, f32 vec3a);
}

fn forms(races: &mut Races) {
    races.table("Forms of lights, beside `glam`", &["in a loop"]);
    for data in DATA {
        forms::f32::race(races, data, &scene::points(data, 4), &scene::lamps(4));
        forms::f64::race(races, data, &scene::points(data, 4), &scene::lamps(4));
    }
}

/// Builds this bench again for the processor of this machine, and races eight points in lanes there.
fn lanes(races: &mut Races) {
    if std::env::var_os(NATIVE).is_none() {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["bench", "--quiet", "--bench", "time", "--", "lanes", "rows"]);
        let words = ["quick", "judge"];
        cargo.args(std::env::args().filter(|a| words.contains(&a.as_str())));
        cargo
            .env(NATIVE, "")
            .env("RUSTFLAGS", "-C target-cpu=native");
        cargo.env("CARGO_TARGET_DIR", "../target/native");
        let status = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).status();
        if !status.is_ok_and(|status| status.success()) {
            races
                .misses
                .push("the lanes for this processor failed".to_owned());
        }
        return;
    }
    let (points, positions) = (scene::points("cube", 4), scene::lamps(4));
    let (_, lamps) = ours::f32::scene(&points, &positions);
    let lanes = lanes::eight_points(&points);
    let real = || lanes::ours(&lanes, &lamps, ours::f32::material(50.5));
    let integer = lanes::ours(&lanes, &lamps, ours::f32::material(50));
    let in_c = |m| lanes::in_c(&points, &positions, m);
    races.table("Eight points in lanes, for this processor", &["4 lights"]);
    let by_hand = lanes::by_hand(&lanes, &positions, 50.5);
    races.row("m = 50.5, beside `wide` by hand", 0.72, [[real(), by_hand]]);
    races.row("m = 50.5, beside C", 0.25, [[real(), in_c(50.5)]]);
    races.row("m = 50, beside C", 0.20, [[integer, in_c(50.0)]]);
}

fn packed(races: &mut Races) {
    races.table("Lights in lanes, beside `glam`", &["in a loop"]);
    macro_rules! packed {
        ($float:ident $hand:ident, $($lanes:ident * $count:literal: $real:literal $integer:literal),*) => {$(
            let (points, positions) = (scene::points("cube", $count), scene::lamps($count));
            let (listed, lamps) = ours::$float::scene(&points, &positions);
            let theirs = hand::$hand::scene(&points, &positions);
            let [integer, _, real, _] = hand::$hand::sums::<false, false>(&theirs);
            let name = |m| format!("m = {m}, {} lights in {}", $count, stringify!($lanes));
            let pack = lanes::packed::<wide::$lanes, _>(&listed, &lamps, ours::$float::material(50.5));
            races.row(&name("50.5"), $real, [[pack, real]]);
            let pack = lanes::packed::<wide::$lanes, _>(&listed, &lamps, ours::$float::material(50));
            races.row(&name("50"), $integer, [[pack, integer]]);
        )*};
    }
    packed!(f32 vec3, f32x4 * 4: 0.40 0.45, f32x4 * 8: 0.33 0.36, f32x8 * 8: 0.33 0.36);
    packed!(f32 vec3, f32x4 * 32: 0.26 0.26, f32x8 * 32: 0.26 0.26);
    packed!(f64 dvec3, f64x4 * 4: 0.50 0.55, f64x4 * 8: 0.48 0.60, f64x8 * 8: 0.48 0.60);
    packed!(f64 dvec3, f64x4 * 32: 0.42 0.56, f64x8 * 32: 0.42 0.56);
}

/// The power of a cosine by a real m, beside the C library's.
fn powers(races: &mut Races) {
    races.table("The power by a real m", &["one power"]);
    macro_rules! powers {
        ($float:ident: $single:literal, $array:literal, $($lanes:ident * $count:literal),*) => {
            let (name, m): (_, $float) = (stringify!($float), black_box(50.5));
            let mut random = fastrand::Rng::with_seed(1977);
            let cosines: Vec<_> = (0..1 << 16).map(|_| random.$float()).collect();
            macro_rules! power {
                (|$c:ident| $power:expr) => {
                    pass::<false, _, _>(&cosines, 1, move |&$c: &$float| $power)
                };
            }
            let single = [power!(|c| black_box(m.raise(c))), power!(|c| black_box(c.powf(m)))];
            races.row(&format!("{name}, one by one"), $single, [single]);
            let array = [power!(|c| m.raise(c)), power!(|c| c.powf(m))];
            races.row(&format!("{name}, an array"), $array, [array]);
            $({
                let lanes = cosines.chunks_exact($count).map(|c| wide::$lanes::new(c.try_into().unwrap()));
                let lanes: Vec<_> = lanes.collect();
                let ours = pass::<false, _, _>(&lanes, $count, |&c| m.raise(c).to_array());
                races.row(stringify!($lanes), $array, [[ours, power!(|c| c.powf(m))]]);
            })*
        };
    }
    powers!(f32: 1.2, 0.35, f32x4 * 4, f32x8 * 8);
    powers!(f64: 0.90, 0.40, f64x2 * 2, f64x4 * 4);
}

fn loops(races: &mut Races) {
    races.tolerance = 0.1; // a rival gets one hard triangle in sixteen wrong
    races.table("Loops beside `fast-srgb8`, `powf` and `glam`", &WAYS);
    let (colors, triangles) = (KINDS.map(scene::colors), KINDS.map(scene::triangles));
    let (c, t) = (&colors[0], &triangles[0]);
    let calls = [ours::loops::<true>(c, t), hand::loops::<true>(c, t)];
    let columns = colors.iter().zip(&triangles);
    let columns = columns.map(|(c, t)| [ours::loops::<false>(c, t), hand::loops::<false>(c, t)]);
    races.rows(
        LOOPS.map(|(name, limit)| (name.to_owned(), limit)),
        columns.chain([calls]),
    );
}
