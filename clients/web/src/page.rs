//! The picture and the numbers of one pixel.

use shading::f32::{Rgb, UnitVec3, Vec3};
use shading::{half_vector, reflection, term};

use crate::mesh;
use crate::scene::{Model, Part, SETTINGS, Scene};
use crate::surface::{Camera, Point, Surface, Turn};

/// Larger pictures are refused.
pub const MOST_PIXELS: usize = 2048 * 2048;

/// How many numbers `Page::probe` gives, in the order of `PROBE` in `page.js`.
pub const PROBE: usize = 73;

pub struct Page {
    pub settings: [f32; SETTINGS],
    /// The visible points, for the few sizes that the page draws.
    views: Vec<View>,
    pixels: Vec<u8>,
    probe: [f32; PROBE],
    message: &'static str,
}

/// The points of one surface from one eye in one size: they change with neither the material nor the lamp.
struct View {
    surface: Surface,
    eye: Vec3,
    turn: Turn,
    size: [usize; 2],
    points: Vec<Point>,
}

impl Page {
    /// Before the first picture.
    pub const EMPTY: Self = Self {
        settings: [0.0; SETTINGS],
        views: Vec::new(),
        pixels: Vec::new(),
        probe: [0.0; PROBE],
        message: "",
    };

    /// Red, green, blue and opacity of each pixel, row by row; empty if the size is refused.
    pub fn draw(&mut self, part: Part, width: usize, height: usize) -> &[u8] {
        self.pixels.clear();
        let scene = Scene::new(&self.settings);
        match width.checked_mul(height) {
            Some(0) => self.message = "The window has no room for a picture.",
            Some(area) if area <= MOST_PIXELS => {
                self.pixels.resize(4 * area, 0);
                let view = view(
                    &mut self.views,
                    surface(&self.settings),
                    &scene,
                    [width, height],
                );
                self.message = trouble(&scene, &view.points);
                for point in &view.points {
                    let [r, g, b] = part.of(scene.shaded(point)).to_srgb8();
                    self.pixels[4 * point.pixel..][..4].copy_from_slice(&[r, g, b, 255]);
                }
            }
            _ => self.message = "The window is larger than 2048 × 2048 pixels: make it smaller.",
        }
        &self.pixels
    }

    /// A message to the user about the last picture; empty if there is none.
    #[must_use]
    pub fn message(&self) -> &'static str {
        self.message
    }

    /// The numbers behind a pixel. All are 0 if nothing is visible there.
    pub fn probe(&mut self, width: usize, height: usize, x: usize, y: usize) -> &[f32; PROBE] {
        self.probe = [0.0; PROBE];
        let is_inside = x < width
            && y < height
            && width
                .checked_mul(height)
                .is_some_and(|area| area <= MOST_PIXELS);
        if is_inside {
            let scene = Scene::new(&self.settings);
            let view = view(
                &mut self.views,
                surface(&self.settings),
                &scene,
                [width, height],
            );
            let pixel = y * width + x;
            if let Ok(found) = view
                .points
                .binary_search_by_key(&pixel, |point| point.pixel)
            {
                self.probe = numbers(&scene, &view.points[found]);
            }
        }
        &self.probe
    }

    /// Where in the picture a lamp is, or outside of the picture if it is off or behind the eye.
    #[must_use]
    pub fn lamp(&self, index: usize, width: usize, height: usize) -> [f32; 2] {
        let camera = self.camera(width, height);
        let projected = self
            .position(index)
            .and_then(|position| camera.project(position));
        projected.map_or([-1.0; 2], |at| [at.x, at.y])
    }

    /// Where a lamp would be in space if it were moved in the picture and kept its depth. A lamp
    /// that is off stays at 0.
    #[must_use]
    pub fn moved(&self, index: usize, width: usize, height: usize, to: [f32; 2]) -> [f32; 3] {
        let position = self.position(index);
        position.map_or([0.0; 3], |position| {
            self.camera(width, height).moved(position, to).into()
        })
    }

    /// Where a point of space is in the picture, and its depth; all are −1 behind the eye.
    #[must_use]
    pub fn project(&self, point: Vec3, width: usize, height: usize) -> [f32; 3] {
        let projected = self.camera(width, height).project(point);
        projected.map_or([-1.0; 3], |at| [at.x, at.y, 1.0 / at.w])
    }

    fn camera(&self, width: usize, height: usize) -> Camera {
        Camera::new(Scene::new(&self.settings).eye, width, height)
    }

    /// The picture of a coarse mesh, with the light mixed between its corners or once for each triangle; empty if
    /// the size is refused.
    pub fn draw_mesh(&mut self, is_smooth: bool, width: usize, height: usize) -> &[u8] {
        self.pixels.clear();
        if width
            .checked_mul(height)
            .is_some_and(|area| area <= MOST_PIXELS)
        {
            self.pixels.resize(4 * width * height, 0);
            let scene = Scene::new(&self.settings);
            let camera = Camera::new(scene.eye, width, height);
            let surface = surface(&self.settings);
            for (pixel, color) in mesh::shaded(&scene, surface, scene.turn, &camera, is_smooth) {
                let [r, g, b] = color.to_srgb8();
                self.pixels[4 * pixel..][..4].copy_from_slice(&[r, g, b, 255]);
            }
        }
        &self.pixels
    }

    fn position(&self, index: usize) -> Option<Vec3> {
        let lamp = Scene::new(&self.settings).lamps.get(index).copied()??;
        Some(lamp.point.position)
    }
}

