//! A turning ring of 400 triangles under two lamps, in fixed point, on a chip that cannot shade
//! every pixel. It shades the 200 corners and interpolates their colors (Gouraud shading). It draws
//! in strips of eight rows, so it needs no frame buffer: a chip with 16 KB of RAM suffices. For
//! another mesh, replace the two tables.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Point, Size};
use embedded_graphics::primitives::Rectangle;
use shading::fixed::{Attenuation, Fixed, Material, PointLight, Rgb, UnitVec3, Vec3};
use shading::shade;

/// x points to the right, y up, and z to the eye, which is far away; the ring's center is the origin.
static LAMPS: [PointLight; 2] = [
    lamp([2.0, 2.5, 3.0], [1.0, 0.95, 0.85]),
    lamp([-3.0, -1.0, 0.5], [0.1, 0.25, 0.9]),
];

static BRASS: Material = Material {
    k_a: color([0.78, 0.57, 0.11]),
    k_d: color([0.78, 0.57, 0.11]),
    k_s: color([0.6, 0.55, 0.45]),
    m: 24,
};

static SURROUNDINGS: Rgb = color([0.05, 0.05, 0.07]);

/// The mesh: each corner's position and normal, and each triangle's corners, counterclockwise as
/// seen from outside.
static CORNERS: [(Vec3, UnitVec3); AROUND * TUBE] = corners();
static TRIANGLES: [[u8; 3]; 2 * AROUND * TUBE] = triangles();

const AROUND: usize = 20;
const TUBE: usize = 10;
const RADIUS: f64 = 0.95;
const THICKNESS: f64 = 0.38;

const fn number(literal: f64) -> Fixed {
    Fixed::new(literal)
}

const fn color([r, g, b]: [f64; 3]) -> Rgb {
    Rgb::new(number(r), number(g), number(b))
}

const fn lamp([x, y, z]: [f64; 3], intensity: [f64; 3]) -> PointLight {
    PointLight {
        position: Vec3::new(number(x), number(y), number(z)),
        intensity: color(intensity),
        attenuation: Attenuation::const_new(number(0.5), number(0.0), number(0.03)).unwrap(),
    }
}

/// How many steps make a full turn.
pub const STEPS: usize = 80;

/// The cosine and the sine of each step. The compiler computes them, so the chip links no trigonometry.
const CIRCLE: [[f64; 2]; STEPS] = {
    let [a, b] = [0.996_917_333_733_128, 0.078_459_095_727_844_94]; // of 4.5°
    let (mut circle, mut i) = ([[1.0, 0.0]; STEPS], 1);
    while i < STEPS {
        let [cosine, sine] = circle[i - 1];
        circle[i] = [a * cosine - b * sine, a * sine + b * cosine];
        i += 1;
    }
    circle
};

static TURNS: [[Fixed; 2]; STEPS] = {
    let (mut turns, mut i) = ([[Fixed::STEP; 2]; STEPS], 0);
    while i < STEPS {
        turns[i] = [number(CIRCLE[i][0]), number(CIRCLE[i][1])];
        i += 1;
    }
    turns
};

const fn corners() -> [(Vec3, UnitVec3); AROUND * TUBE] {
    let x = UnitVec3::const_new(number(1.0), number(0.0), number(0.0)).unwrap();
    let mut corners = [(Vec3::new(number(0.0), number(0.0), number(0.0)), x); AROUND * TUBE];
    let mut i = 0;
    while i < AROUND * TUBE {
        let [around, along] = CIRCLE[i / TUBE * (STEPS / AROUND)];
        let [out, up] = CIRCLE[i % TUBE * (STEPS / TUBE)];
        let r = RADIUS + THICKNESS * out;
        let p = Vec3::new(
            number(r * around),
            number(r * along),
            number(THICKNESS * up),
        );
        let (x, y, z) = (number(out * around), number(out * along), number(up));
        corners[i] = (p, UnitVec3::const_new(x, y, z).unwrap());
        i += 1;
    }
    corners
}

