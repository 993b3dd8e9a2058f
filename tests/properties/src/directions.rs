//! Lengths and directions, the reflection vector R and the half vector H.

use proptest::prelude::*;
use shading::{Vec3, half_vector, reflection, term};

use crate::book::{self, Triple};
use crate::given::{Directions, Triangle};
use crate::tracked::{prop_assert_book, prop_assert_near};
use crate::{Number, Outcome, has_digits};

fn xyz<T: Number>(v: impl Into<Vec3<T>>) -> Triple {
    book::xyz(v.into().map(T::exact))
}

/// A rounding of a number of about 1.
fn u<T: Number>() -> f64 {
    T::U + T::STEP
}

/// N and −N reflect alike, to the bit.
pub fn reflection_has_no_side<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_eq!(reflection(-d.n, d.l), reflection(d.n, d.l));
    Ok(())
}

/// The reflection of the reflection of L is L: each is off by few roundings.
pub fn reflection_twice_is_the_identity<T: Number>(d: &Directions<T>) -> Outcome {
    let twice = xyz(reflection(d.n, reflection(d.n, d.l)));
    for (back, l) in twice.into_iter().zip(xyz(d.l)) {
        prop_assert_near!(back, l, 24.0 * u::<T>());
    }
    Ok(())
}

/// |R| = |L|.
pub fn reflection_keeps_the_length<T: Number>(d: &Directions<T>) -> Outcome {
    let [r, l] = [reflection(d.n, d.l), d.l].map(|v| book::length(xyz(v)));
    prop_assert_near!(r, l, 12.0 * u::<T>());
    Ok(())
}

/// R leaves at the angle at which L arrives: N·R = N·L.
pub fn reflection_makes_the_same_angle<T: Number>(d: &Directions<T>) -> Outcome {
    let [r, l] = [reflection(d.n, d.l), d.l].map(|v| book::dot(xyz(d.n), xyz(v)));
    prop_assert_near!(r, l, 12.0 * u::<T>());
    Ok(())
}

/// R lies in the plane of N and L, on the other side of N: R + L = 2(N·L)N.
pub fn reflection_lies_opposite_l<T: Number>(d: &Directions<T>) -> Outcome {
    let [n, l, r] = [d.n, d.l, reflection(d.n, d.l)].map(xyz);
    prop_assert_near!(book::dot(r, book::cross(n, l)), 0.0, 12.0 * u::<T>());
    let across = |v| book::minus(v, book::times(book::dot(n, v), n));
    for (r, l) in across(r).into_iter().zip(across(l)) {
        prop_assert_near!(r, -l, 24.0 * u::<T>());
    }
    Ok(())
}

/// H(L, V) = H(V, L), to the bit.
pub fn half_vector_is_symmetric<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_eq!(half_vector(d.l, d.v), half_vector(d.v, d.l));
    Ok(())
}

/// H makes the same angle with L and with V, and it has length 1: the shorter L + V is, the fewer
/// digits it has.
pub fn half_vector_is_halfway<T: Number>(d: &Directions<T>) -> Outcome {
    let Some(h) = half_vector(d.l, d.v) else {
        return Ok(());
    };
    let [h, l, v] = [h, d.l, d.v].map(xyz);
    let size = book::length(book::plus(l, v));
    prop_assume!(size > 64.0 * T::STEP);
    let few = 12.0 * u::<T>() / size;
    prop_assert_near!(
        book::length(h),
        1.0,
        4.0 * T::U + 8.0 * T::STEP / size / size
    );
    prop_assert_near!(book::dot(h, l), book::dot(h, v), few);
    // |L + V|² = 2 + 2L·V, so H·L = √((1 + L·V)/2)
    prop_assert_near!(
        book::dot(h, l),
        (0.5 + 0.5 * book::dot(l, v)).max(0.0).sqrt(),
        few
    );
    Ok(())
}

/// H = (L + V)/|L + V|, written out.
pub fn half_vector_is_its_formula<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_book!(
        d,
        half_vector(d.l, d.v),
        book::halfway(book::xyz(d.l), book::xyz(d.v))
    );
    Ok(())
}

/// L and −L have no half vector.
pub fn opposites_have_no_half_vector<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assert_eq!(half_vector(d.l, -d.l), None);
    Ok(())
}

