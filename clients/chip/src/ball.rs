//! A turning ball under two lamps, drawn pixel by pixel in the order in which the display takes
//! them: no frame buffer, no line buffer, no trigonometry.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Point, Size};
use embedded_graphics::primitives::Rectangle;
use shading::{Real, shade};

#[cfg(not(feature = "fixed"))]
use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
#[cfg(feature = "fixed")]
use shading::fixed::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};

#[cfg(not(feature = "fixed"))]
type Number = f32;
#[cfg(feature = "fixed")]
type Number = shading::fixed::Fixed;

const fn number(literal: f64) -> Number {
    #[cfg(not(feature = "fixed"))]
    return literal as f32;
    #[cfg(feature = "fixed")]
    return Number::new(literal);
}

/// x points to the right, y up, and z to the eye; the ball has radius 1 and its center at the
/// origin.
static LAMPS: [PointLight; 2] = [
    PointLight {
        position: vector(2.0, 2.5, 3.0),
        intensity: color(1.0, 0.95, 0.85),
        attenuation: FALLOFF,
    },
    PointLight {
        position: vector(-3.0, -1.0, 0.5),
        intensity: color(0.1, 0.2, 0.6),
        attenuation: FALLOFF,
    },
];

const FALLOFF: Attenuation =
    Attenuation::const_new(number(0.5), number(0.0), number(0.03)).unwrap();

static SURROUNDINGS: Rgb = color(0.05, 0.05, 0.07);

/// The paint on the ball multiplies the ambient and the diffuse part.
static LACQUER: Material = Material {
    k_a: Rgb::WHITE,
    k_d: Rgb::WHITE,
    k_s: color(0.35, 0.35, 0.35),
    m: 40,
};

static RED: Rgb = color(0.75, 0.05, 0.04);
static CREAM: Rgb = color(0.85, 0.75, 0.55);
static BEHIND: Rgb = color(0.01, 0.01, 0.01);

const fn vector(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(number(x), number(y), number(z))
}

const fn color(r: f64, g: f64, b: f64) -> Rgb {
    Rgb::new(number(r), number(g), number(b))
}

/// Pixels are placed on a ball of this radius, because fixed point divides it 64 times as finely as
/// a radius of 1. To floating point, a power of two makes no difference.
const RADIUS: f64 = 64.0;
const RADIUS_SQUARED: Number = number(RADIUS * RADIUS);

/// How far the ball has turned about its axis: the cosine and the sine of the angle, times 64.
#[derive(Clone, Copy)]
pub struct Turn(Number, Number);

impl Turn {
    /// The ball has not turned yet.
    pub const NONE: Self = Self(number(64.0), number(0.0));

    /// Turns further by the angle of the Pythagorean triple 7, 24, 25, which is 16.26°.
    #[must_use]
    pub fn next(self) -> Self {
        const TRIPLE: [Number; 3] = [number(7.0), number(24.0), number(25.0)];
        let (Self(cosine, sine), [a, b, c]) = (self, TRIPLE);
        Self((b * cosine - a * sine) / c, (b * sine + a * cosine) / c)
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
    // constants, because a chip would convert literals in double precision
    const HALF: Number = number(0.5);
    const SHARE: Number = number(23.0 / 50.0);
    const SCALE: Number = number(256.0 * RADIUS);
    const BACK: Number = number(1.0 / 256.0);
    let Size { width, height } = display.size();
    let pixels = |count: u32| Number::from(count as i16);
    let radius = SHARE * pixels(width.min(height));
    // by a factor 256 times as large and by 1/256, since RADIUS / radius alone would lose bits
    let scale = SCALE / radius;
    let center = (HALF * pixels(width), HALF * pixels(height));
    for row in 0..height {
        let y = (center.1 - pixels(row) - HALF) * scale * BACK;
        let colors = (0..width).map(|column| {
            let x = (pixels(column) + HALF - center.0) * scale * BACK;
            let light = ball(x, y, turn).unwrap_or(BEHIND);
            Rgb565::from(RawU16::new(light.to_rgb565()))
        });
        let line = Rectangle::new(Point::new(0, row as i32), Size::new(width, 1));
        display.fill_contiguous(&line, colors)?;
    }
    Ok(())
}

/// The light from the point of the ball at (x, y) to the eye, which is far away; `None` outside the
/// ball.
fn ball(x: Number, y: Number, turn: Turn) -> Option<Rgb> {
    const SHRUNK: Number = number(1.0 / 64.0);
    let z_squared = RADIUS_SQUARED - x * x - y * y;
    if z_squared < Number::ZERO {
        return None;
    }
    let large = Vec3::new(x, y, Real::sqrt(z_squared));
    let p = large * SHRUNK;
    let n = UnitVec3::assume_unit(p); // on a ball of radius 1, p is the normal
    let lights = LAMPS.iter().map(|lamp| lamp.at(p));
    let shaded = shade::blinn_phong(n, UnitVec3::Z, &LACQUER, SURROUNDINGS, lights);
    Some((shaded.ambient + shaded.diffuse) * painted(large, turn) + shaded.specular)
}

/// Eight fields, alternately red and cream, as the coordinate planes divide a ball that is turned
/// about its axis. The axis leans by the angle of the triple 3, 4, 5. Only signs count, so nothing
/// is divided by the lengths 5 and 64.
fn painted(p: Vec3, Turn(cosine, sine): Turn) -> Rgb {
    const TRIPLE: [Number; 3] = [number(3.0), number(4.0), number(5.0)];
    let [a, b, c] = TRIPLE;
    let (x, y, z) = (b * p.x + a * p.y, b * p.y - a * p.x, c * p.z);
    let (x, z) = (cosine * x + sine * z, cosine * z - sine * x);
    if x * y * z > Number::ZERO { RED } else { CREAM }
}
