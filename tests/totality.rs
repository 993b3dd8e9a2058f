//! What every function gives where its formula has no answer, and at the ends of the number types,
//! for `f32` and `f64`: a test for each row of `docs/totality.md`, which names them. Beside the
//! rows stand the sweeps that no row holds.

#![allow(clippy::float_cmp)] // results are compared exactly

#[path = "totality/casts.rs"]
mod casts;
#[path = "totality/duals.rs"]
mod duals;
#[path = "totality/invalid.rs"]
mod invalid;
#[path = "support/row.rs"]
mod row;
#[path = "totality/sweeps.rs"]
mod sweeps;
#[path = "totality/thresholds.rs"]
mod thresholds;

use std::f64::consts::{FRAC_1_PI, PI};

use kit::{Float, direction, rgb, vector};
use row::{each_gives, gives, row, units, value};
use shading::number::Mask;
use shading::term::{blinn, blinn_normalization, phong, phong_normalization};
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, IncidentLight, Light, Lobe, Material,
    PointLight, Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal,
    reflection, shade, term,
};

fn x<T: Real>(x: T) -> Vec3<T> {
    Vec3::new(x, T::ZERO, T::ZERO)
}

fn trusted<T: Real>(v: Vec3<T>) -> UnitVec3<T> {
    UnitVec3::assume_unit(v)
}

fn of<T: Real, const N: usize>(numbers: [f64; N]) -> [T; N] {
    numbers.map(T::of)
}

fn tiniest<T: Float>() -> T {
    T::of(T::TINIEST)
}

fn not_finite<T: Float>() -> [T; 3] {
    [T::INFINITY, -T::INFINITY, T::NAN]
}

/// From the smallest number to the largest.
fn sizes<T: Float>() -> [T; 5] {
    [
        tiniest(),
        T::of(T::MIN_POSITIVE),
        T::of(1e-20),
        T::ONE,
        T::MAX,
    ]
}

/// Whether a number is right to some u of itself.
fn near<T: Float>(x: T, expected: f64, units: f64) -> bool {
    x.to_f64() == expected || (x.to_f64() / expected - 1.0).abs() <= units * T::U
}

trait ToF64 {
    fn to_f64(self) -> f64;
}

impl<T: Float> ToF64 for T {
    fn to_f64(self) -> f64 {
        self.into()
    }
}

fn mirror<T: Real, M>(m: M) -> Material<T, M> {
    let [k_a, k_d, k_s] = [Rgb::WHITE; 3];
    Material { k_a, k_d, k_s, m }
}

fn falloff<T: Float>(a: f64, b: f64, c: f64) -> Attenuation<T> {
    Attenuation::new(T::of(a), T::of(b), T::of(c)).expect("coefficients")
}

fn inverse_square<T: Float>() -> Attenuation<T> {
    falloff(0.0, 0.0, 1.0)
}

fn lamp<T: Real>(position: Vec3<T>, attenuation: Attenuation<T>) -> PointLight<T> {
    PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation,
    }
}

fn spot<T: Float>(point: PointLight<T>, half_angle: f64) -> SpotLight<T> {
    let cone = Cone::from_half_angle(T::of(half_angle)).expect("a half-angle");
    SpotLight {
        point,
        axis: UnitVec3::NEG_X,
        cone,
    }
}

fn sun<T: Real>(l: UnitVec3<T>) -> IncidentLight<T> {
    DirectionalLight {
        l,
        intensity: Rgb::WHITE,
    }
    .at(Vec3::ZERO)
}

/// The sums of everything that comes from such lights onto mirrors, which face the eye.
fn shine<T: Real, const N: usize>(lights: [IncidentLight<T>; N]) -> [[Rgb<T>; 3]; 2] {
    [UnitVec3::Z, UnitVec3::X].map(|n| {
        [
            shade::lambert(n, &mirror(1), Rgb::BLACK, lights).total(),
            shade::phong(n, n, &mirror(1), Rgb::BLACK, lights).total(),
            shade::blinn_phong(n, n, &mirror(1), Rgb::BLACK, lights).total(),
        ]
    })
}

/// As many lights from above.
fn bright<T: Real, const N: usize>(intensity: T) -> [IncidentLight<T>; N] {
    [DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(intensity),
    }
    .at(Vec3::ZERO); N]
}

fn invalid<T: Float>() -> [T; 4] {
    [-T::ONE, -T::of(1e30), -T::INFINITY, T::NAN]
}

/// A right angle at the origin, whose map is the plane it lies in.
fn corner<T: Float>(size: T, map: T) -> ([Vec3<T>; 3], [[T; 2]; 3]) {
    let o = T::ZERO;
    (
        [Vec3::ZERO, x(size), Vec3::new(o, size, o)],
        [[o, o], [map, o], [o, map]],
    )
}

/// Whether a tangent is (3, −1, 0)/√10, to 8 roundings.
fn slants<T: Float>(tangent: Option<(UnitVec3<T>, T)>) -> bool {
    let root = 10.0_f64.sqrt();
    tangent.is_some_and(|(t, h)| {
        near(t.x, 3.0 / root, 8.0) && near(t.y, -1.0 / root, 8.0) && h == T::ONE
    })
}

/// A variable with this value.
fn variable<T: Real>(value: T) -> Dual<T> {
    Dual::point(x(value)).x
}

/// The value, and whether the slope is a finite number.
fn slope<T: Float>(dual: Dual<T>) -> (T, bool) {
    (dual.value, dual.gradient.x.to_f64().is_finite())
}

fn globe<T: Elementary>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos())
}

/// The normal of (k u, v, 0), whose tangents are in the ratio k, and that with u and v exchanged.
fn thin<T: Float>(k: f64, size: f64) -> [Option<UnitVec3<T>>; 2] {
    let [k, size]: [T; 2] = of([k * size, size]);
    let s = |u: Dual<T>, v: Dual<T>| Vec3::new(u * k, v * size, Dual::ZERO);
    [
        normal::parametric(s, T::ONE, T::ONE),
        normal::parametric(|v, u| s(u, v), T::ONE, T::ONE),
    ]
}

fn is_nan<T: Float>(x: T) -> bool {
    x.to_f64().is_nan()
}

mod numbers {
    use super::*;

    each_gives!(
        selection_above_zero,
        [tiniest(), T::ONE, T::INFINITY],
        |x: T| {
            let is = x.above(T::ZERO);
            (is.any(), is.select(T::ONE, T::ZERO))
        },
        (true, T::ONE)
    );
    each_gives!(
        selection_of_zero,
        [T::ZERO, -T::ZERO, -tiniest::<T>(), T::NAN],
        |x: T| {
            let is = x.above(T::ZERO);
            (is.any(), is.select(T::ONE, T::ZERO))
        },
        (false, T::ZERO)
    );
    each_gives!(
        literal_in_single_precision,
        [0.1, f32::MAX],
        |x: f32| T::of_f32(x) == T::of(x.into()),
        true
    );
    each_gives!(
        root_below_zero,
        [-tiniest::<T>(), -T::ONE, -T::INFINITY],
        |x: T| is_nan(x.sqrt()),
        true
    );
    each_gives!(
        logarithm_below_zero,
        [-tiniest::<T>(), -T::ONE, -T::INFINITY],
        |x: T| is_nan(x.ln()),
        true
    );
}

mod vectors {
    use super::*;

    /// Its square overflows.
    fn large<T: Float>(x: f64, y: f64) -> Vec3<T> {
        vector::<T>([x, y, 0.0]) * (T::MAX.sqrt() * T::of(2.0))
    }

