//! The same formulas written by hand with `wide` and its own power.

use crate::lanes::{COUNT, Lanes};
use crate::scene::{AMBIENT, ATTENUATION, K_A, K_D, K_S, REAL_M, Scene};

type V = [Lanes; 3];

fn dot(a: V, b: V) -> Lanes {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn splat(v: [f32; 3]) -> V {
    v.map(Lanes::splat)
}

pub struct Wide {
    points: Vec<V>,
    normals: Vec<V>,
    eyes: Vec<V>,
    /// position and intensity
    lamps: Vec<(V, V)>,
    attenuation: V,
    k_a: V,
    k_d: V,
    k_s: V,
    ambient: V,
    m: Lanes,
    pub image: Vec<V>,
}

impl Wide {
    pub fn new(scene: &Scene) -> Self {
        let gather = |all: &[[f32; 3]]| -> Vec<V> {
            all.chunks_exact(COUNT)
                .map(|some| [0, 1, 2].map(|k| std::array::from_fn(|i| some[i][k]).into()))
                .collect()
        };
        Self {
            points: gather(&scene.points),
            normals: gather(&scene.normals),
            eyes: gather(&scene.eyes),
            lamps: scene
                .lamps
                .iter()
                .map(|lamp| (splat(lamp.position), splat(lamp.intensity)))
                .collect(),
            attenuation: splat(ATTENUATION),
            k_a: splat(K_A),
            k_d: splat(K_D),
            k_s: splat(K_S),
            ambient: splat(AMBIENT),
            m: Lanes::splat(REAL_M),
            image: vec![[Lanes::ZERO; 3]; scene.points.len() / COUNT],
        }
    }

    #[inline(never)]
    pub fn shade(&mut self) {
        for i in 0..self.points.len() {
            self.image[i] = self.some(self.points[i], self.normals[i], self.eyes[i]);
        }
    }

    #[inline]
    fn some(&self, p: V, n: V, v: V) -> V {
        let [a, b, c] = self.attenuation;
        let (zero, one) = (Lanes::ZERO, Lanes::ONE);
        let mut sum: V = std::array::from_fn(|k| self.k_a[k] * self.ambient[k]);
        for (position, intensity) in &self.lamps {
            let to_lamp: V = std::array::from_fn(|k| position[k] - p[k]);
            let q = dot(to_lamp, to_lamp).sqrt();
            let over_q = one / q;
            let l = to_lamp.map(|x| x * over_q);
            let n_dot_l = dot(n, l).max(zero);
            let lit = n_dot_l.simd_gt(zero);
            if lit.any() {
                let h: V = std::array::from_fn(|k| l[k] + v[k]);
                let n_dot_h = (dot(n, h) / dot(h, h).sqrt()).max(zero);
                let highlight = n_dot_h.powf_simd(self.m) & lit;
                let arriving = one / (a + q * (b + c * q));
                for k in 0..3 {
                    let returned = self.k_d[k] * n_dot_l + self.k_s[k] * highlight;
                    sum[k] += intensity[k] * arriving * returned;
                }
            }
        }
        sum
    }
}
