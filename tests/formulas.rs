//! Every formula and every convention against a value derived by hand, for `f32` and `f64`: a test
//! for each row. The derivation stands over the row, with how many roundings the value may be off
//! by; without a number, it is exact.

#![allow(clippy::float_cmp)] // results without rounding are compared exactly

#[path = "support/row.rs"]
mod row;

use std::f64::consts::{FRAC_1_PI, PI};

use kit::{Float, direction, rgb, vector};
use row::{row, units, units_of_1, value};
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, IncidentLight, Light, Lobe, Material,
    PointLight, Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal,
    reflection, shade, term,
};

/// L = (3, 0, 4)/5, at 36.87° from Z: the length is exact, and each quotient is off by 1u.
fn slanted<T: Float>() -> UnitVec3<T> {
    direction([3.0, 0.0, 4.0])
}

/// (sin, 0, cos) with exactly this z.
fn with_cosine<T: Real>(z: f64) -> UnitVec3<T> {
    UnitVec3::assume_unit(vector([(1.0 - z * z).sqrt(), 0.0, z]))
}

fn of<T: Real, const N: usize>(numbers: [f64; N]) -> [T; N] {
    numbers.map(T::of)
}

fn gray<T: Real>(x: f64) -> Rgb<T> {
    Rgb::gray(T::of(x))
}

fn falloff<T: Float>(a: f64, b: f64, c: f64) -> Attenuation<T> {
    Attenuation::new(T::of(a), T::of(b), T::of(c)).expect("coefficients")
}

fn lamp<T: Real>(position: [f64; 3], attenuation: Attenuation<T>) -> PointLight<T> {
    PointLight {
        position: vector(position),
        intensity: rgb([1.0, 0.5, 0.0]),
        attenuation,
    }
}

/// What arrives of a white sun.
fn from<T: Real>(l: UnitVec3<T>) -> IncidentLight<T> {
    let intensity = Rgb::WHITE;
    DirectionalLight { l, intensity }.into()
}

fn material<T: Real, M>([k_a, k_d, k_s]: [f64; 3], m: M) -> Material<T, M> {
    let [k_a, k_d, k_s] = [k_a, k_d, k_s].map(gray);
    Material { k_a, k_d, k_s, m }
}

mod vectors {
    use super::*;

    fn a<T: Real>() -> Vec3<T> {
        vector([1.0, 2.0, 3.0])
    }

    fn b<T: Real>() -> Vec3<T> {
        vector([4.0, -5.0, 6.0])
    }

    value!(sum_of_vectors, a::<T>() + b(), [5.0, -3.0, 9.0]);
    value!(difference_of_vectors, a::<T>() - b(), [-3.0, 7.0, -3.0]);
    value!(vector_times_number, a::<T>() * T::of(2.0), [2.0, 4.0, 6.0]);
    value!(
        number_times_vector,
        T::of(2.0).times_vector(a()),
        [2.0, 4.0, 6.0]
    );
    value!(vector_over_number, b::<T>() / T::of(2.0), [2.0, -2.5, 3.0]);
    // 7/10 is that of a division, not of a multiplication by a rounded reciprocal
    value!(
        quotients_are_divided,
        (vector::<T>([7.0; 3]) / T::of(10.0)).y,
        T::of(0.7)
    );
    value!(opposite_vector, -a::<T>(), [-1.0, -2.0, -3.0]);
    // 1·4 − 2·5 + 3·6
    value!(dot_product, a::<T>().dot(b()), 12.0);
    // (2·6 + 3·5, 3·4 − 1·6, −1·5 − 2·4)
    value!(cross_product, a::<T>().cross(b()), [27.0, 6.0, -13.0]);
    value!(cross_product_with_itself, a::<T>().cross(a()), [0.0; 3]);
    // a quarter of the way from (1, 2, 3) to (4, −5, 6)
    value!(
        lerp_by_a_quarter,
        a::<T>().lerp(b(), T::of(0.25)),
        [1.75, 0.25, 3.75]
    );
    value!(
        added_to_a_vector,
        {
            let mut v = a::<T>();
            v += b();
            v
        },
        [5.0, -3.0, 9.0]
    );
    // ((1, 2, 3) − (4, −5, 6))·2/4, and then a direction less and a direction more
    value!(
        changed_in_place,
        {
            let mut v = a::<T>();
            v -= b();
            v *= T::of(2.0);
            v /= T::of(4.0);
            v -= UnitVec3::X;
            v += UnitVec3::Y;
            v
        },
        [-2.5, 4.5, -1.5]
    );
    value!(vector_of_one_number, Vec3::splat(T::of(2.0)), [2.0; 3]);
    // 2² + 3² + 6² = 7²
    value!(
        length_of_a_vector,
        vector::<T>([2.0, -3.0, 6.0]).length(),
        7.0
    );
    value!(
        distance_of_points,
        vector::<T>([3.0, 1.0, 5.0]).distance(vector([1.0, 4.0, -1.0])),
        7.0
    );

    // 1 + u + u is 1, and u + u + 1 is 1 + 2u
    fn in_order<T: Float>(terms: [f64; 3]) -> Vec3<T> {
        terms.into_iter().map(|x| vector::<T>([x; 3])).sum()
    }
    value!(
        sum_of_vectors_goes_forward,
        in_order::<T>([1.0, T::U, T::U]),
        [1.0; 3]
    );
    value!(
        sum_of_vectors_does_not_go_back,
        in_order::<T>([T::U, T::U, 1.0]),
        [1.0 + 2.0 * T::U; 3]
    );
    value!(sum_of_no_vectors, [].into_iter().sum::<Vec3<T>>(), [0.0; 3]);
}

mod colors {
    use super::*;

    fn a<T: Real>() -> Rgb<T> {
        rgb([0.5, 1.0, 2.0])
    }

    fn b<T: Real>() -> Rgb<T> {
        rgb([0.25, 0.5, -4.0])
    }

    value!(sum_of_colors, a::<T>() + b(), [0.75, 1.5, -2.0]);
    value!(difference_of_colors, a::<T>() - b(), [0.25, 0.5, 6.0]);
    value!(product_of_colors, a::<T>() * b(), [0.125, 0.5, -8.0]);
    value!(color_times_number, a::<T>() * T::of(2.0), [1.0, 2.0, 4.0]);
    value!(
        number_times_color,
        T::of(2.0).times_rgb(a()),
        [1.0, 2.0, 4.0]
    );
    value!(color_over_number, a::<T>() / T::of(2.0), [0.25, 0.5, 1.0]);
    value!(
        color_quotients_are_divided,
        (gray::<T>(7.0) / T::of(10.0)).g,
        T::of(0.7)
    );
    value!(clamped_color, (a::<T>() + b()).clamped(), [0.75, 1.0, 0.0]);
    value!(
        added_to_a_color,
        {
            let mut c = a::<T>();
            c += b();
            c
        },
        [0.75, 1.5, -2.0]
    );
    // ((0.5, 1, 2) − (0.25, 0.5, −4))·(0.25, 0.5, −4)·2/4
    value!(
        changed_in_place,
        {
            let mut c = a::<T>();
            c -= b();
            c *= b::<T>();
            c *= T::of(2.0);
            c /= T::of(4.0);
            c
        },
        [0.03125, 0.125, -12.0]
    );

    // 1 + u + u is 1, and u + u + 1 is 1 + 2u
    fn in_order<T: Float>(terms: [f64; 3]) -> Rgb<T> {
        terms.into_iter().map(gray::<T>).sum()
    }
    value!(
        sum_of_colors_goes_forward,
        in_order::<T>([1.0, T::U, T::U]),
        [1.0; 3]
    );
    value!(
        sum_of_colors_does_not_go_back,
        in_order::<T>([T::U, T::U, 1.0]),
        [1.0 + 2.0 * T::U; 3]
    );
    value!(sum_of_no_colors, [].into_iter().sum::<Rgb<T>>(), [0.0; 3]);
}

mod directions {
    use super::*;