    gives!(
        dot_product_that_overflows,
        large::<T>(1.0, 1.0).dot(large(1.0, 1.0)),
        T::INFINITY
    );
    gives!(
        dot_product_of_infinities,
        is_nan(large::<T>(1.0, 1.0).dot(large(1.0, -1.0))),
        true
    );
    gives!(
        cross_product_that_overflows,
        large::<T>(1.0, 1.0).cross(large(1.0, -1.0)).z,
        -T::INFINITY
    );
    gives!(
        cross_product_with_itself_that_overflows,
        is_nan(large::<T>(1.0, 1.0).cross(large(1.0, 1.0)).z),
        true
    );
    gives!(
        cross_product_with_itself,
        {
            let c = vector::<T>([1.0, 2.0, 3.0]) * T::of(0.1) * T::MAX.sqrt();
            c.cross(c)
        },
        Vec3::<T>::ZERO
    );
    gives!(
        length_that_overflows,
        Vec3::new(T::MAX, T::ZERO, T::MAX).length(),
        T::MAX
    );
    gives!(
        length_of_infinity,
        Vec3::new(T::ZERO, -T::INFINITY, T::ONE).length(),
        T::INFINITY
    );
    gives!(
        length_of_nan,
        Vec3::new(T::ONE, T::NAN, T::ONE).length(),
        T::NAN
    );
    gives!(length_of_zero, Vec3::<T>::ZERO.length(), T::ZERO);

    // (1, 2, 2)/3; the squares, sums and root are off by 2.5u, and the division by 1u
    row!(unit_at_any_size, {
        for size in [
            tiniest(),
            T::of(T::MIN_POSITIVE),
            T::ONE,
            T::MAX * T::of(0.5),
        ] {
            let n = (vector::<T>([1.0, 2.0, 2.0]) * size)
                .unit()
                .expect("finite");
            assert!(
                near(n.x, 1.0 / 3.0, 3.5) && near(n.y, 2.0 / 3.0, 3.5),
                "{n:?}"
            );
            assert_eq!(n.z, n.y);
        }
    });
    gives!(no_direction_of_zero, Vec3::<T>::ZERO.unit(), None);
    gives!(
        no_direction_of_negative_zero,
        (-Vec3::<T>::ZERO).unit(),
        None
    );
    each_gives!(
        no_direction_of_what_is_not_finite,
        not_finite::<T>(),
        |c: T| Vec3::new(T::ONE, c, c).unit(),
        None
    );
    gives!(
        unit_or_of_zero,
        Vec3::<T>::ZERO.unit_or(UnitVec3::Y),
        UnitVec3::Y
    );
    each_gives!(
        unit_or_of_what_is_not_finite,
        not_finite::<T>(),
        |c: T| Vec3::new(T::ONE, c, c).unit_or(UnitVec3::Y),
        UnitVec3::Y
    );
    gives!(
        unit_or_of_a_direction,
        vector::<T>([3.0, 0.0, 4.0]).unit_or(UnitVec3::Y),
        direction::<T>([3.0, 0.0, 4.0])
    );

    fn new<T: Float>([x, y, z]: [f64; 3]) -> Option<UnitVec3<T>> {
        UnitVec3::new(T::of(x), T::of(y), T::of(z))
    }
    each_gives!(
        new_of_length_1,
        [
            [0.0, 0.0, 1.0],
            [0.6, 0.0, -0.8],
            [-0.48, 0.6, 0.64],
            [1.0 / 3.0_f64.sqrt(); 3]
        ],
        |v: [f64; 3]| new(v).map(|u: UnitVec3<T>| *u) == Some(vector::<T>(v)),
        true
    );
    each_gives!(
        new_of_another_length,
        [
            [1.0, 0.0, 1.0],
            [3e30, 0.0, 4e30],
            [-0.4, 0.3, 0.8],
            [0.0, 0.0, T::TINIEST]
        ],
        |v: [f64; 3]| new(v) == vector::<T>(v).unit(),
        true
    );
    gives!(new_of_the_zero_vector, new::<T>([0.0; 3]), None);
    // the square of the length is off by 16ε, that of a rounded unit vector by 4ε at most
    each_gives!(
        new_of_almost_length_1,
        [
            [0.6, 0.0, 0.8].map(|c| c * (1.0 - 16.0 * T::U)),
            [0.6, 0.8, 0.0].map(|c| c * (1.0 + 16.0 * T::U))
        ],
        |v: [f64; 3]| new(v).is_some_and(|u: UnitVec3<T>| {
            Into::<f64>::into(u.dot(u) - T::ONE).abs() <= 8.0 * T::U && *u != vector::<T>(v)
        }),
        true
    );
    each_gives!(
        new_of_what_is_not_finite,
        [
            [f64::NAN, 0.0, 1.0],
            [f64::INFINITY, 0.0, 0.0],
            [0.0, f64::NEG_INFINITY, 0.0]
        ],
        new::<T>,
        None
    );
    gives!(
        assume_unit_changes_nothing,
        *trusted(vector::<T>([1.0, 2.0, 3.0])),
        vector::<T>([1.0, 2.0, 3.0])
    );

    each_gives!(
        half_vector_of_opposites,
        [[0.0, 0.0, 1.0], [1.0, 2.0, 3.0], [-5.0, 0.1, 7.0]].map(direction::<T>),
        |l: UnitVec3<T>| half_vector(l, -l),
        None
    );
    // both are of length 1 up to rounding, and their sum is (0, 0, tiny)
    each_gives!(
        half_vector_of_nearly_opposites,
        [tiniest(), T::of(T::MIN_POSITIVE), T::of(T::U)],
        |tiny: T| half_vector(trusted(Vec3::new(T::ONE, T::ZERO, tiny)), UnitVec3::NEG_X),
        Some(UnitVec3::<T>::Z)
    );
    gives!(
        half_vector_of_nan,
        half_vector(trusted(x(T::NAN)), UnitVec3::X),
        None
    );
    // 2(N·L)N − L for |N| = 2: 2·4·2 − 1
    gives!(
        reflection_in_a_long_normal,
        reflection(trusted(x(T::of(2.0))), UnitVec3::X).x,
        T::of(7.0)
    );
    gives!(
        reflection_of_nan,
        reflection(trusted(x(T::NAN)), UnitVec3::X).x,
        T::NAN
    );
}

mod normals {
    use super::*;

    fn x_y_z<T: Real>() -> [UnitVec3<T>; 3] {
        [UnitVec3::X, UnitVec3::Y, UnitVec3::Z]
    }

    gives!(
        plane_without_a_direction,
        normal::plane(T::ZERO, T::ZERO, T::ZERO),
        None
    );
    each_gives!(
        plane_that_is_not_finite,
        not_finite::<T>(),
        |a: T| normal::plane(a, T::ONE, T::ZERO),
        None
    );

    /// Two points and the middle between them.
    fn on_a_line<T: Float>() -> [Vec3<T>; 3] {
        [[1.0, 2.0, 3.0], [4.0, 6.0, 8.0], [2.5, 4.0, 5.5]].map(vector)
    }
    fn triangle_and_corner<T: Float>([a, b, c]: [Vec3<T>; 3]) -> (Option<UnitVec3<T>>, Vec3<T>) {
        (normal::triangle(a, b, c), normal::corner(a, b, c))
    }
    gives!(
        degenerate_triangle_of_a_point,
        {
            let [a, ..] = on_a_line::<T>();
            triangle_and_corner([a, a, a])
        },
        (None, Vec3::ZERO)
    );
    each_gives!(
        degenerate_triangle_of_two_points,
        {
            let [a, b, _] = on_a_line::<T>();
            [[a, a, b], [a, b, a], [a, b, b]]
        },
        triangle_and_corner::<T>,
        (None, Vec3::ZERO)
    );
    each_gives!(
        degenerate_triangle_on_a_line,
        {
            let [a, b, middle] = on_a_line::<T>();
            [[a, middle, b], [middle, a, b]]
        },
        triangle_and_corner::<T>,
        (None, Vec3::ZERO)
    );
    row!(triangle_to_infinity, {
        for far in not_finite::<T>().map(x) {
            let [a, b] = [x(T::ONE), *UnitVec3::Y];
            for corners in [[far, a, b], [a, far, b], [a, b, far], [far; 3]] {
                assert_eq!(
                    triangle_and_corner(corners),
                    (None, Vec3::ZERO),
                    "{corners:?}"
                );
            }
        }
    });

