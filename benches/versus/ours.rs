//! This crate, over any number type.

use shading::{Attenuation, Exponent, Material, PointLight, Real, Rgb, UnitVec3, Vec3, shade};

use crate::scene::{AMBIENT, ATTENUATION, K_A, K_D, K_S, Scene};

/// The scene over the number type `T`: a float, or lanes of it.
pub struct Ours<T, M> {
    points: Vec<Vec3<T>>,
    normals: Vec<UnitVec3<T>>,
    eyes: Vec<UnitVec3<T>>,
    lights: Vec<PointLight<T>>,
    material: Material<T, M>,
    ambient: Rgb<T>,
    pub image: Vec<Rgb<T>>,
}

impl<T: Real, M: Exponent<T>> Ours<T, M> {
    /// `gather` makes the numbers of one or more points into `T`.
    pub fn new(scene: &Scene, m: M, gather: impl Fn(&[[f32; 3]]) -> Vec<Vec3<T>>) -> Self {
        let number = |x: f32| T::of(f64::from(x));
        let colour = |k: [f32; 3]| Rgb::from(k.map(number));
        let units = |v: Vec<Vec3<T>>| v.into_iter().map(UnitVec3::assume_unit).collect();
        let [a, b, c] = ATTENUATION;
        let attenuation = Attenuation::<f32>::new(a, b, c).expect("valid");
        let points = gather(&scene.points);
        Self {
            image: vec![Rgb::BLACK; points.len()],
            points,
            normals: units(gather(&scene.normals)),
            eyes: units(gather(&scene.eyes)),
            lights: scene
                .lamps
                .iter()
                .map(|lamp| PointLight {
                    position: Vec3::from(lamp.position.map(number)),
                    intensity: colour(lamp.intensity),
                    attenuation: attenuation.map(number),
                })
                .collect(),
            material: Material {
                k_a: colour(K_A),
                k_d: colour(K_D),
                k_s: colour(K_S),
                m,
            },
            ambient: colour(AMBIENT),
        }
    }

    #[inline(never)]
    pub fn shade(&mut self) {
        let places = self.points.iter().zip(&self.normals).zip(&self.eyes);
        for (((&p, &n), &v), pixel) in places.zip(&mut self.image) {
            let lights = self.lights.iter().filter_map(|light| light.in_front(p, n));
            *pixel = shade::blinn_phong(n, v, &self.material, self.ambient, lights).total();
        }
    }
}
