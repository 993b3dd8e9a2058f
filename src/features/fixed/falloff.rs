//! What is left of a light at a distance: v/(a + bq + cq²), and within a range.
//!
//! The denominator is exact. It is rounded to a step from 1 to the largest number, and to 22 bits elsewhere,
//! and then its reciprocal is cut off. Each operation rises or falls with its arguments, rounded as it is,
//! and so what arrives never rises with q.

use super::product::{LONG_MULTIPLY, part, product64, upper, upper_signed};
use super::reciprocal::reciprocal;
use super::{Fixed, ONE};

/// A factor that is not negative: `share`/2³², or (1 + `share`/2³²) · 2^`up` if `up` is not negative.
#[derive(Clone, Copy)]
pub(super) struct Factor {
    share: u32,
    up: i32,
}

/// By how many bits a distance below 1 is finer than a step.
pub(super) const FINE: u32 = 15;

/// A distance in steps, given one that may be finer.
#[inline]
pub(super) const fn in_steps(finer: Fixed) -> Fixed {
    if finer.0 < 0 {
        Fixed(((-finer.0 >> (FINE - 1)) + 1) >> 1)
    } else {
        finer
    }
}

impl Factor {
    pub(super) const ONE: Self = Self { share: 0, up: 0 };

    /// 1/(a + bq + cq²). If q is negative, it is −q, and [`FINE`] bits finer than a step.
    #[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
    #[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
    pub(super) fn of(a: Fixed, b: Fixed, c: Fixed, q: Fixed) -> Self {
        if LONG_MULTIPLY && q.0 >= 0 {
            // the usual case; where flash is scarce, the general one does
            Self::reciprocal_of(a, b, c, q, 0)
        } else {
            Self::of_any(a, b, c, q)
        }
    }

    #[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline)]
    #[cfg_attr(
        not(all(target_arch = "arm", not(target_has_atomic = "32"))),
        cold,
        inline(never)
    )]
    fn of_any(a: Fixed, b: Fixed, c: Fixed, q: Fixed) -> Self {
        let fine = if q.0 < 0 { FINE } else { 0 };
        Self::reciprocal_of(a, b, c, Fixed(q.0.wrapping_abs()), fine)
    }

    /// 1/(a + bq + cq²), where q is so many bits finer than a step.
    #[inline(always)]
    fn reciprocal_of(a: Fixed, b: Fixed, c: Fixed, q: Fixed, fine: u32) -> Self {
        let [a, b, c, q] = [a.0 as u32, b.0 as u32, c.0 as u32, q.0 as u32];
        // b + cq in two words, 32 bits after the point, or `fine` more
        let (slope, carry) = c.wrapping_mul(q).overflowing_add(b << (16 + fine));
        let slope_above = upper(c, q) + (b >> (16 - fine)) + u32::from(carry);
        // times q, and a, in three words
        let low = slope.wrapping_mul(q);
        let product = upper(slope, q);
        if LONG_MULTIPLY && fine == 0 && slope_above == 0 {
            // the usual case, of few instructions
            let steps = (product + (low >> 31)).wrapping_add(a) as i32;
            if steps > ONE {
                return Self {
                    share: reciprocal(steps as u32),
                    up: -1,
                };
            }
        }
        let (mut middle, carry) = product.overflowing_add(a << (2 * fine));
        let mut high = (a >> 1 >> (31 - 2 * fine)) + u32::from(carry);
        if slope_above != 0 {
            let (sum, carry) = middle.overflowing_add(slope_above.wrapping_mul(q));
            middle = sum;
            high += upper(slope_above, q) + u32::from(carry);
        }
        // in steps
        let [above, steps, below] = if fine == 0 {
            [high, middle, low]
        } else {
            [
                high >> (2 * FINE),
                high << (32 - 2 * FINE) | middle >> (2 * FINE),
                middle << (32 - 2 * FINE),
            ]
        };
        let steps = steps.wrapping_add(below >> 31) as i32;
        if above == 0 && steps > ONE {
            Self {
                share: reciprocal(steps as u32),
                up: -1,
            }
        } else if above == 0 && steps == ONE {
            Self::ONE
        } else {
            Self::beyond(high, middle, low, 32 - 2 * fine as i32)
        }
    }

    /// The reciprocal of a denominator of three words, the highest in units of 2^shift steps, that is
    /// below 1 or above the largest number.
    #[cfg_attr(
        all(target_arch = "arm", not(target_has_atomic = "32")),
        inline(always)
    )]
    #[cfg_attr(
        not(all(target_arch = "arm", not(target_has_atomic = "32"))),
        cold,
        inline(never)
    )]
    fn beyond(mut high: u32, mut middle: u32, mut low: u32, mut shift: i32) -> Self {
        // from 2⁻⁴⁸ steps down, every light is the largest number
        while high == 0 && shift > -64 {
            [high, middle, low] = [middle, low, 0];
            shift -= 32;
        }
        while high >> 31 == 0 && shift > -64 {
            high = high << 1 | middle >> 31;
            middle = middle << 1 | low >> 31;
            low <<= 1;
            shift -= 1;
        }
        // 2⁵⁸ over the highest bits, from 2²⁶ to 2²⁷
        let share = reciprocal(high >> 10 | 1 << 21);
        if shift <= -16 {
            Self {
                share: share << 6,
                up: -16 - shift,
            }
        } else {
            Self {
                share: share >> (10 + shift).min(31),
                up: -1,
            }
        }
    }

    /// The factor, which is 1 at most if it is clamped.
    #[inline]
    pub(super) fn clamped(self, is_clamped: bool) -> Self {
        if is_clamped && self.up >= 0 {
            Self::ONE
        } else {
            self
        }
    }

    /// Multiplies v by the factor, rounded and saturated. It does so in place: on a Cortex-M0 a sum has no
    /// stack for another color.
    #[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
    #[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
    pub(super) fn scale(self, v: &mut [Fixed; 3]) {
        for c in v {
            *c = if LONG_MULTIPLY && self.up < 0 {
                Fixed(part(c.0, self.share))
            } else {
                self.times_any(*c)
            };
        }
    }

    #[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline)]
    #[cfg_attr(
        not(all(target_arch = "arm", not(target_has_atomic = "32"))),
        cold,
        inline(never)
    )]
    fn times_any(self, number: Fixed) -> Fixed {
        let up = self.up.clamp(0, 31);
        let shifted = number.0 << up;
        Fixed(if shifted >> up == number.0 {
            let whole = if self.up < 0 { 0 } else { shifted };
            part(shifted, self.share).saturating_add(whole)
        } else {
            number.0 >> 31 ^ i32::MAX
        })
    }

    /// The product with a share of at most 1.
    pub(super) fn within(self, window: Wide) -> Self {
        let factor = if self.up < 0 {
            Wide::new(self.share, -32)
        } else {
            Wide {
                mantissa: self.share >> 1 | 1 << 31,
                exponent: self.up - 31,
            }
        };
        let Wide { mantissa, exponent } = factor.times(window);
        if exponent <= -32 {
            let shift = (-32 - exponent) as u32;
            Self {
                share: mantissa.checked_shr(shift).unwrap_or(0),
                up: -1,
            }
        } else {
            Self {
                share: mantissa << 1,
                up: exponent + 31,
            }
        }
    }
}

