//! The light of `shading.h`, and the light of the crate that it becomes. C and JavaScript use it with
//! `f32`, Python also with `f64`.

use shading::{Attenuation, Cone, DirectionalLight, PointLight, Rgb, SpotLight, UnitVec3, Vec3};

use crate::number::Number;
use crate::problem::{Problem, Status, triple};

#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Light<T = f32> {
    pub kind: u32,
    pub position: [T; 3],
    pub toward: [T; 3],
    pub axis: [T; 3],
    pub intensity: [T; 3],
    pub attenuation: [T; 3],
    pub range: T,
    pub inner: T,
    pub outer: T,
    pub gltf: u32,
}

// as JavaScript writes it: twenty words
const _: () = assert!(size_of::<Light>() == 80);

pub const DIRECTIONAL: u32 = 0;
pub const POINT: u32 = 1;
pub const SPOT: u32 = 2;

impl<T: Number> Light<T> {
    /// A light of the kind with the defaults of all languages. Its position and direction are NaN, so
    /// that forgetting them is an error.
    pub fn default_of(kind: u32) -> Self {
        let unknown = [T::of(f64::NAN); 3];
        let (zero, one) = (T::ZERO, T::ONE);
        Self {
            kind,
            position: unknown,
            toward: unknown,
            axis: unknown,
            intensity: [one; 3],
            attenuation: [one, zero, zero],
            range: T::of(f64::INFINITY),
            inner: zero,
            outer: T::of(std::f64::consts::FRAC_PI_4),
            gltf: 0,
        }
    }

    pub fn checked(&self) -> Result<shading::Light<T>, Problem> {
        match self.kind {
            DIRECTIONAL => Ok(shading::Light::Directional(DirectionalLight {
                l: direction(Status::Toward, "toward", self.toward)?,
                intensity: self.intensity()?,
            })),
            POINT => Ok(shading::Light::Point(self.point()?)),
            SPOT => {
                let point = self.point()?;
                let axis = direction(Status::Axis, "axis", self.axis)?;
                let cone = Cone::from_half_angles(self.inner, self.outer);
                let cone = cone.ok_or_else(|| self.angles())?;
                Ok(shading::Light::Spot(SpotLight { point, axis, cone }))
            }
            kind => Err(Problem::new(
                Status::Kind,
                "kind",
                "0 (directional), 1 (point) or 2 (spot)",
                kind,
            )),
        }
    }

    fn angles(&self) -> Problem {
        let got = format!("{} and {}", self.inner, self.outer);
        let expected = "0 <= inner <= outer <= pi, in radians (a degree is pi/180)";
        Problem::new(Status::Angles, "inner, outer", expected, got)
    }

    fn intensity(&self) -> Result<Rgb<T>, Problem> {
        let expected = "finite numbers of 0 or more";
        let is_light = self.intensity.iter().all(|&channel| is_light(channel));
        is_light.then(|| self.intensity.into()).ok_or_else(|| {
            let got = triple(self.intensity);
            Problem::new(Status::Intensity, "intensity", expected, got)
        })
    }

    fn point(&self) -> Result<PointLight<T>, Problem> {
        let position = finite(Status::Position, "position", self.position)?;
        let [a, b, c] = self.attenuation;
        let attenuation = Attenuation::new(a, b, c).ok_or_else(|| {
            let expected = "three finite numbers a, b, c of 0 or more, and not all 0";
            let got = triple(self.attenuation);
            Problem::new(Status::Attenuation, "attenuation", expected, got)
        })?;
        let ending = match self.gltf {
            0 => attenuation.within(self.range),
            1 => attenuation.within_gltf(self.range),
            gltf => return Err(Problem::new(Status::Gltf, "gltf", "0 or 1", gltf)),
        };
        Ok(PointLight {
            position,
            intensity: self.intensity()?,
            attenuation: ending.ok_or_else(|| {
                let expected = "a number above 0, or infinity";
                Problem::new(Status::Range, "range", expected, self.range)
            })?,
        })
    }
}

/// Light or a reflectance: neither negative nor infinite nor NaN.
pub fn is_light<T: Number>(channel: T) -> bool {
    (channel >= T::ZERO) & (channel <= T::MAX)
}

pub fn is_finite<T: Number>(x: T) -> bool {
    (x >= -T::MAX) & (x <= T::MAX)
}

fn finite<T: Number>(status: Status, name: &str, v: [T; 3]) -> Result<Vec3<T>, Problem> {
    let is_finite = v.iter().all(|&x| is_finite(x));
    let problem = || Problem::new(status, name, "three finite numbers", triple(v));
    is_finite.then(|| v.into()).ok_or_else(problem)
}

fn direction<T: Number>(status: Status, name: &str, v: [T; 3]) -> Result<UnitVec3<T>, Problem> {
    let problem = || Problem::new(status, name, "three finite numbers, not all 0", triple(v));
    Vec3::from(v).unit().ok_or_else(problem)
}
