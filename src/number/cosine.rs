//! The cosine of a half-angle.

use core::f64::consts::FRAC_PI_2;

use super::{Mask, Real, constant, parts};

/// The cosine of an angle within [0, π], by + − × ÷ alone: for every number type, and in constants.
/// It is the sine or the cosine of an angle y of at most π/4, by its Taylor series, with −1 in place of
/// +1 for the cosine and without the factor y:
///
/// ```text
/// y (1 − y²/(2(2 + 1)) (1 − y²/(4(4 + 1)) (…)))
/// ```
///
/// π/2 is given as a number and the rest that this number leaves.
///
/// `$if_above!(a, b, x, y)` is x where a > b, and y elsewhere.
macro_rules! cosine {
    ($angle:expr, $one:expr, $half_pi:expr, $rest:expr, $if_above:ident) => {{
        let (angle, one, half_pi, rest) = ($angle, $one, $half_pi, $rest);
        let (two, quarter_pi) = (one + one, half_pi / (one + one));
        let before = half_pi - angle;
        let (sine, far) = (before + rest, (before + half_pi) + two * rest);
        // the cosine up to π/4, the sine to 3π/4, and minus the cosine
        macro_rules! third {
            ($near:expr, $middle:expr, $last:expr) => {{
                let not_near = $if_above!(angle, half_pi + quarter_pi, $last, $middle);
                $if_above!(angle, quarter_pi, not_near, $near)
            }};
        }
        let (y, odd) = (third!(angle, sine, far), third!(-one, one, -one));
        let (square, mut k, mut sum) = (y * y, two + two * two * two * two, one);
        // a whole number counts, because k of an odd number type might never reach 0
        let mut left = 9;
        while left > 0 {
            sum = one - square / (k * (k + odd)) * sum;
            k = k - two;
            left -= 1;
        }
        third!(sum, y * sum, -sum)
    }};
}

macro_rules! select {
    ($a:expr, $b:expr, $then:expr, $otherwise:expr) => {
        $a.above($b).select($then, $otherwise)
    };
}

macro_rules! choose {
    ($a:expr, $b:expr, $then:expr, $otherwise:expr) => {
        if $a > $b { $then } else { $otherwise }
    };
}

#[cold]
pub(crate) fn cosine<T: Real>(angle: T) -> T {
    const PARTS: [f32; 3] = parts(FRAC_PI_2);
    let [first, second, third] = PARTS;
    let half_pi = constant(PARTS);
    let rest = (T::of_f32(first) - half_pi) + T::of_f32(second) + T::of_f32(third);
    cosine!(angle, T::ONE, half_pi, rest + T::of_f32(BEYOND), select)
}

/// The part of π/2 that the nearest `f64` leaves.
const BEYOND: f32 = 6.123_234e-17;

pub(crate) const fn cosine_f32(angle: f32) -> f32 {
    const HALF_PI: f32 = core::f32::consts::FRAC_PI_2;
    cosine!(angle, 1.0, HALF_PI, -4.371_139e-8, choose)
}

#[allow(clippy::cast_lossless)] // `From` is not const
pub(crate) const fn cosine_f64(angle: f64) -> f64 {
    cosine!(angle, 1.0, FRAC_PI_2, BEYOND as f64, choose)
}
