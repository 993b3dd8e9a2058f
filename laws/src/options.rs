//! What a run tries.

use std::time::Duration;

use crate::clock::{self, Clock};
use crate::mistakes::departures;
use crate::profile::Profile;

/// A run of the laws. It is deterministic: the same seed gives the same scenes.
///
/// ```
/// use shading_laws::{Laws, Profile, from_fn};
///
/// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
/// let laws = Laws { seed: 7, cases: 50, ..Laws::default() };
/// let report = laws.run(&mut black).unwrap();
/// assert!(report.is_broken()); // there is no k_a I_a
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
            clock: clock::of_machine,
        }
    }
}

impl Laws {
    /// What prevents a run, if anything.
    pub(crate) fn complaint(&self, profile: &Profile) -> Option<String> {
        let of_profile = profile.complaint().or_else(|| departures(profile).err());
        if let Some(complaint) = of_profile {
            return Some(format!("the profile of {}: {complaint}", profile.name));
        }
        (self.cases == 0).then(|| "the number of cases is 0".into())
    }
}
