//! A low-poly bunny, each triangle in the color of its own normal, on a display that keeps its pixels
//! itself: far triangles first, and no frame buffer in the chip.
#![no_std]

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::prelude::{DrawTarget, Drawable, OriginDimensions, Point, Primitive, Size};
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle, Triangle};
use shading::f32::{
    Attenuation, DirectionalLight, Light, Material, PointLight, Rgb, UnitVec3, Vec3,
};
use shading::{normal, shade};

#[allow(clippy::unreadable_literal)]
mod bunny {
    use shading::f32::Vec3;
    include!(concat!(env!("OUT_DIR"), "/bunny.rs"));
}

pub use bunny::{FACES, VERTICES};

pub const WIDTH: u32 = 160;
pub const HEIGHT: u32 = 128;

/// x points to the right, y up, and z to the eye, which is far away.
static LIGHTS: [Light; 2] = [
    Light::Directional(DirectionalLight {
        l: UnitVec3::new(0.48, 0.64, 0.6).unwrap(),
        intensity: Rgb::new(1.0, 0.95, 0.9),
    }),
    Light::Point(PointLight {
        position: Vec3::new(-2.0, 0.5, 1.0),
        intensity: Rgb::new(0.2, 0.35, 0.7),
        attenuation: Attenuation::new(0.3, 0.0, 0.2).unwrap(),
    }),
];

static STONE: Material = Material {
    k_a: Rgb::gray(0.6),
    k_d: Rgb::new(0.7, 0.6, 0.5),
    k_s: Rgb::gray(0.15),
    m: 8,
};

static SURROUNDINGS: Rgb = Rgb::gray(0.1);

// glue
fn rgb565(light: Rgb) -> Rgb565 {
    RawU16::new(light.to_rgb565()).into()
}
fn on_screen(p: Vec3) -> Point {
    let place =
        |along: f32, pixels: u32| ((along * 61.0) as i32).clamp(-9999, 9999) + pixels as i32 / 2;
    Point::new(place(p.x, WIDTH), place(-p.y, HEIGHT))
}
// end of glue

/// How far the bunny has turned about its axis: the cosine and the sine of the angle.
#[derive(Clone, Copy)]
pub struct Turn(pub f32, pub f32);

/// The bunny of the gallery, turned.
///
/// # Errors
///
/// Those of the display.
pub fn draw_bunny<D: DrawTarget<Color = Rgb565>>(
    display: &mut D,
    Turn(cosine, sine): Turn,
) -> Result<(), D::Error> {
    let turned =
        VERTICES.map(|p| Vec3::new(cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x));
    draw(display, &turned, &FACES)
}

/// The most triangles of a model that are drawn: more do not fit in the memory.
pub const MOST: usize = 600;

/// Draws any model. It leaves out triangles with a missing vertex, those without an area, and those
/// beyond [`MOST`].
///
/// # Errors
///
/// Those of the display.
pub fn draw<D: DrawTarget<Color = Rgb565>>(
    display: &mut D,
    vertices: &[Vec3],
    faces: &[[u16; 3]],
) -> Result<(), D::Error> {
    display.clear(rgb565(Rgb::gray(0.01)))?;
    // its depth, which grows toward the eye, and its index
    let mut visible = [(0_i16, 0_u32); MOST];
    let mut count = 0;
    for (&face, i) in faces.iter().zip(0..) {
        let Some([a, b, c]) = corners(vertices, face) else {
            continue;
        };
        // turned to the eye: counter-clockwise, where y is downward
        let [p, q, r] = [a, b, c].map(on_screen);
        if (q - p).x * (r - p).y - (q - p).y * (r - p).x < 0 && count < MOST {
            visible[count] = (((a.z + b.z + c.z) * 4096.0) as i16, i);
            count += 1;
        }
    }
    visible[..count].sort_unstable();
    for &(_, i) in &visible[..count] {
        let Some([a, b, c]) = corners(vertices, faces[i as usize]) else {
            continue;
        };
        let Some(n) = normal::triangle(a, b, c) else {
            continue;
        };
        let center = (a + b + c) * (1.0 / 3.0);
        let lights = LIGHTS.iter().filter_map(|light| light.in_front(center, n));
        let shaded = shade::blinn_phong(n, UnitVec3::Z, &STONE, SURROUNDINGS, lights);
        Triangle::new(on_screen(a), on_screen(b), on_screen(c))
            .into_styled(PrimitiveStyle::with_fill(rgb565(shaded.total())))
            .draw(display)?;
    }
    Ok(())
}

fn corners(vertices: &[Vec3], face: [u16; 3]) -> Option<[Vec3; 3]> {
    let [a, b, c] = face.map(|i| vertices.get(usize::from(i)).copied());
    Some([a?, b?, c?])
}

/// A display that passes on each rectangle of one color, as drivers send it to the panel.
pub struct Panel<F>(pub F);

impl<F> OriginDimensions for Panel<F> {
    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT)
    }
}

impl<F: FnMut(Rectangle, u16)> DrawTarget for Panel<F> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            self.fill_solid(&Rectangle::new(at, Size::new(1, 1)), color)?;
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        let inside = area.intersection(&Rectangle::new(Point::zero(), self.size()));
        if inside.size != Size::zero() {
            (self.0)(inside, RawU16::from(color).into_inner());
        }
        Ok(())
    }
}
