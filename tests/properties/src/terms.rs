//! Lambert's factor, the highlights, and the powers that they are made of.

use std::f64::consts::TAU;

use proptest::prelude::*;
use shading::{Lobe, UnitVec3, Vec3, half_vector, reflection, term};

use crate::book;
use crate::given::{Directions, Numbers};
use crate::tracked::{prop_assert_book, prop_assert_near};
use crate::{Number, Outcome, least_normal};

/// A rounding of a number of about 1.
fn u<T: Number>() -> f64 {
    T::U + T::STEP
}

/// max(0, N·L), written out.
pub fn lambert_is_the_cosine<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_book!(d, vec![term::lambert(d.n, d.l)], book::lambert(d.n, d.l));
    Ok(())
}

/// Lambert's factor is 0 for a light behind the surface.
pub fn lambert_is_never_negative<T: Number>(d: &Directions<T>) -> Outcome {
    let lit = term::lambert(d.n, d.l);
    prop_assert!(lit >= T::ZERO, "{lit:?}");
    prop_assert_eq!(lit > T::ZERO, d.n.dot(d.l) > T::ZERO);
    Ok(())
}

/// N and L turned over together change nothing, and one of the two leaves nothing, to the bit.
pub fn lambert_has_no_preferred_side<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_eq!(term::lambert(-d.n, -d.l), term::lambert(d.n, d.l));
    let other = term::lambert(-d.n, d.l);
    prop_assert!(other == T::ZERO || term::lambert(d.n, d.l) == T::ZERO);
    Ok(())
}

/// L turned toward N by a hundredth of the way is no darker, but for the rounding of L.
pub fn tilting_l_toward_n_never_darkens<T: Number>(d: &Directions<T>) -> Outcome {
    let Some(nearer) = (*d.l + *d.n * T::of(0.01)).unit() else {
        return Ok(());
    };
    let [before, after] = [d.l, nearer].map(|l| term::lambert(d.n, l).exact());
    let is_no_darker = after >= before - 4.0 * u::<T>();
    prop_assert!(is_no_darker, "{before:?} and then {after:?}");
    Ok(())
}

/// max(0, R·V)ᵐ, written out.
pub fn phong_is_a_power_of_the_cosine<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_book!(
        d,
        vec![term::phong(reflection(d.n, d.l), d.v, d.m)],
        book::highlight(
            book::dot(
                book::reflected(book::xyz(d.n), book::xyz(d.l)),
                book::xyz(d.v)
            ),
            d.m
        )
    );
    Ok(())
}

/// max(0, N·H)ᵐ, written out.
pub fn blinn_is_a_power_of_the_cosine<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_book!(
        d,
        half_vector(d.l, d.v).map(|h| vec![term::blinn(d.n, h, d.m)]),
        book::halfway(book::xyz(d.l), book::xyz(d.v))
            .map(|h| book::highlight(book::dot(book::xyz(d.n), h), d.m))
    );
    Ok(())
}

/// A highlight is at least 0 and at most 1, although |H| or |R| may round to more.
pub fn a_highlight_is_at_most_1<T: Number>(d: &Directions<T>) -> Outcome {
    let phong = term::phong(reflection(d.n, d.l), d.v, d.m);
    let blinn = half_vector(d.l, d.v).map_or(T::ZERO, |h| term::blinn(d.n, h, d.m));
    let longer = UnitVec3::assume_unit(*d.n * T::of(1.5));
    for highlight in [phong, blinn, term::blinn(longer, d.n, d.m)] {
        prop_assert!(highlight >= T::ZERO && highlight <= T::ONE, "{highlight:?}");
    }
    Ok(())
}

/// A cosine of 0 or below gives no highlight, whatever m is, even m = 0; one above 0 gives 1 for m
/// = 0.
pub fn no_highlight_without_a_cosine<T: Number>(d: &Directions<T>) -> Outcome {
    for m in [0, 1, d.m] {
        prop_assert_eq!(term::phong(d.n, -d.n, m), T::ZERO);
        prop_assert_eq!(term::blinn(d.n, -d.n, m), T::ZERO);
    }
    let above_0 = |cosine: T| if cosine > T::ZERO { T::ONE } else { T::ZERO };
    prop_assert_eq!(term::phong(d.l, d.v, 0), above_0(d.l.dot(d.v)));
    prop_assert_eq!(term::blinn(d.n, d.l, 0), above_0(d.n.dot(d.l)));
    Ok(())
}

