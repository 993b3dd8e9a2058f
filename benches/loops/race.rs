//! Races a function of this crate against its rivals, side by side: inlined into a loop, and by a call.

use std::cell::RefCell;
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::time::Instant;

const PASSES: usize = 200;
/// How often a ratio above its limit is measured again: a busy machine disturbs a race, but seldom
/// three of them.
const ATTEMPTS: usize = 3;
/// How much more time is allowed on hard data, where the rivals give wrong results sooner.
const HARD: f64 = 1.25;

/// Named arguments, such as random and smooth ones.
pub type Data<I> = (&'static str, Vec<I>);

/// The most that this crate's time may be of a rival's: inlined into a loop, and by a call.
#[derive(Clone, Copy)]
pub struct Limit {
    pub in_loop: f64,
    pub by_call: f64,
}

/// The rival is there to be seen.
pub const NONE: Limit = Limit {
    in_loop: f64::INFINITY,
    by_call: f64::INFINITY,
};

pub const fn limit(in_loop: f64, by_call: f64) -> Limit {
    Limit { in_loop, by_call }
}

type Work<'a, I> = dyn Fn(&[I]) + 'a;

struct Contestant<'a, I> {
    name: &'static str,
    limit: Limit,
    in_loop: Box<Work<'a, I>>,
    by_call: Box<Work<'a, I>>,
}

/// The contestants; the first is this crate's function.
pub struct Race<'a, I> {
    name: &'static str,
    contestants: Vec<Contestant<'a, I>>,
}

/// A closure twice: the compiler inlines what is called only once.
macro_rules! twice {
    ($function:expr) => {
        ($function, $function)
    };
}
pub(crate) use twice;

impl<'a, I> Race<'a, I> {
    pub fn of<O: 'a>(
        name: &'static str,
        ours: (impl Fn(&I) -> O + 'a, impl Fn(&I) -> O + 'a),
    ) -> Self {
        let race = Self {
            name,
            contestants: Vec::new(),
        };
        race.against("this crate", NONE, ours)
    }

    #[must_use]
    pub fn against<O: 'a>(
        mut self,
        name: &'static str,
        limit: Limit,
        (inlined, called): (impl Fn(&I) -> O + 'a, impl Fn(&I) -> O + 'a),
    ) -> Self {
        let results = RefCell::new(Vec::new());
        self.contestants.push(Contestant {
            name,
            limit,
            in_loop: Box::new(move |inputs| in_loop(&inlined, inputs, &mut results.borrow_mut())),
            by_call: Box::new(move |inputs| by_call(&called, inputs)),
        });
        self
    }

    /// Prints the least times and the ratios, a line for each data set, and returns how many ratios
    /// exceed their limits.
    pub fn run(&self, data: &[Data<I>]) -> usize {
        data.iter().map(|data| self.run_with(data)).sum()
    }

    fn run_with(&self, (kind, inputs): &Data<I>) -> usize {
        let mut least = vec![[f64::INFINITY; 2]; self.contestants.len()];
        let mut exceeded = 0;
        let allowance = if *kind == "hard" { HARD } else { 1.0 };
        for _ in 0..ATTEMPTS {
            self.measure(inputs, &mut least);
            exceeded = self.exceeded(&least, allowance);
            if exceeded == 0 {
                break;
            }
        }
        let [ours_in_loop, ours_by_call] = least[0];
        print!(
            "{:<22} {kind:<8} {ours_in_loop:7.2} {ours_by_call:7.2}",
            self.name
        );
        for (rival, [in_loop, by_call]) in self.contestants.iter().zip(&least).skip(1) {
            let (in_loop_ratio, by_call_ratio) = (ours_in_loop / in_loop, ours_by_call / by_call);
            let mark = |ratio: f64, limit: f64| if ratio > limit * allowance { "!" } else { "" };
            print!(
                " | {} {in_loop:.2} {by_call:.2}: {in_loop_ratio:.2}{} {by_call_ratio:.2}{}",
                rival.name,
                mark(in_loop_ratio, rival.limit.in_loop),
                mark(by_call_ratio, rival.limit.by_call),
            );
        }
        println!();
        exceeded
    }

    /// Lowers the least times. The contestants take turns, so that all of them run in the same quiet
    /// moments.
    fn measure(&self, inputs: &[I], least: &mut [[f64; 2]]) {
        #[allow(clippy::cast_precision_loss)]
        let per_input = 1e9 / inputs.len() as f64;
        for _ in 0..PASSES {
            for (contestant, least) in self.contestants.iter().zip(&mut *least) {
                for (work, least) in [&contestant.in_loop, &contestant.by_call]
                    .into_iter()
                    .zip(least)
                {
                    let start = Instant::now();
                    work(black_box(inputs));
                    *least = least.min(start.elapsed().as_secs_f64() * per_input);
                }
            }
        }
    }

    fn exceeded(&self, least: &[[f64; 2]], allowance: f64) -> usize {
        let ratios = self.contestants.iter().zip(least).skip(1);
        let over = ratios.map(|(rival, theirs)| {
            usize::from(least[0][0] / theirs[0] > rival.limit.in_loop * allowance)
                + usize::from(least[0][1] / theirs[1] > rival.limit.by_call * allowance)
        });
        over.sum()
    }
}

/// What users write: the function inlined into a loop over their array.
#[inline(never)]
fn in_loop<I, O>(function: &impl Fn(&I) -> O, inputs: &[I], results: &mut Vec<MaybeUninit<O>>) {
    results.resize_with(inputs.len(), MaybeUninit::uninit);
    for (result, input) in results.iter_mut().zip(inputs) {
        result.write(function(input));
    }
    black_box(results);
}

fn by_call<I, O>(function: &impl Fn(&I) -> O, inputs: &[I]) {
    #[inline(never)]
    fn call<I, O>(function: &impl Fn(&I) -> O, input: &I) -> O {
        function(input)
    }
    for input in inputs {
        black_box(&call(function, input)); // a copy could wait for the store
    }
}
