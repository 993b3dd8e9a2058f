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
#[path = "time/loops.rs"]
mod loops;
#[path = "time/ours.rs"]
mod ours;
#[path = "time/race.rs"]
mod race;
#[path = "time/scene.rs"]
mod scene;

use race::{Races, pass};
use shading::{self as subject, Exponent};
use std::hint::black_box;
use std::process::{Command, ExitCode};
use std::time::Duration;

const MODELS: [&str; 4] = [
    "Blinn, m = 50",
    "Blinn, m = 51",
    "Blinn, m = 50.5",
    "Phong, m = 50",
];
const DATA: [&str; 2] = ["random", "sphere"];
const COUNTS: [usize; 3] = [1, 4, 16];
const LIGHTS: [&str; 3] = ["1 light", "4 lights", "16 lights"];
/// Set where the bench was built for the processor of this machine.
const NATIVE: &str = "SHADING_BENCH_NATIVE";

/// The tables by name.
const TABLES: [(&str, fn(&mut Races)); 8] = [
    ("sums", sums),
    ("calls", calls),
    ("vec3a", vec3a),
    ("forms", forms),
    ("lanes", lanes),
    ("packed", packed),
    ("powers", powers),
    ("loops", loops),
];

/// The sums in a loop, or by a call, beside a vector type of `glam`.
macro_rules! sums {
    ($races:ident, $call:literal, $limit:literal, $($float:ident $hand:ident),*) => {$(
        let float = |v: &[f64; 3]| v.map(|x| x as $float);
        for data in DATA {
            let scenes = COUNTS.map(|count| (scene::points(data, count), scene::lamps(count)));
            let ours = scenes.each_ref().map(|(points, lamps)| {
                let points: Vec<_> = points.iter().map(|point| point.each_ref().map(float)).collect();
                (points, ours::$float::lamps(&lamps.iter().map(float).collect::<Vec<_>>()))
            });
            let theirs = scenes.map(|(points, lamps)| {
                let points: Vec<_> = points.iter().map(|point| point.map(hand::$hand::vector)).collect();
                (points, lamps.into_iter().map(hand::$hand::lamp).collect::<Vec<_>>())
            });
            for (i, model) in MODELS.iter().enumerate() {
                let pairs = ours.iter().zip(&theirs).map(|(ours, theirs)| {
                    let ours = ours::$float::sums::<$call>(&ours.0, &ours.1);
                    let theirs = hand::$hand::sums::<$call>(&theirs.0, &theirs.1);
                    ours.into_iter().zip(theirs).nth(i).unwrap().into()
                });
                $races.row(&format!("{} {model}, {data}", stringify!($float)), $limit, pairs);
            }
        }
    )*};
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let given = |word: &str| arguments.iter().any(|a| a == word);
    let all = !TABLES.iter().any(|(name, _)| given(name));
    let mut races = Races::new(Duration::from_millis(if given("quick") { 50 } else { 200 }));
    for (_, table) in TABLES.iter().filter(|(name, _)| all || given(name)) {
        table(&mut races);
    }
    for miss in &races.misses {
        eprintln!("{miss}");
    }
    ExitCode::from(u8::from(!races.misses.is_empty()))
}

fn sums(races: &mut Races) {
    races.table("A sum in a loop, beside `glam`", &LIGHTS);
    sums!(races, false, 0.90, f32 vec3, f64 dvec3);
    races.mean(0.72);
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
    let (points, eight) = (scene::points("cube", 4), scene::lamps(4));
    let positions: Vec<_> = eight.iter().map(|p| p.map(|x| x as f32)).collect();
    let (lamps, lanes) = (ours::f32::lamps(&positions), lanes::eight_points(&points));
    races.table("Eight points in lanes", &["4 lights"]);
    let real = || lanes::ours(&lanes, &lamps, ours::f32::material(50.5));
    let integer = lanes::ours(&lanes, &lamps, ours::f32::material(50));
    races.row(
        "real m, beside `wide` by hand",
        0.72,
        [[real(), lanes::by_hand(&lanes, &eight, 50.5)]],
    );
    races.row(
        "real m, beside C",
        0.25,
        [[real(), lanes::in_c(&points, &eight, 50.5)]],
    );
    races.row(
        "integer m, beside C",
        0.20,
        [[integer, lanes::in_c(&points, &eight, 50.0)]],
    );
}

