//! Whole colors in fixed point against the same formulas in `f64`, for the very same numbers: those
//! of a random scene in fixed point.

use shading::fixed::{
    Attenuation, Cone, Fixed, IncidentLight, Material, PointLight, Rgb, Shaded, SoftCone,
    SpotLight, UnitVec3, Vec3,
};
use shading::{Beam, DirectionalLight, Elementary, Falloff, Light, reflection, shade};

use crate::{Random, assert_documented, exact};

/// The largest difference that the page of `Fixed` promises, in levels of 8 bits.
const MOST: f64 = 0.5;

/// By how much the cosine of two directions may be off: each coordinate of a computed direction by
/// 0.51 steps, together by √3 times that, and the product by half a step. Where light has an edge,
/// at the horizon of a highlight and at that of a hard cone, a light may be on either side of it
/// within this margin.
const MARGIN: f64 = (0.51 * 1.733 + 0.5) / 65536.0;

/// The least |L + V| for a half vector: an error in L turns H by as much over |L + V|.
const LEAST_SUM: f64 = 0.1;

/// For each model.
const SCENES: u32 = 100_000;

/// A light as it arrives, in fixed point and in `f64`.
type Arriving = (IncidentLight, shading::f64::IncidentLight);

fn arriving<C, A>(light: &Light<Fixed, C, A>, p: Vec3) -> Arriving
where
    C: Beam<Fixed, In<f64>: Beam<f64>>,
    A: Falloff<Fixed, In<f64>: Falloff<f64>>,
{
    (light.at(p), light.cast(exact).at(p.map(exact)))
}

impl Random {
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

            let is_far = [position.x, position.y, position.z]
                .iter()
                .any(|c| exact(*c).abs() > 100.0);
            // the range that the page of `Fixed` names
            if is_far || denominator < 0.01 * (1.0 + q) || denominator > 32_000.0 {
                continue;
            }
            // so that it arrives with up to 1
            let intensity = self.color().map(|i| Fixed::new(exact(i) * denominator));
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
                arriving(&Light::Spot(SpotLight { point, axis, cone }), p)
            }
            _ => {
                let (point, cone) = (ranged, self.soft_cone());
                arriving(&Light::Spot(SpotLight { point, axis, cone }), p)
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

/// A random scene shaded in fixed point and in `f64`, and how many lights were left out because they
/// are on an edge.
fn shaded(model: Model, random: &mut Random) -> (Shaded, shading::f64::Shaded, u32) {
    let p = random.vector(100.0);
    let count = 1 + random.below(4);
    let lights = (0..count).filter_map(|_| random.light(p));
    let mut lights: Vec<_> = lights.collect();

    // toward the first light, and the eye is often in its highlight
    let n = random.direction();
    let first = lights.first().map_or(n, |(light, _)| light.l);
    let n = if exact(n.dot(first)) < 0.0 { -n } else { n };
    let aside = random.of_any_size(0.01, 1.0);
    let v = match random.below(2) {
        0 => random.direction(),
        _ => (*reflection(n, first) + random.vector(aside)).unit_or(n),
    };
    let [k_a, k_d, k_s, i_a] = [(); 4].map(|()| random.color());
    let m = u32::try_from(random.below(129)).expect("small");
    let material = Material { k_a, k_d, k_s, m };

    let [n64, v64] = [n, v].map(|direction| direction.cast(exact));
    if !matches!(model, Model::Lambert) {
        lights.retain(|(_, light)| n64.dot(light.l).abs() > MARGIN);
    }
    let left_out = u32::try_from(count - lights.len()).expect("small");
    if matches!(model, Model::BlinnPhong) {
        lights.retain(|(_, light)| (*light.l + *v64).length() >= LEAST_SUM);
    }
    let (lights, lights64): (Vec<_>, Vec<_>) = lights.into_iter().unzip();
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
    (fixed, double, left_out)
}

#[test]
fn colors_are_within_half_a_level() {
    let models = [
        ("Lambert", Model::Lambert),
        ("Phong", Model::Phong),
        ("Blinn–Phong", Model::BlinnPhong),
    ];
    for (seed, (name, model)) in models.into_iter().enumerate() {
        let mut random = Random(10 + seed as u64);
        let (mut largest, mut sum, mut left_out) = (0.0_f64, 0.0, 0_u32);
        for _ in 0..SCENES {
            let (fixed, double, on_an_edge) = shaded(model, &mut random);
            let difference = (fixed.total().map(exact) - double.total()).map(|c| 255.0 * c.abs());
            let levels = difference.r.max(difference.g).max(difference.b);
            assert!(levels <= MOST, "{fixed:?} and {double:?}: {levels} levels");
            largest = largest.max(levels);
            sum += difference.r + difference.g + difference.b;
            left_out += on_an_edge;
        }
        let mean = sum / f64::from(3 * SCENES);
        println!("{name}: {largest:.3} levels at most, {mean:.4} on average");
        let what = format!("a color, {name}");
        assert_documented(&what, largest, MOST, "levels of 1/255");
        let what = format!("a color, {name}, on average");
        assert_documented(&what, mean, 0.01, "levels of 1/255");
        // a cosine is within the margin of an edge in 1 of 50,000 cases, and a scene has 5 at most
        assert!(left_out < SCENES / 2000, "{left_out} lights left out");
    }
}
