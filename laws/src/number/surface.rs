//! Normals of implicit and parametric surfaces, by differentiation.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use proptest::sample::select;
use shading::{Dual, Elementary, Real, UnitVec3, Vec3, normal};

use super::Number;
use super::check::{by_spacing, check, equal_but_for_ties, near, same_or_near, to_f64, within};
use super::exact::dot;
use super::generators::exponent;

/// A surface with both an implicit and a parametric form.
#[derive(Clone, Copy, Debug)]
enum Surface {
    /// The lengths of the semi-axes.
    Ellipsoid([f64; 3]),
    /// The radii of the ring and of its tube.
    Torus([f64; 2]),
}

use Surface::{Ellipsoid, Torus};

impl Surface {
    /// f(p), 0 on the surface.
    fn implicit<T: Elementary>(self, p: Vec3<T>) -> T {
        match self {
            Ellipsoid(axes) => {
                let [x, y, z] = scaled(p, axes);
                x * x + y * y + z * z - T::ONE
            }
            Torus([ring, tube]) => {
                let aside = (p.x * p.x + p.y * p.y).sqrt() - T::of(ring);
                aside * aside + p.z * p.z - T::of(tube) * T::of(tube)
            }
        }
    }

    /// ∇f, derived by hand.
    fn gradient<T: Elementary>(self, p: Vec3<T>) -> Vec3<T> {
        match self {
            Ellipsoid(axes) => Vec3::from(scaled(scaled(p, axes).into(), axes)),
            Torus([ring, _]) => {
                let distance = (p.x * p.x + p.y * p.y).sqrt();
                let aside = (distance - T::of(ring)) / distance;
                Vec3::new(p.x * aside, p.y * aside, p.z)
            }
        }
    }

    /// s(u, v), where u is the azimuth, and v is the polar angle or the angle in the tube.
    fn parametric<T: Elementary>(self, u: T, v: T) -> Vec3<T> {
        match self {
            Ellipsoid([a, b, c]) => Vec3::new(
                u.cos() * v.sin() * T::of(a),
                u.sin() * v.sin() * T::of(b),
                v.cos() * T::of(c),
            ),
            Torus([ring, tube]) => {
                let radius = v.cos() * T::of(tube) + T::of(ring);
                Vec3::new(radius * u.cos(), radius * u.sin(), v.sin() * T::of(tube))
            }
        }
    }

    /// ∂s/∂u and ∂s/∂v, derived by hand.
    fn tangents<T: Elementary>(self, u: T, v: T) -> [Vec3<T>; 2] {
        let ((sin_u, cos_u), (sin_v, cos_v)) = ((u.sin(), u.cos()), (v.sin(), v.cos()));
        match self {
            Ellipsoid(axes) => {
                let [a, b, c] = axes.map(T::of);
                [
                    Vec3::new(-(sin_u * sin_v * a), cos_u * sin_v * b, T::ZERO),
                    Vec3::new(cos_u * cos_v * a, sin_u * cos_v * b, -(sin_v * c)),
                ]
            }
            Torus([ring, tube]) => {
                let tube = T::of(tube);
                let radius = cos_v * tube + T::of(ring);
                [
                    Vec3::new(-(radius * sin_u), radius * cos_u, T::ZERO),
                    Vec3::new(
                        -(sin_v * tube * cos_u),
                        -(sin_v * tube * sin_u),
                        cos_v * tube,
                    ),
                ]
            }
        }
    }

    /// The factor by which a parametric normal magnifies rounding. An ellipsoid has no normal at
    /// its poles.
    fn conditioning(self, v: f64) -> f64 {
        match self {
            Ellipsoid(_) => 1.0 / v.sin(),
            Torus(_) => 1.0,
        }
    }
}

fn scaled<T: Elementary>(p: Vec3<T>, axes: [f64; 3]) -> [T; 3] {
    let [a, b, c] = axes.map(T::of);
    [p.x / a, p.y / b, p.z / c]
}

