//! Normals differentiated by dual numbers against normals from gradients and tangents derived by
//! hand, at every point of the reference files.

use shading::{UnitVec3, Vec3, normal};
use support::number::{Number, for_f32_and_f64, vector};

use crate::surfaces;
use crate::table::{Row, Tally, rows};
use support::running::{Bounded, Float};

for_f32_and_f64!(gradients_by_hand, tangents_by_hand);

/// Compares the two normals; each is computed independently, so each has its own bound.
fn compare<T: Float>(
    tally: &mut Tally,
    row: &Row,
    [dual, by_hand]: [UnitVec3<T>; 2],
    [dual_, by_hand_]: [UnitVec3<T::Running>; 2],
) {
    let [dual, by_hand] = [dual, by_hand].map(|n| n.map(T::to_f64).into());
    let errors = |n: UnitVec3<T::Running>| <[f64; 3]>::from(n.map(Bounded::error));
    let (a, b) = (errors(dual_), errors(by_hand_));
    let tolerance = [0, 1, 2].map(|i| a[i] + b[i]);
    let title = format!("{} {}", row.text("surface"), row.text("id"));
    tally.compare(title, dual, by_hand, tolerance);
}

fn gradients_by_hand<T: Float>() {
    let mut tally = Tally::new::<T>("implicit surfaces, derived by hand");
    for row in rows("normals_implicit.csv") {
        compare::<T>(&mut tally, &row, both_gradients(&row), both_gradients(&row));
    }
    tally.close(500, &[]);
}

fn both_gradients<T: Number>(row: &Row) -> [UnitVec3<T>; 2] {
    let p = vector(row.vector("{}"));
    let dual = normal::implicit(|p| surfaces::implicit(row, p), p);
    [dual, normal::from_gradient(gradient(row, p))].map(|n| n.expect("a normal"))
}

/// ∇f, up to a positive factor.
fn gradient<T: Number>(row: &Row, p: Vec3<T>) -> Vec3<T> {
    let number = |name| T::of(row.parameter(name));
    // ∂/∂x x²/a² = 2x/a²; the factor 2 is omitted
    let over = |x: T, name| x / (number(name) * number(name));
    let Vec3 { x, y, z } = p;
    match row.text("surface") {
        // ∇|p − c|² = 2(p − c)
        "sphere" => p - Vec3::from(["cx", "cy", "cz"]).map(number),
        "ellipsoid" => Vec3::new(over(x, "a"), over(y, "b"), over(z, "c")),
        "hyperboloid1" | "hyperboloid2" | "cone" => {
            Vec3::new(over(x, "a"), over(y, "b"), -over(z, "c"))
        }
        // the term −z is linear, so its derivative is −1, or −½ without the factor 2
        "paraboloid" => Vec3::new(over(x, "a"), over(y, "b"), T::of(-0.5)),
        "cylinder" => Vec3::new(x, y, T::ZERO),
        // with ρ = √(x² + y²): ∂f/∂x = 2(ρ − R) x/ρ, ∂f/∂z = 2z
        "torus" => {
            let rho = (x * x + y * y).sqrt();
            let ring = (rho - number("R")) / rho;
            Vec3::new(x * ring, y * ring, z)
        }
        // with S = |p|² + R² − r²: ∂f/∂x = 4x S − 8R² x, ∂f/∂z = 4z S; the factor 4 is omitted
        "torus_quartic" => {
            let [outer, inner] = [number("R"), number("r")].map(|x| x * x);
            let s = p.dot(p) + outer - inner;
            Vec3::new(
                x * s - (outer + outer) * x,
                y * s - (outer + outer) * y,
                z * s,
            )
        }
        // ∂f/∂x = a(cos ax cos ay − sin az sin ax), and the others by rotation; a > 0 is omitted
        "gyroid" => {
            let p = p * number("a");
            let (sin, cos) = (p.map(T::sin), p.map(T::cos));
            Vec3::new(
                cos.x * cos.y - sin.z * sin.x,
                cos.y * cos.z - sin.x * sin.y,
                cos.z * cos.x - sin.y * sin.z,
            )
        }
        other => panic!("unknown implicit surface {other}"),
    }
}

