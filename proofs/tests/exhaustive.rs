//! Every rule of the prover with every operand, in formats of so few numbers that all can be tried:
//! each value must lie in the range that was derived for it, each answer must be that of the
//! numbers, and each goal that is proved must hold. The rules do not know in which format they are
//! used.

use shading::number::Mask;
use shading::{Lobe, Real};
use shading_proofs::tried::every;
use shading_proofs::{Format, Given, Goal, Range, Term};

const INF: f64 = f64::INFINITY;
/// Three exponent bits and three digits: 0, ±1/16 … ±14, ±∞ and NaN.
const SMALL: Format = Format::Small(3, 3);

/// Tries every claim with every input, in both formats of this size or in the smaller one.
fn check<I: std::fmt::Debug>(
    format: Format,
    forms: impl IntoIterator<Item = I>,
    claim: impl Fn(Given, &I) -> Vec<Goal>,
) {
    let mut compared = 0;
    for form in forms {
        match every(format, |given| claim(given, &form)) {
            Ok(values) => compared += values,
            Err(wrong) => panic!("{form:?}: {wrong}"),
        }
    }
    assert!(compared > 0);
}

/// Ranges of each kind: with and without NaN, −0, infinities, either sign, one number alone.
fn ranges() -> [Range; 10] {
    [
        Range::ANY,
        Range::within(-INF, INF),
        Range::within(0.0, INF),
        Range::unsigned(0.0, 14.0),
        Range::within(-INF, 0.0),
        Range::within(0.25, 2.0).or_nan(),
        Range::NOT_FINITE,
        Range::NAN,
        Range::within(0.0, 0.0),
        Range::within(-1.0, 14.0),
    ]
}

/// Each choice of one from each list.
fn pairs<A: Copy, B: Copy>(a: &[A], b: &[B]) -> Vec<(A, B)> {
    a.iter()
        .flat_map(|a| b.iter().map(move |b| (*a, *b)))
        .collect()
}

const CONSTANTS: [f64; 10] = [0.0, -0.0, 0.0625, 1.0, -1.0, 0.5, 2.5, 4.0, 14.0, INF];

/// The operation with this number.
#[allow(clippy::eq_op)] // a shape that a rule looks for
fn operation(op: usize, x: Term, y: Term) -> Term {
    match op {
        0 => x + y,
        1 => x - y,
        2 => x * y,
        3 => x / y,
        4 => x * x,
        5 => x.sqrt(),
        6 => x.above(-x).select(x, -x),
        7 => -x,
        8 => x.at_least(y),
        9 => x.at_most(y),
        10 => x.above(y).select(x - y, y - x),
        11 => x - x,
        _ => x.above(Term::ZERO).select(y, -x),
    }
}
const OPERATIONS: [usize; 13] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

/// All that may be claimed of two values.
fn all_of(x: Term, y: Term) -> Vec<Goal> {
    let zero = Term::ZERO;
    vec![
        Goal::Same(x, y),
        Goal::AtMost(x, y),
        Goal::AtMost(y, x),
        Goal::Within(x, Range::within(0.0, 1.0)),
        Goal::Within(x, Range::unsigned(0.0, INF).or_nan()),
        Goal::Within(x, Range::NOT_FINITE),
        Goal::Same(x + zero, x),
        Goal::Same(x.at_least(zero), x),
    ]
}

fn above_zero(x: Term) -> Goal {
    Goal::Within(x, Range::within(SMALL.tiny(), INF))
}

/// A decision, from which the rules learn. Returns whether it holds.
fn decide(test: usize, x: Term, y: Term) -> bool {
    match test {
        0 => x > y,
        1 => x <= y,
        2 => x == y,
        3 => x >= y,
        _ => x < y,
    }
}
const TESTS: [usize; 5] = [0, 1, 2, 3, 4];

