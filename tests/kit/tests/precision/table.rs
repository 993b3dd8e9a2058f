//! The table of each function, the largest error found, and the bound of all errors.

use shading::term::{self, blinn, phong};

use crate::measure::{
    Model, attenuated, blinn_normalization, corner, diffuse, half, highlight, implicit,
    lamp_direction, lamp_intensity, length, mapped, mirrored, normalization, parametric,
    phong_normalization, ranged, real_power, shaded, soft_cone, sphere, transformed, triangle,
    unit, whole_power,
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
    #[rustfmt::skip]
    let rows = vec![
        row("`Vec3::length`", "of the result", 2.5, &length::<T>),
        row("`Vec3::unit`, `normal::plane`", "of the result", 3.5, &unit::<T>),
        row("`normal::sphere`", "of the result", 5.5, &sphere::<T>),
        row("`normal::triangle`", "of 1, times the conditioning", 2.84, &triangle::<T>),
        row("`normal::implicit`, a torus", "of 1", 3.66, &implicit::<T>),
        row("`normal::parametric`, a paraboloid", "of 1", 1.83, &parametric::<T>),
        row("`normal::transformed`", "of 1, times the conditioning", 3.12, &transformed::<T>),
        row("`normal::corner`", "of its angle, times the conditioning", 25.9, &corner::<T>),
        row("`normal::mapped`", "of 1, times the conditioning", 9.1, &mapped::<T>),
        row("`reflection`", "of 1", 4.5, &mirrored::<T>),
        row("`half_vector`", "of the result", 5.5, &half::<T>),
        row("`lambert`", "of 1", 1.5, &diffuse::<T>),
        row("`phong`, m = 1", "of 1", whole(1.0), &highlight(phong::<T, _>, 1_u32, 1.0)),
        row("`phong`, m = 32", "of 1", whole(32.0), &highlight(phong::<T, _>, 32_u32, 32.0)),
        row("`phong`, m = 32.5", "of 1", real(32.5), &highlight(phong, t(32.5), 32.5)),
        row("`blinn`, m = 128", "of 1", whole(128.0), &highlight(blinn::<T, _>, 128_u32, 128.0)),
        row("`blinn`, m = 128.5", "of 1", real(128.5), &highlight(blinn, t(128.5), 128.5)),
        row("`Exponent::raise`, m = 32", "of the result", 31.0, &whole_power::<T>(32, 0.125)),
        row("`Exponent::raise`, m = 32.5", "of 1", power, &real_power::<T>(32.5, 0.125)),
        row("`Exponent::raise`, m = 1000", "of the result", 999.0, &whole_power::<T>(1000, 0.94)),
        row("`Exponent::raise`, m = 1000.5", "of 1", power, &real_power::<T>(1000.5, 0.94)),
        row("`phong_normalization`", "of the result", 3.0, &normalization(term::phong_normalization::<T>, phong_normalization)),
        row("`blinn_normalization`", "of the result", 11.75, &normalization(term::blinn_normalization::<T>, blinn_normalization)),
        row("`attenuation`", "of the result", 5.0, &attenuated::<T>),
        row("`Attenuation::at`, with a range", "of the attenuation without a range", 8.5, &ranged::<T>(true)),
        row("`Attenuation::at`, with a range, unsquared", "of the attenuation without a range", 7.0, &ranged::<T>(false)),
        row("`Cone::factor`, soft", "of 1, over the width of the edge", 5.95, &soft_cone::<T>(false)),
        row("`Cone::factor`, soft, a smoothstep", "of 1, over the width of the edge", 4.3, &soft_cone::<T>(true)),
        row("`PointLight::at`, direction", "of the result", 6.5, &lamp_direction::<T>),
        row("`PointLight::at`, intensity", "of the result", 13.0, &lamp_intensity::<T>),
        row("`shade::lambert`, four lights", "of all the light", 9.0, &shaded::<T>(Model::Lambert)),
        row("`shade::phong`, m = 32", "of all the light", 405.5, &shaded::<T>(Model::Phong)),
        row("`shade::blinn_phong`, m = 32", "of all the light", 193.0, &shaded::<T>(Model::BlinnPhong)),
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
