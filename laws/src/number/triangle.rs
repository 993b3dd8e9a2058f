//! Normals of triangles, planes and spheres, and vectors of any size.

use proptest::prelude::*;
use shading::{UnitVec3, Vec3, normal};

use super::Number;
use super::check::{
    by_spacing, check, equal_but_for_ties, is_short_of_range, near, same, scaled_size, to_f64,
    within,
};
use super::exact::{cross, dot, length, square_excess, subtract};
use super::generators::{adversarial_vector, dyadic_point, exponent, octaves, point, unit};

type Triangle<T> = [Vec3<T>; 3];

fn triangle<T: Number>() -> impl Strategy<Value = Triangle<T>> {
    // every other triangle is a sliver: its third vertex is next to the line through the first two
    let sliver = (point::<T>(), point(), point(), -2.0..2.0, 0.0..12.0).prop_map(
        |(a, b, aside, along, thin): (Vec3<T>, Vec3<T>, Vec3<T>, f64, f64)| {
            [
                a,
                b,
                a + (b - a) * T::of(along) + aside * T::of((-thin).exp2()),
            ]
        },
    );
    prop_oneof![[point(), point(), point()], sliver]
}

fn normal<T: Number>([a, b, c]: Triangle<T>) -> Option<UnitVec3<T>> {
    normal::triangle(a, b, c)
}

/// |e|²/(2·area) for the longest edge: the factor by which a triangle magnifies rounding.
fn conditioning<T: Number>(triangle: Triangle<T>) -> f64 {
    let [a, b, c] = triangle.map(to_f64);
    let [ab, ac, bc] = [subtract(b, a), subtract(c, a), subtract(c, b)];
    let longest = length(ab).max(length(ac)).max(length(bc));
    longest * longest / length(cross(ab, ac))
}

/// The error of a normal: the edges are off by 1u each, and the products of the cross product and
/// their difference by 2u, relative to the lengths of the edges; the unit vector is off by 3u.
///
/// In an evenly spaced type, the edges are exact. They are made as long as its range allows, so that the 2√3u of the
/// cross product are relative to the square of that; the unit vector is off by √3u.
fn tolerance<T: Number>(conditioning: f64) -> f64 {
    T::U * by_spacing::<T>(
        4.0 * conditioning + 3.0,
        3.58 / scaled_size::<T>().powi(2) * conditioning + 1.77,
    )
}

/// A triangle that has a normal, and its conditioning.
fn well_conditioned<T: Number>() -> impl Strategy<Value = (Triangle<T>, f64)> {
    triangle::<T>()
        .prop_map(|triangle| (triangle, conditioning(triangle)))
        .prop_filter("a line", |(_, conditioning)| *conditioning < 0.01 / T::U)
}

/// (41) A cyclic shift of the vertices changes little: each of the two normals has its own error.
fn cyclic_shift_changes_little<T: Number>() {
    check(well_conditioned::<T>(), |([a, b, c], conditioning)| {
        let n = normal([a, b, c]).expect("the property expects a triangle, and there is none");
        for shifted in [[b, c, a], [c, a, b]] {
            let shifted =
                normal(shifted).expect("the property expects the same triangle, and there is none");
            near(n, shifted, 2.0 * tolerance::<T>(conditioning))?;
        }
        Ok(())
    });
}

/// (42) Swapping two vertices negates the normal, exactly if the first vertex stays.
fn swapping_two_vertices_negates<T: Number>() {
    check(well_conditioned::<T>(), |([a, b, c], conditioning)| {
        let n = -normal([a, b, c]).expect("the property expects a triangle, and there is none");
        equal_but_for_ties(
            normal([a, c, b]).expect("the property expects the same triangle, and there is none"),
            n,
        )?;
        for swapped in [[b, a, c], [c, b, a]] {
            let swapped =
                normal(swapped).expect("the property expects the same triangle, and there is none");
            near(swapped, n, 2.0 * tolerance::<T>(conditioning))?;
        }
        Ok(())
    });
}

/// (43) The normal is perpendicular to each edge, and the vertices appear counter-clockwise.
fn normal_is_perpendicular_to_each_edge<T: Number>() {
    check(well_conditioned::<T>(), |(triangle, conditioning)| {
        let n =
            to_f64(normal(triangle).expect("the property expects a triangle, and there is none"));
        let [a, b, c] = triangle.map(to_f64);
        for edge in [subtract(b, a), subtract(c, a), subtract(c, b)] {
            within(dot(n, edge), tolerance::<T>(conditioning) * length(edge))?;
        }
        prop_assert!(dot(n, cross(subtract(b, a), subtract(c, a))) > 0.0);
        Ok(())
    });
}

/// (44) Moving a triangle on a dyadic grid changes nothing.
fn translating_a_triangle_on_a_grid_is_exact<T: Number>() {
    let grid = dyadic_point::<T>;
    check(([grid(), grid(), grid()], grid()), |(triangle, offset)| {
        optionally(normal(triangle.map(|p| p + offset)), normal(triangle))
    });
}