fn surface(settings: &[f32; SETTINGS]) -> Surface {
    if settings[0] == 0.0 {
        Surface::Sphere
    } else {
        Surface::Teapot
    }
}

/// The view that is there already, or a new one in place of the oldest.
fn view<'a>(
    views: &'a mut Vec<View>,
    surface: Surface,
    scene: &Scene,
    size: [usize; 2],
) -> &'a View {
    let wanted = (surface, scene.eye, scene.turn, size);
    let known = views
        .iter()
        .position(|it| (it.surface, it.eye, it.turn, it.size) == wanted);
    let index = known.unwrap_or_else(|| {
        if views.len() == 6 {
            views.remove(0);
        }
        views.push(View::new(surface, scene, size));
        views.len() - 1
    });
    &views[index]
}

/// The problem with the lamp, if there is one.
fn trouble(scene: &Scene, points: &[Point]) -> &'static str {
    let Some(lamp) = scene.lamps[0] else {
        return "1/(a + bq + cq²) has no value where a, b and c are 0. The lamps are off: raise one of them.";
    };
    let is_lit = |point: &Point| {
        scene
            .lights(point.p)
            .any(|light| light.is_in_front(point.n) && light.intensity() != Rgb::BLACK)
    };
    if points.iter().any(is_lit) {
        ""
    } else if scene.lamps[1].is_some() || scene.sun.is_some() {
        "The lamps light nothing that is seen."
    } else if lamp.point.position == scene.eye {
        "The lamp is at the eye, and its cone misses what is seen."
    } else {
        "The lamp lights nothing that is seen: it is black, inside or behind the surface, or its cone is too narrow."
    }
}

impl View {
    fn new(surface: Surface, scene: &Scene, size: [usize; 2]) -> Self {
        let (eye, turn) = (scene.eye, scene.turn);
        let points = surface.seen_by(&Camera::new(eye, size[0], size[1]), turn);
        Self {
            surface,
            eye,
            turn,
            size,
            points,
        }
    }
}

/// Each letter of the formula at a point.
fn numbers(scene: &Scene, point: &Point) -> [f32; PROBE] {
    let Point { p, n, v, .. } = *point;
    let shaded = scene.shaded(point);
    let total = shaded.total();
    let mut numbers = [0.0; PROBE];
    let mut places = numbers.iter_mut();
    let mut put = |list: &[f32]| {
        list.iter()
            .zip(&mut places)
            .for_each(|(x, place)| *place = *x);
    };
    put(&[1.0]);
    put([
        p.into(),
        n.into(),
        v.into(),
        shaded.ambient.into(),
        shaded.diffuse.into(),
        shaded.specular.into(),
        total.into(),
        total.to_srgb8().map(f32::from),
    ]
    .as_flattened());
    let lamps = scene.lamps.iter().flatten().map(|lamp| {
        let incident = lamp.at(p).arrival();
        let (l, q) = (incident.l, incident.distance);
        (
            l,
            q,
            lamp.point.attenuation.at(q),
            lamp.cone.factor(lamp.axis, l),
        )
    });
    // the sun has no distance, and loses nothing on its way
    let sun = scene.sun.iter().map(|sun| (sun.l, 0.0, 1.0, 1.0));
    for (l, q, attenuation, cone) in lamps.chain(sun) {
        let r = reflection(n, l);
        let h = half_vector(l, v).unwrap_or(UnitVec3::assume_unit(Vec3::ZERO));
        let (r_dot_v, n_dot_h) = (r.dot(v), n.dot(h));
        let highlight = match scene.model {
            Model::Lambert => 0.0,
            Model::Phong => term::phong(r, v, scene.material.m),
            Model::BlinnPhong => term::blinn(n, h, scene.material.m),
        };
        put([l.into(), r.into(), h.into()].as_flattened());
        put(&[q, n.dot(l), r_dot_v, n_dot_h, highlight]);
        put(&[attenuation, cone]);
    }
    numbers
}
