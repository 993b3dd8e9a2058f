//! Scenes in fixed point, and what the crate makes of them.

#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // of bits

use shading::fixed::{
    Attenuation, Cone, DirectionalLight, Fixed, IncidentLight, Material, PointLight, Rgb,
    SpotLight, UnitVec3, Vec3,
};
use shading::{Real, half_vector, normal, reflection, shade, term};

const LIGHTS: usize = 3;
/// As in fixed.c.
const ARGUMENTS: usize = 88;
const LIGHT: usize = 22;
pub const RESULTS: usize = 61;

pub type Scene = [i32; ARGUMENTS];

/// Reads scenes and writes results, or writes the encodings of all light from below black to above white.
pub const PROGRAM: &str = include_str!("../fixed.c");
pub const LEVELS: &str = "levels";

pub fn words<'a>(all: impl IntoIterator<Item = &'a i32>) -> Vec<u8> {
    all.into_iter().flat_map(|x| x.to_le_bytes()).collect()
}

pub fn levels_by_the_crate() -> Vec<u8> {
    let of = |steps| {
        let light = Fixed::from_bits(steps);
        let [byte, ..] = Rgb::gray(light).to_srgb8();
        [Rgb::gray(light).to_rgb565().into(), byte.into()]
    };
    words((-2..65_540).flat_map(of).collect::<Vec<_>>().iter())
}

pub fn by_the_crate(scene: &Scene) -> [i32; RESULTS] {
    let number = |i: usize| Fixed::from_bits(scene[i]);
    let vector = |i: usize| Vec3::new(number(i), number(i + 1), number(i + 2));
    let unit = |i: usize| UnitVec3::assume_unit(vector(i));
    let color = |i: usize| Rgb::new(number(i), number(i + 1), number(i + 2));
    let or_zero = |v: Option<UnitVec3>| v.map_or(Vec3::ZERO, |v| *v);
    let mut results = Vec::new();
    let mut give = |numbers: &[Fixed]| results.extend(numbers.iter().map(|x| x.to_bits()));
    let give3 = |give: &mut dyn FnMut(&[Fixed]), v: Vec3| give(&[v.x, v.y, v.z]);

    let (n, v, p) = (unit(0), unit(3), vector(6));
    let m = scene[9] as u32;
    give3(&mut give, or_zero((*n).unit()));
    give(&[p.length()]);
    give3(&mut give, *reflection(n, v));
    give3(&mut give, or_zero(half_vector(n, v)));
    give(&[
        term::lambert(n, v),
        term::phong(n, v, m),
        term::blinn(v, n, m),
    ]);
    give(&[Real::sqrt(n.x)]);
    give3(&mut give, or_zero(normal::plane(p.x, p.y, p.z)));
    give3(&mut give, or_zero(normal::sphere(*n, p)));
    give3(&mut give, or_zero(normal::triangle(*n, *v, p)));
    give3(&mut give, *normal::facing(n, v, UnitVec3::assume_unit(p)));
    // coefficients and a limit that are no lamp's, as a rule
    let [q, limit] = [scene[6], scene[3]].map(|bits| Fixed::from_bits(bits & i32::MAX));
    let unchecked = Fixed::attenuated(color(19), [n.x, n.y, n.z], q, limit);
    let Rgb { r, g, b } = unchecked.color;
    give(&[r, g, b]);
    let light = |i: usize| -> IncidentLight {
        let (l, position, intensity) = (unit(i + 3), vector(i + 3), color(i + 6));
        let attenuation = Attenuation::new(number(i + 9), number(i + 10), number(i + 11))
            .and_then(|unlimited| unlimited.clamped_to(number(i + 12)))
            .and_then(|limited| match scene[i + 1] {
                0 => limited.within(number(i + 13)),
                _ => limited.within_gltf(number(i + 13)),
            })
            .expect("a valid falloff");
        let point = PointLight {
            position,
            intensity,
            attenuation,
        };
        // beyond the ends of cosines, and where there is no edge between the two, the header has a hard cone
        let inner = number(i + 17).clamp(Fixed::NEG_ONE, Fixed::ONE);
        let outer = number(i + 18).clamp(Fixed::NEG_ONE, inner);
        let hard = Cone::from_cosines(inner, outer).expect("a valid cone");
        let cone = if scene[i + 2] == 0 {
            hard
        } else {
            hard.smoothstep()
        };
        let axis = unit(i + 14);
        match scene[i] {
            0 => DirectionalLight { l, intensity }.at(p),
            1 => point.at(p),
            _ => SpotLight { point, axis, cone }.at(p),
        }
    };
    let lights: [IncidentLight; LIGHTS] = std::array::from_fn(|k| light(LIGHT * (k + 1)));
    for light in lights {
        let arrival = light.arrival();
        give3(&mut give, *arrival.l);
        give(&[arrival.distance]);
        let Rgb { r, g, b } = arrival.intensity;
        give(&[r, g, b]);
    }
    let material = Material {
        k_a: color(10),
        k_d: color(13),
        k_s: color(16),
        m,
    };
    for shaded in [
        shade::lambert(n, &material, color(19), lights),
        shade::phong(n, v, &material, color(19), lights),
        shade::blinn_phong(n, v, &material, color(19), lights),
    ] {
        let Rgb { r, g, b } = shaded.total();
        give(&[r, g, b]);
    }
    let n = Rgb::new(n.x, n.y, n.z);
    results.push(n.to_rgb565().into());
    results.push(n.to_srgb8()[0].into());
    results.try_into().expect("as many results as in fixed.c")
}