/// A surface and the parameters of a point on it, away from a pole.
fn places<T: Number>() -> impl Strategy<Value = (Surface, T, T)> {
    let axis = || select(&[0.5, 0.75, 1.0, 1.5, 2.0][..]);
    let surface = prop_oneof![
        Just(Ellipsoid([1.0; 3])),
        [axis(), axis(), axis()].prop_map(Ellipsoid),
        (select(&[1.5, 2.0, 3.0][..]), select(&[0.5, 1.0][..])).prop_map(|(r, t)| Torus([r, t])),
    ];
    let pole = f64::max(0.01, 128.0 * T::U); // the tangents are told apart
    (surface, 0.0..TAU, pole..PI - pole).prop_map(|(surface, u, v)| (surface, T::of(u), T::of(v)))
}

/// The error of a normal of these surfaces. Sine and cosine are off by 2u each, the products by 2u
/// more, and the cross product by 4u: 10u of the tangents. The axes of the ellipsoids differ by a
/// factor of up to 4, so an error of a tangent may be four times as large in the normal; the unit
/// vector adds 3u.
///
/// In an evenly spaced type, a product of sine and cosine is off by 3u, and by u more for its axis of ½
/// or more: 5u of each axis. That makes 7u of the one tangent, relative to the sine of the polar angle,
/// and 9u of the other, again four times as large in the normal. The tangents of a torus are off by 20u
/// and 15u of their lengths, its gradient by 44u, and that of an ellipsoid by 48u.
fn tolerance<T: Number>(conditioning: f64) -> f64 {
    (by_spacing::<T>(40.0, 64.0) * conditioning + 3.0) * T::U
}

fn implicit<T: Number>(surface: Surface, p: Vec3<T>) -> UnitVec3<T> {
    normal::implicit(|p| surface.implicit(p), p)
        .expect("the property expects a smooth surface, and there is none")
}

fn parametric<T: Number>(surface: Surface, u: T, v: T) -> UnitVec3<T> {
    normal::parametric(|u, v| surface.parametric(u, v), u, v)
        .expect("the property expects a point away from the pole, and there is none")
}

/// (47) Implicit and parametric normals agree up to sign, within the errors of both. The point
/// itself is off by as much, and the surfaces bend by up to 8 within a unit of length.
fn implicit_and_parametric_normals_agree<T: Number>() {
    check(places::<T>(), |(surface, u, v)| {
        let of_parametric = parametric(surface, u, v);
        let of_implicit = implicit(surface, surface.parametric(u, v));
        let sign = T::of(
            to_f64(of_implicit)
                .into_iter()
                .zip(to_f64(of_parametric))
                .map(|(a, b)| a * b)
                .sum::<f64>()
                .signum(),
        );
        let conditioning = surface.conditioning(v.to_f64());
        near(
            *of_parametric * sign,
            *of_implicit,
            2.0 * tolerance::<T>(conditioning),
        )
    });
}

/// (48) f and c·f have the same normal for c > 0, exactly for a power of two, and opposite normals
/// for c < 0. Otherwise, each component of the gradient is off by 1u, and the two unit vectors by
/// 3u. In an evenly spaced type, the gradient is at least 1 and c times as long, and off by √3u; the two
/// unit vectors by 1u each.
fn factor_of_an_implicit_surface_does_not_matter<T: Number>() {
    let factors = 0.01..f64::min(T::MAX.to_f64() / 64.0, 100.0); // the gradient stays in the range
    check(
        (places::<T>(), factors, exponent::<T>(10, 10)),
        |((surface, u, v), c, k)| {
            let p = surface.parametric(u, v);
            let times = |c: f64| {
                normal::implicit(|p| surface.implicit(p) * T::of(c), p)
                    .expect("the property expects a smooth surface, and there is none")
            };
            let n = implicit(surface, p);
            same_or_near(times(f64::from(k).exp2()), n, 2.0 * 1.02)?;
            equal_but_for_ties(times(-f64::from(k).exp2()), -n)?;
            let tolerance = T::U * by_spacing::<T>(8.0, 1.75 / c + 2.1);
            near(times(c), n, tolerance)?;
            near(times(-c), -n, tolerance)
        },
    );
}

