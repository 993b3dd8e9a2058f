//! The prover proves what is true, refutes what is not, and leaves open what it cannot know.

use shading::number::Mask;
use shading::{Real, Vec3};
use shading_proofs::{Format, Given, Goal, Range, Term, Verdict, judge, refute};

const INF: f64 = f64::INFINITY;
const RUNS: u64 = 20_000;

fn within(x: Term, low: f64, high: f64) -> Vec<Goal> {
    vec![Goal::Within(x, Range::within(low, high))]
}

fn number(given: Given, name: &str, low: f64, high: f64) -> Term {
    given.number(name, Range::within(low, high))
}

fn verdicts(claim: impl Fn(Given) -> Vec<Goal>) -> [Verdict; 2] {
    [Format::F32, Format::F64].map(|format| judge(format, &claim, RUNS))
}

fn proves(claim: impl Fn(Given) -> Vec<Goal>) {
    assert_eq!(verdicts(claim), [Verdict::Proved, Verdict::Proved]);
}

/// The input that refutes a claim, in each format.
fn refutes(claim: impl Fn(Given) -> Vec<Goal>) -> [Vec<(String, f64)>; 2] {
    verdicts(claim).map(|verdict| match verdict {
        Verdict::Refuted(input) => input,
        other => panic!("{other}"),
    })
}

fn window<T: Real>(q: T, r: T) -> T {
    let share = q / r;
    T::ONE - share * share
}

#[test]
fn a_naive_window_is_refuted_and_a_right_one_proved() {
    let refuted = refutes(|given| {
        let (q, r) = (given.not_negative("q"), given.not_negative("r"));
        within(window(q, r), 0.0, 1.0)
    });
    for input in refuted {
        let (q, r) = (input[0].1, input[1].1);
        assert!(!(0.0..=1.0).contains(&window(q, r)), "{q} {r}");
    }
    proves(|given| {
        let r = Range::within(given.format().tiny(), given.format().max());
        let (q, r) = (given.not_negative("q"), given.number("r", r));
        within(window(q, r).at_least(Real::ZERO), 0.0, 1.0)
    });
}

#[test]
fn what_intervals_cannot_know_stays_open() {
    let halves = |given: Given| {
        let x = given.not_negative("x");
        within(x - x * Real::of(0.5), 0.0, INF)
    };
    for verdict in verdicts(halves) {
        assert!(matches!(verdict, Verdict::Open(_)), "{verdict}");
    }
}

#[test]
fn nan_and_minus_zero_are_told_apart() {
    let nothing = |x| vec![Goal::Within(x, Range::unsigned(0.0, 0.0))];
    // ∞ − ∞ is NaN, x − x is 0 without a sign
    let infinite = refutes(|given| {
        let x = number(given, "x", -INF, INF);
        nothing(x - x)
    });
    assert!(infinite.iter().all(|input| input[0].1.is_infinite()));
    proves(|given| {
        let x = number(given, "x", -1.0, 1.0);
        nothing(x - x)
    });
    refutes(|given| nothing(number(given, "x", -1.0, 1.0) * Real::ZERO));
}

#[test]
#[should_panic(expected = "F32: refuted by q = 0e0")]
fn a_test_shows_the_input() {
    shading_proofs::prove(|given| {
        let q = given.number("q", Range::unsigned(0.0, 0.0));
        within(q / q, 0.0, 1.0)
    });
}

/// What no format of few numbers has: a literal that is NaN, and a range between ends that are NaN.
#[test]
fn nan_is_no_limit() {
    refutes(|given| {
        let x = given.any("x");
        vec![Goal::AtMost(x * Real::ZERO, x.at_most(Real::of(f64::NAN)))]
    });
    // a range whose ends are no numbers holds nothing
    let [low, high] = [f64::NAN; 2];
    let nothing = Range {
        low,
        high,
        ..Range::ANY
    };
    refutes(move |given| vec![Goal::Within(given.any("x"), nothing)]);
}

