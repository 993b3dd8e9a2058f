//! Whole colors in fixed point against the same formulas in `f64`, for the very same numbers: a climb to the
//! worst scene. A scene is made of a list of shares, and its neighbors of a list that differs in a few.

use shading::fixed::{
    Attenuation, Cone, DirectionalLight, Fixed, IncidentLight, Light, Material, PointLight, Rgb,
    Shaded, SpotLight, UnitVec3, Vec3,
};
use shading::{reflection, shade};

use crate::{Random, exact};

/// How far a cosine may be from the edge of a hard cone, on either side of which it may fall.
const MARGIN: f64 = 2.0 / 65536.0;

/// The least |L + V|: an error of L turns H by as much over |L + V|.
const LEAST_SUM: f64 = 0.1;

const SHARES: usize = 84;

struct Shares<'a>(std::slice::Iter<'a, f64>);

impl Shares<'_> {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.next().expect("enough shares")
    }

    /// A whole number from `low` to `high`.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // small, and not negative
    fn whole(&mut self, low: u32, high: u32) -> u32 {
        self.within(low.into(), f64::from(high) + 1.0) as u32
    }

    /// As often between 1 and 2 as between 2 and 4.
    fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.within(0.0, 1.0))
    }

    fn vector(&mut self, size: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| Fixed::new(self.within(-size, size))))
    }

    fn direction(&mut self) -> UnitVec3 {
        self.vector(1.0).unit_or(UnitVec3::Z)
    }

    fn color(&mut self) -> Rgb {
        Rgb::from([(); 3].map(|()| Fixed::new(self.within(0.0, 1.0))))
    }

    /// A light of any kind, which arrives with up to 4; `None` if the scene is not what is promised.
    fn light(&mut self, p: Vec3) -> Option<Light> {
        let kind = self.within(0.0, 1.0);
        let toward = self.direction();
        let distance = self.of_any_size(0.01, 200.0);
        let color = self.color() * Fixed::new(self.of_any_size(0.25, 4.0));
        let [a, b, c] = [(); 3].map(|()| self.of_any_size(0.001, 1.0));
        let which = self.whole(0, 2);
        let range = self.within(0.9, 4.0);
        let axis = (self.vector(0.5) - *toward).unit_or(-toward); // the point is often in the cone
        let (angle, width) = (self.within(0.05, 1.4), self.within(0.06, 0.5));
        let smoothstep = self.within(-1.0, 1.0);
        if kind < 0.1 {
            let (l, intensity) = (toward, color);
            return Some(Light::Directional(DirectionalLight { l, intensity }));
        }
        let position = p + toward.map(|x| Fixed::new(exact(x) * distance));
        let q = (position - p).map(exact).length();
        let coefficients = match which {
            0 => [1.0, 0.0, 0.0],
            1 => [0.0, 0.0, c],
            _ => [a, b, c],
        };
        let [a, b, c] = coefficients.map(Fixed::new);
        let attenuation = Attenuation::new(a, b, c)?;
        let denominator = 1.0 / attenuation.cast(exact).at(q);
        let intensity = color.map(|x| Fixed::new(exact(x) * denominator));
        let range = Fixed::new((q * range).max(1.0));
        let attenuation = match kind {
            0.4..0.55 => attenuation.within(range)?,
            0.55..0.7 => attenuation.within_gltf(range)?,
            _ => attenuation,
        };
        let point = PointLight {
            position,
            intensity,
            attenuation,
        };
        if !(0.01..200.0).contains(&q) || kind < 0.6 {
            return (0.01..200.0).contains(&q).then_some(Light::Point(point));
        }
        let [inner, outer] = [angle, angle + width].map(Fixed::new);
        let cone = match (smoothstep, kind > 0.9) {
            (_, true) => Cone::from_half_angle(inner)?,
            (..0.0, _) => Cone::from_half_angles(inner, outer)?,
            _ => Cone::from_half_angles(inner, outer)?.smoothstep(),
        };
        let cosine = -axis.cast(exact).dot((position - p).map(exact).unit()?);
        let [inner, outer] = cone.cosines().map(exact);
        let is_clear = inner - outer > 0.1 || kind > 0.9 && (cosine - inner).abs() > MARGIN;
        is_clear.then_some(Light::Spot(SpotLight { point, axis, cone }))
    }
}

#[derive(Clone, Copy, Debug)]
enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

/// E as sRGB defines it, in levels.
fn levels(light: f64) -> f64 {
    let light = light.clamp(0.0, 1.0);
    255.0
        * if light <= 0.003_130_8 {
            12.92 * light
        } else {
            1.055 * light.powf(1.0 / 2.4) - 0.055
        }
}

