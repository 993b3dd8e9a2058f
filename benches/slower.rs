//! Races the loops of the working tree against those of another commit: `slower.sh` makes a package of it.

#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]

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

mod before {
    use before as subject;
    pub mod ours {
        include!("time/ours.rs");
    }
}

use race::Races;
use std::process::ExitCode;
use std::time::Duration;

/// Noise.
const LIMIT: f64 = 1.05;

macro_rules! pairs {
    ($races:ident, [$($name:expr),*], $call:ident($($argument:expr),*)) => {
        let before = before::ours::$call($($argument),*);
    };
}
