//! What holds of local illumination, whatever the number type.
//!
//! A property is a function with its sentence over it. It takes a [`Scene`], some [`Directions`], a
//! [`Triangle`], or what else it is about, and fails as proptest's properties do. [`all!`] makes a
//! test of each, for a number:
//!
//! ```ignore
//! mod my_number {
//!     properties::all!(super::MyNumber);
//! }
//! ```
//!
//! ```text
//! test my_number::light::lights_add_up ... ok
//! ```
//!
//! A test that fails prints the simplest input that proptest finds, as a call to paste into a test.
//!
//! Four groups of properties hold of most numbers, but not of all. A number that does not promise
//! one says so, and those properties are not listed for it: `properties::all!(super::MyNumber,
//! without doubling)`.
//!
//! | group | promises |
//! |---|---|
//! | `doubling` | a product with a power of two is exact, as in a binary float |
//! | `mirroring` | −x is rounded as x is |
//! | `ordering` | a sum over lights rounds after each light: `Real::Sum` is a color of the number |
//! | `plain` | what dims a light is computed by the formulas, so a dual number has the same light |
//!
//! A number with elementary functions, which is a real shininess, too, has more:
//! `properties::all!(f32, with functions)`.
#![allow(clippy::missing_errors_doc, clippy::missing_panics_doc)] // a property fails
#![allow(clippy::must_use_candidate)] // short names for what is printed
#![allow(clippy::float_cmp)] // what holds to the bit is compared so

mod book;
mod given;
mod number;
mod run;
mod simplest;
mod source;
mod strategies;
mod tracked;

pub mod colors;
pub mod directions;
pub mod falloff;
pub mod light;
pub mod normals;
pub mod numbers;
pub mod terms;

pub use given::{Beam, Directions, Falloff, Frame, Numbers, Scene, Triangle};
pub use number::Number;
/// What a property returns: proptest's own.
pub use proptest::test_runner::TestCaseResult as Outcome;
pub use run::{run, try_property};
pub use tracked::Tracked;

// what the input of a failed test is written with
pub use given::{coefficients, cone, down, lamp, material, rgb, shiny, spot, sun, unit, up, vec3};
pub use shading::{Attenuation, Real, Rgb, UnitVec3};

use shading::Vec3;

/// Every property, by topic; a group in brackets is one that a number may not promise.
macro_rules! properties {
    ($d:tt $($topic:ident: $($([$group:ident])? $name:ident)*;)*) => {
        /// Makes a test of each property, for a number: `mod half { properties::all!(super::Half);
        /// }`.
        #[macro_export]
        macro_rules! all {
            ($d number:ty) => {
                $d crate::all! { @ $d number, functions }
            };
            ($d number:ty, with functions) => {
                $d crate::all! { @ $d number, }
            };
            ($d number:ty, without $d($d without:ident),+) => {
                $d(const _: () = $d crate::without::$d without;)+
                $d crate::all! { @ $d number, functions $d($d without)+ }
            };
            (@ $d number:ty, $d($d without:ident)*) => {
                type Number = $d number;
                $(mod $topic {
                    $($d crate::property! {
                        ($($group)?) ($d($d without)*)
                        #[test]
                        fn $name() {
                            let name = concat!(stringify!($topic), "::", stringify!($name));
                            let number = stringify!($d number);
                            let property = $d crate::$topic::$name::<super::Number>;
                            $d crate::run(name, number, property);
                        }
                    })*
                })*
            };
        }

        /// The names of all properties, such as `"light::lights_add_up"`.
        pub const NAMES: &[&str] = &[
            $($(concat!(stringify!($topic), "::", stringify!($name)),)*)*
        ];
    };
}

/// The groups that a number may do without.
#[doc(hidden)]
#[allow(non_upper_case_globals)]
pub mod without {
    pub const doubling: () = ();
    pub const mirroring: () = ();
    pub const ordering: () = ();
    pub const plain: () = ();
}

/// A test, unless the number does without its group.
#[doc(hidden)]
#[macro_export]
macro_rules! property {
    (() ($($without:ident)*) $test:item) => { $test };
    (($group:ident) () $test:item) => { $test };
    ((functions) (functions $($rest:ident)*) $test:item) => {};
    ((doubling) (doubling $($rest:ident)*) $test:item) => {};
    ((mirroring) (mirroring $($rest:ident)*) $test:item) => {};
    ((ordering) (ordering $($rest:ident)*) $test:item) => {};
    ((plain) (plain $($rest:ident)*) $test:item) => {};
    (($group:ident) ($other:ident $($rest:ident)*) $test:item) => {
        $crate::property! { ($group) ($($rest)*) $test }
    };
}

