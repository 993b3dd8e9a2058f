//! Races two loops over the same data, in turn, and prints a table of their least times.
//!
//! The time is that of the wall, because the time of a thread reads too low at times. A pass is
//! short, and the least of many is one that nothing interrupted. `criterion` and `divan` measure
//! one function after the other, on a machine whose clock changes meanwhile; `tango-bench` pairs
//! two builds of one function, not two functions.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

/// How often a ratio above its limit is measured again, if limits are judged. A busy machine
/// disturbs a race, but seldom five.
const ATTEMPTS: usize = 5;

/// A loop over inputs. It returns the nanoseconds for a unit and, if asked, the sum of its results.
pub type Pass<'a> = Box<dyn FnMut(bool) -> [f64; 2] + 'a>;

/// The function in a loop over the inputs: inlined, or by a call. An input has several `units`, such as lights.
///
/// `#[inline]` compiles the loop in the module that writes the function, as in a renderer, and not in this one.
#[inline]
pub fn pass<'a, const CALL: bool, I, O: Output + Clone + Default + 'a>(
    inputs: &'a [I],
    units: usize,
    function: impl Fn(&I) -> O + 'a,
) -> Pass<'a> {
    let mut results = vec![O::default(); inputs.len()];
    Box::new(move |sum| {
        let start = Instant::now();
        fill::<CALL, _, _>(black_box(&mut results), black_box(inputs), &function);
        let nanoseconds = start.elapsed().as_secs_f64() * 1e9;
        let sum = if sum {
            results.iter().map(O::sum).sum()
        } else {
            0.0
        };
        [nanoseconds / (units * inputs.len()) as f64, sum]
    })
}

/// The loop, a function over slices as a renderer has it: the compiler knows that none is another.
#[inline]
fn fill<const CALL: bool, I, O>(results: &mut [O], inputs: &[I], function: &impl Fn(&I) -> O) {
    for (result, input) in results.iter_mut().zip(inputs) {
        *result = if CALL {
            call(function, input)
        } else {
            function(input)
        };
    }
}

#[inline(never)]
fn call<I, O>(function: &impl Fn(&I) -> O, input: &I) -> O {
    function(input)
}

/// A result, summed up so that two contestants can be compared.
pub trait Output {
    fn sum(&self) -> f64;
}

impl<O: Output, const N: usize> Output for [O; N] {
    fn sum(&self) -> f64 {
        self.iter().map(O::sum).sum()
    }
}

impl<O: Output> Output for Option<O> {
    fn sum(&self) -> f64 {
        self.iter().map(O::sum).sum()
    }
}

macro_rules! numbers {
    ($($number:ty),*) => {$(
        impl Output for $number {
            fn sum(&self) -> f64 {
                f64::from(*self).abs()
            }
        }
    )*};
}

numbers!(u8, u16, f32, f64);

/// Tables, and what in them is above its limit.
pub struct Races {
    /// How many seconds a ratio is measured.
    pub budget: f64,
    /// Whether what is above its limit is measured again and is an error.
    pub judges: bool,
    pub misses: Vec<String>,
    /// How far the results of ours and theirs may be apart.
    pub tolerance: f64,
    title: &'static str,
    ratios: Vec<(String, f64)>,
}

impl Races {
    pub fn new(budget: f64, judges: bool) -> Self {
        Self {
            budget,
            judges,
            misses: Vec::new(),
            tolerance: 1e-3,
            title: "",
            ratios: Vec::new(),
        }
    }

    /// Begins a table.
    pub fn table(&mut self, title: &'static str, columns: &[&str]) {
        (self.title, self.ratios) = (title, Vec::new());
        println!(
            "\n**{title}**\n\n| ours / theirs in ns = ratio | {} | limit |",
            columns.join(" | ")
        );
        println!("|---|---{}|", "|---".repeat(columns.len()));
    }

    /// A row with a ratio for each pair of ours and theirs.
    pub fn row<'a>(
        &mut self,
        name: &str,
        limit: f64,
        pairs: impl IntoIterator<Item = [Pass<'a>; 2]>,
    ) {
        print!("| {name}");
        for mut pair in pairs {
            let [ours, theirs] = self.least(&mut pair, limit, name);
            let ratio = ours / theirs;
            self.ratios.push((name.to_owned(), ratio));
            self.check(name, ratio, limit);
            let mark = if ratio > limit { "**" } else { "" };
            print!(" | {ours:.2} / {theirs:.2} = {mark}{ratio:.2}{mark}");
        }
        println!(" | {limit:.2} |");
    }

    /// Rows of which each column is given as a whole.
    pub fn rows<'a, const N: usize>(
        &mut self,
        names: [(String, f64); N],
        columns: impl IntoIterator<Item = [[Pass<'a>; N]; 2]>,
    ) {
        let mut rows = names.map(|name| (name, Vec::new()));
        for [ours, theirs] in columns {
            for ((row, ours), theirs) in rows.iter_mut().zip(ours).zip(theirs) {
                row.1.push([ours, theirs]);
            }
        }
        for ((name, limit), pairs) in rows {
            self.row(&name, limit, pairs);
        }
    }

    /// Ends a table with the geometric mean of some rows.
    pub fn mean(&mut self, limit: f64, rows: impl Fn(&str) -> bool) {
        let some = self.ratios.iter().filter(|(name, _)| rows(name));
        let logarithms: Vec<f64> = some.map(|(_, ratio)| ratio.ln()).collect();
        let mean = (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp();
        println!(
            "\ngeometric mean of {} {mean:.2}, limit {limit:.2}",
            logarithms.len()
        );
        self.check("geometric mean", mean, limit);
    }

    fn check(&mut self, name: &str, ratio: f64, limit: f64) {
        if ratio > limit {
            self.misses
                .push(format!("{}, {name}: {ratio:.3} > {limit}", self.title));
        }
    }

    fn least(&self, pair: &mut [Pass; 2], limit: f64, name: &str) -> [f64; 2] {
        let [ours, theirs] = pair.each_mut().map(|pass| pass(true)[1]);
        let differ = (ours - theirs).abs() > self.tolerance * theirs.abs();
        assert!(
            !differ,
            "{}, {name}: {ours} differs from {theirs}",
            self.title
        );
        let mut least = [f64::MAX; 2];
        for _ in 0..if self.judges { ATTEMPTS } else { 1 } {
            let start = Instant::now();
            while start.elapsed().as_secs_f64() < self.budget {
                for (pass, least) in pair.iter_mut().zip(&mut least) {
                    *least = least.min(pass(false)[0]);
                }
            }
            if least[0] <= limit * least[1] {
                break;
            }
        }
        least
    }

    /// Names what is above its limit, if limits are judged.
    pub fn report(&self) -> ExitCode {
        if !self.judges {
            return ExitCode::SUCCESS;
        }
        for miss in &self.misses {
            eprintln!("{miss}");
        }
        ExitCode::from(u8::from(!self.misses.is_empty()))
    }
}
