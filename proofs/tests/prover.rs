//! The prover proves what is true, refutes what is not, and leaves open what it cannot know.

use shading::{Real, Vec3};
use shading_proofs::{Format, Given, Goal, Range, Term, Verdict, judge, refute};

const INF: f64 = f64::INFINITY;
const RUNS: u64 = 20_000;

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
    let share = Range::within(0.0, 1.0);
    let refuted = refutes(|given| {
        let (q, r) = (given.not_negative("q"), given.not_negative("r"));
        vec![Goal::Within(window(q, r), share)]
    });
    for input in refuted {
        let [(_, q), (_, r)] = input[..] else {
            panic!("{input:?}");
        };
        assert!(!share.contains(window(q, r)), "{q} {r}");
    }
    proves(|given| {
        let r = Range::within(given.format().tiny(), given.format().max());
        let (q, r) = (given.not_negative("q"), given.number("r", r));
        vec![Goal::Within(window(q, r).at_least(Real::ZERO), share)]
    });
}

#[test]
fn what_intervals_cannot_know_stays_open() {
    let halves = |given: Given| {
        let x = given.not_negative("x");
        let half = x * Real::of(0.5);
        vec![Goal::Within(x - half, Range::within(0.0, INF))]
    };
    for verdict in verdicts(halves) {
        assert!(matches!(verdict, Verdict::Open(_)), "{verdict}");
    }
}

#[test]
fn nan_and_minus_zero_are_told_apart() {
    // ∞ − ∞ is NaN, x − x is 0 without a sign
    let infinite = refutes(|given| {
        let x = given.number("x", Range::within(-INF, INF));
        vec![Goal::Within(x - x, Range::within(0.0, 0.0))]
    });
    assert!(infinite.iter().all(|input| input[0].1.is_infinite()));
    proves(|given| {
        let x = given.number("x", Range::within(-1.0, 1.0));
        vec![Goal::Within(x - x, Range::unsigned(0.0, 0.0))]
    });
    refutes(|given| {
        let x = given.number("x", Range::within(-1.0, 1.0));
        vec![Goal::Within(x * Real::ZERO, Range::unsigned(0.0, 0.0))]
    });
}

#[test]
fn a_comparison_forks() {
    proves(|given| {
        let x = given.any("x");
        let size = if x < Real::ZERO { -x } else { x };
        let size = if size >= Real::ZERO { size } else { Real::ONE }; // NaN
        vec![Goal::Within(size, Range::within(0.0, INF))]
    });
}

#[test]
fn the_length_of_a_part_is_at_most_that_of_the_whole() {
    proves(|given| {
        let v: Vec3<_> = given.vector("v", Range::within(-1e10, 1e10));
        let Some(unit) = v.unit() else {
            return vec![];
        };
        vec![Goal::Within(unit.x, Range::within(-1.25, 1.25))]
    });
}

#[test]
#[should_panic(expected = "F32: refuted by q = 0e0")]
fn a_test_shows_the_input() {
    shading_proofs::prove(|given| {
        let q = given.number("q", Range::unsigned(0.0, 0.0));
        vec![Goal::Within(q / q, Range::within(0.0, 1.0))]
    });
}

/// Claims that a prover with wrong rules accepted, each beside one that it should.
#[test]
fn false_claims_are_not_proved() {
    let number = |given: Given, name: &str, low, high| given.number(name, Range::within(low, high));
    // (r − s)/(0 · r + s) is −2 for r = −1 and s = 1
    let sums = |s: Range, least: f64, most: f64| {
        move |given: Given| {
            let (r, s) = (number(given, "r", -INF, 0.0), given.number("s", s));
            let quotient = (r - s) / (r * Real::ZERO + s);
            vec![Goal::Within(quotient, Range::within(least, most).or_nan())]
        }
    };
    refutes(sums(Range::within(0.0, INF), -1.0, 1.0));
    proves(sums(Range::unsigned(0.0, INF), -INF, 0.0));
    // a/(v · 0) is ∞ for a = 1
    let by_nothing = |most: f64| {
        move |given: Given| {
            let (a, v) = (number(given, "a", 0.0, 10.0), given.any("v"));
            if a > abs(v) * Real::of(0.5) {
                return vec![];
            }
            vec![Goal::Within(
                a / (v * Real::ZERO),
                Range::within(-most, most).or_nan(),
            )]
        }
    };
    refutes(by_nothing(4.0));
    proves(by_nothing(INF));
    // a/b is ∞ for a = ∞ and b = MAX, whose product by 2.5 overflows
    let overflowing = |most: f64| {
        move |given: Given| {
            let (a, b) = (number(given, "a", 0.0, INF), given.any("b"));
            if a > abs(b) * Real::of(2.5) {
                return vec![];
            }
            vec![Goal::Within(a / b, Range::within(-most, most).or_nan())]
        }
    };
    refutes(overflowing(4.0));
    proves(overflowing(INF));
    // 2⁻²⁰⁰ of a number underflows in `f32`, and 2²⁰⁰ of 0 is 0
    let scaled = |low: f64, high: f64| {
        move |given: Given| {
            let (x, y) = (
                number(given, "x", 0.25, 0.4),
                number(given, "y", -0.4, -0.25),
            );
            let [down, up] = [-100, 100].map(|power| Real::of(2.0_f64.powi(power)));
            let scaled = |t: Term| t * down * down * up * up;
            vec![Goal::Within(
                scaled(x) - scaled(y),
                Range::within(low, high),
            )]
        }
    };
    for (low, high) in [(0.5, 0.9), (5.0, 9.0)] {
        let verdict = judge(Format::F32, scaled(low, high), RUNS);
        assert!(matches!(verdict, Verdict::Refuted(_)), "{verdict}");
    }
    assert_eq!(judge(Format::F64, scaled(0.5, 0.9), RUNS), Verdict::Proved);
    assert_eq!(judge(Format::F32, scaled(0.0, 0.0), RUNS), Verdict::Proved);
    // nothing lies outside of limits of which one is NaN
    let outside = |low: Range| {
        move |given: Given| {
            let (x, low) = (number(given, "x", 0.5, 0.6), given.number("low", low));
            if low <= x {
                vec![Goal::Same(x, x)]
            } else {
                vec![Goal::Never]
            }
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
        vec![Goal::Within(x * y + x / y, Range::within(0.0, INF))]
    });
    // a range whose ends are no numbers holds nothing
    refutes(|given| {
        vec![Goal::Within(
            given.any("x"),
            Range {
                low: f64::NAN,
                high: f64::NAN,
                ..Range::ANY
            },
        )]
    });
}

