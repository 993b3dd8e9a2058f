//! Random inputs, with special values among them.

use fastrand::Rng;
use kernel::functions::Input;
use shading::f32::{Rgb, UnitVec3, Vec3};
use shading::reflection;

pub fn random(seed: u64, count: usize) -> Vec<Input> {
    let mut random = Random(Rng::with_seed(seed));
    (0..count).map(|_| random.input()).collect()
}

struct Random(Rng);

impl Random {
    /// True once in this many times, on average.
    fn once_in(&mut self, n: u32) -> bool {
        self.0.u32(..n) == 0
    }

    /// Within ±1, sometimes 0 or an integer.
    fn signed(&mut self) -> f32 {
        match self.0.u32(..16) {
            0 => 0.0,
            1 => self.0.i32(-1..=1) as f32,
            _ => 2.0 * self.0.f32() - 1.0,
        }
    }

    /// Within [0, limit], sometimes 0.
    fn up_to(&mut self, limit: f32) -> f32 {
        if self.once_in(16) {
            0.0
        } else {
            self.0.f32() * limit
        }
    }

    /// Within a cube of side 2, sometimes of any size.
    fn point(&mut self) -> Vec3 {
        let point = Vec3::new(self.signed(), self.signed(), self.signed());
        if self.once_in(32) {
            point * 2_f32.powi(self.0.i32(-60..60))
        } else {
            point
        }
    }

    fn unit(&mut self) -> UnitVec3 {
        loop {
            let v = Vec3::new(self.signed(), self.signed(), self.signed());
            if let Some(unit) = v.unit() {
                return unit;
            }
        }
    }

    fn color(&mut self) -> Rgb {
        Rgb::new(self.up_to(1.0), self.up_to(1.0), self.up_to(1.0))
    }

    fn input(&mut self) -> Input {
        let (a, n, l) = (self.point(), self.unit(), self.unit());
        let b = if self.once_in(32) { a } else { self.point() };
        let c = if self.once_in(32) { b } else { self.point() };
        let v = match self.0.u32(..16) {
            0 => -l,
            1 => l,
            2 => reflection(n, l),
            _ => self.unit(),
        };
        let (one, other) = (self.signed(), self.signed());
        let edge = if self.once_in(16) {
            l.dot(-v).clamp(-1.0, 1.0)
        } else {
            one.max(other)
        };
        Input {
            a,
            b,
            c,
            n: *n,
            l: *l,
            v: *v,
            k: self.color(),
            i: self.color(),
            coefficients: Vec3::new(self.up_to(2.0), self.up_to(2.0), self.up_to(2.0)),
            q: self.up_to(4.0),
            r: 0.1 + self.up_to(4.0),
            inner: edge,
            outer: edge.min(one.min(other)),
            m: self.up_to(200.0),
            integer: self.0.u32(..200),
        }
    }
}
