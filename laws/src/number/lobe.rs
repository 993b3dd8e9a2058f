//! The two highlights.

use std::f64::consts::{FRAC_PI_4, TAU};

use proptest::prelude::*;
use shading::{Exponent, UnitVec3, Vec3, half_vector, reflection, term};

use super::check::{
    at_least, by_spacing, check, is_short_of_range, octaves_below_one, same, to_f64, within,
};
use super::exact::{determinant, dot};
use super::generators::{Relation, Shine, direction, rounded, shine, triple};
use super::{Number, RealPowers};

/// R·V, N·H, det[N, L, V], and 1 + L·V, exact for the R and H that were computed.
struct Cosines {
    r_dot_v: f64,
    n_dot_h: f64,
    determinant: f64,
    one_plus_l_dot_v: f64,
}

impl Cosines {
    /// `None` where 1 + L·V ≤ 0.1, since H is ill-conditioned there.
    fn of<T: Number>([n, l, v]: [UnitVec3<T>; 3]) -> Option<Self> {
        let (r, h) = (to_f64(reflection(n, l)), half_vector(l, v).map(to_f64)?);
        let [n, l, v] = [n, l, v].map(to_f64);
        let one_plus_l_dot_v = 1.0 + dot(l, v);
        (one_plus_l_dot_v > 0.1).then(|| Self {
            r_dot_v: dot(r, v),
            n_dot_h: dot(n, h),
            determinant: determinant(n, l, v),
            one_plus_l_dot_v,
        })
    }

    /// R is off by 7u, and by 2u for the length of N. N·H is off by 3u, so twice its square is off
    /// by 12u. The lengths of L and V add 2u/(1 + L·V) to H, and as much to the last term. In an evenly
    /// spaced type, R is off by 4u, twice the square of N·H by 7u, and the lengths, by √3u: 4√3u for N,
    /// and as much for L and V.
    fn tolerance<T: Number>(&self) -> f64 {
        let per_sum = 1.0 / self.one_plus_l_dot_v;
        T::U * by_spacing::<T>(21.0 + 4.0 * per_sum, 18.0 + 7.0 * per_sum)
    }
}

/// (28) R·V = 2(N·H)² − 1 + det[N, L, V]²/(1 + L·V)
fn phong_and_blinn_cosines_are_related<T: Number>() {
    check(triple::<T>(), |directions| {
        let Some(c) = Cosines::of(directions) else {
            return Ok(());
        };
        let right = 2.0 * c.n_dot_h.powi(2) - 1.0 + c.determinant.powi(2) / c.one_plus_l_dot_v;
        within(c.r_dot_v - right, c.tolerance::<T>())
    });
}

/// (29) R·V ≥ 2(N·H)² − 1. If N, L, and V do not lie in a plane, it is greater by at least half the
/// square of their determinant, since 1 + L·V ≤ 2.
fn phong_cosine_is_at_least_that_of_twice_the_angle<T: Number>() {
    check(triple::<T>(), |directions| {
        let Some(c) = Cosines::of(directions) else {
            return Ok(());
        };
        let doubled = 2.0 * c.n_dot_h.powi(2) - 1.0;
        at_least(
            c.r_dot_v,
            doubled + 0.5 * c.determinant.powi(2),
            c.tolerance::<T>(),
        )?;
        if c.determinant.abs() < T::U {
            within(c.r_dot_v - doubled, c.tolerance::<T>())?;
        }
        Ok(())
    });
}

/// N, L, and V in a plane: L and V are at angles to N, toward an azimuth.
fn coplanar<T: Number>() -> impl Strategy<Value = [UnitVec3<T>; 3]> {
    let angles = [-FRAC_PI_4..FRAC_PI_4, -FRAC_PI_4..FRAC_PI_4];
    (direction(), 0.0..TAU, angles).prop_map(|(n, azimuth, angles)| {
        let [l, v] = angles.map(|angle| Relation::Angle(angle, azimuth).to(n));
        [n, l, v].map(rounded)
    })
}

