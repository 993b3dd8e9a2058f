//! R, H, both highlights, and the attenuation against 60-digit arithmetic (`tests/data/README.md`).

use shading::{
    Attenuation, DirectionalLight, Material, Real, Rgb, UnitVec3, Vec3, attenuation, half_vector,
    reflection, shade, term,
};
use support::number::{Number, for_f32_and_f64, vector};

use crate::table::{Row, Tally, rows};
use support::running::{Bounded, Float};

for_f32_and_f64!(
    reflections,
    half_vectors,
    highlights_with_real_m,
    highlights_with_integer_m,
    highlights_in_the_sum,
    attenuations,
    checked_attenuations
);

const SPECULAR: &str = "scalar_specular.csv";
const ATTENUATION: &str = "scalar_attenuation.csv";

/// N, L, and V exactly as given, whether normalized or not.
fn directions<T: Number>(row: &Row) -> [UnitVec3<T>; 3] {
    ["N{}_hex32", "L{}_hex32", "V{}_hex32"]
        .map(|pattern| UnitVec3::assume_unit(vector(row.vector(pattern))))
}

fn components<T: Float>(v: Vec3<T>) -> [f64; 3] {
    v.map(T::to_f64).into()
}

fn errors<T: Number + Bounded>(v: Vec3<T>) -> [f64; 3] {
    v.map(Bounded::error).into()
}

fn reflections<T: Float>() {
    let mut tally = Tally::new::<T>(format!("{SPECULAR}, R"));
    for row in rows(SPECULAR) {
        let [n, l, _] = directions::<T>(&row);
        let [n_, l_, _] = directions::<T::Running>(&row);
        let tolerance = errors(*reflection(n_, l_));
        let r = components(*reflection(n, l));
        tally.compare(row.text("id"), r, row.vector("R{}"), tolerance);
    }
    tally.close(600, &[]);
}

fn half_vectors<T: Float>() {
    let mut tally = Tally::new::<T>(format!("{SPECULAR}, H"));
    for row in rows(SPECULAR) {
        let [_, l, v] = directions::<T>(&row);
        let h = half_vector(l, v);
        if row.number("Hx").is_nan() {
            assert_eq!(h, None, "{}", row.text("id"));
            tally.checked();
            continue;
        }
        let [_, l_, v_] = directions::<T::Running>(&row);
        let tolerance = errors(*half_vector(l_, v_).expect("H"));
        let h = components(*h.expect("H"));
        tally.compare(row.text("id"), h, row.vector("H{}"), tolerance);
    }
    tally.close(600, &[]);
}

/// Both highlights of a row in any number type.
fn highlights<T: Number, M: shading::Exponent<T>>(row: &Row, m: M) -> [T; 2] {
    let [n, l, v] = directions::<T>(row);
    // without H there is no highlight
    let of_blinn = half_vector(l, v).map_or(T::ZERO, |h| term::blinn(n, h, m));
    [term::phong(reflection(n, l), v, m), of_blinn]
}

/// Where the crate differs from the bare power: the highlight is 0 for a cosine of 0 or below, even
/// for m = 0, and a cosine above 1, from vectors that are not unit vectors, counts as 1.
fn expected(row: &Row) -> [f64; 2] {
    [("RdotV", "phong"), ("NdotH", "blinn")].map(|(cosine, power)| {
        let cosine = row.number(cosine);
        if cosine.is_nan() || cosine <= 0.0 {
            0.0
        } else if cosine >= 1.0 {
            1.0
        } else {
            row.number(power)
        }
    })
}

fn highlights_with_real_m<T: Float>() {
    let mut tally = Tally::new::<T>(format!("{SPECULAR}, real m"));
    for row in rows(SPECULAR) {
        let m = row.number("m_hex32");
        let actual = highlights::<T, T>(&row, T::of(m)).map(T::to_f64);
        let running = highlights::<T::Running, T::Running>(&row, Real::of(m));
        let tolerance = running.map(Bounded::error);
        tally.compare(row.text("id"), actual, expected(&row), tolerance);
    }
    tally.close(600, &[]);
}