/// (49) The gradient is perpendicular to both tangents.
fn gradient_is_perpendicular_to_both_tangents<T: Number>() {
    check(places::<T>(), |(surface, u, v)| {
        let [u, v] = [
            Dual::point(Vec3::new(u, v, T::ZERO)).x,
            Dual::point(Vec3::new(u, v, T::ZERO)).y,
        ];
        let s = surface.parametric(u, v);
        let n = to_f64(implicit(surface, s.map(|c| c.value)));
        let tolerance = tolerance::<T>(surface.conditioning(v.to_f64()));
        for tangent in [s.map(|c| c.gradient.x), s.map(|c| c.gradient.y)].map(to_f64) {
            within(
                dot(n, tangent),
                2.0 * tolerance * dot(tangent, tangent).sqrt(),
            )?;
        }
        Ok(())
    });
}

/// (50) Swapping u and v negates the normal.
fn swapping_the_parameters_negates<T: Number>() {
    check(places::<T>(), |(surface, u, v)| {
        let swapped = normal::parametric(|v, u| surface.parametric(u, v), v, u);
        equal_but_for_ties(
            swapped.expect("the property expects a point away from the pole, and there is none"),
            -parametric(surface, u, v),
        )
    });
}

/// (50) Going along u and v at another speed changes nothing: exactly for a power of two, otherwise
/// within the rounding of each component of the tangents and of their product, 3u each. In an evenly
/// spaced type, it is the error of both normals, and the speed is not slower: short tangents lose bits.
fn speed_of_the_parameters_does_not_matter<T: Number>() {
    let slowest = by_spacing::<T>(0.1, 1.0);
    check(
        (places::<T>(), slowest..10.0, exponent::<T>(3, 3)),
        |((surface, u, v), pace, k)| {
            let n = parametric(surface, u, v);
            let at_pace = |pace: T| {
                let s = |u: Dual<T>, v: Dual<T>| {
                    surface.parametric(u.chain(u.value, pace), v.chain(v.value, pace))
                };
                normal::parametric(s, u, v)
                    .expect("the property expects a point away from the pole, and there is none")
            };
            let tolerance = 2.0 * tolerance::<T>(surface.conditioning(v.to_f64()));
            same_or_near(at_pace(T::of(f64::from(k).exp2())), n, tolerance / T::U)?;
            near(at_pace(T::of(pace)), n, tolerance)
        },
    );
}

/// (51) The differentiated normal is the same as the one derived by hand.
fn differentiated_normals_equal_those_derived_by_hand<T: Number>() {
    check(places::<T>(), |(surface, u, v)| {
        let tolerance = 2.0 * tolerance::<T>(surface.conditioning(v.to_f64()));
        let [s_u, s_v] = surface.tangents(u, v);
        let by_hand = normal::from_tangents(s_u, s_v)
            .expect("the property expects a point away from the pole, and there is none");
        near(parametric(surface, u, v), by_hand, tolerance)?;

        let p = surface.parametric(u, v);
        let by_hand = normal::from_gradient(surface.gradient(p))
            .expect("the property expects a smooth surface, and there is none");
        near(implicit(surface, p), by_hand, tolerance)
    });
}

/// (46) The apex of a cone and the pole of a sphere have no normal. An evenly spaced type need not have
/// the infinite slope of a root at 0, which tells the apex of a cone that is written with a root.
fn singular_points_have_no_normal<T: Number>() {
    check((0.1..10.0, 0.0..TAU), |(slope, u)| {
        let slope = T::of(slope);
        let cone = |p: Vec3<Dual<T>>| p.x * p.x + p.y * p.y - p.z * p.z * slope;
        prop_assert!(normal::implicit(cone, Vec3::ZERO).is_none());
        let round_cone = |p: Vec3<Dual<T>>| (p.x * p.x + p.y * p.y).sqrt() - p.z;
        prop_assert!(T::EVENLY_SPACED || normal::implicit(round_cone, Vec3::ZERO).is_none());
        let sphere = |u: Dual<T>, v| Ellipsoid([1.0; 3]).parametric(u, v);
        prop_assert!(normal::parametric(sphere, T::of(u), T::ZERO).is_none());
        Ok(())
    });
}

properties! { surface:
    implicit_and_parametric_normals_agree,
    factor_of_an_implicit_surface_does_not_matter,
    gradient_is_perpendicular_to_both_tangents,
    swapping_the_parameters_negates,
    speed_of_the_parameters_does_not_matter,
    differentiated_normals_equal_those_derived_by_hand,
    singular_points_have_no_normal,
}