    /// The edges are (2, 0, 0) and (1, 1, 0) times the largest number.
    fn largest<T: Float>() -> [Vec3<T>; 3] {
        [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|v| vector::<T>(v) * T::MAX)
    }
    gives!(
        triangle_whose_edges_overflow,
        {
            let [a, b, c] = largest::<T>();
            [normal::triangle(a, b, c), normal::triangle(a, c, b)]
        },
        [Some(UnitVec3::Z), Some(UnitVec3::NEG_Z)]
    );
    gives!(
        triangle_whose_edge_overflows_in_a_coordinate,
        {
            let [a, b, _] = largest::<T>();
            normal::triangle(a, b, Vec3::new(-T::MAX, T::ONE, T::ZERO))
        },
        Some(UnitVec3::Z)
    );
    gives!(
        tiny_triangle_far_out,
        normal::triangle(
            x(T::MAX),
            Vec3::new(T::MAX, tiniest(), T::ZERO),
            Vec3::new(T::MAX, T::ZERO, tiniest())
        ),
        Some(UnitVec3::X)
    );

    gives!(
        sphere_at_its_center,
        normal::sphere(x(T::ONE), x(T::ONE)),
        None
    );
    gives!(
        sphere_from_end_to_end,
        normal::sphere(x(-T::MAX), x(T::MAX)),
        Some(UnitVec3::X)
    );
    gives!(
        sphere_back_from_end_to_end,
        normal::sphere(x(T::MAX), x(-T::MAX)),
        Some(UnitVec3::NEG_X)
    );
    each_gives!(
        sphere_around_infinity,
        not_finite::<T>(),
        |c: T| normal::sphere(x(c), x(T::ONE)),
        None
    );
    each_gives!(
        sphere_to_infinity,
        not_finite::<T>(),
        |p: T| normal::sphere(x(T::ONE), x(p)),
        None
    );

    gives!(
        gradient_of_zero,
        normal::from_gradient(Vec3::<T>::ZERO),
        None
    );
    each_gives!(
        gradient_that_is_not_finite,
        not_finite::<T>(),
        |c: T| normal::from_gradient(x(c)),
        None
    );
    each_gives!(
        tangents_of_zero_or_infinity,
        [T::ZERO, T::INFINITY, -T::INFINITY, T::NAN].map(x),
        |v: Vec3<T>| [
            normal::from_tangents(v, *UnitVec3::Y),
            normal::from_tangents(*UnitVec3::Y, v)
        ],
        [None; 2]
    );
    row!(tangents_of_any_length, {
        for a in sizes::<T>() {
            for b in sizes() {
                let across = normal::from_tangents(x(a), *UnitVec3::Y * b);
                assert_eq!(across, Some(UnitVec3::Z), "{a:e} {b:e}");
                assert_eq!(normal::from_tangents(x(a), x(b)), None, "{a:e} {b:e}");
            }
        }
    });

    fn cone<T: Real>(p: Vec3<Dual<T>>) -> Dual<T> {
        p.x * p.x + p.y * p.y - p.z * p.z
    }
    // ∇(x² + y² − z²) = 0
    gives!(
        implicit_at_the_apex_of_a_cone,
        normal::implicit(cone, Vec3::<T>::ZERO),
        None
    );
    gives!(
        implicit_on_a_cone,
        normal::implicit(cone, vector::<T>([3.0, 4.0, 5.0])).is_some(),
        true
    );
    // √x has no gradient at 0, ln x none below 0
    gives!(
        implicit_without_a_gradient,
        normal::implicit(|p: Vec3<Dual<T>>| p.x.sqrt(), Vec3::ZERO),
        None
    );
    gives!(
        implicit_where_undefined,
        normal::implicit(|p: Vec3<Dual<T>>| p.x.ln() + p.z, x(-T::ONE)),
        None
    );
    gives!(
        implicit_where_undefined_under_a_bar,
        normal::implicit(|p: Vec3<Dual<T>>| p.x.ln().abs() + p.z, x(-T::ONE)),
        None
    );

    gives!(
        parametric_at_a_pole,
        normal::parametric(globe, T::ONE, T::ZERO),
        None
    );
    // sin π is not 0 but the rounding of π, at most 2u
    gives!(
        parametric_at_a_rounded_pole,
        normal::parametric(globe, T::ONE, T::of(PI)),
        None
    );
    gives!(
        parametric_of_parallel_tangents,
        normal::parametric(
            |u: Dual<T>, v| Vec3::new(u + v, u + v, u + v),
            T::ONE,
            T::ONE
        ),
        None
    );
    row!(tangents_of_noise, {
        for size in [1e-30, 1.0, 1e30] {
            assert_eq!(thin::<T>(32.0 * T::U, size), [None; 2], "{size:e}");
            assert_eq!(thin::<T>(0.0, size), [None; 2], "{size:e}");
        }
    });
    row!(tangents_above_noise, {
        for size in [1e-30, 1.0, 1e30] {
            for k in [32.0 * T::U * (1.0 + 2.0 * T::U), 64.0 * T::U, 0.5, 1.0] {
                let normals = [Some(UnitVec3::Z), Some(UnitVec3::NEG_Z)];
                assert_eq!(thin::<T>(k, size), normals, "{size:e} {k:e}");
            }
        }
    });

    each_gives!(
        facing_edge_on,
        x_y_z::<T>().map(|n| n.cross(UnitVec3::Z)),
        |n: Vec3<T>| *normal::facing(trusted(n), UnitVec3::Z, trusted(n)) == n,
        true
    );
    each_gives!(
        facing_nan,
        [UnitVec3::<T>::X, UnitVec3::NEG_X],
        |n: UnitVec3<T>| normal::facing(n, trusted(x(T::NAN)), n) == n
            && normal::facing(n, -n, trusted(x(T::NAN))) == n,
        true
    );

    fn transformed<T: Float>(columns: [Vec3<T>; 3]) -> [Option<UnitVec3<T>>; 3] {
        x_y_z().map(|n| normal::transformed(n, columns))
    }
    // projected onto the plane z = 0, that plane keeps its normal, and a wall becomes a line
    gives!(
        flattened_onto_a_plane,
        {
            let [i, j, _] = x_y_z::<T>();
            transformed([*i, *j, Vec3::ZERO])
        },
        [None, None, Some(UnitVec3::Z)]
    );
    gives!(
        flattened_onto_a_line,
        {
            let i = *UnitVec3::<T>::X;
            transformed([i, i * T::of(2.0), -i])
        },
        [None; 3]
    );
    gives!(
        flattened_onto_a_point,
        transformed([Vec3::<T>::ZERO; 3]),
        [None; 3]
    );
    row!(columns_that_are_not_finite, {
        for bad in not_finite::<T>() {
            for size in [tiniest(), T::ONE, T::MAX] {
                for i in 0..3 {
                    let mut columns = x_y_z().map(|axis| *axis * size);
                    columns[i] /= size;
                    columns[i].y = bad;
                    assert_eq!(transformed(columns), [None; 3], "{columns:?}");
                }
            }
        }
    });
    row!(columns_of_any_size, {
        let all = || sizes::<T>().into_iter();
        for (a, b, c) in all().flat_map(|a| all().flat_map(move |b| all().map(move |c| (a, b, c))))
        {
            let columns = [x(a), *UnitVec3::Y * b, *UnitVec3::Z * c];
            assert_eq!(transformed(columns), x_y_z().map(Some), "{columns:?}");
        }
    });
    // (1, 1, 0) stretched by a along x and y, and by any size along z; the unit vectors round
    row!(columns_of_any_size_and_a_slanted_normal, {
        for (a, c) in sizes::<T>()
            .into_iter()
            .flat_map(|a| sizes().map(|c| (a, c)))
        {
            let d = direction::<T>([1.0, 1.0, 0.0]);
            let columns = [x(a), *UnitVec3::Y * a, *UnitVec3::Z * c];
            let n = normal::transformed(d, columns).expect("a normal");
            assert!(
                (n.x - d.x).to_f64().abs() <= 4.0 * T::U && n.y == n.x,
                "{n:?}"
            );
        }
    });

