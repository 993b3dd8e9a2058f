//! Surfaces of one's own, with their exact normals.

use shading::{Dual, Vec3, normal};

use crate::dialect::Dialect;
use crate::file::Recorded;
use crate::graph::Graph;
use crate::kind::{Kind, Parts};
use crate::number::{Expr, variable};

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
/// # Panics
///
/// Panics if the function takes a decision by a comparison that has no answer before there are numbers, as
/// `partial_cmp` does. `<`, `>`, `<=` and `>=` become branches of the text.
#[must_use]
pub fn implicit(
    dialect: &'static Dialect,
    name: &str,
    value: impl Fn(Vec3<Expr>) -> Expr,
    derivatives: impl Fn(Vec3<Dual<Expr>>) -> Dual<Expr>,
) -> String {
    let parameters = [("p", Kind::Vector)];
    let p = || Vec3::from([0, 1, 2].map(|i| variable("p", Some(i))));
    let value = text(dialect, name, &parameters, Kind::Number, &|| {
        vec![value(p())]
    });
    let normal = || normal::implicit(&derivatives, p()).parts();
    let name = format!("{name}_normal");
    let normal = text(dialect, &name, &parameters, Kind::Unit, &normal);
    format!("{value}\n{normal}")
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
    let parameters = [("u", Kind::Number), ("v", Kind::Number)];
    let [u, v] = ["u", "v"].map(|name| move || variable(name, None));
    let point = || point(u(), v()).parts();
    let point = text(dialect, name, &parameters, Kind::Vector, &point);
    let normal = || normal::parametric(&derivatives, u(), v()).parts();
    let name = format!("{name}_normal");
    let normal = text(dialect, &name, &parameters, Kind::Unit, &normal);
    format!("{point}\n{normal}")
}

/// A function of the user's.
fn text(
    dialect: &'static Dialect,
    name: &str,
    parameters: &[(&'static str, Kind)],
    result: Kind,
    formula: &dyn Fn() -> Vec<Expr>,
) -> String {
    let graph = Graph::new("", false, true);
    let recorded = Recorded {
        graph,
        name,
        parameters,
        result,
        formula: &|| formula().iter().map(|x| x.0).collect(),
    };
    recorded.text(dialect, [dialect.namespace, dialect.prefix].concat(), &[])
}
