//! Random scenes: of short numbers, and of long ones beside them.
//!
//! Short numbers are made of small integers, so a scene is exact in `f32`, and special positions
//! (perpendicular, opposite, mirrored) are hit exactly and often. Long numbers have all the bits of
//! the renderer's type, and lamps of long scenes stand as near as 2⁻¹⁰ and as far as 2¹⁴.

use std::f64::consts::FRAC_PI_2;

use crate::profile::{BRIGHTEST, Profile};
use crate::random::Random;
use crate::scene::{Kind, Light, Scene, Triple};
use crate::scene::{add, attenuated, cross, dot, length, scale, size, sub, unit};

/// A vector of small whole numbers, with its largest component from 1 to 2 by a power of two.
fn vector(v: Triple) -> Triple {
    v.map(|c| c / size(v).max(1.0).log2().floor().exp2())
}

/// Brighter light on a surface that is as much darker, which gives the same color. So lights are bright in a
/// profile that clamps its colors, too.
fn brighten(scene: &mut Scene, times: f64) {
    let lights = scene.lights.iter().map(|light| light.intensity());
    let brightest = lights.chain([scene.i_a]).map(size).fold(0.0, f64::max);
    if brightest * times > BRIGHTEST {
        return;
    }
    let darker = |k: Triple| scale(k, 1.0 / times);
    (scene.k_a, scene.k_d, scene.k_s) = (darker(scene.k_a), darker(scene.k_d), darker(scene.k_s));
    scene.scale_light(times);
}

/// A random scene, if the renderer has all that it needs.
pub fn scene(profile: &Profile, random: &mut Random) -> Option<Scene> {
    profile.fitted(Generator { profile, random }.scene())
}

struct Generator<'a> {
    profile: &'a Profile,
    random: &'a mut Random,
}

