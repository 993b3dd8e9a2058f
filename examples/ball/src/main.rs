//! The shortest way to a picture: `cargo run -p ball` writes `ball.bmp`. It is a package of its own,
//! because an example would be compiled with all that the tests need.

use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
use shading::shade;

const SIZE: u16 = 256;
const CLAY: Material = Material {
    k_a: Rgb::new(0.7, 0.2, 0.1),
    k_d: Rgb::new(0.7, 0.2, 0.1),
    k_s: Rgb::gray(0.4),
    m: 40,
};
const LAMP: PointLight = PointLight {
    position: Vec3::new(-2.0, 2.0, 3.0),
    intensity: Rgb::WHITE,
    attenuation: Attenuation::const_new(0.5, 0.0, 0.03).unwrap(),
};

/// The light that the unit sphere sends to a distant eye at (x, y).
fn pixel(x: f32, y: f32) -> Rgb {
    let p = Vec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt());
    match p.unit() {
        Some(n) if p.z > 0.0 => {
            shade::blinn_phong(n, UnitVec3::Z, &CLAY, Rgb::gray(0.1), [LAMP.at(p)]).total()
        }
        _ => Rgb::gray(0.01),
    }
}

fn main() -> std::io::Result<()> {
    let side = u32::from(SIZE);
    let header = [54 + 3 * side * side, 0, 54, 40, side, side, 1 | 24 << 16];
    let mut file = b"BM".to_vec();
    file.extend(header.into_iter().chain([0; 6]).flat_map(u32::to_le_bytes));
    let coordinate = |i: u16| (f32::from(i) + 0.5) / f32::from(SIZE) * 2.2 - 1.1;
    for (row, column) in (0..SIZE).flat_map(|row| (0..SIZE).map(move |column| (row, column))) {
        let [r, g, b] = pixel(coordinate(column), coordinate(row)).to_srgb8();
        file.extend([b, g, r]);
    }
    std::fs::write("ball.bmp", file)?;
    println!("drew {}", std::path::absolute("ball.bmp")?.display());
    Ok(())
}