#[test]
fn empty_claims_are_refused() {
    let refused = |why: &str, claim: fn(Given) -> Vec<Goal>| {
        for verdict in verdicts(claim) {
            let is_refused = matches!(&verdict, Verdict::Empty(text) if text.contains(why));
            assert!(is_refused, "{verdict}");
        }
    };
    refused("range of x", |given| {
        within(number(given, "x", 2.0, 1.0), -INF, INF)
    });
    refused("range of x", |given| {
        within(number(given, "x", f64::NAN, 1.0), -INF, INF)
    });
    refused("no goal", |given| {
        let x = number(given, "x", 0.0, 1.0);
        given.assume_above(x, Real::of(2.0));
        vec![Goal::Never]
    });
    refused("no goal", |given| {
        let _ = given.any("x");
        vec![]
    });
    refused("no goal", |given| {
        let is_above_all = given.any("x") > Real::of(INF);
        is_above_all.then_some(Goal::Never).into_iter().collect()
    });
    // the rules do not see that this is impossible, but no input satisfies it
    refused("satisfies", |given| {
        let x = number(given, "x", 1.0, 2.0);
        given.assume_above(x - x * Real::of(0.5), x);
        within(x, 0.0, 5.0)
    });
    // of two cases, one is empty
    refused("satisfies", |given| {
        let x = number(given, "x", 1.0, 2.0);
        if given.one_of(2) == 1 {
            given.assume_above(x - x * Real::of(0.5), x);
        }
        within(x, 1.0, 2.0)
    });
}

/// What a run with numbers computes has the bits of the float, operation by operation.
#[test]
fn the_number_that_records_computes_as_floats_do() {
    let usual = [0.0, -0.0, 1.0, -1.5, 3.0, INF, -INF, f64::NAN];
    let single = [1e-45_f32, 1.2e-38, 3.4e38, 0.1].map(f64::from);
    let numbers = [&usual[..], &single, &[5e-324, 1.7e308]].concat();
    let second = |x: &f64| numbers.iter().map(|y| (*x, *y)).collect::<Vec<_>>();
    for (x, y) in numbers.iter().flat_map(second) {
        #[allow(clippy::cast_possible_truncation)] // it is what `Real::of` does
        let single = formulas(x as f32, y as f32).map(f64::from);
        for (format, floats) in [(Format::F32, single), (Format::F64, formulas(x, y))] {
            let claim = |_: Given| {
                let terms: [Term; 23] = formulas(Real::of(x), Real::of(y));
                let pairs = terms.into_iter().zip(floats);
                pairs.map(|(x, y)| Goal::Same(x, Real::of(y))).collect()
            };
            assert_eq!(refute(format, claim, 1), None, "{x} {y} in {format:?}");
        }
    }
}

fn formulas<T: Real + PartialOrd>(x: T, y: T) -> [T; 23] {
    // in front by the rounded products of the smallest numbers, but not by the exact ones
    let n = [0.6, -0.4, -0.4].map(T::of).into();
    let v = Vec3::new(x, x, y);
    [
        if T::faces(n, v).any() {
            T::cosine(n, &T::toward(n, v))
        } else {
            T::NEG_ONE
        },
        if x.any_outside(T::ONE, T::of(4.0)) {
            T::ZERO
        } else {
            T::ONE
        },
        x + y,
        x - y,
        x * y,
        x / y,
        x * T::NEG_ONE,
        x / T::NEG_ONE,
        x.sqrt(),
        -x,
        x.above(y).select(x, y),
        x.above(T::ZERO).select(y, x),
        x.at_least(y),
        x.at_most(y),
        if x <= y { x } else { y },
        -(x * -y),
        -x * y,
        -x / y,
        x / -y,
        x + -y,
        -x + y,
        -x - -y,
        // what the path has decided is not recorded as a choice
        if x > y {
            x.above(y).select(x + y, y)
        } else {
            x.above(y).select(x, y - x)
        },
    ]
}