/// An eye that R points to sees H at N: N·H = 1, and the highlight is not above 1 even where N·H
/// rounds up.
pub fn the_eye_in_the_reflection_sees_h_at_n<T: Number>(d: &Directions<T>) -> Outcome {
    prop_assume!(d.n.dot(d.l).exact() > 0.25);
    let h = half_vector(d.l, reflection(d.n, d.l)).expect("in front");
    prop_assert_near!(d.n.dot(h).exact(), 1.0, 32.0 * u::<T>());
    prop_assert!(term::blinn(d.n, h, 1_000_000) <= T::ONE);
    Ok(())
}

/// |v| = √(x² + y² + z²) and v/|v|, written out, for vectors of any size.
pub fn a_length_is_the_root_of_the_squares<T: Number>(t: &Triangle<T>) -> Outcome {
    prop_assert_book!(t, vec![t.a.length()], book::length(book::xyz(t.a)));
    prop_assert_book!(t, t.a.unit(), book::direction(book::xyz(t.a)));
    prop_assert_book!(
        t,
        vec![t.a.distance(t.b)],
        book::length(book::minus(book::xyz(t.a), book::xyz(t.b)))
    );
    Ok(())
}

/// A direction has length 1, whatever the size of its vector.
pub fn a_direction_has_length_1<T: Number>(t: &Triangle<T>) -> Outcome {
    let size = book::length(xyz(t.a));
    prop_assume!(has_digits::<T>(size * size));
    let v = t.a.unit().expect("a direction");
    prop_assert_near!(
        book::length(xyz(v)),
        1.0,
        4.0 * (T::U + T::STEP + T::STEP / size / size)
    );
    prop_assert!(book::dot(xyz(v), xyz(t.a)) > 0.0);
    prop_assert_eq!(t.a.unit_or(-v), v);
    Ok(())
}

/// The zero vector has no direction, and `unit_or` gives what it is told to.
pub fn nothing_has_no_direction<T: Number>(d: &Directions<T>) -> Outcome {
    let zero = *d.n * T::ZERO;
    prop_assert_eq!(zero.unit(), None);
    prop_assert_eq!(zero.unit_or(d.l), d.l);
    prop_assert_eq!(zero.length(), T::ZERO);
    Ok(())
}

/// An axis that is longer by a power of two has the same direction, to the bit.
pub fn a_direction_has_no_size<T: Number>(t: &Triangle<T>) -> Outcome {
    let v = t.corners[0];
    for k in [0.25, 0.5, 2.0, 64.0] {
        prop_assert_eq!((v * T::of(k)).unit(), v.unit());
    }
    Ok(())
}

/// |−v| = |v|, and the direction of −v is the opposite of that of v, to the bit.
pub fn opposite_vectors_are_as_long<T: Number>(t: &Triangle<T>) -> Outcome {
    for v in [t.a, t.corners[0], Vec3::new(T::ZERO, T::ZERO, t.a.z)] {
        prop_assert_eq!((-v).length(), v.length());
        prop_assert_eq!((-v).unit(), v.unit().map(|u| -u));
    }
    prop_assert_eq!(t.a.distance(t.b), t.b.distance(t.a));
    Ok(())
}

/// a × b is perpendicular to both, and |a × b|² + (a·b)² = |a|²|b|² (Lagrange), exactly on a grid.
pub fn products_of_vectors_keep_lagranges_identity<T: Number>(t: &Triangle<T>) -> Outcome {
    let [a, b, c] = t.corners.map(|v| v * T::of(0.5));
    let cross = a.cross(b);
    prop_assert_eq!(b.cross(a), -cross);
    prop_assert_eq!(a.dot(b), b.dot(a));
    // the volume of a box with edges of at most √3
    let tolerance = 16.0 * (T::U + T::STEP);
    prop_assert_near!(cross.dot(a).exact(), 0.0, tolerance);
    prop_assert_near!(a.dot(b.cross(c)).exact(), c.dot(cross).exact(), tolerance);
    let square = |v: Vec3<T>| book::dot(xyz(v), xyz(v));
    let dot = a.dot(b).exact();
    prop_assert_near!(square(cross) + dot * dot, square(a) * square(b), 0.0);
    Ok(())
}

/// A blend of two vectors begins at the one, ends at the other, and is halfway in the middle.
pub fn a_blend_goes_from_one_to_the_other<T: Number>(t: &Triangle<T>) -> Outcome {
    let [a, b, _] = t.corners;
    let half = T::of(0.5);
    prop_assert_eq!([T::ZERO, T::ONE].map(|t| a.lerp(b, t)), [a, b]);
    prop_assert_eq!(a.lerp(b, half), (a + b) * half);
    Ok(())
}