/// Two triangles between each corner, the next one around the ring and the next ones around the tube.
const fn triangles() -> [[u8; 3]; 2 * AROUND * TUBE] {
    let (mut triangles, mut i) = ([[0; 3]; 2 * AROUND * TUBE], 0);
    while i < AROUND * TUBE {
        let up = i / TUBE * TUBE + (i + 1) % TUBE;
        let [on, on_and_up] = [(i + TUBE) % (AROUND * TUBE), (up + TUBE) % (AROUND * TUBE)];
        triangles[2 * i] = [i as u8, on as u8, on_and_up as u8];
        triangles[2 * i + 1] = [i as u8, on_and_up as u8, up as u8];
        i += 1;
    }
    triangles
}

/// The width of the picture is limited so that a strip takes no more than 7,680 bytes.
const WIDTH: usize = 240;
const ROWS: usize = 8;

/// Draws the ring after so many steps of its turn, as large as the display allows.
///
/// # Errors
///
/// Returns the errors of the display.
pub fn draw<D>(display: &mut D, step: usize) -> Result<(), D::Error>
where
    D: DrawTarget<Color = Rgb565> + OriginDimensions,
{
    let Size { width, height } = display.size();
    let (width, height) = ((width as i32).min(WIDTH as i32), height as i32);
    let mut corners = [Corner::default(); CORNERS.len()];
    for (corner, &(p, n)) in corners.iter_mut().zip(&CORNERS) {
        *corner = Corner::new(p, n, TURNS[step % STEPS], [width, height]);
    }
    let mut strip = Strip {
        top: 0,
        width,
        pixels: &mut [Pixel::BEHIND; WIDTH * ROWS],
    };
    let mut facing = [0u16; TRIANGLES.len()];
    let mut count = 0;
    for (i, triangle) in TRIANGLES.iter().enumerate() {
        let [a, b, c] = triangle.map(|i| &corners[usize::from(i)]);
        facing[count] = i as u16;
        count += usize::from((b.x - a.x) * (a.y - c.y) - (c.x - a.x) * (a.y - b.y) >= 64);
    }
    while strip.top < height {
        for &i in &facing[..count] {
            strip.draw(TRIANGLES[usize::from(i)].map(|i| &corners[usize::from(i)]));
        }
        let rows = (height - strip.top).min(ROWS as i32);
        let area = Rectangle::new(
            Point::new(0, strip.top),
            Size::new(width as u32, rows as u32),
        );
        let pixels = &mut strip.pixels[..(rows * width) as usize];
        let colors = pixels
            .iter()
            .map(|pixel| Rgb565::from(RawU16::new(pixel.color)));
        display.fill_contiguous(&area, colors)?;
        pixels.fill(Pixel::BEHIND);
        strip.top += rows;
    }
    Ok(())
}

/// A corner as it is drawn: x to the right and y down, in sixteenths of a pixel, and what is interpolated.
#[derive(Clone, Copy, Default)]
struct Corner {
    x: i32,
    y: i32,
    /// The levels of red, green and blue in RGB565, times 256, and the depth.
    values: [i32; 4],
}

impl Corner {
    /// Turns a corner about the y axis and leans it toward the eye; shades it; and places it on the display.
    fn new(p: Vec3, n: UnitVec3, [cosine, sine]: [Fixed; 2], [width, height]: [i32; 2]) -> Self {
        const LEAN: [Fixed; 2] = [number(0.8), number(0.6)];
        const SHARE: Fixed = number(0.34);
        let turned = |v: Vec3| {
            let (x, z) = (cosine * v.x + sine * v.z, cosine * v.z - sine * v.x);
            Vec3::new(x, LEAN[0] * v.y - LEAN[1] * z, LEAN[1] * v.y + LEAN[0] * z)
        };
        let (p, n) = (turned(p), UnitVec3::assume_unit(turned(*n)));
        let lights = LAMPS.iter().map(|lamp| lamp.at(p));
        let light = shade::blinn_phong(n, UnitVec3::Z, &BRASS, SURROUNDINGS, lights).total();
        let scale = Fixed::from(width.min(height) as i16) * SHARE;
        let sixteenths = |x: Fixed| (x * scale).to_bits() >> 12;
        // Encoded levels are interpolated, which saves an encoding for each pixel. Half a level is
        // added, so that the fraction can be cut off.
        let [r, g, b] = light.to_srgb8().map(i32::from);
        let level = |byte, levels| (byte * levels * 256 + 127) / 255 + 128;
        Self {
            x: width * 8 + sixteenths(p.x),
            y: height * 8 - sixteenths(p.y),
            values: [level(r, 31), level(g, 63), level(b, 31), p.z.to_bits() >> 7],
        }
    }
}

