//! The prover proves what is true, refutes what is not, and leaves open what it cannot know.

use shading::number::Mask;
use shading::{Elementary, Real, Vec3};
use shading_proofs::{Format, Given, Goal, Range, Term, Verdict, judge, refute};

const INF: f64 = f64::INFINITY;
const RUNS: u64 = 20_000;

fn within(x: Term, low: f64, high: f64) -> Vec<Goal> {
    vec![Goal::Within(x, Range::within(low, high))]
}

fn within_or_nan(x: Term, low: f64, high: f64) -> Vec<Goal> {
    vec![Goal::Within(x, Range::within(low, high).or_nan())]
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
        let [(_, q), (_, r)] = input[..] else {
            panic!("{input:?}");
        };
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
fn a_comparison_forks() {
    proves(|given| {
        let x = given.any("x");
        let size = if x < Real::ZERO { -x } else { x };
        let size = if size >= Real::ZERO { size } else { Real::ONE }; // NaN
        within(size, 0.0, INF)
    });
}

#[test]
fn the_length_of_a_part_is_at_most_that_of_the_whole() {
    proves(|given| {
        let v: Vec3<_> = given.vector("v", Range::within(-1e10, 1e10));
        v.unit().map_or(vec![], |unit| within(unit.x, -1.25, 1.25))
    });
}

#[test]
#[should_panic(expected = "F32: refuted by q = 0e0")]
fn a_test_shows_the_input() {
    shading_proofs::prove(|given| {
        let q = given.number("q", Range::unsigned(0.0, 0.0));
        within(q / q, 0.0, 1.0)
    });
}

/// Claims that a prover with wrong rules accepted, each beside one that it should.
#[test]
fn false_claims_are_not_proved() {
    // (r − s)/(0 · r + s) is −2 for r = −1 and s = 1
    let sums = |s: Range, least: f64, most: f64| {
        move |given: Given| {
            let (r, s) = (number(given, "r", -INF, 0.0), given.number("s", s));
            within_or_nan((r - s) / (r * Real::ZERO + s), least, most)
        }
    };
    refutes(sums(Range::within(0.0, INF), -1.0, 1.0));
    proves(sums(Range::unsigned(0.0, INF), -INF, 0.0));
    // a/(v · 0) is ∞ for a = 1, and a/b is ∞ for a = ∞ and b = MAX, whose product by 2.5 overflows
    let quotients = |largest: f64, times: f64, by: fn(Term) -> Term, most: f64| {
        move |given: Given| {
            let (a, b) = (number(given, "a", 0.0, largest), given.any("b"));
            if a > Elementary::abs(b) * Real::of(times) {
                return vec![];
            }
            within_or_nan(a / by(b), -most, most)
        }
    };
    for (largest, times, by) in [
        (10.0, 0.5, (|b| b * Real::ZERO) as fn(Term) -> Term),
        (INF, 2.5, |b| b),
    ] {
        refutes(quotients(largest, times, by, 4.0));
        proves(quotients(largest, times, by, INF));
    }
    // 2⁻²⁰⁰ of a number underflows in `f32`, and 2²⁰⁰ of 0 is 0
    let scaled = |format, low: f64, high: f64| {
        let claim = move |given: Given| {
            let [x, y] = [0.25, -0.4].map(|low| number(given, "x", low, low + 0.15));
            let [down, up] = [-100, 100].map(|power| Real::of(2.0_f64.powi(power)));
            let scaled = |t: Term| t * down * down * up * up;
            within(scaled(x) - scaled(y), low, high)
        };
        judge(format, claim, RUNS)
    };
    for (low, high) in [(0.5, 0.9), (5.0, 9.0)] {
        let verdict = scaled(Format::F32, low, high);
        assert!(matches!(verdict, Verdict::Refuted(_)), "{verdict}");
    }
    assert_eq!(scaled(Format::F64, 0.5, 0.9), Verdict::Proved);
    assert_eq!(scaled(Format::F32, 0.0, 0.0), Verdict::Proved);
    // nothing lies outside of limits of which one is NaN
    let outside = |low: Range| {
        move |given: Given| {
            let (x, low) = (number(given, "x", 0.5, 0.6), given.number("low", low));
            vec![if low <= x {
                Goal::Same(x, x)
            } else {
                Goal::Never
            }]
        }
    };
    refutes(outside(Range::within(0.0, 0.1).or_nan()));
    proves(outside(Range::within(0.0, 0.1)));
    // NaN as a literal
    refutes(|given| {
        let x = given.any("x");
        vec![Goal::AtMost(x * Real::ZERO, x.at_most(Real::of(f64::NAN)))]
    });
    // an infinite factor of 0, and a sum of opposite infinities
    refutes(|given| {
        let (x, y) = (given.not_negative("x"), given.not_negative("y"));
        within(x * y + x / y, 0.0, INF)
    });
    // NaN lies not below the edge, so 2 is chosen of the first two, and 1 of the others
    let chosen = |x: Range| {
        move |given: Given| {
            let (x, y) = (given.number("x", x), number(given, "y", 2.0, 9.0));
            let choose = |x: Term, [below, other]: [f64; 2]| {
                let [edge, below, other] = [5.0, below, other].map(Real::of);
                Real::above(edge, x).select(below, other)
            };
            let (first, second) = (choose(x, [0.0, 2.0]), choose(y, [1.0, 3.0]));
            vec![Goal::AtMost(first, second)]
        }
    };
    refutes(chosen(Range::within(0.0, 1.0).or_nan()));
    proves(chosen(Range::within(0.0, 1.0)));
    // a sum is at least one of its terms if the other is not negative, whichever that is
    for less in [-1.0, 0.0] {
        for is_first in [false, true] {
            let claim = move |given: Given| {
                let (x, more) = (
                    number(given, "x", -9.0, 9.0),
                    number(given, "more", less, 1.0),
                );
                let sum = if is_first { more + x } else { x + more };
                vec![Goal::AtMost(x, sum)]
            };
            if less < 0.0 {
                refutes(claim);
            } else {
                proves(claim);
            }
        }
    }
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
                let terms: [Term; 21] = formulas(Real::of(x), Real::of(y));
                let pairs = terms.into_iter().zip(floats);
                pairs.map(|(x, y)| Goal::Same(x, Real::of(y))).collect()
            };
            assert_eq!(refute(format, claim, 1), None, "{x} {y} in {format:?}");
        }
    }
}

fn formulas<T: Real + PartialOrd>(x: T, y: T) -> [T; 21] {
    [
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