/// (30) In a plane, Blinn's highlight with 4m is at least Phong's with m, since cos⁴(α/2) ≥ cos α. In an
/// evenly spaced type, 4m is at most 128.
fn blinn_with_fourfold_shininess_covers_phong_in_a_plane<T: Number>() {
    let m = 1..=if T::EVENLY_SPACED { 32 } else { 500_u32 };
    check((coplanar::<T>(), m), |([n, l, v], m)| {
        let h = half_vector(l, v)
            .expect("the property expects an angle within a right angle, and there is none");
        let (blinn, phong) = (
            term::blinn(n, h, 4 * m),
            term::phong(reflection(n, l), v, m),
        );
        // the cosines are off by 5u and by 11u; their powers 4m and m add as many roundings
        let tolerance = f64::from(4 * m) * 6.0 + f64::from(m) * 12.0;
        at_least(blinn.to_f64(), phong.to_f64(), tolerance * T::U)
    });
}

/// (31) A trap: out of the plane, Blinn's highlight may be smaller than Phong's with the same m. If
/// L and V are next to the horizon and 120° apart, R is 60° from V, and H is nearly on the horizon. In an
/// evenly spaced type, both are 0 if m is large.
fn blinn_may_be_smaller_than_phong<T: Number>() {
    let m = 1..=if is_short_of_range::<T>() {
        12
    } else {
        100_u32
    };
    check((0.001..0.1, m), |(height, m)| {
        let radius = f64::sqrt(1.0 - height * height);
        let (sin, cos) = f64::to_radians(120.0).sin_cos();
        let n = UnitVec3::<T>::Z;
        let l = rounded([radius, 0.0, height]);
        let v = rounded([radius * cos, radius * sin, height]);
        let h = half_vector(l, v).expect("120° apart");
        prop_assert!(term::blinn(n, h, m) < term::phong(reflection(n, l), v, m));
        Ok(())
    });
}

/// (32) L and V are interchangeable, exactly so for Blinn, whose H is the same.
fn blinn_is_symmetric<T: Number>() {
    check((triple::<T>(), shine::<T>(1000)), |([n, l, v], m)| {
        if let (Some(lv), Some(vl)) = (half_vector(l, v), half_vector(v, l)) {
            same([term::blinn(n, lv, m); 3], [term::blinn(n, vl, m); 3])?;
        }
        Ok(())
    });
}

/// (32) For Phong, they are interchangeable within 8u of the cosine, times m: R·V = 2(N·L)(N·V) −
/// L·V. Below m = 1, the power is steep at 0. Each of the two powers also has its own error. In an
/// evenly spaced type, R is off by 4u and R·V by 1u: 10u for both.
fn phong_is_symmetric<T: Number>() {
    check((triple::<T>(), shine::<T>(1000)), |([n, l, v], m)| {
        prop_assume!(m.m >= 1.0);
        let (lv, vl) = (
            term::phong(reflection(n, l), v, m),
            term::phong(reflection(n, v), l, m),
        );
        within(
            lv.to_f64() - vl.to_f64(),
            (by_spacing::<T>(8.0, 10.0) * m.m + 2.0 * m.error::<T>()) * T::U,
        )
    });
}

/// The highlight for a cosine N·H or R·V.
fn highlight<T: Number>(cosine: T, m: Shine) -> T {
    // only the z component counts next to the z axis
    let direction = UnitVec3::<T>::assume_unit(Vec3::new(T::ZERO, T::ZERO, cosine));
    let highlight = term::blinn(UnitVec3::Z, direction, m);
    assert!(
        highlight == term::phong(UnitVec3::Z, direction, m),
        "one cosine gives two different highlights"
    );
    highlight
}

/// Below this, a power would be subnormal in `f32` or in the type, and may be 0.
fn negligible<T: Number>() -> f64 {
    let subnormal = by_spacing::<T>(T::TINY.to_f64() / (2.0 * T::U), 0.0);
    subnormal.max(f32::MIN_POSITIVE.into())
}

/// A cosine in [0, 1], often next to an end.
fn cosine<T: Number>() -> impl Strategy<Value = T> {
    prop_oneof![
        4 => (0.0..=1.0).prop_map(T::of),
        1 => (0..64).prop_map(|k: i32| T::of(1.0 - f64::from(k) * T::U)),
        1 => (0.0..30.0).prop_map(|k: f64| T::of((-k).exp2())),
        1 => Just(T::ZERO),
        1 => Just(T::TINY),
    ]
}