#[derive(Clone, Copy)]
struct Pixel {
    color: u16,
    depth: i16,
}

impl Pixel {
    const BEHIND: Self = Self {
        color: 0x0841,
        depth: i16::MIN,
    };
}

/// Some rows of the picture.
struct Strip<'a> {
    top: i32,
    width: i32,
    pixels: &'a mut [Pixel],
}

/// What is linear in a triangle: its value at a pixel, and how it changes to the right and down.
#[derive(Clone, Copy)]
struct Linear {
    value: i32,
    right: i32,
    down: i32,
}

impl Strip<'_> {
    /// Draws the pixels of a triangle in this strip whose centers are inside it and nearer than
    /// what was drawn before.
    fn draw(&mut self, [a, b, c]: [&Corner; 3]) {
        // pixels by their centers
        let pixels = |[a, b, c]: [i32; 3]| (a.min(b).min(c) + 7) >> 4..(a.max(b).max(c) + 8) >> 4;
        let rows = pixels([a.y, b.y, c.y]);
        let rows = rows.start.max(self.top)..rows.end.min(self.top + ROWS as i32);
        if rows.is_empty() {
            return;
        }
        let area = (b.x - a.x) * (a.y - c.y) - (c.x - a.x) * (a.y - b.y);
        let columns = pixels([a.x, b.x, c.x]);
        let columns = columns.start.max(0)..columns.end.min(self.width);
        if rows.is_empty() || columns.is_empty() || area < 64 {
            return; // elsewhere; turned away, or smaller than an eighth of a pixel
        }
        let (x, y) = (columns.start * 16 + 8, rows.start * 16 + 8);

        // how far a pixel is from an edge: the weight of the corner on the other side, times the area
        let weight = |from: &Corner, to: &Corner| Linear {
            value: (x - from.x) * (to.y - from.y) - (y - from.y) * (to.x - from.x),
            right: 16 * (to.y - from.y),
            down: 16 * (from.x - to.x),
        };
        let mut weights = [weight(b, c), weight(c, a), weight(a, b)];
        let mut values = [0, 1, 2, 3].map(|i| {
            let sum = |change: fn(&Linear) -> i32| {
                let [u, v, w] = &weights;
                (change(u) * a.values[i] + change(v) * b.values[i] + change(w) * c.values[i]) / area
            };
            let (right, down) = (sum(|w| w.right), sum(|w| w.down));
            let value = a.values[i] + ((right * (x - a.x) + down * (y - a.y)) >> 4);
            Linear { value, right, down }
        });

        for row in rows {
            // the pixels of the row that are inside
            let [mut u, mut v, mut w] = weights.map(|weight| weight.value);
            let mut take_steps = |is_inside: bool, most: i32| {
                let mut steps = 0;
                while steps < most && ((u | v | w) >= 0) == is_inside {
                    u += weights[0].right;
                    v += weights[1].right;
                    w += weights[2].right;
                    steps += 1;
                }
                steps
            };
            let skipped = take_steps(false, columns.len() as i32);
            let inside = take_steps(true, columns.len() as i32 - skipped);

            let start = ((row - self.top) * self.width + columns.start + skipped) as usize;
            let [mut r, mut g, mut b, mut depth] = values.map(|v| v.value + v.right * skipped);
            for pixel in &mut self.pixels[start..start + inside as usize] {
                if depth > i32::from(pixel.depth) {
                    let color = ((r >> 8 << 11) | (g >> 8 << 5) | (b >> 8)) as u16;
                    let depth = depth as i16;
                    *pixel = Pixel { color, depth };
                }
                r += values[0].right;
                g += values[1].right;
                b += values[2].right;
                depth += values[3].right;
            }

            for linear in weights.iter_mut().chain(&mut values) {
                linear.value += linear.down;
            }
        }
    }
}
