//! Races the loops of the working tree against those of another commit. `slower.sh` makes a package of this file.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

#[path = "time/race.rs"]
mod race;
#[path = "time/scene.rs"]
mod scene;

mod now {
    use shading as subject;
    pub mod ours {
        include!("time/ours.rs");
    }
}

mod then {
    use before as subject;
    pub mod ours {
        include!("time/ours.rs");
    }
}

use race::Races;
use scene::{COUNTS, DATA, ENCODINGS, KINDS, LIGHTS, MODELS, NORMALS, WAYS};
use std::process::ExitCode;

/// More is not noise.
const LIMIT: f64 = 1.05;

macro_rules! sums {
    ($races:ident, $float:ident) => {
        for data in DATA {
            let float = |v: &[f64; 3]| v.map(|x| x as $float);
            let scenes = COUNTS.map(|count| {
                let points = scene::points(data, count);
                let lamps: Vec<_> = scene::lamps(count).iter().map(float).collect();
                let points: Vec<_> = points
                    .iter()
                    .map(|point| point.each_ref().map(float))
                    .collect();
                (
                    points,
                    now::ours::$float::lamps(&lamps),
                    then::ours::$float::lamps(&lamps),
                )
            });
            let columns = scenes.iter().map(|(points, now, then)| {
                [
                    now::ours::$float::sums::<false>(points, now),
                    then::ours::$float::sums::<false>(points, then),
                ]
            });
            let name = |model| (format!("{} {model}, {data}", stringify!($float)), LIMIT);
            $races.rows(MODELS.map(name), columns);
        }
    };
}

fn main() -> ExitCode {
    let mut races = Races::new(0.2);
    races.table("Now / then: loops", &WAYS);
    let (colors, triangles) = (KINDS.map(scene::colors), KINDS.map(scene::triangles));
    let both = |c| {
        [
            now::ours::encodings::<false>(c),
            then::ours::encodings::<false>(c),
        ]
    };
    let call = |c| {
        [
            now::ours::encodings::<true>(c),
            then::ours::encodings::<true>(c),
        ]
    };
    let columns = colors.iter().map(|c| both(c)).chain([call(&colors[0])]);
    races.rows(ENCODINGS.map(|(name, _)| (name.to_owned(), LIMIT)), columns);
    let both = |t| {
        [
            now::ours::normals::<false>(t),
            then::ours::normals::<false>(t),
        ]
    };
    let call = |t| {
        [
            now::ours::normals::<true>(t),
            then::ours::normals::<true>(t),
        ]
    };
    let columns = triangles
        .iter()
        .map(|t| both(t))
        .chain([call(&triangles[0])]);
    races.rows(NORMALS.map(|(name, _)| (name.to_owned(), LIMIT)), columns);
    races.table("Now / then: sums", &LIGHTS);
    sums!(races, f32);
    sums!(races, f64);
    races.report()
}
