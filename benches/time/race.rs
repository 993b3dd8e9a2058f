//! Races two loops over the same data, in turn, and prints a table of their least times.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How often a ratio above its limit is measured again. A busy machine disturbs a race, but seldom five.
const ATTEMPTS: usize = 5;

/// A loop over inputs. It returns its time and, if asked, the sum of its results.
pub struct Pass<'a> {
    /// What the time is divided by: inputs, or inputs times lights.
    pub units: usize,
    run: Box<dyn FnMut(bool) -> (Duration, f64) + 'a>,
}

/// The function in a loop over the inputs: inlined, or by a call.
pub fn pass<'a, const CALL: bool, I, O: Output + 'a>(
    inputs: &'a [I],
    lights: usize,
    function: impl Fn(&I) -> O + 'a,
) -> Pass<'a> {
    let mut results = vec![O::default(); inputs.len()];
    let units = inputs.len() * lights;
    let run = Box::new(move |sum: bool| {
        let start = Instant::now();
        for (result, input) in black_box(&mut results).iter_mut().zip(black_box(inputs)) {
            *result = if CALL {
                call(&function, input)
            } else {
                function(input)
            };
        }
        black_box(&mut results);
        let time = start.elapsed();
        let channels = |result: &O| result.channels().into_iter().sum::<f64>();
        let sum = if sum {
            results.iter().map(channels).sum()
        } else {
            0.0
        };
        (time, sum)
    });
    Pass { units, run }
}

#[inline(never)]
fn call<I, O>(function: &impl Fn(&I) -> O, input: &I) -> O {
    function(input)
}

/// A result.
pub trait Output: Clone + Default {
    fn channels(&self) -> [f64; 3];
}

macro_rules! outputs {
    ($($output:ty: |$o:ident| $channels:expr;)*) => {$(
        impl Output for $output {
            fn channels(&self) -> [f64; 3] {
                let $o = self;
                $channels
            }
        }
    )*};
}

outputs! {
    [u8; 3]: |o| o.map(f64::from);
    [f32; 3]: |o| o.map(f64::from);
    [f64; 3]: |o| *o;
    [wide::f32x8; 3]: |o| o.map(|lanes| lanes.to_array().into_iter().map(f64::from).sum());
    Option<[f32; 3]>: |o| o.unwrap_or_default().map(f64::from);
    u16: |o| [f64::from(*o), 0.0, 0.0];
    f32: |o| [f64::from(*o), 0.0, 0.0];
    f64: |o| [*o, 0.0, 0.0];
    wide::f64x4: |o| [o.to_array().into_iter().sum(), 0.0, 0.0];
}

/// All tables, and what is above a limit.
pub struct Races {
    /// The least time spent on each ratio.
    pub budget: Duration,
    pub misses: Vec<String>,
    title: &'static str,
    ratios: Vec<f64>,
}

impl Races {
    pub fn new(budget: Duration) -> Self {
        let (misses, ratios) = (Vec::new(), Vec::new());
        Self {
            budget,
            misses,
            title: "",
            ratios,
        }
    }

    /// Begins a table.
    pub fn table(&mut self, title: &'static str, columns: &[&str]) {
        (self.title, self.ratios) = (title, Vec::new());
        println!("\n**{title}**: ours / theirs in ns = ratio\n");
        println!("| | {} | limit |", columns.join(" | "));
        println!("|---{}|---|", "|---".repeat(columns.len()));
    }

    /// Races ours against theirs, and prints a row with a ratio for each pair.
    pub fn row<'a>(
        &mut self,
        name: &str,
        limit: f64,
        pairs: impl IntoIterator<Item = [Pass<'a>; 2]>,
    ) {
        print!("| {name}");
        for [mut ours, mut theirs] in pairs {
            let mut least = [f64::MAX; 2];
            for _ in 0..ATTEMPTS {
                self.race([&mut ours, &mut theirs], &mut least);
                if least[0] <= limit * least[1] {
                    break;
                }
            }
            let [nanoseconds, rival] = least;
            let ratio = nanoseconds / rival;
            self.ratios.push(ratio);
            let mark = if ratio > limit { "**" } else { "" };
            print!(" | {nanoseconds:.2} / {rival:.2} = {mark}{ratio:.2}{mark}");
            if ratio > limit {
                self.misses
                    .push(format!("{}, {name}: {ratio:.2} > {limit}", self.title));
            }
        }
        println!(" | {limit:.2} |");
    }

    /// Lowers the least nanoseconds of a unit.
    fn race(&self, mut passes: [&mut Pass; 2], least: &mut [f64; 2]) {
        let sums = passes.each_mut().map(|pass| (pass.run)(true).1);
        let close = (sums[0] - sums[1]).abs() <= 1e-3 * sums[1].abs();
        assert!(close || sums[1].is_nan(), "{}: {sums:?} differ", self.title);
        let start = Instant::now();
        while start.elapsed() < self.budget {
            for (pass, least) in passes.iter_mut().zip(&mut *least) {
                #[allow(clippy::cast_precision_loss)]
                let time = (pass.run)(false).0.as_secs_f64() * 1e9 / pass.units as f64;
                *least = least.min(time);
            }
        }
    }

    /// Ends a table with the geometric mean of its ratios.
    pub fn mean(&mut self, limit: f64) {
        #[allow(clippy::cast_precision_loss)]
        let count = self.ratios.len() as f64;
        let mean = (self.ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / count).exp();
        println!("\ngeometric mean {mean:.2}, limit {limit:.2}");
        if mean > limit {
            self.misses.push(format!(
                "{}, geometric mean: {mean:.2} > {limit}",
                self.title
            ));
        }
    }
}
