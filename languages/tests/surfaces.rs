//! A surface of the user's, and its normal, are in C what they are in Rust, on each path through its decisions.

use host::{answer, bytes, compiled};
use shading::{Real, UnitVec3, Vec3, normal};
use shading_languages::dialect::C;
use shading_languages::{implicit, parametric};
use surface::{figure, pencil, rounded_box, wave};

mod host;
mod surface;

/// The numbers of a point or a direction; 0 where there is none.
fn numbers(of: Option<UnitVec3<f32>>) -> [f32; 3] {
    of.map_or([0.0; 3], |n| <[f32; 3]>::from(*n))
}

/// Multiples of 1/4, of which many are equal, and numbers between.
fn coordinates() -> Vec<f32> {
    let quarters = (-6_i8..=6).map(|i| f32::from(i) * 0.25);
    quarters.chain([-0.9, 0.1, 0.3, 0.77, 1.9]).collect()
}

/// Asserts that a program in C gives what Rust does for each row of arguments, but for the roundoff of its library.
fn agree(
    name: &str,
    roundoff: f32,
    function: &str,
    call: &str,
    width: usize,
    rows: &[(Vec<f32>, Vec<f32>)],
) {
    let results = rows[0].1.len();
    let text = format!(
        "#include <stdio.h>
#include \"shading.h\"
{function}
int main(void) {{
    float x[{width}];
    while (fread(x, sizeof x, 1, stdin) == 1) {{
        {call}
        fwrite(y, sizeof y, 1, stdout);
    }}
    return 0;
}}
"
    );
    let command = ["gcc", "-std=c99", "-O2", "-Wall", "-Wno-unused-function"];
    let program = compiled(&command, &text, name).unwrap();
    let arguments: Vec<_> = rows.iter().flat_map(|row| row.0.clone()).collect();
    let found = answer(&program, "", &bytes(&arguments)).expect("an answer");
    assert_eq!(found.len(), rows.len() * results * 4);
    for ((x, right), found) in rows.iter().zip(found.chunks(results * 4)) {
        let found = found.chunks_exact(4);
        let found: Vec<_> = found
            .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
            .collect();
        let is_same = |(a, b): (&f32, &f32)| {
            (a - b).abs() <= roundoff * a.abs().max(1.0) || a.is_nan() && b.is_nan()
        };
        assert!(
            right.iter().zip(&found).all(is_same),
            "{name}{x:?}: the crate {right:?}, the text {found:?}"
        );
    }
}

macro_rules! implicit_agrees {
    ($f:ident within $roundoff:expr) => {
        let name = stringify!($f);
        let mut rows = vec![];
        for x in coordinates() {
            for y in coordinates() {
                for z in coordinates() {
                    let p = Vec3::new(x, y, z);
                    let n = numbers(normal::implicit($f, p));
                    rows.push((vec![x, y, z], [&[$f(p)], &n[..]].concat()));
                }
            }
        }
        let call = format!(
            "shading_vec3 p = {{x[0], x[1], x[2]}}, n = {name}_normal(p);
        float y[4] = {{{name}(p), n.x, n.y, n.z}};"
        );
        agree(
            name,
            $roundoff,
            &implicit(&C, name, $f, $f),
            &call,
            3,
            &rows,
        );
    };
}

macro_rules! parametric_agrees {
    ($s:ident within $roundoff:expr) => {
        let name = stringify!($s);
        let mut rows = vec![];
        for u in coordinates() {
            for v in coordinates() {
                let n = numbers(normal::parametric($s, u, v));
                rows.push((vec![u, v], [<[f32; 3]>::from($s(u, v)), n].concat()));
            }
        }
        let call = format!(
            "shading_vec3 s = {name}(x[0], x[1]), n = {name}_normal(x[0], x[1]);
        float y[6] = {{s.x, s.y, s.z, n.x, n.y, n.z}};"
        );
        agree(
            name,
            $roundoff,
            &parametric(&C, name, $s, $s),
            &call,
            2,
            &rows,
        );
    };
}

#[test]
fn a_surface_is_what_it_is_in_rust_on_each_path() {
    // figure has no function of the library of C, so its numbers are the crate's, but for the sign of 0
    implicit_agrees!(figure within 0.0);
    implicit_agrees!(rounded_box within 1e-6);
    parametric_agrees!(wave within 1e-6);
    parametric_agrees!(pencil within 1e-6);
}

#[test]
#[should_panic(expected = "a formula takes more than 64 decisions")]
fn a_loop_until_a_number_is_small_is_refused() {
    fn halved<T: Real + PartialOrd>(p: Vec3<T>) -> T {
        let mut x = p.x;
        while x > T::ONE {
            x = x / T::of(2.0);
        }
        x
    }
    let _ = implicit(&C, "halved", halved, halved);
}
