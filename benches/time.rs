//! How long the crate takes beside the same by hand: on `glam`, on `wide`, in C and with the standard library.
//!
//! `cargo bench -p shading-benches --bench time` prints tables in Markdown, and fails if a ratio is above its limit.
//! `-- quick` takes a quarter of the time; `-- forms lanes` runs these tables alone.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

#[path = "time/forms.rs"]
mod forms;
#[path = "time/hand.rs"]
mod hand;
#[path = "time/lanes.rs"]
mod lanes;
#[path = "time/ours.rs"]
mod ours;
#[path = "time/race.rs"]
mod race;
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
const TABLES: [(&str, Table); 8] = [
    ("sums", sums),
    ("calls", calls),
    ("vec3a", vec3a),
    ("forms", forms),
    ("lanes", lanes),
    ("packed", packed),
    ("powers", powers),
    ("loops", loops),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let given = |word: &str| arguments.iter().any(|a| a == word);
    let all = !TABLES.iter().any(|(name, _)| given(name));
    let mut races = Races::new(if given("quick") { 0.05 } else { 0.2 });
    for (_, table) in TABLES.iter().filter(|(name, _)| all || given(name)) {
        table(&mut races);
    }
    races.report()
}

/// The sums in a loop, or by a call, beside a vector type of `glam`.
macro_rules! sums {
    ($races:ident, $call:literal, $limit:literal, $($float:ident $hand:ident),*) => {$(
        for data in DATA {
            let scenes = COUNTS.map(|count| (scene::points(data, count), scene::lamps(count)));
            let ours = scenes.each_ref().map(|(points, lamps)| ours::$float::scene(points, lamps));
            let theirs = scenes.each_ref().map(|(points, lamps)| hand::$hand::scene(points, lamps));
            let both = |(ours, theirs)| [
                ours::$float::sums::<$call>(ours),
                hand::$hand::sums::<$call>(theirs),
            ];
            let name = |model| (format!("{} {model}, {data}", stringify!($float)), $limit);
            $races.rows(MODELS.map(name), ours.iter().zip(&theirs).map(both));
        }
    )*};
}

fn sums(races: &mut Races) {
    races.table("A sum in a loop, beside `glam`", &LIGHTS);
    sums!(races, false, 0.90, f32 vec3, f64 dvec3);
    races.mean(0.72, |row| !row.contains("m = 51"));
}

fn calls(races: &mut Races) {
    races.table("A sum by a call, beside `glam`", &LIGHTS);
    sums!(races, true, 0.95, f32 vec3, f64 dvec3);
}

fn vec3a(races: &mut Races) {
    races.table("A sum in a loop, beside `glam::Vec3A`", &LIGHTS);
    sums!(races, false, 1.0, f32 vec3a);
}

fn forms(races: &mut Races) {
    races.table("Forms of lights, beside `glam`", &["in a loop"]);
    for data in DATA {
        forms::f32::race(races, data, &scene::points(data, 1), &scene::lamps(4));
        forms::f64::race(races, data, &scene::points(data, 1), &scene::lamps(4));
    }
}

/// Builds this bench again for the processor of this machine, and races eight points in lanes there.
fn lanes(races: &mut Races) {
    if std::env::var_os(NATIVE).is_none() {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["bench", "--quiet", "--bench", "time", "--", "lanes"]);
        cargo.args(std::env::args().filter(|a| a == "quick"));
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
            let [integer, _, real, _] = hand::$hand::sums::<false>(&theirs);
            let name = |m| format!("m = {m}, {} lights in {}", $count, stringify!($lanes));
            let pack = lanes::packed::<wide::$lanes, _>(&listed, &lamps, ours::$float::material(50.5));
            races.row(&name("50.5"), $real, [[pack, real]]);
            let pack = lanes::packed::<wide::$lanes, _>(&listed, &lamps, ours::$float::material(50));
            races.row(&name("50"), $integer, [[pack, integer]]);
        )*};
    }
    packed!(f32 vec3, f32x4 * 4: 0.40 0.45, f32x8 * 8: 0.33 0.36, f32x8 * 32: 0.26 0.26);
    packed!(f64 dvec3, f64x4 * 4: 0.40 0.45, f64x8 * 8: 0.33 0.36, f64x8 * 32: 0.26 0.26);
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
    powers!(f32: 1.4, 0.35, f32x4 * 4, f32x8 * 8);
    powers!(f64: 0.70, 0.25, f64x2 * 2, f64x4 * 4);
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