/// How the numbers of a scene are drawn.
#[derive(Clone, Copy, PartialEq)]
enum Draw {
    /// Any bits.
    Any,
    /// Lights at the ends of what the formulas distinguish.
    Edge,
    /// What a renderer has.
    Ordinary,
}

pub fn scenes() -> impl Iterator<Item = Scene> {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let draws = [Draw::Any, Draw::Edge, Draw::Ordinary, Draw::Edge];
    draws
        .into_iter()
        .cycle()
        .map(move |draw| random.scene(draw))
}

struct Random(u64);

impl Random {
    fn bits(&mut self) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32) as i32
    }

    fn below(&mut self, end: i32) -> i32 {
        self.bits().rem_euclid(end)
    }

    /// A number with any count of digits, one at an end of its range, or one whose root is just below the middle
    /// of two steps.
    fn any(&mut self) -> i32 {
        let size = self.bits() >> self.below(32);
        let k = self.below(181) + 1;
        match self.below(12) {
            0 => 0,
            1 => i32::MAX,
            2 => i32::MIN,
            3 => 1 << 16,
            4 => k * ((k << 16) + 1),
            _ => size,
        }
    }

    fn positive(&mut self) -> i32 {
        self.any().saturating_abs()
    }

    fn direction(&mut self) -> [i32; 3] {
        loop {
            let [x, y, z] = std::array::from_fn(|_| Fixed::from_bits(self.bits()));
            if let Some(unit) = Vec3::new(x, y, z).unit() {
                return [unit.x, unit.y, unit.z].map(Fixed::to_bits);
            }
        }
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.bits() as usize % all.len()]
    }

    fn scene(&mut self, draw: Draw) -> Scene {
        let mut scene: Scene = std::array::from_fn(|_| self.any());
        let exponents = [scene[9], self.below(130), self.below(3)];
        scene[9] = self.one_of(&exponents);
        if draw == Draw::Any {
            self.unusual(&mut scene);
        }
        if draw != Draw::Any {
            scene[0..3].copy_from_slice(&self.direction());
            scene[3..6].copy_from_slice(&self.direction());
            scene[6..9].fill_with(|| self.bits() >> 12);
            scene[10..22].fill_with(|| self.below(65_537));
        }
        let (shared, lights) = scene.split_at_mut(LIGHT);
        for light in lights.chunks_mut(LIGHT) {
            self.light(draw != Draw::Any, light);
            if draw == Draw::Any && self.below(4) == 0 {
                light[3..6].fill_with(|| self.below(4) - 1);
            }
            if draw == Draw::Edge {
                self.edge(&shared[3..6], &shared[6..9], light);
            }
        }
        scene
    }

    /// Directions and points that random numbers rarely give.
    fn unusual(&mut self, scene: &mut Scene) {
        match self.below(5) {
            // directions too long for a half vector, whose cosine a small exponent shows
            0 | 1 => {
                scene[0..3].copy_from_slice(&self.direction());
                scene[9] = self.below(2);
                let length = self.below(5) + 3;
                let v = self.direction().map(|x| x * length);
                scene[3..6].copy_from_slice(&v);
            }
            // products of single steps
            2 => scene[0..9].fill_with(|| self.below(4) - 1),
            // a triangle that is nearly a line
            3 => {
                scene[0..9].fill(0);
                scene[3] = 1 << 16;
                scene[6..8].copy_from_slice(&[1 << 30, self.below(16)]);
            }
            _ => {}
        }
    }

    fn light(&mut self, is_ordinary: bool, light: &mut [i32]) {
        light[0..3].copy_from_slice(&[self.below(3), self.below(2), self.below(2)]);
        // a, b and c, near which the factor is 1, or any
        light[9..12].fill_with(|| self.positive());
        light[12..14].fill_with(|| self.positive().max(1));
        if is_ordinary {
            light[3..6].fill_with(|| self.bits() >> 11);
            light[6..9].fill_with(|| self.below(1 << 19));
            light[9..12].fill_with(|| self.below(1 << 17) >> self.below(14));
            light[14..17].copy_from_slice(&self.direction());
            if light[0] == 0 {
                light[3..6].copy_from_slice(&self.direction());
            }
            light[13] = self.below(1 << 22) + 1;
            let edges = [self.below(131_073) - 65_536, self.below(131_073) - 65_536];
            light[17] = edges[0].max(edges[1]);
            light[18] = edges[0].min(edges[1]);
        }
        if light[9..12] == [0; 3] {
            light[9] = 1;
        }
        for end in &mut light[12..14] {
            if self.below(2) == 0 {
                *end = i32::MAX;
            }
        }
        match self.below(8) {
            0 => light[18] = light[17],
            1 => light[17..19].fill(-65_536),
            _ => {}
        }
    }

    /// Makes an ordinary light an edge for the point p, seen from v: a sun behind the point, or a lamp on an axis
    /// through it.
    fn edge(&mut self, v: &[i32], p: &[i32], light: &mut [i32]) {
        if light[0] == 0 {
            return light[3..6].copy_from_slice(&[-v[0], -v[1], -v[2]]);
        }
        let mut q = 1 + ((self.bits() & i32::MAX) >> (1 + self.below(29)));
        let bright = |random: &mut Self| random.bits() & i32::MAX;
        match self.below(5) {
            // a factor that is too large for the header's numbers, or nearly so, and little light
            0 => {
                q = 1 + (q >> 20);
                light[6..9].fill_with(|| self.below(9));
                light[9..12].copy_from_slice(&[0, 0, 1 + self.below(3)]);
            }
            // a denominator within a step of 1
            1 => {
                let square = i64::from(q) * i64::from(q);
                let c = self.below(((1 << 48) / square).clamp(1, 1 << 30) as i32);
                let a = (((1 << 48) - i64::from(c) * square) >> 32) as i32 + self.below(3) - 1;
                light[6..9].fill_with(|| bright(self));
                light[9..12].copy_from_slice(&[a.max(1), 0, c]);
            }
            // a slope with all 32 bits
            2 => {
                q = 1 + self.below(1 << 16);
                light[6..9].fill_with(|| bright(self));
                light[9..12].fill_with(|| i32::MAX - self.below(9));
            }
            // a limit below 1, and a denominator below 32
            3 => {
                light[6..9].fill_with(|| bright(self));
                light[9..12].copy_from_slice(&[self.below(1 << 21), 0, 0]);
                light[12] = 1 + self.below(1 << 16);
            }
            // near a lamp with a large range
            _ => {
                q = 1 + (q >> 15);
                light[13] = bright(self).max(1);
            }
        }
        let (along, sign) = (self.below(3) as usize, self.one_of(&[1, -1]));
        light[3..6].copy_from_slice(p);
        light[3 + along] = p[along].saturating_add(sign * q);
        if self.below(2) == 0 {
            light[14..17].fill(0);
            light[14 + self.below(3) as usize] = self.one_of(&[1 << 16, -1 << 16]);
        }
        // the least and the largest cosine that a cone stores, and those beside
        let cosines = [
            -65_536, -65_533, -65_532, -65_531, 0, 65_531, 65_532, 65_533, 65_536,
        ];
        let edges = [self.one_of(&cosines), self.one_of(&cosines)];
        light[17] = edges[0].max(edges[1]);
        light[18] = edges[0].min(edges[1]);
    }
}