#[test]
fn empty_claims_are_refused() {
    let refused = |claim: fn(Given) -> Vec<Goal>, why: &str| {
        for verdict in verdicts(claim) {
            assert!(
                matches!(&verdict, Verdict::Empty(text) if text.contains(why)),
                "{verdict}"
            );
        }
    };
    refused(
        |given| {
            vec![Goal::Within(
                given.number("x", Range::within(2.0, 1.0)),
                Range::NONE,
            )]
        },
        "range of x",
    );
    refused(
        |given| {
            vec![Goal::Same(
                given.number("x", Range::within(f64::NAN, 1.0)),
                Real::ZERO,
            )]
        },
        "range of x",
    );
    refused(
        |given| {
            let x = given.number("x", Range::within(0.0, 1.0));
            given.assume_above(x, Real::of(2.0));
            vec![Goal::Never]
        },
        "no goal",
    );
    // the rules do not see that this is impossible, but no input satisfies it
    refused(
        |given| {
            let x = given.number("x", Range::within(1.0, 2.0));
            given.assume_above(x - x * Real::of(0.5), x);
            vec![Goal::Within(x, Range::within(0.0, 5.0))]
        },
        "satisfies",
    );
    refused(
        |given| {
            let _ = given.any("x");
            vec![]
        },
        "no goal",
    );
    refused(
        |given| {
            if given.any("x") > Real::of(INF) {
                vec![Goal::Never]
            } else {
                vec![]
            }
        },
        "no goal",
    );
    // of two cases, one is empty
    refused(
        |given| {
            let x = given.number("x", Range::within(1.0, 2.0));
            if given.one_of(2) == 1 {
                given.assume_above(x - x * Real::of(0.5), x);
            }
            vec![Goal::Within(x, Range::within(1.0, 2.0))]
        },
        "satisfies",
    );
}

/// What a run with numbers computes has the bits of the float, operation by operation.
#[test]
fn the_number_that_records_computes_as_floats_do() {
    let single = [1e-45_f32, 1.2e-38, 3.4e38, 0.1].map(f64::from);
    let numbers = [
        0.0,
        -0.0,
        1.0,
        -1.5,
        3.0,
        5e-324,
        1.7e308,
        INF,
        -INF,
        f64::NAN,
    ];
    let numbers = [&single[..], &numbers].concat();
    for (x, y) in numbers
        .iter()
        .flat_map(|x| numbers.iter().map(move |y| (*x, *y)))
    {
        #[allow(clippy::cast_possible_truncation)] // it is what `Real::of` does
        let single = formulas(x as f32, y as f32).map(f64::from);
        for (format, floats) in [(Format::F32, single), (Format::F64, formulas(x, y))] {
            let claim = |_: Given| {
                let terms: [Term; 12] = formulas(Real::of(x), Real::of(y));
                terms
                    .into_iter()
                    .zip(floats)
                    .map(|(term, float)| Goal::Same(term, Real::of(float)))
                    .collect()
            };
            assert_eq!(refute(format, claim, 1), None, "{x} {y} in {format:?}");
        }
    }
}

fn abs(x: Term) -> Term {
    shading::Elementary::abs(x)
}

fn formulas<T: Real + PartialOrd>(x: T, y: T) -> [T; 12] {
    [
        x + y,
        x - y,
        x * y,
        x / y,
        x.sqrt(),
        -x,
        x.if_above(y, x, y),
        x.if_positive(y, x),
        x.at_least(y),
        x.at_most(y),
        if x <= y { x } else { y },
        -(x * -y),
    ]
}
