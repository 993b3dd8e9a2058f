//! The edges that are known: fixed scenes, which each law tries before any random one.

use std::collections::BTreeSet;

use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene, Triple, add, scale};

const BLACK: Triple = [0.0; 3];
const UP: Triple = [0.0, 0.0, 1.0];

/// The edges that a renderer has.
pub fn edges(profile: &Profile) -> Vec<Scene> {
    let mut corpus = Corpus {
        profile,
        scenes: Vec::new(),
        turn: 0,
    };
    corpus.directions();
    corpus.terms();
    corpus.lamps();
    corpus.spots();
    corpus.shininess();
    corpus.many_lights();
    corpus.scenes
}

struct Corpus<'a> {
    profile: &'a Profile,
    scenes: Vec<Scene>,
    /// The kinds of light that were taken in turn.
    turn: usize,
}

impl Corpus<'_> {
    /// A surface that shows all terms, seen from v.
    fn scene(n: Triple, v: Triple, m: f64, lights: Vec<Light>) -> Scene {
        Scene {
            model: Model::BlinnPhong,
            p: BLACK,
            n,
            v,
            k_a: [0.25, 0.5, 0.125],
            k_d: [0.5, 0.25, 0.75],
            k_s: [0.5, 0.25, 1.0],
            m,
            i_a: [0.25, 0.125, 0.5],
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
        let scene = scene.clone();
        let fitted = self.profile.fitted(Scene { model, ..scene });
        self.scenes.extend(fitted);
    }

    /// A light from there, of the kind.
    fn light(&self, kind: Kind, way: Triple, intensity: Triple) -> Light {
        let point = Light::point(intensity, way, [0.5, 0.25, 0.25]);
        match kind {
            Kind::Directional => Light::Directional { intensity, l: way },
            Kind::Point => point,
            Kind::Spot => point.with_cone(scale(way, -1.0), self.profile.rounded(0.75)),
        }
    }

    /// Each kind of light that the renderer has, from there.
    fn kinds(&self, way: Triple, intensity: Triple) -> Vec<Light> {
        let kinds = Kind::ALL.into_iter().filter(|kind| self.profile.has(*kind));
        kinds.map(|kind| self.light(kind, way, intensity)).collect()
    }

    /// A scene with each kind of light from there.
    fn each_kind(&mut self, n: Triple, v: Triple, l: Triple, m: f64) {
        for light in self.kinds(l, [0.5, 0.75, 0.25]) {
            self.add(&Self::scene(n, v, m, vec![light]));
        }
    }

    /// A scene with the kinds of light in turn.
    fn in_turn(&mut self, n: Triple, v: Triple, l: Triple, m: f64) {
        let kinds = self.kinds(l, [1.0, 0.75, 0.5]);
        let light = kinds[(self.turn + self.turn / kinds.len()) % kinds.len()];
        self.turn += 1;
        self.add(&Self::scene(n, v, m, vec![light]));
    }

    fn directions(&mut self) {
        // L = −V, with N·L above and at 0: H has no direction
        for (n, l) in [
            (UP, UP),
            ([1.0, 0.0, 1.0], UP),
            ([0.0, 1.0, 1.0], [0.0, 1.0, 0.0]),
            ([1.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
            (UP, [1.0, 0.0, 0.0]),
            ([1.0, 2.0, 2.0], [1.0, 2.0, 2.0]),
            ([0.0, -1.0, 0.0], [3.0, -4.0, 0.0]),
        ] {
            self.each_kind(n, scale(l, -1.0), l, 8.0);
        }
        // N·L and N·V above, at and below 0; L and V along N and mirrored
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
        for l in ways {
            for v in ways {
                self.in_turn(UP, v, l, 8.0);
            }
        }
        self.add(&Self::scene(UP, UP, 8.0, vec![]));
        // each kind of light behind the surface, with R and H near what they are compared with
        self.each_kind(UP, [-1.0, 0.0, 0.375], [1.0, 0.0, -0.125], 8.0);
        // R or H below the surface, and an m with which any floor of the cosine shows
        self.each_kind(UP, [0.8, 0.0, 0.6], [0.8, 0.0, 0.6], 1.0);
        self.each_kind(UP, [0.0, 0.25, -1.5], [0.6, 0.0, 0.8], 1.0);
        // the same, but black, where few levels show a floor
        for light in self.kinds([0.8, 0.0, 0.6], [1.0; 3]) {
            let mut scene = Self::scene(UP, [0.8, 0.0, 0.6], 1.0, vec![light]);
            (scene.k_d, scene.i_a) = (BLACK, BLACK);
            self.add(&scene);
        }
        // N·L just above 0, seen in the mirror direction, where the highlight is bright
        for height in [0.07, 0.03, 0.008, 0.0008, 0.00008, 0.000_008] {
            let v = self.long([-1.0, 0.0, height]);
            self.in_turn(UP, v, [1.0, 0.0, height], 8.0);
        }
        // N and V of other lengths than 1
        for (n, v) in [
            (0.25, 1.0),
            (3.0, 1.0),
            (1.0, 0.125),
            (1.0, 20.0),
            (0.001, 100.0),
        ] {
            let n = self.long(scale([0.6, 0.0, 0.8], n));
            let v = self.long(scale([0.0, 0.28, 0.96], v));
            self.each_kind(n, v, [0.5, 0.25, 1.0], 8.0);
        }
    }

    /// Surfaces that lack a term, in the mirror direction; and the brightest lights, on dark surfaces.
    fn terms(&mut self) {
        let (l, v) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
        for light in self.kinds(l, [0.5, 0.75, 0.25]) {
            let scene = Self::scene(UP, v, 8.0, vec![light]);
            for lack in 0..3 {
                let mut scene = scene.clone();
                *[&mut scene.k_a, &mut scene.k_d, &mut scene.k_s][lack] = BLACK;
                self.add(&scene);
            }
        }
        for bright in [[16.0, 12.0, 8.0], [5.0, 16.0, 11.0]] {
            for light in self.kinds(l, bright) {
                let mut scene = Self::scene(UP, v, 8.0, vec![light]);
                let darker = |k: Triple| scale(k, 1.0 / 32.0);
                (scene.k_a, scene.k_d) = (darker(scene.k_a), darker(scene.k_d));
                (scene.k_s, scene.i_a) = (darker(scene.k_s), bright);
                self.add(&scene);
            }
        }
    }

    /// As the renderer holds it.
    fn long(&self, v: Triple) -> Triple {
        v.map(|c| self.profile.rounded(c))
    }

    /// The next model that the renderer has.
    fn model(&self, i: usize) -> Model {
        self.profile.models[i % self.profile.models.len()]
    }

    /// Lamps near and far, attenuated by one coefficient alone, at a point away from the origin.
    fn lamps(&mut self) {
        let mut kinds = vec![Kind::Point, Kind::Spot];
        kinds.retain(|kind| self.profile.has(*kind));
        let distances = [
            0.00002, 0.0001, 0.001, 0.005, 0.05, 0.5, 1.0, 2.0, 8.0, 40.0, 300.0, 1500.0, 12000.0,
            30000.0,
        ];
        for (k, q) in distances.into_iter().enumerate() {
            let square: f64 = q * q;
            let mut all = vec![
                [1.0, 0.0, 0.0],
                [0.0, 1.0 / q, 0.0],
                [0.0, 0.0, 1.0 / square],
                [0.5, 0.5 / q, 0.5 / square],
                [0.0, 0.0, 0.1 / square],
                [0.005, 0.0, 0.0],
                [0.0, 0.0, [3000.0, 300.0, 30.0][k % 3] / square],
            ];
            if self.profile.unattenuated {
                all.truncate(1);
            }
            for (i, attenuation) in all.into_iter().enumerate() {
                let attenuation = self.long(attenuation);
                // a lamp that the attenuation brightens is dim
                let left = 1.0 / (attenuation[0] + attenuation[1] * q + attenuation[2] * square);
                let intensity = self.long(scale([0.5, 1.0, 0.75], 1.0 / left.max(1.0)));
                for p in [BLACK, [1.0, -2.0, 0.5]] {
                    if kinds.is_empty() || p != BLACK && q < 0.001 {
                        continue; // the difference would have no digits
                    }
                    let position = self.long(add(p, scale([0.0, 0.6, 0.8], q)));
                    let mut light = Light::point(intensity, position, attenuation);
                    if kinds[(i + k) % kinds.len()] == Kind::Spot {
                        light = light.with_cone([0.0, 0.0, -1.0], self.profile.rounded(0.75));
                    }
                    let mut scene = Self::scene(UP, [0.0, -0.5, 1.0], 8.0, vec![light]);
                    scene.p = p;
                    if left < 0.1 {
                        scene.i_a = BLACK; // among light, little light is not seen
                    }
                    self.add_as(self.model(i + k / 2), &scene);
                }
            }
        }
    }

    /// Points within and outside a cone, nearer to its edge than a degree, and angles of whole degrees and others.
    fn spots(&mut self) {
        for degrees in [5.0, 10.0, 22.5, 30.0, 37.9, 45.0, 59.3, 75.6, 89.5, 90.0] {
            for beyond in [-40.0, -2.0, -0.3, 0.3, 2.0] {
                let off: f64 = degrees + beyond;
                if off >= 0.0 {
                    let (sine, cosine) = libm::sincos(off.to_radians());
                    let axis = self.profile.unit([-sine, 0.0, -cosine]);
                    let angle = self.profile.rounded(f64::to_radians(degrees));
                    let light = self.light(Kind::Spot, UP, [1.0, 0.75, 0.5]);
                    let light = light.with_cone(axis, angle.min(std::f64::consts::FRAC_PI_2));
                    let scene = Self::scene(UP, UP, 8.0, vec![light]);
                    self.add_as(self.model(self.scenes.len()), &scene);
                }
            }
        }
    }

    /// Whole and real exponents up to the largest, each at its peak and on its slope.
    fn shininess(&mut self) {
        let most = self.profile.shininess(self.profile.most_shiny);
        let known = [
            1.0, 1.5, 2.75, 9.6, 31.3, 32.0, 50.5, 64.0, 99.5, 110.25, 127.5, 128.0, 129.0, 190.4,
            256.0, 301.7, 1000.0, 4000.0,
        ];
        for m in known.into_iter().chain([most / 3.0, most - 0.5, most]) {
            if !(1.0..=most).contains(&m) {
                continue;
            }
            let m = self.profile.shininess(m);
            for off in [0.0, 0.5, 1.5] {
                let v = self.long([off / m.sqrt(), 0.0, 1.0]);
                self.in_turn(UP, v, UP, m);
            }
        }
        // the largest, under an N of long components, and at its peak: in few digits, the light of
        // a lamp may not be known well enough for so large a power
        for (n, across) in [
            ([0.301, -0.117, 0.946], [0.946, 0.0, -0.301]),
            ([-0.553, 0.719, 0.421], [0.719, 0.553, 0.0]),
        ] {
            for off in [1.0, 2.0, -1.5] {
                let way = self.long(add(n, scale(across, off / most.sqrt())));
                let n = self.profile.direction(self.long(n));
                self.in_turn(n, n, way, most);
            }
        }
        self.each_kind(UP, UP, UP, most);
    }

    /// Two lights that are equal or differ in color alone; and as many as it has, each in turn the brightest.
    #[allow(clippy::cast_precision_loss)] // the count of lights
    fn many_lights(&mut self) {
        let [lights, dim] = [0.5, 0.25].map(|c| self.kinds(UP, [c; 3]));
        for (light, dim) in lights.into_iter().zip(dim) {
            for other in [light, dim] {
                self.add(&Self::scene(UP, UP, 8.0, vec![light, other]));
            }
        }
        let most = self.profile.most_lights;
        let counts = BTreeSet::from([most, most.saturating_sub(1), 5, 9, 17]);
        for count in counts.into_iter().filter(|it| (2..=most).contains(it)) {
            for brightest in [0, count / 2, count - 1] {
                let lights = (0..count).map(|i| {
                    let [x, y, z] = [i % 3, i % 5, i % 2].map(|step| step as f64);
                    let dim = 0.25 / count as f64;
                    let share = if i == brightest { 0.5 } else { dim };
                    let color = self.long(scale([1.0, 0.5, 1.0], share));
                    let way = [0.5 - x / 2.0, y / 4.0 - 0.5, 1.0 + z / 2.0];
                    let kinds = self.kinds(way, color);
                    kinds[(i + brightest) % kinds.len()]
                });
                let scene = Self::scene(UP, [0.25, 0.0, 1.0], 8.0, lights.collect());
                self.add_as(self.model(brightest), &scene);
            }
        }
    }
}
