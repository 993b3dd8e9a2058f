//! Taking times side by side.

use std::hint::black_box;
use std::time::Instant;

const REPETITIONS: usize = 2000;

pub struct Contestant<'a> {
    name: &'static str,
    work: Box<dyn FnMut(usize) + 'a>,
    /// The least time of each scene.
    least: Vec<f64>,
}

impl<'a> Contestant<'a> {
    /// `work` does all of it once.
    pub fn new(name: &'static str, mut work: impl FnMut() + 'a) -> Self {
        Self {
            name,
            work: Box::new(move |_| work()),
            least: vec![f64::INFINITY],
        }
    }

    /// Shades another of the scenes each time: of one and the same, the processor would learn by
    /// heart which lights are in front, and nobody would pay for a branch foretold wrongly.
    pub fn in_turn<S>(
        name: &'static str,
        scenes: &'a mut [S],
        shade: impl Fn(&mut S) + 'a,
    ) -> Self {
        Self {
            name,
            least: vec![f64::INFINITY; scenes.len()],
            work: Box::new(move |scene| shade(black_box(&mut scenes[scene]))),
        }
    }

    fn perform(&mut self, repetition: usize) {
        let scene = repetition % self.least.len();
        let start = Instant::now();
        (self.work)(scene);
        self.least[scene] = self.least[scene].min(start.elapsed().as_secs_f64());
    }

    fn mean(&self) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let scenes = self.least.len() as f64;
        self.least.iter().sum::<f64>() / scenes
    }
}

/// What each contestant takes.
pub struct Results(Vec<(&'static str, f64)>);

impl Results {
    /// Runs all contestants and prints what each takes for each of the `count` units of its work: the
    /// mean over the scenes of the least of many times. What else the machine does adds to a time, and
    /// more to that of one contestant than of another; as they take turns, all have the same quiet
    /// moments.
    pub fn of(unit: &str, count: usize, mut contestants: Vec<Contestant>) -> Self {
        for repetition in 0..REPETITIONS {
            for contestant in &mut contestants {
                contestant.perform(repetition);
            }
        }
        #[allow(clippy::cast_precision_loss)]
        let per_unit = 1e9 / count as f64;
        let means = contestants.iter().map(|c| (c.name, c.mean() * per_unit));
        let results = Self(means.collect());
        for (name, nanoseconds) in &results.0 {
            println!("{name:28} {nanoseconds:6.2} ns per {unit}");
        }
        results
    }

    /// Prints ours/theirs, where both took part.
    pub fn ratio(&self, case: &str, ours: &str, theirs: &str) {
        let find = |wanted| self.0.iter().find(|(name, _)| *name == wanted);
        match (find(ours), find(theirs)) {
            (Some((_, ours)), Some((_, theirs))) => println!("ratio {case} {:.3}", ours / theirs),
            _ => println!("no ratio {case}: no C compiler was found"),
        }
    }
}

/// The images show the same: their formulas are the same, only the rounding differs.
///
/// # Panics
///
/// If they do not.
pub fn agree(
    name: &str,
    ours: impl IntoIterator<Item = [f32; 3]>,
    theirs: impl IntoIterator<Item = [f32; 3]>,
) {
    // four highlights of at most 2 each, wrong by m·8u
    const TOLERANCE: f32 = 8.0 * 50.5 * 8.0 * f32::EPSILON / 2.0;
    let (ours, theirs) = (ours.into_iter().flatten(), theirs.into_iter().flatten());
    for (ours, theirs) in ours.zip(theirs) {
        assert!(
            (ours - theirs).abs() <= TOLERANCE,
            "{name} shows {theirs}, not {ours}"
        );
    }
}
