//! The edges of lights against three.js, Filament, and the glTF extension `KHR_lights_punctual`, by
//! the formulas of their shaders.

use shading::{Attenuation, UnitVec3, Vec3};
use support::number::{Number, for_f32_and_f64};

use crate::table::Tally;
use support::running::{Bounded, Float};

for_f32_and_f64!(soft_cones, ranges);

/// Angles of the cone in degrees, and the inner angles as shares of the outer.
const ANGLES: [f64; 5] = [5.0, 30.0, 45.0, 72.5, 90.0];
const SHARES: [f64; 4] = [0.0, 0.25, 0.5, 0.9];

/// The factors of the square and of the smoothstep, for a light whose axis is at this cosine.
fn factors<T: Number>(degrees: [f64; 2], cosine: f64) -> [T; 2] {
    let cone = T::soft_cone(degrees).expect("two half-angles");
    let sine = (1.0 - cosine * cosine).sqrt();
    let l = UnitVec3::assume_unit(Vec3::new(sine, 0.0, cosine).map(T::of));
    [cone, cone.smoothstep()].map(|cone| cone.factor(-UnitVec3::Z, l))
}

/// three.js 0.170, `getSpotAttenuation`: smoothstep(coneCos, penumbraCos, angleCos), as defined by
/// GLSL.
fn three_js(inner: f64, outer: f64, cosine: f64) -> f64 {
    let t = ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Filament, `getAngleAttenuation`, and the sample code of `KHR_lights_punctual`: scale and offset
/// are computed on the CPU. Both enforce a minimum width of the edge, but all cones here are wider.
fn filament(inner: f64, outer: f64, cosine: f64) -> f64 {
    let scale = 1.0 / f64::max(1.0 / 1024.0, inner - outer);
    let offset = -outer * scale;
    (cosine * scale + offset).clamp(0.0, 1.0).powi(2)
}

/// The tolerance is the error that running analysis finds, and the error of the formulas in `f64`:
/// a cosine is off by 1u, which counts more the narrower the edge is.
fn soft_cones<T: Float>() {
    let mut tally = Tally::new::<T>("soft cones");
    for (angle, share) in ANGLES.into_iter().flat_map(|a| SHARES.map(|s| (a, s))) {
        let degrees = [angle * share, angle];
        let [inner, outer] = degrees.map(|degrees| degrees.to_radians().cos());
        for k in 0..=200 {
            let cosine = f64::from(k) / 100.0 - 1.0;
            let actual = factors::<T>(degrees, cosine).map(T::to_f64);
            let expected = [filament, three_js].map(|formula| formula(inner, outer, cosine));
            let own = 8.0 * f64::EPSILON / (inner - outer);
            let tolerance =
                factors::<T::Running>(degrees, cosine).map(|factor| factor.error() + own);
            tally.compare(
                format!("{degrees:?}, {cosine}"),
                actual,
                expected,
                tolerance,
            );
        }
    }
    tally.close(ANGLES.len() * SHARES.len() * 201, &[]);
}

/// three.js 0.170, `getDistanceAttenuation` with a `decay` of 2, from a distance of 0.1 on, where
/// it does not clamp.
fn three_js_distance(q: f64, cutoff: f64) -> f64 {
    1.0 / f64::max(q.powi(2), 0.01) * (1.0 - (q / cutoff).powi(4)).clamp(0.0, 1.0).powi(2)
}

/// Filament, `getDistanceAttenuation`, with `falloff` 1/r².
fn filament_distance(q: f64, r: f64) -> f64 {
    let factor = q * q * (1.0 / (r * r));
    let smooth = (1.0 - factor * factor).clamp(0.0, 1.0);
    smooth * smooth / f64::max(q * q, 1e-4)
}

/// `KHR_lights_punctual`, “Range Property”, whose window is not squared.
fn khr_distance(q: f64, r: f64) -> f64 {
    (1.0 - (q / r).powi(4)).clamp(0.0, 1.0) / (q * q)
}

/// The attenuation is off by 4u. The root of the window is off by 6u of 1, and the window by twice
/// that. There are two more roundings, and the expected values are off by as many units of `f64`.
fn ranges<T: Float>() {
    let mut tally = Tally::new::<T>("ranges");
    let free = T::attenuation([0.0, 0.0, 1.0]).expect("coefficients");
    for r in [0.5, 1.0, 3.0, 12.5] {
        let ranged = (free).of_range(T::of(r)).expect("a range");
        for k in 1..=60 {
            let q = T::of(r * f64::from(k) / 50.0);
            let [actual, unsquared] = [ranged, ranged.unsquared()].map(|r| r.at(q).to_f64());
            let q = q.to_f64();
            if q < 0.1 {
                tally.leave_out("three.js clamps");
                continue;
            }
            let tolerance = 20.0 * (T::U + f64::EPSILON) / (q * q);
            let actual = [actual, actual, unsquared];
            let expected = [
                three_js_distance(q, r),
                filament_distance(q, r),
                khr_distance(q, r),
            ];
            tally.compare(format!("{q} of {r}"), actual, expected, [tolerance; 3]);
        }
    }
    tally.close(226, &[("three.js clamps", 14)]);

    // in three.js a `distance` of 0 means no range; here 0 is refused, and ∞ means no range
    assert_eq!((free).of_range(T::ZERO), None);
    assert_eq!(
        (free)
            .of_range(T::INFINITY)
            .expect("no range")
            .at(T::of(2.0)),
        T::of(0.25)
    );
    assert_eq!((Attenuation::NONE).of_range(T::NAN), None);
}
