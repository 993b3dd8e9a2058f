//! Whole colors in fixed point against the same formulas in `f64`, for the very same numbers: a climb to the
//! worst scene. A scene is made of a tape of random numbers, and its neighbors of a tape that differs in a few.

use shading::fixed::{
    Attenuation, Cone, Fixed, IncidentLight, Material, PointLight, Rgb, Shaded, SoftCone,
    SpotLight, UnitVec3, Vec3,
};
use shading::{Beam, DirectionalLight, Elementary, Falloff, Light, reflection, shade};

use crate::{Random, exact};

/// By how much the cosine of two directions may be off: each coordinate of a computed direction by
/// 0.51 steps, together by √3 times that, and the product by half a step. Where light has an edge,
/// at the horizon of a highlight and at that of a hard cone, a light may be on either side of it
/// within this margin.
const MARGIN: f64 = (0.51 * 1.733 + 0.5) / 65536.0;

/// The least |L + V| for a half vector: an error in L turns H by as much over |L + V|.
const LEAST_SUM: f64 = 0.1;

/// A light as it arrives, in fixed point and in `f64`, and by how many steps its intensity may be off.
type Arriving = (IncidentLight, shading::f64::IncidentLight, f64);

/// Random numbers that can be played again.
struct Tape {
    numbers: Vec<u64>,
    at: usize,
    random: Random,
}

impl Tape {
    fn bits(&mut self) -> u64 {
        if self.at == self.numbers.len() {
            self.numbers.push(self.random.bits());
        }
        self.at += 1;
        self.numbers[self.at - 1]
    }

    #[allow(clippy::cast_precision_loss)] // 53 bits
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// The choice depends on the highest bits, so that a small change to the tape seldom changes it.
    fn below(&mut self, count: usize) -> usize {
        let choice = (u128::from(self.bits()) * count as u128) >> 64;
        usize::try_from(choice).expect("a small number")
    }

    /// A neighbor: some numbers are changed, by anything from the last digit to everything.
    fn changed(&mut self) -> Self {
        let mut numbers = self.numbers.clone();
        for _ in 0..=self.random.below(3) {
            let place = self.random.below(numbers.len());
            let change = self.random.bits() >> self.random.below(56);
            numbers[place] = if self.random.below(2) == 0 {
                numbers[place].wrapping_add(change)
            } else {
                numbers[place].wrapping_sub(change)
            };
        }
        let random = Random(self.random.bits());
        Self {
            numbers,
            at: 0,
            random,
        }
    }
}

fn arriving<C, A>(light: &Light<Fixed, C, A>, p: Vec3) -> Arriving
where
    C: Beam<Fixed, In<f64>: Beam<f64>>,
    A: Falloff<Fixed, In<f64>: Falloff<f64>>,
{
    let light64 = light.cast(exact).at(p.map(exact));
    (light.at(p), light64, off_by(light64.intensity))
}

/// The steps by which what arrives from a lamp may be off: two, or 2⁻¹⁵, which is two steps of 1.
fn off_by(intensity: shading::f64::Rgb) -> f64 {
    2.0 * intensity.r.max(intensity.g).max(intensity.b).max(1.0)
}

/// The same behind a soft edge. The cosine is off by the margin, t by that over the width w of the edge and a
/// step for the quotient, and t² or t²(3 − 2t) by twice that and a step. The product adds half a step.
fn softly_arriving<A>(spot: &SpotLight<SoftCone, A>, p: Vec3) -> Arriving
where
    A: Falloff<Fixed, In<f64>: Falloff<f64>>,
{
    let (light, light64, _) = arriving(&Light::Spot(*spot), p);
    let full = off_by(spot.point.cast(exact).at(p.map(exact)).intensity);
    let [inner, outer] = spot.cone.cosines().map(exact);
    let edge = 2.0 * 65536.0 * MARGIN / (inner - outer) + 3.0;
    (light, light64, full + full / 2.0 * edge + 0.5)
}

impl Tape {
    fn number(&mut self, low: f64, high: f64) -> Fixed {
        Fixed::new(self.within(low, high))
    }

