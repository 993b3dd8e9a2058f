//! Everything that the crate computes with `f32`, over a fixed set of inputs, in one number that
//! changes with any bit of any result.

mod cases;
mod fnv;

use cases::{DISTANCES, Numbers, REAL, WHOLE};
pub use fnv::Fnv;
use shading::{
    Attenuation, Dual, Elementary, Exponent, Light, PointLight, Real, Rgb, UnitVec3, Vec3,
    attenuation, half_vector, normal, reflection, shade, term,
};

use crate::scene::{AMBIENT, LIGHTS, brass};
use crate::{broken, picture};

/// The digest of [`single_precision`], of the [`picture`] for a display, and of the angles, which
/// `libm` computes in doubles.
#[must_use]
pub fn everything() -> u64 {
    let mut digest = Fnv(single_precision());
    picture::absorb(&mut digest);
    angles(&mut digest);
    digest.0
}

/// The digest of all that promises to link no routine for doubles.
#[must_use]
pub fn single_precision() -> u64 {
    let mut digest = Fnv::EMPTY;
    shaded_points(&mut digest);
    degenerate_points(&mut digest);
    terms(&mut digest);
    powers(&mut digest);
    colors(&mut digest);
    digest.absorb(broken::promise(0.0));
    digest.0
}

/// 2,048 points under all kinds of light, with normals from every constructor, shaded by every
/// model with whole and with real shininess.
fn shaded_points(digest: &mut Fnv) {
    let mut numbers = Numbers(1);
    let exponents = || WHOLE.into_iter().zip(REAL).cycle();
    for (i, (whole, real)) in (0..2048).zip(exponents()) {
        let p = numbers.vector(4.0);
        let v = numbers.vector(1.0).unit_or(UnitVec3::Z);
        let n = any_normal(i, p, &mut numbers);
        digest.absorb(n);
        shaded(digest, n.unwrap_or(UnitVec3::Z), v, p, whole, real);
    }
}

/// A normal by the i-th of the constructors, in turn.
fn any_normal(i: u32, p: Vec3<f32>, numbers: &mut Numbers) -> Option<UnitVec3<f32>> {
    let a = numbers.vector(2.0);
    let b = numbers.vector(2.0);
    match i % 10 {
        0 => normal::plane(a.x, a.y, a.z),
        1 => normal::triangle(p, a, b),
        2 => normal::triangle(p, p + a * 1e-3, p + a * (1e-3 + 1e-9)), // a sliver
        3 => normal::sphere(a, p),
        4 => normal::implicit(torus, p),
        5 => normal::implicit(blobs, p),
        6 => normal::parametric(saddle, a.x, a.y),
        7 => normal::from_gradient(a),
        8 => normal::from_tangents(a, b),
        _ => Some(a.unit_or(UnitVec3::X)),
    }
}

fn torus<T: Real>(p: Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

fn blobs<T: Elementary>(p: Vec3<T>) -> T {
    let blob = |x: T| {
        let offset = p - Vec3::new(x, T::ZERO, T::ONE);
        (-offset.dot(offset)).exp()
    };
    blob(-T::ONE) + blob(T::ONE) + (p.z.abs() + T::ONE).ln() - p.x.powi(3)
}

fn saddle<T: Real>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u, v, u * u - v * v)
}

/// What every model returns at a point, and what arrives of every light there.
fn shaded(
    digest: &mut Fnv,
    n: UnitVec3<f32>,
    v: UnitVec3<f32>,
    p: Vec3<f32>,
    whole: u32,
    real: f32,
) {
    let (whole, real) = (&brass(whole), &brass(real));
    let lights = || LIGHTS.iter().map(|light| light.at(p));
    lights().for_each(|incident| digest.absorb(incident));
    digest.absorb(shade::lambert(n, whole, AMBIENT, lights()));
    digest.absorb(shade::phong(n, v, whole, AMBIENT, lights()));
    digest.absorb(shade::phong(n, v, real, AMBIENT, lights()));
    digest.absorb(shade::blinn_phong(n, v, whole, AMBIENT, lights()));
    let shaded = shade::blinn_phong(n, v, real, AMBIENT, lights());
    digest.absorb(shaded);
    digest.absorb(shaded.total().clamped());
}

/// Points at the light, next to it, out of all bounds, opposite the eye, at grazing incidence.
fn degenerate_points(digest: &mut Fnv) {
    let axes = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z, -UnitVec3::Z];
    for distance in DISTANCES {
        for axis in axes {
            let p = *axis * distance;
            digest.absorb(p.unit());
            digest.absorb(normal::triangle(Vec3::ZERO, p, *UnitVec3::Y * distance));
            for n in axes {
                shaded(digest, n, axis, p, 0, 0.0);
                shaded(digest, n, -axis, p, 32, 32.5);
                beside_lamps(digest, n, axis, p);
            }
        }
    }
}

