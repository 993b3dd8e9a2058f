//! The laws: what must hold of the color of any scene.

use serde::Serialize;

use crate::bounded::Bounded3;
use crate::formula::Formula;
use crate::scene::Triple;

/// A statement about the color of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    Finite,
    Formula,
    NoMemory,
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

impl Law {
    /// Every law, in the order of the report.
    pub const ALL: [Self; 3] = [Self::Finite, Self::Formula, Self::NoMemory];

    /// Its name, and what it says.
    pub fn told(self) -> (&'static str, &'static str) {
        match self {
            Self::Finite => ("finite", "every color is finite"),
            Self::Formula => (
                "formula",
                "the color is that of the formula, in the renderer's precision and form",
            ),
            Self::NoMemory => (
                "no_memory",
                "a scene has the same color wherever it is in a batch",
            ),
        }
    }

    pub fn name(self) -> &'static str {
        self.told().0
    }

    /// How the replies to a scene, the first and any later one, break the law. The formulas give the linear light.
    pub fn broken(self, right: &Formula, linear: Bounded3, replies: &[Triple]) -> Option<Broken> {
        (0..3).find_map(|channel| {
            let (light, reply) = (linear[channel], replies[0][channel]);
            let (off, allowed) = match self {
                Self::Finite => {
                    // a power of what cancels may have no end, but it is a number
                    let is_lost = reply.is_nan() || reply.is_infinite() && light.error.is_finite();
                    is_lost.then_some((reply, 0.0))
                }
                Self::Formula => right
                    .excess(light, reply)
                    .or_else(|| right.profile.is_not_as_said(reply)),
                Self::NoMemory => {
                    let [low, high] = right.ends(light)?;
                    let again = replies.last()?[channel];
                    let off = reply - again;
                    let allowed = high - low + right.profile.slack(reply.abs(), right.u);
                    let is_lost = reply.is_nan() != again.is_nan();
                    (is_lost || off.abs() > allowed).then_some((off, allowed))
                }
            }?;
            Some(Broken {
                channel,
                off,
                allowed,
            })
        })
    }
}
