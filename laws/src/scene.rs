//! One place on a surface and the light on it, as plain numbers.

use std::fmt;

/// Three numbers: the coordinates of a point or a direction, or red, green and blue.
pub type Triple = [f64; 3];

/// One place on a surface, and the light on it.
///
/// Positions are in one unit of length, angles in radians, light is linear. The renderer's type holds almost all numbers
/// exactly.
///
/// ```
/// use shading_laws::{Light, Material, Model, Scene};
///
/// let [black, gray, white] = [[0.0; 3], [0.5; 3], [1.0; 3]];
/// let scene = Scene {
///     model: Model::BlinnPhong,
///     p: [0.0, 0.0, 0.0],
///     n: [0.0, 0.0, 1.0],
///     v: [0.0, 0.0, 2.0],
///     material: Material { k_a: black, k_d: gray, k_s: gray, m: 8.0 },
///     i_a: black,
///     lights: vec![Light::Directional { l: [0.0, 0.0, 1.0], intensity: white }],
/// };
/// let rust = scene.to_string(); // to copy into a test
/// assert!(rust.starts_with("Scene {\n    model: Model::BlinnPhong,"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The formula to use.
    pub model: Model,
    /// The point, on the surface.
    pub p: Triple,
    /// A vector along the normal N, not 0. Like a normal that was interpolated, it has any length
    /// unless the [`Profile`](crate::Profile) asks for unit vectors.
    pub n: Triple,
    /// The vector from the point to the eye, not 0: the eye is at p + v. It has any length unless
    /// the [`Profile`](crate::Profile) asks for unit vectors.
    pub v: Triple,
    /// What the surface reflects.
    pub material: Material,
    /// The ambient light I_a.
    pub i_a: Triple,
    /// The lights.
    pub lights: Vec<Light>,
}

/// The formula of the reflected light. Each has the ambient term k_a I_a and the diffuse term
/// k_d I max(0, N·L).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Model {
    /// No highlight.
    Lambert,
    /// The highlight is k_s I max(0, R·V)^m where N·L > 0.
    Phong,
    /// The highlight is k_s I max(0, N·H)^m where N·L > 0.
    #[default]
    BlinnPhong,
}

/// What a surface reflects, in red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The ambient reflectance, from 0 to 1.
    pub k_a: Triple,
    /// The diffuse reflectance, from 0 to 1.
    pub k_d: Triple,
    /// The specular reflectance, from 0 to 1.
    pub k_s: Triple,
    /// The shininess, 1 or more.
    pub m: f64,
}

/// A light. All directions have length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Light from far away, or light that has already been attenuated on its way to the point.
    Directional {
        /// The direction from the surface to the light.
        l: Triple,
        /// The light that arrives.
        intensity: Triple,
    },
    /// A lamp.
    Point {
        /// Where it is; never at the point itself.
        position: Triple,
        /// Its light, before the attenuation.
        intensity: Triple,
        /// The coefficients a, b, c of the attenuation 1/(a + bq + cq²), where q is the distance.
        attenuation: Triple,
    },
    /// A lamp that lights a cone and nothing outside it.
    Spot {
        /// Where it is; never at the point itself.
        position: Triple,
        /// Its light within the cone, before the attenuation.
        intensity: Triple,
        /// The coefficients a, b, c of the attenuation 1/(a + bq + cq²), where q is the distance.
        attenuation: Triple,
        /// The direction in which it shines.
        axis: Triple,
        /// The angle between the axis and the edge of the cone, in radians, at most π/2.
        half_angle: f64,
    },
}

impl Model {
    /// All models.
    pub const ALL: [Self; 3] = [Self::Lambert, Self::Phong, Self::BlinnPhong];

    /// The name in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Lambert => "lambert",
            Self::Phong => "phong",
            Self::BlinnPhong => "blinn_phong",
        }
    }
}

impl Light {
    /// The light before any attenuation.
    #[must_use]
    pub fn intensity(&self) -> Triple {
        match *self {
            Self::Directional { intensity, .. }
            | Self::Point { intensity, .. }
            | Self::Spot { intensity, .. } => intensity,
        }
    }

    /// The same light in another color.
    #[must_use]
    pub fn with_intensity(mut self, new: Triple) -> Self {
        match &mut self {
            Self::Directional { intensity, .. }
            | Self::Point { intensity, .. }
            | Self::Spot { intensity, .. } => *intensity = new,
        }
        self
    }

    /// The position and the attenuation of a lamp.
    pub(crate) fn lamp(mut self) -> Option<(Triple, Triple)> {
        let (position, attenuation) = self.lamp_mut()?;
        Some((*position, *attenuation))
    }

    /// The same, to be changed.
    pub(crate) fn lamp_mut(&mut self) -> Option<(&mut Triple, &mut Triple)> {
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

    /// The name of its kind in JSON.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Directional { .. } => "directional",
            Self::Point { .. } => "point",
            Self::Spot { .. } => "spot",
        }
    }
}

impl Scene {
    /// The sum of the largest coordinates of a lamp, of the point and of the way to the eye, to which a renderer that
    /// works in a frame of its own may round the lamp and the point.
    pub(crate) fn extent(&self, lamp: Triple) -> f64 {
        size(lamp) + size(self.p) + size(self.v)
    }

    /// Whether a lamp stands so near to the point that a renderer with this roundoff may find it there: in the frame of
    /// the eye, both positions round by up to u times their size.
    pub(crate) fn has_lamp_at_the_point(&self, light: &Light, u: f64) -> bool {
        light.lamp().is_some_and(|(position, _)| {
            let way = std::array::from_fn(|i| position[i] - self.p[i]);
            size(way) <= 4.0 * u * self.extent(position)
        })
    }
}

fn size(triple: Triple) -> f64 {
    triple.iter().fold(0.0, |most, c| most.max(c.abs()))
}

/// The scene as Rust.
impl fmt::Display for Scene {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            model,
            p,
            n,
            v,
            material,
            i_a,
            lights,
        } = self;
        let Material { k_a, k_d, k_s, m } = material;
        writeln!(f, "Scene {{")?;
        writeln!(f, "    model: Model::{model:?},")?;
        writeln!(f, "    p: {p:?},")?;
        writeln!(f, "    n: {n:?},")?;
        writeln!(f, "    v: {v:?},")?;
        writeln!(f, "    material: Material {{")?;
        writeln!(f, "        k_a: {k_a:?},")?;
        writeln!(f, "        k_d: {k_d:?},")?;
        writeln!(f, "        k_s: {k_s:?},")?;
        writeln!(f, "        m: {m:?},")?;
        writeln!(f, "    }},")?;
        writeln!(f, "    i_a: {i_a:?},")?;
        writeln!(f, "    lights: vec![")?;
        for light in lights {
            writeln!(f, "        Light::{light:?},")?;
        }
        writeln!(f, "    ],")?;
        write!(f, "}}")
    }
}