    /// A number that is as often between 1 and 2 as between 2 and 4.
    fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        // from `libm`, and so the same on every machine
        let [low, high] = [low, high].map(Elementary::ln);
        Elementary::exp(self.within(low, high))
    }

    fn vector(&mut self, size: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| self.number(-size, size)))
    }

    fn direction(&mut self) -> UnitVec3 {
        self.vector(1.0).unit_or(UnitVec3::Z)
    }

    fn color(&mut self) -> Rgb {
        Rgb::from([(); 3].map(|()| self.number(0.0, 1.0)))
    }

    fn lamp(&mut self, p: Vec3) -> PointLight {
        loop {
            let distance = self.of_any_size(0.1, 200.0);
            let position = p + self.direction().map(|c| Fixed::new(exact(c) * distance));
            let [a, b, c] = match self.below(3) {
                0 => [1.0, 0.0, 0.0],
                1 => [0.0, 0.0, self.of_any_size(0.001, 1.0)],
                _ => {
                    let [b, c] = [(); 2].map(|()| self.of_any_size(0.001, 1.0));
                    [self.within(0.0, 1.0), b, c]
                }
            };
            let attenuation = Attenuation::new(Fixed::new(a), Fixed::new(b), Fixed::new(c));
            let attenuation = attenuation.expect("coefficients");
            let q = (position - p).map(exact).length();
            let denominator = 1.0 / attenuation.cast(exact).at(q);
            let bright = self.of_any_size(0.25, 4.0);

            let is_far = [position.x, position.y, position.z]
                .iter()
                .any(|c| exact(*c).abs() > 100.0);
            if is_far || q == 0.0 {
                continue;
            }
            // so that it arrives with up to 4, if there is a number that large
            let intensity = self
                .color()
                .map(|i| Fixed::new(exact(i) * bright * denominator));
            return PointLight {
                position,
                intensity,
                attenuation,
            };
        }
    }

    fn soft_cone(&mut self) -> SoftCone {
        loop {
            let inner = self.number(0.0, 1.4);
            let outer = inner + self.number(0.05, 0.5);
            let cone = SoftCone::from_half_angles(inner, outer).expect("angles");
            let [inner, outer] = cone.cosines().map(exact);
            if inner - outer >= 0.05 {
                return if self.below(2) == 0 {
                    cone
                } else {
                    cone.smoothstep()
                };
            }
        }
    }

    /// A light of any kind; `None` if the point is on the edge of a hard cone.
    fn light(&mut self, p: Vec3) -> Option<Arriving> {
        let point = self.lamp(p);
        let l = (point.position - p).unit().expect("a distance");
        let axis = (self.vector(0.5) - *l).unit_or(-l); // the point is often in the cone
        let range = Fixed::new(exact(point.at(p).distance) * self.within(0.9, 4.0));
        let ranged = PointLight {
            position: point.position,
            intensity: point.intensity,
            attenuation: point.attenuation.within(range).expect("a range"),
        };
        Some(match self.below(7) {
            0 => {
                let (l, intensity) = (self.direction(), self.color());
                let sun = DirectionalLight { l, intensity };
                arriving(&Light::<_, Cone, Attenuation>::from(sun), p)
            }
            1 => arriving(&Light::<_, Cone, _>::Point(point), p),
            2 => arriving(&Light::<_, Cone, _>::Point(ranged), p),
            kind @ (3 | 4) => {
                let cone = Cone::from_half_angle(self.number(0.05, 1.5)).expect("an angle");
                let cosine = -axis
                    .cast(exact)
                    .dot((point.position - p).map(exact).unit()?);
                if (cosine - exact(cone.cosine())).abs() <= MARGIN {
                    return None;
                }
                if kind == 3 {
                    arriving(&Light::Spot(SpotLight { point, axis, cone }), p)
                } else {
                    let point = ranged;
                    arriving(&Light::Spot(SpotLight { point, axis, cone }), p)
                }
            }
            5 => {
                let cone = self.soft_cone();
                softly_arriving(&SpotLight { point, axis, cone }, p)
            }
            _ => {
                let (point, cone) = (ranged, self.soft_cone());
                softly_arriving(&SpotLight { point, axis, cone }, p)
            }
        })
    }
}

#[derive(Clone, Copy)]
enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

/// A scene shaded in fixed point and in `f64`, and by how many steps they may differ.
fn shaded(model: Model, random: &mut Tape) -> (Shaded, shading::f64::Shaded, f64) {
    let p = random.vector(100.0);
    let count = 1 + random.below(4);
    let lights = (0..count).filter_map(|_| random.light(p));
    let mut lights: Vec<_> = lights.collect();

    // toward the first light, and the eye is often in its highlight
    let n = random.direction();
    let first = lights.first().map_or(n, |(light, ..)| light.l);
    let n = if exact(n.dot(first)) < 0.0 { -n } else { n };
    let aside = random.of_any_size(0.01, 1.0);
    let v = match random.below(2) {
        0 => random.direction(),
        _ => (*reflection(n, first) + random.vector(aside)).unit_or(n),
    };
    let [k_a, k_d, k_s, i_a] = [(); 4].map(|()| random.color());
    let m = u32::try_from(1 + random.below(128)).expect("small");
    let material = Material { k_a, k_d, k_s, m };

    let [n64, v64] = [n, v].map(|direction| direction.cast(exact));
    if !matches!(model, Model::Lambert) {
        lights.retain(|(_, light, _)| n64.dot(light.l).abs() > MARGIN);
    }
    if matches!(model, Model::BlinnPhong) {
        lights.retain(|(_, light, _)| (*light.l + *v64).length() >= LEAST_SUM);
    }
    let m = if matches!(model, Model::Lambert) {
        0
    } else {
        m
    };
    let material = Material { m, ..material };
    let most = bound(&material, &lights);
    let lights64: Vec<_> = lights.iter().map(|(_, light, _)| *light).collect();
    let lights: Vec<_> = lights.iter().map(|(light, ..)| *light).collect();
    let (material64, i_a64) = (material.cast(exact), i_a.map(exact));
    let (fixed, double) = match model {
        Model::Lambert => (
            shade::lambert(n, &material, i_a, lights),
            shade::lambert(n64, &material64, i_a64, lights64),
        ),
        Model::Phong => (
            shade::phong(n, v, &material, i_a, lights),
            shade::phong(n64, v64, &material64, i_a64, lights64),
        ),
        Model::BlinnPhong => (
            shade::blinn_phong(n, v, &material, i_a, lights),
            shade::blinn_phong(n64, v64, &material64, i_a64, lights64),
        ),
    };
    (fixed, double, most)
}