    value!(axis_x, UnitVec3::<T>::X, [1.0, 0.0, 0.0]);
    value!(axis_y, UnitVec3::<T>::Y, [0.0, 1.0, 0.0]);
    value!(axis_z, UnitVec3::<T>::Z, [0.0, 0.0, 1.0]);
    value!(axis_neg_x, UnitVec3::<T>::NEG_X, [-1.0, 0.0, 0.0]);
    value!(axis_neg_y, UnitVec3::<T>::NEG_Y, [0.0, -1.0, 0.0]);
    value!(axis_neg_z, UnitVec3::<T>::NEG_Z, [0.0, 0.0, -1.0]);
    value!(opposite_direction, -UnitVec3::<T>::X, [-1.0, 0.0, 0.0]);
    value!(
        direction_times_number,
        UnitVec3::<T>::X * T::of(2.0),
        [2.0, 0.0, 0.0]
    );
    value!(
        vector_plus_direction,
        Vec3::<T>::ZERO + UnitVec3::Y,
        [0.0, 1.0, 0.0]
    );
    value!(
        vector_minus_direction,
        Vec3::<T>::ZERO - UnitVec3::Z,
        [0.0, 0.0, -1.0]
    );
    // the length 5 is exact
    value!(
        unit_of_3_4_5,
        vector::<T>([3.0, 0.0, 4.0]).unit(),
        [0.6, 0.0, 0.8],
        units(1.0)
    );

    // N = (3, 0, 4)/5, L = Z: N·L = 4/5, R = 8/5 (3, 0, 4)/5 − (0, 0, 1) = (24, 0, 7)/25. 1.6 is
    // off by 1u, its products with N by 3u: 2.9u of 0.96 and 3.9u of 1.28, and the difference
    // rounds by ¼u
    value!(
        reflection_in_a_tilted_normal,
        reflection(slanted::<T>(), UnitVec3::Z),
        [0.96, 0.0, 0.28],
        units(4.3)
    );
    value!(
        reflection_off_a_floor,
        reflection(UnitVec3::<T>::Z, slanted()),
        [-0.6, 0.0, 0.8],
        units(1.0)
    );
    value!(
        reflection_off_the_other_side,
        reflection(-UnitVec3::<T>::Z, slanted()),
        [-0.6, 0.0, 0.8],
        units(1.0)
    );

    /// GLSL: reflect(I, N) = I − 2(N·I)N.
    fn glsl_reflect<T: Float>(i: UnitVec3<T>, n: UnitVec3<T>) -> Vec3<T> {
        *i - *n * (T::of(2.0) * n.dot(i))
    }
    value!(
        glsl_reflect_takes_minus_l,
        *reflection(UnitVec3::<T>::Z, slanted()) - glsl_reflect(-slanted(), UnitVec3::Z),
        [0.0; 3]
    );

    // (2, 1, 2)/3 + (1, 2, 2)/3 = (3, 3, 4)/3, of length √34/3. Each component is off by 2u, the
    // length by as much and 2.5u, the quotient by 1u
    value!(
        half_vector_of_two_directions,
        half_vector(direction::<T>([2.0, 1.0, 2.0]), direction([1.0, 2.0, 2.0])),
        [3.0, 3.0, 4.0].map(|c| c / 34.0_f64.sqrt()),
        units(7.5)
    );
    // the root of 2 and the quotient
    value!(
        half_vector_of_two_axes,
        half_vector(UnitVec3::<T>::X, UnitVec3::Z),
        [0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt()],
        units(2.0)
    );
}

mod terms {
    use super::*;

    /// (√3, 0, 1)/2
    fn at_60_degrees<T: Float>() -> UnitVec3<T> {
        direction([3.0_f64.sqrt(), 0.0, 1.0])
    }

    // √3 is off by 1u, its square by 3u, the sum with 1 by 3.25u, the root by 2.6u, the quotient by
    // 3.6u
    value!(
        lambert_at_60_degrees,
        term::lambert(UnitVec3::Z, at_60_degrees::<T>()),
        0.5,
        units(3.6)
    );
    value!(
        lambert_overhead,
        term::lambert(UnitVec3::<T>::Z, UnitVec3::Z),
        1.0
    );
    value!(
        lambert_from_behind,
        term::lambert(UnitVec3::<T>::Z, -slanted()),
        0.0
    );
    value!(
        lambert_on_the_horizon,
        term::lambert(UnitVec3::<T>::Z, UnitVec3::X),
        0.0
    );

    value!(
        ambient,
        term::ambient(rgb::<T>([0.5, 0.25, 0.0]), rgb([0.5, 2.0, 3.0])),
        [0.25, 0.5, 0.0]
    );

    // R·V = 4/5, off by 1u: a power by m, and its products by 1u each
    value!(
        phong_of_1,
        term::phong(slanted::<T>(), UnitVec3::Z, 1),
        0.8,
        units(1.0)
    );
    value!(
        phong_of_2,
        term::phong(slanted::<T>(), UnitVec3::Z, 2),
        0.64,
        units(3.0)
    );
    value!(
        phong_of_3,
        term::phong(slanted::<T>(), UnitVec3::Z, 3),
        0.512,
        units(5.0)
    );
    // a real power is off by 4u of 1, and m times by what its base is
    value!(
        phong_of_real_2,
        term::phong(slanted::<T>(), UnitVec3::Z, T::of(2.0)),
        0.64,
        units_of_1(4.0 + 2.0 * 0.64)
    );
    value!(
        phong_of_real_3,
        term::phong(slanted::<T>(), UnitVec3::Z, T::of(3.0)),
        0.512,
        units_of_1(4.0 + 3.0 * 0.512)
    );
    value!(
        phong_of_a_half,
        term::phong(slanted::<T>(), UnitVec3::Z, T::of(0.5)),
        0.8_f64.sqrt(),
        units_of_1(4.5)
    );

    /// L·V = 4/5, |L + V|² = 2 + 8/5 = 18/5, N·H = (4/5 + 1)/√(18/5) = √(9/10). L + V is off by 1u,
    /// its square by 4u, the root by 3u, the quotient by 5u.
    fn h<T: Float>() -> UnitVec3<T> {
        half_vector(slanted(), UnitVec3::Z).expect("halfway")
    }

    value!(
        blinn_of_2,
        term::blinn(UnitVec3::Z, h::<T>(), 2),
        0.9,
        units(11.0)
    );
    value!(
        blinn_of_4,
        term::blinn(UnitVec3::Z, h::<T>(), 4),
        0.81,
        units(23.0)
    );
    value!(
        blinn_of_real_4,
        term::blinn(UnitVec3::Z, h::<T>(), T::of(4.0)),
        0.81,
        units_of_1(4.0 + 20.0 * 0.81)
    );

    // the light is behind the surface, which the factor alone does not know
    value!(
        phong_is_not_gated,
        term::phong(-UnitVec3::<T>::Z, -UnitVec3::Z, 3),
        1.0
    );
    value!(
        blinn_is_not_gated,
        term::blinn(UnitVec3::<T>::Z, UnitVec3::Z, 3),
        1.0
    );

    row!(powers_of_a_half, {
        for m in [0_u32, 1, 2, 3, 10, 25, 99, 100] {
            let power: f64 = m.raise(T::of(0.5)).into();
            assert_eq!(power, 0.5_f64.powi(m.try_into().expect("small")));
        }
    });
    row!(powers_of_the_root_of_a_quarter, {
        for m in [0_u32, 1, 2, 5, 64, 65, 100] {
            let power: f64 = m.raise_root(T::of(0.25)).into();
            assert_eq!(power, 0.5_f64.powi(m.try_into().expect("small")));
        }
    });

