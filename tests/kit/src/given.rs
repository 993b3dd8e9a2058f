//! What the functions are called with.

use shading::{
    Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Light, Material, PointLight, Rgb,
    Shaded, SpotLight, UnitVec3, Vec3,
};

use crate::number::Number;

/// The numbers that everything is made of.
#[derive(Clone, Copy)]
pub struct Input<T> {
    /// Whether directions have length 1, everything is finite, and everything that must not be
    /// negative is not.
    pub is_valid: bool,
    pub p: Vec3<T>,
    pub a: Vec3<T>,
    pub b: Vec3<T>,
    pub c: Vec3<T>,
    pub n: Vec3<T>,
    pub l: Vec3<T>,
    pub v: Vec3<T>,
    /// Of the spotlights, which are at c.
    pub axis: Vec3<T>,
    pub x: T,
    pub y: T,
    /// In [0, 1], if valid.
    pub cosine: T,
    pub rgb: Rgb<T>,
    pub k_a: Rgb<T>,
    pub k_d: Rgb<T>,
    pub k_s: Rgb<T>,
    pub intensity: Rgb<T>,
    /// Of the attenuation, of the range, and of the cones, each of which falls back to one that is
    /// valid.
    pub coefficients: Vec3<T>,
    pub range: T,
    pub edge: T,
    pub edges: [T; 2],
    pub integer_m: u32,
    pub real_m: T,
    pub bits: u32,
}

/// Everything that a function may take.
#[derive(Clone, Copy)]
pub struct Given<T> {
    pub is_valid: bool,
    pub p: Vec3<T>,
    pub a: Vec3<T>,
    pub b: Vec3<T>,
    pub n: UnitVec3<T>,
    pub l: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub x: T,
    pub y: T,
    pub cosine: T,
    pub f: Dual<T>,
    pub h: Dual<T>,
    pub rgb: Rgb<T>,
    pub integer: Material<T, u32>,
    pub real: Material<T, T>,
    pub attenuation: Attenuation<T>,
    pub sun: DirectionalLight<T>,
    /// The attenuation of the second and fourth is clamped.
    pub lamps: [PointLight<T>; 4],
    pub spot: SpotLight<T>,
    pub soft_spot: SpotLight<T>,
    pub lights: [Light<T>; 4],
    pub shaded: Shaded<T>,
    pub bits: u32,
}

impl<T: Number> Given<T> {
    #[inline]
    pub fn new(input: &Input<T>) -> Self {
        let &Input {
            p, a, b, c, x, y, ..
        } = input;
        let &Input {
            k_a,
            k_d,
            k_s,
            intensity,
            edge,
            edges: [inner, outer],
            ..
        } = input;
        let [n, l, v, axis] = [input.n, input.l, input.v, input.axis].map(UnitVec3::assume_unit);
        let coefficients = input.coefficients;
        let attenuation = Attenuation::new(coefficients.x, coefficients.y, coefficients.z)
            .unwrap_or(Attenuation::NONE);
        let lamp = |position, attenuation| PointLight {
            position,
            intensity,
            attenuation,
        };
        let sun = DirectionalLight { l, intensity };
        let cone = Cone::from_cosines(edge, edge).unwrap_or(T::CONE);
        let spot = SpotLight {
            point: lamp(c, attenuation),
            axis,
            cone,
        };
        let [near, far] = [lamp(a, attenuation), lamp(b, attenuation.clamped())];
        Self {
            is_valid: input.is_valid,
            p,
            a,
            b,
            n,
            l,
            v,
            x,
            y,
            cosine: input.cosine,
            f: Dual {
                value: x,
                gradient: a,
            },
            h: Dual {
                value: y,
                gradient: b,
            },
            rgb: input.rgb,
            integer: Material {
                k_a,
                k_d,
                k_s,
                m: input.integer_m,
            },
            real: Material {
                k_a,
                k_d,
                k_s,
                m: input.real_m,
            },
            attenuation,
            sun,
            lamps: [
                near,
                far,
                lamp(c, attenuation),
                lamp(a + b, far.attenuation),
            ],
            spot,
            soft_spot: SpotLight {
                point: PointLight {
                    position: c,
                    intensity,
                    attenuation: attenuation.within(input.range).unwrap_or(attenuation),
                },
                axis,
                cone: Cone::from_cosines(inner, outer).unwrap_or(cone),
            },
            lights: [
                Light::Directional(sun),
                Light::Point(near),
                Light::Spot(spot),
                Light::Point(far),
            ],
            shaded: Shaded {
                ambient: k_a,
                diffuse: k_d,
                specular: k_s,
            },
            bits: input.bits,
        }
    }

    /// The light that arrives from each lamp.
    #[inline]
    pub fn from_lamps(&self) -> impl Iterator<Item = IncidentLight<T>> {
        self.lamps.iter().map(|lamp| lamp.at(self.p))
    }

    /// The light that arrives from a light of each kind, twice: more than four are in front of the
    /// surface.
    pub fn from_lights(&self) -> impl Iterator<Item = IncidentLight<T>> {
        let lights = self.lights.map(|light| light.at(self.p));
        lights.into_iter().chain(lights)
    }
}
