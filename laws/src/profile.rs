//! What a renderer says of itself, and what its replies mean: their range, their levels and their encoding.

use serde::{Deserialize, Serialize};

use crate::bounded;
use crate::scene::{Kind, Model, Triple, unit};

/// What a renderer says of itself: how precise it is, what it has, and where it departs from the
/// formulas on purpose. A law that needs something the renderer lacks is not tried.
///
/// The default is a renderer in `f32` that has everything, gives linear light without a limit and
/// follows the formulas.
///
/// ```
/// use shading_laws::{Kind, Model, Profile};
///
/// let shader = Profile {
///     models: vec![Model::Phong],
///     lights: vec![Kind::Directional, Kind::Point],
///     clamps: Some([0.0, 1.0]),
///     srgb: true,
///     bits: Some(8),
///     ..Profile::default()
/// };
/// assert_eq!(shader.roundoff, f64::from(f32::EPSILON) / 2.0);
/// ```
#[allow(clippy::struct_excessive_bools)] // each is a fact of its own
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Profile {
    /// The name in the report.
    pub name: String,
    /// The unit roundoff of its arithmetic: half the distance from 1 to the next number.
    pub roundoff: f64,

    /// The models that it has.
    pub models: Vec<Model>,
    /// It has ambient light.
    pub ambient: bool,
    /// The kinds of light that it has.
    pub lights: Vec<Kind>,
    /// The most lights in a scene, up to 1024.
    pub most_lights: usize,
    /// The largest shininess, up to 65536.
    pub most_shiny: f64,
    /// Its shininess is an integer.
    pub integer_shininess: bool,
    /// It needs N and V at length 1. Otherwise they have any length, as where a shader gets them.
    pub unit_vectors: bool,

    /// The range to which it clamps its colors, if it does.
    pub clamps: Option<[f64; 2]>,
    /// Its colors are encoded as sRGB.
    pub srgb: bool,
    /// The bits of each channel, if its colors are levels from 0 to 2^bits − 1, divided by the
    /// largest.
    pub bits: Option<u32>,

    /// The angle of a spot is that from edge to edge, not the half of it: `half_angle` is doubled
    /// in each scene.
    pub whole_angle: bool,
    /// Each light brings the ambient light along, attenuated like its own: the ambient term is
    /// k_a I_a Σ 1/(a + bq + cq²).
    pub attenuated_ambient: bool,
    /// The highlight is not attenuated.
    pub unattenuated_highlight: bool,
    /// A light behind the surface has a highlight.
    pub highlight_on_the_dark_side: bool,
    /// N is turned toward the eye: where N·V < 0, it is −N.
    pub normal_faces_eye: bool,
    /// Without lights, the color is black.
    pub black_without_lights: bool,
    /// Without lights, it shows the surface unlit: k_d is added to the ambient term.
    pub unlit_without_lights: bool,
    /// It has no attenuation: in each scene, a is 1, and b and c are 0.
    pub unattenuated: bool,
    /// The highlight has no color of its own: in each scene, k_s is gray.
    pub gray_highlight: bool,
    /// The light of a spot falls off within its cone, as the cosine of the angle to its axis to the
    /// power of this number, 0 or more.
    pub spot_exponent: f64,
    /// The ambient term is multiplied by k_d: it is k_a k_d I_a.
    pub ambient_times_diffuse: bool,
}

impl Default for Profile {
    fn default() -> Self {
        Self {
            name: "the renderer".into(),
            roundoff: f64::from(f32::EPSILON) / 2.0,
            models: Model::ALL.into(),
            ambient: true,
            lights: Kind::ALL.into(),
            most_lights: 8,
            most_shiny: 128.0,
            integer_shininess: false,
            unit_vectors: false,
            clamps: None,
            srgb: false,
            bits: None,
            whole_angle: false,
            attenuated_ambient: false,
            unattenuated_highlight: false,
            highlight_on_the_dark_side: false,
            normal_faces_eye: false,
            black_without_lights: false,
            unlit_without_lights: false,
            unattenuated: false,
            gray_highlight: false,
            spot_exponent: 0.0,
            ambient_times_diffuse: false,
        }
    }
}