    // (2 + 2)/(2π) = 2/π, (6 + 2)/(2π) = 4/π and 3.5/(2π): the constant and the product are off by
    // 1u each, here and there
    value!(
        normalization_of_phong_2,
        term::phong_normalization(T::of(2.0)),
        2.0 * FRAC_1_PI,
        units(4.0)
    );
    value!(
        normalization_of_phong_6,
        term::phong_normalization(T::of(6.0)),
        4.0 * FRAC_1_PI,
        units(4.0)
    );
    value!(
        normalization_of_phong_1_5,
        term::phong_normalization(T::of(1.5)),
        1.75 * FRAC_1_PI,
        units(4.0)
    );
    // 4·6/(8π(½ + 2)) = 1.2/π, 8·10/(8π(⅛ + 6)) = 80/(49π) and 3.5·5.5/(8π(2^(−¾) + 1.5)). The
    // constant, three products or quotients and a sum are off by 1u each, the power by 4u of 1,
    // which is 2u of the sum; the value by 3u
    value!(
        normalization_of_blinn_2,
        term::blinn_normalization(T::of(2.0)),
        1.2 * FRAC_1_PI,
        units(10.0)
    );
    value!(
        normalization_of_blinn_6,
        term::blinn_normalization(T::of(6.0)),
        80.0 / 49.0 * FRAC_1_PI,
        units(10.0)
    );
    value!(
        normalization_of_blinn_1_5,
        term::blinn_normalization(T::of(1.5)),
        3.5 * 5.5 / 8.0 / (0.5_f64.powf(0.75) + 1.5) * FRAC_1_PI,
        units(10.0)
    );
}

mod falloffs {
    use super::*;

    // 1 + ½·2 + ¼·2² = 3; 1 + 2·4 + ½·16 = 17; q is the distance, and the factor is not clamped
    value!(
        attenuation_at_a_distance,
        attenuation(T::ONE, T::of(0.5), T::of(0.25), T::of(2.0)),
        1.0 / 3.0,
        units(1.0)
    );
    value!(
        attenuation_at_2,
        falloff::<T>(1.0, 0.5, 0.25).at(T::of(2.0)),
        1.0 / 3.0,
        units(1.0)
    );
    value!(
        attenuation_at_4,
        falloff::<T>(1.0, 2.0, 0.5).at(T::of(4.0)),
        1.0 / 17.0,
        units(1.0)
    );
    value!(
        attenuation_is_not_clamped,
        falloff::<T>(0.0, 0.0, 1.0).at(T::of(0.25)),
        16.0
    );
    value!(
        attenuation_clamped_nearby,
        falloff::<T>(0.0, 0.0, 1.0).clamped().at(T::of(0.25)),
        1.0
    );
    value!(
        attenuation_clamped_further,
        falloff::<T>(0.0, 0.0, 1.0).clamped().at(T::of(2.0)),
        0.25
    );
    value!(
        coefficients_of_a_falloff,
        falloff::<T>(0.25, 0.0, 3.0).clamped().coefficients(),
        [0.25, 0.0, 3.0]
    );

    fn ranged<T: Float>() -> Attenuation<T> {
        falloff(1.0, 0.0, 0.25).within(T::of(4.0)).expect("a range")
    }

    fn of_gltf<T: Float>() -> Attenuation<T> {
        falloff(1.0, 0.0, 0.25)
            .within_gltf(T::of(4.0))
            .expect("a range")
    }

    // 1/(1 + 4/4) (1 − (2/4)⁴)² = ½ (15/16)²; as glTF has it, ½ 15/16
    value!(range_halfway, ranged::<T>().at(T::of(2.0)), 225.0 / 512.0);
    value!(
        range_of_gltf_halfway,
        of_gltf::<T>().at(T::of(2.0)),
        15.0 / 32.0
    );
    value!(range_at_its_end, ranged::<T>().at(T::of(4.0)), 0.0);

    value!(
        limit_of_a_clamped_falloff,
        falloff::<T>(1.0, 0.0, 0.0).clamped().limit(),
        Some(T::ONE)
    );
    value!(
        limit_of_a_falloff_without,
        falloff::<T>(1.0, 0.0, 0.0).limit(),
        None::<T>
    );
    value!(falloff_is_that_of_gltf, of_gltf::<T>().is_gltf(), true);
    value!(
        falloff_is_not_that_of_gltf,
        ranged::<T>().clamped().is_gltf(),
        false
    );
    value!(
        falloff_by_default_is_none,
        Attenuation::<T>::default() == falloff(1.0, 0.0, 0.0),
        true
    );
    value!(range_of_a_falloff, ranged::<T>().range(), Some(T::of(4.0)));
    value!(
        range_of_a_falloff_without,
        Attenuation::<T>::NONE.range(),
        None::<T>
    );
    // one range after another replaces it, and the order of the steps does not matter
    value!(
        order_of_steps_does_not_matter,
        falloff::<T>(1.0, 0.0, 0.25)
            .clamped()
            .within_gltf(T::of(4.0))
            == Some(of_gltf().clamped()),
        true
    );
    value!(
        another_range_replaces_the_first,
        falloff::<T>(1.0, 0.0, 0.25)
            .within(T::ONE)
            .expect("a range")
            .within(T::of(4.0))
            == Some(ranged()),
        true
    );
}

mod cones {
    use super::*;

    fn off_axis<T: Float>(degrees: f64) -> UnitVec3<T> {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        direction([sine, 0.0, cosine])
    }

    fn of_45_degrees<T: Float>() -> Cone<T> {
        Cone::from_half_angle(T::of(PI / 4.0)).expect("a half-angle")
    }

    /// The axis points down.
    fn factor<T: Real>(cone: Cone<T>, cosine: f64) -> T {
        cone.factor(UnitVec3::NEG_Z, with_cosine(cosine))
    }

    value!(
        cone_within_its_half_angle,
        of_45_degrees::<T>().factor(UnitVec3::NEG_Z, off_axis(44.0)),
        1.0
    );
    value!(
        cone_beyond_its_half_angle,
        of_45_degrees::<T>().factor(UnitVec3::NEG_Z, off_axis(46.0)),
        0.0
    );

    fn hard<T: Float>() -> Cone<T> {
        Cone::from_cosine(T::of(0.5)).expect("a cosine")
    }

    value!(cone_on_its_edge_is_lit, factor(hard::<T>(), 0.5), 1.0);
    value!(
        cone_beyond_its_edge_is_dark,
        factor(hard::<T>(), 0.5 - T::U),
        0.0
    );

    fn soft<T: Float>() -> Cone<T> {
        Cone::from_cosines(T::of(0.75), T::of(0.25)).expect("cosines")
    }

    // t = (½ − ¼)/(¾ − ¼) = ½: t² = ¼, t²(3 − 2t) = ½
    value!(soft_edge_halfway, factor(soft::<T>(), 0.5), 0.25);
    value!(
        smoothstep_halfway,
        factor(soft::<T>().smoothstep(), 0.5),
        0.5
    );
    // t = (⅜ − ¼)/(¾ − ¼) = ¼: t² = 1/16, t²(3 − 2t) = 5/32
    value!(
        soft_edge_further_out,
        factor(soft::<T>(), 0.375),
        1.0 / 16.0
    );
    value!(
        smoothstep_further_out,
        factor(soft::<T>().smoothstep(), 0.375),
        5.0 / 32.0
    );
    value!(soft_edge_ends_within, factor(soft::<T>(), 0.75), 1.0);
    value!(soft_edge_ends_outside, factor(soft::<T>(), 0.25), 0.0);
    value!(
        cone_is_a_smoothstep,
        soft::<T>().smoothstep().is_smoothstep(),
        true
    );
    value!(cone_is_not_a_smoothstep, soft::<T>().is_smoothstep(), false);
    // there is no edge to be smooth
    value!(
        hard_cone_is_its_smoothstep,
        hard::<T>().smoothstep() == hard(),
        true
    );

