//! The promises of the documentation, for every input that they speak of.

#![allow(clippy::wildcard_imports)] // each table of claims uses nearly all that is given

mod falloff;
mod given;
mod lights;
mod normals;
mod sums;
mod terms;
mod vectors;

use shading_proofs::{Given, Goal};

pub struct Claim {
    pub name: &'static str,
    pub promise: &'static str,
    pub formula: fn(Given) -> Vec<Goal>,
}

macro_rules! claims {
    ($($module:ident::$name:ident $promise:literal)*) => {
        &[$(Claim {
            name: stringify!($name),
            promise: $promise,
            formula: $module::$name,
        }),*]
    };
}

pub const CLAIMS: &[Claim] = claims! {
    vectors::length_of_numbers "`Vec3::length` of any numbers is in [0, ∞]"
    vectors::unit_of_any "`Vec3::unit` of any bits is `None` or has components up to 1.25 in size"
    vectors::unit_of_nothing "`Vec3::unit` and `normal::plane` of the zero vector are `None`, and if a component is infinite or NaN"
    vectors::unit_or_of_any "`Vec3::unit_or` of any bits has components up to 1.25 in size, if the fallback has"
    vectors::unit_or_of_nothing "`Vec3::unit_or` is the fallback where `Vec3::unit` is `None`, to the bit"
    vectors::direction_of_any "`UnitVec3::new` of any bits is `None`, or its argument, each component in [−1.01, 1.01]"
    vectors::direction_of_nothing "`UnitVec3::new` is `None` for the zero vector, and if a component is infinite or NaN"
    vectors::half_vector_of_any "`half_vector` of any bits is `None` or has components up to 1.25 in size"
    vectors::half_vector_of_opposite "`half_vector` of L and −L, any bits, is `None`"
    vectors::half_vector_of_broken "`half_vector` is `None` if a component is infinite or NaN"
    vectors::clamped "`Rgb::clamped` of any bits is in [0, 1], NaN too"
    falloff::attenuation_of_any "`Attenuation::new` of any bits is `None`, or `coefficients` are in [0, MAX] and `at` of any bits is in [0, MAX]"
    falloff::attenuation_of_invalid "`Attenuation::new` is `None` if a coefficient is negative, infinite or NaN, or all are 0"
    falloff::attenuation_in_its_limit "`Attenuation::at` with any range, of any bits, is in [0, MAX], and in [0, 1] if `clamped`, with glTF's window or not"
    falloff::attenuation_never_rises "`Attenuation::at` never rises with the distance, with any range or none, `clamped`, with glTF's window or not"
    falloff::range_of_invalid "`Attenuation::within` is `None` for r ≤ 0 and NaN"
    falloff::range_ends "`Attenuation::at` is 0 for q ≥ r, any range below the largest number, with glTF's window or not"
    falloff::range_never_adds "`Attenuation::at` with a range is never above that without, any r and q ≥ 0"
    falloff::cone_of_any_cosines "`Cone::from_cosines` of any bits is `None`, or `cosines` are in [−1, 1] and `factor` in [0, 1], axis and L of any bits, `smoothstep` or not"
    falloff::cone_of_any_half_angles "the same of `Cone::from_half_angles`, given that the cosine of a finite number is in [−1, 1]"
    falloff::cone_of_invalid_cosines "`Cone::from_cosines` is `None` for a cosine outside of [−1, 1], for NaN, and if the inner one is below the outer one"
    falloff::cone_of_invalid_half_angles "`Cone::from_half_angles` is `None` for an angle below 0 or above 3.15, for NaN, and if the inner one is above the outer one"
    falloff::cone_on_its_axis "`Cone::factor` is 1 on the axis, whatever `Cone::from_cosines` gets"
    falloff::cone_of_everything "`Cone::factor` of a cone of cosine −1 is 1 in every direction"
    lights::lamp_of_any "`PointLight::at`, positions of any bits: `intensity` is in [0, MAX], and `l` has components up to 1.25 in size"
    lights::distance_of_finite "`IncidentLight::distance` of a lamp is in [0, MAX], finite positions"
    lights::lamp_with_a_range "the same with any range"
    lights::spot_of_any "the same of `SpotLight::at`, axis and cosines of any bits"
    lights::light_at_the_point "`PointLight::at` and `SpotLight::at` are black where the light is"
    lights::light_at_infinity "`PointLight::at` is black if a coordinate of the light or of p is infinite or NaN"
    lights::black_lamp "`PointLight::at` of a black light is black, whatever the attenuation, positions of any bits"
    sums::lit_by_suns "`shade`, two lights, in the three models, any shininess: no channel is negative or NaN, nor one of `Shaded::total`"
    sums::lit_by_a_lamp "the same of `shade::blinn_phong` under a lamp, positions of any bits"
    sums::any_number_of_lights "each light adds a term in [0, ∞] to a sum that begins at 0, in the three models, any shininess; so no number of lights makes a channel negative or NaN"
    sums::behind "a light with N·L ≤ 0, or NaN, adds nothing, to the bit, before or after another, in the three models, any shininess; directions of any bits"
    sums::lamp_behind "the same of `PointLight` and `SpotLight` that are not `is_in_front`, positions of any bits"
    sums::black_light "a black light adds nothing, to the bit, before or after another, in the three models, any shininess"
    sums::broken_lamp "the same of a lamp with a coordinate that is infinite or NaN"
    sums::opposite "`shade::blinn_phong` has no highlight for L = −V"
    sums::black_surface "a reflectance of 0 gives 0, even if the sum of two lights overflows"
    sums::reflected_at_most "diffuse and specular are at most the largest number times k"
    sums::highlight_at_most "the highlight of one light is at most its intensity times k_s, in the three models, any shininess"
    normals::normals_of_any "`normal::triangle`, `sphere`, `implicit`, `parametric` and `from_tangents` of any bits is `None` or has components up to 1.25 in size"
    normals::triangle_of_none "`normal::triangle` is `None` if two vertices are equal, or one is infinite or NaN"
    normals::sphere_of_none "`normal::sphere` is `None` at the center, and if a coordinate is infinite or NaN"
    normals::implicit_of_none "`normal::implicit` and `normal::from_gradient` are `None` where ∇f is 0, infinite or NaN"
    normals::parametric_of_none "`normal::parametric` is `None` if the tangents are equal, or one is 0, infinite or NaN"
    normals::tangents_of_none "`normal::from_tangents` is `None` if the tangents are equal, or one is 0, infinite or NaN"
    normals::facing_faces "`normal::facing`: N·V is not negative, N and V of any numbers"
    normals::facing_stays "`normal::facing` is N, to the bit, if N·V is 0 or above or NaN"
    normals::transformed_of_any "`normal::transformed` is `None` or has components up to 1.25 in size, N of any bits, and each column of any bits whose |v|² is between 1/p and p"
    normals::transformed_of_none "`normal::transformed` is `None` if N is 0, infinite or NaN and the columns are as above"
    normals::tangent_of_any "`normal::tangent` of any bits is `None`, or has components up to 1.25 in size and a handedness in [−1, 1]"
    normals::tangent_of_none "`normal::tangent` is `None` if two vertices have the same texture coordinates"
    normals::corner_of_none "`normal::corner` is 0 if two vertices are equal, or one is infinite or NaN"
    normals::mapped_of_any "`normal::mapped` of any bits is `None` or has components up to 1.25 in size"
    normals::mapped_of_none "`normal::mapped` is `None` if T or the sample is 0, infinite or NaN, or T is N"
    terms::lambert_of_any "`term::lambert` of any bits is in [0, ∞]"
    terms::lambert_of_units "`term::lambert` of directions is at most 1 + 16 u"
    terms::highlights_of_any "`term::phong` and `term::blinn` of any bits by an integer are in [0, 1], odd and even ones up to 2³² − 1"
    terms::highlights_in_the_dark "`term::phong` and `term::blinn` by an integer are 0 for a cosine that is not above 0 or is NaN"
    terms::highlights_of_one "`term::phong` and `term::blinn` by an integer are 1 for a cosine of 1 or above, and by 0 for every cosine above 0"
    terms::powers_in_their_range "`Lobe::raise` and `Lobe::raise_root` of [0, 1] by an integer are in [0, 1]"
    terms::phong_normalization "`term::phong_normalization` of any bits is in [0.3, MAX]"
    terms::blinn_normalization "`term::blinn_normalization` of any bits is in [0.02, MAX], given what a real power promises"
    terms::dual_values "+ − × ÷ √ and `powi` of `Dual` have the value of the same number without a gradient, to the bit, any bits"
};