/// Lights in lanes, in a default build.
fn packed(races: &mut Races) {
    let points = scene::points("cube", 4);
    races.table("Lights in lanes, beside `glam`", &["in a loop"]);
    macro_rules! packed {
        ($float:ident $hand:ident, $($lanes:ident * $count:literal: $real:literal $integer:literal),*) => {$(
            let (float, positions) = (|v: &[f64; 3]| v.map(|x| x as $float), scene::lamps($count));
            let ours: Vec<_> = points.iter().map(|point| point.each_ref().map(float)).collect();
            let lamps = ours::$float::lamps(&positions.iter().map(float).collect::<Vec<_>>());
            let theirs: Vec<_> = points.iter().map(|point| point.map(hand::$hand::vector)).collect();
            let by_hand: Vec<_> = positions.iter().map(|&p| hand::$hand::lamp(p)).collect();
            let [integer, _, real, _] = hand::$hand::sums::<false>(&theirs, &by_hand);
            let name = |m| format!("{m}, {} lights in {}", $count, stringify!($lanes));
            let pack = lanes::packed::<wide::$lanes, _>(&ours, &lamps, ours::$float::material(50.5));
            races.row(&name("m = 50.5"), $real, [[pack, real]]);
            let pack = lanes::packed::<wide::$lanes, _>(&ours, &lamps, ours::$float::material(50));
            races.row(&name("m = 50"), $integer, [[pack, integer]]);
        )*};
    }
    packed!(f32 vec3, f32x4 * 4: 0.40 0.45, f32x8 * 8: 0.33 0.36, f32x8 * 32: 0.26 0.26);
    packed!(f64 dvec3, f64x4 * 4: 0.40 0.45, f64x8 * 8: 0.33 0.36, f64x8 * 32: 0.26 0.26);
}

/// The power of a cosine by a real m, beside the C library's.
fn powers(races: &mut Races) {
    races.table("The power by a real m", &["ns"]);
    macro_rules! powers {
        ($float:ident: $single:literal, $array:literal, $($lanes:ident * $count:literal),*) => {
            let mut random = fastrand::Rng::with_seed(1977);
            let cosines: &Vec<_> = &(0..1 << 16).map(|_| random.$float()).collect();
            macro_rules! power {
                (|$c:ident, $m:ident| $power:expr) => {{
                    let $m: $float = black_box(50.5);
                    pass::<false, _, _>(cosines, 1, move |&$c: &$float| $power)
                }};
            }
            let (name, real_m): (_, $float) = (stringify!($float), black_box(50.5));
            let theirs = || power!(|c, m| c.powf(m));
            races.row(&format!("{name}, one by one"), $single, [[power!(|c, m| black_box(m.raise(c))), power!(|c, m| black_box(c.powf(m)))]]);
            races.row(&format!("{name}, an array"), $array, [[power!(|c, m| m.raise(c)), theirs()]]);
            $({
                let lanes: Vec<_> = cosines.chunks_exact($count).map(|some| wide::$lanes::new(some.try_into().unwrap())).collect();
                let ours = pass::<false, _, _>(&lanes, $count, |&c| real_m.raise(c).to_array());
                races.row(stringify!($lanes), $array, [[ours, theirs()]]);
            })*
        };
    }
    powers!(f32: 1.4, 0.35, f32x4 * 4, f32x8 * 8);
    powers!(f64: 0.70, 0.25, f64x4 * 4, f64x8 * 8);
}

fn loops(races: &mut Races) {
    races.tolerance = 0.1; // a rival gets one hard triangle in sixteen wrong
    races.table(
        "Loops over colors and triangles",
        &["random", "smooth", "hard", "random, by a call"],
    );
    let (colors, triangles) = (
        scene::KINDS.map(scene::colors),
        scene::KINDS.map(scene::triangles),
    );
    let rows = [
        ("to_srgb8, beside fast-srgb8", 0.85),
        ("to_rgb565, beside powf", 0.4),
    ];
    for (i, (name, limit)) in rows.into_iter().enumerate() {
        let pair =
            |(ours, theirs): ([_; 2], [_; 2])| ours.into_iter().zip(theirs).nth(i).unwrap().into();
        let loops = colors
            .iter()
            .map(|c| pair((ours::encodings::<false>(c), loops::encodings::<false>(c))));
        let calls = pair((
            ours::encodings::<true>(&colors[0]),
            loops::encodings::<true>(&colors[0]),
        ));
        races.row(name, limit, loops.chain([calls]));
    }
    let rows = [
        ("Vec3::unit", 1.3),
        ("normal::triangle", 1.3),
        ("normal::corner", 1.2),
        ("normal::implicit, a torus", 1.5),
        ("normal::parametric, a saddle", 1.5),
    ];
    for (i, (name, limit)) in rows.into_iter().enumerate() {
        let pair =
            |(ours, theirs): ([_; 5], [_; 5])| ours.into_iter().zip(theirs).nth(i).unwrap().into();
        let loops = triangles
            .iter()
            .map(|t| pair((ours::normals::<false>(t), loops::normals::<false>(t))));
        let calls = pair((
            ours::normals::<true>(&triangles[0]),
            loops::normals::<true>(&triangles[0]),
        ));
        races.row(name, limit, loops.chain([calls]));
    }
}