    value!(cosine_of_a_hard_cone, hard::<T>().cosines(), [0.5, 0.5]);
    value!(cosines_of_a_soft_cone, soft::<T>().cosines(), [0.75, 0.25]);
    fn right_angle<T: Float>() -> [T; 2] {
        Cone::from_half_angles(T::ZERO, T::of(PI / 2.0))
            .expect("a cone")
            .cosines()
    }
    // 4ε less than 1, so that the axis is lit however it rounds
    value!(
        cosine_of_a_half_angle_of_0,
        right_angle::<T>()[0],
        1.0 - 8.0 * T::U
    );
    // π/2 is between 1 and 2, so it is off by 1u of 1, and so is its cosine
    value!(
        cosine_of_a_half_angle_of_90_degrees,
        right_angle::<T>()[1],
        0.0,
        units_of_1(1.0)
    );
}

mod lights {
    use super::*;

    fn above<T: Float>() -> PointLight<T> {
        lamp([0.0, 0.0, 2.0], falloff(0.0, 0.0, 1.0))
    }

    /// The lamp shines down within 30°.
    fn spot<T: Float>() -> SpotLight<T> {
        let cone = Cone::from_half_angle(T::of(PI / 6.0)).expect("a half-angle");
        let axis = UnitVec3::NEG_Z;
        SpotLight {
            point: above(),
            axis,
            cone,
        }
    }

    fn p<T: Float>(x: f64) -> Vec3<T> {
        vector([x, 0.0, 0.0])
    }

    value!(
        direction_to_a_lamp,
        above::<T>().at(Vec3::ZERO).l(),
        [0.0, 0.0, 1.0]
    );
    value!(
        distance_of_a_lamp,
        above::<T>().at(Vec3::ZERO).distance(),
        2.0
    );
    // 1/2² of (1, ½, 0)
    value!(
        intensity_of_a_lamp,
        above::<T>().at(Vec3::ZERO).intensity(),
        [0.25, 0.125, 0.0]
    );
    // ½ (15/16)² of (1, ½, 0), halfway to the range
    value!(
        intensity_of_a_lamp_with_a_range,
        {
            let ranged = falloff(1.0, 0.0, 0.25).within(T::of(4.0)).expect("a range");
            lamp([0.0, 0.0, 2.0], ranged).at(Vec3::ZERO).intensity()
        },
        [225.0 / 512.0, 225.0 / 1024.0, 0.0]
    );

    fn sun<T: Float>() -> IncidentLight<T> {
        let intensity = rgb([2.0, 1.0, 0.5]);
        let sun = DirectionalLight {
            l: UnitVec3::Z,
            intensity,
        };
        sun.at(vector([1e30, -1e30, 1e30]))
    }
    value!(direction_to_a_sun, sun::<T>().l(), [0.0, 0.0, 1.0]);
    value!(intensity_of_a_sun, sun::<T>().intensity(), [2.0, 1.0, 0.5]);
    value!(distance_of_a_sun, sun::<T>().distance(), T::MAX);
    value!(
        lights_print_their_kinds,
        {
            let at = Vec3::ZERO;
            let lights = [sun::<T>(), above().at(at), spot().at(at)];
            let kinds = ["kind: Directional", "kind: Point", "kind: Spot"];
            let mut pairs = lights.iter().zip(kinds);
            pairs.all(|(light, kind)| {
                let text = format!("{light:?}");
                text.contains(kind) && text.contains("to_light: Vec3 { x: 0.0, y: 0.0, z: ")
            })
        },
        true
    );

    // (1, 0, 0) is 2 below the lamp: arctan ½ = 26.6°, 1/(4 + 1) = 0.2. The root is off by 1u, its
    // square by 3u, the reciprocal by 4u
    value!(
        spot_within_its_cone,
        spot::<T>().at(p(1.0)).intensity(),
        [0.2, 0.1, 0.0],
        units(4.0)
    );
    // (1.2, 0, 0): arctan 0.6 = 31.0°
    value!(
        spot_beyond_its_cone,
        spot::<T>().at(p(1.2)).intensity(),
        [0.0; 3]
    );
    value!(
        spot_has_the_direction_of_its_lamp,
        *spot::<T>().at(p(1.0)).l() - *above().at(p(1.0)).l(),
        [0.0; 3]
    );
    value!(
        spot_has_the_light_of_its_lamp,
        spot::<T>().at(p(1.0)).intensity() - above().at(p(1.0)).intensity(),
        [0.0; 3]
    );
    value!(
        light_of_any_kind_is_a_spot,
        Light::from(spot::<T>()).at(p(1.0)) == spot().at(p(1.0)),
        true
    );
    value!(
        light_of_any_kind_is_a_lamp,
        Light::from(above::<T>()).at(p(1.0)) == above().at(p(1.0)),
        true
    );

    value!(
        light_in_front,
        from(UnitVec3::<T>::Z).is_in_front(UnitVec3::Z),
        true
    );
    value!(
        light_on_the_horizon_is_not_in_front,
        from(UnitVec3::<T>::Z).is_in_front(UnitVec3::X),
        false
    );
    value!(
        light_behind_is_not_in_front,
        from(UnitVec3::<T>::Z).is_in_front(UnitVec3::NEG_Z),
        false
    );

    /// Whether the wall z = `height` stands between p and the light.
    fn is_blocked<T: Float>(p: Vec3<T>, height: f64, light: IncidentLight<T>) -> bool {
        let t = (T::of(height) - p.z) / light.l().z;
        t > T::ZERO && t < light.distance()
    }

    /// Two units to the side and two up.
    fn aside<T: Float>() -> IncidentLight<T> {
        lamp([3.0, 0.0, 2.0], Attenuation::NONE).at(p(1.0))
    }
    value!(
        shadow_of_a_wall_before_the_lamp,
        is_blocked(p::<T>(1.0), 1.0, aside()),
        true
    );
    value!(
        shadow_ends_at_the_lamp,
        is_blocked(p::<T>(1.0), 3.0, aside()),
        false
    );
    value!(
        shadow_of_any_wall_before_the_sun,
        is_blocked(p::<T>(0.0), 1e30, from(UnitVec3::Z)),
        true
    );
    value!(
        shadow_of_no_wall_behind,
        is_blocked(p::<T>(0.0), -1.0, from(UnitVec3::Z)),
        false
    );

    // a scene in another number is the same scene: what arrives is cast, or the light is
    row!(light_in_another_number, {
        let p = vector::<T>([1.0, 0.0, 0.5]);
        let plain = spot::<T>().at(p);
        let dual = spot::<T>().cast(Dual::constant).at(p.map(Dual::constant));
        let cast = plain.cast(Dual::constant);
        assert!(dual.intensity() == plain.intensity().map(Dual::constant));
        assert!(dual.l() == cast.l() && dual.distance() == cast.distance());
        assert!(cast.intensity() == dual.intensity());
    });
}

mod sums {
    use super::*;

    /// A lamp two units above the origin, where ¼ of (1, ½, 0) arrives, and the slanted sun with
    /// intensity ½.
    fn two_lights<T: Float>() -> [IncidentLight<T>; 2] {
        let sun = DirectionalLight {
            l: slanted(),
            intensity: gray(0.5),
        };
        let lamp = lamp([0.0, 0.0, 2.0], falloff(0.0, 0.0, 1.0));
        [lamp.at(Vec3::ZERO), sun.at(Vec3::ZERO)]
    }

    /// I_a is ¼, and the eye is above.
    fn clay<T: Float>() -> [Shaded<T>; 3] {
        let (clay, i_a) = (material([0.125, 0.5, 0.25], 2), gray(0.25));
        let (n, v) = (UnitVec3::Z, UnitVec3::Z);
        [
            shade::lambert(n, &clay, i_a, two_lights()),
            shade::phong(n, v, &clay, i_a, two_lights()),
            shade::blinn_phong(n, v, &clay, i_a, two_lights()),
        ]
    }

