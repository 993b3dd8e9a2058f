//! The ingredients of the formulas, each of which a mistake may change.

use crate::bounded::{Bounded, Bounded3};
use crate::scene::{Light, Model};

/// An ingredient, in the order of the computation. A number is three alike, so that one operation fits any.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    V,
    N,
    /// What N is multiplied by: 1 or −1.
    Side,
    M,
    Ambient,
    /// The ambient term as it enters the sum.
    Once,
    Intensity,
    ToLight,
    Q,
    L,
    Falloff,
    /// The cosine of the angle to the axis of the cone.
    Against,
    Angle,
    /// What is left of the light within the cone.
    Within,
    Cone,
    Lambert,
    Half,
    Cosine,
    Power,
    /// Whether there is a highlight: above 0.
    Gate,
    ShinyFalloff,
    Diffuse,
    Specular,
    OfLight,
    /// Ambient light that comes with a light.
    AmbientToo,
    Sum,
    Encode,
    Level,
}

/// What is known when an ingredient is computed: all before it.
#[derive(Clone, Default)]
pub struct At {
    /// The distance of the renderer's levels.
    pub level: Option<f64>,
    /// The unit roundoff.
    pub u: f64,
    /// The number of the mistake.
    pub value: f64,
    pub model: Model,
    pub p: Bounded3,
    /// V and N as they are given, and as unit vectors.
    pub raw_v: Bounded3,
    pub v: Bounded3,
    pub raw_n: Bounded3,
    pub n: Bounded3,
    pub k_d: Bounded3,
    pub k_s: Bounded3,
    pub m: f64,
    pub ambient: Bounded3,
    pub is_unlit: bool,
    /// The light, and its place among the others.
    pub light: Option<Light>,
    pub i: f64,
    pub intensity: Bounded3,
    pub position: Bounded3,
    pub to_light: Bounded3,
    pub q: Bounded,
    pub l: Bounded3,
    pub falloff: Bounded,
    pub against: Bounded,
    pub edge: Bounded,
    pub within: Bounded,
    pub cone: Bounded,
    pub n_dot_l: Bounded,
    /// L + V.
    pub sum: Bounded3,
    pub cosine: Bounded,
    /// The sum over the lights, and that of the ambient light.
    pub lit: Bounded3,
    pub ambients: Bounded3,
    /// What is clamped or encoded.
    pub linear: f64,
}

/// What a mistake makes of an ingredient.
pub type Change = fn(Bounded3, &At) -> Bounded3;

/// A change with its number.
pub type Applied = (Part, Change, f64);

impl At {
    /// A number as the renderer holds it.
    pub fn given(&self, x: f64) -> Bounded {
        Bounded::given(x, self.u)
    }

    /// The number of the mistake, as the renderer has it.
    pub fn number(&self) -> Bounded {
        self.given(self.value)
    }
}