/// (45) A triangle 2^k times as large has the same normal, and so does the one mirrored in the
/// origin. In an evenly spaced type, the cross product may be computed at another size, and the normals
/// agree within the errors of both.
fn scaling_a_triangle_by_a_power_of_two_is_exact<T: Number>() {
    check((triangle::<T>(), exponent::<T>(16, 11)), |(triangle, k)| {
        let scale = T::of(f64::from(k).exp2());
        let scaled = normal(triangle.map(|p| p * scale));
        if is_short_of_range::<T>() {
            let conditioning = conditioning(triangle);
            prop_assume!(conditioning < 0.01 / T::U);
            let n = normal(triangle).expect("the property expects a triangle, and there is none");
            for other in [scaled, normal(triangle.map(|p| -p))] {
                let tolerance = 2.0 * tolerance::<T>(conditioning);
                near(
                    other.expect("the property expects a triangle, and there is none"),
                    n,
                    tolerance,
                )?;
            }
            return Ok(());
        }
        optionally(scaled, normal(triangle))?;
        optionally(normal(triangle.map(|p| -p)), normal(triangle))
    });
}

/// (45) From sizes at which the coordinates lose bits to sizes at which the edges overflow, the
/// error stays the same.
fn size_of_a_triangle_does_not_matter<T: Number>() {
    check(
        (well_conditioned::<T>(), octaves::<T>()),
        |((triangle, conditioning), k)| {
            let scale = T::of(k.exp2());
            let scaled = normal(triangle.map(|p| p * scale))
                .expect("the property expects a triangle of any size, and there is none");
            near(
                scaled,
                normal(triangle).expect("the property expects a triangle, and there is none"),
                2.0 * tolerance::<T>(conditioning),
            )
        },
    );
}

/// (46) A triangle has no normal if two vertices coincide or all three lie on a line.
fn degenerate_triangles_have_no_normal<T: Number>() {
    let grid = dyadic_point::<T>;
    check(
        (point::<T>(), point(), grid(), grid(), -1..=2_i8),
        |(a, b, p, q, k)| {
            for repeated in [[a, a, b], [a, b, a], [b, a, a], [a, a, a]] {
                prop_assert!(normal(repeated).is_none());
            }
            let r = p + (q - p) * T::of(k.into());
            prop_assert!(normal([p, q, r]).is_none());
            Ok(())
        },
    );
}

/// (46) For any vertices, the result is a unit vector or `None`, never NaN.
fn normals_have_length_one_or_are_none<T: Number>() {
    let any = adversarial_vector::<T>;
    check([any(), any(), any()], |[a, b, c]| {
        let normals = [
            normal([a, b, c]),
            normal::plane(a.x, a.y, a.z),
            normal::sphere(a, b),
            normal::from_gradient(c),
            normal::from_tangents(a, b),
        ];
        for n in normals.into_iter().flatten() {
            within(square_excess(to_f64(n)), T::U * by_spacing::<T>(6.0, 3.6))?;
        }
        Ok(())
    });
}

/// v/|v| for v of any size: the direction is right to 3u, and only zero has none. `unit_or` gives
/// the same, and its fallback for zero. An evenly spaced type has it right to 0.51 steps.
fn unit_vectors_are_right_at_any_size<T: Number>() {
    check((adversarial_vector::<T>(), unit()), |(v, fallback)| {
        let Some(n) = v.unit() else {
            prop_assert!(v == Vec3::ZERO);
            return same(v.unit_or(fallback), fallback);
        };
        same(v.unit_or(fallback), n)?;
        // first scaled to a moderate size, in steps that are exact in f64
        let v = to_f64(v);
        let largest = v.into_iter().fold(0.0, |a: f64, c| a.max(c.abs()));
        let exponent = largest.log2().floor();
        let tame =
            v.map(|c| c * (-exponent / 2.0).floor().exp2() * (exponent / -2.0).ceil().exp2());
        let length = length(tame);
        for (n, tame) in to_f64(n).into_iter().zip(tame) {
            within(n - tame / length, T::U * by_spacing::<T>(4.0, 1.02))?;
        }
        Ok(())
    });
}

/// The normal of a plane is that of its equation; the normal of a sphere points away from the
/// center, even near it.
fn planes_and_spheres_point_outward<T: Number>() {
    check(
        (point::<T>(), dyadic_point::<T>(), unit::<T>()),
        |(v, center, n)| {
            optionally(normal::plane(v.x, v.y, v.z), v.unit())?;
            optionally(normal::from_gradient(v), v.unit())?;
            let on_sphere = center + *n * T::of(2.0);
            // the point is off by 4u for a radius of 2, and the unit vectors by 4u
            near(
                normal::sphere(center, on_sphere).expect(
                    "the property expects a point that is not the center, and there is none",
                ),
                n,
                6.0 * T::U,
            )
        },
    );
}

fn optionally<T: Number>(
    a: Option<UnitVec3<T>>,
    b: Option<UnitVec3<T>>,
) -> Result<(), TestCaseError> {
    match (a, b) {
        (Some(a), Some(b)) => same(a, b),
        (a, b) => {
            prop_assert!(a.is_none() && b.is_none(), "{a:?} is not {b:?}");
            Ok(())
        }
    }
}

properties! { triangle:
    cyclic_shift_changes_little,
    swapping_two_vertices_negates,
    normal_is_perpendicular_to_each_edge,
    translating_a_triangle_on_a_grid_is_exact,
    scaling_a_triangle_by_a_power_of_two_is_exact,
    size_of_a_triangle_does_not_matter,
    degenerate_triangles_have_no_normal,
    normals_have_length_one_or_are_none,
    unit_vectors_are_right_at_any_size,
    planes_and_spheres_point_outward,
}