/// The levels by which fixed point is off in the scene; `None` if the scene is not what is promised.
fn difference(model: Model, shares: &[f64; SHARES]) -> Option<f64> {
    let mut shares = Shares(shares.iter());
    let p = shares.vector(100.0);
    let count = shares.whole(1, 3);
    let n = shares.direction();
    let m = shares.whole(1, 128);
    let [k_a, k_d, k_s, i_a] = [(); 4].map(|()| shares.color());
    let aside = shares.of_any_size(0.001, 2.0);
    let aside = shares.vector(aside);
    let lights: Option<Vec<_>> = (0..count).map(|_| shares.light(p)).collect();
    let lights = lights?;

    // toward the first light, and the eye is often in its highlight
    let first = lights[0].at(p).l();
    let n = if exact(n.dot(first)) < 0.0 { -n } else { n };
    let v = (*reflection(n, first) + aside).unit_or(n);
    let material = Material { k_a, k_d, k_s, m };
    let [n64, v64] = [n, v].map(|direction| direction.cast(exact));
    let (material64, i_a64) = (material.cast(exact), i_a.map(exact));
    let arriving64 = lights
        .iter()
        .map(|light| light.cast(exact).at(p.map(exact)));
    let arriving64: Vec<_> = arriving64.collect();
    if arriving64
        .iter()
        .any(|light| (*light.l() + *v64).length() < LEAST_SUM)
    {
        return None;
    }
    let arriving = lights.iter().map(|light| light.at(p));
    let (fixed, double) = match model {
        Model::Lambert => (
            shade::lambert(n, &material, i_a, arriving),
            shade::lambert(n64, &material64, i_a64, arriving64),
        ),
        Model::Phong => (
            shade::phong(n, v, &material, i_a, arriving),
            shade::phong(n64, v64, &material64, i_a64, arriving64),
        ),
        Model::BlinnPhong => (
            shade::blinn_phong(n, v, &material, i_a, arriving),
            shade::blinn_phong(n64, v64, &material64, i_a64, arriving64),
        ),
    };
    let (fixed, double) = (fixed.total(), double.total());
    let is_negative = |x: Fixed| x < Fixed::from(0);
    assert!(!<[Fixed; 3]>::from(fixed).into_iter().any(is_negative));
    Some(apart(fixed, double))
}

/// The levels by which fixed point is off where the light of a lamp ends, whose intensity is up to
/// 4,096: a factor near 0 meets a light that is still large. `None` if the scene is not what is
/// promised.
fn difference_at_an_end(shares: &[f64; SHARES]) -> Option<f64> {
    let mut shares = Shares(shares.iter());
    let p = shares.vector(100.0);
    let (toward, n) = (shares.direction(), shares.direction());
    let n = if exact(n.dot(toward)) < 0.0 { -n } else { n };
    let intensity = shares.color() * Fixed::new(shares.of_any_size(4.0, 4096.0));
    let k_d = shares.color();
    let range = Fixed::new(shares.of_any_size(1.0, 200.0));
    // short of the end by this share of the range, or of the width of the edge
    let short = shares.of_any_size(1e-6, 0.3);
    let kind = shares.whole(0, 3);
    let (outer, width) = (shares.within(-0.9, 0.85), shares.of_any_size(0.101, 1.0));
    let aside = shares.direction();

    let distance = exact(range) * if kind < 2 { 1.0 - short } else { 1.0 };
    let position = p + toward.map(|x| Fixed::new(exact(x) * distance));
    let attenuation = match kind {
        0 => Attenuation::NONE.within(range)?,
        1 => Attenuation::NONE.within_gltf(range)?,
        _ => Attenuation::NONE,
    };
    let point = PointLight {
        position,
        intensity,
        attenuation,
    };
    let light = if kind < 2 {
        Light::Point(point)
    } else {
        let cone = Cone::from_cosines(Fixed::new((outer + width).min(1.0)), Fixed::new(outer))?;
        let [inner, outer] = cone.cosines().map(exact);
        if inner - outer <= 0.1 {
            return None;
        }
        let cosine = outer + (inner - outer) * short;
        let from = (p - position).map(exact).unit()?;
        let across = aside.cast(exact).cross(from).unit()?;
        let axis = from.map(|x| x * cosine) + across.map(|x| x * (1.0 - cosine * cosine).sqrt());
        let axis = Vec3::from([axis.x, axis.y, axis.z].map(Fixed::new)).unit()?;
        let cone = if kind == 2 { cone } else { cone.smoothstep() };
        Light::Spot(SpotLight { point, axis, cone })
    };
    let white = Material {
        k_a: Rgb::BLACK,
        k_d,
        k_s: Rgb::BLACK,
        m: 1,
    };
    let fixed = shade::lambert(n, &white, Rgb::BLACK, [light.at(p)]);
    let light64 = light.cast(exact).at(p.map(exact));
    let shading::Rgb { r, g, b } = light64.intensity();
    if r.max(g).max(b) > 4.0 {
        return None;
    }
    let (n64, white64) = (n.cast(exact), white.cast(exact));
    let double = shade::lambert(n64, &white64, shading::Rgb::BLACK, [light64]);
    Some(apart(fixed.diffuse, double.diffuse))
}

