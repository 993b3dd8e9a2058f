//! What the contestants shade.

/// The sums.
pub const MODELS: [&str; 4] = [
    "Blinn, m = 50",
    "Blinn, m = 51",
    "Blinn, m = 50.5",
    "Phong, m = 50",
];
pub const DATA: [&str; 2] = ["random", "sphere"];
pub const COUNTS: [usize; 3] = [1, 4, 16];
pub const LIGHTS: [&str; 3] = ["1 light", "4 lights", "16 lights"];

/// The loops, and how much of a rival's time they may take.
pub const LOOPS: [(&str, f64); 7] = [
    ("to_srgb8", 0.85),
    ("to_rgb565", 0.4),
    ("unit", 1.3),
    ("triangle", 1.3),
    ("corner", 1.2),
    ("implicit, a torus", 1.5),
    ("parametric, a saddle", 1.5),
];
pub const KINDS: [&str; 3] = ["random", "smooth", "hard"];
pub const WAYS: [&str; 4] = ["random", "smooth", "hard", "random, by a call"];

pub const K_A: [f64; 3] = [0.1; 3];
pub const K_D: [f64; 3] = [0.6, 0.5, 0.4];
pub const K_S: [f64; 3] = [0.3; 3];
/// a, b, c of 1/(a + bq + cq²)
pub const ATTENUATION: [f64; 3] = [1.0, 0.1, 0.05];

/// Branches that no processor memorizes: a Zen 5 knows 16,384 of them by heart.
const BRANCHES: usize = 1 << 16;

pub type List<T> = [T; 3];

/// N, V and p of points: random ones on a unit sphere whose eye is before the surface, the pixels
/// of a picture of that sphere, row by row, or random ones in a cube, with any N and V.
pub fn points(data: &str, lights: usize) -> Vec<List<List<f64>>> {
    let mut random = fastrand::Rng::with_seed(7);
    // no more than that either: a pass is then too short for a neighbor to interrupt each
    let side = (BRANCHES / lights).isqrt();
    let point = |i| {
        let pixel = |k: usize| (k as f64 + 0.5) / side as f64 * 2.0 - 1.0;
        let (x, y) = (pixel(i % side), pixel(i / side));
        if data == "sphere" {
            let n = unit([x, y, (1.0 - x * x - y * y).max(0.01).sqrt()]);
            [n, unit([-n[0], -n[1], 4.0 - n[2]]), n]
        } else if data == "random" {
            let n = unit(vector(&mut random, 2.0));
            [n, unit(n.map(|x| x + random.f64() - 0.5)), n]
        } else {
            let [n, v, p] = [(); 3].map(|()| vector(&mut random, 2.0));
            [unit(n), unit(v), p]
        }
    };
    (0..side * side).map(point).collect()
}

/// Positions of lamps around the sphere.
pub fn lamps(count: usize) -> Vec<List<f64>> {
    let mut random = fastrand::Rng::with_seed(11);
    let lamp = |_| unit(vector(&mut random, 2.0)).map(|x| 3.0 * x);
    (0..count).map(lamp).collect()
}

fn vector(random: &mut fastrand::Rng, size: f64) -> List<f64> {
    [(); 3].map(|()| size * (random.f64() - 0.5))
}

fn unit(v: List<f64>) -> List<f64> {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// Arguments of a loop.
const COUNT: u16 = 4096;

/// Linear colors. The hard ones are of all magnitudes, black, too bright and invalid.
pub fn colors(kind: &str) -> Vec<List<f32>> {
    let mut random = fastrand::Rng::with_seed(1975);
    let mut channel = |i: u16, k: u16| match (kind, random.u8(0..8), random.f32()) {
        ("random", _, x) => x,
        ("smooth", ..) => f32::from((i + 1000 * k) % COUNT) / f32::from(COUNT),
        (_, 0, x) => -x,
        (_, 1, x) => 1.0 + x,
        (_, 2, x) => [0.0, f32::NAN, f32::INFINITY][(3.0 * x) as usize],
        (_, _, x) => (-12.0 * x).exp2(),
    };
    (0..COUNT)
        .map(|i| [0, 1, 2].map(|k| channel(i, k)))
        .collect()
}

/// Triangles. Of the hard ones, one in sixteen has an edge whose square is not exact.
pub fn triangles(kind: &str) -> Vec<List<List<f32>>> {
    let mut random = fastrand::Rng::with_seed(1977);
    let corner = |column: u16, row: u16| {
        let (x, y) = (f32::from(column) / 32.0, f32::from(row) / 32.0);
        [x, y, 0.2 * (3.0 * x).sin() * (2.0 * y).cos()]
    };
    let triangle = |i: u16| {
        let scale = match (kind, random.u8(0..32)) {
            ("hard", 0) => 1e-30,
            ("hard", 1) => 1e30,
            _ => 1.0,
        };
        match kind {
            "smooth" => [[0, 0], [1, 0], [0, 1]].map(|[x, y]| corner(i % 64 + x, i / 64 + y)),
            _ => [(); 3].map(|()| [(); 3].map(|()| scale * (4.0 * random.f32() - 2.0))),
        }
    };
    (0..COUNT).map(triangle).collect()
}
