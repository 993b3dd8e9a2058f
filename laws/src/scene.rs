//! One place on a surface and the light on it, as plain numbers.

use std::ops::{Add, Div, Mul, Sub};

use serde::{Deserialize, Serialize};

/// Three numbers: the coordinates of a point or a direction, or red, green and blue.
pub type Triple = [f64; 3];

/// One place on a surface, and the light on it.
///
/// Positions are in one unit of length, angles in radians, light is linear. The renderer's type
/// holds almost all numbers exactly.
///
/// ```
/// let dark = r#"{"model":"lambert","p":[0,0,0],"n":[0,0,1],"v":[0,0,1],"k_a":[0,0,0],"k_d":[1,1,1],
///     "k_s":[0,0,0],"m":1,"i_a":[0,0,0],"lights":[]}"#;
/// assert_eq!(shading_laws::Scene::from_json(dark).unwrap().k_d, [1.0; 3]);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// The formula to use.
    pub model: Model,
    /// The point, on the surface.
    pub p: Triple,
    /// A vector along the normal N, not 0. Like a normal that was interpolated, it has any length
    /// unless the [`Profile`](crate::Profile) asks for unit vectors.
    pub n: Triple,
    /// The vector from the point to the eye, not 0: the eye is at p + v. Its length is as free as that of n.
    pub v: Triple,
    /// The ambient reflectance, from 0 to 1.
    pub k_a: Triple,
    /// The diffuse reflectance, from 0 to 1.
    pub k_d: Triple,
    /// The specular reflectance, from 0 to 1.
    pub k_s: Triple,
    /// The shininess, 1 or more.
    pub m: f64,
    /// The ambient light I_a.
    pub i_a: Triple,
    /// The lights.
    pub lights: Vec<Light>,
}

/// The formula of the reflected light. Each has the ambient term k_a I_a and the diffuse term
/// k_d I max(0, N·L).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// No highlight.
    Lambert,
    /// The highlight is k_s I max(0, R·V)^m where N·L > 0.
    Phong,
    /// The highlight is k_s I max(0, N·H)^m where N·L > 0.
    #[default]
    BlinnPhong,
}

/// A light. All directions have length 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Light {
    /// Light from far away, or light that has already been attenuated on its way to the point.
    Directional {
        /// The light that arrives.
        intensity: Triple,
        /// The direction from the surface to the light.
        l: Triple,
    },
    /// A lamp.
    Point {
        /// Its light, before the attenuation.
        intensity: Triple,
        /// Where it is; never at the point itself.
        position: Triple,
        /// The coefficients a, b, c of the attenuation 1/(a + bq + cq²), where q is the distance.
        attenuation: Triple,
    },
    /// A lamp that lights a cone and nothing outside it.
    Spot {
        /// Its light within the cone, before the attenuation.
        intensity: Triple,
        /// Where it is; never at the point itself.
        position: Triple,
        /// The coefficients a, b, c of the attenuation 1/(a + bq + cq²), where q is the distance.
        attenuation: Triple,
        /// The direction in which it shines.
        axis: Triple,
        /// The angle between the axis and the edge of the cone, in radians, at most π/2.
        #[serde(rename = "angle")]
        half_angle: f64,
    },
}

/// What a light is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Light from far away.
    Directional,
    /// A lamp.
    Point,
    /// A lamp with a cone.
    Spot,
}

impl Model {
    /// All models.
    pub const ALL: [Self; 3] = [Self::Lambert, Self::Phong, Self::BlinnPhong];
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Directional, Self::Point, Self::Spot];
}

impl Light {
    pub(crate) fn point(intensity: Triple, position: Triple, attenuation: Triple) -> Self {
        Self::Point {
            intensity,
            position,
            attenuation,
        }
    }

    /// A spot in the place of a point light; nothing else is one.
    pub(crate) fn with_cone(self, axis: Triple, half_angle: f64) -> Self {
        let (position, attenuation) = self.lamp().unwrap_or_default();
        let intensity = self.intensity();
        Self::Spot {
            intensity,
            position,
            attenuation,
            axis,
            half_angle,
        }
    }

