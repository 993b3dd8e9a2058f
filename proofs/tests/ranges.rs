//! Interval operations of the prover, with every range and every number of a small format.

use shading_proofs::{Format, Range};

const INF: f64 = f64::INFINITY;

/// Each choice of a low end and of a high one.
fn ends(numbers: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let of = |low: &f64| numbers.iter().map(|high| (*low, *high)).collect::<Vec<_>>();
    numbers.iter().flat_map(of)
}

/// Interval operations: every pair of ranges, with every pair of their numbers.
#[test]
fn ranges_hold_what_operations_give() {
    type Operation = (fn(Range, Range, Format) -> Range, fn(f64, f64) -> f64);
    let operations: [Operation; 7] = [
        (Range::add, |x, y| x + y),
        (Range::sub, |x, y| x - y),
        (Range::mul, |x, y| x * y),
        (Range::div, |x, y| x / y),
        (|range, _, f| range.sqrt(f), |x, _| x.sqrt()),
        (|range, _, f| range.square(f), |x, _| x * x),
        (|range, _, _| range.opposite(), |x, _| -x),
    ];
    let f = Format::Small(2, 3);
    let numbers = f.numbers();
    let mut ranges = vec![Range::NONE, Range::NAN, Range::NOT_FINITE];
    for (low, high) in ends(&numbers) {
        for range in [Range::within(low, high), Range::unsigned(low, high)] {
            ranges.extend((!ranges.contains(&range)).then_some(range));
        }
    }
    let some = ranges.iter().step_by(7).map(|range| range.or_nan());
    ranges.extend(some.collect::<Vec<_>>());
    let inside = |range: &Range| -> Vec<f64> {
        let inside = numbers.iter().copied();
        inside.filter(|x| range.contains(*x)).collect()
    };
    let ranges: Vec<_> = ranges.iter().map(|range| (*range, inside(range))).collect();
    for (a, xs) in &ranges {
        for (b, ys) in &ranges {
            for (op, (of_ranges, of_numbers)) in operations.iter().enumerate() {
                let range = of_ranges(*a, *b, f);
                let ys = if op < 4 { &ys[..] } else { &[0.0] };
                for (x, y) in xs.iter().flat_map(|x| ys.iter().map(move |y| (*x, *y))) {
                    assert!(
                        range.contains(f.round(of_numbers(x, y))),
                        "operation {op} of {x} in {a:?} and {y} in {b:?} gives {range:?}"
                    );
                }
            }
            let (both, covers) = (a.meet(*b), a.covers(*b));
            assert!(xs.iter().all(|x| both.contains(*x) || !b.contains(*x)));
            assert!(!covers || ys.iter().all(|y| a.contains(*y)));
        }
    }
}

/// The ends of a range need not be numbers of the format.
#[test]
fn a_variable_has_the_numbers_of_its_range() {
    let f = Format::Small(3, 3);
    let numbers = [
        -INF, -20.0, -14.0, -0.3, -0.01, 0.0, 0.01, 0.26, 0.3, 1.0, 13.9, 20.0, INF,
    ];
    for (low, high) in ends(&numbers) {
        for range in [
            Range::within(low, high),
            Range::unsigned(low, high).or_nan(),
        ] {
            for x in f.numbers() {
                let of_format = range.of_format(f);
                assert_eq!(range.contains(x), of_format.contains(x), "{x} {range:?}");
            }
        }
    }
}
