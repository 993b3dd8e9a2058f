//! The picture and the numbers of one pixel.

use shading::f32::{Rgb, UnitVec3, Vec3};
use shading::{half_vector, reflection, term};

use crate::scene::{Model, Part, SETTINGS, Scene};
use crate::surface::{Camera, EYE, Point, Surface};

/// Larger pictures are refused.
pub const MOST_PIXELS: usize = 2048 * 2048;

/// How many numbers `Page::probe` gives, in the order of `PROBE` in `page.js`.
pub const PROBE: usize = 57;

pub struct Page {
    pub settings: [f32; SETTINGS],
    /// The visible points, for the few sizes that the page draws.
    views: Vec<View>,
    pixels: Vec<u8>,
    probe: [f32; PROBE],
    message: &'static str,
}

/// The points of one surface in one size: they change with neither the material nor the lamp.
struct View {
    surface: Surface,
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
                let view = view(&mut self.views, surface(&self.settings), [width, height]);
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
            let view = view(&mut self.views, surface(&self.settings), [width, height]);
            let pixel = y * width + x;
            if let Ok(found) = view
                .points
                .binary_search_by_key(&pixel, |point| point.pixel)
            {
                self.probe = numbers(&Scene::new(&self.settings), &view.points[found]);
            }
        }
        &self.probe
    }

    /// Where in the picture a lamp is, or outside of the picture if it is off or behind the eye.
    #[must_use]
    pub fn lamp(&self, index: usize, width: usize, height: usize) -> [f32; 2] {
        let projected = self
            .position(index)
            .and_then(|position| Camera::new(width, height).project(position));
        projected.map_or([-1.0; 2], |at| [at.x, at.y])
    }

    /// Where a lamp would be in space if it were moved in the picture and kept its depth. A lamp
    /// that is off stays at 0.
    #[must_use]
    pub fn moved(&self, index: usize, width: usize, height: usize, to: [f32; 2]) -> [f32; 3] {
        let position = self.position(index);
        position.map_or([0.0; 3], |position| {
            Camera::new(width, height).moved(position, to).into()
        })
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
fn view(views: &mut Vec<View>, surface: Surface, size: [usize; 2]) -> &View {
    let known = views
        .iter()
        .position(|view| view.surface == surface && view.size == size);
    let index = known.unwrap_or_else(|| {
        if views.len() == 4 {
            views.remove(0);
        }
        views.push(View::new(surface, size));
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
        let mut lights = scene.lamps.iter().flatten().map(|lamp| lamp.at(point.p));
        lights.any(|light| light.is_in_front(point.n) && light.intensity() != Rgb::BLACK)
    };
    if points.iter().any(is_lit) {
        ""
    } else if scene.lamps[1].is_some() {
        "The lamps light nothing that is seen."
    } else if lamp.point.position == EYE {
        "The lamp is at the eye, and its cone misses what is seen."
    } else {
        "The lamp lights nothing that is seen: it is black, inside or behind the surface, or its cone is too narrow."
    }
}

impl View {
    fn new(surface: Surface, size: [usize; 2]) -> Self {
        let points = surface.seen_by(&Camera::new(size[0], size[1]));
        Self {
            surface,
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
    for lamp in scene.lamps.into_iter().flatten() {
        let incident = lamp.at(p).arrival();
        let (l, q) = (incident.l, incident.distance);
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
        put(&[lamp.point.attenuation.at(q), lamp.cone.factor(lamp.axis, l)]);
    }
    numbers
}