    /// What it is.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self {
            Self::Directional { .. } => Kind::Directional,
            Self::Point { .. } => Kind::Point,
            Self::Spot { .. } => Kind::Spot,
        }
    }

    /// The light before any attenuation.
    #[must_use]
    pub fn intensity(mut self) -> Triple {
        *self.intensity_mut()
    }

    /// The same, to be changed.
    pub fn intensity_mut(&mut self) -> &mut Triple {
        match self {
            Self::Directional { intensity, .. }
            | Self::Point { intensity, .. }
            | Self::Spot { intensity, .. } => intensity,
        }
    }

    /// The position and the attenuation of a lamp.
    #[must_use]
    pub fn lamp(mut self) -> Option<(Triple, Triple)> {
        let (position, attenuation) = self.lamp_mut()?;
        Some((*position, *attenuation))
    }

    /// The same, to be changed.
    pub fn lamp_mut(&mut self) -> Option<(&mut Triple, &mut Triple)> {
        match self {
            Self::Directional { .. } => None,
            Self::Point {
                position,
                attenuation,
                ..
            }
            | Self::Spot {
                position,
                attenuation,
                ..
            } => Some((position, attenuation)),
        }
    }

    /// The axis of a spot, and the angle between it and the edge of the cone.
    #[must_use]
    pub fn cone(self) -> Option<(Triple, f64)> {
        match self {
            Self::Spot {
                axis, half_angle, ..
            } => Some((axis, half_angle)),
            _ => None,
        }
    }

    /// The direction in which it is from a point, and the light that arrives there.
    pub(crate) fn arriving(self, p: Triple) -> (Triple, Triple) {
        let l = match self {
            Self::Directional { l, .. } => l,
            Self::Point { position, .. } | Self::Spot { position, .. } => unit(sub(position, p)),
        };
        let is_outside = |(axis, half_angle): (Triple, f64)| -dot(axis, l) < half_angle.cos();
        let is_dark = self.cone().is_some_and(is_outside);
        let left = if is_dark { 0.0 } else { self.falloff(p) };
        (l, scale(self.intensity(), left))
    }

    /// What the attenuation leaves of it at a point.
    pub(crate) fn falloff(self, p: Triple) -> f64 {
        self.lamp().map_or(1.0, |(position, attenuation)| {
            attenuated(length(sub(position, p)), attenuation)
        })
    }
}

impl Scene {
    /// The scene of a line of JSON.
    ///
    /// # Errors
    ///
    /// What is wrong with the line.
    pub fn from_json(line: &str) -> Result<Self, String> {
        serde_json::from_str(line).map_err(|why| why.to_string())
    }

    /// The scene as one line of JSON in the format of the program, its members always in the same order.
    ///
    /// # Panics
    ///
    /// Never: numbers and lists of them are JSON.
    #[must_use]
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("JSON")
    }

    /// The same with more light, or with less.
    pub(crate) fn scale_light(&mut self, times: f64) {
        self.i_a = scale(self.i_a, times);
        for light in &mut self.lights {
            *light.intensity_mut() = scale(light.intensity(), times);
        }
    }

    /// The sum of the largest coordinates of a lamp, of the point and of the way to the eye, to
    /// which a renderer that works in a frame of its own may round the lamp and the point.
    pub(crate) fn extent(&self, lamp: Triple) -> f64 {
        size(lamp) + size(self.p) + size(self.v)
    }
}

/// What is left of light at a distance.
pub fn attenuated(q: f64, [a, b, c]: Triple) -> f64 {
    1.0 / (a + b * q + c * q * q)
}

pub fn size(v: Triple) -> f64 {
    v.iter().fold(0.0, |most, c| most.max(c.abs()))
}

/// What vectors are made of: plain numbers, and those that know their error.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn root(self) -> Self;
}

impl Number for f64 {
    fn root(self) -> Self {
        self.sqrt()
    }
}

pub fn zip<T: Copy>(a: [T; 3], b: [T; 3], f: impl Fn(T, T) -> T) -> [T; 3] {
    [0, 1, 2].map(|i| f(a[i], b[i]))
}

pub fn dot<T: Number>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn add<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    zip(a, b, |a, b| a + b)
}

pub fn sub<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    zip(a, b, |a, b| a - b)
}

pub fn mul<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    zip(a, b, |a, b| a * b)
}

pub fn scale<T: Number>(v: [T; 3], factor: T) -> [T; 3] {
    v.map(|c| c * factor)
}

pub fn cross(a: Triple, b: Triple) -> Triple {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

pub fn length<T: Number>(v: [T; 3]) -> T {
    dot(v, v).root()
}

pub fn unit<T: Number>(v: [T; 3]) -> [T; 3] {
    let length = length(v);
    v.map(|c| c / length)
}