/// A number that is not negative, of any size: `mantissa` · 2^`exponent`. The mantissa is 2³¹ or more, or 0
/// with a low exponent. Operations cut off what is beyond the mantissa.
#[derive(Clone, Copy)]
pub(super) struct Wide {
    mantissa: u32,
    exponent: i32,
}

impl Wide {
    fn new(mantissa: u32, exponent: i32) -> Self {
        let zeros = mantissa.leading_zeros() & 31;
        let exponent = if mantissa == 0 { -200 } else { exponent };
        Self {
            mantissa: mantissa << zeros,
            exponent: exponent - zeros as i32,
        }
    }

    fn times(self, other: Self) -> Self {
        Self::new(
            upper(self.mantissa, other.mantissa),
            self.exponent + other.exponent + 32,
        )
    }
}

/// 1 − (q/r)⁴ or its square, where q is the length of a vector; 0 from r on.
///
/// With e = r² − q², which is exact, 1 − (q/r)⁴ is e(2r² − e)/r⁴.
#[inline(never)]
pub(super) fn window(v: &[Fixed; 3], r: Fixed, is_squared: bool) -> Wide {
    let square = |c: Fixed| product64(c.0, c.0) as u64;
    let range = square(r);
    let rest = range.saturating_sub(square(v[0]) + square(v[1]) + square(v[2]));
    if rest == 0 {
        return Wide::new(0, 0);
    }
    // 31 bits of r², and 30 of e, so that the product rises with e although 2r² − e falls
    let (shift, rest_shift) = (range.leading_zeros(), rest.leading_zeros());
    let range = (range << shift >> 33) as u32;
    let rest = (rest << rest_shift >> 34) as u32;
    let other = 2 * range - ((2 * rest) >> (rest_shift - shift).min(31));
    let product = Wide::new(
        upper(rest << 2, other),
        1 + shift as i32 - rest_shift as i32,
    );
    let root = product.times(precise_reciprocal(upper(range << 1, range << 1)));
    if is_squared { root.times(root) } else { root }
}

/// 1/x, cut off, by Newton's method; x is from 2³⁰ on.
fn precise_reciprocal(x: u32) -> Wide {
    let Wide { mantissa, exponent } = Wide::new(x, 0);
    let y = reciprocal(mantissa >> 10) << 5; // 2⁶³/mantissa
    let error = (1_u32 << 31).wrapping_sub(upper(mantissa, y)) as i32;
    let y = i64::from(y) + i64::from(upper_signed((y >> 1) as i32, error << 2)) - 2;
    Wide::new(y.min(u32::MAX.into()) as u32, -63 - exponent)
}