fn highlights_with_integer_m<T: Float>() {
    let mut tally = Tally::new::<T>(format!("{SPECULAR}, integer m"));
    for row in rows(SPECULAR) {
        let m = row.number("m_hex32");
        if m.fract() != 0.0 {
            tally.leave_out("m is not an integer");
            continue;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let m = m as u32;
        let actual = highlights::<T, u32>(&row, m).map(T::to_f64);
        let tolerance = highlights::<T::Running, u32>(&row, m).map(Bounded::error);
        // in f32, a power that would be subnormal may be 0
        let tolerance = tolerance.map(|t| t.max(T::MIN_POSITIVE));
        tally.compare(row.text("id"), actual, expected(&row), tolerance);
    }
    tally.close(144, &[("m is not an integer", 456)]);
}

/// The same highlights as computed in the sum over lights: from R, and from L + V without
/// normalizing it, and only for a light in front of the surface.
fn highlights_in_the_sum<T: Float>() {
    let mut tally = Tally::new::<T>(format!("{SPECULAR}, in the sum"));
    for row in rows(SPECULAR) {
        let actual = shaded_highlights::<T>(&row).map(T::to_f64);
        let tolerance = shaded_highlights::<T::Running>(&row).map(Bounded::error);
        let expected = if row.number("NdotL") > 0.0 {
            expected(&row)
        } else {
            [0.0; 2]
        };
        tally.compare(row.text("id"), actual, expected, tolerance);
    }
    tally.close(600, &[]);
}

fn shaded_highlights<T: Number>(row: &Row) -> [T; 2] {
    let [n, l, v] = directions::<T>(row);
    let light = [DirectionalLight {
        l,
        intensity: Rgb::WHITE,
    }
    .at(Vec3::ZERO)];
    let m = T::of(row.number("m_hex32"));
    let mirror = Material {
        k_a: Rgb::BLACK,
        k_d: Rgb::BLACK,
        k_s: Rgb::WHITE,
        m,
    };
    [
        shade::phong(n, v, &mirror, Rgb::BLACK, light).specular.r,
        shade::blinn_phong(n, v, &mirror, Rgb::BLACK, light)
            .specular
            .r,
    ]
}

fn coefficients_and_distance(row: &Row) -> [f64; 4] {
    ["a_hex32", "b_hex32", "c_hex32", "q_hex32"].map(|name| row.number(name))
}

fn attenuation_of<T: Number>(row: &Row) -> T {
    let [a, b, c, q] = coefficients_and_distance(row).map(T::of);
    attenuation(a, b, c, q)
}

/// The factor that makes errors relative; 1 for values that have no relative precision.
fn relative<T: Float>(expected: f64) -> f64 {
    let is_normal = expected >= T::MIN_POSITIVE && expected <= T::MAX.to_f64();
    if is_normal { 1.0 / expected } else { 1.0 }
}

/// The bound of running error analysis. Where the denominator overflows, the factor is 0 instead of
/// a number below 1/MAX.
fn attenuation_tolerance<T: Float>(row: &Row, expected: f64) -> f64 {
    let overflow = if expected < 1.0 / T::MAX.to_f64() {
        expected
    } else {
        0.0
    };
    attenuation_of::<T::Running>(row).error() + overflow
}

fn attenuations<T: Float>() {
    let mut tally = Tally::new::<T>(ATTENUATION);
    for row in rows(ATTENUATION) {
        let expected = row.number("attenuation");
        let scale = relative::<T>(expected);
        let tolerance = attenuation_tolerance::<T>(&row, expected) * scale;
        let actual = attenuation_of::<T>(&row).to_f64() * scale;
        tally.compare(row.text("id"), [actual], [expected * scale], [tolerance]);
    }
    tally.close(400, &[]);
}

fn checked_attenuations<T: Float>() {
    let mut tally = Tally::new::<T>(format!("{ATTENUATION}, checked"));
    for row in rows(ATTENUATION) {
        let [a, b, c, q] = coefficients_and_distance(&row).map(T::of);
        let expected = row.number("attenuation");
        let Some(attenuation) = Attenuation::of(a, b, c) else {
            assert_eq!(row.text("class"), "all_zero");
            tally.checked();
            continue;
        };
        let tolerance = attenuation_tolerance::<T>(&row, expected);
        // an infinite factor is the largest finite number; any other is limited to 1 when clamped
        let expected = expected.min(T::MAX.to_f64());
        let scale = relative::<T>(expected);
        let actual = [attenuation.at(q), attenuation.clamped().at(q)].map(|x| x.to_f64() * scale);
        let expected = [expected, expected.min(1.0)].map(|x| x * scale);
        tally.compare(row.text("id"), actual, expected, [tolerance * scale; 2]);
    }
    tally.close(400, &[]);
}
