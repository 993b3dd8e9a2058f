//! What arrives of a lamp, against the formula in exact integers, for every attenuation: a climb to the worst
//! case, in which every number is free, from one step to the ends of the range.

use shading::fixed::{Attenuation, Fixed, PointLight, Ranged, Rgb, Vec3};
use shading::{Falloff, Real};

use crate::{Random, exact, steps};

/// A lamp at the origin, and the point that it lights.
#[derive(Clone, Copy, Debug)]
struct Lamp {
    /// a, b, c, r, the intensity, and the coordinates of the point, in steps
    numbers: [i32; 8],
    is_clamped: bool,
    is_squared: bool,
}

impl Lamp {
    fn any(random: &mut Random, is_near: bool) -> Self {
        let numbers = std::array::from_fn(|i| {
            let magnitude = random.fixed().to_bits().saturating_abs();
            let is_zero = i < 3 && random.below(4) == 0;
            let is_none = i == 3 && random.below(2) == 0;
            match i {
                _ if is_zero => 0,
                3 if is_none => i32::MAX,
                5.. if is_near => magnitude >> 14,
                // so that no sum of squares is out of range
                5.. => magnitude / 2,
                _ => magnitude.max(1),
            }
        });
        let is_clamped = random.below(4) == 0;
        let is_squared = random.below(2) == 0;
        Self {
            numbers,
            is_clamped,
            is_squared,
        }
        .valid()
    }

    fn valid(mut self) -> Self {
        for number in &mut self.numbers {
            *number = number.saturating_abs();
        }
        if self.numbers[..3] == [0; 3] {
            self.numbers[2] = 1;
        }
        if self.numbers[5..] == [0; 3] {
            self.numbers[5] = 1;
        }
        self.numbers[3] = self.numbers[3].max(1);
        for coordinate in &mut self.numbers[5..] {
            *coordinate = (*coordinate).min(i32::MAX / 2);
        }
        self
    }

    /// A neighbor: some numbers are changed, by anything from a step to everything.
    fn changed(mut self, random: &mut Random) -> Self {
        for _ in 0..=random.below(2) {
            let number = &mut self.numbers[random.below(8)];
            let change = random.fixed().to_bits() >> random.below(31);
            *number = match random.below(8) {
                0 => change,
                1 => 0,
                _ => number.saturating_add(change),
            };
        }
        self.valid()
    }

    fn fixed(self) -> ([Fixed; 8], Attenuation) {
        let numbers = self.numbers.map(Fixed::from_bits);
        let [a, b, c, ..] = numbers;
        let attenuation = Attenuation::new(a, b, c).expect("coefficients");
        let attenuation = if self.is_clamped {
            attenuation.clamped()
        } else {
            attenuation
        };
        (numbers, attenuation)
    }

    fn within(self, attenuation: Attenuation, r: Fixed) -> Ranged {
        let ranged = attenuation.within(r).expect("a range");
        if self.is_squared {
            ranged
        } else {
            ranged.unsquared()
        }
    }

    /// What arrives, in steps.
    fn arriving(self) -> f64 {
        let ([_, _, _, r, intensity, x, y, z], attenuation) = self.fixed();
        let lamp = PointLight {
            position: Vec3::ZERO,
            // each channel for itself
            intensity: Rgb::new(Fixed::STEP, intensity, Fixed::MAX),
            attenuation: self.within(attenuation, r),
        };
        let ranged = lamp.at(Vec3::new(x, y, z)).intensity.g;
        if r == Fixed::MAX {
            let PointLight {
                position,
                intensity,
                ..
            } = lamp;
            let plain = PointLight {
                position,
                intensity,
                attenuation,
            };
            assert_eq!(plain.at(Vec3::new(x, y, z)).intensity.g, ranged, "{self:?}");
        }
        steps(ranged)
    }

    /// The formula in steps. The squares are exact, and so is 1 − q²/r². The rest is off by less than 2⁻⁴⁸.
    #[allow(clippy::cast_precision_loss)] // below 2⁻⁵²
    fn expected(self) -> f64 {
        let [a, b, c, r, intensity, ..] = self.numbers.map(f64::from);
        let square: i128 = self.numbers[5..]
            .iter()
            .map(|&c| i128::from(c).pow(2))
            .sum();
        let (square64, q) = (square as f64, (square as f64).sqrt());
        let step = 65536.0;
        let denominator = (a + b * q / step + c * square64 / (step * step)) / step;
        let factor = if self.is_clamped {
            (1.0 / denominator).min(1.0)
        } else {
            1.0 / denominator
        };
        let window = if self.numbers[3] == i32::MAX {
            1.0
        } else {
            let rest = i128::from(self.numbers[3]).pow(2) - square;
            let share = rest.max(0) as f64 / (r * r); // 1 − (q/r)²
            (share * (2.0 - share)).powi(if self.is_squared { 2 } else { 1 })
        };
        (intensity * (factor * window)).min(f64::from(i32::MAX))
    }

    /// The error as a multiple of what is promised: two steps, or 2⁻¹⁵.
    fn excess(self) -> f64 {
        let (arriving, expected) = (self.arriving(), self.expected());
        (arriving - expected).abs() / (expected / 32768.0).max(2.0)
    }
}

