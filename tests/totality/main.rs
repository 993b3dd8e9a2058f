//! What every function returns where its formula has no answer. A test here or in `conventions.rs`
//! covers each cell of the table in `docs/totality.md`.

mod attenuation;
mod dual;
mod lights;
mod normals;
mod sum;
mod terms;
mod vectors;

use shading::{Material, PointLight, Real, Rgb, Vec3};
use support::number::Float;

fn at_x<T: Real>(x: T) -> Vec3<T> {
    Vec3::new(x, T::ZERO, T::ZERO)
}

/// The values that are not finite numbers.
fn not_finite<T: Float>() -> [T; 3] {
    [T::INFINITY, -T::INFINITY, T::NAN]
}

fn mirror<T: Real, M>(m: M) -> Material<T, M> {
    Material {
        k_a: Rgb::WHITE,
        k_d: Rgb::WHITE,
        k_s: Rgb::WHITE,
        m,
    }
}

fn lamp<T: Float>(position: Vec3<T>, coefficients: [f64; 3]) -> PointLight<T> {
    let attenuation = T::attenuation(coefficients).expect("coefficients");
    PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation,
    }
}

/// The table in the documentation cites only tests that exist.
#[test]
fn every_row_of_the_table_names_a_test() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |file: &str| std::fs::read_to_string(root.join(file)).expect(file);
    let tests = [
        "totality/attenuation.rs",
        "totality/dual.rs",
        "totality/lights.rs",
        "totality/normals.rs",
        "totality/sum.rs",
        "totality/terms.rs",
        "totality/vectors.rs",
        "conventions.rs",
        "extremes.rs",
        "shadows.rs",
        "lengths.rs",
        "lanes/main.rs",
    ]
    .map(|name| read(&format!("tests/{name}")));
    let table = read("docs/totality.md");
    let cited = table
        .lines()
        .filter(|line| line.ends_with(" |"))
        .filter_map(|row| {
            let cell = row.trim_end_matches(" |").rsplit("| ").next()?;
            cell.strip_prefix('`')?.split('`').next()
        });
    let cited: Vec<&str> = cited.collect();
    for name in &cited {
        let definitions = [format!("fn {name}<"), format!("fn {name}(")];
        let defines = |text: &String| {
            definitions
                .iter()
                .any(|definition| text.contains(definition))
        };
        let is_there = tests.iter().any(defines);
        assert!(is_there, "no test {name}");
    }
    assert_eq!(cited.len(), 92, "rows");
}
