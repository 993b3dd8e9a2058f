//! A turning ball under two lamps, drawn pixel by pixel in the order in which the display takes
//! them: no frame buffer, no line buffer, no trigonometry.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Point, Size};
use embedded_graphics::primitives::Rectangle;
use shading::{Attenuation, Material, PointLight, Real, Rgb, UnitVec3, Vec3, shade};

/// x points to the right, y up, and z to the eye; the ball has radius 1 and its center at the
/// origin.
static LAMPS: [PointLight<f32>; 2] = [
    PointLight {
        position: Vec3::new(2.0, 2.5, 3.0),
        intensity: Rgb::new(1.0, 0.95, 0.85),
        attenuation: Attenuation::<f32>::new(0.5, 0.0, 0.03).unwrap(),
    },
    PointLight {
        position: Vec3::new(-3.0, -1.0, 0.5),
        intensity: Rgb::new(0.1, 0.2, 0.6),
        attenuation: Attenuation::<f32>::new(0.5, 0.0, 0.03).unwrap(),
    },
];

static SURROUNDINGS: Rgb<f32> = Rgb::new(0.05, 0.05, 0.07);

/// The paint on the ball multiplies the ambient and the diffuse part.
static LACQUER: Material<f32, u32> = Material {
    k_a: Rgb::WHITE,
    k_d: Rgb::WHITE,
    k_s: Rgb::gray(0.35),
    m: 40,
};

static RED: Rgb<f32> = Rgb::new(0.75, 0.05, 0.04);
static CREAM: Rgb<f32> = Rgb::new(0.85, 0.75, 0.55);

/// How far the ball has turned about its axis: the cosine and the sine of the angle.
#[derive(Clone, Copy)]
pub struct Turn(f32, f32);

impl Turn {
    /// The ball has not turned yet.
    pub const NONE: Self = Self(1.0, 0.0);

    /// Turns further by the angle of the Pythagorean triple 7, 24, 25, which is 16.26°.
    #[must_use]
    pub fn next(self) -> Self {
        let Self(cosine, sine) = self;
        Self(0.96 * cosine - 0.28 * sine, 0.96 * sine + 0.28 * cosine)
    }
}

/// Draws the ball row by row, as large as the display allows.
///
/// # Errors
///
/// Returns the errors of the display.
pub fn draw<D>(display: &mut D, turn: Turn) -> Result<(), D::Error>
where
    D: DrawTarget<Color = Rgb565> + OriginDimensions,
{
    let Size { width, height } = display.size();
    let radius = 0.46 * width.min(height) as f32;
    let center = (0.5 * width as f32, 0.5 * height as f32);
    for row in 0..height {
        let y = (center.1 - row as f32 - 0.5) / radius;
        let colors = (0..width).map(|column| {
            let x = (column as f32 + 0.5 - center.0) / radius;
            let light = ball(x, y, turn).unwrap_or(Rgb::gray(0.01));
            Rgb565::from(RawU16::new(light.to_rgb565()))
        });
        let line = Rectangle::new(Point::new(0, row as i32), Size::new(width, 1));
        display.fill_contiguous(&line, colors)?;
    }
    Ok(())
}

/// The light from the point of the ball at (x, y) to the eye, which is far away; `None` outside the
/// ball.
fn ball(x: f32, y: f32, turn: Turn) -> Option<Rgb<f32>> {
    let z_squared = 1.0 - x * x - y * y;
    if z_squared < 0.0 {
        return None;
    }
    let p = Vec3::new(x, y, Real::sqrt(z_squared));
    let n = UnitVec3::assume_unit(p); // on a ball of radius 1, p is the normal
    let lights = LAMPS.iter().filter_map(|lamp| lamp.in_front(p, n));
    let shaded = shade::blinn_phong(n, UnitVec3::Z, &LACQUER, SURROUNDINGS, lights);
    Some((shaded.ambient + shaded.diffuse) * painted(p, turn) + shaded.specular)
}

/// Eight fields, alternately red and cream, as the coordinate planes divide a ball that is turned
/// about its axis. The axis leans by the angle of the triple 3, 4, 5.
fn painted(p: Vec3<f32>, Turn(cosine, sine): Turn) -> Rgb<f32> {
    let (x, y) = (0.8 * p.x + 0.6 * p.y, 0.8 * p.y - 0.6 * p.x);
    let (x, z) = (cosine * x + sine * p.z, cosine * p.z - sine * x);
    if x * y * z > 0.0 { RED } else { CREAM }
}