    // k_a I_a = ⅛ · ¼
    value!(ambient_of_lambert, clay::<T>()[0].ambient, [0.03125; 3]);
    value!(ambient_of_phong, clay::<T>()[1].ambient, [0.03125; 3]);
    value!(ambient_of_blinn, clay::<T>()[2].ambient, [0.03125; 3]);
    // N·L = 1 and 4/5: ½ (¼ + ½ · ⅘) = 0.325, ½ (⅛ + ⅖) = 0.2625, ½ · ⅖ = 0.2. ⅖ is off by 0.4u of 1, the
    // sum by 0.9u
    value!(
        diffuse_of_lambert,
        clay::<T>()[0].diffuse,
        [0.325, 0.2625, 0.2],
        units(1.5)
    );
    value!(
        diffuse_of_phong,
        clay::<T>()[1].diffuse,
        [0.325, 0.2625, 0.2],
        units(1.5)
    );
    value!(
        diffuse_of_blinn,
        clay::<T>()[2].diffuse,
        [0.325, 0.2625, 0.2],
        units(1.5)
    );
    value!(specular_of_lambert, clay::<T>()[0].specular, [0.0; 3]);
    // (R·V)² = 1 and 16/25: ¼ (¼ + ½ · 0.64) = 0.1425, ¼ (⅛ + 0.32) = 0.11125, ¼ · 0.32. 0.64 is
    // off by 3u of itself, its half by 0.96u of 1, the sum by 1.5u
    value!(
        specular_of_phong,
        clay::<T>()[1].specular,
        [0.1425, 0.111_25, 0.08],
        units(2.7)
    );
    // the parts are off by 0.45u and 0.37u of 1, and two sums round by ¼u each
    value!(
        total_of_phong,
        clay::<T>()[1].total(),
        [0.498_75, 0.405, 0.311_25],
        units(3.0)
    );
    // (N·H)² = 1 and 9/10, off by 11u: ¼ (¼ + ½ · 0.9) = 0.175, ¼ (⅛ + 0.45) = 0.14375, ¼ · 0.45.
    // The sum is off by 5.5u
    value!(
        specular_of_blinn,
        clay::<T>()[2].specular,
        [0.175, 0.143_75, 0.1125],
        units(8.0)
    );

    /// A lobe that has no other method than the one it must have.
    #[derive(Clone, Copy)]
    struct Square;
    impl<T: Real> Lobe<T> for Square {
        fn raise(self, cosine: T) -> T {
            cosine * cosine
        }
    }
    // (N·H)² = 9/10, off by 11u; its root by 5.5u and 1u, and the square of that by 13u and 1u
    value!(
        lobe_of_ones_own,
        {
            let (n, material) = (UnitVec3::Z, material([1.0; 3], Square));
            shade::blinn_phong(n, n, &material, Rgb::BLACK, [from(slanted::<T>())]).specular
        },
        [0.9; 3],
        units(14.0)
    );

    /// A white surface under the sun from above or below.
    fn white<T: Float>(l: UnitVec3<T>) -> Shaded<T> {
        shade::phong(
            UnitVec3::Z,
            UnitVec3::Z,
            &material([1.0; 3], 5),
            Rgb::BLACK,
            [from(l)],
        )
    }
    value!(
        directions_point_away_from_the_surface,
        white::<T>(UnitVec3::Z).diffuse,
        [1.0; 3]
    );
    value!(
        highlight_toward_the_light,
        white::<T>(UnitVec3::Z).specular,
        [1.0; 3]
    );
    value!(
        nothing_from_behind,
        white::<T>(-UnitVec3::Z).total(),
        [0.0; 3]
    );

    /// As many suns above a gray surface, with ambient light.
    fn suns<T: Float>(count: usize) -> Shaded<T> {
        let suns = std::iter::repeat_n(from(UnitVec3::Z), count);
        shade::lambert(UnitVec3::Z, &material([0.5; 3], 1), gray(0.5), suns)
    }
    value!(ambient_without_lights, suns::<T>(0).ambient, [0.25; 3]);
    value!(
        ambient_of_three_lights_counts_once,
        suns::<T>(3).ambient,
        [0.25; 3]
    );
    value!(colors_are_not_clamped, suns::<T>(3).total(), [1.75; 3]);
    value!(
        colors_are_clamped_by_the_caller,
        suns::<T>(3).total().clamped(),
        [1.0; 3]
    );

    /// Each part has a reflectance of its own.
    fn parts<T: Float>() -> [Shaded<T>; 2] {
        let material = material([0.25, 0.5, 0.125], 3);
        let (n, v, sun) = (UnitVec3::Z, UnitVec3::Z, from(UnitVec3::Z));
        [
            shade::phong(n, v, &material, Rgb::WHITE, [sun]),
            shade::blinn_phong(n, v, &material, Rgb::WHITE, [sun]),
        ]
    }
    value!(
        parts_of_phong,
        {
            let s = parts::<T>()[0];
            [s.ambient.r, s.diffuse.g, s.specular.b]
        },
        [0.25, 0.5, 0.125]
    );
    value!(
        parts_of_blinn,
        {
            let s = parts::<T>()[1];
            [s.ambient.r, s.diffuse.g, s.specular.b]
        },
        [0.25, 0.5, 0.125]
    );
    value!(total_of_the_parts, parts::<T>()[1].total(), [0.875; 3]);

    value!(
        shadow_is_a_filter,
        {
            let lights = [from(UnitVec3::<T>::Z), from(slanted())];
            let lit = lights.into_iter().filter(|light| light.l() == UnitVec3::Z);
            shade::lambert(UnitVec3::Z, &material([1.0; 3], 1), Rgb::BLACK, lit).diffuse
        },
        [1.0; 3]
    );
    // 1/4 of (1, ½, 0)
    value!(
        falloff_of_ones_own_is_a_map,
        {
            let lamp = lamp::<T>([0.0, 0.0, 4.0], Attenuation::NONE).at(Vec3::ZERO);
            let dimmed = [lamp].map(|light| light * (T::ONE / light.distance()));
            shade::lambert(UnitVec3::Z, &material([1.0; 3], 1), Rgb::BLACK, dimmed).diffuse
        },
        [0.25, 0.125, 0.0]
    );

    fn shaded<T: Real>(x: f64) -> Shaded<T> {
        let [ambient, diffuse, specular] = [x, 2.0 * x, 4.0 * x].map(gray);
        Shaded {
            ambient,
            diffuse,
            specular,
        }
    }

    // 1 + 10/2, twice and four times that
    value!(
        results_add_up,
        {
            let s = shaded::<T>(1.0) + shaded(10.0) * T::of(0.5);
            [s.ambient.g, s.diffuse.g, s.specular.g, s.total().g]
        },
        [6.0, 12.0, 24.0, 42.0]
    );
    value!(
        added_to_a_result,
        {
            let mut s = shaded::<T>(1.0);
            s += s;
            [s.ambient.r, s.diffuse.g, s.specular.b]
        },
        [2.0, 4.0, 8.0]
    );
    value!(
        scaled_in_place,
        {
            let mut s = shaded::<T>(1.0);
            s *= T::of(0.5);
            [s.ambient.r, s.diffuse.g, s.specular.b]
        },
        [0.5, 1.0, 2.0]
    );
    // a white sun, halved, and then through a filter
    value!(
        light_dimmed_in_place,
        {
            let mut light = from::<T>(UnitVec3::Z);
            light *= T::of(0.5);
            light *= rgb([1.0, 0.5, 0.0]);
            light.intensity()
        },
        [0.5, 0.25, 0.0]
    );
    // ((x + 3) − 1)·x/2 at x = 4 is 12; its slope is (2x + 2)/2 = 5
    value!(
        dual_changed_in_place,
        {
            let [x, mut f] = [Dual::point(vector::<T>([4.0, 0.0, 0.0])).x; 2];
            f += T::of(3.0);
            f -= Dual::constant(T::ONE);
            f *= x;
            f /= T::of(2.0);
            [f.value, f.gradient.x]
        },
        [12.0, 5.0]
    );
    fn of_one_light<T: Float>() -> Shaded<T> {
        let material = material([0.25, 0.5, 0.0], 1);
        shade::lambert(UnitVec3::Z, &material, Rgb::WHITE, [from(UnitVec3::Z)])
    }
    /// 1/4 of the ambient light and 1/2 of the sun. Encoded, 0.75 is 0.880825: 224.6 of 255, 27.3 of 31,
    /// 55.49 of 63.
    #[test]
    fn a_result_encodes_its_total() {
        let rgb565 = 0b1_1011 << 11 | 0b11_0111 << 5 | 0b1_1011;
        let s = of_one_light::<f32>();
        assert_eq!(
            (s.to_srgb8(), s.to_rgb565(), s.to_linear8()),
            ([225; 3], rgb565, [191; 3])
        );
        let s = of_one_light::<f64>();
        assert_eq!(
            (s.to_srgb8(), s.to_rgb565(), s.to_linear8()),
            ([225; 3], rgb565, [191; 3])
        );
    }
    // 1 + u + u is 1, and u + u + 1 is 1 + 2u
    fn in_order<T: Float>(terms: [f64; 3]) -> [T; 2] {
        let sum: Shaded<T> = terms.into_iter().map(shaded).sum();
        [sum.ambient.r, sum.specular.b]
    }
    value!(
        sum_of_results_goes_forward,
        in_order::<T>([1.0, T::U, T::U]),
        [1.0, 4.0]
    );
    value!(
        sum_of_results_does_not_go_back,
        in_order::<T>([T::U, T::U, 1.0]),
        [1.0 + 2.0 * T::U, 4.0 + 8.0 * T::U]
    );
    value!(
        sum_of_no_results,
        [].into_iter().sum::<Shaded<T>>().total(),
        [0.0; 3]
    );
}