/// The searches that `SHADING_SEARCH=all` makes longer.
fn climbs() -> u32 {
    if std::env::var("SHADING_SEARCH").is_ok_and(|extent| extent == "all") {
        4000
    } else {
        60
    }
}

/// The denominator is exact but for q, of which half a step is at most 2⁻¹⁷; the denominator is rounded to half
/// a step, which is as much again if it is 1; its reciprocal is off by less than 2⁻¹⁸.
#[test]
fn what_arrives_is_within_two_steps_or_a_15th_power_of_one_half() {
    let mut random = Random(40);
    let mut worst = 0.0_f64;
    for climb in 0..climbs() {
        let mut lamp = (0..20)
            .map(|_| Lamp::any(&mut random, climb % 3 == 0))
            .max_by(|a, b| a.excess().total_cmp(&b.excess()))
            .expect("lamps");
        let mut excess = lamp.excess();
        for _ in 0..2000 {
            let other = lamp.changed(&mut random);
            let higher = other.excess();
            if higher >= excess {
                (lamp, excess) = (other, higher);
            }
        }
        let (arriving, expected) = (lamp.arriving(), lamp.expected());
        assert!(
            excess <= 1.0,
            "{lamp:?}: {arriving} for {expected} steps, {excess}"
        );
        worst = worst.max(excess);
    }
    println!("{worst:.3} of what is promised");
    assert!(worst > 0.5, "the climb finds no more than {worst}");
}

/// The lamps whose denominators are out of range today and tomorrow, by hand.
#[test]
fn lamps_far_away_are_dim() {
    let x = Fixed::new;
    let square = Attenuation::new(x(0.0), x(0.0), x(1.0)).expect("coefficients");
    for (intensity, q, expected) in [
        (20_000.0, 200.0, 0.5),
        (30_000.0, 1000.0, 0.03),
        (30_000.0, 30_000.0, 0.0),
    ] {
        let arriving = square.dim(&Rgb::gray(x(intensity)), x(q)).r;
        assert!(
            (exact(arriving) - expected).abs() <= 2.0 / 65536.0,
            "{arriving} at {q}"
        );
    }
}

/// Division by 1 gives back any number.
#[test]
fn lamps_without_attenuation_arrive_as_they_are() {
    let mut random = Random(41);
    let bright = [i32::MAX, i32::MAX - 1, 1 << 30, (1 << 30) + 1, 1].map(Fixed::from_bits);
    let some = (0..100_000).map(|_| Real::abs(random.fixed()));
    for intensity in bright.into_iter().chain(some.collect::<Vec<_>>()) {
        let q = Real::abs(random.fixed()).max(Fixed::STEP);
        for attenuation in [Attenuation::NONE, Attenuation::NONE.clamped()] {
            let color = Rgb::new(intensity, Fixed::MAX, Fixed::ZERO);
            assert_eq!(attenuation.dim(&color, q), color, "at {q}");
            assert_eq!(Ranged::from(attenuation).dim(&color, q), color, "at {q}");
        }
    }
}

/// From one step to the next, and to any distance, what arrives never rises, with a range and without.
#[test]
fn what_arrives_never_rises_with_the_distance() {
    let mut random = Random(42);
    for i in 0..60_000 {
        let lamp = Lamp::any(&mut random, false);
        let ([.., r, intensity, q, _, _], attenuation) = lamp.fixed();
        let ranged = attenuation.within(r).expect("a range");
        // often where the denominator is a power of two, where the distance is 1 unit, or the range ends
        let q = match i % 4 {
            0 => Fixed::ONE,
            1 => r,
            2 => root_of(lamp, 1_u64 << random.below(40)),
            _ => q,
        };
        let color = Rgb::new(intensity, Fixed::ONE, Fixed::STEP);
        let near = Fixed::from_bits(q.to_bits().saturating_sub(4).max(1));
        let mut last = (Rgb::gray(Fixed::MAX), Rgb::gray(Fixed::MAX));
        for k in 0..8 {
            let q = Fixed::from_bits(near.to_bits().saturating_add(k));
            let (plain, within) = (attenuation.dim(&color, q), ranged.dim(&color, q));
            let is_falling =
                |now: Rgb, last: Rgb| now.r <= last.r && now.g <= last.g && now.b <= last.b;
            assert!(
                is_falling(plain, last.0),
                "{lamp:?}: {plain:?} after {:?} at {q}",
                last.0
            );
            assert!(
                is_falling(within, last.1),
                "{lamp:?}: {within:?} after {:?} at {q}",
                last.1
            );
            assert!(
                is_falling(within, plain),
                "{lamp:?}: {within:?} above {plain:?} at {q}"
            );
            assert!(
                q < r || r == Fixed::MAX || within == Rgb::BLACK,
                "{lamp:?} at {q}"
            );
            last = (plain, within);
        }
    }
}

/// The distance at which the denominator is about so many steps.
fn root_of(lamp: Lamp, denominator: u64) -> Fixed {
    let [a, b, c, ..] = lamp.numbers.map(|number| f64::from(number) / 65536.0);
    #[allow(clippy::cast_precision_loss)] // a power of two
    let rest = denominator as f64 / 65536.0 - a;
    let q = if c > 0.0 {
        (-b + (b * b + 4.0 * c * rest).max(0.0).sqrt()) / (2.0 * c)
    } else {
        rest / b
    };
    Fixed::new(q).max(Fixed::STEP)
}