    // 90° and 45°; the edges of the largest triangle overflow
    row!(corners_of_any_size, {
        for size in [T::TINIEST, T::MIN_POSITIVE, 1e-20, 1.0, 1e20, T::MAX.into()] {
            let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]];
            let [a, b, c] = corners.map(|v| vector::<T>(v) * T::of(size));
            for ([a, b, c], angle) in [
                ([a, b, c], PI / 2.0),
                ([b, c, a], PI / 4.0),
                ([c, a, b], PI / 4.0),
            ] {
                let corner = normal::corner(a, b, c);
                assert!(near(corner.z, angle, 8.0), "{size:e}: {corner:?}");
                assert_eq!(normal::corner(a, c, b), -corner, "{size:e}");
            }
        }
    });
}

mod tangents {
    use super::*;

    /// The right angle at the origin, with the texture coordinates of these corners.
    fn tangent<T: Float>(order: [usize; 3]) -> Option<(UnitVec3<T>, T)> {
        let (vertices, map) = corner::<T>(T::ONE, T::ONE);
        normal::tangent(vertices, order.map(|i| map[i]))
    }
    each_gives!(
        no_map_of_two_points,
        [[0, 0, 0], [0, 1, 1], [0, 1, 0], [1, 1, 2]],
        tangent::<T>,
        None
    );
    gives!(
        no_map_on_a_line,
        {
            let (vertices, [a, b, _]) = corner::<T>(T::ONE, T::ONE);
            normal::tangent(vertices, [a, [T::of(2.0), T::ZERO], b])
        },
        None
    );
    gives!(
        no_triangle_under_the_map,
        {
            let ([o, a, _], map) = corner::<T>(T::ONE, T::ONE);
            [
                normal::tangent([o, o, o], map),
                normal::tangent([o, o, a], map),
            ]
        },
        [None; 2]
    );
    each_gives!(
        map_of_a_triangle_to_infinity,
        not_finite::<T>(),
        |bad: T| {
            let (_, map) = corner::<T>(T::ONE, T::ONE);
            normal::tangent([Vec3::ZERO, x(bad), x(T::ONE)], map)
        },
        None
    );
    each_gives!(
        map_to_infinity,
        not_finite::<T>(),
        |bad: T| {
            let (vertices, [a, b, c]) = corner::<T>(T::ONE, T::ONE);
            [
                normal::tangent(vertices, [a, [bad, T::ZERO], c]),
                normal::tangent(vertices, [a, b, [T::ZERO, bad]]),
            ]
        },
        [None; 2]
    );
    // half of the smallest number is 0; with the second and third coordinates exchanged, x and y
    // are
    row!(maps_of_any_size, {
        let sizes = || [T::of(2.0 * T::TINIEST), T::ONE, T::MAX];
        for (size, map) in sizes()
            .into_iter()
            .flat_map(|size| sizes().map(|map| (size, map)))
        {
            let (vertices, [a, b, c]) = corner(size, map);
            let tangent = normal::tangent(vertices, [a, b, c]);
            assert_eq!(tangent, Some((UnitVec3::X, T::ONE)), "{size:e} {map:e}");
            let tangent = normal::tangent(vertices, [a, c, b]);
            assert_eq!(tangent, Some((UnitVec3::Y, -T::ONE)), "{size:e} {map:e}");
        }
    });
    gives!(
        map_whose_differences_overflow,
        {
            let max = T::MAX;
            let map = [[-max, -max], [max, -max], [-max, max]];
            normal::tangent(map.map(|[x, y]| Vec3::new(x, y, T::ZERO)), map)
        },
        Some((UnitVec3::X, T::ONE))
    );
    // T = e₂y₃ − e₃y₂ = 3e₂ − e₃, however x and y are scaled
    each_gives!(
        map_scaled_unevenly,
        [
            [0.0, 0.0],
            [-73.0, 73.0],
            [73.0, -73.0],
            [-120.0, 120.0],
            [120.0, -120.0]
        ],
        |[a, b]: [f64; 2]| {
            let (vertices, _) = corner::<T>(T::ONE, T::ONE);
            let map = [[0.0, 0.0], [3.0, 1.0], [-1.0, 3.0]];
            let map = map.map(|[x, y]: [f64; 2]| of([x * a.exp2(), y * b.exp2()]));
            slants(normal::tangent(vertices, map))
        },
        true
    );
    row!(map_and_triangle_scaled, {
        let exponents = || [-73.0_f64, 73.0, -120.0, 120.0].into_iter();
        for (a, b) in exponents().flat_map(|a| exponents().map(move |b| (a, b))) {
            let (vertices, _) = corner::<T>(T::of(a.exp2()), T::ONE);
            let map = [[0.0, 0.0], [3.0, 1.0], [-1.0, 3.0]];
            let map = map.map(|xy: [f64; 2]| of(xy.map(|x| x * b.exp2())));
            assert!(slants(normal::tangent(vertices, map)), "{a} {b}");
        }
    });

    each_gives!(
        no_frame_for_a_map,
        [
            *UnitVec3::<T>::Z,
            *UnitVec3::NEG_Z,
            *UnitVec3::Z * T::MAX,
            *UnitVec3::Z * tiniest(),
            Vec3::ZERO
        ],
        |t: Vec3<T>| normal::mapped(UnitVec3::Z, t, T::ONE, *UnitVec3::X),
        None
    );
    each_gives!(
        no_tangent,
        [T::ZERO, T::INFINITY, -T::INFINITY, T::NAN],
        |c: T| normal::mapped(UnitVec3::Z, x(c), T::ONE, *UnitVec3::Z),
        None
    );
    each_gives!(
        no_sample,
        [T::ZERO, T::INFINITY, -T::INFINITY, T::NAN],
        |c: T| normal::mapped(UnitVec3::Z, *UnitVec3::X, T::ONE, x(c)),
        None
    );
    each_gives!(
        samples_of_any_length,
        [tiniest(), T::ONE, T::MAX],
        |size: T| {
            let map = |sample| normal::mapped(UnitVec3::Z, x(size), T::ONE, sample);
            [map(x(size)), map(Vec3::new(T::ZERO, T::ZERO, size))]
        },
        [Some(UnitVec3::X), Some(UnitVec3::Z)]
    );
    // ⅛ is the last bit of the sample, and the largest size a power of two
    each_gives!(
        slanted_samples_of_any_length,
        [
            8.0 * T::TINIEST,
            T::MIN_POSITIVE,
            0.5 * T::MAX.to_f64() * (1.0 + 2.0 * T::U)
        ],
        |size: f64| {
            let sample = |size| vector([-1.0, 0.75, 0.875]) * T::of(size);
            let (n, t) = (direction([2.0, -1.0, 3.0]), vector([1.0, 4.0, -2.0]));
            let mapped = |size| normal::mapped(n, t, T::ONE, sample(size));
            mapped(size) == mapped(1.0) && mapped(size).is_some()
        },
        true
    );
    each_gives!(
        handedness_above_zero,
        [T::ONE, T::of(0.1)],
        |h: T| normal::mapped(UnitVec3::Z, *UnitVec3::X, h, *UnitVec3::Y),
        Some(UnitVec3::Y)
    );
    // a number without a sign counts as negative
    each_gives!(
        handedness_of_zero_or_nan,
        [T::ZERO, -T::ONE, T::NAN],
        |h: T| normal::mapped(UnitVec3::Z, *UnitVec3::X, h, *UnitVec3::Y),
        Some(UnitVec3::NEG_Y)
    );
}

