//! No light rises as the distance or a coefficient does, not by a step: cases that once did, a climb to the
//! worst case, and the reciprocal for every number that it tells apart.

use std::env;
use std::time::{Duration, Instant};

use shading::fixed::{Attenuation, Fixed, Rgb};
use shading::{Real, attenuation};

use crate::{Random, exact, reciprocal, steps};

/// A light after a distance: what the climb changes.
#[derive(Clone, Copy, Debug)]
struct Given {
    color: Fixed,
    /// a, b, c and q
    arguments: [Fixed; 4],
    limit: Fixed,
    range: Fixed,
    is_gltf: bool,
}

impl Given {
    /// The light as a sum over lights takes it.
    fn light(&self) -> Fixed {
        let [a, b, c, q] = self.arguments;
        let dimmed = Fixed::attenuated(Rgb::gray(self.color), [a, b, c], q, self.limit);
        dimmed.color.r * dimmed.factor
    }

    /// The factor, within a range.
    fn factor(&self) -> Option<Fixed> {
        let [a, b, c, q] = self.arguments;
        let some = Attenuation::new(a, b, c)?.clamped_to(self.limit)?;
        let ranged = if self.is_gltf {
            some.within_gltf(self.range)?
        } else {
            some.within(self.range)?
        };
        Some(ranged.at(q))
    }

    /// a + bq + cq²
    fn denominator(&self) -> f64 {
        let [a, b, c, q] = self.arguments.map(exact);
        a + q * (b + c * q)
    }

    /// The light of the formula, in steps.
    fn exact(&self) -> f64 {
        let factor = (1.0 / self.denominator()).min(exact(self.limit));
        (steps(self.color) * factor).min(steps(Fixed::MAX))
    }

    /// The same with one of a, b, c and q greater by a step.
    fn with_a_step(mut self, argument: usize) -> Self {
        self.arguments[argument] += Fixed::STEP;
        self
    }

    /// How near to a rise it is: the greatest difference that rounding makes to the fall by a step, in
    /// steps, or in parts of 2²⁴ of a bright light. Fails if there is a rise, or if a limit brightens.
    fn lift(&self) -> f64 {
        let (light, factor, exactly) = (self.light(), self.factor(), self.exact());
        let unlimited = Given {
            limit: Fixed::MAX,
            ..*self
        };
        let limited = unlimited.light().min(self.color * self.limit);
        assert!(self.limit == Fixed::MAX || light <= limited, "{self:?}");
        let lifts = [0, 1, 2, 3].map(|argument| {
            let next = self.with_a_step(argument);
            assert!(
                next.light() <= light,
                "light rises with {argument}: {self:?}"
            );
            assert!(
                next.factor() <= factor || factor.is_none(),
                "{argument}: {self:?}"
            );
            steps(next.light()) - steps(light) - (next.exact() - exactly)
        });
        lifts.into_iter().fold(f64::MIN, f64::max) / (1.0 + exactly / f64::from(1 << 24))
    }
}

/// A number that is not negative, of any magnitude.
fn some(random: &mut Random) -> Fixed {
    Fixed::from_bits(random.fixed().to_bits() & i32::MAX)
}

/// A denominator near which two ways to compute it may meet: 1, a power of two, and the largest number.
fn meeting(random: &mut Random) -> f64 {
    match random.below(4) {
        0 | 1 => 1.0,
        2 => 32_768.0,
        _ => 2.0_f64.powi(i32::try_from(random.below(40)).expect("small") - 20),
    }
}

/// A number off by up to four steps.
fn beside(random: &mut Random, number: f64) -> Fixed {
    let off = i32::try_from(random.below(9)).expect("small") - 4;
    Fixed::new(number).at_least(Fixed::ZERO) + Fixed::from_bits(off).at_least(-Fixed::new(number))
}

/// Changes a, or q, so that the denominator is nearly a given number.
fn take_to(given: &mut Given, random: &mut Random, denominator: f64) {
    let [a, b, c, q] = given.arguments.map(exact);
    if random.below(2) == 0 {
        given.arguments[0] = beside(random, denominator - q * (b + c * q));
    } else {
        let rest = (denominator - a).max(0.0);
        given.arguments[3] = beside(random, 2.0 * rest / (b + (b * b + 4.0 * c * rest).sqrt()));
    }
}

fn drawn(random: &mut Random) -> Given {
    let mut given = Given {
        color: [Fixed::ONE, Fixed::MAX, some(random)][random.below(3)],
        arguments: [(); 4].map(|()| some(random)),
        limit: [Fixed::MAX, Fixed::MAX, Fixed::ONE, some(random)][random.below(4)],
        range: [Fixed::MAX, some(random)][random.below(2)],
        is_gltf: random.below(2) == 0,
    };
    if random.below(4) == 0 {
        given.arguments[random.below(3)] = Fixed::ZERO;
    }
    if random.below(8) != 0 {
        let denominator = meeting(random);
        take_to(&mut given, random, denominator);
    }
    given
}

