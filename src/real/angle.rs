//! The cosine of a half-angle, for any number type, computed with + − × ÷ alone.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::{Real, constant, parts};

const HALF_PI: [f32; 3] = parts(FRAC_PI_2);
/// The amount by which π/2 exceeds its nearest `f64`.
const REST: [f32; 3] = parts(6.123_233_995_736_766e-17);

/// `None` outside [0, π]. For `f32` and `f64` it has the bits of the constructors that work in
/// constants.
pub(super) fn cosine_of_half_angle<T: Real + PartialOrd>(radians: T) -> Option<T> {
    let [quarter, half, pi] = [
        constant(const { parts(FRAC_PI_4) }),
        constant::<T>(HALF_PI),
        constant(const { parts(PI) }),
    ];
    if !(radians >= T::ZERO && radians <= pi) {
        return None;
    }
    // what the number nearest to π/2 lacks
    let [first, second, third] = HALF_PI;
    let first = T::of_f32(first) - half;
    let rest = first + T::of_f32(second) + T::of_f32(third) + constant(REST);
    // each case needs only the sine of an angle of at most π/4
    Some(if radians < quarter {
        cosine_of_small(radians)
    } else if radians < quarter + half {
        sine_of_small((half - radians) + rest)
    } else {
        -cosine_of_small((pi - radians) + (rest + rest))
    })
}

/// cos x = 1 − 2 sin²(x/2)
fn cosine_of_small<T: Real>(x: T) -> T {
    let two = T::ONE + T::ONE;
    let sine = sine_of_small(x / two);
    T::ONE - two * sine * sine
}

/// The Taylor series, for |x| ≤ π/4.
fn sine_of_small<T: Real>(x: T) -> T {
    let (mut sum, mut term, mut k) = (T::ZERO, x, T::ONE);
    for _ in 0..10 {
        sum = sum + term;
        let (next, after) = (k + T::ONE, k + T::ONE + T::ONE);
        term = -term * x * x / (next * after);
        k = after;
    }
    sum
}
