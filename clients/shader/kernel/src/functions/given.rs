//! The arguments of the functions: the fields of the table's own arguments, as far as a shader has them.

use bytemuck::{Pod, Zeroable};
use shading::f32::{Rgb, Vec3};
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Material, PointLight, Ranged, Shaded,
    SoftCone, SpotLight, UnitVec3,
};

use super::Number;

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Input {
    /// Points.
    pub a: Vec3,
    pub b: Vec3,
    pub c: Vec3,
    /// Directions of length 1.
    pub n: Vec3,
    pub l: Vec3,
    pub v: Vec3,
    /// Colors.
    pub k: Rgb,
    pub i: Rgb,
    /// Of an attenuation.
    pub coefficients: Vec3,
    /// A distance, and a range.
    pub q: f32,
    pub r: f32,
    /// The cosines of a soft cone's edges.
    pub inner: f32,
    pub outer: f32,
    /// Shininess.
    pub m: f32,
    pub integer: u32,
}

/// The same as the types of the library. The point p is `Input::a`, and the lamps are around `Input::b`.
pub struct Given<T> {
    pub p: shading::Vec3<T>,
    pub a: shading::Vec3<T>,
    pub b: shading::Vec3<T>,
    pub n: UnitVec3<T>,
    pub l: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub x: T,
    pub y: T,
    pub cosine: T,
    pub f: Dual<T>,
    pub rgb: shading::Rgb<T>,
    pub integer: Material<T, u32>,
    pub real: Material<T, T>,
    pub attenuation: Attenuation<T>,
    pub sun: DirectionalLight<T>,
    pub lamps: [PointLight<T>; 1],
    /// From each of four lamps to the next: a shader cannot index an array of them.
    step: shading::Vec3<T>,
    pub spot: SpotLight<T>,
    pub soft_spot: SpotLight<T, SoftCone<T>, Ranged<T>>,
    pub incident: IncidentLight<T>,
    pub shaded: Shaded<T>,
}

impl Given<f32> {
    pub fn by(input: &Input) -> Self {
        let &Input {
            a,
            b,
            c,
            k,
            i,
            q,
            r,
            inner,
            outer,
            m,
            integer,
            ..
        } = input;
        let n = UnitVec3::assume_unit(input.n);
        let l = UnitVec3::assume_unit(input.l);
        let v = UnitVec3::assume_unit(input.v);
        let Vec3 { x, y, z } = input.coefficients;
        let attenuation = Attenuation::<f32>::new(x, y, z).unwrap_or(Attenuation::NONE);
        let everything = Cone::<f32>::from_cosine(-1.0).unwrap();
        let lamp = PointLight {
            position: b,
            intensity: i,
            attenuation,
        };
        let axis = v;
        let ranged = PointLight {
            position: b,
            intensity: i,
            attenuation: attenuation.within(r).unwrap(),
        };
        Self {
            p: a,
            a: b,
            b: c,
            n,
            l,
            v,
            x: q,
            y: r,
            cosine: if inner < 0.0 { -inner } else { inner },
            f: Dual {
                value: q,
                gradient: b,
            },
            rgb: i,
            integer: Material {
                k_a: k,
                k_d: k,
                k_s: i,
                m: integer,
            },
            real: Material {
                k_a: k,
                k_d: k,
                k_s: i,
                m,
            },
            attenuation,
            sun: DirectionalLight { l, intensity: i },
            lamps: [lamp],
            step: c,
            spot: SpotLight {
                point: lamp,
                axis,
                cone: Cone::<f32>::from_cosine(inner).unwrap_or(everything),
            },
            soft_spot: SpotLight {
                point: ranged,
                axis,
                cone: SoftCone::<f32>::from_cosines(inner, outer).unwrap(),
            },
            incident: IncidentLight {
                l,
                intensity: i,
                distance: q,
            },
            shaded: Shaded {
                ambient: k,
                diffuse: i,
                specular: k,
            },
        }
    }
}

impl<T: Number> Given<T> {
    /// The light that arrives from each lamp.
    pub fn from_lamps(&self) -> impl Iterator<Item = IncidentLight<T>> {
        let (lamp, step, p) = (self.lamps[0], self.step, self.p);
        (0..4_u32).map(move |k| moved(lamp, step, k).at(p))
    }

    /// The light that arrives from each lamp in front of the surface.
    pub fn lamps_in_front(&self) -> impl Iterator<Item = IncidentLight<T>> {
        let (lamp, step, p, n) = (self.lamps[0], self.step, self.p, self.n);
        (0..4_u32).filter_map(move |k| moved(lamp, step, k).in_front(p, n))
    }
}

fn moved<T: Number>(lamp: PointLight<T>, step: shading::Vec3<T>, k: u32) -> PointLight<T> {
    let mut position = lamp.position;
    for _ in 0..k {
        position += step;
    }
    PointLight { position, ..lamp }
}
