//! A small ray tracer. The crate shades; this file finds what is visible and which lights reach it.

use rayon::prelude::*;
use shading::f32::{IncidentLight, Light, Material, Rgb, Shaded, UnitVec3, Vec3};
use shading::{Dual, Elementary, normal, shade};

#[derive(Clone, Copy)]
pub struct Ray {
    pub origin: Vec3,
    pub along: UnitVec3,
}

impl Ray {
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + *self.along * t
    }
}

/// Where a ray meets a surface: the distance, and the triangle of a mesh with the weights of its corners.
#[derive(Clone, Copy)]
pub struct Meeting {
    pub t: f32,
    pub triangle: usize,
    pub weights: [f32; 3],
}

impl Meeting {
    pub fn at(t: f32) -> Self {
        Self {
            t,
            triangle: 0,
            weights: [0.0; 3],
        }
    }
}

pub trait Surface: Sync {
    /// The nearest meeting before the distance `limit`.
    fn meet(&self, ray: &Ray, limit: f32) -> Option<Meeting>;
    /// The point and the normal there. `None` where there is no normal: any that faces the eye will do.
    fn place(&self, ray: &Ray, meeting: &Meeting) -> (Vec3, Option<UnitVec3>);
}

#[derive(Clone, Copy)]
pub struct Sphere(pub Vec3, pub f32);

impl Sphere {
    /// The two distances at which the line of a ray crosses the sphere.
    fn crossings(&self, ray: &Ray) -> Option<[f32; 2]> {
        let to_center = self.0 - ray.origin;
        let middle = to_center.dot(ray.along);
        let aside = to_center - *ray.along * middle; // avoids cancellation for a distant sphere
        let square = self.1 * self.1 - aside.dot(aside);
        (square > 0.0).then(|| [middle - square.sqrt(), middle + square.sqrt()])
    }
}

impl Surface for Sphere {
    fn meet(&self, ray: &Ray, limit: f32) -> Option<Meeting> {
        let crossings = self.crossings(ray)?.into_iter();
        crossings
            .filter(|t| (1e-4..limit).contains(t))
            .map(Meeting::at)
            .next()
    }
    fn place(&self, ray: &Ray, meeting: &Meeting) -> (Vec3, Option<UnitVec3>) {
        let p = ray.at(meeting.t);
        (p, normal::sphere(self.0, p))
    }
}

/// The plane ax + by + cz + d = 0.
pub struct Plane(pub [f32; 4]);

impl Surface for Plane {
    fn meet(&self, ray: &Ray, limit: f32) -> Option<Meeting> {
        let [a, b, c, d] = self.0;
        let abc = Vec3::new(a, b, c);
        let t = -(abc.dot(ray.origin) + d) / abc.dot(ray.along);
        (0.0 < t && t < limit).then(|| Meeting::at(t))
    }
    fn place(&self, ray: &Ray, meeting: &Meeting) -> (Vec3, Option<UnitVec3>) {
        let [a, b, c, _] = self.0;
        (ray.at(meeting.t), normal::plane(a, b, c))
    }
}

/// A function whose zeros form a surface. It is negative inside, and |f| is at most the distance to
/// the surface. With `f32` it finds the surface, and with dual numbers it gives the normal.
pub trait Field: Sync {
    fn value<T: Elementary>(&self, p: shading::Vec3<T>) -> T;
}

/// The surface of a field inside a sphere, found by sphere tracing (Hart, *The Visual Computer* 12, 1996).
pub struct Implicit<F>(pub F, pub Sphere);

impl<F: Field> Surface for Implicit<F> {
    fn meet(&self, ray: &Ray, limit: f32) -> Option<Meeting> {
        let [enter, leave] = self.1.crossings(ray)?;
        let (mut t, end) = (enter.max(0.0), leave.min(limit));
        for _ in 0..400 {
            let f = self.0.value(ray.at(t));
            if t >= end || f < 1e-4 {
                break;
            }
            t += f;
        }
        (t < end).then(|| Meeting::at(t))
    }
    fn place(&self, ray: &Ray, &Meeting { t, .. }: &Meeting) -> (Vec3, Option<UnitVec3>) {
        // a step of Newton's method along the ray; where it grazes, the curvature counts more than the slope
        let f = self.0.value(Dual::point(ray.at(t)));
        let slope = f.gradient.dot(ray.along);
        let p = ray.at(if slope < -0.1 { t - f.value / slope } else { t });
        (p, normal::implicit(|p| self.0.value(p), p))
    }
}

/// What is seen of a surface: its material at each point, or, of a lamp, its color.
pub enum Look {
    Painted(Box<dyn Fn(Vec3) -> Material + Sync>),
    Glowing(Rgb),
}

pub struct Object {
    pub surface: Box<dyn Surface>,
    pub look: Look,
    /// It fades into the backdrop between these distances from the origin, so that a floor has no horizon.
    pub fade: [f32; 2],
}

pub enum Camera {
    /// Sees an angle in degrees from the lower to the upper edge.
    Perspective(f32),
    /// Sees this height along parallel rays.
    Parallel(f32),
}

#[derive(Clone, Copy)]
pub enum Model {
    Phong,
    BlinnPhong,
}

pub struct Scene {
    pub eye: Vec3,
    pub at: Vec3,
    pub camera: Camera,
    pub objects: Vec<Object>,
    pub lights: Vec<Light>,
    pub ambient: Rgb,
    pub model: Model,
    /// The part of the light that is shown.
    pub part: fn(Shaded) -> Rgb,
    /// The color in the middle and at the edge of the picture.
    pub backdrop: [Rgb; 2],
}

