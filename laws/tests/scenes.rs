//! The scenes of a run are the same on every machine, whatever the width of its words, its mathematical
//! library and its clock.

#![allow(missing_docs)]

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use shading_laws::{Laws, Profile, Progress, Renderer, Scene, Triple, from_fn};

/// Notes what it is asked in the plan of a run, and then ends the run.
struct Notes {
    profile: Profile,
    scenes: usize,
    /// FNV-1a of 64 bits, of the scenes as JSON.
    hash: u64,
}

impl Renderer for Notes {
    fn profile(&self) -> Profile {
        self.profile.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        for byte in scenes.iter().flat_map(|it| it.to_json().into_bytes()) {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        self.scenes += scenes.len();
        Ok(vec![[0.0; 3]; scenes.len()])
    }

    fn goes_on(&mut self, progress: &Progress) -> bool {
        progress.asked < progress.of
    }
}

/// The number and the hash of the scenes of a plan.
fn noted(seed: u64, profile: Profile) -> (usize, u64) {
    let mut notes = Notes {
        profile,
        scenes: 0,
        hash: 0xcbf2_9ce4_8422_2325,
    };
    let laws = Laws {
        seed,
        ..Laws::default()
    };
    laws.run(&mut notes).expect("a plan");
    (notes.scenes, notes.hash)
}

/// The numbers are those of x86-64; `.ci/portability` compares those of WebAssembly, where a word has 32 bits.
#[test]
fn the_scenes_are_the_same_on_every_machine() {
    let double = Profile {
        roundoff: f64::EPSILON / 2.0,
        ..Profile::default()
    };
    assert_eq!(
        noted(0, Profile::default()),
        (2303, 14_656_339_109_723_053_092)
    );
    assert_eq!(noted(1, double), (2303, 12_192_348_552_639_903_282));
}

/// Without a clock, the numbers of scenes and of batches end a run.
#[test]
fn a_run_needs_no_clock() {
    let laws = Laws {
        clock: || Duration::ZERO,
        time: Some(Duration::from_secs(1)),
        ..Laws::default()
    };
    let mut black = from_fn(Profile::default(), |_| [0.0; 3]);
    let report = laws.run(&mut black).expect("a report");
    assert!(report.is_broken() && !report.is_cut_short(), "{report}");
    let finding = &report.findings[0];
    assert!(!finding.places.is_empty(), "{report}");
    // a program that reads the report finds the scenes beside the finding
    let json: serde_json::Value = serde_json::from_str(&report.to_json()).expect("JSON");
    let scene = json["findings"][0]["scenes"][0].to_string();
    assert_eq!(
        Scene::from_json(&scene).as_ref(),
        Ok(&finding.scenes[0]),
        "{scene}"
    );
}

/// The run asks the clock that it is given.
#[test]
fn the_clock_is_an_option() {
    static SECONDS: AtomicU64 = AtomicU64::new(0);
    let laws = Laws {
        clock: || Duration::from_secs(SECONDS.fetch_add(1, Ordering::Relaxed)),
        time: Some(Duration::from_secs(5)),
        ..Laws::default()
    };
    let mut ambient = from_fn(Profile::default(), |scene| {
        [0, 1, 2].map(|i| scene.k_a[i] * scene.i_a[i])
    });
    let report = laws.run(&mut ambient).expect("a report");
    assert!(report.is_cut_short(), "{report}");
    assert!(SECONDS.load(Ordering::Relaxed) < 100, "{SECONDS:?}");
}
