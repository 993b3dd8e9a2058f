//! Everything that the crate computes, at the same places on every machine.

#[cfg(feature = "fixed")]
pub mod any_bits;
pub mod fnv;
pub mod given;

use shading::{
    Attenuation, Cone, Dual, Elementary, Exponent, Light, PointLight, Ranged, Real, Rgb, SoftCone,
    UnitVec3, Vec3, attenuation, half_vector, normal, reflection, shade, term,
};

use fnv::Each;
pub use fnv::Fnv;
pub use given::{Float, Number};
use given::{Given, places};

/// A function's name, and a function that digests its results at a place.
pub type Function<T> = (&'static str, fn(&Given<T>, &mut Fnv));

/// Digests the results of the functions at all places.
pub fn absorb<T: Number>(functions: &[Function<T>], digest: &mut Fnv) {
    for given in places() {
        for (_, absorb_results) in functions {
            absorb_results(&given, digest);
        }
    }
}

/// The shininess, as an integer and as a real number.
const INTEGER: [u32; 8] = [0, 1, 2, 5, 32, 33, 1000, u32::MAX];
const REAL: [f32; 8] = [0.0, 0.5, 1.0, 10.25, 32.0, 100.5, 1e4, f32::MAX];

/// The functions in one number type.
pub struct Of<T>(T);

macro_rules! functions {
    ($($(#[$doc:meta])* $list:ident: $bound:ident { $($name:literal: |$given:ident| $results:expr;)* })*) => {
        $(impl<T: $bound> Of<T> {
            $(#[$doc])* pub const $list: &[Function<T>] =
                &[$(($name, |$given, digest| digest.absorb($results))),*];
        })*
    };
}

functions! {
    /// One line per function.
    FUNCTIONS: Number {
        // numbers
        "Real::sqrt": |g| g.x.abs().sqrt();
        "Real::abs": |g| g.x.abs();
        "Real::if_positive": |g| g.x.if_positive(g.y, g.cosine);
        "Real::if_above": |g| g.x.if_above(g.y, g.cosine, g.x);
        "Real::at_least": |g| g.x.at_least(g.y);
        "Real::at_most": |g| g.x.at_most(g.y);
        "Real::any_positive": |g| g.x.any_positive();
        "Elementary::powi": |g| [-3, -1, 0, 1, 2, 7, 100].map(|i| g.x.powi(i));
        "Elementary::exp": |g| g.x.exp();
        "Elementary::ln": |g| g.x.abs().ln();
        "Exponent::raise, integer m": |g| INTEGER.map(|m| m.raise(g.cosine));

        // vectors and colors
        "Vec3, operators": |g| [g.a + g.b, g.a - g.b, g.a * g.x, g.x.times_vector(g.a), g.a / g.x, -g.a];
        "Vec3, assigned": |g| { let mut v = g.a; v += g.b; v *= g.x; v -= g.p; v };
        "Vec3::sum": |g| [[g.p, g.a, g.b].iter().sum::<Vec3<T>>(), [g.b, g.a, g.p].into_iter().sum()];
        "Vec3::dot": |g| [g.a.dot(g.b), g.a.dot(g.n)];
        "Vec3::cross": |g| [g.a.cross(g.b), g.a.cross(g.n)];
        "Vec3::length": |g| g.a.length();
        "Vec3::unit": |g| g.a.unit();
        "Vec3::unit_or": |g| g.a.unit_or(g.n);
        "UnitVec3::assume_unit": |g| -UnitVec3::assume_unit(g.a);
        "UnitVec3::new": |g| UnitVec3::of(g.n.x, g.n.y, g.n.z);
        "UnitVec3::normalized": |g| T::normalized(g.a);
        "Rgb, operators": |g| [g.rgb + g.k_a, g.rgb - g.k_a, g.rgb * g.k_a, g.rgb * g.x, g.x.times_rgb(g.rgb), g.rgb / g.x];
        "Rgb, assigned": |g| { let mut c = g.rgb; c += g.k_a; c *= g.x; c -= g.k_d; c };
        "Rgb::sum": |g| [[g.rgb, g.k_a, g.k_d].iter().sum::<Rgb<T>>(), [g.k_d, g.rgb, g.k_a].into_iter().sum()];
        "Rgb::gray": |g| Rgb::gray(g.x);
        "Rgb, encoded and decoded": |g| { let rgb = g.rgb.map(T::single); [Rgb::from_srgb8(rgb.to_srgb8()), Rgb::gray(rgb.to_rgb565().into())] };
        "Rgb::clamped": |g| (g.rgb - g.k_a).clamped();

        // dual numbers
        "Dual, operators": |g| [g.f + g.h, g.f - g.h, g.f * g.h, g.f / g.h, -g.f];
        "Dual, with a number": |g| [g.f + g.y, g.f - g.y, g.f * g.y, g.f / g.y];
        "Dual::chain": |g| g.f.chain(g.y, g.x);
        "Dual::sqrt": |g| g.f.abs().sqrt();
        "Dual::powi": |g| [-3, -1, 0, 1, 2, 7].map(|i| g.f.powi(i));
        "Dual::exp": |g| g.f.exp();
        "Dual::ln": |g| g.f.abs().ln();

        // normals
        "normal::plane": |g| normal::plane(g.a.x, g.a.y, g.a.z);
        "normal::triangle": |g| normal::triangle(g.p, g.a, g.b);
        "normal::triangle, slivers": |g| normal::triangle(g.p, g.p + g.a, g.p + g.a * g.cosine);
        "normal::sphere": |g| normal::sphere(g.a, g.p);
        "normal::implicit": |g| [normal::implicit(torus, g.p), normal::implicit(blobs, g.p)];
        "normal::from_gradient": |g| normal::from_gradient(g.a);
        "normal::parametric": |g| normal::parametric(saddle, g.x, g.y);
        "normal::from_tangents": |g| normal::from_tangents(g.a, g.b);
        "normal::facing": |g| normal::facing(g.n, g.v);
        "normal::transformed": |g| normal::transformed(g.n, [g.p, g.a, g.b]);
        "normal::corner": |g| normal::corner(g.p, g.a, g.b);
        "normal::mapped": |g| normal::mapped(g.n, g.a, g.cosine, g.b);

        // directions, terms, attenuation, cone
        "reflection": |g| reflection(g.n, g.l);
        "half_vector": |g| half_vector(g.l, g.v);
        "term::ambient": |g| term::ambient(g.k_a, g.rgb);
        "term::phong_normalization": |_g| REAL.map(|m| term::phong_normalization(T::of_f32(m)));
        "term::lambert": |g| term::lambert(g.n, g.l);
        "term::phong, integer m": |g| INTEGER.map(|m| term::phong(g.l, g.v, m));
        "term::blinn, integer m": |g| INTEGER.map(|m| term::blinn(g.n, g.v, m));
        "attenuation": |g| attenuation(g.a.x, g.a.y, g.a.z, g.x);
        "Attenuation::new": |g| Attenuation::of(g.x, g.y, g.cosine).map(Attenuation::coefficients);
        "Attenuation::is_clamped": |g| g.lamps.map(|lamp| lamp.attenuation.is_clamped());
        "Attenuation::at": |g| g.attenuation.at(g.x.abs());
        "Attenuation::clamped": |g| g.attenuation.clamped().at(g.x.abs());
        "Cone::from_cosine": |g| Cone::of_cosine(g.cosine + g.cosine - T::ONE).map(Cone::cosine);
        "Cone::factor": |g| Cone::of_cosine(g.cosine).map(|cone| cone.factor(g.n, g.l));
        "SoftCone::from_cosines": |g| SoftCone::of_cosines(g.cosine, -g.cosine).map(SoftCone::cosines);
        "SoftCone::factor": |g| SoftCone::of_cosines(g.cosine, -g.cosine).map(|cone| cone.factor(g.n, g.l));
        "SoftCone::smoothstep": |g| SoftCone::of_cosines(g.cosine, -g.cosine).map(|cone| cone.smoothstep().factor(g.n, g.l));
        "SoftCone::is_smoothstep": |g| SoftCone::of_cosines(g.cosine, -g.cosine).map(SoftCone::is_smoothstep);
        "Ranged, parts": |g| Ranged::of(g.attenuation, g.y.abs()).map(|ranged| [ranged.range(), ranged.attenuation().at(g.x.abs())]);
        "Ranged::at": |g| Ranged::of(g.attenuation, g.y.abs()).map(|ranged| ranged.at(g.x.abs()));

        // lights
        "IncidentLight::in_front": |g| g.lamps.map(|lamp| lamp.at(g.p).in_front(g.n));
        "DirectionalLight::at": |g| g.sun.at(g.p);
        "DirectionalLight::in_front": |g| g.sun.in_front(g.p, g.n);
        "PointLight::at": |g| g.lamps.map(|lamp| lamp.at(g.p));
        "PointLight::in_front": |g| g.lamps.map(|lamp| lamp.in_front(g.p, g.n));
        "PointLight::all_in_front": |g| Each(PointLight::all_in_front(&g.lamps, g.p, g.n));
        "SpotLight::at": |g| g.spot.at(g.p);
        "SpotLight::in_front": |g| g.spot.in_front(g.p, g.n);
        "SpotLight::at, soft and ranged": |g| g.soft_spot().map(|spot| spot.at(g.p));
        "SpotLight::in_front, soft and ranged": |g| g.soft_spot().map(|spot| spot.in_front(g.p, g.n));
        "Light::at": |g| g.lights().map(|light| light.at(g.p));
        "Light::in_front": |g| g.lights().map(|light| light.in_front(g.p, g.n));
        "Light::all_in_front": |g| Each(Light::all_in_front(&g.lights(), g.p, g.n));

        // sums over lights
        "shade::lambert": |g| shade::lambert(g.n, &g.material(0), g.rgb, g.arriving());
        "shade::phong, integer m": |g| shade::phong(g.n, g.v, &g.material(32), g.rgb, g.arriving());
        "shade::blinn_phong, even m": |g| shade::blinn_phong(g.n, g.v, &g.material(32), g.rgb, g.arriving());
        "shade::blinn_phong, odd m": |g| shade::blinn_phong(g.n, g.v, &g.material(33), g.rgb, g.arriving());
        "Shaded, operators": |g| [g.shaded() + g.shaded() * g.x, [g.shaded(), g.shaded()].into_iter().sum()];
        "Shaded::total": |g| g.shaded().total();

        // in another number type
        "PointLight::cast": |g| g.lamps[0].cast(Dual::constant).at(Dual::point(g.p));
    }

    /// Functions of a real shininess, and of a number before a dual number.
    OF_FLOATS: Float {
        "Exponent::raise, real m": |g| REAL.map(|m| T::from(m).raise(g.cosine));
        "Exponent::raise, invalid m": |g| [f32::INFINITY, -1.0, f32::NAN].map(|m| T::from(m).raise(g.cosine));
        "Exponent::raise, where the power vanishes": |g| [2, 5, 33, 1000, 10_000].map(|m| vanishing(m, g.cosine));
        "Exponent::raise, where all coefficients count": |g| Each((0_u8..32).map(|i| difficult(i, g.cosine)));
        "term::blinn_normalization": |_g| REAL.map(|m| term::blinn_normalization(T::from(m)));
        "Dual, after a number": |g| g.y.before(g.f);
        "term::phong, real m": |g| REAL.map(|m| term::phong(g.l, g.v, T::from(m)));
        "term::blinn, real m": |g| REAL.map(|m| term::blinn(g.n, g.v, T::from(m)));
        "shade::phong, real m": |g| shade::phong(g.n, g.v, &g.material(T::from(32.5)), g.rgb, g.arriving());
        "shade::blinn_phong, real m": |g| shade::blinn_phong(g.n, g.v, &g.material(T::from(32.5)), g.rgb, g.arriving());
    }

    /// Functions that use doubles internally in fixed point.
    HALF_ANGLES: Number {
        "Cone::from_half_angle": |g| Cone::of_half_angle(g.cosine * T::of_f32(3.25)).map(Cone::cosine);
        "SoftCone::from_half_angles": |g| SoftCone::of_half_angles(g.cosine, g.cosine * T::of_f32(3.0)).map(SoftCone::cosines);
    }

    /// Functions for which `libm` uses doubles internally.
    ANGLES: Number {
        "Elementary::sin": |g| g.x.sin();
        "Elementary::cos": |g| g.x.cos();
        "Dual::sin": |g| g.f.sin();
        "Dual::cos": |g| g.f.cos();
        "normal::implicit, with angles": |g| normal::implicit(gyroid, g.p);
        "normal::parametric, with angles": |g| normal::parametric(globe, g.x, g.y);
    }
}

/// A power close to the smallest normal number, below which it becomes 0.
fn vanishing<T: Float>(m: u16, share: T) -> T {
    let power = T::from(126.0) + share * T::from(4.0);
    u32::from(m).raise((power / T::from(m.into())).raise(T::from(0.5)))
}

/// A power of a cosine next to √½ by an odd m: there the series of the logarithm and of the
/// exponential have their largest arguments.
fn difficult<T: Float>(i: u8, share: T) -> T {
    let i = T::from(i.into());
    (i + i + T::ONE).raise(T::from(0.707) + (i + share) * T::from(1e-5))
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

fn gyroid<T: Elementary>(p: Vec3<T>) -> T {
    p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos()
}

fn globe<T: Elementary>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u.cos() * v.cos(), u.sin() * v.cos(), v.sin())
}
