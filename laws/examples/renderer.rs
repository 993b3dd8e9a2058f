//! A renderer to copy from: Lambert, Phong and Blinn–Phong in `f32`, checked by
//!
//! ```sh
//! rustc -O --edition 2021 renderer.rs
//! shading-laws ./renderer
//! ```
//!
//! It reads scenes without a JSON parser: their members always come in the same order, so the numbers do too.

use std::io::{self, Write};

type Vector = [f32; 3];

fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn mul(a: Vector, b: Vector) -> Vector {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

fn scale(a: Vector, s: f32) -> Vector {
    a.map(|x| x * s)
}

fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a` at length 1, or 0 if it has no direction, as L + V where L = −V.
fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    if length > 0.0 {
        scale(a, 1.0 / length)
    } else {
        a
    }
}

/// The numbers in a piece of JSON.
fn numbers(json: &str) -> impl Iterator<Item = f32> + '_ {
    json.split(|c| "[]{},:\"".contains(c))
        .filter_map(|word| word.parse().ok())
}

/// The next three numbers.
fn triple(numbers: &mut impl Iterator<Item = f32>) -> Vector {
    [(); 3].map(|()| numbers.next().expect("a number"))
}

/// The direction to a light, and the intensity that arrives at `p`.
fn arriving(light: &str, p: Vector) -> (Vector, Vector) {
    let numbers = &mut numbers(light);
    let intensity = triple(numbers);
    if light.starts_with("directional") {
        return (triple(numbers), intensity);
    }
    let to_light = sub(triple(numbers), p);
    let [a, b, c] = triple(numbers);
    let q = dot(to_light, to_light).sqrt();
    let l = scale(to_light, 1.0 / q);
    if light.starts_with("spot") {
        let axis = triple(numbers);
        let angle = numbers.next().expect("the angle");
        if -dot(l, axis) < angle.cos() {
            return (l, [0.0; 3]); // outside the cone, to which the edge belongs
        }
    }
    (l, scale(intensity, 1.0 / (a + b * q + c * q * q)))
}

fn highlight(model: &str, n: Vector, l: Vector, v: Vector, m: f32) -> f32 {
    match model {
        "phong" => {
            let r = sub(scale(n, 2.0 * dot(n, l)), l);
            dot(r, v).max(0.0).powf(m)
        }
        "blinn_phong" => dot(n, unit(add(l, v))).max(0.0).powf(m),
        _ => 0.0, // Lambert
    }
}

fn shade(scene: &str) -> Vector {
    let mut parts = scene.split("{\"kind\":\"");
    let head = parts.next().expect("what stands before the lights");
    let model = head.split('"').nth(3).expect("the model");
    let numbers = &mut numbers(head);
    let p = triple(numbers);
    let [n, v] = [(); 2].map(|()| unit(triple(numbers)));
    let [k_a, k_d, k_s] = [(); 3].map(|()| triple(numbers));
    let m = numbers.next().expect("the shininess");
    let mut color = mul(k_a, triple(numbers));
    for light in parts {
        let (l, intensity) = arriving(light, p);
        let n_dot_l = dot(n, l);
        if n_dot_l > 0.0 {
            let specular = scale(k_s, highlight(model, n, l, v, m));
            color = add(color, mul(intensity, add(scale(k_d, n_dot_l), specular)));
        }
    }
    color
}

fn main() -> io::Result<()> {
    let mut lines = io::stdin().lines();
    lines.next(); // the version of the format
    let mut out = io::BufWriter::new(io::stdout());
    writeln!(
        out,
        "{{\"name\":\"renderer.rs\",\"roundoff\":{:e}}}",
        f32::EPSILON / 2.0
    )?;
    out.flush()?;
    for line in lines {
        let line = line?;
        if line.is_empty() {
            out.flush()?; // the end of a batch
        } else {
            writeln!(out, "{:?}", shade(&line))?;
        }
    }
    Ok(())
}