/// Two operations, one inside the other.
#[test]
fn operations_on_operations() {
    let ranges = ranges();
    check(
        SMALL,
        pairs(
            &pairs(&OPERATIONS, &OPERATIONS),
            &pairs(&ranges[..6], &[0, 1, 4]),
        ),
        |given, &((f, g), (range, other))| {
            let (x, y) = (given.number("x", range), given.number("y", ranges[other]));
            let inner = operation(f, x, y);
            let outer = [operation(g, inner, y), operation(g, y, inner)];
            [
                all_of(outer[0], inner),
                all_of(outer[1], x),
                all_of(inner, y),
            ]
            .concat()
        },
    );
}

/// Constants as operands, as in x · 1, x + 0 and max(x, 0).
#[test]
fn operations_with_constants() {
    let forms = pairs(&pairs(&OPERATIONS, &CONSTANTS), &ranges());
    check(
        Format::Small(4, 3),
        forms,
        |given, &((op, constant), range)| {
            let (x, k) = (given.number("x", range), Term::of(constant));
            let results = [operation(op, x, k), operation(op, k, x)];
            // two selections that differ in what they compare
            let chosen = [k, Term::ONE].map(|limit| x.above(limit).select(Term::ONE, Term::ZERO));
            let turned = [k, Term::ONE].map(|y| y.above(x).select(Term::ONE, Term::ZERO));
            // what differs only in the order of operands, once a 0 is left out
            let (sum, product) = ((x + Term::ZERO) + k, (x + Term::ZERO) * k);
            let selected = |x: Term| k.above(x).select(x * k, x);
            let shifted = results.map(|result| operation(op, result, x));
            [
                all_of(results[0], x),
                all_of(results[1], x),
                all_of(shifted[0], x),
                all_of(chosen[0], chosen[1]),
                all_of(turned[0], turned[1]),
                all_of(sum, k + x),
                all_of(product, k * x),
                all_of(selected(x + Term::ZERO), selected(x)),
                all_of(x, shifted[1]),
            ]
            .concat()
        },
    );
}

/// What a decision shows of the operands of what it compares.
#[test]
fn decisions_about_operations() {
    let limits = [
        0.0, -0.0, 0.0625, -0.25, 1.0, -1.5, 2.0, 14.0, -14.0, INF, -INF,
    ];
    let [any, some] = [Range::ANY, Range::within(-1.0, 14.0)];
    let operands = pairs(&[any, some], &[any, some, Range::within(INF, INF)]);
    for test in TESTS {
        check(
            SMALL,
            pairs(&pairs(&OPERATIONS, &limits), &operands),
            |given, &((op, limit), (range, other))| {
                let (x, y) = (given.number("x", range), given.number("y", other));
                let result = operation(op, x, y);
                if decide(test, result, Term::of(limit)) {
                    all_of(x, result)
                } else {
                    all_of(y, x)
                }
            },
        );
    }
}

/// What two decisions about variables show, one after the other.
#[test]
fn decisions_about_decisions() {
    let ranges = [Range::ANY, Range::within(-1.0, 14.0), Range::NOT_FINITE];
    let forms = pairs(&pairs(&TESTS, &TESTS), &pairs(&ranges, &ranges));
    check(SMALL, forms, |given, &((first, second), (range, other))| {
        let (x, y) = (given.number("x", range), given.number("y", other));
        let shown = decide(first, x, y);
        let again = decide(second, y, x) == shown;
        let chosen = if again {
            x.above(y).select(x, y)
        } else {
            y.above(x).select(x, y)
        };
        [
            all_of(chosen, x),
            all_of(chosen, y),
            all_of(x * x, chosen),
            all_of(x / y, x),
            all_of(x - y, y - x),
            vec![above_zero(x - y), above_zero(y - x)],
        ]
        .concat()
    });
}

