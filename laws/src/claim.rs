//! What a law says about the colors of a few scenes.

use serde::Serialize;

use crate::bounded::Bounded3;
use crate::profile::Profile;
use crate::scene::Triple;

/// What must hold between the colors of a few scenes: a sum of them is 0, or at least not negative, in each channel.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The weight of the color of each scene.
    pub weights: Vec<f64>,
    pub constant: Triple,
    /// How far the constant may be off.
    pub slack: Triple,
    pub relation: Relation,
    /// The first channel that the claim is about.
    pub first_channel: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relation {
    /// The sum is 0.
    Zero,
    /// The sum is not negative.
    NotNegative,
    /// The color is that of the formulas.
    Right,
    /// The colors themselves are finite.
    Finite,
    /// The colors themselves are within the range, and levels if they should be.
    AsSaid,
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
        (share, most): (f64, Triple),
    ) -> Self {
        let error = [0, 1, 2].map(|i: usize| {
            // the error of a renderer that is brighter than the formulas grows with its light
            let times = reply[i].abs() / linear[i].value.abs();
            if times > 1.0 && times.is_finite() && !profile.srgb {
                linear[i].error * times
            } else {
                linear[i].error
            }
        });
        let meant = reply.map(|c| profile.meant(c));
        let spread = [0, 1, 2].map(|i: usize| {
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

/// How a law does not hold.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Broken {
    /// The channel in which it does not: 0 for red, 1 for green, 2 for blue.
    pub channel: usize,
    /// How far the channel is off.
    pub off: f64,
    /// How far rounding may put it off.
    pub allowed: f64,
}

impl Broken {
    /// Whether nobody would take it for rounding.
    pub(crate) fn is_clear(&self) -> bool {
        !self.off.is_finite() || self.off.abs() > 2.0 * self.allowed
    }
}

impl Claim {
    pub fn new(relation: Relation, weights: &[f64]) -> Self {
        Self {
            weights: weights.to_vec(),
            constant: [0.0; 3],
            slack: [0.0; 3],
            relation,
            first_channel: 0,
        }
    }

    /// How the claim does not hold, if it does not.
    pub fn broken(&self, profile: &Profile, seen: &[Seen]) -> Option<Broken> {
        (self.first_channel..3).find_map(|channel| {
            let (off, allowed) = self.excess(profile, seen, channel)?;
            Some(Broken {
                channel,
                off,
                allowed,
            })
        })
    }

    /// How far a channel is off and how far it may be, where that is too far.
    fn excess(&self, profile: &Profile, seen: &[Seen], channel: usize) -> Option<(f64, f64)> {
        let mut replies = seen.iter().map(|color| color.reply[channel]);
        let (mut constant, mut allowed) = (self.constant[channel], self.slack[channel]);
        match self.relation {
            Relation::Finite => {
                // a power of what cancels may have no end, but it is a number
                let is_open = seen[0].error[channel].is_infinite();
                return replies
                    .find(|c| c.is_nan() || c.is_infinite() && !is_open)
                    .map(|c| (c, 0.0));
            }
            Relation::AsSaid => return replies.find_map(|c| profile.is_not_as_said(c)),
            Relation::Right => {
                constant = -seen[0].right[channel];
                allowed = 1e-15 * constant.abs();
            }
            Relation::Zero | Relation::NotNegative => {}
        }
        let (mut low, mut high, mut sum) = (constant, constant, constant);
        for (color, weight) in seen.iter().zip(&self.weights) {
            if !color.reply[channel].is_finite() {
                return None; // another law is about this
            }
            let [least, most] = color.meant[channel];
            let ends = [weight * least, weight * most];
            low += ends[0].min(ends[1]);
            high += ends[0].max(ends[1]);
            // what a law says of several colors must hold of a wrong formula, too
            let is_alone = self.weights.len() == 1;
            let error = if is_alone { color.error } else { color.spread };
            allowed += weight.abs() * error[channel];
            sum += weight * f64::midpoint(least, if most.is_finite() { most } else { least });
        }
        let is_broken = match self.relation {
            Relation::NotNegative => high < -allowed,
            _ => low > allowed || high < -allowed,
        };
        let spread = (high - low) / 2.0;
        let spread = if spread.is_finite() { spread } else { 0.0 };
        is_broken.then_some((sum, allowed + spread))
    }
}
