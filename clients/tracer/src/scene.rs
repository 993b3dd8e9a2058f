//! Spheres, a floor and a model under three lights.

use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, PointLight, Rgb, SpotLight, UnitVec3,
};
use shading::{Material, Real, Shaded, shade};

use crate::mesh::Mesh;
use crate::vector::{Vector, direction, ours};

const LIGHTS: [Light; 3] = [
    Light::Directional(DirectionalLight {
        l: UnitVec3::new(0.48, 0.6, 0.64).unwrap(),
        intensity: Rgb::new(0.5, 0.48, 0.45),
    }),
    Light::Point(PointLight {
        position: shading::Vec3::new(-3.0, 2.5, 1.0),
        intensity: Rgb::new(0.9, 0.3, 0.2),
        attenuation: Attenuation::new(0.5, 0.0, 0.06).unwrap(),
    }),
    Light::Spot(SpotLight {
        point: PointLight {
            position: shading::Vec3::new(2.0, 4.0, 0.0),
            intensity: Rgb::new(0.2, 0.4, 0.9),
            attenuation: Attenuation::NONE,
        },
        axis: UnitVec3::new(-0.6, -0.8, 0.0).unwrap(),
        cone: Cone::from_half_angle(0.4).unwrap(),
    }),
];

/// The scene is written in `f32`; `cast` converts lights and materials to the number type.
pub struct Scene<V: Vector> {
    pub spheres: Vec<(V, V::Number, Material<V::Number>)>,
    pub mesh: Option<(Mesh<V>, Material<V::Number>)>,
    pub floor: Material<V::Number>,
    pub lights: Vec<shading::Light<V::Number>>,
}

/// Where a ray ends.
pub struct Hit<'a, V: Vector> {
    pub t: V::Number,
    pub n: V,
    pub material: &'a Material<V::Number>,
}

impl<V: Vector> Scene<V> {
    pub fn new(mesh: Option<Mesh<V>>) -> Self {
        let paint = |r, g, b, m| {
            let (color, k_s) = (Rgb::new(r, g, b), Rgb::gray(0.5));
            Material {
                k_a: color,
                k_d: color,
                k_s,
                m,
            }
            .cast(V::Number::from)
        };
        let sphere = |center, radius: f32, material| (V::of_f32(center), radius.into(), material);
        Self {
            spheres: vec![
                sphere([1.4, 0.8, -0.6], 0.8, paint(0.8, 0.8, 0.8, 60)),
                sphere([-1.9, 0.6, 0.7], 0.6, paint(0.7, 0.5, 0.1, 20)),
                sphere([1.6, 0.4, 1.4], 0.4, paint(0.1, 0.6, 0.3, 200)),
            ],
            mesh: mesh.map(|mesh| (mesh, paint(0.75, 0.7, 0.65, 12))),
            floor: paint(0.5, 0.5, 0.5, 5),
            lights: LIGHTS
                .iter()
                .map(|light| light.cast(V::Number::from))
                .collect(),
        }
    }

    /// The light that comes back along a ray.
    pub fn seen(&self, from: V, along: V) -> Option<Shaded<V::Number>> {
        let Hit { t, n, material } = self.nearest(from, along, V::Number::MAX)?;
        let p = from + along * t;
        // off the surface, so that it does not shadow itself
        let start = p + n * V::Number::from(1e-3);
        let lit = self
            .lights
            .iter()
            .filter_map(|light| light.in_front(ours(p), direction(n)))
            .filter(|light| {
                self.nearest(start, <[_; 3]>::from(light.l).into(), light.distance)
                    .is_none()
            });
        let ambient = shading::Rgb::gray(V::Number::from(0.08));
        Some(shade::blinn_phong(
            direction(n),
            -direction(along),
            material,
            ambient,
            lit,
        ))
    }

    /// The first thing that a ray meets before the limit.
    pub fn nearest(&self, from: V, along: V, limit: V::Number) -> Option<Hit<'_, V>> {
        let mut found: Option<Hit<V>> = None;
        let mut take = |t, n, material| {
            let before = found.as_ref().map_or(limit, |hit| hit.t);
            if t > V::Number::from(0.0) && t < before {
                found = Some(Hit { t, n, material });
            }
        };
        let [_, height, _] = from.into();
        let [_, slope, _] = along.into();
        let t = -height / slope;
        if t < V::Number::from(60.0) {
            take(t, V::of_f32([0.0, 1.0, 0.0]), &self.floor);
        }
        for (center, radius, material) in &self.spheres {
            let toward = *center - from;
            let b = toward.dot(along);
            let discriminant = b * b - toward.dot(toward) + *radius * *radius;
            if discriminant > V::Number::from(0.0) {
                let t = b - Real::sqrt(discriminant);
                take(
                    t,
                    (along * t - toward) * (V::Number::from(1.0) / *radius),
                    material,
                );
            }
        }
        if let Some((mesh, material)) = &self.mesh
            && let Some((t, n)) = mesh.nearest(from, along, limit)
        {
            take(t, n, material);
        }
        found
    }
}
