//! The scene that all contestants shade: random points with random normals, about half of them
//! turned away from each light, and four point lights.

/// A power of two, which every number of lanes divides.
pub const POINTS: usize = 4096;
/// The number of lights, if no other is given. A renderer learns it only at run time, so no contestant knows
/// it at compile time.
pub const LIGHTS: usize = 4;

/// The shininess as a real number and as an integer.
pub const REAL_M: f32 = 50.5;
pub const WHOLE_M: u32 = 50;

pub const AMBIENT: [f32; 3] = [0.1, 0.1, 0.12];
pub const K_A: [f32; 3] = [0.3, 0.25, 0.2];
pub const K_D: [f32; 3] = [0.6, 0.5, 0.4];
pub const K_S: [f32; 3] = [0.4, 0.4, 0.35];
/// a, b, c of 1/(a + bq + cq²)
pub const ATTENUATION: [f32; 3] = [1.0, 0.1, 0.05];

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Lamp {
    pub position: [f32; 3],
    pub intensity: [f32; 3],
}

pub struct Scene {
    pub points: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    /// the directions to the eye
    pub eyes: Vec<[f32; 3]>,
    pub lamps: Vec<Lamp>,
}

impl Scene {
    /// Makes the same scene for the same seed.
    pub fn new(seed: u64) -> Self {
        Self::lit_by(LIGHTS, seed)
    }

    /// The same number of points and lights with fewer points and more lights.
    pub fn lit_by(lights: usize, seed: u64) -> Self {
        let count = POINTS * LIGHTS / lights;
        let mut random = fastrand::Rng::with_seed(seed);
        let mut within = |size: f32| [(); 3].map(|()| size * (2.0 * random.f32() - 1.0));
        let lamp = |_| Lamp {
            position: within(4.0),
            intensity: within(0.5).map(|channel| channel + 1.0),
        };
        let lamps = (0..lights).map(lamp).collect();
        let mut direction = || loop {
            let v = within(1.0);
            let square: f32 = v.iter().map(|c| c * c).sum();
            if (0.01..1.0).contains(&square) {
                return v.map(|c| c / square.sqrt());
            }
        };
        let normals = (0..count).map(|_| direction()).collect();
        let eyes = (0..count).map(|_| direction()).collect();
        let points = (0..count).map(|_| within(1.0)).collect();
        Self {
            points,
            normals,
            eyes,
            lamps,
        }
    }
}
