//! Normals of planes, triangles, and implicit and parametric surfaces against 60-digit arithmetic
//! (`tests/data/README.md`).

use std::collections::BTreeMap;

use shading::{UnitVec3, normal};
use support::number::{Number, for_f32_and_f64, vector};

use crate::surfaces;
use crate::table::{Row, Tally, rows};
use support::running::{Bounded, Float};

for_f32_and_f64!(planes, triangles, implicit_surfaces, parametric_surfaces);

/// Why `f32` leaves out a row that `f64` compares.
const OUT_OF_RANGE: &str = "beyond the range of f32";
const TOO_THIN: &str = "too thin for f32: rounding the vertices may reverse its normal";

fn components<T: Float>(n: UnitVec3<T>) -> [f64; 3] {
    n.map(T::to_f64).into()
}

fn errors<T: Number + Bounded>(n: UnitVec3<T>) -> [f64; 3] {
    n.map(Bounded::error).into()
}

fn in_range<T: Float>(numbers: impl IntoIterator<Item = f64>) -> bool {
    numbers.into_iter().all(T::in_range)
}

/// The number of rows compared, and the rows that are left out in `f32` only.
fn account<T: Float>(
    rows: usize,
    left_out: &[(&'static str, usize)],
) -> (usize, Vec<(&'static str, usize)>) {
    let left_out = if T::NAME == "f32" {
        left_out.to_vec()
    } else {
        Vec::new()
    };
    (
        rows - left_out.iter().map(|(_, count)| count).sum::<usize>(),
        left_out,
    )
}

fn planes<T: Float>() {
    let plane = |row: &Row| [row.number("a"), row.number("b"), row.number("c")];
    let mut tally = Tally::new::<T>("normals_plane.csv");
    for row in rows("normals_plane.csv") {
        if !in_range::<T>(plane(&row)) {
            tally.leave_out(OUT_OF_RANGE);
            continue;
        }
        let [a, b, c] = plane(&row).map(T::of);
        let n = normal::plane(a, b, c).expect("a normal");
        let [a, b, c] = plane(&row).map(<T::Running as shading::Real>::of);
        let tolerance = errors(normal::plane(a, b, c).expect("a normal"));
        tally.compare(row.text("id"), components(n), row.vector("n{}"), tolerance);
    }
    let (compared, left_out) = account::<T>(120, &[(OUT_OF_RANGE, 18)]);
    tally.close(compared, &left_out);
}

/// The error of a triangle with representable vertices, in units u.
///
/// Each component of an edge is rounded once, by a relative u. A component of the cross product is
/// the difference of two products: it is off by 3u of the sum of their magnitudes, which as a
/// vector is at most √2 |e₁||e₂| long, and by u of itself. Divided by |e₁×e₂|, that is 3√2 times
/// the conditioning, plus 1. Normalizing adds 3.5: three squares and two sums under the root, the
/// root, and the division.
fn triangle_units(conditioning: f64) -> f64 {
    3.0 * 2.0_f64.sqrt() * conditioning + 4.5
}

fn triangles<T: Float>() {
    let vertices = |row: &Row| ["a{}", "b{}", "c{}"].map(|vertex| row.vector(vertex));
    let mut tally = Tally::new::<T>("normals_triangle.csv");
    let mut classes = BTreeMap::<String, f64>::new();
    for row in rows("normals_triangle.csv") {
        if !in_range::<T>(vertices(&row).into_iter().flatten()) {
            tally.leave_out(OUT_OF_RANGE);
            continue;
        }
        let [a, b, c] = vertices(&row).map(vector::<T>);
        let n = normal::triangle(a, b, c);
        if row.text("class").starts_with("degenerate") {
            assert_eq!(n, None, "{}", row.text("id"));
            tally.checked();
            continue;
        }
        let units = triangle_units(row.number("cond"));
        let tolerance = if row.text("prec") == T::NAME || T::NAME == "f64" {
            [T::U * units; 3]
        } else {
            let [a, b, c] = vertices(&row).map(vector::<T::Running>);
            errors(normal::triangle(a, b, c).expect("a normal"))
        };
        if tolerance.iter().any(|&t| t >= 1.0) {
            tally.leave_out(TOO_THIN);
            continue;
        }
        let n = components(n.expect("a normal"));
        tally.compare(row.text("id"), n, row.vector("n{}"), tolerance);
        let error = (0..3)
            .map(|i| (n[i] - row.vector("n{}")[i]).abs())
            .fold(0.0, f64::max);
        let class = classes.entry(row.text("class").to_owned()).or_default();
        *class = class.max(error / (T::U * row.number("cond")));
    }
    println!("  largest error in units of u times the conditioning, by class: {classes:.2?}");
    let (compared, left_out) = account::<T>(350, &[(OUT_OF_RANGE, 27), (TOO_THIN, 28)]);
    tally.close(compared, &left_out);
}

fn implicit_surfaces<T: Float>() {
    let mut tally = Tally::new::<T>("normals_implicit.csv");
    for row in rows("normals_implicit.csv") {
        let n = implicit::<T>(&row);
        let tolerance = errors(implicit::<T::Running>(&row));
        let surface = format!("{} {}", row.text("surface"), row.text("id"));
        tally.compare(surface, components(n), row.vector("n{}"), tolerance);
    }
    tally.close(500, &[]);
}

fn implicit<T: Number>(row: &Row) -> UnitVec3<T> {
    let p = vector(row.vector("{}"));
    normal::implicit(|p| surfaces::implicit(row, p), p).expect("a normal")
}

fn parametric_surfaces<T: Float>() {
    let patches = rows("normals_bezier_controlpoints.csv");
    let mut tally = Tally::new::<T>("normals_parametric.csv");
    for row in rows("normals_parametric.csv") {
        let control = patches
            .iter()
            .find(|patch| patch.text("id") == row.text("id"));
        let n = parametric::<T>(&row, control);
        let tolerance = errors(parametric::<T::Running>(&row, control));
        let surface = format!("{} {}", row.text("surface"), row.text("id"));
        tally.compare(surface, components(n), row.vector("n{}"), tolerance);
    }
    tally.close(450, &[]);
}

fn parametric<T: Number>(row: &Row, control: Option<&Row>) -> UnitVec3<T> {
    let [u, v] = ["u", "v"].map(|name| T::of(row.number(name)));
    let s = |u, v| surfaces::parametric(row, control, u, v);
    normal::parametric(s, u, v).expect("a normal")
}
