//! R and H.

use proptest::prelude::*;
use shading::{Vec3, half_vector, reflection, term};

use super::Number;
use super::check::{by_spacing, check, equal, near, same, to_f64, within};
use super::exact::{determinant, dot, dot_difference, length, square_excess, sum_of_products};
use super::generators::{pair, shine};

// The error of R = 2(N·L)N − L, in units of u: N·L is off by 2 (three products, and two partial
// sums below 1), so 2(N·L)N is off by 4 along N and by 2 in the product; the difference adds 1.
// Together, the vector is off by 7. N itself is longer than 1 by up to 1u, which stretches 2(N·L)N
// by 2 more along N.
//
// An evenly spaced type rounds a dot product once. N·L is off by 1, so 2(N·L)N is off by 2 along N and
// by √3 in the product: 4 in all. The directions are longer than 1 by up to δ = √3u.

/// (19) |R| = |L|, within 11u. In an evenly spaced type, the length of N adds 4δ, or 7u, to 4u.
fn reflection_keeps_the_length<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        let (r, l) = (to_f64(reflection(n, l)), to_f64(l));
        // |R| − |L| is half the difference of the squares
        within(0.5 * dot_difference([r, r], [l, l]), 11.0 * T::U)
    });
}

/// (20) N·R = N·L, within 9u. In an evenly spaced type, it is 4δ + 4u, or 11u.
fn reflection_keeps_the_angle_to_the_normal<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        let [n, l, r] = [n, l, reflection(n, l)].map(to_f64);
        within(
            dot_difference([n, r], [n, l]),
            T::U * by_spacing::<T>(9.0, 11.0),
        )
    });
}

/// (21) The reflection of the reflection is L, within 14u. In an evenly spaced type, the length of N adds
/// 8δ, or 14u, to twice the error of R in a component, which is 3u.
fn reflection_is_its_own_inverse<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        let k = by_spacing::<T>(14.0, 20.0);
        near(reflection(n, reflection(n, l)), l, k * T::U)
    });
}

/// (22) N and −N reflect alike, except for the sign of a zero. In an evenly spaced type, a tie may go up
/// for N as for −N. Then N·L differs by a step, and R by two.
fn reflection_does_not_depend_on_the_side<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        let (back, front) = (reflection(-n, l), reflection(n, l));
        if T::EVENLY_SPACED && (-n).dot(l) != -n.dot(l) {
            near(back, front, 4.0 * T::U)
        } else {
            equal(back, front)
        }
    });
}

/// (23) R, N, and L lie in a plane, within 7u: before rounding, R = 2(N·L)N − L has no component
/// outside it.
fn reflection_stays_in_the_plane<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        within(
            determinant(to_f64(reflection(n, l)), to_f64(n), to_f64(l)),
            7.0 * T::U,
        )
    });
}

/// (24) L and V are interchangeable.
fn half_vector_is_symmetric<T: Number>() {
    check(pair::<T>(), |[l, v]| {
        let (lv, vl) = (half_vector(l, v), half_vector(v, l));
        prop_assert_eq!(lv.is_some(), vl.is_some());
        if let (Some(lv), Some(vl)) = (lv, vl) {
            same(lv, vl)?;
        }
        Ok(())
    });
}

/// (25) H makes the same angle with L as with V. H·L − H·V = (|L|² − |V|²)/|L + V|, and the lengths
/// differ by 2u. In addition, H is off by 1u for the sum and by 2u for the division by the length:
/// 4u/|L + V| + 6u in all. In an evenly spaced type, the sum is exact, and H is off by 1.02u in a
/// component: 4δ/|L + V| + 3.6u.
fn half_vector_halves_the_angle<T: Number>() {
    check(pair::<T>(), |[l, v]| {
        let Some(h) = half_vector(l, v) else {
            return Ok(());
        };
        let [h, l, v] = [h, l, v].map(to_f64);
        let sum = length([0, 1, 2].map(|i| l[i] + v[i]));
        let k = by_spacing::<T>(4.0 / sum + 6.0, 7.0 / sum + 3.6);
        within(dot_difference([h, l], [h, v]), k * T::U)
    });
}

/// (25) |L + V|² = 2 + 2 L·V, because H·(L + V) = |L + V|. The lengths of L and V contribute 4u,
/// and H is off by 3u of the square of the sum. In an evenly spaced type, these are 4δ and 1.8u.
fn half_vector_belongs_to_the_sum<T: Number>() {
    check(pair::<T>(), |[l, v]| {
        let Some(h) = half_vector(l, v) else {
            return Ok(());
        };
        let [h, l, v] = [h, l, v].map(to_f64);
        let along = dot(h, l) + dot(h, v);
        let square = sum_of_products([
            (2.0, 1.0),
            (2.0 * l[0], v[0]),
            (2.0 * l[1], v[1]),
            (2.0 * l[2], v[2]),
        ]);
        let k = by_spacing::<T>(4.0 + 6.0 * square, 7.0 + 3.6 * square);
        within(along * along - square, k * T::U)
    });
}

/// (26) |H| = 1, even if L and V are nearly opposite. The sum of squares is off by at most 3u and
/// its root by 1.5u, and the root and the division round: 3.5u. More than 2u is rare. An evenly spaced
/// type is off by 1.02u in each component.
fn half_vector_has_length_one<T: Number>() {
    check(pair::<T>(), |[l, v]| {
        let Some(h) = half_vector(l, v) else {
            prop_assert!(*l + *v == Vec3::ZERO);
            return Ok(());
        };
        let k = by_spacing::<T>(3.5, 1.77);
        within(0.5 * square_excess(to_f64(h)), k * T::U)
    });
}

/// (27) Seen along the mirror direction, V = R, H is N: N·H = 1 within 4u, and the highlight is
/// full but no brighter. For N·L near 0, H turns by up to 8u/(N·L), and the cosine falls by half
/// the square of that angle.
fn mirrored_eye_sees_the_full_highlight<T: Number>() {
    check((pair::<T>(), shine::<T>(10_000)), |([n, l], m)| {
        let cosine = dot(to_f64(n), to_f64(l));
        prop_assume!(cosine > 100.0 * T::U);
        let h = half_vector(l, reflection(n, l)).expect("L is not opposite to R");
        let turned = 8.0 * T::U / cosine;
        let tolerance = 4.0 * T::U + 0.5 * turned * turned;
        within(1.0 - dot(to_f64(n), to_f64(h)), tolerance)?;
        let highlight = term::blinn(n, h, m).to_f64();
        prop_assert!(highlight <= 1.0);
        within(
            1.0 - highlight,
            m.m * (tolerance + 2.0 * T::U) + m.error::<T>() * T::U,
        )
    });
}

properties! { direction:
    reflection_keeps_the_length,
    reflection_keeps_the_angle_to_the_normal,
    reflection_is_its_own_inverse,
    reflection_does_not_depend_on_the_side,
    reflection_stays_in_the_plane,
    half_vector_is_symmetric,
    half_vector_halves_the_angle,
    half_vector_belongs_to_the_sum,
    half_vector_has_length_one,
    mirrored_eye_sees_the_full_highlight,
}
