//! The promises of the documentation, for every input that they speak of.

#![allow(clippy::wildcard_imports)] // each table of claims uses nearly all that is given

mod anchors;
mod falloff;
mod given;
mod lights;
mod normals;
mod sums;
mod terms;
mod vectors;

use shading_proofs::{Given, Goal};

/// What proves a claim.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum By {
    Rules,
    Bitwuzla,
    Gappa,
    /// The rules, and Bitwuzla once more.
    Both,
}

pub struct Claim {
    pub name: &'static str,
    pub by: By,
    pub promise: &'static str,
    pub formula: fn(Given) -> Vec<Goal>,
}

macro_rules! claims {
    ($($module:ident::$name:ident $by:ident $promise:literal)*) => {
        &[$(Claim {
            name: stringify!($name),
            by: By::$by,
            promise: $promise,
            formula: $module::$name,
        }),*]
    };
}

pub const CLAIMS: &[Claim] = claims! {
    anchors::vectors_by_components Both "the operators of `Vec3` and `UnitVec3`, `dot` and `cross` are those of the components"
    anchors::directions_by_formula Both
        "`Vec3::unit`, `unit_or`, `length`, `normal::plane` and `half_vector` are v/√(v·v), where v·v is between 1/p and p"
    anchors::in_front_by_formula Both
        "any light: `is_in_front` is whether n·v > 0, v = L or position − p"
    anchors::facing_by_formula Both
        "`normal::facing` is −N where (−F)·V > 0, and N elsewhere, as where it is 0 or NaN"
    anchors::terms_by_formula Both
        "`term::lambert`, `phong`, `blinn` and `reflection` are their formulas"
    anchors::attenuation_by_formula Rules
        "`Attenuation::new` and its limits and ranges accept what is valid; `attenuation` and `at` are min(limit, \
         1/(a + bq + cq²)) times the window"
    anchors::cone_by_formula Both
        "`Cone::from_cosines` accepts −1 ≤ outer ≤ inner ≤ 1, and `factor` is 1, 0, t² or t²(3 − 2t), with edges within 8 u"
    anchors::arrival_by_formula Rules
        "any sun, and any lamp or spot whose squared distance is from 1/p to p: `l`, `distance`, `intensity` and a filter \
         are their formulas"
    anchors::sum_by_formula Rules
        "the three sums over such a light and a sun, both in front, and `Shaded::total` are their formulas"
    vectors::length_of_numbers Both "`Vec3::length` of any numbers is in [0, ∞]"
    vectors::unit_of_any Rules
        "`Vec3::unit` of any bits is `None` or has components up to 1.25 in size"
    vectors::unit_of_nothing Rules
        "`Vec3::unit` and `normal::plane` of the zero vector are `None`, and if a component is \
         infinite or NaN"
    vectors::unit_or_of_any Rules
        "`Vec3::unit_or` of any bits has components up to 1.25 in size, if the fallback has"
    vectors::unit_or_of_nothing Both
        "`Vec3::unit_or` is the fallback where `Vec3::unit` is `None`, to the bit"
    vectors::direction_of_any Rules
        "`UnitVec3::new` of any bits is `None` or has components up to 1.25 in size, unless |v|² is within \
         4ε of 1"
    vectors::direction_of_length_1 Bitwuzla
        "`UnitVec3::new` is its argument, with components up to 1.01 in size, if |v|² is within 4ε of 1"
    vectors::direction_of_nothing Bitwuzla
        "`UnitVec3::new` is `None` for the zero vector, and if a component is infinite or NaN"
    vectors::half_vector_of_any Rules
        "`half_vector` of any bits is `None` or has components up to 1.25 in size"
    vectors::half_vector_of_opposite Both "`half_vector` of L and −L, any bits, is `None`"
    vectors::half_vector_of_broken Both "`half_vector` is `None` if a component is infinite or NaN"
    vectors::clamped Both "`Rgb::clamped` of any bits is in [0, 1], NaN too"
    falloff::attenuation_of_any Both
        "`attenuation` of any bits is in [0, MAX]; `Attenuation::new` of any bits is `None`, or \
         has `coefficients` in [0, MAX]"
    falloff::attenuation_of_invalid Rules
        "`Attenuation::new` is `None` if a coefficient is negative, infinite or NaN, or all are 0, \
         and `within`, `within_gltf` and `clamped_to` for 0, below and NaN"
    falloff::attenuation_in_its_limits Rules
        "any attenuation: `at` of any bits is in [0, MAX], and at most `limit`"
    falloff::attenuation_never_rises Rules
        "any attenuation: `at` never rises with the distance, from 0 to ∞; `attenuation` never \
         rises with q, a, b or c"
    falloff::range_ends Rules
        "any attenuation with a range below the largest number: `at` is 0 for q ≥ r"
    falloff::range_never_adds Rules
        "any attenuation with a range: `at` is never above what it is without, q ≥ 0"
    falloff::cone_of_any Rules
        "any cone: `cosines` are in [−1, 1] and `factor` in [0, 1], axis and L of any bits"
    falloff::cone_of_invalid Both
        "`Cone::from_cosines` and `Cone::from_half_angles` are `None` outside of [−1, 1] and of \
         [0, π], for NaN, and if the inner edge is beyond the outer one"
    falloff::cone_on_its_axis Both "any cone: `factor` is 1 on the axis"
    falloff::cone_never_falls Rules
        "`Cone::factor`, but for `smoothstep`, never falls as the computed cosine rises"
    falloff::cone_of_everything Both
        "`Cone::factor` of a cone of cosine −1 is 1 where the computed cosine is at least −1 − 16 \
         u"
    lights::light_that_arrives Rules
        "any light, positions of any bits, through any filter: `intensity` is in [0, MAX]"
    lights::direction_that_arrives Rules
        "any lamp or spot, positions of any bits: `l` has components up to 1.25 in size"
    lights::distance_of_finite Rules
        "any lamp or spot: `distance` is in [0, MAX], finite positions; that of any sun is MAX"
    lights::light_of_nowhere Rules
        "any lamp or spot is black where it is itself, and if a coordinate of it or of p is \
         infinite or NaN"
    lights::black_light Rules "any light through a black filter is black"
    lights::spot_at_most_its_lamp Rules "a spot is never brighter than its lamp"
    sums::lit_by_any Rules
        "`shade` under any light: no channel is negative or NaN, nor one of `Shaded::total`"
    sums::any_number_of_lights Rules
        "any light adds a term in [0, ∞] to a sum that begins at 0; so no number of lights makes a \
         channel negative or NaN"
    sums::one_more_light Rules "with any light more, no channel is less"
    sums::light_behind Rules
        "any light adds nothing, to the bit, before or after another, unless n·v > 0, v = L or position − p"
    sums::light_that_is_black Rules
        "any light through a black filter adds nothing, to the bit, before or after another"
    sums::broken_lamp Rules
        "any lamp or spot with a coordinate that is infinite or NaN adds nothing, to the bit, \
         before or after another"
    sums::opposite Both "`shade::blinn_phong` has no highlight for L = −V"
    sums::reflected_at_most Rules
        "diffuse and specular are at most the largest number times k, for two lights, one of any \
         kind"
    sums::reflected_of_one Rules
        "diffuse and specular of one light are at most what arrives times k, any sun, and any lamp \
         or spot whose squared distance is from 1/p to p"
    sums::black_surface Rules "a reflectance of 0 gives 0, even if the sum of two lights overflows"
    sums::added_results Both
        "`Shaded` + `Shaded` and `Shaded` × a number of 0 or more: no channel is negative or NaN"
    normals::normals_of_any Rules
        "`normal::plane`, `triangle`, `sphere`, `implicit`, `parametric` and `from_tangents` of \
         any bits is `None` or has components up to 1.25 in size"
    normals::triangle_of_none Rules
        "`normal::triangle` is `None` if two vertices are equal, or one is infinite or NaN"
    normals::sphere_of_none Rules
        "`normal::sphere` is `None` at the center, and if a coordinate is infinite or NaN"
    normals::implicit_of_none Rules
        "`normal::implicit` and `normal::from_gradient` are `None` where ∇f is 0, infinite or NaN"
    normals::parametric_of_none Rules
        "`normal::parametric` and `from_tangents` are `None` if the tangents are equal, or one is 0, \
         infinite or NaN"
    normals::transformed_of_any Rules
        "`normal::transformed` is `None` or has components up to 1.25 in size, N of any bits, and \
         each column of any bits whose |v|² is between 1/p and p"
    normals::transformed_of_none Rules
        "`normal::transformed` is `None` if N is 0, infinite or NaN and the columns are as above"
    normals::tangent_of_any Rules
        "`normal::tangent` of any bits is `None`, or has components up to 1.25 in size and a \
         handedness in [−1, 1]"
    normals::tangent_of_none Rules
        "`normal::tangent` is `None` if two vertices have the same texture coordinates"
    normals::corner_of_none Rules
        "`normal::corner` is 0 if two vertices are equal, or one is infinite or NaN"
    normals::mapped_of_any Rules
        "`normal::mapped` of any bits is `None` or has components up to 1.25 in size"
    normals::mapped_of_none Rules
        "`normal::mapped` is `None` if T or the sample is 0, infinite or NaN, or T is N"
    terms::lambert_of_any Both "`term::lambert` of any bits is in [0, ∞]"
    terms::cosine_of_units Gappa "N·L and −N·L of two directions are in [−1 − 16 u, 1 + 16 u]"
    terms::lambert_of_units Both "`term::lambert` is at most 1 + 16 u where N·L is"
    terms::highlights_of_any Rules
        "`term::phong` and `term::blinn` of any bits by an integer are in [0, 1], odd and even \
         ones up to 2³² − 1"
    terms::highlights_in_the_dark Both
        "`term::phong` and `term::blinn` by an integer are 0 for a cosine that is not above 0 or \
         is NaN"
    terms::highlights_of_one Rules
        "`term::phong` and `term::blinn` by an integer are 1 for a cosine of 1 or above, and by 0 \
         for every cosine above 0"
    terms::powers_in_their_range Rules
        "`Lobe::raise` and `Lobe::raise_root` of [0, 1] by an integer are in [0, 1]"
    terms::one_squaring Both
        "the square of a number in [0, 1], and its product with another, are in [0, 1]"
    terms::phong_normalization Both "`term::phong_normalization` of any bits is in [0.3, MAX]"
    terms::blinn_normalization Rules
        "`term::blinn_normalization` of any bits is in [0.02, MAX], given what a real power \
         promises"
    terms::dual_values Both
        "+ − × ÷ √ of `Dual` have the value of the same number without a gradient, to \
         the bit, any bits"
};
