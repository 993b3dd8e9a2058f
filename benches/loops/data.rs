//! Arguments: random ones, smooth ones as neighboring pixels and triangles have them, and hard ones,
//! which mispredict branches and leave the range in which squares are exact.

use glam::Vec3;

use crate::race::Data;

/// Fits into the caches.
pub const COUNT: u16 = 4096;
/// Too long for a Zen 5 to memorize the branches of four lights at each point, as it does with 4,096 points if no other
/// branches run in between. A rival then takes up to a quarter less time.
pub const MANY: u16 = 16_384;

/// Three vectors, of which a function takes as many as it needs, for this crate and for `glam`.
#[derive(Clone)]
pub struct Vectors {
    pub ours: [shading::Vec3<f32>; 3],
    pub glam: [Vec3; 3],
}

impl From<[Vec3; 3]> for Vectors {
    fn from(glam: [Vec3; 3]) -> Self {
        let ours = glam.map(|v| shading::Vec3::from(v.to_array()));
        Self { ours, glam }
    }
}

struct Random(fastrand::Rng);

impl Random {
    fn new() -> Self {
        Self(fastrand::Rng::with_seed(1975))
    }

    fn channel(&mut self) -> f32 {
        self.0.f32()
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::from([(); 3].map(|()| 4.0 * self.channel() - 2.0))
    }

    fn vectors(&mut self) -> [Vec3; 3] {
        [(); 3].map(|()| self.vector())
    }

    fn direction(&mut self) -> Vec3 {
        self.vector().normalize_or(Vec3::Z)
    }
}

fn each<I, J: Into<I>>(count: u16, kind: &'static str, of: impl FnMut(u16) -> J) -> Data<I> {
    (kind, (0..count).map(of).map(Into::into).collect())
}

/// Linear colors.
pub fn colors() -> Vec<Data<[f32; 3]>> {
    let mut random = Random::new();
    let mut hard = Random::new();
    vec![
        each(COUNT, "random", |_| [(); 3].map(|()| random.channel())),
        each(COUNT, "smooth", |i| {
            let ramp = f32::from(i) / f32::from(COUNT);
            [ramp, 0.5 * ramp, 1.0 - ramp]
        }),
        // of all magnitudes, black, too bright and invalid
        each(COUNT, "hard", |_| {
            [(); 3].map(|()| match hard.0.u8(0..8) {
                0 => -hard.channel(),
                1 => 1.0 + hard.channel(),
                2 => [0.0, f32::NAN, f32::INFINITY][hard.0.usize(0..3)],
                _ => (-12.0 * hard.channel()).exp2(),
            })
        }),
    ]
}

/// The corners of triangles.
pub fn triangles() -> Vec<Data<Vectors>> {
    let (mut random, mut hard) = (Random::new(), Random::new());
    vec![
        each(COUNT, "random", |_| random.vectors()),
        each(COUNT, "smooth", |i| {
            let corner = |column: u16, row: u16| {
                let (x, y) = (f32::from(column) / 32.0, f32::from(row) / 32.0);
                Vec3::new(x, y, 0.2 * (3.0 * x).sin() * (2.0 * y).cos())
            };
            let (column, row) = (i % 64, i / 64);
            [
                corner(column, row),
                corner(column + 1, row),
                corner(column, row + 1),
            ]
        }),
        // one in sixteen has an edge whose square is not exact
        each(COUNT, "hard", |_| {
            let vectors = hard.vectors();
            match hard.0.u8(0..32) {
                0 => vectors.map(|v| v * 1e-30),
                1 => vectors.map(|v| v * 1e30),
                _ => vectors,
            }
        }),
    ]
}

/// Three directions.
pub fn directions(count: u16) -> Vec<Data<Vectors>> {
    let (mut random, mut hard) = (Random::new(), Random::new());
    vec![
        each(count, "random", |_| [(); 3].map(|()| random.direction())),
        each(count, "smooth", |i| {
            let angle = f32::from(i) / f32::from(count);
            let (sine, cosine) = angle.sin_cos();
            [
                Vec3::Z,
                Vec3::new(0.6, 0.0, 0.8),
                Vec3::new(sine, 0.0, cosine),
            ]
        }),
        // the second is often opposite to the first or perpendicular to it
        each(count, "hard", |_| {
            let [n, l, v] = [(); 3].map(|()| hard.direction());
            [
                n,
                [-n, n, n.any_orthonormal_vector(), l][hard.0.usize(0..4)],
                v,
            ]
        }),
    ]
}