fn tangents_by_hand<T: Float>() {
    const POLYNOMIAL: &str = "a patch, whose derivative is another patch";
    let mut tally = Tally::new::<T>("parametric surfaces, derived by hand");
    for row in rows("normals_parametric.csv") {
        match row.text("surface") {
            "bezier33" | "rational_sphere" => tally.leave_out(POLYNOMIAL),
            _ => compare::<T>(
                &mut tally,
                &row,
                both_parametric(&row),
                both_parametric(&row),
            ),
        }
    }
    tally.close(336, &[(POLYNOMIAL, 114)]);
}

fn both_parametric<T: Number>(row: &Row) -> [UnitVec3<T>; 2] {
    let [u, v] = ["u", "v"].map(|name| T::of(row.number(name)));
    let dual = normal::parametric(|u, v| surfaces::parametric(row, None, u, v), u, v);
    let [s_u, s_v] = tangents(row, u, v);
    [dual, normal::from_tangents(s_u, s_v)].map(|n| n.expect("a normal"))
}

/// ∂s/∂u and ∂s/∂v.
fn tangents<T: Number>(row: &Row, u: T, v: T) -> [Vec3<T>; 2] {
    let number = |name| T::of(row.parameter(name));
    let (sin_u, cos_u, sin_v, cos_v) = (u.sin(), u.cos(), v.sin(), v.cos());
    let ellipsoid = |a: T, b: T, c: T| {
        [
            Vec3::new(-a * sin_u * sin_v, b * cos_u * sin_v, T::ZERO),
            Vec3::new(a * cos_u * cos_v, b * sin_u * cos_v, -c * sin_v),
        ]
    };
    match row.text("surface") {
        "torus" => {
            let ring = number("R") + number("r") * cos_v;
            [
                Vec3::new(-ring * sin_u, ring * cos_u, T::ZERO),
                Vec3::new(-sin_v * cos_u, -sin_v * sin_u, cos_v) * number("r"),
            ]
        }
        // with w = R + v cos(u/2): ∂w/∂u = −½ v sin(u/2), ∂w/∂v = cos(u/2)
        "mobius" => {
            let half = T::of(0.5);
            let (sin, cos) = ((u * half).sin(), (u * half).cos());
            let (w, w_u) = (number("R") + v * cos, -half * v * sin);
            [
                Vec3::new(
                    w_u * cos_u - w * sin_u,
                    w_u * sin_u + w * cos_u,
                    half * v * cos,
                ),
                Vec3::new(cos * cos_u, cos * sin_u, sin),
            ]
        }
        "helicoid" => [
            Vec3::new(-v * sin_u, v * cos_u, number("c")),
            Vec3::new(cos_u, sin_u, T::ZERO),
        ],
        "sphere_uv" => ellipsoid(number("r"), number("r"), number("r")),
        "ellipsoid_uv" => ellipsoid(number("a"), number("b"), number("c")),
        // ∂/∂u (u − u³/3 + uv²) = 1 − u² + v², ∂/∂v = 2uv, and the same with u and v exchanged
        "enneper" => {
            let (two_u, two_v) = (u + u, v + v);
            [
                Vec3::new(T::ONE - u * u + v * v, two_u * v, two_u),
                Vec3::new(two_u * v, T::ONE - v * v + u * u, -two_v),
            ]
        }
        // cosh′ = sinh; the factor c outside cancels the 1/c inside
        "catenoid" => {
            let (c, half) = (number("c"), T::of(0.5));
            let (grows, falls) = ((v / c).exp(), (-v / c).exp());
            let (cosh, sinh) = (half * (grows + falls), half * (grows - falls));
            [
                Vec3::new(-c * cosh * sin_u, c * cosh * cos_u, T::ZERO),
                Vec3::new(sinh * cos_u, sinh * sin_u, T::ONE),
            ]
        }
        other => panic!("unknown parametric surface {other}"),
    }
}