mod normals {
    use super::*;

    /// Of a box with edges of 6, 3 and 2: 6² + 3² + 2² = 7². The length is exact, and each quotient
    /// off by 1u.
    const DIAGONAL: [f64; 3] = [6.0 / 7.0, 3.0 / 7.0, 2.0 / 7.0];

    /// (−1, 2, 0) × (−1, 0, 3) = (6, 3, 2)
    fn corners<T: Real>() -> [Vec3<T>; 3] {
        [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]].map(vector)
    }

    value!(
        normal_of_a_plane,
        normal::plane(T::of(6.0), T::of(3.0), T::of(2.0)),
        DIAGONAL,
        units(1.0)
    );
    value!(
        normal_of_a_triangle,
        {
            let [a, b, c] = corners::<T>();
            normal::triangle(a, b, c)
        },
        DIAGONAL,
        units(1.0)
    );
    value!(
        normal_of_two_tangents,
        {
            let [a, b, c] = corners::<T>();
            normal::from_tangents(b - a, c - a)
        },
        DIAGONAL,
        units(1.0)
    );
    value!(
        normal_of_a_sphere,
        normal::sphere(vector::<T>([1.0; 3]), vector([7.0, 4.0, 3.0])),
        DIAGONAL,
        units(1.0)
    );
    value!(
        normal_of_a_gradient,
        normal::from_gradient(vector::<T>([6.0, 3.0, 2.0])),
        DIAGONAL,
        units(1.0)
    );
    // ∇(xyz) = (yz, xz, xy), at (1, 2, 3)
    value!(
        normal_of_an_equation,
        normal::implicit(|p: Vec3<Dual<T>>| p.x * p.y * p.z, vector([1.0, 2.0, 3.0])),
        DIAGONAL,
        units(1.0)
    );
    // s = (u, v, uv): S_u × S_v = (1, 0, v) × (0, 1, u) = (−v, −u, 1), at (2, 2); the length 3 is
    // exact
    value!(
        normal_of_a_saddle,
        normal::parametric(|u, v| Vec3::new(u, v, u * v), T::of(2.0), T::of(2.0)),
        [-2.0, -2.0, 1.0].map(|c| c / 3.0),
        units(1.0)
    );
    value!(
        normal_of_a_saddle_turned_over,
        normal::parametric(|v, u| Vec3::new(u, v, u * v), T::of(2.0), T::of(2.0)),
        [2.0, 2.0, -1.0].map(|c| c / 3.0),
        units(1.0)
    );

    /// Counter-clockwise seen from above: (1, 0, 0) × (0, 1, 0) = (0, 0, 1).
    fn floor<T: Float>(order: [usize; 3]) -> Option<UnitVec3<T>> {
        let corners = [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [0.0, 1.0, 5.0]].map(vector);
        let [a, b, c] = order.map(|i| corners[i]);
        normal::triangle(a, b, c)
    }
    value!(
        normal_of_a_floor_is_up,
        floor::<T>([0, 1, 2]),
        [0.0, 0.0, 1.0]
    );
    value!(
        normal_of_a_floor_from_another_corner,
        floor::<T>([1, 2, 0]),
        [0.0, 0.0, 1.0]
    );
    value!(
        normal_of_a_floor_clockwise_is_down,
        floor::<T>([0, 2, 1]),
        [0.0, 0.0, -1.0]
    );

    value!(
        facing_stays,
        normal::facing(slanted::<T>(), UnitVec3::Z, slanted()) == slanted(),
        true
    );
    value!(
        facing_turns_over,
        normal::facing(-slanted::<T>(), UnitVec3::Z, -slanted()) == slanted(),
        true
    );
    value!(
        facing_edge_on_stays,
        normal::facing(UnitVec3::<T>::X, UnitVec3::Z, UnitVec3::X) == UnitVec3::X,
        true
    );
    // N·V = −0.8, yet the eye sees the front of the face, so N stays
    value!(
        facing_follows_the_face_from_the_front,
        normal::facing(-slanted::<T>(), UnitVec3::Z, UnitVec3::Z) == -slanted(),
        true
    );
    value!(
        facing_follows_the_face_from_behind,
        normal::facing(-slanted::<T>(), UnitVec3::Z, UnitVec3::NEG_Z) == slanted(),
        true
    );
    /// GLSL: faceforward(N, I, N_ref) = N where N_ref·I < 0, else −N.
    fn faceforward<T: Float>(n: UnitVec3<T>, i: UnitVec3<T>, n_ref: UnitVec3<T>) -> UnitVec3<T> {
        if n_ref.dot(i) < T::ZERO { n } else { -n }
    }
    // I points from the eye to the surface: it is −V
    fn agrees_with_faceforward<T: Float>(v: UnitVec3<T>, face: UnitVec3<T>) -> bool {
        [slanted::<T>(), -slanted::<T>(), UnitVec3::X]
            .into_iter()
            .all(|n| normal::facing(n, v, face) == faceforward(n, -v, face))
    }
    value!(
        facing_is_faceforward_from_the_front,
        agrees_with_faceforward::<T>(UnitVec3::Z, slanted()),
        true
    );
    value!(
        facing_is_faceforward_from_behind,
        agrees_with_faceforward::<T>(UnitVec3::NEG_Z, slanted()),
        true
    );
    value!(
        faceforward_turns_over_edge_on_where_facing_stays,
        faceforward(UnitVec3::<T>::X, UnitVec3::NEG_Z, UnitVec3::X) == -UnitVec3::X,
        true
    );

    // the cofactors of diag(½, 1, 1) are diag(1, ½, ½), which turn (3, 0, 4)/5 into (3, 0, 2)/√13.
    // The components are off by 1u, their squares by 3u, the sum by 4u, the root by 3u, the
    // quotient by 5u
    value!(
        transformed_roof_half_as_wide,
        normal::transformed(
            slanted::<T>(),
            [[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector)
        ),
        [3.0 / 13.0_f64.sqrt(), 0.0, 2.0 / 13.0_f64.sqrt()],
        units(5.0)
    );
    // as columns: (x, y) ↦ (x + 2y, y) leaves a wall x = 0 … and its normal (1, −2, 0)/√5
    value!(
        transformed_by_a_shear,
        normal::transformed(
            UnitVec3::<T>::X,
            [[1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector)
        ),
        [1.0 / 5.0_f64.sqrt(), -2.0 / 5.0_f64.sqrt(), 0.0],
        units(2.0)
    );
    /// Mirrored in x = 0.
    fn mirror<T: Float>(n: UnitVec3<T>) -> Option<UnitVec3<T>> {
        normal::transformed(
            n,
            [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector),
        )
    }
    // a triangle in that plane stays, where the inverse transpose reverses its normal; a roof
    // slopes the other way
    value!(
        transformed_by_a_mirror,
        mirror::<T>(UnitVec3::X),
        [1.0, 0.0, 0.0]
    );
    value!(
        transformed_roof_in_a_mirror,
        mirror::<T>(slanted()),
        [0.6, 0.0, -0.8],
        units(5.0)
    );

    /// Half an equilateral triangle, seen from above.
    fn half<T: Float>() -> [Vec3<T>; 3] {
        [[0.0, 0.0, 0.0], [3.0_f64.sqrt(), 0.0, 0.0], [0.0, 1.0, 0.0]].map(vector)
    }
    // an angle is off by 8u of itself, √3 included
    value!(
        corner_of_90_degrees,
        {
            let [a, b, c] = half::<T>();
            normal::corner(a, b, c)
        },
        [0.0, 0.0, PI / 2.0],
        units(8.0)
    );
    value!(
        corner_of_60_degrees,
        {
            let [a, b, c] = half::<T>();
            normal::corner(c, a, b)
        },
        [0.0, 0.0, PI / 3.0],
        units(8.0)
    );
    value!(
        corner_of_30_degrees,
        {
            let [a, b, c] = half::<T>();
            normal::corner(b, c, a)
        },
        [0.0, 0.0, PI / 6.0],
        units(8.0)
    );

    /// A triangle with the edges (2, 0, 0) and (0, 4, 3), and a map with the differences (1, 1) and
    /// (−1, 1).
    fn mapped<T: Real>() -> ([Vec3<T>; 3], [[T; 2]; 3]) {
        let vertices = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 4.0, 3.0]].map(vector);
        (vertices, [[2.0, 3.0], [3.0, 4.0], [1.0, 4.0]].map(of))
    }
    fn t_and_h<T: Float>(order: [usize; 3]) -> Option<[T; 4]> {
        let (vertices, map) = mapped();
        normal::tangent(vertices, order.map(|i| map[i])).map(|(t, h)| [t.x, t.y, t.z, h])
    }
    // d = 2, T = (e₁ − e₂)/2 = (2, −4, −3)/2, of length √29/2; with the last two exchanged, d = −2.
    // Each edge over the longest is off by 1u, the length by 3.5u, the quotient by 5.5u
    value!(
        tangent_of_a_slanted_map,
        t_and_h::<T>([0, 1, 2]),
        [2.0, -4.0, -3.0, 29.0_f64.sqrt()].map(|c| c / 29.0_f64.sqrt()),
        units(5.5)
    );
    value!(
        tangent_of_a_mirrored_map,
        t_and_h::<T>([0, 2, 1]),
        [-2.0, 4.0, 3.0, -29.0_f64.sqrt()].map(|c| c / 29.0_f64.sqrt()),
        units(5.5)
    );

    fn sample<T: Float>(handedness: T) -> Option<UnitVec3<T>> {
        normal::mapped(
            slanted(),
            vector([2.0, 0.0, 1.0]),
            handedness,
            vector([1.0, 2.0, 2.0]),
        )
    }
    // T = (2, 0, 1), whose component along N is 2N: t = (4, 0, −3)/5, N × t = (0, 1, 0); (t ± 2(0,
    // 1, 0) + 2N)/3. Each product is off by 6u, a sum by 7u, the length by as much and 2.5u, the
    // quotient by 1u
    value!(
        mapped_sample,
        sample::<T>(T::ONE),
        [2.0, 2.0, 1.0].map(|c| c / 3.0),
        units(17.5)
    );
    value!(
        mapped_sample_of_the_other_hand,
        sample::<T>(-T::ONE),
        [2.0, -2.0, 1.0].map(|c| c / 3.0),
        units(17.5)
    );
    // T need not be perpendicular to N, and a sample below the surface is used as it is
    value!(
        mapped_by_a_slanted_tangent,
        normal::mapped(
            UnitVec3::<T>::Z,
            vector([1.0, 0.0, 5.0]),
            T::ONE,
            vector([3.0, 0.0, 4.0])
        ),
        [0.6, 0.0, 0.8],
        units(5.0)
    );
    value!(
        mapped_sample_below_the_surface,
        normal::mapped(
            UnitVec3::<T>::Z,
            *UnitVec3::X,
            T::ONE,
            vector([0.0, -3.0, -4.0])
        ),
        [0.0, -0.6, -0.8],
        units(5.0)
    );
}

