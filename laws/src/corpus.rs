//! The edges that are known: fixed scenes, which each law tries before any random one.

use std::array::from_fn;

use crate::generator::Case;
use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene, Triple, scale};

/// Changes when scenes are added, so that a report says which edges it has tried.
pub const VERSION: u32 = 4;

/// The most lights that a scene of the corpus has.
pub const MOST_LIGHTS: usize = 1024;

const BLACK: Triple = [0.0; 3];
const UP: Triple = [0.0, 0.0, 1.0];

/// The edges that a renderer has.
pub fn edges(profile: &Profile) -> Vec<Case> {
    let mut corpus = Corpus {
        profile,
        cases: Vec::new(),
    };
    corpus.opposite();
    corpus.faces();
    corpus.grazing();
    corpus.lamps();
    corpus.spots();
    corpus.shininess();
    corpus.dark_highlights();
    corpus.sharpest_highlights();
    corpus.colors();
    corpus.lengths();
    corpus.many_lights();
    corpus.cases
}

struct Corpus<'a> {
    profile: &'a Profile,
    cases: Vec<Case>,
}

impl Corpus<'_> {
    /// A surface that shows all terms, seen from v.
    fn scene(&self, n: Triple, v: Triple, lights: Vec<Light>) -> Scene {
        let k_s = [0.5, 0.25, 1.0];
        Scene {
            model: Model::BlinnPhong,
            p: BLACK,
            n: self.profile.direction(n),
            v: self.profile.direction(v),
            k_a: [0.25, 0.5, 0.125],
            k_d: [0.5, 0.25, 0.75],
            k_s: if self.profile.gray_highlight {
                [0.5; 3]
            } else {
                k_s
            },
            m: 8.0_f64.min(self.profile.most_shiny),
            i_a: if self.profile.ambient {
                [0.25, 0.125, 0.5]
            } else {
                BLACK
            },
            lights,
        }
    }

    /// Adds a scene in each model.
    fn add(&mut self, scene: &Scene) {
        for &model in &self.profile.models {
            self.add_as(model, scene);
        }
    }

    fn add_as(&mut self, model: Model, scene: &Scene) {
        let k = self.cases.len();
        let is_lost = |light| scene.has_lamp_at_the_point(light, self.profile.roundoff);
        if scene.lights.len() > self.profile.most_lights || scene.lights.iter().any(is_lost) {
            return;
        }
        let ways: [Triple; 6] = [
            [1.0, 0.0, 1.0],
            [0.0, 1.0, 1.5],
            [1.0, 0.5, 0.25],
            [0.0, 0.0, 1.0],
            [-1.0, 0.75, 1.0],
            [0.5, -1.0, 0.5],
        ];
        #[allow(clippy::cast_precision_loss)] // 1 to 8
        let factor = |i: usize| ((k * 3 + i * 5) % 8 + 1) as f64;
        self.cases.push(Case {
            scene: Scene {
                model,
                ..scene.clone()
            },
            ways: from_fn(|i| ways[(k + 2 * i) % 6]),
            factors: from_fn(factor),
        });
    }

    /// A light from there, of the kind.
    fn light(&self, kind: Kind, way: Triple, intensity: Triple) -> Light {
        let attenuation = if self.profile.unattenuated {
            [1.0, 0.0, 0.0]
        } else {
            [0.5, 0.25, 0.25]
        };
        match kind {
            Kind::Directional => Light::Directional {
                intensity,
                l: self.profile.unit(way),
            },
            Kind::Point => Light::Point {
                intensity,
                position: way,
                attenuation,
            },
            Kind::Spot => Light::Spot {
                intensity,
                position: way,
                attenuation,
                axis: self.profile.unit(scale(way, -1.0)),
                half_angle: self.profile.rounded(0.75),
            },
        }
    }

    /// Each kind of light that the renderer has, from there.
    fn kinds(&self, way: Triple, intensity: Triple) -> Vec<Light> {
        let kinds = Kind::ALL.into_iter().filter(|kind| self.profile.has(*kind));
        kinds.map(|kind| self.light(kind, way, intensity)).collect()
    }

    /// L = −V, with N·L above and at 0: H has no direction.
    fn opposite(&mut self) {
        for (n, l) in [
            (UP, UP),
            ([1.0, 0.0, 1.0], UP),
            ([0.0, 1.0, 1.0], [0.0, 1.0, 0.0]),
            ([1.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
            (UP, [1.0, 0.0, 0.0]),
            ([1.0, 2.0, 2.0], [1.0, 2.0, 2.0]),
            ([0.0, -1.0, 0.0], [3.0, -4.0, 0.0]),
        ] {
            for light in self.kinds(l, [0.5; 3]) {
                let v = l.map(|c| -c);
                self.add(&self.scene(n, v, vec![light]));
            }
        }
    }

    /// N·L and N·V above, at and below 0; L and V along N and mirrored.
    fn faces(&mut self) {
        let ways = [
            UP,
            [0.0, 0.0, -1.0],
            [1.0, 0.0, 0.0],
            [1.0, 0.0, 1.0],
            [-1.0, 0.0, 1.0],
            [1.0, 1.0, -1.0],
            [64.0, 0.0, 1.0],
            [0.0, 64.0, -1.0],
        ];
        for (i, l) in ways.into_iter().enumerate() {
            for (j, v) in ways.into_iter().enumerate() {
                let kinds = self.kinds(l, [0.5, 0.75, 0.25]);
                let light = kinds[(i + j) % kinds.len()];
                self.add(&self.scene(UP, v, vec![light]));
            }
        }
        // each kind of light behind the surface, with R and H near what they are compared with
        for light in self.kinds([1.0, 0.0, -0.125], [0.75, 1.0, 0.5]) {
            self.add(&self.scene(UP, [-1.0, 0.0, 0.375], vec![light]));
        }
        self.add(&self.scene(UP, UP, vec![]));
    }

    /// N·L just above 0, seen in the mirror direction, where the highlight is bright.
    fn grazing(&mut self) {
        for (i, height) in [0.07, 0.03, 0.008, 0.0008, 0.00008, 0.000_008]
            .into_iter()
            .enumerate()
        {
            let kinds = self.kinds([1.0, 0.0, height], [0.75, 1.0, 0.5]);
            let light = kinds[i % kinds.len()];
            let v = [-1.0, 0.0, height].map(|c| self.profile.rounded(c));
            self.add(&self.scene(UP, v, vec![light]));
        }
    }

    /// Lamps near and far, attenuated by one coefficient alone, at a point away from the origin.
    fn lamps(&mut self) {
        let unattenuated = [[1.0, 0.0, 0.0]];
        let distances = [
            0.00002, 0.0001, 0.001, 0.005, 0.05, 0.5, 1.0, 2.0, 8.0, 40.0, 300.0, 1500.0, 12000.0,
            30000.0,
        ];
        for (k, q) in distances.into_iter().enumerate() {
            let square: f64 = q * q;
            let some = [
                [1.0, 0.0, 0.0],
                [0.0, 1.0 / q, 0.0],
                [0.0, 0.0, 1.0 / square],
                [0.5, 0.5 / q, 0.5 / square],
                [0.0, 0.0, 0.1 / square],
                [0.005, 0.0, 0.0],
                [0.0, 0.0, [3000.0, 300.0, 30.0][k % 3] / square],
            ];
            let all = if self.profile.unattenuated {
                &unattenuated[..]
            } else {
                &some
            };
            for (i, coefficients) in all.iter().enumerate() {
                let attenuation = coefficients.map(|c| self.profile.rounded(c));
                // a lamp that the attenuation brightens is dim
                let left = 1.0 / (attenuation[0] + attenuation[1] * q + attenuation[2] * square);
                let dim = |c: f64| self.profile.rounded(c / left.max(1.0));
                let intensity = [0.5, 1.0, 0.75].map(dim);
                for p in [BLACK, [1.0, -2.0, 0.5]] {
                    if p != BLACK && q < 0.001 {
                        continue; // the difference would have no digits
                    }
                    let way = [0.0, 0.6, 0.8].map(|c| c * q);
                    let position = from_fn(|i| self.profile.rounded(p[i] + way[i]));
                    let lamps =
                        [Kind::Point, Kind::Spot].map(|kind| (kind, self.profile.has(kind)));
                    let Some((kind, _)) = lamps
                        .into_iter()
                        .cycle()
                        .skip(i % 2)
                        .take(2)
                        .find(|(_, has)| *has)
                    else {
                        return;
                    };
                    let light = self.light(kind, UP, intensity);
                    let mut scene = self.scene(UP, [0.0, -0.5, 1.0], vec![light]);
                    scene.p = p;
                    if left < 0.1 {
                        scene.i_a = BLACK; // among light, little light is not seen
                    }
                    move_lamp(&mut scene.lights[0], position, attenuation);
                    let model = self.profile.models[i % self.profile.models.len()];
                    self.add_as(model, &scene);
                }
            }
        }
    }

    /// Points within and outside a cone, nearer to its edge than a degree, and angles of whole degrees and others.
    fn spots(&mut self) {
        if !self.profile.has(Kind::Spot) {
            return;
        }
        for degrees in [5.0, 10.0, 22.5, 30.0, 37.9, 45.0, 59.3, 75.6, 89.5, 90.0] {
            for beyond in [-40.0, -2.0, -0.3, 0.3, 2.0] {
                let off: f64 = degrees + beyond;
                if off < 0.0 {
                    continue;
                }
                let angle = off.to_radians();
                let axis = [-angle.sin(), 0.0, -angle.cos()];
                let mut light = self.light(Kind::Spot, UP, [1.0, 0.75, 0.5]);
                if let Light::Spot {
                    axis: of_light,
                    half_angle,
                    ..
                } = &mut light
                {
                    *of_light = self.profile.unit(axis);
                    let right = std::f64::consts::FRAC_PI_2;
                    *half_angle = self.profile.rounded(f64::to_radians(degrees)).min(right);
                }
                let model = self.profile.models[self.cases.len() % self.profile.models.len()];
                self.add_as(model, &self.scene(UP, UP, vec![light]));
            }
        }
    }

    /// Whole and real exponents up to the largest, each at its peak and on its slope.
    fn shininess(&mut self) {
        let most = self.profile.most_m();
        for m in [
            1.0,
            1.5,
            2.75,
            9.6,
            31.3,
            32.0,
            50.5,
            64.0,
            99.5,
            110.25,
            127.5,
            128.0,
            129.0,
            190.4,
            256.0,
            301.7,
            1000.0,
            4000.0,
            most / 3.0,
            most - 0.5,
            most,
        ] {
            if !(1.0..=most).contains(&m) {
                continue;
            }
            let m = self.profile.shininess(m);
            for off in [0.0, 0.5, 1.5] {
                let off = off / f64::sqrt(m);
                let kinds = self.kinds(UP, [1.0, 0.5, 0.75]);
                let light = kinds[self.cases.len() % kinds.len()];
                let v = [off, 0.0, 1.0].map(|c| self.profile.rounded(c));
                let mut scene = self.scene(UP, v, vec![light]);
                scene.m = m;
                self.add(&scene);
            }
        }
    }

    /// R or H below the surface, and an m with which any floor of the cosine shows.
    fn dark_highlights(&mut self) {
        for (l, v) in [
            ([0.8, 0.0, 0.6], [0.8, 0.0, 0.6]),
            ([0.6, 0.0, 0.8], [0.0, 0.25, -1.5]),
        ] {
            for light in self.kinds(l, [1.0, 0.5, 0.75]) {
                let mut scene = self.scene(UP, v, vec![light]);
                scene.m = 1.0;
                self.add(&scene);
            }
        }
    }

    /// The largest exponent, on the slope of the highlight under an N of long components, and at its peak: in few digits,
    /// the light of a lamp may not be known well enough for so large a power.
    fn sharpest_highlights(&mut self) {
        let most = self.profile.most_m();
        for (n, across) in [
            ([0.301, -0.117, 0.946], [0.946, 0.0, -0.301]),
            ([-0.553, 0.719, 0.421], [0.719, 0.553, 0.0]),
        ] {
            for off in [1.0, 2.0, -1.5] {
                let way = from_fn(|i| n[i] + off / most.sqrt() * across[i]);
                let way = way.map(|c| self.profile.rounded(c));
                let n = self.profile.direction(n.map(|c| self.profile.rounded(c)));
                let kinds = self.kinds(way, [1.0, 0.5, 0.75]);
                let light = kinds[self.cases.len() % kinds.len()];
                let mut scene = self.scene(n, n, vec![light]);
                scene.m = most;
                self.add(&scene);
            }
        }
        for light in self.kinds(UP, [1.0, 0.5, 0.75]) {
            let mut scene = self.scene(UP, UP, vec![light]);
            scene.m = most;
            self.add(&scene);
        }
    }

    /// Colors with many digits, dark ones, and sums above 1 of which no light alone is.
    fn colors(&mut self) {
        let long = |c: Triple| c.map(|c| self.profile.rounded(c));
        let bright = [
            self.scene(UP, UP, self.kinds([0.0, 0.5, 1.0], [0.7; 3])),
            self.scene(UP, UP, self.kinds([0.0, 0.5, 1.0], [2.0; 3])),
        ];
        let mut scenes = Vec::new();
        for (k, i) in [
            ([0.1, 0.3, 0.7], [0.9, 1.0 / 3.0, 0.55]),
            ([0.01, 0.004, 0.999], [0.05, 0.4, 0.123]),
            ([0.2, 0.0031, 0.06], [0.8, 0.9, 0.0011]),
        ] {
            for light in self.kinds([0.3, 0.2, 1.0], long(i)) {
                let mut scene = self.scene(UP, [-0.2, 0.1, 1.0], vec![light]);
                let k = long(k);
                scene.k_a = [k[1], k[2], k[0]];
                scene.k_d = k;
                if !self.profile.gray_highlight {
                    scene.k_s = [k[2], k[0], k[1]];
                }
                if self.profile.ambient {
                    scene.i_a = long([0.31, 0.77, 0.15]);
                }
                scenes.push(scene);
            }
        }
        for scene in scenes.iter().chain(&bright) {
            if scene.lights.len() <= self.profile.most_lights {
                self.add(scene);
            }
        }
    }

    /// N and V of other lengths than 1.
    fn lengths(&mut self) {
        if self.profile.unit_vectors {
            return;
        }
        for (n, v) in [
            (0.25, 1.0),
            (3.0, 1.0),
            (1.0, 0.125),
            (1.0, 20.0),
            (0.001, 100.0),
        ] {
            for light in self.kinds([0.5, 0.25, 1.0], [0.5, 0.25, 0.75]) {
                let n = [0.6, 0.0, 0.8].map(|c| self.profile.rounded(c * n));
                let v = [0.0, 0.28, 0.96].map(|c| self.profile.rounded(c * v));
                self.add(&self.scene(n, v, vec![light]));
            }
        }
    }

    /// As many lights as it has: all alike, and each in turn the brightest.
    fn many_lights(&mut self) {
        let most = self.profile.most_lights.min(MOST_LIGHTS);
        let mut counts = vec![most, most.saturating_sub(1), 5, 9, 17];
        counts.retain(|count| (2..=most).contains(count));
        counts.sort_unstable();
        counts.dedup();
        #[allow(clippy::cast_precision_loss)] // the count of lights
        for count in counts {
            for brightest in [0, count / 2, count - 1] {
                let lights = (0..count).map(|i| {
                    let way = [
                        0.5 - (i % 3) as f64 / 2.0,
                        (i % 5) as f64 / 4.0 - 0.5,
                        1.0 + (i % 2) as f64 / 2.0,
                    ];
                    let share = if i == brightest {
                        0.5
                    } else {
                        0.25 / count as f64
                    };
                    let share = self.profile.rounded(share);
                    let kinds = self.kinds(way, [share, share / 2.0, share]);
                    kinds[(i + brightest) % kinds.len()]
                });
                let lights = lights.collect();
                let model = self.profile.models[brightest % self.profile.models.len()];
                self.add_as(model, &self.scene(UP, [0.25, 0.0, 1.0], lights));
            }
        }
    }
}

fn move_lamp(light: &mut Light, to: Triple, coefficients: Triple) {
    if let Some((position, attenuation)) = light.lamp_mut() {
        (*position, *attenuation) = (to, coefficients);
    }
    if let Light::Spot { axis, .. } = light {
        *axis = [0.0, 0.0, -1.0];
    }
}
