//! What a run tries.

use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// The time since some moment, which never goes back.
///
/// A page has no clock that the standard library knows. There, the default stands still, so only the numbers of
/// scenes and of batches end a search, unless [`Laws`] is given a clock such as one that asks the page for
/// `performance.now()`.
pub type Clock = fn() -> Duration;

/// A run of the laws. It is deterministic: the same seed gives the same scenes.
///
/// ```
/// use shading_laws::{Laws, Profile, from_fn};
///
/// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
/// let laws = Laws { seed: 7, cases: 50, ..Laws::default() };
/// let report = laws.run(&mut black).unwrap();
/// assert!(report.is_broken()); // there is no k_a I_a
/// assert!(report.to_json().starts_with(r#"{"passes":false,"version":9,"seed":7,"#));
/// ```
#[derive(Clone, Debug)]
pub struct Laws {
    /// The seed of the scenes.
    pub seed: u64,
    /// The number of random scenes, beside the fixed ones.
    pub cases: usize,
    /// Whether smaller scenes are looked for that break a law, too: for two seconds in all.
    pub shrinks: bool,
    /// Whether a cause is looked for among the known mistakes, which takes most of the time where none fits.
    pub explains: bool,
    /// The longest time of the run. Each law is tried at least once. If the time ends before all
    /// cases are tried, the report does not pass.
    pub time: Option<Duration>,
    /// What tells the time. Without a clock, as in a page, `time` ends nothing.
    pub clock: Clock,
}

impl Default for Laws {
    fn default() -> Self {
        Self {
            seed: 0,
            cases: 1024,
            shrinks: true,
            explains: true,
            time: None,
            clock: of_machine,
        }
    }
}

/// The clock of the standard library. Where it has none, asking for it would end the program.
fn of_machine() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    if cfg!(all(target_family = "wasm", target_os = "unknown")) {
        return Duration::ZERO;
    }
    START.elapsed()
}
