//! Surfaces of one's own, with their exact normals.

use shading::{Dual, Vec3, normal};

use crate::dialect::Dialect;
use crate::kind::{Kind, Value};
use crate::number::Expr;
use crate::print::function;
use crate::tree::Formula;

/// Writes two functions for the implicit surface f(p) = 0: `name(p)`, which is f, and `name_normal(p)`, its exact
/// normal, which is 0 where there is none.
///
/// Pass your function twice: one call records its value and the other its derivatives. The text calls functions
/// of the file of the same language, so it stands after that file.
///
/// ```
/// use shading::{Real, Vec3};
/// use shading_languages::{dialect::WGSL, implicit};
///
/// fn sphere<T: Real>(p: Vec3<T>) -> T {
///     p.dot(p) - T::ONE
/// }
/// let text = implicit(&WGSL, "sphere", sphere, sphere);
/// assert_eq!(
///     text,
///     "\
/// fn sphere(p: vec3f) -> f32 {
///     return dot(p, p) - 1.0;
/// }
///
/// fn sphere_normal(p: vec3f) -> vec3f {
///     return shading_unit(p + p);
/// }
/// "
/// );
/// ```
///
/// A comparison becomes a branch of the text, and what follows it is written for each answer, so each further one
/// doubles the text. `at_least`, `at_most` and [`Mask::select`](shading::number::Mask::select) do not.
///
/// # Panics
///
/// Panics if the function compares more than 64 numbers one after another, as a loop until a number is small does.
#[must_use]
pub fn implicit(
    dialect: &'static Dialect,
    name: &str,
    value: impl Fn(Vec3<Expr>) -> Expr,
    derivatives: impl Fn(Vec3<Dual<Expr>>) -> Dual<Expr>,
) -> String {
    let p = |of: &[Expr]| Vec3::new(of[0], of[1], of[2]);
    let value = |of: &[Expr]| vec![value(p(of))];
    let normal = |of: &[Expr]| normal::implicit(&derivatives, p(of)).numbers();
    let parameters = [("p", Kind::Vector)];
    text(dialect, name, &parameters, Kind::Number, value, normal)
}

/// Writes two functions for the parametric surface s(u, v): `name(u, v)`, which is s, and `name_normal(u, v)`, its
/// exact normal, which is 0 where there is none. It is called as [`implicit`] is.
#[must_use]
pub fn parametric(
    dialect: &'static Dialect,
    name: &str,
    point: impl Fn(Expr, Expr) -> Vec3<Expr>,
    derivatives: impl Fn(Dual<Expr>, Dual<Expr>) -> Vec3<Dual<Expr>>,
) -> String {
    let point = |of: &[Expr]| point(of[0], of[1]).numbers();
    let normal = |of: &[Expr]| normal::parametric(&derivatives, of[0], of[1]).numbers();
    let parameters = [("u", Kind::Number), ("v", Kind::Number)];
    text(dialect, name, &parameters, Kind::Vector, point, normal)
}

/// The two functions of a surface, given the parameters, and the kind of the first one's result.
fn text(
    dialect: &'static Dialect,
    name: &str,
    parameters: &[(&'static str, Kind)],
    result: Kind,
    value: impl Fn(&[Expr]) -> Vec<Expr>,
    normal: impl Fn(&[Expr]) -> Vec<Expr>,
) -> String {
    let text = |name: &str, result, of: &dyn Fn(&[Expr]) -> Vec<Expr>| {
        let record = |numbers: &[usize]| {
            let numbers: Vec<_> = numbers.iter().copied().map(Expr).collect();
            of(&numbers).iter().map(|x| x.0).collect()
        };
        let formula = Formula {
            defining: "",
            parameters,
            result,
            record: &record,
        };
        function(dialect, name, &formula) + "\n"
    };
    let normal = text(&format!("{name}_normal"), Kind::Unit, &normal);
    text(name, result, &value) + "\n" + &normal
}