/// (33) A highlight does not rise with m, except by the roundings of two powers, m each, if m is an
/// integer, and by one unit in the last place if m is real. In an evenly spaced type, it is the error of
/// the two powers.
fn highlight_does_not_rise_with_the_shininess<T: Number>() {
    check(
        (cosine::<T>(), shine::<T>(10_000), shine::<T>(10_000)),
        |(cosine, a, b)| {
            let whole = a.whole && b.whole;
            let [a, b] = [a, b].map(|shine| Shine { whole, ..shine });
            let (small, large) = if a.m <= b.m { (a, b) } else { (b, a) };
            prop_assume!(cosine > T::ZERO);
            let (brighter, darker) = (
                highlight(cosine, small).to_f64(),
                highlight(cosine, large).to_f64(),
            );
            let k = if whole { small.m + large.m } else { 2.0 };
            let roundings = by_spacing::<T>(
                k * T::U * brighter + negligible::<T>(),
                (small.error::<T>() + large.error::<T>()) * T::U,
            );
            at_least(brighter, darker, roundings)
        },
    );
}

/// (33) It does not fall as the cosine rises: not at all for an integer m, since each
/// multiplication is monotone, and by at most one unit in the last place for a real m.
fn highlight_does_not_fall_with_the_cosine<T: Number>() {
    check(
        (cosine::<T>(), cosine::<T>(), shine::<T>(10_000)),
        |(a, b, m)| {
            let (small, large) = if a <= b { (a, b) } else { (b, a) };
            let (darker, brighter) = (highlight(small, m).to_f64(), highlight(large, m).to_f64());
            let is_integer = m.whole || T::EVENLY_SPACED;
            let k = if is_integer { 0.0 } else { 1.0 };
            at_least(
                brighter,
                darker,
                k * (2.0 * T::U * darker + T::TINY.to_f64()),
            )
        },
    );
}

/// (33) Where the cosine is not positive, the highlight is 0 for every m. Where the cosine is 1, or
/// more than 1 by rounding, the highlight is exactly 1.
fn highlight_ends_at_the_horizon<T: Number>() {
    check((cosine::<T>(), shine::<T>(10_000)), |(cosine, m)| {
        same([highlight(-cosine, m); 3], [T::ZERO; 3])?;
        same([highlight(T::ONE, m); 3], [T::ONE; 3])?;
        same([highlight(T::of(1.0 + 2.0 * T::U), m); 3], [T::ONE; 3])
    });
}

/// (34) f^(m₁ + m₂) = f^m₁ · f^m₂ for integer m, within 2(m + 1)u: m roundings on either side. Both
/// sides may be 0 where they would be negligible. In an evenly spaced type, it is the error of the three
/// powers, and u for the product.
fn whole_powers_add_up<T: Number>() {
    let most = if T::EVENLY_SPACED { 64 } else { 5000_u32 };
    check((cosine::<T>(), 0..most, 0..most), |(cosine, a, b)| {
        let shine = |m: u32| Shine {
            m: m.into(),
            whole: true,
        };
        let [a, b, sum] = [a, b, a + b].map(shine);
        let (product, power) = (
            highlight(cosine, a) * highlight(cosine, b),
            highlight(cosine, sum),
        );
        let (product, power) = (product.to_f64(), power.to_f64());
        let roundings = 2.0 * (sum.m + 1.0) * T::U * power.max(product);
        let errors: f64 = [a, b, sum].map(Shine::error::<T>).into_iter().sum();
        let tolerance = by_spacing::<T>(roundings.max(negligible::<T>()), (errors + 1.0) * T::U);
        within(power - product, tolerance)
    });
}

/// (34) The same for real m, within the error of each of the three powers, and u for the product.
fn real_powers_add_up<T: RealPowers>() {
    check(
        (cosine::<T>(), shine::<T>(5000), shine::<T>(5000)),
        |(cosine, a, b)| {
            let highlight = |m: f64| highlight(cosine, Shine { m, whole: false }).to_f64();
            let (product, power) = (highlight(a.m) * highlight(b.m), highlight(a.m + b.m));
            within(power - product, (3.0 * T::POWER_ERROR + 1.0) * T::U)
        },
    );
}

/// (√s)^m as the sum over lights computes it for Blinn–Phong.
fn raise_root<T: Number>(m: impl Exponent<T>, square: T) -> T {
    match m.half() {
        Some(half) => half.raise(square),
        None => m.raise(square.sqrt()),
    }
}

