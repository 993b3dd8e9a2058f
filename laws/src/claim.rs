//! What a law says about the colors of a few scenes.

use std::array::from_fn;

use crate::bounded::Bounded3;
use crate::profile::Profile;
use crate::scene::{Scene, Triple};

/// A few scenes, and what must hold between their colors.
#[derive(Clone, Debug, Default)]
pub struct Group {
    pub scenes: Vec<Scene>,
    pub claims: Vec<Claim>,
}

/// A sum of colors is 0, or at least not negative, in each channel.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The claim in words, for the report.
    pub says: &'static str,
    pub terms: Vec<Term>,
    pub constant: Triple,
    /// How far the constant may be off.
    pub slack: Triple,
    pub relation: Relation,
    /// The channels that the claim is about.
    pub channels: [bool; 3],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relation {
    /// The sum is 0.
    Zero,
    /// The sum is not negative.
    NotNegative,
    /// The colors themselves are finite.
    Finite,
    /// The colors themselves are within the range, and levels if they should be.
    AsSaid,
}

/// A color in the sum.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    pub weight: f64,
    /// The index of the scene.
    pub scene: usize,
    /// Channel i of the sum takes channel i + shift of the color.
    pub shift: usize,
}

impl Claim {
    pub fn new(says: &'static str, relation: Relation, terms: &[(f64, usize)]) -> Self {
        let term = |&(weight, scene): &(f64, usize)| Term {
            weight,
            scene,
            shift: 0,
        };
        Self {
            says,
            terms: terms.iter().map(term).collect(),
            constant: [0.0; 3],
            slack: [0.0; 3],
            relation,
            channels: [true; 3],
        }
    }

    /// The first color equals the second.
    pub fn same(says: &'static str) -> Self {
        Self::new(says, Relation::Zero, &[(1.0, 0), (-1.0, 1)])
    }

    /// No channel of the second color is above that of the first.
    pub fn brighter(says: &'static str) -> Self {
        Self::new(says, Relation::NotNegative, &[(1.0, 0), (-1.0, 1)])
    }

    pub fn plus(self, constant: Triple, slack: Triple) -> Self {
        Self {
            constant,
            slack,
            ..self
        }
    }
}

/// A color that a renderer gave, and what is known about it.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    pub reply: Triple,
    /// The least and the largest linear light that it may mean.
    pub meant: [[f64; 2]; 3],
    /// The linear light of the formulas.
    pub right: Triple,
    /// How far rounding may have moved the linear light from the right one.
    pub error: Triple,
    /// How far rounding may have moved it from that of any formula, right or wrong.
    pub spread: Triple,
}

impl Seen {
    pub fn new(
        profile: &Profile,
        reply: Triple,
        linear: Bounded3,
        conditioning: (f64, Triple),
    ) -> Self {
        let error = |i: usize| {
            // the error of a renderer that is brighter than the textbook grows with its light
            let c = linear[i];
            let times = reply[i].abs() / c.value.abs();
            if times > 1.0 && times.is_finite() && !profile.srgb {
                c.error * times
            } else {
                c.error
            }
        };
        let error = [error(0), error(1), error(2)];
        let meant = reply.map(|c| profile.meant(c));
        let (share, most) = conditioning;
        let spread = from_fn(|i| {
            let size = most[i].max(meant[i][0].abs());
            (share * size).max(2.0 * error[i])
        });
        Self {
            reply,
            meant,
            right: linear.map(|c| c.value),
            error,
            spread,
        }
    }
}

/// A claim that does not hold.
#[derive(Clone, Debug)]
pub struct Broken {
    /// The claim in words.
    pub says: &'static str,
    /// 0 for red, 1 for green, 2 for blue.
    pub channel: usize,
    /// How far the channel is off, and how far it may be.
    pub off: f64,
    pub allowed: f64,
}

impl Group {
    /// The first claim that does not hold.
    pub fn broken(&self, profile: &Profile, seen: &[Seen]) -> Option<Broken> {
        self.claims
            .iter()
            .find_map(|claim| claim.broken(profile, seen))
    }
}

impl Claim {
    fn broken(&self, profile: &Profile, seen: &[Seen]) -> Option<Broken> {
        (0..3)
            .filter(|&channel| self.channels[channel])
            .find_map(|channel| {
                let (off, allowed) = self.excess(profile, seen, channel)?;
                Some(Broken {
                    says: self.says,
                    channel,
                    off,
                    allowed,
                })
            })
    }

    /// How far a channel is off and how far it may be, where that is too far.
    fn excess(&self, profile: &Profile, seen: &[Seen], channel: usize) -> Option<(f64, f64)> {
        let replies = || {
            self.terms
                .iter()
                .map(|term| seen[term.scene].reply[channel])
        };
        match self.relation {
            Relation::Finite => {
                return replies().find(|c| !c.is_finite()).map(|c| (c, 0.0));
            }
            Relation::AsSaid => {
                return replies().find_map(|c| profile.is_not_as_said(c));
            }
            Relation::Zero | Relation::NotNegative => {}
        }
        let (mut low, mut high) = (self.constant[channel], self.constant[channel]);
        let mut allowed = self.slack[channel];
        let mut sum = self.constant[channel];
        for term in &self.terms {
            let (color, channel) = (&seen[term.scene], (channel + term.shift) % 3);
            if !color.reply[channel].is_finite() {
                return None; // another law is about this
            }
            let [least, most] = color.meant[channel].map(|end| term.weight * end);
            low += least.min(most);
            high += least.max(most);
            // what a law says of several colors must hold of a wrong formula, too
            let error = if self.terms.len() > 1 {
                color.spread
            } else {
                color.error
            };
            allowed += term.weight.abs() * error[channel];
            let [least, most] = color.meant[channel];
            let middle = if most.is_finite() {
                f64::midpoint(least, most)
            } else {
                least
            };
            sum += term.weight * middle;
        }
        if let (Relation::Zero, [term]) = (self.relation, &self.terms[..]) {
            // where the formulas leave it open, such as the highlight where L = -V, the right color is one of many
            let right = seen[term.scene].right[channel];
            let open = (term.weight * right + self.constant[channel]).abs();
            allowed += if open.is_finite() { open } else { 0.0 };
        }
        let is_broken = match self.relation {
            Relation::Zero => low > allowed || high < -allowed,
            _ => high < -allowed,
        };
        let spread = if (high - low).is_finite() {
            (high - low) / 2.0
        } else {
            0.0
        };
        is_broken.then_some((sum, allowed + spread))
    }
}