/// The same but for a number or two.
fn changed(mut given: Given, random: &mut Random) -> Given {
    let argument = random.below(4);
    let before = given.arguments[argument].to_bits();
    let off = random.fixed().to_bits() >> random.below(32);
    given.arguments[argument] = Fixed::from_bits(before.wrapping_add(off) & i32::MAX);
    match random.below(8) {
        0 => given.color = some(random),
        1 => given.color = Fixed::from_bits(given.color.to_bits() ^ 1 << random.below(31)),
        2 | 3 => {
            let denominator = given.denominator();
            take_to(&mut given, random, denominator);
        }
        4 => {
            let denominator = meeting(random);
            take_to(&mut given, random, denominator);
        }
        _ => {}
    }
    given
}

/// Climbs from lights drawn at random to where rounding lifts a light most, until the time is over. Returns
/// the number of lights tried, each with a step more of a, b, c and q.
fn climb(seed: u64, go_on: impl Fn(u64) -> bool) -> u64 {
    let mut random = Random(seed);
    let mut tried = 0;
    while go_on(tried) {
        let mut best = drawn(&mut random);
        let mut highest = best.lift();
        let mut failures = 0;
        while failures < 60 {
            let next = changed(best, &mut random);
            let lift = next.lift();
            tried += 1;
            failures += 1;
            if lift > highest {
                (best, highest, failures) = (next, lift, 0);
            }
        }
    }
    tried
}

#[test]
fn no_light_rises_with_a_step() {
    assert!(climb(1, |tried| tried < 300_000) >= 300_000);
}

/// For an hour, or as many seconds as `SHADING_SECONDS` says; the seed is 2, or `SHADING_SEED`.
#[test]
#[ignore = "takes an hour"]
fn no_light_rises_in_an_hour() {
    let variable =
        |name, or| env::var(name).map_or(or, |text| text.parse().expect("a whole number"));
    let seed = variable("SHADING_SEED", 2);
    let time = Duration::from_secs(variable("SHADING_SECONDS", 3600));
    let start = Instant::now();
    let tried = climb(seed, |_| start.elapsed() < time);
    println!("seed {seed}: {tried} lights and four steps of each, none rises");
}

/// Each once rose: where the denominator passes 1, and where the factor is above 1.
#[test]
fn light_does_not_rise_where_the_denominator_passes_1() {
    let factor = |[a, b, c, q]: [i32; 4]| {
        let [a, b, c, q] = [a, b, c, q].map(Fixed::from_bits);
        assert_eq!(
            Attenuation::new(a, b, c).unwrap().at(q),
            attenuation(a, b, c, q)
        );
        attenuation(a, b, c, q)
    };
    for (nearer, farther) in [
        ([130, 3, 1, 16_678_784], [130, 3, 1, 16_678_785]),
        ([107, 9, 379, 860_344], [107, 9, 379, 860_346]),
        ([22, 193, 3, 7_806_258], [24, 193, 3, 7_806_258]),
        ([2231, 0, 1, 65_535], [2231, 0, 1, 65_536]),
    ] {
        assert!(factor(farther) <= factor(nearer), "{nearer:?}, {farther:?}");
    }
}

/// Every x from ½ to 1 with 26 bits, which are all that it reads; and where x passes a power of two.
fn reciprocal_never_rises(stride: usize) {
    let mut lowest = u32::MAX;
    for bits in (1_u32 << 25..1 << 26).step_by(stride) {
        let y = reciprocal::reciprocal(bits << 6);
        assert!(y <= lowest, "{bits}");
        assert_eq!(reciprocal::reciprocal(bits << 6 | 63), y);
        // 2⁶⁰/(64 bits) within 2⁻²⁴ of itself
        let product = u64::from(y) * u64::from(bits);
        let error = (1_u64 << 54).abs_diff(product);
        assert!(error <= 1 << 30, "{bits}: {error}");
        lowest = y;
    }
    let first = reciprocal::reciprocal(1 << 31);
    assert!(first / 2 <= reciprocal::reciprocal(u32::MAX) && first < 1 << 29);
}

#[test]
fn the_reciprocal_never_rises_on_some() {
    reciprocal_never_rises(61);
}

#[test]
#[ignore = "takes seconds with optimization, a minute without"]
fn the_reciprocal_never_rises() {
    reciprocal_never_rises(1);
}
