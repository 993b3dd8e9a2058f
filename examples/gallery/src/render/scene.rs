//! A scene, and the light that reaches the eye: this file calls the crate.

use shading::{IncidentLight, Light, Material, Ranged, Rgb, Shaded, SoftCone, Vec3, shade};

use super::film::View;
use super::ray::{Camera, Hit, Ray, Surface};

/// Materials with an integer shininess.
pub type Finish = Material<f32, u32>;

/// A light with a soft edge and a range.
pub type SoftLight = Light<f32, SoftCone<f32>, Ranged<f32>>;

pub struct Scene {
    pub camera: Camera,
    pub objects: Vec<Object>,
    pub lights: Vec<Light<f32>>,
    /// Lights with a soft edge and a range.
    pub soft_lights: Vec<SoftLight>,
    /// I_a
    pub ambient: Rgb<f32>,
    pub model: Model,
    /// The part of the result that is shown.
    pub part: Part,
    pub backdrop: Backdrop,
}

/// All of the light that a point reflects, or one part of it.
pub type Part = fn(Shaded<f32>) -> Rgb<f32>;

/// The choice among the crate's sums over lights.
#[derive(Clone, Copy)]
pub enum Model {
    Phong,
    BlinnPhong,
}

pub struct Object {
    surface: Box<dyn Surface>,
    look: Look,
    /// The object fades into the backdrop between these distances from the scene's origin.
    fade: Option<[f32; 2]>,
}

enum Look {
    /// The material at each point.
    Painted(Box<dyn Fn(&Hit) -> Finish + Sync>),
    /// Shows where a light is, without shading and without a shadow.
    Glowing(Rgb<f32>),
}

impl Object {
    pub fn new(surface: impl Surface + 'static, material: Finish) -> Self {
        Self::painted(surface, move |_| material)
    }

    pub fn painted(
        surface: impl Surface + 'static,
        paint: impl Fn(&Hit) -> Finish + Sync + 'static,
    ) -> Self {
        Self {
            surface: Box::new(surface),
            look: Look::Painted(Box::new(paint)),
            fade: None,
        }
    }

    pub fn glowing(surface: impl Surface + 'static, color: Rgb<f32>) -> Self {
        Self {
            surface: Box::new(surface),
            look: Look::Glowing(color),
            fade: None,
        }
    }

    /// Makes the object fade into the backdrop with the distance from the scene's origin, so that a
    /// floor has no horizon.
    pub fn fading(self, near: f32, far: f32) -> Self {
        let fade = Some([near, far]);
        Self { fade, ..self }
    }

    /// The share of the backdrop that covers the object at a point.
    fn faded(&self, p: Vec3<f32>) -> f32 {
        self.fade
            .map_or(0.0, |[near, far]| (p.length() - near) / (far - near))
    }
}

/// The background behind the objects, brightest in the middle of the picture.
#[derive(Clone, Copy)]
pub struct Backdrop {
    pub center: Rgb<f32>,
    pub edge: Rgb<f32>,
}

impl Backdrop {
    pub const BLACK: Self = Self {
        center: Rgb::BLACK,
        edge: Rgb::BLACK,
    };

    /// The color at the point (x, y) of the picture.
    fn color(&self, x: f32, y: f32) -> Rgb<f32> {
        mix(self.center, self.edge, (x * x + y * y).sqrt() / 1.2)
    }
}

/// a at 0, b at 1, with a smooth transition in between.
fn mix(a: Rgb<f32>, b: Rgb<f32>, share: f32) -> Rgb<f32> {
    let x = share.clamp(0.0, 1.0);
    let smooth = x * x * (3.0 - 2.0 * x);
    a * (1.0 - smooth) + b * smooth
}

impl Scene {
    fn nearest(&self, ray: &Ray) -> Option<(Hit, &Object)> {
        let mut nearest: Option<(Hit, &Object)> = None;
        for object in &self.objects {
            let limit = nearest.map_or(f32::INFINITY, |(hit, _)| hit.t);
            nearest = object
                .surface
                .hit(ray, limit)
                .map(|hit| (hit, object))
                .or(nearest);
        }
        nearest
    }

    fn shaded(&self, ray: &Ray, hit: &Hit, material: &Finish) -> Shaded<f32> {
        let v = -ray.direction;
        // no ray is sent to a light behind the surface
        let hard = self
            .lights
            .iter()
            .filter_map(|light| light.in_front(hit.p, hit.n));
        let soft = self
            .soft_lights
            .iter()
            .filter_map(|light| light.in_front(hit.p, hit.n));
        let lit = hard.chain(soft).filter(|light| !self.in_shadow(hit, light));
        match self.model {
            Model::Phong => shade::phong(hit.n, v, material, self.ambient, lit),
            Model::BlinnPhong => shade::blinn_phong(hit.n, v, material, self.ambient, lit),
        }
    }

    /// Whether an object is between a point and a light.
    fn in_shadow(&self, hit: &Hit, light: &IncidentLight<f32>) -> bool {
        let ray = Ray {
            origin: hit.lifted,
            direction: light.l,
        };
        self.objects
            .iter()
            .filter(|object| matches!(object.look, Look::Painted(_)))
            .any(|object| object.surface.blocks(&ray, light.distance))
    }
}

impl View for Scene {
    fn color(&self, x: f32, y: f32, aspect: f32) -> Rgb<f32> {
        let backdrop = self.backdrop.color(x, y);
        let ray = self.camera.ray(x * aspect, y);
        let Some((hit, object)) = self.nearest(&ray) else {
            return backdrop;
        };
        let color = match &object.look {
            Look::Painted(paint) => (self.part)(self.shaded(&ray, &hit, &paint(&hit))),
            Look::Glowing(color) => *color,
        };
        mix(color, backdrop, object.faded(hit.p))
    }
}

/// Views in rows and columns, row by row.
pub struct Grid<V> {
    pub columns: usize,
    pub cells: Vec<V>,
}

impl<V: View> View for Grid<V> {
    fn color(&self, x: f32, y: f32, aspect: f32) -> Rgb<f32> {
        let columns = self.columns as f32;
        let rows = (self.cells.len() / self.columns) as f32;
        // the position in cells, from the left and from the top
        let across = (1.0 + x) * (0.5 * columns);
        let down = (1.0 - y) * (0.5 * rows);
        let column = across.floor().clamp(0.0, columns - 1.0);
        let row = down.floor().clamp(0.0, rows - 1.0);
        self.cells[row as usize * self.columns + column as usize].color(
            (across - column) * 2.0 - 1.0,
            1.0 - (down - row) * 2.0,
            aspect * rows / columns,
        )
    }
}
