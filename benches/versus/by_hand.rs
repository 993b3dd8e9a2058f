//! The same formulas as one would write them with `glam` and the powers of the standard library.

use glam::Vec3;

use crate::scene::{AMBIENT, ATTENUATION, K_A, K_D, K_S, Scene};

struct Lamp {
    position: Vec3,
    intensity: Vec3,
}

pub struct Glam<M> {
    points: Vec<Vec3>,
    normals: Vec<Vec3>,
    eyes: Vec<Vec3>,
    lamps: Vec<Lamp>,
    attenuation: [f32; 3],
    k_a: Vec3,
    k_d: Vec3,
    k_s: Vec3,
    ambient: Vec3,
    m: M,
    pub image: Vec<Vec3>,
}

impl<M: Copy> Glam<M> {
    pub fn new(scene: &Scene, m: M) -> Self {
        let gather = |all: &[[f32; 3]]| all.iter().copied().map(Vec3::from).collect();
        Self {
            points: gather(&scene.points),
            normals: gather(&scene.normals),
            eyes: gather(&scene.eyes),
            lamps: scene
                .lamps
                .iter()
                .map(|lamp| Lamp {
                    position: lamp.position.into(),
                    intensity: lamp.intensity.into(),
                })
                .collect(),
            attenuation: ATTENUATION,
            k_a: K_A.into(),
            k_d: K_D.into(),
            k_s: K_S.into(),
            ambient: AMBIENT.into(),
            m,
            image: vec![Vec3::ZERO; scene.points.len()],
        }
    }

    #[inline(never)]
    pub fn shade(&mut self, power: impl Fn(f32, M) -> f32) {
        for i in 0..self.points.len() {
            self.image[i] = self.point(self.points[i], self.normals[i], self.eyes[i], &power);
        }
    }

    #[inline]
    fn point(&self, p: Vec3, n: Vec3, v: Vec3, power: impl Fn(f32, M) -> f32) -> Vec3 {
        let [a, b, c] = self.attenuation;
        let mut sum = self.k_a * self.ambient;
        for lamp in &self.lamps {
            let to_lamp = lamp.position - p;
            let q = to_lamp.length();
            let l = to_lamp / q;
            let n_dot_l = n.dot(l);
            if n_dot_l > 0.0 {
                let h = (l + v).normalize();
                let highlight = power(n.dot(h).max(0.0), self.m);
                let attenuation = 1.0 / (a + q * (b + c * q));
                sum += lamp.intensity * attenuation * (self.k_d * n_dot_l + self.k_s * highlight);
            }
        }
        sum
    }
}