/// (34) (√s)^2m = s^m, exactly for integer m, since no root is needed. In a type that takes the root
/// all the same, the root is off by u, which the power magnifies 2m times (√s)^(2m − 1), and both powers
/// have errors. An odd power has the rounding of the root, m times, and its own.
fn power_of_a_root_is_half_the_power<T: Number>() {
    check((cosine::<T>(), 0..5000_u32), |(square, m)| {
        let (even, half) = (raise_root(2 * m, square), m.raise(square));
        if Exponent::<T>::half(2 * m).is_some() {
            same([even; 3], [half; 3])?;
        } else {
            let error = |m: u32| {
                Shine {
                    m: f64::from(m),
                    whole: true,
                }
                .error::<T>()
            };
            let twice = 2.0 * f64::from(m);
            let slope = twice * square.to_f64().sqrt().powf((twice - 1.0).max(0.0));
            let tolerance = (slope + error(2 * m) + error(m)) * T::U;
            within(even.to_f64() - half.to_f64(), tolerance)?;
        }
        let m = 2 * m + 1;
        let (power, expected) = (
            raise_root(m, square).to_f64(),
            m.raise(square.sqrt()).to_f64(),
        );
        let roundings = 3.0 * f64::from(m) * T::U * expected;
        within(power - expected, roundings.max(negligible::<T>()))
    });
}

/// (34) (√s)^m for real m, within the errors of both powers, and m times the rounding of the root.
fn real_power_of_a_root_is_half_the_power<T: RealPowers>() {
    check((cosine::<T>(), shine::<T>(5000)), |(square, m)| {
        let real = Shine { whole: false, ..m };
        let power = raise_root(real, square).to_f64();
        let expected = real.raise(square.sqrt()).to_f64();
        let tolerance = 2.0 * T::POWER_ERROR + 2.0 * m.m * expected.max(power);
        within(power - expected, tolerance * T::U)
    });
}

/// An integer power is right to m − 1 roundings down to the smallest normal `f32`: a result that
/// single precision can hold in full never becomes 0. The expected value is rounded once. In an evenly
/// spaced type, the power has its own error, down to a twentieth of a step.
fn faint_highlights_are_kept<T: Number>() {
    let (m, octaves) = if T::EVENLY_SPACED {
        (1..=128, 0.0..20.0)
    } else {
        (1..=10_000_u32, 0.0..octaves_below_one::<T>().min(126.0))
    };
    check((m, octaves), |(m, octaves)| {
        let cosine = T::of((-octaves / f64::from(m)).exp2());
        let expected = cosine.to_f64().powf(m.into());
        prop_assume!(expected >= negligible::<T>());
        let (m, whole) = (f64::from(m), true);
        let shine = Shine { m, whole };
        let error = highlight(cosine, shine).to_f64() - expected;
        let roundings = ((m - 1.0) * T::U).exp_m1(); // (1 + u)^(m − 1) − 1
        let tolerance = by_spacing::<T>(roundings * expected, shine.error::<T>() * T::U);
        within(error, tolerance + f64::U * expected)
    });
}

/// (34) An integer m and the same m as a real number agree.
fn whole_and_real_powers_agree<T: RealPowers>() {
    check((cosine::<T>(), shine::<T>(10_000)), |(cosine, shine)| {
        let m = shine.m.floor();
        let [whole, real] =
            [true, false].map(|whole| highlight(cosine, Shine { m, whole }).to_f64());
        within(whole - real, (m * whole + T::POWER_ERROR) * T::U)
    });
}

properties! { lobe:
    phong_and_blinn_cosines_are_related,
    phong_cosine_is_at_least_that_of_twice_the_angle,
    blinn_with_fourfold_shininess_covers_phong_in_a_plane,
    blinn_may_be_smaller_than_phong,
    blinn_is_symmetric,
    phong_is_symmetric,
    highlight_does_not_rise_with_the_shininess,
    highlight_does_not_fall_with_the_cosine,
    highlight_ends_at_the_horizon,
    whole_powers_add_up,
    power_of_a_root_is_half_the_power,
    faint_highlights_are_kept,
    [real powers]
    whole_and_real_powers_agree,
    real_powers_add_up,
    real_power_of_a_root_is_half_the_power,
}