impl Profile {
    /// What a renderer wrote of itself: one object, with any of the members.
    ///
    /// # Errors
    ///
    /// What is wrong with the line, or with the profile.
    pub fn from_json(line: &str) -> Result<Self, String> {
        if !line.trim_start().starts_with('{') {
            return Err("expected a JSON object or {}".into());
        }
        let profile: Self = serde_json::from_str(line).map_err(|why| why.to_string())?;
        profile.complaint().map_or(Ok(profile), Err)
    }

    /// Why the profile is contradictory, if it is.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // the count of lights
    pub fn complaint(&self) -> Option<String> {
        let outside = |name: &str, x: f64, [low, high]: [f64; 2]| {
            let is_outside = !(low..=high).contains(&x);
            is_outside.then(|| format!("{name} is {x}, not from {low:?} to {high:?}"))
        };
        let is = |is_wrong: bool, what: &str| is_wrong.then(|| what.to_owned());
        let [low, high] = self.clamps.unwrap_or([0.0, 1.0]);
        let is_clamped = low <= 0.0 && high >= 0.5 && high - low < f64::INFINITY;
        let is_other = self.black_without_lights || self.attenuated_ambient;
        let is_two = self.unlit_without_lights && is_other;
        let complaints = [
            outside("roundoff", self.roundoff, [1e-40, 0.01]),
            outside("most_lights", self.most_lights as f64, [1.0, 1024.0]),
            outside("most_shiny", self.most_shiny, [1.0, 65536.0]),
            outside("spot_exponent", self.spot_exponent, [0.0, 128.0]),
            outside("bits", self.bits.unwrap_or(8).into(), [4.0, 32.0]),
            is(self.models.is_empty(), "models is empty"),
            is(self.lights.is_empty(), "lights is empty"),
            is(!is_clamped, "clamps leaves out colors from 0 to 0.5"),
            is(
                is_two,
                "without lights, it cannot be unlit and something else",
            ),
        ];
        complaints.into_iter().flatten().next()
    }

    pub(crate) fn has(&self, kind: Kind) -> bool {
        self.lights.contains(&kind)
    }

    pub(crate) fn has_highlights(&self) -> bool {
        self.models.iter().any(|model| *model != Model::Lambert)
    }

    /// The shininess of the renderer that is nearest to m.
    pub(crate) fn shininess(&self, m: f64) -> f64 {
        let m = if self.integer_shininess {
            m.floor()
        } else {
            self.rounded(m)
        };
        m.min(self.most_shiny).max(1.0)
    }

    /// The number of the renderer that is nearest to x.
    pub(crate) fn rounded(&self, x: f64) -> f64 {
        bounded::rounded(x, self.roundoff) + 0.0 // no -0
    }

    /// A direction of length 1, in the numbers of the renderer.
    pub(crate) fn unit(&self, v: Triple) -> Triple {
        unit(v).map(|c| self.rounded(c))
    }

    /// N or V: of any length, or of length 1 if the renderer needs that.
    pub(crate) fn direction(&self, v: Triple) -> Triple {
        if self.unit_vectors {
            self.unit(v)
        } else {
            v.map(|c| c + 0.0) // no -0
        }
    }

    /// The most that a light shines: a clamped color mostly has room for it.
    pub(crate) fn brightest(&self) -> f64 {
        if self.range().is_some() { 1.0 } else { 2.0 }
    }

    /// The range of its colors. Levels end at 0 and 1.
    pub(crate) fn range(&self) -> Option<[f64; 2]> {
        self.clamps.or(self.bits.map(|_| [0.0, 1.0]))
    }

    /// The distance between two levels of a channel.
    pub(crate) fn level(&self) -> Option<f64> {
        Some(1.0 / (f64::from(self.bits?).exp2() - 1.0))
    }

    /// How far a reply of this size may be from the exact encoding: 0.6 of a level, as for Vulkan's normalized
    /// formats, or the error of a power in floating point.
    pub(crate) fn slack(&self, size: f64, roundoff: f64) -> f64 {
        let of_level = self.level().map_or(0.0, |level| 0.6 * level);
        let of_power = if self.srgb { 16.0 } else { 2.0 };
        of_level + of_power * roundoff * size
    }

    /// The least and the largest linear light that the renderer may have meant by a reply.
    pub(crate) fn meant(&self, reply: f64) -> [f64; 2] {
        let slack = self.slack(reply.abs(), self.roundoff);
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