mod terms {
    use super::*;

    const WHOLE: [u32; 5] = [0, 1, 2, 1000, u32::MAX];

    fn dark<T: Float>() -> [T; 5] {
        [T::NAN, -T::ONE, -tiniest::<T>(), -T::ZERO, T::ZERO]
    }

    /// Both highlights of this cosine.
    fn highlights<T: Float, M: Lobe<T> + Copy>(cosine: T, m: M) -> [T; 2] {
        let v = trusted(x(cosine));
        [phong(v, UnitVec3::X, m), blinn(v, UnitVec3::X, m)]
    }

    each_gives!(
        lambert_behind,
        [-T::ONE, T::ZERO],
        |c: T| term::lambert(trusted(x(c)), UnitVec3::X),
        T::ZERO
    );
    gives!(
        lambert_of_nan,
        term::lambert(trusted(x(T::NAN)), UnitVec3::X),
        T::ZERO
    );
    each_gives!(
        highlight_in_the_dark,
        dark::<T>(),
        |c: T| WHOLE.map(|m| highlights(c, m)),
        [[T::ZERO; 2]; 5]
    );
    each_gives!(
        highlight_in_the_dark_of_a_real_exponent,
        dark::<T>(),
        |c: T| of::<T, 4>([0.0, 0.5, 1.0, 1e30]).map(|m| highlights(c, m)),
        [[T::ZERO; 2]; 4]
    );
    each_gives!(
        highlight_of_exponent_0,
        [tiniest(), T::of(0.5), T::ONE],
        |c: T| [highlights(c, 0), highlights(c, T::ZERO)],
        [[T::ONE; 2]; 2]
    );
    // N·N exceeds 1 by two units in the last place: 1.0000002^1000000 would be 1.27
    each_gives!(
        cosine_above_1,
        [1.0, 1.0 + 2.0 * T::U, 2.0],
        |c: f64| WHOLE.map(|m| highlights(T::of(c), m)),
        [[T::ONE; 2]; 5]
    );
    each_gives!(
        cosine_above_1_of_a_real_exponent,
        [1.0, 1.0 + 2.0 * T::U, 2.0],
        |c: f64| of::<T, 3>([0.5, 1e6, 1e30]).map(|m| highlights(T::of(c), m)),
        [[T::ONE; 2]; 3]
    );
    gives!(
        cosine_above_1_in_a_sum,
        {
            let (n, m) = (trusted(x(T::of(1.0 + 2.0 * T::U))), T::of(1e6));
            [
                shade::blinn_phong(n, n, &mirror(m), Rgb::BLACK, [sun(n)]),
                shade::phong(n, n, &mirror(m), Rgb::BLACK, [sun(n)]),
            ]
            .map(|s| s.specular)
        },
        [Rgb::<T>::WHITE; 2]
    );
    // (1 − 2⁻¹²)^(2³² − 1) < e^(−2²⁰), which is 0 in every float
    each_gives!(
        huge_exponent,
        [T::of(1e30), T::MAX, T::INFINITY],
        |m: T| {
            let below_1 = T::of(1.0 - 2.0_f64.powi(-12));
            [
                highlights(below_1, m),
                highlights(below_1, u32::MAX),
                highlights(T::ONE, m),
            ]
        },
        [[T::ZERO; 2], [T::ZERO; 2], [T::ONE; 2]]
    );
    each_gives!(
        invalid_exponent,
        invalid::<T>(),
        |m: T| {
            let sum = shade::blinn_phong(
                UnitVec3::Z,
                direction([3.0, 0.0, 4.0]),
                &mirror(m),
                Rgb::BLACK,
                [sun(UnitVec3::Z)],
            );
            [highlights(T::of(0.8), m), [sum.specular.r; 2]]
        },
        [[T::ONE; 2]; 2]
    );

    // a highlight that is 1 everywhere is Lambert's: 2/(2π) = 2·4/(8π) = 1/π, with three roundings
    value!(
        normalization_of_phong_0,
        phong_normalization(T::ZERO),
        FRAC_1_PI,
        units(3.0)
    );
    value!(
        normalization_of_blinn_0,
        blinn_normalization(T::ZERO),
        FRAC_1_PI,
        units(3.0)
    );
    // (m + 2)/(2π), and (m + 6 + 8/m)/(8π), with seven roundings
    row!(normalization_of_a_huge_exponent, {
        for m in [T::of(1e30), T::MAX] {
            assert!(
                near(phong_normalization(m), m.to_f64() * FRAC_1_PI * 0.5, 7.0),
                "{m:e}"
            );
            assert!(
                near(blinn_normalization(m), m.to_f64() * FRAC_1_PI * 0.125, 7.0),
                "{m:e}"
            );
        }
    });
    gives!(
        normalization_of_an_infinite_exponent,
        [
            phong_normalization(T::INFINITY),
            blinn_normalization(T::INFINITY)
        ],
        [phong_normalization(T::MAX), blinn_normalization(T::MAX)]
    );
    each_gives!(
        normalization_of_an_invalid_exponent,
        invalid::<T>(),
        |m: T| [phong_normalization(m), blinn_normalization(m)],
        [phong_normalization(T::ZERO), blinn_normalization(T::ZERO)]
    );
}

mod falloffs {
    use super::*;

    fn at<T: Float>(abcq: [f64; 4]) -> T {
        let [a, b, c, q] = of(abcq);
        attenuation(a, b, c, q)
    }

    each_gives!(
        attenuation_without_a_denominator,
        [
            [0.0, 0.0, 0.0, 1.0],
            [0.0, 1.0, 1.0, 0.0],
            [0.0, 0.0, 1.0, -0.0],
            [-0.0, 0.0, 1.0, 0.0]
        ],
        at::<T>,
        T::MAX
    );
    each_gives!(
        attenuation_below_zero,
        [[-1.0, 0.0, 0.0, 1.0], [-0.0, 0.0, 1.0, -0.0]],
        at::<T>,
        T::ZERO
    );
    each_gives!(
        attenuation_of_nan,
        [[f64::NAN, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, f64::NAN]],
        at::<T>,
        T::ZERO
    );
    each_gives!(
        attenuation_over_an_overflow,
        [[T::ZERO, T::ONE, T::MAX], [T::MAX; 3]],
        |[b, c, q]: [T; 3]| attenuation(b, b, c, q),
        T::ZERO
    );

    each_gives!(
        bad_coefficients,
        [-T::ONE, -tiniest::<T>(), T::INFINITY, -T::INFINITY, T::NAN],
        |bad: T| {
            [
                Attenuation::new(bad, T::ONE, T::ONE),
                Attenuation::new(T::ONE, bad, T::ONE),
                Attenuation::new(T::ONE, T::ONE, bad),
            ]
        },
        [None; 3]
    );
    gives!(
        no_coefficients,
        Attenuation::new(T::ZERO, T::ZERO, T::ZERO),
        None
    );
    gives!(
        no_coefficients_of_negative_zero,
        Attenuation::new(-T::ZERO, T::ZERO, T::ZERO),
        None
    );
    each_gives!(
        one_coefficient_is_enough,
        [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [-0.0, 0.0, T::MAX.into()]
        ]
        .map(of::<T, 3>),
        |[a, b, c]: [T; 3]| Attenuation::new(a, b, c).is_some(),
        true
    );
    each_gives!(
        falloff_at_zero,
        [
            [0.0, 1.0, 0.0],
            [-0.0, 1.0, 0.0],
            [-0.0, 0.0, 1.0],
            [T::TINIEST, 0.0, 0.0]
        ],
        |[a, b, c]: [f64; 3]| [T::ZERO, -T::ZERO].map(|q| falloff(a, b, c).at(q)),
        [T::MAX; 2]
    );
    each_gives!(
        falloff_at_zero_if_clamped,
        [
            [0.0, 1.0, 0.0],
            [-0.0, 1.0, 0.0],
            [-0.0, 0.0, 1.0],
            [T::TINIEST, 0.0, 0.0]
        ],
        |[a, b, c]: [f64; 3]| [T::ZERO, -T::ZERO].map(|q| falloff(a, b, c).clamped().at(q)),
        [T::ONE; 2]
    );
    each_gives!(
        no_attenuation,
        [T::ZERO, tiniest(), T::of(15_000.0), T::MAX],
        |q: T| [Attenuation::NONE.at(q), Attenuation::default().at(q)],
        [T::ONE; 2]
    );

