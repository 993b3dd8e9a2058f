//! What is wrong with a renderer.

use shading_laws::{Fault, Mistake};

/// A way to be wrong that is no known mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Odd {
    /// k_d is multiplied by this.
    DiffuseTimes(f64),
    /// The wrap of N·L.
    Wrap(f64),
    /// N·L to the power of this.
    CosineTo(f64),
    /// The highlight's power from a table of so many entries.
    PowerTable(f64),
    /// The unit vectors are rounded to so many bits.
    Normals(f64),
    /// N is tilted by this.
    Tilt(f64),
    /// The attenuation to the power of this.
    AttenuationTo(f64),
    /// The edge of a spot is softer by this.
    SoftEdge(f64),
    /// The shininess to the power of this.
    ShininessTo(f64),
    /// The red channel is too bright.
    Red(f64),
    /// A constant is added.
    Plus(f64),
    /// The light has a hue by its index.
    Hue(f64),
    /// All lights after the first are dimmer.
    Later(f64),
    /// Everything is rounded to so many bits after each light.
    Rounded(f64),
    /// N·L is rounded to multiples of 1/x.
    Banded(f64),
    /// N·L is at least this in front.
    CosineAtLeast(f64),
    /// The highlight has the square of the light's color.
    LightSquared,
    /// The highlight has the mean of the light's color.
    GrayHighlight,
    /// The distance of a spot is that along its axis.
    DistanceAlongAxis,
    /// k_d and k_s are divided by their largest sum, if it is above 1.
    NoMoreThanOne,
    /// A light whose red is black is left out.
    RedDecides,
    /// The ambient light comes with the first light in front.
    AmbientIfLit,
    /// The power by the bits of a float.
    PowerByBits,
    /// The sum is cut to so many bits after each light.
    SumCut(f64),
    /// It fades with the distance of the eye.
    Fog(f64),
    /// N·V in place of N·H.
    EyeForHalf,
}

/// What is wrong with a renderer.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    pub faults: Vec<Fault>,
    pub odd: Option<Odd>,
}

impl<const N: usize> From<[Mistake; N]> for Plan {
    fn from(mistakes: [Mistake; N]) -> Self {
        Self {
            faults: mistakes.map(Fault::from).to_vec(),
            odd: None,
        }
    }
}
