//! The cosine of a half-angle, with integers alone, for constants as well.

use super::Fixed;
use super::product::upper;

/// π in steps.
pub(super) const PI: i32 = 205_887;

/// The cosine of an angle within [0, π], within 0.5001 of a step. It is the series that other numbers take, with
/// 30 bits after the point.
///
/// ```text
/// y (1 − y²/(2(2 + 1)) (1 − y²/(4(4 + 1)) (…)))
/// ```
pub(super) const fn cosine(Fixed(angle): Fixed) -> Fixed {
    const HALF_PI: i32 = 1_686_629_713;
    const QUARTER: i32 = PI / 4;
    let angle = if angle < 0 {
        0
    } else if angle > PI {
        PI
    } else {
        angle
    };
    let is_sine = QUARTER < angle && angle < 3 * QUARTER;
    let before_half_pi = HALF_PI.wrapping_sub(angle.wrapping_mul(1 << 14));
    let (y, sign) = if is_sine {
        (before_half_pi, 1)
    } else if angle <= QUARTER {
        (angle << 14, 1)
    } else {
        (before_half_pi.wrapping_add(HALF_PI), -1)
    };
    let odd = if is_sine { 1 } else { -1 };
    let square = upper(2 * y, 2 * y); // 30 bits, as y has
    let (mut sum, mut k) = (1 << 30, 10);
    while k > 0 {
        sum = (1 << 30) - (upper(2 * square, sum) * 2) / (k * (k + odd));
        k -= 2;
    }
    let cosine = if is_sine {
        upper(2 * y, sum) * 2
    } else {
        sign * sum
    };
    Fixed((cosine + (1 << 13)) >> 14)
}