    each_gives!(
        bad_range,
        [T::ZERO, -T::ZERO, -T::ONE, -T::INFINITY, T::NAN],
        |r: T| [
            Attenuation::NONE.within(r),
            Attenuation::NONE.within_gltf(r)
        ],
        [None; 2]
    );
    each_gives!(
        bad_limit,
        [T::ZERO, -T::ZERO, -T::ONE, -T::INFINITY, T::NAN],
        |limit: T| Attenuation::NONE.clamped_to(limit),
        None
    );
    each_gives!(
        limit_without_an_end,
        [T::INFINITY, T::MAX],
        |limit: T| fading().clamped_to(limit) == Some(fading()),
        true
    );
    each_gives!(
        limited_below_one,
        [T::ZERO, tiniest(), T::ONE],
        |q: T| fading().clamped_to(T::of(0.125)).expect("above 0").at(q),
        T::of(0.125)
    );
    fn fading<T: Float>() -> Attenuation<T> {
        falloff(1.0, 0.0, 0.25)
    }
    each_gives!(
        range_without_an_end,
        [T::INFINITY, T::MAX],
        |r: T| fading().within(r) == Some(fading()),
        true
    );
    each_gives!(
        range_without_an_end_far_out,
        [T::ZERO, tiniest(), T::of(2.0), T::MAX, T::INFINITY],
        |q: T| fading().within_gltf(T::INFINITY).expect("none").at(q) == fading().at(q),
        true
    );
    // also where the attenuation has no denominator, at the smallest range, and for NaN
    each_gives!(
        out_of_range,
        [tiniest(), T::ONE, T::MAX / T::of(2.0)],
        |r: T| {
            let ranged = inverse_square().within(r).expect("above 0");
            let beyond = [r, r + r, T::INFINITY, T::NAN];
            [ranged, inverse_square().within_gltf(r).expect("above 0")]
                .map(|falloff| beyond.map(|q| falloff.at(q)))
        },
        [[T::ZERO; 4]; 2]
    );
    each_gives!(
        at_the_lamp_with_a_range,
        [tiniest(), T::ONE, T::MAX / T::of(2.0)],
        |r: T| inverse_square().within(r).expect("above 0").at(T::ZERO),
        T::MAX
    );
}

mod cones {
    use super::*;

    each_gives!(
        bad_angles,
        [
            -tiniest::<T>(),
            T::of(3.2),
            T::INFINITY,
            -T::INFINITY,
            T::NAN
        ],
        |a: T| {
            [
                Cone::from_half_angle(a),
                Cone::from_half_angles(a, T::ONE),
                Cone::from_half_angles(T::ONE, a),
            ]
        },
        [None; 3]
    );
    each_gives!(
        bad_cosines,
        [
            T::of(1.0 + 2.0 * T::U),
            -T::of(1.0 + 2.0 * T::U),
            T::INFINITY,
            -T::INFINITY,
            T::NAN
        ],
        |c: T| {
            [
                Cone::from_cosine(c),
                Cone::from_cosines(c, T::ZERO),
                Cone::from_cosines(T::ZERO, c),
            ]
        },
        [None; 3]
    );
    gives!(
        edges_out_of_order,
        Cone::from_half_angles(T::of(0.5), T::of(0.4)),
        None
    );
    gives!(
        edges_out_of_order_by_cosines,
        Cone::from_cosines(T::of(0.4), T::of(0.5)),
        None
    );
    gives!(
        edges_in_order,
        Cone::from_half_angles(T::ZERO, T::of(0.5)).is_some(),
        true
    );
    gives!(
        edges_at_both_ends,
        Cone::from_half_angles(T::ZERO, T::of(PI)).is_some(),
        true
    );
    gives!(
        edges_at_both_ends_by_cosines,
        Cone::from_cosines(T::ONE, -T::ONE).is_some(),
        true
    );

    fn hard<T: Float>() -> Cone<T> {
        Cone::from_cosine(T::of(0.5)).expect("a cone")
    }
    fn soft<T: Float>() -> Cone<T> {
        Cone::from_cosines(T::of(0.9), T::of(0.5)).expect("a cone")
    }
    gives!(
        cone_with_an_axis_of_nan,
        hard::<T>().factor(trusted(x(T::NAN)), UnitVec3::X),
        T::ONE
    );
    gives!(
        cone_of_nan,
        soft::<T>().factor(UnitVec3::X, trusted(x(T::NAN))),
        T::ONE
    );
    gives!(
        cone_of_nan_with_a_smoothstep,
        soft::<T>()
            .smoothstep()
            .factor(UnitVec3::X, trusted(x(T::NAN))),
        T::ONE
    );
    // a cone of NaN, which no constructor makes
    gives!(
        cone_cast_to_nan,
        hard::<T>()
            .cast(|_| T::NAN)
            .factor(UnitVec3::X, UnitVec3::X),
        T::ONE
    );
    // −0 is not below 0, so it may be the inner cosine; the width of such an edge is −0
    each_gives!(
        edge_between_two_zeros,
        [[0.0, 0.0], [0.0, -0.0], [-0.0, 0.0], [-0.0, -0.0]].map(of::<T, 2>),
        |[inner, outer]: [T; 2]| {
            let cone = Cone::from_cosines(inner, outer).expect("an edge");
            [cone, cone.smoothstep()].map(|cone| {
                [-tiniest::<T>(), T::ZERO, tiniest()]
                    .map(|c| cone.factor(UnitVec3::NEG_X, trusted(Vec3::new(c, T::ZERO, T::ONE))))
            })
        },
        [[T::ZERO, T::ONE, T::ONE]; 2]
    );
    value!(
        cone_of_angle_0,
        Cone::from_half_angle(T::ZERO).expect("a cone").cosines()[1],
        1.0 - 8.0 * T::U
    );
    value!(
        cone_of_cosine_1,
        Cone::from_cosine(T::ONE).expect("a cone").cosines()[1],
        1.0 - 8.0 * T::U
    );
    value!(
        cone_of_angle_pi,
        Cone::from_half_angle(T::of(PI)).expect("a cone").cosines()[1],
        -1.0
    );
    value!(
        cone_of_cosine_minus_1,
        Cone::from_cosine(-T::ONE).expect("a cone").cosines()[1],
        -1.0
    );
}

mod lights {
    use super::*;

    const BLACK: [[[f64; 3]; 3]; 2] = [[[0.0; 3]; 3]; 2];

    /// What arrives, and the sums of it.
    fn everything<T: Float>(light: IncidentLight<T>) -> (Rgb<T>, [[Rgb<T>; 3]; 2]) {
        (light.intensity(), shine([light]))
    }
    fn nothing<T: Float>() -> (Rgb<T>, [[Rgb<T>; 3]; 2]) {
        (Rgb::BLACK, BLACK.map(|n| n.map(rgb)))
    }

