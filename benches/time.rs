//! How long the crate takes beside the same by hand: on `glam`, on `wide`, in C and with the standard library.
//!
//! `cargo bench -p shading-benches --bench time` prints tables in Markdown, and fails if a ratio is above its limit.
//! `-- quick` takes a quarter of the time; `-- forms` runs the tables whose name holds that word.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

#[path = "time/forms.rs"]
mod forms;
#[path = "time/hand.rs"]
mod hand;
#[path = "time/ours.rs"]
mod ours;
#[path = "time/race.rs"]
mod race;
#[path = "time/scene.rs"]
mod scene;

use race::Races;
use shading as subject;
use std::process::ExitCode;
use std::time::Duration;

const MODELS: [&str; 4] = [
    "Blinn, m = 50",
    "Blinn, m = 51",
    "Blinn, m = 50.5",
    "Phong, m = 50",
];
const DATA: [(&str, bool); 2] = [("random", false), ("sphere", true)];
const COUNTS: [usize; 3] = [1, 4, 16];

/// The sums in a loop, or by a call, beside a vector type of `glam`.
macro_rules! sums {
    ($races:ident, $call:literal, $limit:literal, $($float:ident $hand:ident),*) => {$(
        let float = |v: &[f64; 3]| v.map(|x| x as $float);
        for (data, coherent) in DATA {
            let scenes = COUNTS.map(|count| (scene::points(coherent, count), scene::lamps(count)));
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
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| a != "--bench")
        .collect();
    let quick = arguments.iter().any(|a| a == "quick");
    let chosen = |name: &str| {
        let mut words = arguments.iter().filter(|a| *a != "quick").peekable();
        words.peek().is_none() || words.any(|word| name.contains(word.as_str()))
    };
    let mut races = Races::new(Duration::from_millis(if quick { 50 } else { 200 }));
    let counts = ["1 light", "4 lights", "16 lights"];
    if chosen("sums") {
        races.table("A sum in a loop, beside `glam`", &counts);
        sums!(races, false, 0.90, f32 vec3, f64 dvec3);
        races.mean(0.72);
    }
    if chosen("calls") {
        races.table("A sum by a call, beside `glam`", &counts);
        sums!(races, true, 0.95, f32 vec3, f64 dvec3);
    }
    if chosen("Vec3A") {
        races.table("A sum in a loop, beside `glam::Vec3A`", &counts);
        sums!(races, false, 1.0, f32 vec3a);
    }
    if chosen("forms") {
        races.table("Forms of lights, beside `glam`", &["in a loop"]);
        let lamps = scene::lamps(4);
        for (data, coherent) in DATA {
            forms::f32::race(&mut races, data, &scene::points(coherent, 1), &lamps);
            forms::f64::race(&mut races, data, &scene::points(coherent, 1), &lamps);
        }
    }
    for miss in &races.misses {
        eprintln!("{miss}");
    }
    ExitCode::from(u8::from(!races.misses.is_empty()))
}
