//! The crate's normals of the surfaces of the exercises, by automatic differentiation where there is something to
//! differentiate: each line of the input is a surface by its place in the list and its numbers. The page has
//! formulas by hand, and a test compares the two.

use std::io;

use shading::Dual;
use shading::f64::Vec3;
use shading::normal;

/// Of a plane, a sphere, a triangle, an ellipsoid or a torus, in this order; 0 if there is none.
fn normal(surface: usize, numbers: &[f64]) -> [f64; 3] {
    let unit = match (surface, numbers) {
        (0, &[a, b, c]) => normal::plane(a, b, c),
        (1, &[a, b, c, x, y, z]) => normal::sphere(Vec3::new(a, b, c), Vec3::new(x, y, z)),
        (2, &[a, b, c, d, e, f, g, h, i]) => {
            normal::triangle(Vec3::new(a, b, c), Vec3::new(d, e, f), Vec3::new(g, h, i))
        }
        (3, &[x, y, z, a, b, c]) => normal::implicit(
            |p| {
                let [x, y, z] = [
                    p.x / Dual::constant(a),
                    p.y / Dual::constant(b),
                    p.z / Dual::constant(c),
                ];
                x * x + y * y + z * z - Dual::constant(1.0)
            },
            Vec3::new(x, y, z),
        ),
        (4, &[u, v, large, small]) => normal::parametric(
            |u, v| {
                let to_axis = Dual::constant(large) + Dual::constant(small) * v.cos();
                shading::Vec3::new(
                    to_axis * u.cos(),
                    to_axis * u.sin(),
                    Dual::constant(small) * v.sin(),
                )
            },
            u,
            v,
        ),
        _ => None,
    };
    unit.map_or([0.0; 3], |n| Vec3::from(n).into())
}

fn main() -> io::Result<()> {
    for line in io::stdin().lines() {
        let line = line?;
        let numbers: Vec<f64> = line
            .split(' ')
            .map(|word| word.parse().expect("numbers"))
            .collect();
        let [surface, ref numbers @ ..] = numbers[..] else {
            panic!("a line: SURFACE NUMBER...");
        };
        let [x, y, z] = normal(surface as usize, numbers);
        println!("{x} {y} {z}");
    }
    Ok(())
}