/// Lamps that are dark, as bright as a number can be, or not attenuated as one would, at the
/// origin, and so at any distance from the point: also none.
fn beside_lamps(digest: &mut Fnv, n: UnitVec3<f32>, v: UnitVec3<f32>, p: Vec3<f32>) {
    let inverse_square = Attenuation::<f32>::new(0.0, 0.0, 1.0).unwrap_or(Attenuation::NONE);
    let lamps = [
        (0.0, inverse_square),
        (f32::MAX, inverse_square),
        (f32::MAX, Attenuation::NONE),
        (1.0, inverse_square.clamped()),
    ]
    .map(|(intensity, attenuation)| PointLight {
        position: Vec3::ZERO,
        intensity: Rgb::gray(intensity),
        attenuation,
    });
    for lamp in lamps {
        let light = Light::Point(lamp);
        digest.absorb(shade::blinn_phong(n, v, &brass(3), AMBIENT, [light.at(p)]));
    }
}

/// The factors by themselves.
fn terms(digest: &mut Fnv) {
    let mut numbers = Numbers(2);
    for (whole, real) in WHOLE.into_iter().zip(REAL) {
        digest.absorb(term::phong_normalization::<f32, _>(whole));
        digest.absorb(term::phong_normalization::<f32, _>(real));
        digest.absorb(term::blinn_normalization::<f32, _>(whole));
        digest.absorb(term::blinn_normalization::<f32, _>(real));
    }
    for (whole, real) in WHOLE.into_iter().zip(REAL).cycle().take(256) {
        let [n, l, v] = [(); 3].map(|()| numbers.vector(1.0).unit_or(UnitVec3::Z));
        let r = reflection(n, l);
        digest.absorb(r);
        digest.absorb(term::lambert(n, l));
        digest.absorb(term::phong(r, v, whole));
        digest.absorb(term::phong(r, v, real));
        digest.absorb(half_vector(l, v));
        digest.absorb(half_vector(l, -l));
        let h = half_vector(l, v).unwrap_or(v);
        digest.absorb(term::blinn(n, h, whole));
        digest.absorb(term::blinn(n, h, real));
        let c = numbers.vector(1.0);
        digest.absorb(attenuation(c.x * c.x, c.y * c.y, c.z * c.z, real));
    }
}

/// Colors of any bits, encoded, and all bytes decoded.
fn colors(digest: &mut Fnv) {
    let bits = |i: u32| f32::from_bits(i.wrapping_mul(0x9E37_79B9)); // 2³² divided by the golden ratio
    for i in 0..4096 {
        let color = Rgb::new(bits(3 * i), bits(3 * i + 1), bits(3 * i + 2));
        for color in [color, color.clamped(), Rgb::gray(i as f32 / 4096.0)] {
            let [r, g, b] = color.to_srgb8();
            digest.bits(u32::from_le_bytes([r, g, b, 0]));
            digest.bits(color.to_rgb565().into());
        }
    }
    for byte in 0..=255 {
        digest.absorb(Rgb::from_srgb8([byte, 255 - byte, byte / 2]));
    }
}

/// Powers over the whole range of cosines and of shininess.
fn powers(digest: &mut Fnv) {
    for i in 0..=256_u16 {
        let near_one = 1.0 - f32::from(i) * f32::EPSILON;
        for cosine in [f32::from(i) / 256.0, near_one, near_one * 1e-30] {
            for whole in WHOLE {
                digest.absorb(whole.raise(cosine));
                digest.absorb(whole.raise_root(cosine));
            }
            for real in REAL {
                digest.absorb(real.raise(cosine));
                digest.absorb(real.raise_root(cosine));
            }
        }
    }
}

/// The normals of surfaces that are written with sine and cosine.
fn angles(digest: &mut Fnv) {
    let mut numbers = Numbers(3);
    for _ in 0..64 {
        let p = numbers.vector(4.0);
        digest.absorb(normal::implicit(gyroid, p));
        digest.absorb(normal::parametric(globe, p.x, p.y));
    }
}

fn gyroid<T: Elementary>(p: Vec3<T>) -> T {
    p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos()
}

fn globe(u: Dual<f32>, v: Dual<f32>) -> Vec3<Dual<f32>> {
    Vec3::new(u.cos() * v.cos(), u.sin() * v.cos(), v.sin())
}
