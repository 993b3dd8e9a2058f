//! Normalized highlights: integrals over the hemisphere.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;
use shading::{UnitVec3, half_vector, reflection, term};

use super::check::{check, within};
use super::generators::{Shine, rounded, shine};
use super::{Number, RealPowers};

/// A normalized highlight: its value for N = Z, L, and V.
type Lobe<T> = fn(UnitVec3<T>, UnitVec3<T>, Shine) -> T;

fn phong<T: Number>(l: UnitVec3<T>, v: UnitVec3<T>, m: Shine) -> T {
    term::phong_normalization(T::of(m.m)) * term::phong(reflection(UnitVec3::Z, l), v, m)
}

fn blinn<T: RealPowers>(l: UnitVec3<T>, v: UnitVec3<T>, m: Shine) -> T {
    let h =
        half_vector(l, v).expect("the property expects both above the surface, and there is none");
    term::blinn_normalization(T::of(m.m)) * term::blinn(UnitVec3::Z, h, m)
}

/// The share of light from all directions that is returned along V, or of light from V that is
/// returned in all directions.
///
/// Gauss–Legendre quadrature in s, where s² is the height of L above the horizon, and equal steps
/// around N. At normal incidence the integrand is s²ᵐ⁺³, which this many nodes integrate to 10⁻⁹ or
/// better for every m.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a small count
fn returned<T: Number>(lobe: Lobe<T>, v: UnitVec3<T>, m: Shine) -> f64 {
    let count = 20 + (3.0 * m.m.sqrt()) as u32;
    let azimuths = 2 * count;
    let ring = |(s, weight): (f64, f64)| {
        let z = s * s;
        let radius = (1.0 - z * z).sqrt();
        let at = |i: u32| {
            let (sin, cos) = (TAU * (f64::from(i) + 0.5) / f64::from(azimuths)).sin_cos();
            let l = rounded([radius * cos, radius * sin, z]);
            (lobe(l, v, m) * term::lambert(UnitVec3::Z, l)).to_f64()
        };
        let mean = (0..azimuths).map(at).sum::<f64>() / f64::from(azimuths);
        TAU * 2.0 * s * weight * mean
    };
    gauss_legendre(count).map(ring).sum()
}

/// The nodes of the rule on [0, 1] and their weights. The nodes are the roots of the Legendre
/// polynomial, found by Newton's iteration.
fn gauss_legendre(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let n = f64::from(count);
    (0..count).map(move |i| {
        let mut x = (PI * (f64::from(i) + 0.75) / (n + 0.5)).cos();
        let mut slope = 0.0;
        for _ in 0..6 {
            let (mut before, mut p) = (1.0, x);
            for k in (2..=count).map(f64::from) {
                (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
            }
            slope = n * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (0.5 + 0.5 * x, 1.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Mostly a small m: a large one needs many nodes.
fn shininess<T: Number>() -> impl Strategy<Value = Shine> {
    prop_oneof![9 => shine::<T>(16), 1 => shine::<T>(250)]
}

/// The tolerance is 1e-9 for the rule. The error of the cosine, at most 21u for R·V and less for
/// N·H, counts m times; the power has its own error, and the remaining factors have nine roundings.
fn tolerance<T: Number>(Shine { m, .. }: Shine) -> f64 {
    1e-9 + (21.0 * m + (m + 2.0) * (1.0 + 0.5 * T::POWER_ERROR) + 9.0) * T::U
}

/// (61) No more is returned than arrives, for every m and every V. Phong's lobe around R and the
/// cosine around N both fall with the angle from their axis, and two such functions overlap most
/// where the axes coincide. For Blinn's lobe, only the integral shows it.
fn normalized_highlight_returns_no_more_than_arrives<T: RealPowers>() {
    let polar = prop_oneof![3 => 0.0..=FRAC_PI_2, 1 => 0.0..=0.1, 1 => Just(FRAC_PI_2)];
    check(
        (polar, 0.0..TAU, shininess::<T>()),
        |(polar, azimuth, m)| {
            let (sin, cos) = polar.sin_cos();
            let v = rounded([sin * azimuth.cos(), sin * azimuth.sin(), cos]);
            for lobe in [phong, blinn] {
                let excess = returned::<T>(lobe, v, m) - 1.0;
                prop_assert!(excess <= tolerance::<T>(m), "{excess:e} too much");
            }
            Ok(())
        },
    );
}

/// (61) All of it is returned where V = N, for every m.
fn normalized_highlight_returns_all_at_normal_incidence<T: RealPowers>() {
    check(shininess::<T>(), |m| {
        for lobe in [phong, blinn] {
            within(returned::<T>(lobe, UnitVec3::Z, m) - 1.0, tolerance::<T>(m))?;
        }
        Ok(())
    });
}

properties! { energy:
    [real powers]
    normalized_highlight_returns_no_more_than_arrives,
    normalized_highlight_returns_all_at_normal_incidence,
}
