//! What a renderer's replies mean: their range, their levels and their encoding.

use crate::profile::Profile;

impl Profile {
    /// The range of its colors. Levels end at 0 and 1.
    pub(crate) fn range(&self) -> Option<[f64; 2]> {
        self.clamps.or(self.bits.map(|_| [0.0, 1.0]))
    }

    /// The distance between two levels of a channel.
    pub(crate) fn level(&self) -> Option<f64> {
        Some(1.0 / (f64::from(self.bits?).exp2() - 1.0))
    }

    /// How far a reply may be from the exact encoding: 0.6 of a level, as for Vulkan's normalized
    /// formats, or the error of a power in floating point.
    pub(crate) fn reply_slack(&self, size: f64) -> f64 {
        self.slack(size, self.roundoff)
    }

    /// The same with another roundoff.
    pub(crate) fn slack(&self, size: f64, roundoff: f64) -> f64 {
        let of_level = self.level().map_or(0.0, |level| 0.6 * level);
        let of_power = if self.srgb { 16.0 } else { 2.0 };
        of_level + of_power * roundoff * size
    }

    /// The least and the largest linear light that the renderer may have meant by a reply.
    pub(crate) fn meant(&self, reply: f64) -> [f64; 2] {
        let slack = self.reply_slack(reply.abs());
        let ends = [reply - slack, reply + slack];
        let mut ends = if self.srgb { ends.map(from_srgb) } else { ends };
        if self.range().is_some_and(|[_, high]| reply >= high - slack) {
            ends[1] = f64::INFINITY;
        }
        ends
    }

    /// How far a finite reply is out of the range or off its level, and how far it may be, where that
    /// is too far.
    pub(crate) fn is_not_as_said(&self, reply: f64) -> Option<(f64, f64)> {
        let slack = 4.0 * self.roundoff;
        if !reply.is_finite() {
            return None;
        }
        if let Some([low, high]) = self.range() {
            let beyond = (reply - high).max(low - reply);
            if beyond > slack {
                return Some((beyond, slack));
            }
        }
        let level = self.level()?;
        let off = (reply - (reply / level).round() * level).abs();
        (off > 0.01 * level).then_some((off, 0.01 * level))
    }
}

/// The encoding of sRGB (IEC 61966-2-1), odd about 0.
pub fn to_srgb(x: f64) -> f64 {
    let size = x.abs();
    let encoded = if size <= 0.003_130_8 {
        12.92 * size
    } else {
        1.055 * size.powf(1.0 / 2.4) - 0.055
    };
    encoded.copysign(x)
}

pub fn from_srgb(y: f64) -> f64 {
    let size = y.abs();
    let decoded = if size <= 0.040_45 {
        size / 12.92
    } else {
        ((size + 0.055) / 1.055).powf(2.4)
    };
    decoded.copysign(y)
}
