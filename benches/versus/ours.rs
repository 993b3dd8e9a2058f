//! This crate, with any number type.

use shading::{
    Attenuation, Exponent, Material, PointLight, Real, Rgb, Shaded, UnitVec3, Vec3, shade,
};

use crate::scene::{AMBIENT, ATTENUATION, K_A, K_D, K_S, Scene};

/// The scene in the number type `T`: a float, or lanes of floats.
pub struct Ours<T, M> {
    points: Vec<Vec3<T>>,
    normals: Vec<UnitVec3<T>>,
    eyes: Vec<UnitVec3<T>>,
    pub lights: Vec<PointLight<T>>,
    pub material: Material<T, M>,
    pub ambient: Rgb<T>,
    pub image: Vec<Rgb<T>>,
}

impl<T: Real, M: Exponent<T>> Ours<T, M> {
    /// `gather` packs the numbers of one or more points into `T`.
    pub fn new(scene: &Scene, m: M, gather: impl Fn(&[[f32; 3]]) -> Vec<Vec3<T>>) -> Self {
        let number = |x: f32| T::of(f64::from(x));
        let color = |k: [f32; 3]| Rgb::from(k.map(number));
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
                    intensity: color(lamp.intensity),
                    attenuation: attenuation.cast(number),
                })
                .collect(),
            material: Material {
                k_a: color(K_A),
                k_d: color(K_D),
                k_s: color(K_S),
                m,
            },
            ambient: color(AMBIENT),
        }
    }

    /// One point at a time: which lights are in front is unpredictable.
    #[inline(never)]
    pub fn shade(&mut self) {
        self.each(|scene, p, n, v| {
            let lights = scene.lights.iter().filter_map(|light| light.in_front(p, n));
            shade::blinn_phong(n, v, &scene.material, scene.ambient, lights)
        });
    }

    /// Points in lanes: nearly every light is in front of at least one of them.
    #[cfg(feature = "native")]
    #[inline(never)]
    pub fn shade_lanes(&mut self) {
        self.each(|scene, p, n, v| {
            let lights = scene.lights.iter().map(|light| light.at(p));
            shade::blinn_phong(n, v, &scene.material, scene.ambient, lights)
        });
    }

    /// The total of what `shade` gives at each point.
    #[inline]
    pub fn each(&mut self, shade: impl Fn(&Self, Vec3<T>, UnitVec3<T>, UnitVec3<T>) -> Shaded<T>) {
        let mut image = std::mem::take(&mut self.image);
        let places = self.points.iter().zip(&self.normals).zip(&self.eyes);
        for (((&p, &n), &v), pixel) in places.zip(&mut image) {
            *pixel = shade(self, p, n, v).total();
        }
        self.image = image;
    }
}
