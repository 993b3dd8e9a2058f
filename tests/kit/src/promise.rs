//! What holds of a result whatever the bits of the arguments, and, where they are valid, what holds
//! then. Each takes the numbers of the result, of which there are none if there is no result.

use core::f64::consts::PI;

use crate::given::Given;
use crate::number::Number;

/// Whether a result keeps its promise.
pub type Promise<T> = fn(&Given<T>, &[f64]) -> bool;

/// There is a result: nothing panics.
pub fn nothing<T: Number>(_: &Given<T>, _: &[f64]) -> bool {
    true
}

/// A direction has length 1 up to rounding. The squares and sums of the check are off by 3u, and
/// the normalizing by 3.5u, which counts twice in the square; an orthogonal axis is exact.
pub fn unit<T: Number>(_: &Given<T>, r: &[f64]) -> bool {
    is_unit::<T>(r, 10.0)
}

/// A direction, or the fallback.
pub fn unit_or_n<T: Number>(given: &Given<T>, r: &[f64]) -> bool {
    is_unit::<T>(r, 10.0) || is_same(r, n(given))
}

/// N or −N; a NaN is what it is.
pub fn n_or_opposite<T: Number>(given: &Given<T>, r: &[f64]) -> bool {
    let n = n(given);
    n.iter().any(|x| x.is_nan()) || is_same(r, n) || is_same(r, n.map(|x| -x))
}

/// Of length 1 if N and L are: 2(N·L)N − L has eleven roundings, which count twice in the square.
pub fn reflected<T: Number>(given: &Given<T>, r: &[f64]) -> bool {
    !given.is_valid || is_unit::<T>(r, 30.0)
}

/// Not longer than the largest angle.
pub fn at_most_pi_long<T: Number>(_: &Given<T>, r: &[f64]) -> bool {
    square(r) <= PI * PI * (1.0 + 16.0 * u::<T>())
}

/// From 0 to 1.
pub fn fraction<T: Number>(_: &Given<T>, r: &[f64]) -> bool {
    r.iter().all(|x| (0.0..=1.0).contains(x))
}

/// Cosines, the largest first.
pub fn cosines<T: Number>(_: &Given<T>, r: &[f64]) -> bool {
    r.iter().all(|x| (-1.0..=1.0).contains(x)) && r.is_sorted_by(|inner, outer| inner >= outer)
}

/// Neither negative nor NaN.
pub fn not_negative<T: Number>(_: &Given<T>, r: &[f64]) -> bool {
    r.iter().all(|x| *x >= 0.0)
}

/// Above zero and finite.
pub fn positive<T: Number>(_: &Given<T>, r: &[f64]) -> bool {
    r.iter().all(|x| *x > 0.0 && x.is_finite())
}

/// Neither negative nor NaN if the arguments are valid; the sum may overflow.
pub fn light<T: Number>(given: &Given<T>, r: &[f64]) -> bool {
    !given.is_valid || not_negative(given, r)
}

/// Light that arrives, if the arguments are valid: finite light, a distance, and a direction unless
/// the light is black.
pub fn arriving<T: Number>(given: &Given<T>, r: &[f64]) -> bool {
    let Some((direction, rest)) = r.split_first_chunk::<3>() else {
        return true;
    };
    let is_finite = |x: &f64| *x >= 0.0 && *x <= T::MAX.double();
    let is_black = *direction == [0.0; 3] && rest[..3] == [0.0; 3];
    let has_direction = is_unit::<T>(direction, 10.0) || is_black;
    !given.is_valid || has_direction && rest.iter().all(is_finite)
}

/// The unit roundoff.
fn u<T: Number>() -> f64 {
    T::EPSILON.double() / 2.0
}

fn n<T: Number>(given: &Given<T>) -> [f64; 3] {
    <[T; 3]>::from(given.n).map(T::double)
}

fn is_same(r: &[f64], v: [f64; 3]) -> bool {
    r.len() == 3
        && r.iter()
            .zip(v)
            .all(|(a, b)| *a == b || a.is_nan() && b.is_nan())
}

fn square(r: &[f64]) -> f64 {
    r.iter().map(|x| x * x).sum()
}

fn is_unit<T: Number>(r: &[f64], units: f64) -> bool {
    r.is_empty() || (square(r) - 1.0).abs() <= units * u::<T>()
}
