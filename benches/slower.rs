//! Races the loops of the working tree against those of another commit. `slower.sh` makes a package of this file.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

#[allow(dead_code)] // a mean
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
use scene::{COUNTS, DATA, KINDS, LIGHTS, LOOPS, MODELS, WAYS};
use std::process::ExitCode;

/// More is not noise.
const LIMIT: f64 = 1.05;

macro_rules! sums {
    ($races:ident, $float:ident) => {
        for data in DATA {
            let scenes = COUNTS.map(|count| (scene::points(data, count), scene::lamps(count)));
            let now = scenes
                .each_ref()
                .map(|(p, lamps)| now::ours::$float::scene(p, lamps));
            let then = scenes
                .each_ref()
                .map(|(p, lamps)| then::ours::$float::scene(p, lamps));
            let columns = now.iter().zip(&then).map(|(now, then)| {
                [
                    now::ours::$float::sums::<false>(now),
                    then::ours::$float::sums::<false>(then),
                ]
            });
            let name = |model| (format!("{} {model}, {data}", stringify!($float)), LIMIT);
            $races.rows(MODELS.map(name), columns);
        }
    };
}

fn main() -> ExitCode {
    let mut races = Races::new(0.2, true);
    races.table("Now / then: loops", &WAYS);
    let (colors, triangles) = (KINDS.map(scene::colors), KINDS.map(scene::triangles));
    let (c, t) = (&colors[0], &triangles[0]);
    let calls = [
        now::ours::loops::<true>(c, t),
        then::ours::loops::<true>(c, t),
    ];
    let columns = colors.iter().zip(&triangles);
    let columns = columns.map(|(c, t)| {
        [
            now::ours::loops::<false>(c, t),
            then::ours::loops::<false>(c, t),
        ]
    });
    races.rows(
        LOOPS.map(|(name, _)| (name.to_owned(), LIMIT)),
        columns.chain([calls]),
    );
    races.table("Now / then: sums", &LIGHTS);
    sums!(races, f32);
    sums!(races, f64);
    races.report()
}