/// Light and eye exchanged give the same highlight: H to the bit, and R·V but for roundings.
pub fn light_and_eye_can_be_exchanged<T: Number>(d: &Directions<T>) -> Outcome {
    let blinn = |l, v| half_vector(l, v).map(|h| term::blinn(d.n, h, d.m));
    prop_assert_eq!(blinn(d.l, d.v), blinn(d.v, d.l));
    let [a, b] = [(d.l, d.v), (d.v, d.l)].map(|(l, v)| reflection(d.n, l).dot(v).exact());
    prop_assert_near!(a, b, 16.0 * u::<T>());
    Ok(())
}

/// R·V = 2(N·H)² − 1 + det[N, L, V]²/(1 + L·V): in the plane of L and V, the angle of R to V is
/// twice that of N to H.
pub fn phong_and_blinn_are_related<T: Number>(d: &Directions<T>) -> Outcome {
    let [n, l, v] = [d.n, d.l, d.v].map(|u| book::xyz(u.cast(T::exact)));
    let c = 1.0 + book::dot(l, v);
    prop_assume!(c > 0.1);
    let h = half_vector(d.l, d.v).expect("not opposite");
    let r_dot_v = reflection(d.n, d.l).dot(d.v).exact();
    let n_dot_h = d.n.dot(h).exact();
    let flat = 2.0 * n_dot_h * n_dot_h - 1.0;
    let det = book::dot(n, book::cross(l, v));
    let tolerance = 32.0 * u::<T>() / c;
    prop_assert_near!(r_dot_v, flat + det * det / c, tolerance);
    prop_assert!(r_dot_v >= flat - tolerance, "{r_dot_v} and {flat}");
    Ok(())
}

/// In the plane of x and z, Blinn's highlight of 4m is at least Phong's of m, as cos⁴ of half an
/// angle exceeds its cos.
pub fn blinn_of_4m_is_at_least_phong_of_m<T: Number>(d: &Directions<T>) -> Outcome {
    let flat = |u: UnitVec3<T>| Vec3::new(u.x, T::ZERO, u.z).unit();
    let is_short = |u: UnitVec3<T>| u.x.exact().hypot(u.z.exact()) < 0.25;
    prop_assume!(![d.n, d.l, d.v].into_iter().any(is_short));
    let [n, l, v] = [d.n, d.l, d.v].map(|u| flat(u).expect("not short"));
    prop_assume!(n.dot(l) > T::ZERO && n.dot(v) > T::ZERO);
    let size = (*l + *v).length().exact();
    prop_assume!(size > 0.1);
    let h = half_vector(l, v).expect("not opposite");
    let [phong, blinn] = [
        term::phong(reflection(n, l), v, d.m),
        term::blinn(n, h, 4 * d.m),
    ];
    let slack = 32.0 * (1.0 + f64::from(d.m)) * u::<T>() / size;
    prop_assert!(
        blinn.exact() >= phong.exact() - slack,
        "{blinn:?} < {phong:?}"
    );
    Ok(())
}

/// A power does not fall as its cosine rises.
pub fn a_power_rises_with_its_cosine<T: Number>(n: &Numbers<T>) -> Outcome {
    let (low, high) = if n.x < n.y { (n.x, n.y) } else { (n.y, n.x) };
    let next = (low * T::of(1.0 + 2.0 * T::U)).at_least(low + T::of(T::SMALLEST));
    for m in [0_u32, 1, 2, 3, 8, 33, 100] {
        let [a, b, c] = [low, next.at_most(T::ONE), high].map(|x| m.raise(x));
        prop_assert!(a <= b && a <= c, "{m}: {a:?}, {b:?}, {c:?}");
    }
    Ok(())
}

/// A power does not rise with its exponent, but for one rounding of each of its products.
pub fn a_power_falls_with_its_exponent<T: Number>(n: &Numbers<T>) -> Outcome {
    for m in 1..120_u32 {
        let [a, b] = [m.raise(n.x), (m + 1).raise(n.x)];
        let most = a.exact() * (1.0 + 2.0 * T::U) + 2.0 * T::STEP;
        prop_assert!(b.exact() <= most, "{m}: {a:?} and then {b:?}");
    }
    Ok(())
}

/// f⁰ = 1, f¹ = f, and 1ᵐ = 1, to the bit.
pub fn powers_of_0_and_1_are_exact<T: Number>(n: &Numbers<T>) -> Outcome {
    prop_assert_eq!(0.raise(n.x.at_least(T::of(0.5))), T::ONE);
    prop_assert_eq!(1.raise(n.x), n.x);
    prop_assert_eq!([n.m, u32::MAX].map(|m| m.raise(T::ONE)), [T::ONE; 2]);
    prop_assert_eq!([1, n.m + 1].map(|m| m.raise(T::ZERO)), [T::ZERO; 2]);
    Ok(())
}