impl Generator<'_> {
    fn scene(&mut self) -> Scene {
        // which numbers of the scene are long
        let is_long = self.random.once_in(2);
        let (profile, n) = (self.profile, self.integers());
        let p = [(); 3].map(|()| self.random.integer(-8, 8) / 4.0);
        let p = if is_long { self.long_point(p) } else { p };
        let ([k_a, k_d, k_s], m) = self.material(is_long);
        let i_a = self.color(profile.brightest(), is_long);
        let count = self.random.below(profile.most_lights.min(4) + 1);
        let ways: Vec<Triple> = (0..count).map(|_| self.way(n)).collect();
        let lights = ways.iter().map(|way| self.light(p, *way, is_long));
        let lights: Vec<Light> = lights.collect();
        let first = ways.first().copied().unwrap_or(n);
        let far = self.random.one_of(&[1.0, 2.0, 0.25, 8.0]);
        let v = if self.random.once_in(5) {
            self.mirrored(n, first, m, is_long)
        } else {
            vector(self.way(n))
        };
        let mut n_of_scene = vector(n).map(|c| c / 2.0);
        let mut v = v.map(|c| c * far);
        if is_long {
            let [by_n, by_v] = [(); 2].map(|()| self.random.scale(0.125, 8.0));
            n_of_scene = self.tilted(n_of_scene).map(|c| profile.rounded(c * by_n));
            v = v.map(|c| profile.rounded(c * by_v));
        }
        let mut scene = Scene {
            model: self.random.one_of(&profile.models),
            p,
            n: n_of_scene,
            v,
            k_a,
            k_d,
            k_s,
            m,
            i_a,
            lights,
        };
        if self.random.once_in(4) {
            let times = self.random.one_of(&[2.0, 4.0, 8.0, 16.0]);
            brighten(&mut scene, times);
        }
        scene
    }

    /// A vector of small whole numbers that is not 0.
    fn integers(&mut self) -> Triple {
        let v = [(); 3].map(|()| {
            let most = if self.random.once_in(4) { 60 } else { 4 };
            self.random.integer(-most, most)
        });
        if size(v) > 0.0 { v } else { [0.0, 0.0, 1.0] }
    }

    /// A vector, mostly within 90° of the normal.
    fn way(&mut self, n: Triple) -> Triple {
        let any = self.integers();
        let way = match self.random.below(17) {
            0..=9 if dot(any, n) < 0.0 => scale(any, -1.0),
            0..=13 => any,
            14 => cross(any, n),
            15 => n,
            _ => scale(n, -1.0),
        };
        if size(way) > 0.0 { way } else { n }
    }

    /// Where the first light is mirrored, or near there, so that the highlight is bright.
    fn mirrored(&mut self, n: Triple, first: Triple, m: f64, is_long: bool) -> Triple {
        let (twice, square) = (2.0 * dot(n, first), dot(n, n));
        let exact = vector(sub(scale(n, twice), scale(first, square)));
        let off = if is_long { 2.0 / m.sqrt() } else { 0.0 };
        exact.map(|c| c + off * self.random.real(-1.0, 1.0))
    }

    fn tilted(&mut self, v: Triple) -> Triple {
        let tilted = v.map(|c| c + self.random.real(-0.1, 0.1));
        if self.random.once_in(2) { tilted } else { v }
    }

    fn long_point(&mut self, short: Triple) -> Triple {
        let most = self.random.one_of(&[2.0, 2.0, 2.0, 30.0]);
        let long = [(); 3].map(|()| self.profile.rounded(self.random.real(-most, most)));
        if self.random.once_in(2) { long } else { short }
    }

    /// From 0 to `most`: a multiple of 1/8, or any number.
    fn amount(&mut self, most: f64, is_long: bool) -> f64 {
        if is_long && self.random.once_in(2) {
            self.profile.rounded(self.random.real(0.0, most))
        } else {
            self.random.integer(0, 8) * most / 8.0
        }
    }

    fn color(&mut self, most: f64, is_long: bool) -> Triple {
        // dark colors have other digits of sRGB
        let is_dark = is_long && self.random.once_in(8);
        let most = if is_dark { most / 64.0 } else { most };
        [(); 3].map(|()| self.amount(most, is_long))
    }

    /// k_a, k_d and k_s, and the shininess.
    fn material(&mut self, is_long: bool) -> ([Triple; 3], f64) {
        let [k_a, k_d, k_s] = [(); 3].map(|()| self.color(1.0, is_long));
        let most = self.profile.most_shiny;
        let m = match self.random.below(4) {
            0 | 1 => self.random.integer(4, 40) / 4.0,
            2 => (4.0 * self.random.real(1.0, most)).floor() / 4.0,
            _ if is_long => self.random.scale(1.0, most),
            _ => self.random.scale(1.0, most).round(),
        };
        ([k_a, k_d, k_s], self.profile.shininess(m))
    }

    fn light(&mut self, p: Triple, way: Triple, is_long: bool) -> Light {
        let (profile, way) = (self.profile, vector(way));
        let kind = self.random.one_of(&profile.lights);
        let intensity = self.color(profile.brightest(), is_long);
        let short = self.random.one_of(&[1.0, 2.0, 0.5, 4.0]);
        let distance = match self.random.below(4) {
            0 if is_long => self.random.scale(1.0 / 1024.0, 16384.0),
            1 if is_long => self.random.scale(0.25, 8.0),
            _ => short,
        };
        let position = add(p, scale(way, distance));
        let position = position.map(|c| if is_long { profile.rounded(c) } else { c });
        let q = distance * length(way);
        let attenuation = self.attenuation(q, is_long);
        // a lamp that the attenuation brightens is dim
        let left = attenuated(q, attenuation);
        let is_bright = is_long && kind != Kind::Directional && left > 1.0;
        let less = if is_bright { 1.0 / left } else { 1.0 };
        let intensity = intensity.map(|c| profile.rounded(c * less));
        let point = Light::point(intensity, position, attenuation);
        match kind {
            Kind::Directional => Light::Directional { intensity, l: way },
            Kind::Point => point,
            Kind::Spot => {
                let (axis, half_angle) = self.spot(way, is_long);
                point.with_cone(axis, half_angle)
            }
        }
    }

    /// a, b and c: short ones, or such that the light is neither gone nor endless at the distance.
    fn attenuation(&mut self, q: f64, is_long: bool) -> Triple {
        let eighth = |random: &mut Random| random.integer(0, 8) / 8.0;
        if !is_long || self.random.once_in(4) {
            let a = self.random.one_of(&[1.0, 0.5, 2.0, 0.0]);
            let (b, c) = (eighth(self.random), eighth(self.random));
            let is_dim = b * q + c * q * q >= 0.125;
            return [if a == 0.0 && !is_dim { 1.0 } else { a }, b, c];
        }
        let left = self.random.scale(0.01, 100.0);
        let mut shares = [(); 3].map(|()| eighth(self.random));
        if shares == [0.0; 3] {
            shares[2] = 1.0;
        }
        let sum: f64 = shares.iter().sum();
        let [a, b, c] = shares.map(|share| share / (sum * left));
        [a, b / q, c / (q * q)].map(|x| self.profile.rounded(x))
    }

    /// An axis and an angle, such that the cone often ends near the point.
    fn spot(&mut self, way: Triple, is_long: bool) -> (Triple, f64) {
        let aim = sub([(); 3].map(|()| self.random.integer(-2, 2) / 4.0), way);
        let aim = if aim == [0.0; 3] { way } else { aim };
        let axis = self.profile.unit(aim);
        let short = self.random.integer(5, 90);
        let l = unit(way);
        let off = libm::acos((-dot(axis, l)).clamp(-1.0, 1.0));
        let degrees = match self.random.below(3) {
            0 if is_long => self.random.real(5.0, 90.0),
            1 if is_long => {
                let beyond = self.random.scale(0.001, 0.2) * self.random.one_of(&[-1.0, 1.0]);
                off.to_degrees() * (1.0 + beyond)
            }
            _ => short,
        };
        let is_usual = (1.0..=90.0).contains(&degrees);
        let angle = if is_usual { degrees } else { short }.to_radians();
        (axis, self.profile.rounded(angle).min(FRAC_PI_2))
    }
}
