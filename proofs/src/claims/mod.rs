//! The promises of the documentation, for every input that they speak of. The table of `docs/proofs.md` says what
//! each claim is, and what proves it.

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

type Formula = fn(Given) -> Vec<Goal>;

#[derive(Clone, Copy)]
pub struct Claim {
    pub name: &'static str,
    pub formula: Formula,
    /// What proves it, in the words of the page: "rules", "bitwuzla" or "gappa", or two of them.
    pub by: &'static str,
}

macro_rules! formulas {
    ($($module:ident: $($name:ident),*;)*) => {
        &[$($((stringify!($name), $module::$name)),*),*]
    };
}

const FORMULAS: &[(&str, Formula)] = formulas! {
    anchors: vectors_by_components, directions_by_formula, in_front_by_formula,
        facing_by_formula, terms_by_formula, attenuation_by_formula, cone_by_formula,
        arrival_by_formula, sum_by_formula;
    vectors: length_of_numbers, unit_of_any, unit_of_nothing, unit_or_of_any,
        unit_or_of_nothing, direction_of_any, direction_of_length_1, direction_of_nothing,
        half_vector_of_any, half_vector_of_opposite, half_vector_of_broken, clamped;
    falloff: attenuation_of_any, attenuation_of_invalid, attenuation_in_its_limits,
        attenuation_never_rises, range_ends, range_never_adds, cone_of_any, cone_of_invalid,
        cone_on_its_axis, cone_never_falls, cone_of_everything;
    lights: light_that_arrives, direction_that_arrives, distance_of_finite, light_of_nowhere,
        black_light, spot_at_most_its_lamp;
    sums: lit_by_any, any_number_of_lights, one_more_light, light_behind, light_that_is_black,
        broken_lamp, opposite, reflected_at_most, reflected_of_one, black_surface,
        added_results;
    normals: normals_of_any, triangle_of_none, sphere_of_none, implicit_of_none,
        parametric_of_none, transformed_of_any, transformed_of_none, tangent_of_any,
        tangent_of_none, corner_of_none, mapped_of_any, mapped_of_none;
    terms: lambert_of_any, cosine_of_units, lambert_of_units, highlights_of_any,
        highlights_in_the_dark, highlights_of_one, powers_in_their_range, one_squaring,
        phong_normalization, blinn_normalization, dual_values;
};

/// The claims, each with its row of the page.
pub fn claims() -> Vec<Claim> {
    let page = include_str!("../../../docs/proofs.md");
    let table = page
        .split_once("| claim | says | by |\n")
        .expect("the table")
        .1;
    let rows = table.lines().skip(1).take_while(|row| row.starts_with('|'));
    let rows: Vec<_> = rows.map(|row| row.split(" | ").collect()).collect();
    assert_eq!(rows.len(), FORMULAS.len(), "rows of docs/proofs.md");
    let of = |&(name, formula)| {
        let is_its = |row: &&Vec<&str>| row[0] == format!("| `{name}`");
        let row = rows
            .iter()
            .find(is_its)
            .unwrap_or_else(|| panic!("no row of {name}"));
        let by = row[row.len() - 1].trim_end_matches(" |");
        assert!(
            ["rules", "bitwuzla", "gappa", "rules, bitwuzla"].contains(&by),
            "{name}: {by}"
        );
        Claim { name, formula, by }
    };
    FORMULAS.iter().map(of).collect()
}