/// The bound that `docs/precision.md` gives, in steps.
///
/// The cosine of a light is off by less than 1.4 steps, and a power of one by 1.5m + 1. Each product and each
/// sum with a product adds half a step.
fn bound(material: &Material, lights: &[Arriving]) -> f64 {
    let largest = |color: shading::f64::Rgb| color.r.max(color.g).max(color.b);
    let [k_d, k_s] = [material.k_d, material.k_s].map(|k| largest(k.map(exact)));
    let highlight = if material.m == 0 {
        0.0
    } else {
        1.5 * f64::from(material.m) + 1.0
    };
    let of_lights = lights.iter().map(|(_, light, off_by)| {
        let intensity = largest(light.intensity);
        k_d * (off_by + 1.4 * intensity + 0.5) + k_s * (off_by + highlight * intensity + 0.5)
    });
    1.5 + of_lights.sum::<f64>()
}

impl Model {
    /// The difference of the scene of a tape, in steps and as a share of the bound.
    fn difference(self, tape: &mut Tape) -> [f64; 2] {
        tape.at = 0;
        let (fixed, double, most) = shaded(self, tape);
        let difference = (fixed.total().map(exact) - double.total()).map(|c| 65536.0 * c.abs());
        let steps = difference.r.max(difference.g).max(difference.b);
        [steps, steps / most]
    }
}

#[test]
fn colors_are_within_their_bound() {
    let is_long = std::env::var("SHADING_SEARCH").is_ok_and(|extent| extent == "all");
    let (climbs, changes) = if is_long { (400, 4000) } else { (8, 800) };
    for (name, model) in [
        ("Lambert", Model::Lambert),
        ("Phong", Model::Phong),
        ("Blinn–Phong", Model::BlinnPhong),
    ] {
        let (mut worst, mut random) = (0.0_f64, Random(10));
        for _ in 0..climbs {
            let tapes = (0..40).map(|_| {
                let random = Random(random.bits());
                let mut tape = Tape {
                    numbers: Vec::new(),
                    at: 0,
                    random,
                };
                let [_, share] = model.difference(&mut tape);
                (tape, share)
            });
            let best = tapes.max_by(|a, b| a.1.total_cmp(&b.1));
            let (mut tape, mut share) = best.expect("tapes");
            for _ in 0..changes {
                let mut other = tape.changed();
                let [_, higher] = model.difference(&mut other);
                if higher >= share {
                    (tape, share) = (other, higher);
                }
            }
            let [steps, _] = model.difference(&mut tape);
            assert!(share <= 1.0, "{name}: {steps} steps, {share} of the bound");
            worst = worst.max(share);
        }
        println!("{name}: {worst:.3} of the bound");
    }
}

/// A scene that a longer climb found: 0.735 levels of one lamp.
#[test]
fn a_highlight_magnifies_the_error_of_its_cosine() {
    let bits = |[x, y, z]: [i32; 3]| Vec3::from([x, y, z].map(Fixed::from_bits));
    let [n, v] = [[8088, -75, 8839], [-28801, -48313, 32109]]
        .map(|direction| bits(direction).unit().expect("a direction"));
    let p = bits([1_682_805, -1_343_390, 2_901_064]);
    let [zero, c] = [0, 126_055].map(Fixed::from_bits);
    let lamp = PointLight {
        position: bits([1_686_579, -1_338_261, 2_898_424]),
        intensity: Rgb::gray(Fixed::from_bits(1356)),
        attenuation: Attenuation::new(zero, zero, c).expect("coefficients"),
    };
    let [k_d, k_s] = [28_589, 65_492].map(|bits| Rgb::gray(Fixed::from_bits(bits)));
    let material = Material {
        k_a: Rgb::BLACK,
        k_d,
        k_s,
        m: 128,
    };
    let light = arriving(&Light::<_, Cone, _>::Point(lamp), p);
    let fixed = shade::phong(n, v, &material, Rgb::BLACK, [light.0]).total();
    let double = shade::phong(
        n.cast(exact),
        v.cast(exact),
        &material.cast(exact),
        shading::f64::Rgb::BLACK,
        [light.1],
    );
    let steps = 65536.0 * (exact(fixed.r) - double.total().r).abs();
    assert!(steps <= bound(&material, &[light]), "{steps} steps");
    // more than half a level of 8 bits
    assert!(steps > 0.5 / 255.0 * 65536.0, "{steps} steps");
}
