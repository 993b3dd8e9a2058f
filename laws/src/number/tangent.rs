//! The tangent of a triangle with texture coordinates.

use proptest::prelude::*;
use shading::{UnitVec3, Vec3, normal};

use super::Number;
use super::check::{check, equal, near, same_or_near, to_f64, within};
use super::exact::{cross, dot, length};
use super::generators::{exponent, point};

type Triangle<T> = ([Vec3<T>; 3], [[T; 2]; 3]);

/// A triangle, and texture coordinates that are not on a line.
fn triangle<T: Number>() -> impl Strategy<Value = Triangle<T>> {
    let coordinates = || [(); 3].map(|()| [-1.0..1.0_f64, -1.0..1.0]);
    ([point::<T>(), point(), point()], coordinates()).prop_filter_map(
        "on a line",
        |(vertices, coordinates)| {
            let coordinates = coordinates.map(|xy| xy.map(T::of));
            let (t, conditioning, d) = exact(&(vertices, coordinates));
            (d.abs() > 1.0 / 16.0 && conditioning < 50.0 && length(t) > 1.0 / 16.0)
                .then_some((vertices, coordinates))
        },
    )
}

/// T times d, its conditioning, and d.
fn exact<T: Number>((vertices, coordinates): &Triangle<T>) -> ([f64; 3], f64, f64) {
    let [a, b, c] = vertices.map(to_f64);
    let [e1, e2] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
    let [[x, y], [x2, y2], [x3, y3]] = coordinates.map(|xy| xy.map(T::to_f64));
    let t = [0, 1, 2].map(|i| (y3 - y) * e1[i] - (y2 - y) * e2[i]);
    let terms = length(e1) * (y3 - y).abs() + length(e2) * (y2 - y).abs();
    (
        t,
        terms / length(t),
        (x2 - x) * (y3 - y) - (x3 - x) * (y2 - y),
    )
}

/// The tangent points to where the map's x grows, and h is the sign of the map's area. Each term of T
/// is off by 5u of itself: the edge and its share by 2u, the coordinate and its share by 2u, the
/// product by 1u. Their difference adds 1u, and `unit` 3.5u; the comparison in `f64` counts as
/// much again. In an evenly spaced type each of the six roundings before the product, of which two
/// are those of the halves, is a step of numbers that may be 1/16, and `exact` has no error.
fn tangent_points_where_the_map_grows<T: Number>() {
    check(triangle::<T>(), |given| {
        let (t, conditioning, d) = exact(&given);
        let (found, h) = normal::tangent(given.0, given.1)
            .expect("the property expects a tangent, and there is none");
        let expected = t.map(|c| c * d.signum() / length(t));
        let k = if T::EVENLY_SPACED { 12.0 * 16.0 } else { 10.0 };
        let found = to_f64(found);
        for i in 0..3 {
            within(found[i] - expected[i], (k * conditioning + 9.0) * T::U)?;
        }
        within(h.to_f64() - d.signum(), 0.0)
    });
}

/// On the front, the map's y grows to the side of h (N × t).
fn handedness_is_that_of_the_map<T: Number>() {
    check(triangle::<T>(), |(vertices, coordinates)| {
        let [a, b, c] = vertices.map(to_f64);
        let [e1, e2] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
        let swapped = coordinates.map(|[x, y]| [y, x]); // its T is the map's B
        let (bitangent, _, d) = exact(&(vertices, swapped));
        let bitangent = bitangent.map(|c| c * d.signum());
        let (t, h) = normal::tangent(vertices, coordinates)
            .expect("the property expects a tangent, and there is none");
        let side = dot(cross(cross(e1, e2), to_f64(t)), bitangent) * h.to_f64();
        let size = length(cross(e1, e2)) * length(bitangent);
        prop_assert!(side > 0.0 || side.abs() < 1e-2 * size, "{side}");
        Ok(())
    });
}

/// Mirroring the map turns t and h around; moving or scaling triangle and map by powers of two changes
/// nothing.
fn mirroring_the_map_turns_the_tangent<T: Number>() {
    let inputs = (triangle::<T>(), exponent::<T>(20, 0), exponent::<T>(20, 0));
    check(inputs, |((vertices, coordinates), k, j)| {
        let (t, h) = normal::tangent(vertices, coordinates)
            .expect("the property expects a tangent, and there is none");
        let mirrored = coordinates.map(|[x, y]| [-x, y]);
        let (turned, opposite) = normal::tangent(vertices, mirrored)
            .expect("the property expects a tangent, and there is none");
        equal(turned, -t)?;
        within((opposite + h).to_f64(), 0.0)?;
        let [k, j] = [k, j].map(|power| T::of(f64::from(power).exp2()));
        let scaled = vertices.map(|p| p * k);
        let (other, _) = normal::tangent(scaled, coordinates.map(|xy| xy.map(|c| c * j)))
            .expect("the property expects a tangent, and there is none");
        same_or_near(other, t, 0.0)
    });
}

/// The order in which the vertices are counted changes the edges, not the tangent.
fn first_vertex_does_not_matter<T: Number>() {
    check(triangle::<T>(), |given| {
        let ([a, b, c], [i, j, k]) = given;
        let turned = ([b, c, a], [j, k, i]);
        let conditioning = exact(&given).1 + exact(&turned).1;
        let direction = |(p, xy): Triangle<T>| -> UnitVec3<T> {
            normal::tangent(p, xy)
                .expect("the property expects a tangent, and there is none")
                .0
        };
        let k = if T::EVENLY_SPACED { 12.0 * 16.0 } else { 5.0 };
        near(
            direction(given),
            direction(turned),
            (k * conditioning + 9.0) * T::U,
        )
    });
}

properties! { tangent:
    tangent_points_where_the_map_grows,
    handedness_is_that_of_the_map,
    mirroring_the_map_turns_the_tangent,
    first_vertex_does_not_matter,
}