    each_gives!(
        lamp_at_the_point,
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
        |[a, b, c]: [f64; 3]| {
            let lamp = lamp(vector::<T>([1.0, 2.0, 3.0]), falloff(a, b, c));
            everything(lamp.at(lamp.position))
        },
        nothing()
    );
    gives!(
        lamp_at_the_point_with_a_cone,
        {
            let lamp = lamp(vector::<T>([1.0, 2.0, 3.0]), inverse_square());
            everything(spot(lamp, PI).at(lamp.position))
        },
        nothing()
    );
    each_gives!(
        lamp_at_infinity,
        not_finite::<T>().map(x),
        |far: Vec3<T>| everything(lamp(far, Attenuation::NONE).at(Vec3::ZERO)),
        nothing()
    );
    each_gives!(
        lamp_at_infinity_seen_from_there,
        not_finite::<T>().map(x),
        |far: Vec3<T>| everything(lamp(far, Attenuation::NONE).at(far)),
        nothing()
    );
    each_gives!(
        lamp_seen_from_infinity,
        not_finite::<T>().map(x),
        |far: Vec3<T>| everything(lamp(Vec3::ZERO, Attenuation::NONE).at(far)),
        nothing()
    );

    each_gives!(
        direction_at_any_distance,
        sizes::<T>(),
        |q: T| {
            let light = lamp(x(q), Attenuation::NONE).at(Vec3::ZERO);
            (light.l(), light.distance() == q, light.intensity())
        },
        (UnitVec3::X, true, Rgb::WHITE)
    );
    // the square, root, reciprocal and product are off by 2.5u; the reciprocal of the distance adds
    // 1u
    row!(attenuation_at_any_distance, {
        for q in of::<T, 7>([
            T::TINIEST,
            T::MIN_POSITIVE,
            1e-30,
            1e-15,
            1e15,
            1e30,
            T::MAX.into(),
        ]) {
            let is = lamp(x(q), falloff(0.0, 1.0, 0.0))
                .at(Vec3::ZERO)
                .intensity()
                .r;
            assert!(
                near(is, (T::ONE / q).at_most(T::MAX).into(), 4.0),
                "{q:e}: {is:e}"
            );
        }
    });

    /// √2 times the largest number away.
    fn too_far<T: Float>(attenuation: Attenuation<T>) -> IncidentLight<T> {
        lamp(Vec3::new(T::MAX, T::MAX, T::ZERO), attenuation).at(Vec3::ZERO)
    }
    value!(
        direction_at_a_distance_that_overflows,
        too_far::<T>(Attenuation::NONE).l().x,
        0.5_f64.sqrt(),
        units(3.0)
    );
    gives!(
        distance_that_overflows,
        too_far::<T>(Attenuation::NONE).distance(),
        T::MAX
    );
    gives!(
        light_from_a_distance_that_overflows,
        too_far::<T>(Attenuation::NONE).intensity(),
        Rgb::WHITE
    );
    // 1/q² is 0
    gives!(
        fading_light_from_a_distance_that_overflows,
        too_far::<T>(inverse_square()).intensity(),
        Rgb::BLACK
    );

    fn from_end_to_end<T: Float>() -> IncidentLight<T> {
        lamp(x(T::MAX), Attenuation::NONE).at(x(-T::MAX))
    }
    gives!(
        difference_that_overflows,
        everything(from_end_to_end::<T>()),
        nothing()
    );
    gives!(
        distance_of_a_difference_that_overflows,
        from_end_to_end::<T>().distance(),
        T::MAX
    );

    gives!(distance_of_a_sun, sun(UnitVec3::<T>::Z).distance(), T::MAX);
    gives!(
        distance_of_a_sun_from_nan,
        {
            let (l, intensity) = (UnitVec3::Z, Rgb::WHITE);
            Light::from(DirectionalLight { l, intensity })
                .at(x(T::NAN))
                .distance()
        },
        T::MAX
    );
    gives!(
        distance_of_a_lamp_at_the_point,
        lamp(Vec3::<T>::ZERO, Attenuation::NONE)
            .at(Vec3::ZERO)
            .distance(),
        T::ZERO
    );
    gives!(
        distance_to_infinity,
        lamp(Vec3::<T>::ZERO, Attenuation::NONE)
            .at(x(T::INFINITY))
            .distance(),
        T::MAX
    );
    gives!(
        distance_to_nan,
        lamp(Vec3::<T>::ZERO, Attenuation::NONE)
            .at(x(T::NAN))
            .distance(),
        T::NAN
    );

    /// Half a unit away, where 1/q² is 4.
    fn too_bright<T: Float>() -> PointLight<T> {
        PointLight {
            intensity: Rgb::gray(T::MAX),
            ..lamp(x(T::of(0.5)), inverse_square())
        }
    }
    gives!(
        intensity_that_overflows,
        too_bright::<T>().at(Vec3::ZERO).intensity(),
        Rgb::gray(T::MAX)
    );
    gives!(
        intensity_that_overflows_within_a_cone,
        spot(too_bright::<T>(), 0.1).at(Vec3::ZERO).intensity(),
        Rgb::gray(T::MAX)
    );
    each_gives!(
        black_lamp,
        [T::ZERO, tiniest(), T::of(T::MIN_POSITIVE)],
        |q: T| {
            let intensity = Rgb::BLACK;
            let lamp = lamp(x(q), inverse_square());
            PointLight { intensity, ..lamp }.at(Vec3::ZERO).intensity()
        },
        Rgb::BLACK
    );

    /// Whether light arrives at a fraction of the range, and shines.
    fn arrives<T: Float>(fraction: f64, r: f64) -> (bool, bool) {
        let ranged = Attenuation::NONE.within(T::of(r)).expect("above 0");
        let position = Vec3::new(T::ZERO, T::ZERO, T::of(fraction * r));
        let light = lamp(position, ranged).at(Vec3::ZERO);
        (
            light.intensity().r > T::ZERO,
            shine([light])[0][0].r > T::ZERO,
        )
    }
    fn ranges<T: Float>() -> [f64; 3] {
        [
            T::MIN_POSITIVE.sqrt() / 16.0,
            1.0,
            T::MAX.to_f64().sqrt() * 16.0,
        ]
    }
    each_gives!(
        lamp_within_range,
        ranges::<T>(),
        |r: f64| arrives::<T>(0.5, r),
        (true, true)
    );
    each_gives!(
        lamp_out_of_range,
        ranges::<T>(),
        |r: f64| [1.0, 2.0].map(|q| arrives::<T>(q, r)),
        [(false, false); 2]
    );

    gives!(
        direction_of_nan,
        {
            let light = sun(trusted(x(T::NAN)));
            (light.is_in_front(UnitVec3::X), shine([light]))
        },
        (false, nothing().1)
    );

    /// A lamp, a sun and a spot.
    fn of_each_kind<T: Float>() -> [IncidentLight<T>; 3] {
        let lamp = lamp(x(T::ONE), Attenuation::NONE);
        [
            lamp.at(Vec3::ZERO),
            sun(UnitVec3::X),
            spot(lamp, 0.5).at(Vec3::ZERO),
        ]
    }
    each_gives!(
        dimmed_light,
        of_each_kind::<T>(),
        |light: IncidentLight<T>| (light * T::of(0.5)).intensity(),
        Rgb::gray(T::of(0.5))
    );
    each_gives!(
        filtered_light,
        of_each_kind::<T>(),
        |light: IncidentLight<T>| (light * rgb([0.0, 1.0, 2.0])).intensity(),
        rgb([0.0, 1.0, 2.0])
    );
    const FILTERS: [f64; 6] = [
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        -f64::NAN,
        2.0,
        -2.0,
    ];
    each_gives!(
        black_light_through_any_filter,
        FILTERS,
        |filter: f64| {
            let black = of_each_kind::<T>().map(|light| light * Rgb::BLACK);
            let filtered = black.map(|light| light * Rgb::gray(T::of(filter)));
            filtered
                .map(|light| light.intensity().map(|x| x == T::ZERO) == Rgb::new(true, true, true))
        },
        [true; 3]
    );
    each_gives!(
        light_through_a_filter_without_a_limit,
        of_each_kind::<T>(),
        |light: IncidentLight<T>| {
            let filtered = |filter| (light * T::of(2.0) * Rgb::gray(filter)).intensity().r;
            let most = [T::INFINITY, T::MAX, T::NAN].map(filtered);
            (most, [-T::INFINITY, -T::MAX].map(filtered))
        },
        ([T::MAX; 3], [-T::MAX; 2])
    );
}

