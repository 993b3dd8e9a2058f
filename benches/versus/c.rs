//! The same formulas in C.

use crate::scene::{AMBIENT, ATTENUATION, K_A, K_D, K_S, Lamp, REAL_M, Scene};

#[repr(C)]
struct CScene {
    lamps: *const Lamp,
    lamp_count: usize,
    attenuation: [f32; 3],
    k_a: [f32; 3],
    k_d: [f32; 3],
    k_s: [f32; 3],
    ambient: [f32; 3],
    m: f32,
}

impl CScene {
    fn new(scene: &Scene) -> Self {
        Self {
            lamps: scene.lamps.as_ptr(),
            lamp_count: scene.lamps.len(),
            attenuation: ATTENUATION,
            k_a: K_A,
            k_d: K_D,
            k_s: K_S,
            ambient: AMBIENT,
            m: REAL_M,
        }
    }
}

#[cfg(feature = "native")]
#[repr(C)]
struct Arrays {
    inputs: [*const f32; 9],
    image: [*mut f32; 3],
}

unsafe extern "C" {
    fn shade_scalar(
        scene: &CScene,
        count: usize,
        points: *const [f32; 3],
        normals: *const [f32; 3],
        eyes: *const [f32; 3],
        image: *mut [f32; 3],
    );
    #[cfg(feature = "native")]
    fn shade_lanes(scene: &CScene, count: usize, arrays: &Arrays);
}

/// `c/scalar.c`
pub struct Scalar<'a> {
    scene: &'a Scene,
    c: CScene,
    pub image: Vec<[f32; 3]>,
}

impl<'a> Scalar<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        Self {
            scene,
            c: CScene::new(scene),
            image: vec![[0.0; 3]; scene.points.len()],
        }
    }

    pub fn shade(&mut self) {
        let s = self.scene;
        let [points, normals, eyes] = [&s.points, &s.normals, &s.eyes].map(Vec::as_ptr);
        // SAFETY: every array has as many elements as the image.
        unsafe {
            shade_scalar(
                &self.c,
                self.image.len(),
                points,
                normals,
                eyes,
                self.image.as_mut_ptr(),
            );
        }
    }
}

/// `c/lanes.c`
#[cfg(feature = "native")]
pub struct Lanes {
    c: CScene,
    inputs: [Vec<f32>; 9],
    pub image: [Vec<f32>; 3],
}

#[cfg(feature = "native")]
impl Lanes {
    pub fn new(scene: &Scene) -> Self {
        let all = [&scene.points, &scene.normals, &scene.eyes];
        Self {
            c: CScene::new(scene),
            inputs: std::array::from_fn(|i| all[i / 3].iter().map(|v| v[i % 3]).collect()),
            image: [(); 3].map(|()| vec![0.0; scene.points.len()]),
        }
    }

    pub fn shade(&mut self) {
        let arrays = Arrays {
            inputs: self.inputs.each_ref().map(Vec::as_ptr),
            image: self.image.each_mut().map(Vec::as_mut_ptr),
        };
        // SAFETY: every array has as many elements as a channel of the image.
        unsafe { shade_lanes(&self.c, self.image[0].len(), &arrays) }
    }
}