/// A component over the root of a sum that has its square, by a division and by a reciprocal.
#[test]
fn components_of_vectors() {
    for format in [SMALL, Format::Small(3, 5), Format::Small(4, 3)] {
        let kinds = [
            Range::ANY,
            Range::within(-INF, INF),
            Range::within(0.0, INF),
        ];
        let kinds = if format == SMALL {
            &kinds[..]
        } else {
            &kinds[..1]
        };
        let least = [0.0, 0.0625, 1.0];
        let forms = pairs(&pairs(kinds, kinds), &pairs(&least, &[0, 1, 2, 3, 4]));
        check(format, forms, |given, &((range, other), (least, form))| {
            let (x, y) = (given.number("x", range), given.number("y", other));
            let sum = match form {
                0 => x * x + y * y,
                1 => x * x + y,
                2 => y + x * x + y * y,
                3 => x * y + x * x,
                _ => y * y,
            };
            if sum > Term::of(least) {
                let root = sum.sqrt();
                let unit = x * (Term::ONE / root);
                [
                    all_of(unit, x / root),
                    all_of(unit * unit, unit),
                    all_of(x * (y / root), x),
                ]
                .concat()
            } else {
                all_of(x / sum.sqrt(), x)
            }
        });
    }
}

/// The order of two results, given that of the operands.
#[test]
fn order_of_results() {
    let ranges = [
        Range::ANY,
        Range::within(0.0, INF),
        Range::within(-4.0, -0.25),
        Range::within(0.25, 4.0),
    ];
    let forms = pairs(&pairs(&ranges, &ranges), &pairs(&TESTS[..2], &OPERATIONS));
    check(
        Format::Small(3, 2),
        forms,
        |given, &((range, other), (test, op))| {
            let (x, y, k) = (
                given.number("x", range),
                given.number("y", range),
                given.number("k", other),
            );
            if !decide(test, x, y) {
                return vec![];
            }
            let both = |op, k| [operation(op, x, k), operation(op, y, k)];
            let turned = |op, k| [operation(op, k, x), operation(op, k, y)];
            let (straight, back) = (both(op, k), turned(op, k));
            let nested = [
                operation(op, straight[0], back[0]),
                operation(op, straight[1], back[1]),
            ];
            let clamped = |x: Term| x.at_least(Term::ZERO).at_most(k);
            let limited = [clamped(straight[0]), clamped(straight[1])];
            let limits = [straight[0].at_most(x), straight[1].at_most(y)];
            let floors = [back[0].at_least(x), back[1].at_least(y)];
            let edges = [(x, 0), (y, 1)].map(|(z, i)| k.above(z).select(limited[i], Term::ONE));
            let chosen = [(x, 0), (y, 1)].map(|(z, i)| k.above(z).select(straight[i], back[i]));
            let masked = [0, 1].map(|i| k.above(Term::ONE).select(straight[i], back[i]));
            let added = [straight[0], straight[0] + back[0]];
            let pairs = [
                straight, back, nested, limited, limits, floors, edges, chosen, masked, added,
            ];
            pairs
                .into_iter()
                .flat_map(|[a, b]| {
                    [
                        Goal::AtMost(a, b),
                        Goal::AtMost(b, a),
                        Goal::Same(a, b),
                        Goal::Within(a / b, Range::within(1.0, INF).or_nan()),
                    ]
                })
                .collect()
        },
    );
}

/// What is assumed of powers, as far as a small format has it.
#[test]
fn powers_with_a_contract() {
    check(
        SMALL,
        pairs(&ranges(), &ranges()),
        |given, &(range, other)| {
            let (x, m) = (given.number("x", range), given.number("m", other));
            let power = m.raise(x);
            [all_of(power, x), all_of(power * m, power)].concat()
        },
    );
}

/// What is selected below an edge keeps the order of numbers, and NaN lies below no edge.
#[test]
fn order_of_selections() {
    let ranges = [Range::within(0.0, 1.0), Range::within(2.0, 4.0)].map(Range::or_nan);
    check(Format::Small(3, 2), ranges, |given, x| {
        let x = given.number("x", *x);
        let y = given.number("y", Range::within(2.0, 4.0));
        let edge = given.number("edge", Range::ANY);
        let [x, y] = [x, y].map(|z| edge.above(z).select(Term::ZERO, Term::ONE));
        vec![Goal::AtMost(x, y)]
    });
}