mod sums {
    use super::*;

    gives!(
        no_lights,
        {
            let (n, i_a) = (UnitVec3::Z, Rgb::gray(T::of(0.5)));
            [
                shade::lambert(n, &mirror(1), i_a, []),
                shade::phong(n, n, &mirror(1), i_a, []),
                shade::blinn_phong(n, n, &mirror(1), i_a, []),
            ]
            .map(|s| (s.ambient, s.total()))
        },
        [(Rgb::gray(T::of(0.5)), Rgb::gray(T::of(0.5))); 3]
    );

    /// The light is above, at 45°, and the eye is opposite it, below.
    fn opposite_the_eye<T: Float>() -> (Shaded<T>, UnitVec3<T>) {
        let l = direction::<T>([1.0, 0.0, 1.0]);
        (
            shade::blinn_phong(UnitVec3::Z, -l, &mirror(0), Rgb::BLACK, [sun(l)]),
            l,
        )
    }
    gives!(
        opposite_the_eye_without_a_highlight,
        opposite_the_eye::<T>().0.specular,
        Rgb::BLACK
    );
    gives!(
        opposite_the_eye_it_is_lit,
        {
            let (s, l) = opposite_the_eye::<T>();
            s.diffuse == Rgb::gray(l.z)
        },
        true
    );

    /// L + V is (0, 0, z) times a tiny number, so H is Z or −Z.
    fn nearly_opposite<T: Float>(n: UnitVec3<T>, m: u32, z: f64) -> T {
        let l = trusted(Vec3::new(T::ONE, T::ZERO, T::of(z * 2.0_f64.powi(-50))));
        shade::blinn_phong(n, -UnitVec3::X, &mirror(m), Rgb::BLACK, [sun(l)])
            .specular
            .r
    }
    each_gives!(
        nearly_opposite_the_eye,
        [1.0, 3.0, 1e9],
        |z: f64| [8, 9].map(|m| nearly_opposite::<T>(UnitVec3::Z, m, z)),
        [T::ONE; 2]
    );
    // N·H is 4/5, with two roundings for each factor
    each_gives!(
        nearly_opposite_the_eye_and_slanted,
        [1.0, 3.0, 1e9],
        |z: f64| near(
            nearly_opposite::<T>(direction([3.0, 0.0, 4.0]), 8, z),
            0.8_f64.powi(8),
            32.0
        ),
        true
    );
    each_gives!(
        nearly_opposite_the_eye_from_below,
        [1.0, 3.0, 1e9],
        |z: f64| nearly_opposite::<T>(direction([3.0, 0.0, 4.0]), 8, -z),
        T::ZERO
    );

    // V is the mirror direction, and H is close to N
    each_gives!(
        behind_the_surface,
        [[1.0, 0.0, -0.125], [1.0, 0.0, 0.0]].map(direction::<T>),
        |l: UnitVec3<T>| {
            let n = UnitVec3::Z;
            [
                shade::phong(n, reflection(n, l), &mirror(1), Rgb::BLACK, [sun(l)]),
                shade::blinn_phong(
                    n,
                    direction([-1.0, 0.0, 0.5]),
                    &mirror(0),
                    Rgb::BLACK,
                    [sun(l)],
                ),
            ]
            .map(Shaded::total)
        },
        [Rgb::BLACK; 2]
    );
    gives!(
        sum_that_overflows_on_black,
        {
            let [k_a, k_d, k_s] = [Rgb::BLACK; 3];
            let black = Material {
                k_a,
                k_d,
                k_s,
                m: 1,
            };
            let (n, i_a) = (UnitVec3::Z, Rgb::gray(T::MAX));
            shade::phong(n, n, &black, i_a, bright::<_, 2>(T::MAX)).total()
        },
        Rgb::BLACK
    );

    fn overflow<T: Float>() -> Shaded<T> {
        let n = UnitVec3::Z;
        shade::phong(n, n, &mirror(1), Rgb::BLACK, bright::<_, 2>(T::MAX))
    }
    gives!(
        sum_that_overflows,
        {
            let s = overflow::<T>();
            [s.diffuse, s.specular]
        },
        [Rgb::gray(T::MAX); 2]
    );
    gives!(
        sum_that_overflows_is_clamped,
        overflow::<T>().total().clamped(),
        Rgb::WHITE
    );
}

mod colors {
    use super::*;

    gives!(clamped_nan, Rgb::gray(T::NAN).clamped(), Rgb::BLACK);
    gives!(
        clamped_infinity,
        Rgb::new(T::INFINITY, -T::INFINITY, T::ONE).clamped(),
        rgb([1.0, 0.0, 1.0])
    );

    /// The levels of a gray.
    fn levels(c: f32) -> ([u8; 3], u16, [u8; 3]) {
        let gray = Rgb::gray(c);
        (gray.to_srgb8(), gray.to_rgb565(), gray.to_linear8())
    }

    #[test]
    fn dark_levels() {
        let nan = f32::from_bits(u32::MAX);
        for c in [
            -0.0,
            1e-45,
            -1e-45,
            -1.0,
            f32::MIN,
            f32::NEG_INFINITY,
            f32::NAN,
            nan,
        ] {
            assert_eq!(levels(c), ([0; 3], 0, [0; 3]), "{c:e}");
        }
    }

    #[test]
    fn bright_levels() {
        for c in [1.0 + f32::EPSILON, 1e30, f32::MAX, f32::INFINITY] {
            assert_eq!(levels(c), ([255; 3], u16::MAX, [255; 3]), "{c:e}");
        }
    }
}

// the value is that of the plain number
mod dual_numbers {
    use super::*;

    gives!(
        dual_root_at_0,
        slope(variable(T::ZERO).sqrt()),
        (T::ZERO, false)
    );
    gives!(
        dual_logarithm_at_0,
        slope(variable(T::ZERO).ln()),
        (-T::INFINITY, false)
    );
    gives!(
        dual_quotient_at_0,
        slope(Dual::<T>::ONE / variable(T::ZERO)),
        (T::INFINITY, false)
    );
    gives!(
        dual_reciprocal_at_0,
        slope(variable(T::ZERO).powi(-1)),
        (T::INFINITY, false)
    );
    gives!(
        dual_over_plain_0,
        slope(variable(T::ONE) / T::ZERO),
        (T::INFINITY, false)
    );
    each_gives!(
        dual_root_below_0,
        [tiniest(), T::ONE, T::MAX],
        |x: T| slope((-variable(x)).sqrt()),
        (T::NAN, false)
    );
    each_gives!(
        dual_logarithm_below_0,
        [tiniest(), T::ONE, T::MAX],
        |x: T| slope((-variable(x)).ln()),
        (T::NAN, false)
    );
    gives!(
        dual_absolute_value_at_0,
        variable(T::ZERO).abs(),
        Dual::constant(T::ZERO)
    );
    gives!(
        dual_absolute_value_of_nan,
        slope((-variable(T::ONE)).sqrt().abs()),
        (T::NAN, false)
    );
    gives!(
        dual_absolute_value_of_a_constant_nan,
        Dual::constant(T::NAN).abs().value,
        T::NAN
    );
    gives!(
        dual_power_0_of_0,
        variable(T::ZERO).powi(0),
        Dual::constant(T::ONE)
    );
    gives!(power_0_of_0, T::ZERO.powi(0), T::ONE);
    gives!(power_1_of_0, 1.raise(T::ZERO), T::ZERO);
}
