//! The prover proves what is true, refutes what is not, and leaves open what it cannot know.

use shading::{Real, Vec3};
use shading_proofs::{Format, Given, Goal, Range, Verdict, judge};

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
fn directions_have_cosines_up_to_one() {
    proves(|given| {
        let limit = 1.0 + 32.0 * given.format().u();
        let cosine = given.unit("n").dot(given.unit("l"));
        vec![Goal::Within(cosine, Range::within(-limit, limit))]
    });
    refutes(|given| {
        let cosine = given.unit("n").dot(given.unit("l"));
        vec![Goal::Within(cosine, Range::within(-0.999, 0.999))]
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

/// What a rounded operation gives lies in the range of its arguments' ranges, for the numbers at which
/// operations change their ways.
#[test]
fn every_operation_stays_in_its_range() {
    let ends = [
        -INF, -1e300, -2.5, -1.0, -1e-320, 0.0, 1e-320, 1.0, 3.0, 1e300, INF,
    ];
    let ranges = || {
        let pairs = ends.iter().flat_map(|a| ends.iter().map(move |b| (*a, *b)));
        let numbers = pairs.filter(|(a, b)| a <= b);
        numbers.flat_map(|(a, b)| [Range::within(a, b), Range::unsigned(a, b).or_nan()])
    };
    let inside = |range: Range| {
        let all = ends.into_iter().chain([-0.0, f64::NAN, 0.3, -7.0]);
        all.filter(move |x| range.contains(*x))
    };
    for a in ranges() {
        for b in ranges() {
            for x in inside(a) {
                for y in inside(b) {
                    operations_contain(a, b, x, y);
                }
            }
        }
    }
}

fn operations_contain(a: Range, b: Range, x: f64, y: f64) {
    let results = [
        (a.add(b, Format::F64), x + y),
        (a.sub(b, Format::F64), x - y),
        (a.mul(b, Format::F64), x * y),
        (a.div(b, Format::F64), x / y),
        (a.square(Format::F64), x * x),
        (a.sqrt(Format::F64), x.sqrt()),
        (a.abs(), x.abs()),
        (a.opposite(), -x),
    ];
    for (operation, (range, result)) in results.into_iter().enumerate() {
        assert!(
            range.contains(result),
            "{operation}: {x} of {a:?}, {y} of {b:?}: {result} is not in {range:?}"
        );
    }
}
