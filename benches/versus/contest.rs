//! Measures the times of contestants side by side.

use std::hint::black_box;
use std::time::Instant;

const REPETITIONS: usize = 2000;

pub struct Contestant<'a> {
    name: &'static str,
    work: Box<dyn FnMut(usize) + 'a>,
    /// The times of each scene, in seconds.
    times: Vec<Vec<f64>>,
}

impl<'a> Contestant<'a> {
    /// `work` does the whole work once.
    pub fn new(name: &'static str, mut work: impl FnMut() + 'a) -> Self {
        Self {
            name,
            work: Box::new(move |_| work()),
            times: vec![Vec::new()],
        }
    }

    /// Shades another scene each time. With a single scene, the processor would memorize which
    /// lights are in front, and no contestant would pay for a mispredicted branch.
    pub fn in_turn<S>(
        name: &'static str,
        scenes: &'a mut [S],
        shade: impl Fn(&mut S) + 'a,
    ) -> Self {
        Self {
            name,
            times: vec![Vec::new(); scenes.len()],
            work: Box::new(move |scene| shade(black_box(&mut scenes[scene]))),
        }
    }

    fn perform(&mut self, repetition: usize) {
        let scene = repetition % self.times.len();
        let start = Instant::now();
        (self.work)(scene);
        self.times[scene].push(start.elapsed().as_secs_f64());
    }

    /// The mean over the scenes of the shortest and of the median time.
    fn time(mut self) -> Time {
        let mut sum = Time::default();
        for times in &mut self.times {
            times.sort_by(f64::total_cmp);
            sum.least += times[0];
            sum.median += times[times.len() / 2];
        }
        #[allow(clippy::cast_precision_loss)]
        let scenes = self.times.len() as f64;
        Time {
            least: sum.least / scenes,
            median: sum.median / scenes,
        }
    }
}

#[derive(Default)]
struct Time {
    least: f64,
    median: f64,
}

/// The time of each contestant.
pub struct Results(Vec<(&'static str, Time)>);

impl Results {
    /// Runs all contestants and prints their times for one of the `count` units of their work:
    /// shortest and median. Anything else that the machine does adds to a time, and not equally for
    /// all contestants. They take turns, so that all of them run in the same quiet moments, which
    /// the shortest times show.
    pub fn of(unit: &str, count: usize, mut contestants: Vec<Contestant>) -> Self {
        for repetition in 0..REPETITIONS {
            for contestant in &mut contestants {
                contestant.perform(repetition);
            }
        }
        #[allow(clippy::cast_precision_loss)]
        let per_unit = 1e9 / count as f64;
        let times = contestants.into_iter().map(|c| (c.name, c.time()));
        let results = Self(times.collect());
        for (name, time) in &results.0 {
            let (least, median) = (time.least * per_unit, time.median * per_unit);
            println!("{name:28} {least:6.2} ns per {unit}, median {median:6.2}");
        }
        results
    }

    /// Prints the ratio ours/theirs if both took part.
    pub fn ratio(&self, case: &str, ours: &str, theirs: &str) {
        let find = |wanted| self.0.iter().find(|(name, _)| *name == wanted);
        match (find(ours), find(theirs)) {
            (Some((_, ours)), Some((_, theirs))) => {
                let (least, median) = (ours.least / theirs.least, ours.median / theirs.median);
                println!("ratio {case} {least:.3}");
                println!("ratio-of-medians {case} {median:.3}");
            }
            _ => println!("no ratio {case}: there is no C compiler"),
        }
    }
}

/// Checks that both images are the same. Their formulas agree; only the rounding differs.
///
/// # Panics
///
/// If they differ.
pub fn agree(
    name: &str,
    lights: usize,
    ours: impl IntoIterator<Item = [f32; 3]>,
    theirs: impl IntoIterator<Item = [f32; 3]>,
) {
    // a highlight of at most 2 for each light, off by m·8u
    #[allow(clippy::cast_precision_loss)]
    let tolerance = 2.0 * lights as f32 * 50.5 * 8.0 * f32::EPSILON / 2.0;
    let (ours, theirs) = (ours.into_iter().flatten(), theirs.into_iter().flatten());
    for (ours, theirs) in ours.zip(theirs) {
        assert!(
            (ours - theirs).abs() <= tolerance,
            "{name} shows {theirs}, not {ours}"
        );
    }
}