properties! { $
    light:
        no_light_is_negative
        lights_add_up
        [ordering] lights_add_up_in_their_order
        the_order_of_lights_does_not_matter
        a_black_light_changes_nothing
        [doubling] half_the_light_is_half_as_bright
        any_fraction_of_the_light_is_that_fraction_as_bright
        each_reflectance_scales_its_term
        channels_are_apart
        red_stays_out_of_green_and_blue
        the_ambient_term_counts_once
        a_surface_returns_at_most_what_arrives
        diffuse_does_not_see_the_eye
        nothing_comes_from_behind
        a_light_is_in_front_where_n_dot_l_is_above_0
        a_light_on_the_horizon_adds_nothing
        the_sum_of_lambert_is_its_formula
        the_sum_of_phong_is_its_formula
        the_sum_of_blinn_is_its_formula
        a_light_at_the_point_adds_nothing
        a_sun_is_as_bright_everywhere
        a_shadow_ray_ends_at_the_lamp
        arrival_is_l_intensity_and_distance
        a_lamp_fades_with_its_distance
        a_spot_is_a_lamp_within_its_cone
        a_filter_multiplies_what_arrives
        a_lamp_never_brightens_as_it_recedes
        [doubling] a_scene_of_twice_the_size_is_as_bright
        [mirroring] half_a_turn_of_the_scene_changes_nothing
        a_quarter_turn_of_the_scene_changes_little
        a_lamp_moves_with_its_point
        a_far_lamp_is_a_sun
        results_add_up_part_by_part;
    directions:
        [mirroring] reflection_has_no_side
        reflection_twice_is_the_identity
        reflection_keeps_the_length
        reflection_makes_the_same_angle
        reflection_lies_opposite_l
        half_vector_is_symmetric
        half_vector_is_halfway
        half_vector_is_its_formula
        opposites_have_no_half_vector
        the_eye_in_the_reflection_sees_h_at_n
        a_length_is_the_root_of_the_squares
        a_direction_has_length_1
        nothing_has_no_direction
        [doubling] a_direction_has_no_size
        [mirroring] opposite_vectors_are_as_long
        products_of_vectors_keep_lagranges_identity
        a_blend_goes_from_one_to_the_other;
    terms:
        lambert_is_the_cosine
        lambert_is_never_negative
        lambert_has_no_preferred_side
        tilting_l_toward_n_never_darkens
        phong_is_a_power_of_the_cosine
        blinn_is_a_power_of_the_cosine
        a_highlight_is_at_most_1
        no_highlight_without_a_cosine
        light_and_eye_can_be_exchanged
        phong_and_blinn_are_related
        blinn_of_4m_is_at_least_phong_of_m
        a_power_rises_with_its_cosine
        a_power_falls_with_its_exponent
        powers_of_0_and_1_are_exact
        powers_multiply
        a_power_of_a_root_is_half_the_power
        a_normalized_phong_lobe_returns_everything
        [functions] a_normalized_blinn_lobe_returns_everything
        [functions] whole_and_real_exponents_agree
        [functions] a_real_power_is_its_formula;
    falloff:
        attenuation_is_its_formula
        a_range_is_its_formula
        light_never_rises_with_distance
        light_never_rises_with_a_coefficient
        a_falloff_is_at_most_1_over_a
        a_clamped_falloff_is_at_most_its_limit
        without_attenuation_everything_arrives
        nothing_arrives_from_the_range_on
        a_range_never_brightens
        a_cone_is_its_formula
        a_cone_never_amplifies
        a_cone_lights_its_axis
        a_cone_of_pi_lights_everything
        a_wider_cone_never_darkens
        a_cone_never_darkens_toward_its_axis
        a_cone_without_an_edge_is_hard
        a_cone_is_round
        [functions] a_half_angle_is_measured_from_the_axis
        a_cast_proves_again;
    normals:
        a_normal_has_length_1
        a_normal_is_perpendicular_to_its_edges
        any_vertex_may_come_first
        an_exchange_turns_the_normal_over
        [mirroring] an_exchange_turns_the_corner_over
        a_degenerate_triangle_has_no_normal
        a_line_has_no_normal
        a_normal_does_not_move_with_its_surface
        [mirroring] a_normal_turns_with_its_surface
        [doubling] a_normal_has_no_size
        a_normal_survives_a_point_reflection
        planes_and_spheres_have_their_direction
        equation_and_parameters_agree
        a_negative_equation_turns_the_normal_over
        [doubling] a_multiple_of_an_equation_has_its_normal
        a_normal_can_face_the_eye
        a_normal_is_transformed_with_its_surface
        a_rotation_transforms_a_normal_as_a_vector
        [doubling] a_matrix_has_no_size
        the_angles_of_a_triangle_add_up_to_pi
        a_corner_is_as_long_as_its_angle
        a_corner_can_be_split
        a_tangent_follows_the_texture
        a_normal_map_is_relative_to_its_frame;
    numbers:
        zero_and_one_are_neutral
        each_operation_rounds_once
        [doubling] doubling_is_exact
        a_comparison_decides
        constants_are_themselves
        the_power_of_a_halfway_cosine_is_its_formula
        a_cast_to_f64_and_back_is_the_same
        a_dual_number_has_the_value_of_its_number
        [plain] a_dual_number_has_the_light_of_its_number
        derivatives_follow_their_rules
        [doubling] a_slope_is_linear_in_the_tangent
        [functions] elementary_functions_have_their_slopes;
    colors:
        a_clamped_color_is_within_0_and_1
        [functions] srgb_is_its_formula
        [functions] srgb_survives_the_round_trip
        [functions] rgb565_is_its_formula
        [functions] linear_bytes_are_proportional;
}

/// Half a turn about z.
fn half_a_turn<T: Real>(v: Vec3<T>) -> Vec3<T> {
    Vec3::new(-v.x, -v.y, v.z)
}

/// A quarter of a turn about z.
fn quarter_turn<T: Real>(v: Vec3<T>) -> Vec3<T> {
    Vec3::new(-v.y, v.x, v.z)
}

/// The least number with all digits; 0 in fixed point, where none has more than another.
fn least_normal<T: Number>() -> f64 {
    if T::U > 0.0 { T::SMALLEST / T::U } else { 0.0 }
}

/// Whether the square of a length needs no scaling.
fn is_tame<T: Number>(square: f64) -> bool {
    square > 1.0 / T::LARGE && square < T::LARGE
}

/// Whether the square of a length has the digits of an ordinary number. In fixed point, one beyond
/// `EXTREME` has few.
fn has_digits<T: Number>(square: f64) -> bool {
    square > 0.0 && (is_tame::<T>(square) || T::U > 0.0)
}