mod duals {
    use super::*;

    /// x = 2, y = 3, z = −1.
    fn variables<T: Real>() -> [Dual<T>; 3] {
        Dual::point(vector([2.0, 3.0, -1.0])).into()
    }

    fn x<T: Real>() -> Dual<T> {
        variables()[0]
    }

    value!(
        dual_sum,
        {
            let [x, y, z] = variables::<T>();
            x + y - z
        },
        [6.0, 1.0, 1.0, -1.0]
    );
    value!(
        dual_product,
        {
            let [x, y, z] = variables::<T>();
            x * y * z
        },
        [-6.0, -3.0, -2.0, 6.0]
    );
    value!(dual_opposite, -x::<T>(), [-2.0, -1.0, 0.0, 0.0]);

    /// x²y/(x + y) = 12/5
    fn quotient<T: Float>() -> Dual<T> {
        let [x, y, _] = variables::<T>();
        x * x * y / (x + y)
    }
    value!(dual_quotient, quotient::<T>().value, 2.4, units(1.0));
    // ∂/∂x = (2xy(x + y) − x²y)/(x + y)² = 48/25: 12 − 2.4 is off by 2.4u of 1 and by a rounding of
    // 9.6, the quotient by 1u
    value!(
        dual_quotient_along_x,
        quotient::<T>().gradient.x,
        1.92,
        units(3.0)
    );
    // ∂/∂y = x³/(x + y)² = 8/25: 4 − 2.4 is off by 2.4u of 1 and by a rounding of 1.6, the quotient
    // by 1u
    value!(
        dual_quotient_along_y,
        quotient::<T>().gradient.y,
        0.32,
        units(3.5)
    );
    value!(dual_quotient_along_z, quotient::<T>().gradient.z, 0.0);

    value!(dual_plus_plain, x::<T>() + T::of(2.0), [4.0, 1.0, 0.0, 0.0]);
    value!(
        dual_minus_plain,
        x::<T>() - T::of(3.0),
        [-1.0, 1.0, 0.0, 0.0]
    );
    value!(
        dual_times_plain,
        x::<T>() * T::of(2.0),
        [4.0, 2.0, 0.0, 0.0]
    );
    value!(dual_over_plain, x::<T>() / T::of(2.0), [1.0, 0.5, 0.0, 0.0]);
    // 3 + x, 3 − x, 3x and 3/x, whose slope is −3/x²
    value!(
        plain_plus_dual,
        T::of(3.0).before(x())[0],
        [5.0, 1.0, 0.0, 0.0]
    );
    value!(
        plain_minus_dual,
        T::of(3.0).before(x())[1],
        [1.0, -1.0, 0.0, 0.0]
    );
    value!(
        plain_times_dual,
        T::of(3.0).before(x())[2],
        [6.0, 3.0, 0.0, 0.0]
    );
    value!(
        plain_over_dual,
        T::of(3.0).before(x())[3],
        [1.5, -0.75, 0.0, 0.0]
    );
    // a function of xy with the value 1 and the slope 5
    value!(
        dual_chain,
        {
            let [x, y, _] = variables::<T>();
            (x * y).chain(T::ONE, T::of(5.0))
        },
        [1.0, 15.0, 10.0, 0.0]
    );
    value!(
        dual_constant,
        Dual::constant(T::of(2.0)),
        [2.0, 0.0, 0.0, 0.0]
    );
    value!(
        dual_point_plus_vector,
        {
            let p = Dual::point(vector::<T>([2.0, 3.0, -1.0]));
            (p + vector::<T>([1.0; 3])).x
        },
        [3.0, 1.0, 0.0, 0.0]
    );
    value!(
        dual_point_minus_vector,
        {
            let p = Dual::point(vector::<T>([2.0, 3.0, -1.0]));
            (p - vector::<T>([1.0; 3])).y
        },
        [2.0, 0.0, 1.0, 0.0]
    );
    value!(
        dual_below_dual,
        {
            let [x, y, _] = variables::<T>();
            x < y
        },
        true
    );
    value!(
        dual_equals_by_its_value,
        x::<T>() == Dual::constant(T::of(2.0)),
        true
    );
    value!(
        dual_differs_by_its_value,
        {
            let [x, y, _] = variables::<T>();
            x == y
        },
        false
    );

