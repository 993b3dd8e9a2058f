//! The surfaces of the reference files, each written once for every number type, as users would.

use shading::{Dual, Elementary, Real, Vec3};

use support::number::Number;

use crate::table::Row;

/// f(p) of the implicit surface that a row names; the parameters are constants.
pub fn implicit<T: Number>(row: &Row, p: Vec3<Dual<T>>) -> Dual<T> {
    let number = |name| Dual::constant(T::of(row.parameter(name)));
    let square = |x: Dual<T>| x * x;
    let scaled = |x: Dual<T>, name| square(x / number(name));
    match row.text("surface") {
        "sphere" => {
            let center = Vec3::from(["cx", "cy", "cz"]).map(number);
            (p - center).dot(p - center) - square(number("r"))
        }
        "ellipsoid" => scaled(p.x, "a") + scaled(p.y, "b") + scaled(p.z, "c") - T::ONE,
        "hyperboloid1" => scaled(p.x, "a") + scaled(p.y, "b") - scaled(p.z, "c") - T::ONE,
        "hyperboloid2" => scaled(p.x, "a") + scaled(p.y, "b") - scaled(p.z, "c") + T::ONE,
        "paraboloid" => scaled(p.x, "a") + scaled(p.y, "b") - p.z,
        "cone" => scaled(p.x, "a") + scaled(p.y, "b") - scaled(p.z, "c"),
        "cylinder" => square(p.x) + square(p.y) - square(number("r")),
        "torus" => {
            let ring = (square(p.x) + square(p.y)).sqrt() - number("R");
            square(ring) + square(p.z) - square(number("r"))
        }
        "torus_quartic" => {
            let [outer, inner] = [number("R"), number("r")].map(square);
            let four = Dual::constant(T::of(4.0));
            square(p.dot(p) + outer - inner) - four * outer * (square(p.x) + square(p.y))
        }
        "gyroid" => {
            let p = p * number("a");
            p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos() - number("b")
        }
        other => panic!("unknown implicit surface {other}"),
    }
}

/// s(u, v) of the parametric surface that a row names. `control` has the points of a Bézier patch.
pub fn parametric<T: Number>(
    row: &Row,
    control: Option<&Row>,
    u: Dual<T>,
    v: Dual<T>,
) -> Vec3<Dual<T>> {
    let number = |name| Dual::constant(T::of(row.parameter(name)));
    let of = |literal| Dual::constant(T::of(literal));
    let ellipsoid = |a, b, c| {
        let (sin_u, cos_u, sin_v, cos_v) = (u.sin(), u.cos(), v.sin(), v.cos());
        Vec3::new(a * cos_u * sin_v, b * sin_u * sin_v, c * cos_v)
    };
    match row.text("surface") {
        "torus" => {
            let ring = number("R") + number("r") * v.cos();
            Vec3::new(ring * u.cos(), ring * u.sin(), number("r") * v.sin())
        }
        "mobius" => {
            let half = u * T::of(0.5);
            let ring = number("R") + v * half.cos();
            Vec3::new(ring * u.cos(), ring * u.sin(), v * half.sin())
        }
        "helicoid" => Vec3::new(v * u.cos(), v * u.sin(), number("c") * u),
        "sphere_uv" => ellipsoid(number("r"), number("r"), number("r")),
        "ellipsoid_uv" => ellipsoid(number("a"), number("b"), number("c")),
        "enneper" => {
            let third = |x: Dual<T>| x.powi(3) / of(3.0);
            let (u2, v2) = (u.powi(2), v.powi(2));
            Vec3::new(u - third(u) + u * v2, v - third(v) + v * u2, u2 - v2)
        }
        "catenoid" => {
            let c = number("c");
            let e = (v / c).exp();
            let cosh = (e + Dual::constant(T::ONE) / e) / of(2.0);
            Vec3::new(c * cosh * u.cos(), c * cosh * u.sin(), v)
        }
        "bezier33" => bezier(control.expect("control points"), u, v),
        "rational_sphere" => rational_sphere(number("r"), number("w"), u, v),
        other => panic!("unknown parametric surface {other}"),
    }
}

/// The sum of the points, each times the weights of its row and column.
fn blend<T: Number, const N: usize>(
    rows: [Dual<T>; N],
    columns: [Dual<T>; N],
    point: impl Fn(usize, usize) -> Vec3<Dual<T>>,
) -> Vec3<Dual<T>> {
    let mut sum = Vec3::ZERO;
    for (i, row) in rows.into_iter().enumerate() {
        for (j, column) in columns.into_iter().enumerate() {
            sum += point(i, j) * (row * column);
        }
    }
    sum
}

fn bezier<T: Number>(control: &Row, u: Dual<T>, v: Dual<T>) -> Vec3<Dual<T>> {
    let bernstein = |t: Dual<T>| {
        let (s, three) = (-t + T::ONE, T::of(3.0));
        [s * s * s, s * s * t * three, s * t * t * three, t * t * t]
    };
    blend(bernstein(u), bernstein(v), |i, j| {
        let point = control.vector(&format!("p{i}{j}{{}}"));
        Vec3::from(point).map(|c| Dual::constant(T::of(c)))
    })
}

/// An eighth of a sphere as a biquadratic patch with weights wᵢwⱼ, w = (1, w, 1).
fn rational_sphere<T: Number>(r: Dual<T>, w: Dual<T>, u: Dual<T>, v: Dual<T>) -> Vec3<Dual<T>> {
    // (X, Y) along u, and (ρ, z) along v
    const CORNERS: [[f64; 2]; 3] = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let of = |literal| Dual::constant(T::of(literal));
    let weighted = |t: Dual<T>| {
        let s = -t + T::ONE;
        [s * s, s * t * of(2.0) * w, t * t]
    };
    let weight = weighted(u).into_iter().fold(of(0.0), |a, b| a + b)
        * weighted(v).into_iter().fold(of(0.0), |a, b| a + b);
    let sum = blend(weighted(u), weighted(v), |i, j| {
        let ([x, y], [rho, z]) = (CORNERS[i], CORNERS[j]);
        Vec3::new(r * of(rho * x), r * of(rho * y), r * of(z))
    });
    sum.map(|c| c / weight)
}
