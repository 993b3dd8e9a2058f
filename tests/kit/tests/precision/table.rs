//! The table of each function, the largest error found, and the bound of all errors.

use shading::term::{self, blinn, phong};

use crate::measure::{
    Lights, Model, attenuated, blinn_normalization, corner, diffuse, half, highlight, implicit,
    lamp_direction, lamp_intensity, length, mapped, mirrored, normalization, parametric,
    phong_normalization, ranged, real_power, shaded, soft_cone, sphere, tangent, transformed,
    triangle, unit, whole_power,
};
use crate::search::{Numbers, largest};
use kit::Float;

/// A line of the table.
pub struct Row {
    pub function: &'static str,
    pub unit: &'static str,
    /// The largest error found.
    pub found: f64,
    /// The bound that no error exceeds.
    pub bound: f64,
}

/// The table. The page explains where the bounds come from.
#[allow(clippy::too_many_lines)] // a table
pub fn rows<T: Float>(hills: u64) -> Vec<Row> {
    // the error of a real power: 2⁻²² in `f32`, 2⁻⁵¹ in `f64`
    let (digits, power) = (if T::NAME == "f32" { 24 } else { 53 }, 2.0);
    let row = |function: &'static str, unit, bound, error: &dyn Fn(&mut Numbers) -> f64| Row {
        function,
        unit,
        found: largest(error, digits, hills),
        bound,
    };
    let whole = |m: f64| 1.5 * m + (m - 1.0) / 4.0;
    let real = |m: f64| 1.5 * m + power;
    let t = T::of;
    let rows = vec![
        row("`Vec3::length`", "of the result", 2.5, &length::<T>),
        row(
            "`Vec3::unit`, `normal::plane`",
            "of the result",
            3.5,
            &unit::<T>,
        ),
        row("`normal::sphere`", "of the result", 5.5, &sphere::<T>),
        // u is the unit roundoff; an absolute error of k u is k/2 units in the last place of 1. A
        // coordinate of an edge is off by 1u, so a product of two is off by 3u, and their difference by 1u
        // more. The vector of the |aᵢbⱼ| + |aⱼbᵢ| is at most 2/√3 |a||b| long: with pᵢ = |aᵢbᵢ|, its square
        // is |a|²|b|² + (Σp)² − 2Σp², where Σp² ≥ (Σp)²/3 and Σp ≤
        // |a||b|. So N is turned by at most (2√3κ + 1)u, κ the conditioning. A component nᵢ gets at
        // most √(1 − nᵢ²) of this, and 3.5u nᵢ from `unit`: together √((2√3κ + 1)² + 3.5²)u ≤
        // 5.68κu.
        row(
            "`normal::triangle`",
            "of 1, times the conditioning",
            2.84,
            &triangle::<T>,
        ),
        // (√(x² + y²) − 2)² + z² − ¼: with ρ = √(x² + y²) ≤ √2, ∇f is along (x(1 − 2/ρ), y(1 − 2/ρ), z). ρ
        // is off by 2u, and 1 − 2/ρ by 2/(2 − ρ) ≤ 3.42 times as much. The slope and the difference add 1u
        // each: 8.83u for x and y together, which turns N by half of that at most. Two more products put x
        // and y off by 2u each: 6.42u. √(6.42² + 3.5²)u = 7.32u.
        row("`normal::implicit`, a torus", "of 1", 3.66, &implicit::<T>),
        // (u, v, u² + uv + v²): one coordinate of each tangent is rounded, and their product is
        // exact: √(1 + 3.5²)u = 3.65u.
        row(
            "`normal::parametric`, a paraboloid",
            "of 1",
            1.83,
            &parametric::<T>,
        ),
        // A product such as b × c is off by 1u of a vector of length 2/√3 |b||c|, as above, and by
        // 1u of itself for the difference. The product with n_x and the two sums add 3u: 5.16u
        // times κ. √(5.16² + 3.5²)κu = 6.24κu.
        row(
            "`normal::transformed`",
            "of 1, times the conditioning",
            3.12,
            &transformed::<T>,
        ),
        // The sine is off by (2√3κ + 1)u for the product and 2.5u for its length, the cosine by 5u
        // of 1. An error of the sine turns θ by the cosine of it, an error of the cosine by the
        // sine, at most θ: (2√3κ + 8.5)u of θ. Most is added where b is π/4, and θ at least π/8:
        // the argument of the arctangent is off by 3u of at most tan π/8, which is 3.2u of θ; the
        // arctangent by 2u; b by ½u of at most 2θ, and the last sum by 1u. So the angle is off by
        // (2√3κ + 15.7)u ≤ 19.2κu, N by 5.68κu, and their product by 1u: 25.9κu.
        row(
            "`normal::corner`",
            "of its angle, times the conditioning",
            25.9,
            &corner::<T>,
        ),
        // An edge, and a difference of texture coordinates, is off by 1u, and the quotient of each
        // by 1u; so each of the two products is off by 5u, and their difference by 1u: T is turned
        // by at most (5κ + 1)u. √((5κ + 1)² + 3.5²)u ≤ 6.95κu.
        row(
            "`normal::tangent`",
            "of 1, times the conditioning",
            3.5,
            &tangent::<T>,
        ),
        // N × T is off by 2.16κu, so with `unit` its direction by (2.16κ + 3.5)u. Its product with
        // N adds 2.16u, and N's own length 3.5u: (2.16κ + 9.2)u for t. The three products and two
        // sums add 3√3u. With κ ≥ 1, and `unit`, at most 18.2κu.
        row(
            "`normal::mapped`",
            "of 1, times the conditioning",
            9.1,
            &mapped::<T>,
        ),
        // 2(N·L) is off by 6u, its product with a component by 2u more, because it may be 2, and
        // the difference by 1u: 9u.
        row("`reflection`", "of 1", 4.5, &mirrored::<T>),
        row("`half_vector`", "of the result", 5.5, &half::<T>),
        // A product is off by 1u of itself, and each of the two sums adds 1u: 3u of Σ|aᵢbᵢ| ≤ 1.
        row("`lambert`", "of 1", 1.5, &diffuse::<T>),
        // The cosine is off by 3u, which the power magnifies at most m times. The intermediate
        // results of an integer power lie between cᵐ and 1, where rounding is off by at most u/2:
        // together (3m + (m − 1)/2)u. With a real m, 3mu and what the power adds, which
        // `src/number/power.rs` derives.
        row(
            "`phong`, m = 1",
            "of 1",
            whole(1.0),
            &highlight(phong::<T, _>, 1_u32, 1.0),
        ),
        row(
            "`phong`, m = 32",
            "of 1",
            whole(32.0),
            &highlight(phong::<T, _>, 32_u32, 32.0),
        ),
        row(
            "`phong`, m = 32.5",
            "of 1",
            real(32.5),
            &highlight(phong, t(32.5), 32.5),
        ),
        row(
            "`blinn`, m = 128",
            "of 1",
            whole(128.0),
            &highlight(blinn::<T, _>, 128_u32, 128.0),
        ),
        row(
            "`blinn`, m = 128.5",
            "of 1",
            real(128.5),
            &highlight(blinn, t(128.5), 128.5),
        ),
        row(
            "`Lobe::raise`, m = 32",
            "of the result",
            31.0,
            &whole_power::<T>(32, 0.125),
        ),
        row(
            "`Lobe::raise`, m = 32.5",
            "of 1",
            power,
            &real_power::<T>(32.5, 0.125),
        ),
        // The product of a power by a, off by (a − 1)u of itself, and of one by b, off by (b − 1)u,
        // is off by the sum of both and 1u: (a + b − 1)u. So a power by m is off by (m − 1)u, in
        // whatever order the products are taken.
        row(
            "`Lobe::raise`, m = 1000",
            "of the result",
            999.0,
            &whole_power::<T>(1000, 0.94),
        ),
        row(
            "`Lobe::raise`, m = 1000.5",
            "of 1",
            power,
            &real_power::<T>(1000.5, 0.94),
        ),
        row(
            "`phong_normalization`",
            "of the result",
            3.0,
            &normalization(term::phong_normalization::<T>, phong_normalization),
        ),
        // (m + 2)(m + 4)/(8π(m + 2^(−m/2))). √½ is off by at most u/2, which its power by m magnifies
        // at most m√½^(m − 1) ≤ 1½ times, and what raises it adds 4u of 1: 4¾u of m + 2^(−m/2), which
        // is least for m = 0, where it is 1. The three sums, the constant, the quotient and the two
        // products add 1u each: 11¾u.
        row(
            "`blinn_normalization`",
            "of the result",
            11.75,
            &normalization(term::blinn_normalization::<T>, blinn_normalization),
        ),
        row("`attenuation`", "of the result", 5.0, &attenuated::<T>),
        // The share s of the range is off by 1u of itself and s⁴ by 7u, so x = 1 − s⁴ by 7u(1 − x)
        // and by ½u more where it is rounded, for x > ½. Of the factor without a range, which is
        // off by 5u, and 1u for the product: unsquared 7(1 − x) + ½ + 6x ≤ 7 for x > ½, and 7 − x
        // below; squared 2x(7(1 − x) + ½) + ½ + 6x² ≤ 7.6, in u.
        row(
            "`Attenuation::at`, with a range",
            "of the attenuation without a range",
            8.5,
            &ranged::<T>(true),
        ),
        row(
            "`Attenuation::at`, with a range, as in glTF",
            "of the attenuation without a range",
            7.0,
            &ranged::<T>(false),
        ),
        // W ≤ 1 is the width. The cosine is off by 3u; the difference, the width and t, none above
        // 1, are each rounded by ½u: t is off by 4½u/W. Its square is off by twice that and ½u:
        // 9½u/W. The slope of t²(3 − 2t) is at most 3/2, and its roundings near t = ½ add 1¼u:
        // 8u/W.
        row(
            "`Cone::factor`, soft",
            "of 1, over the width of the edge",
            5.95,
            &soft_cone::<T>(false),
        ),
        row(
            "`Cone::factor`, soft, a smoothstep",
            "of 1, over the width of the edge",
            4.3,
            &soft_cone::<T>(true),
        ),
        row(
            "`PointLight::at`, direction",
            "of the result",
            6.5,
            &lamp_direction::<T>,
        ),
        row(
            "`PointLight::at`, intensity",
            "of the result",
            13.0,
            &lamp_intensity::<T>,
        ),
        // The cosine is off by 3u of 1; its product with the light, three sums, the reflectance and
        // two sums of the total add 1u each, but for a sum with 0: 9u.
        row(
            "`shade::lambert`, four suns",
            "of all the light",
            9.0,
            &shaded::<T>(Model::Lambert, Lights::Suns),
        ),
        // R·V is off by 6u for 2(N·L), 3u for the rest of R and 3u as a dot product. From these
        // 12u, as above, 399.5u for the power, and then 405.5u for the sum.
        row(
            "`shade::phong`, m = 32, four suns",
            "of all the light",
            405.5,
            &shaded::<T>(Model::Phong, Lights::Suns),
        ),
        // The sum L + V is off by 1u, which turns it by at most u; the slope of cos³² of an angle
        // is at most 3.5. (N·h)²/(h·h) is off by 2·3u for N·h, 1u for its square, 3u for h·h and 1u
        // for the quotient. From these 11u, as above, 183.5u for the power of 16; with 3.5u, and 6u
        // for the sum, 193u.
        row(
            "`shade::blinn_phong`, m = 32, four suns",
            "of all the light",
            193.0,
            &shaded::<T>(Model::BlinnPhong, Lights::Suns),
        ),
        // The vector w to a lamp is off by 1u of its length, which turns L by as much; |w| is off
        // by 2.5u, and its quotient by 1u: 4.5u more for each cosine. The intensity is off by 26u,
        // as above. Lambert's sum of 9u becomes 39.5u, and Phong's R·V of 12u becomes 16.5u, 32
        // times of which are 144u more: 405.5u + 144u + 26u.
        row(
            "`shade::lambert`, four lamps",
            "of all the light",
            39.5,
            &shaded::<T>(Model::Lambert, Lights::Lamps),
        ),
        row(
            "`shade::phong`, m = 32, four lamps",
            "of all the light",
            575.5,
            &shaded::<T>(Model::Phong, Lights::Lamps),
        ),
        // h = w + |w|v is off by 1u|w| for w, by 3.5u|w| for its length, by 1u|w| for the product
        // and by 1u|h|. With |w|/|h| = 1/|L + V|, the first three turn it by 5.5u/|L + V|, which
        // the slope of 3.5 makes 19.3u: with the 193u of suns, and 26u for the intensity and 4.5u
        // for N·L, 242.8u.
        row(
            "`shade::blinn_phong`, m = 32, four lamps",
            "of all the light, over the least \\|L + V\\| below 1",
            242.8,
            &shaded::<T>(Model::BlinnPhong, Lights::Lamps),
        ),
    ];
    rows
}

/// A line of the table in `f32` and `f64`, as on the page.
pub fn line((single, double): (&Row, &Row)) -> String {
    let found = [single, double].map(|row| tenths(row.found));
    let bound = tenths(single.bound);
    let [single_found, double_found] = found;
    format!(
        "| {} | {single_found} | {double_found} | {bound} | {} |",
        single.function, single.unit
    )
}

/// Rounds up to a tenth.
fn tenths(x: f64) -> String {
    format!("{:.1}", (x * 10.0).ceil() / 10.0)
}