    /// The value of a function of 2 and its slope.
    fn at_2<T: Float>(function: fn(Dual<T>) -> Dual<T>) -> [T; 2] {
        let result = function(x());
        [result.value, result.gradient.x]
    }
    // `libm` is right to one unit in the last place, which is 2u, and the value is off by 1u
    value!(
        dual_sine,
        at_2::<T>(Elementary::sin),
        [2.0_f64.sin(), 2.0_f64.cos()],
        units(3.0)
    );
    value!(
        dual_cosine,
        at_2::<T>(Elementary::cos),
        [2.0_f64.cos(), -(2.0_f64.sin())],
        units(3.0)
    );
    value!(
        dual_exponential,
        at_2::<T>(Elementary::exp),
        [2.0_f64.exp(); 2],
        units(3.0)
    );
    value!(
        dual_logarithm,
        at_2::<T>(Elementary::ln),
        [2.0_f64.ln(), 0.5],
        units(3.0)
    );
    // √(xy + z + 11) = 4: ∇ = (y, x, 1)/8
    value!(
        dual_root,
        {
            let [x, y, z] = variables::<T>();
            (x * y + z + T::of(11.0)).sqrt()
        },
        [4.0, 0.375, 0.25, 0.125]
    );
    value!(
        dual_absolute_value_below_0,
        variables::<T>()[2].abs(),
        [1.0, 0.0, 0.0, -1.0]
    );
    value!(
        dual_absolute_value_above_0,
        variables::<T>()[1].abs(),
        [3.0, 0.0, 1.0, 0.0]
    );
    // xⁿ and n xⁿ⁻¹ at 2, where every power is a power of two
    row!(dual_powers, {
        for n in [-10, -1, 0, 1, 2, 7, 10] {
            let power = x::<T>().powi(n);
            let is: [f64; 2] = [power.value, power.gradient.x].map(Into::into);
            assert_eq!(is, [2.0_f64.powi(n), f64::from(n) * 2.0_f64.powi(n - 1)]);
        }
    });
    // (cᵐ)′ = m cᵐ⁻¹, which is m at c = 1, also for an m of more than 16 bits
    row!(slope_of_a_large_power, {
        for m in [65_535_u32, 65_536, 100_001] {
            let one = Dual::point(vector::<T>([1.0, 0.0, 0.0])).x;
            assert_eq!(Into::<f64>::into(m.raise(one).gradient.x), f64::from(m));
        }
    });
    // (x³)″ = 6x, and (x³)′ = 3x²
    value!(
        second_derivative,
        {
            let x = Dual::point(Dual::point(vector::<T>([2.0, 0.0, 0.0]))).x;
            (x * x * x).gradient.x
        },
        [12.0, 12.0, 0.0, 0.0]
    );

    /// The slope of what arrives along z, at the distance q of a lamp.
    fn slope<T: Float>(falloff: Attenuation<T>, q: f64) -> T {
        let lamp = lamp([0.0; 3], falloff).cast(Dual::constant);
        lamp.at(Dual::point(vector([0.0, 0.0, q])))
            .intensity()
            .r
            .gradient
            .z
    }
    // 1/q² changes by −2/q³; where Foley's limit holds, the light is constant
    value!(
        slope_of_a_lamp_nearby,
        slope::<T>(falloff(0.0, 0.0, 1.0), 0.5),
        -16.0
    );
    value!(
        slope_of_a_lamp_further,
        slope::<T>(falloff(0.0, 0.0, 1.0), 2.0),
        -0.25
    );
    value!(
        slope_of_a_clamped_lamp_nearby,
        slope::<T>(falloff(0.0, 0.0, 1.0).clamped(), 0.5),
        0.0
    );
    value!(
        slope_of_a_clamped_lamp_further,
        slope::<T>(falloff(0.0, 0.0, 1.0).clamped(), 2.0),
        -0.25
    );
}

/// The cosine of L is c = ½ + kε, exactly, and both differences in t = (c − ½)/(inner − ½) are
/// exact. The quotient is off by 1u of itself, its square by 3u.
#[test]
fn a_faint_edge_keeps_its_digits() {
    for inner in [0.7_f32, 0.8, 0.9, 0.95] {
        let cone = Cone::from_cosines(inner, 0.5).expect("cosines");
        for k in (0..20).map(|i| f64::exp2(f64::from(i)) + 1.0) {
            let t = k * f64::from(f32::EPSILON) / (f64::from(inner) - 0.5);
            let l = with_cosine(0.5 + k * f64::from(f32::EPSILON));
            let factor = f64::from(cone.factor(UnitVec3::NEG_Z, l));
            assert!(
                (factor / (t * t) - 1.0).abs() <= 4.0 * f32::U,
                "{inner} {k}"
            );
        }
    }
}

/// Each short name is the type for that number, and needs no other parameter.
macro_rules! short_names {
    ($($float:ident: $($name:ident)*;)*) => {$($(
        const _: fn(shading::$float::$name) -> shading::$name<$float> = |value| value;
    )*)*};
}

short_names! {
    f32: Vec3 UnitVec3 Rgb Dual Attenuation Cone IncidentLight DirectionalLight PointLight
        SpotLight Light Material Shaded;
    f64: Vec3 UnitVec3 Rgb Dual Attenuation Cone IncidentLight DirectionalLight PointLight
        SpotLight Light Material Shaded;
}
const _: fn(shading::f32::Material<f32>) -> Material<f32, f32> = |material| material;

/// `approx` looks at every number, and its defaults mean the same as for floats.
#[cfg(feature = "approx")]
#[test]
fn approximate_comparison_looks_at_every_number() {
    use approx::{AbsDiffEq, RelativeEq, UlpsEq};

    fn looks<V, const N: usize>(value: impl Fn([f64; N]) -> V)
    where
        V: AbsDiffEq<Epsilon = f64> + RelativeEq + UlpsEq,
    {
        let one = value([1.0; N]);
        for i in 0..N {
            let with = |component: f64| {
                value(std::array::from_fn(
                    |j| if i == j { component } else { 1.0 },
                ))
            };
            let [more, double, three_up] = [1.5, 2.0, 1.0 + 3.0 * f64::EPSILON].map(with);
            assert!(one.abs_diff_eq(&more, 0.5) && !one.abs_diff_eq(&more, 0.25));
            // they differ by 1, which is half of 2
            assert!(one.relative_eq(&double, 0.0, 0.5) && !one.relative_eq(&double, 0.0, 0.25));
            assert!(one.ulps_eq(&three_up, 0.0, 3) && !one.ulps_eq(&three_up, 0.0, 2));
        }
        assert!(V::default_epsilon() <= f64::EPSILON && V::default_epsilon() >= f64::EPSILON);
        assert!(V::default_max_ulps() == f64::default_max_ulps());
        let relative = V::default_max_relative() - f64::default_max_relative();
        assert!(relative.abs() <= 0.0);
    }

    looks(Vec3::from);
    looks(|xyz| UnitVec3::assume_unit(Vec3::from(xyz)));
    looks(Rgb::from);
    looks(|[a, b, c, d, e, f, g, h, i]| Shaded {
        ambient: Rgb::new(a, b, c),
        diffuse: Rgb::new(d, e, f),
        specular: Rgb::new(g, h, i),
    });
}