/// fᵃ fᵇ = fᵃ⁺ᵇ: each power is off by its exponent in roundings of its value, or in steps.
pub fn powers_multiply<T: Number>(n: &Numbers<T>) -> Outcome {
    for (a, b) in [(1_u32, 1_u32), (2, 3), (8, 8), (5, 28), (33, 67)] {
        let [x, y, z] = [a, b, a + b].map(|m| m.raise(n.x).exact());
        let roundings = f64::from(a + b) + 3.0;
        prop_assume!(x * y == 0.0 || x * y > 2.0 * least_normal::<T>());
        prop_assert_near!(x * y, z, 2.0 * roundings * (T::U * z + T::STEP));
    }
    Ok(())
}

/// cᵐ of a root is that of the number to the half of m: (√x)²ᵏ = xᵏ.
pub fn a_power_of_a_root_is_half_the_power<T: Number>(n: &Numbers<T>) -> Outcome {
    for k in [1_u32, 2, 5, 50] {
        let [even, whole] = [(2 * k).raise_root(n.x), k.raise(n.x)].map(T::exact);
        prop_assume!(whole == 0.0 || whole > 4.0 * least_normal::<T>() / n.x.exact());
        prop_assert_near!(
            even,
            whole,
            2.0 * (f64::from(2 * k) + 3.0) * (T::U * whole + T::STEP)
        );
        let [odd, product] = [(2 * k + 1).raise_root(n.x), k.raise(n.x) * n.x.sqrt()].map(T::exact);
        prop_assert_near!(
            odd,
            product,
            4.0 * (f64::from(k) + 3.0) * (T::U * product + T::STEP)
        );
    }
    Ok(())
}

/// Over the hemisphere, ∫ (m + 2)/(2π) cosᵐ⁺¹ = 1: a white surface that the light meets head-on
/// returns all of it.
pub fn a_normalized_phong_lobe_returns_everything<T: Number>(n: &Numbers<T>) -> Outcome {
    let k = term::phong_normalization(T::of(f64::from(n.m))).exact();
    let exponent = i32::try_from(n.m).expect("small") + 1;
    let all = k * over_the_hemisphere(|c| c.powi(exponent));
    // 1/(2π) = 0.16 is a sum of three parts, each of which is rounded
    prop_assert_near!(all, 1.0, 8.0 * T::U + 24.0 * T::STEP + 1e-4);
    Ok(())
}

/// The integral of a function of the cosine over the hemisphere, 2π ∫ f(c) dc, by the midpoint
/// rule: for cᵐ with m of at most 101, it is off by less than 10⁻⁴ of itself.
fn over_the_hemisphere(f: impl Fn(f64) -> f64) -> f64 {
    let steps = 4096;
    let midpoints = (0..steps).map(|i| (f64::from(i) + 0.5) / f64::from(steps));
    TAU * midpoints.map(f).sum::<f64>() / f64::from(steps)
}

/// Light that meets a white surface head-on returns whole from Blinn's normalized lobe: H is at
/// half the angle of V, so N·H = √((1 + N·V)/2).
pub fn a_normalized_blinn_lobe_returns_everything<T: Number + Lobe<T>>(n: &Numbers<T>) -> Outcome {
    let m = f64::from(n.m) + n.x.exact();
    let k = term::blinn_normalization(T::of(m)).exact();
    let all = k * over_the_hemisphere(|c| (0.5 + 0.5 * c).powf(m / 2.0) * c);
    prop_assert_near!(all, 1.0, 16.0 * T::U + 1e-4);
    Ok(())
}

/// A whole m and the same real m give the same power, but for the roundings of both.
pub fn whole_and_real_exponents_agree<T: Number + Lobe<T>>(n: &Numbers<T>) -> Outcome {
    let [whole, real] = [n.m.raise(n.x), T::of(f64::from(n.m)).raise(n.x)].map(T::exact);
    if n.x > T::ZERO {
        prop_assert_near!(real, whole, (f64::from(n.m) + 8.0) * T::U);
    }
    Ok(())
}

/// A real power is c^m, written out; it does not fall as the cosine rises, but for its rounding.
pub fn a_real_power_is_its_formula<T: Number + Lobe<T>>(n: &Numbers<T>) -> Outcome {
    let m = f64::from(n.m) + n.y.exact();
    let power = |x: T| T::of(m).raise(x).exact();
    let (is, exact) = (power(n.x), n.x.exact().powf(T::of(m).exact()));
    if n.x > T::ZERO {
        prop_assert_near!(is, exact, 8.0 * T::U);
    }
    let higher = (n.x + (T::ONE - n.x) * T::of(0.25)).at_most(T::ONE);
    prop_assert!(power(higher) >= is * (1.0 - 2.0 * T::U), "{higher:?}");
    Ok(())
}