/// The levels between two colors, where they are farthest apart.
fn apart(fixed: Rgb, double: shading::Rgb<f64>) -> f64 {
    let (fixed, double): ([Fixed; 3], [f64; 3]) = (fixed.into(), double.into());
    let pairs = fixed.into_iter().zip(double);
    let levels = pairs.map(|(a, b)| (levels(exact(a)) - levels(b)).abs());
    levels.fold(0.0, f64::max)
}

/// The largest difference that climbs find.
fn worst(difference: impl Fn(&[f64; SHARES]) -> Option<f64>) -> f64 {
    let is_long = std::env::var("SHADING_SEARCH").is_ok_and(|extent| extent == "all");
    let (climbs, changes) = if is_long { (400, 10_000) } else { (6, 1000) };
    let mut random = Random(11);
    let mut worst = 0.0_f64;
    for _ in 0..climbs {
        let starts = (0..60).map(|_| [(); SHARES].map(|()| random.fraction()));
        let starts = starts.filter_map(|shares| Some((difference(&shares)?, shares)));
        let best = starts.max_by(|a, b| a.0.total_cmp(&b.0));
        let (mut most, mut best) = best.expect("a scene");
        for _ in 0..changes {
            let mut shares = best;
            for _ in 0..=random.bits() % 3 {
                let place = &mut shares[usize::try_from(random.bits() % SHARES as u64).unwrap()];
                let change = (random.fraction() - 0.5) * 0.5_f64.powf(40.0 * random.fraction());
                *place = (*place + change).rem_euclid(1.0);
            }
            if let Some(more) = difference(&shares).filter(|more| *more >= most) {
                (most, best) = (more, shares);
            }
        }
        worst = worst.max(most);
    }
    println!("{worst:.3} levels");
    worst
}

#[test]
fn colors_are_within_a_level() {
    for model in [Model::Lambert, Model::Phong, Model::BlinnPhong] {
        assert!(
            worst(|shares| difference(model, shares)) <= 1.0,
            "{model:?}"
        );
    }
}

#[test]
fn faint_ends_of_bright_lights_are_within_a_level() {
    assert!(worst(difference_at_an_end) <= 1.0);
}

/// Each result is rounded twice, to half a step: as a sum, and as a product with a reflectance of at most 1.
#[test]
fn sums_do_not_depend_on_the_order_of_lights() {
    let mut random = Random(14);
    for _ in 0..2000 {
        let shares = [(); SHARES].map(|()| random.fraction());
        let mut shares = Shares(shares.iter());
        let p = shares.vector(100.0);
        let (n, v) = (shares.direction(), shares.direction());
        let [k_d, k_s] = [(); 2].map(|()| shares.color());
        let (k_a, m) = (Rgb::BLACK, shares.whole(1, 128));
        let material = Material { k_a, k_d, k_s, m };
        let lights = (0..3).filter_map(|_| shares.light(p));
        let lights: Vec<_> = lights.map(|light| light.at(p)).collect();
        let shaded = |lights: &[IncidentLight]| {
            shade::blinn_phong(n, v, &material, Rgb::BLACK, lights.iter().copied())
        };
        let sum = shaded(&lights);
        let backward: Vec<_> = lights.iter().rev().copied().collect();
        assert_eq!(shaded(&backward), sum);
        let one_by_one: Shaded = lights.chunks(1).map(shaded).sum();
        let apart = (one_by_one.diffuse - sum.diffuse).map(|x| x.to_bits().abs());
        let most = i32::try_from(lights.len()).unwrap() + 1;
        assert!(apart.r.max(apart.g).max(apart.b) <= most, "{apart:?}");
    }
}

/// Grazing light, where the rounded direction may be behind the surface although the light is not.
#[test]
fn grazing_light_is_not_negative() {
    let mut random = Random(12);
    let white = Material {
        k_a: Rgb::BLACK,
        k_d: Rgb::WHITE,
        k_s: Rgb::WHITE,
        m: 1,
    };
    for _ in 0..100_000 {
        let n =
            Vec3::from([(); 3].map(|()| Fixed::new(random.fraction() - 0.5))).unit_or(UnitVec3::Z);
        let aside = Vec3::from([(); 3].map(|()| Fixed::new(random.fraction() - 0.5)));
        let along = aside.cross(n) * Fixed::new(100.0 * random.fraction())
            + *n * Fixed::new(0.001 * random.fraction());
        let lamp = PointLight {
            position: along,
            intensity: Rgb::gray(Fixed::from(4)),
            attenuation: Attenuation::NONE,
        };
        let shaded = shade::blinn_phong(n, n, &white, Rgb::BLACK, [lamp.at(Vec3::ZERO)]);
        assert!(
            shaded.diffuse.r >= Fixed::from(0),
            "{n:?} {along:?} {shaded:?}"
        );
    }
}
