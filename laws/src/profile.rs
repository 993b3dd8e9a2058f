//! What a renderer says of itself.

use crate::scene::Model;

/// What a renderer says of itself: how precise it is, what it has, and where it departs from the
/// formulas on purpose. A law that needs something the renderer lacks is not tried.
///
/// The default is a renderer in `f32` that has everything, gives linear light without a limit and
/// follows the formulas.
///
/// ```
/// use shading_laws::{Model, Profile};
///
/// let shader = Profile {
///     models: vec![Model::Phong],
///     spot_lights: false,
///     clamps: Some([0.0, 1.0]),
///     srgb: true,
///     bits: Some(8),
///     ..Profile::default()
/// };
/// assert_eq!(shader.roundoff, f64::from(f32::EPSILON) / 2.0);
/// ```
#[allow(clippy::struct_excessive_bools)] // each is a fact of its own
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// The name in the report.
    pub name: String,
    /// The unit roundoff of its arithmetic: half the distance from 1 to the next number.
    pub roundoff: f64,

    /// The models that it has.
    pub models: Vec<Model>,
    /// It has ambient light.
    pub ambient: bool,
    /// It has directional lights.
    pub directional_lights: bool,
    /// It has point lights.
    pub point_lights: bool,
    /// It has spot lights.
    pub spot_lights: bool,
    /// The most lights in a scene.
    pub most_lights: usize,
    /// The largest shininess.
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
            directional_lights: true,
            point_lights: true,
            spot_lights: true,
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
    /// Why the profile is contradictory, if it is.
    #[must_use]
    pub fn complaint(&self) -> Option<String> {
        let complaint = if !(self.roundoff > 0.0 && self.roundoff < 0.01) {
            format!("roundoff is {}, not between 0 and 0.01", self.roundoff)
        } else if self.models.is_empty() {
            "models is empty".into()
        } else if !(self.directional_lights || self.point_lights || self.spot_lights) {
            "it has no kind of light".into()
        } else if self.most_lights == 0 {
            "most_lights is 0".into()
        } else if self.most_shiny.is_nan() || self.most_shiny < 1.0 {
            format!("most_shiny is {}, below 1", self.most_shiny)
        } else if self.unlit_without_lights
            && (self.black_without_lights || self.attenuated_ambient)
        {
            "unlit_without_lights goes with neither black_without_lights nor attenuated_ambient"
                .into()
        } else if !(0.0..=128.0).contains(&self.spot_exponent) {
            format!("spot_exponent is {}, not from 0 to 128", self.spot_exponent)
        } else if self.bits.is_some_and(|bits| !(4..=32).contains(&bits)) {
            format!("bits is {}, not from 4 to 32", self.bits.unwrap_or(0))
        } else if let Some([low, high]) = self.clamps.filter(|[low, high]| {
            !(low.is_finite() && high.is_finite() && *low <= 0.0 && *high >= 0.5)
        }) {
            format!("clamps is [{low}, {high}], which leaves out colors from 0 to 0.5")
        } else {
            return None;
        };
        Some(complaint)
    }
}