impl Scene {
    /// The ray through the point (x, y) of the picture; y goes from −1 at the lower to 1 at the upper edge.
    fn ray(&self, x: f32, y: f32) -> Ray {
        let forward = (self.at - self.eye).unit_or(UnitVec3::NEG_Z);
        let right = forward.cross(UnitVec3::Y).unit_or(UnitVec3::X);
        let aside = *right * x + right.cross(forward) * y;
        match self.camera {
            Camera::Perspective(degrees) => {
                let along = *forward + aside * (degrees.to_radians() / 2.0).tan();
                Ray {
                    origin: self.eye,
                    along: along.unit_or(forward),
                }
            }
            Camera::Parallel(height) => Ray {
                origin: self.eye + aside * (height / 2.0),
                along: forward,
            },
        }
    }

    /// The linear light at a point of the picture.
    fn color(&self, x: f32, y: f32) -> Rgb {
        let backdrop = mix(self.backdrop, (x * x + y * y).sqrt() / 1.2);
        let ray = self.ray(x, y);
        let mut nearest: Option<(Meeting, &Object)> = None;
        for object in &self.objects {
            let limit = nearest.map_or(f32::INFINITY, |(meeting, _)| meeting.t);
            nearest = object
                .surface
                .meet(&ray, limit)
                .map(|meeting| (meeting, object))
                .or(nearest);
        }
        let Some((meeting, object)) = nearest else {
            return backdrop;
        };
        let (p, n) = object.surface.place(&ray, &meeting);
        let color = match &object.look {
            Look::Glowing(color) => *color,
            Look::Painted(paint) => {
                (self.part)(self.shaded(p, n.unwrap_or(-ray.along), -ray.along, &paint(p)))
            }
        };
        let [near, far] = object.fade;
        mix([color, backdrop], (p.length() - near) / (far - near))
    }

    fn shaded(&self, p: Vec3, n: UnitVec3, v: UnitVec3, material: &Material) -> Shaded {
        let start = p + *n * 2e-3; // off the surface, so that it does not shadow itself
        let is_blocked = |light: &IncidentLight| {
            let arrival = light.arrival();
            self.is_blocked(start, arrival.l, arrival.distance)
        };
        let lights = self.lights.iter().map(|light| light.at(p));
        let lit = lights.filter(|light| light.is_in_front(n) && !is_blocked(light));
        match self.model {
            Model::Phong => shade::phong(n, v, material, self.ambient, lit),
            Model::BlinnPhong => shade::blinn_phong(n, v, material, self.ambient, lit),
        }
    }

    fn is_blocked(&self, origin: Vec3, along: UnitVec3, limit: f32) -> bool {
        let ray = Ray { origin, along };
        let blocks = |object: &Object| object.surface.meet(&ray, limit).is_some();
        self.objects
            .iter()
            .any(|object| matches!(object.look, Look::Painted(_)) && blocks(object))
    }
}

/// a at 0, b at 1, with a smooth transition in between.
fn mix([a, b]: [Rgb; 2], share: f32) -> Rgb {
    let x = share.clamp(0.0, 1.0);
    let smooth = x * x * (3.0 - 2.0 * x);
    a * (1.0 - smooth) + b * smooth
}

/// The bytes of a picture of scenes in rows: one sample for each pixel, and sixteen where its neighbors differ.
pub fn draw(rows: &[Vec<Scene>], [width, height]: [usize; 2]) -> Vec<u8> {
    let cell = [width / rows[0].len(), height / rows.len()];
    let sample = |i: usize, dx: f32, dy: f32| {
        let (column, row) = (i % width, i / width);
        let scene =
            &rows[(row / cell[1]).min(rows.len() - 1)][(column / cell[0]).min(rows[0].len() - 1)];
        let x = ((column % cell[0]) as f32 + dx) * 2.0 - cell[0] as f32;
        let y = cell[1] as f32 - ((row % cell[1]) as f32 + dy) * 2.0;
        scene
            .color(x / cell[1] as f32, y / cell[1] as f32)
            .clamped() // so that the edge of a highlight stays smooth
    };
    let pixels = 0..width * height;
    let rough: Vec<Rgb> = pixels
        .clone()
        .into_par_iter()
        .map(|i| sample(i, 0.5, 0.5))
        .collect();
    let levels: Vec<[u8; 3]> = rough.iter().map(|color| color.to_srgb8()).collect();
    let differs = |i: usize, j: usize| (0..3).any(|c| levels[i][c].abs_diff(levels[j][c]) > 3);
    let needs_more = |i: usize| {
        let (x, y) = (i % width, i / width);
        let around = |k: usize, end: usize| k.saturating_sub(1)..=(k + 1).min(end - 1);
        around(y, height).any(|y| around(x, width).any(|x| differs(i, y * width + x)))
    };
    let smooth = |i: usize| -> Rgb {
        let points =
            (0..16_u32).map(|k| [k, k.reverse_bits() >> 28].map(|k| (k as f32 + 0.5) / 16.0)); // Hammersley's
        points.map(|[dx, dy]| sample(i, dx, dy)).sum::<Rgb>() * (1.0 / 16.0)
    };
    let color = |i: usize| if needs_more(i) { smooth(i) } else { rough[i] };
    pixels
        .into_par_iter()
        .flat_map_iter(|i| color(i).to_srgb8())
        .collect()
}
