//! What a renderer says of itself, and what its replies mean: their range, their levels and their encoding.

use serde::{Deserialize, Serialize};

use crate::bounded;
use crate::scene::{Kind, Light, Model, Scene, Triple, length, size, sub, unit};

/// The most that the format allows a channel of a light.
pub const BRIGHTEST: f64 = 16.0;

/// The rounding of our own doubles, where the renderer has more digits.
const OURS: f64 = 1e-15;

/// What a renderer says of itself: how precise it is, what it has, what its replies mean, and where
/// it departs from the formulas on purpose. A law that needs something the renderer lacks is not
/// tried.
///
/// The default is a renderer in `f32` that has everything, gives linear light without a limit and
/// follows the formulas.
///
/// ```
/// use shading_laws::Profile;
/// let shader = Profile { srgb: true, bits: Some(8), ambient: false, ..Profile::default() };
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
    /// It needs N and V at length 1. Otherwise they have any length, as where a shader gets them.
    pub unit_vectors: bool,
    /// It has no attenuation: in each scene, a is 1, and b and c are 0.
    pub unattenuated: bool,
    /// The highlight has no color of its own: in each scene, k_s is gray.
    pub gray_highlight: bool,

    /// The range to which it clamps its colors, if it does.
    pub clamps: Option<[f64; 2]>,
    /// Its colors are encoded as sRGB.
    pub srgb: bool,
    /// The bits of each channel, if its colors are levels from 0 to 2^bits − 1, divided by the largest.
    pub bits: Option<u32>,
    /// The number that it gives for a channel of light 1: 255 if its colors are integers from 0 to 255.
    pub white: f64,

    /// Where it departs from the formulas on purpose: the names that a report gives, such as
    /// `HighlightNotGated` or, with a number, `ConeExponent=2`.
    pub departs: Vec<String>,
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
            unit_vectors: false,
            unattenuated: false,
            gray_highlight: false,
            clamps: None,
            srgb: false,
            bits: None,
            white: 1.0,
            departs: Vec::new(),
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
        let complaints = [
            outside("roundoff", self.roundoff, [1e-40, 0.01]),
            outside("most_lights", self.most_lights as f64, [1.0, 1024.0]),
            outside("most_shiny", self.most_shiny, [1.0, 65536.0]),
            outside("white", self.white, [1e-3, 1e10]),
            outside("bits", self.bits.unwrap_or(8).into(), [4.0, 32.0]),
            is(self.models.is_empty(), "models is empty"),
            is(self.lights.is_empty(), "lights is empty"),
            is(!is_clamped, "clamps leaves out colors from 0 to 0.5"),
        ];
        complaints.into_iter().flatten().next()
    }

    pub(crate) fn has(&self, kind: Kind) -> bool {
        self.lights.contains(&kind)
    }

    /// The shininess of the renderer that is nearest to m.
    pub(crate) fn shininess(&self, m: f64) -> f64 {
        self.rounded(m).min(self.most_shiny).max(1.0)
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

    /// The ends of the range, as the renderer gives them.
    pub(crate) fn ends(&self) -> Option<[f64; 2]> {
        Some(self.range()?.map(|end| end * self.white))
    }

    /// The distance between two levels of a channel, as the renderer gives them.
    pub(crate) fn level(&self) -> Option<f64> {
        Some(self.white / (f64::from(self.bits?).exp2() - 1.0))
    }

    /// How far a reply of this size may be from the exact encoding: 0.6 of a level, as for Vulkan's normalized
    /// formats, or the error of a power in floating point.
    pub(crate) fn slack(&self, size: f64, roundoff: f64) -> f64 {
        let of_level = self.level().map_or(0.0, |level| 0.6 * level);
        let of_power = if self.srgb { 16.0 } else { 2.0 };
        of_level + (of_power * roundoff + OURS) * size
    }

    /// How far a finite reply is out of the range or off its level, and how far it may be, if that is too far.
    pub(crate) fn is_not_as_said(&self, reply: f64) -> Option<(f64, f64)> {
        let slack = 4.0 * self.roundoff * self.white;
        if !reply.is_finite() {
            return None;
        }
        if let Some([low, high]) = self.ends() {
            let beyond = (reply - high).max(low - reply);
            if beyond > slack {
                return Some((beyond, slack));
            }
        }
        let level = self.level()?;
        let off = (reply - (reply / level).round() * level).abs();
        (off > 0.01 * level).then_some((off, 0.01 * level))
    }

    /// A scene as the renderer can be given it, if it has all else: with directions of length 1, a gray highlight,
    /// lamps that are not attenuated and no ambient light, if it needs that.
    pub(crate) fn fitted(&self, mut scene: Scene) -> Option<Scene> {
        (scene.n, scene.v) = (self.direction(scene.n), self.direction(scene.v));
        scene.m = scene.m.min(self.most_shiny);
        if self.gray_highlight {
            scene.k_s = [scene.k_s[0]; 3];
        }
        if !self.ambient {
            scene.i_a = [0.0; 3];
        }
        for light in &mut scene.lights {
            if let Light::Directional { l: axis, .. } | Light::Spot { axis, .. } = light {
                *axis = self.unit(*axis);
            }
            if let Some((_, abc)) = light.lamp_mut().filter(|_| self.unattenuated) {
                *abc = [1.0, 0.0, 0.0];
            }
        }
        self.has_all_of(&scene).then_some(scene)
    }

    /// Whether the renderer has all else that a fitted scene needs, and the format allows it.
    pub(crate) fn has_all_of(&self, scene: &Scene) -> bool {
        // in half precision, the squares of other lengths have no digits, or no end
        let is_short = self.roundoff >= bounded::HALF;
        let is_in_reach = |v: Triple| !is_short || (1.0 / 32.0..=64.0).contains(&length(v));
        let is_direction = |v: Triple| length(v) > 0.0 && is_in_reach(v);
        let most = if is_short { 4096.0 } else { 1e12 };
        let has_lamp = |light: &Light| {
            light.lamp().is_none_or(|(position, abc)| {
                abc.iter().sum::<f64>() > 0.0
                    && abc.iter().all(|c| (0.0..=most).contains(c))
                    && position != [0.0; 3] // a lamp at the origin divides by 0 where p is forgotten
                    && is_in_reach(sub(position, scene.p))
                    // in the frame of the eye, both positions round by up to u times their size, so a renderer may
                    // find a nearer lamp at the point
                    && size(sub(position, scene.p)) > 4.0 * self.roundoff * scene.extent(position)
            })
        };
        let is_aimed = |light: &Light| match *light {
            Light::Directional { l: axis, .. } | Light::Spot { axis, .. } => length(axis) > 0.0,
            Light::Point { .. } => true,
        };
        let has_light = |light| self.has(Light::kind(light)) && has_lamp(light) && is_aimed(light);
        let intensities = scene.lights.iter().map(|light| light.intensity());
        let colors = [scene.k_a, scene.k_d, scene.k_s, scene.i_a];
        let mut colors = colors.into_iter().chain(intensities).flatten();
        self.models.contains(&scene.model)
            && [scene.n, scene.v].into_iter().all(is_direction)
            && scene.m >= 1.0
            && colors.all(|c| (0.0..=BRIGHTEST).contains(&c))
            && scene.lights.len() <= self.most_lights
            && scene.lights.iter().all(has_light)
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
