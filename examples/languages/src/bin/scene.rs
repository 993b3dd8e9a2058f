//! Writes a scene and its colors as the crate computes them, for the programs in other languages to
//! compare their bits with: `scene FOLDER` writes `points`, `normals`, `colors` and `bytes`.

use std::{env, fs, io, path::Path, process::ExitCode};

use shading::f32::{
    Attenuation, DirectionalLight, Material, PointLight, Ranged, Rgb, SoftCone, SpotLight,
    UnitVec3, Vec3,
};
use shading::{Light, shade};

/// A unit sphere in front of a wall, looked at along z: one point for each pixel of a square.
const SIDE: u16 = 256;

fn place(column: u16, row: u16) -> (Vec3, Vec3) {
    let coordinate = |index: u16| (f32::from(index) + 0.5) / 128.0 - 1.0;
    let (x, y) = (1.25 * coordinate(column), -1.25 * coordinate(row));
    let square = x * x + y * y;
    if square < 1.0 {
        let p = Vec3::new(x, y, (1.0 - square).sqrt());
        (p, p * 2.0) // normals need not have length 1
    } else {
        (Vec3::new(x, y, -1.0), Vec3::new(0.0, 0.0, 0.5))
    }
}

/// The lights that each program declares.
fn lights() -> Option<[Light<f32, SoftCone, Ranged>; 4]> {
    let lamp = |position: [f32; 3], intensity: [f32; 3], [a, b, c]: [f32; 3], range| {
        Some(PointLight {
            position: position.into(),
            intensity: intensity.into(),
            attenuation: Attenuation::new(a, b, c)?.within(range)?,
        })
    };
    let sun = DirectionalLight {
        l: Vec3::new(-1.0, 2.0, 2.0).unit()?,
        intensity: Rgb::new(0.25, 0.25, 0.375),
    };
    let near = lamp(
        [2.0, 1.0, 2.0],
        [1.0, 0.75, 0.5],
        [1.0, 0.0, 0.25],
        f32::INFINITY,
    )?;
    let mut far = lamp([-4.0, -2.0, 4.0], [2.0, 4.0, 8.0], [0.0, 0.0, 1.0], 8.0)?;
    far.attenuation = far.attenuation.unsquared();
    let spot = SpotLight {
        point: lamp([0.0, 3.0, 3.0], [3.0, 1.0, 1.0], [1.0, 0.5, 0.0], 8.0)?,
        axis: Vec3::new(0.0, -1.0, -1.0).unit()?,
        cone: SoftCone::from_half_angles(0.25, 0.375)?,
    };
    Some([sun.into(), near.into(), far.into(), spot.into()])
}

fn write(folder: &Path) -> io::Result<()> {
    let lights = lights().expect("valid lights");
    let eye = Vec3::new(0.0, 0.0, 5.0);
    let (k_a, k_d, k_s) = (Rgb::gray(0.125), Rgb::new(0.5, 0.375, 0.25), Rgb::gray(0.5));
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: 32,
    };

    let pixels = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| place(column, row)));
    let (points, normals): (Vec<_>, Vec<_>) = pixels.unzip();
    let color = |(p, n): (&Vec3, &Vec3)| {
        let (n, v): (UnitVec3, UnitVec3) = n.unit().zip((eye - *p).unit())?;
        let arriving = lights.iter().map(|light| light.at(*p));
        Some(shade::blinn_phong(n, v, &material, Rgb::gray(0.5), arriving).total())
    };
    let colors = points
        .iter()
        .zip(&normals)
        .map(|place| color(place).unwrap_or(Rgb::BLACK));
    let colors: Vec<Rgb> = colors.collect();

    fs::create_dir_all(folder)?;
    let floats = |name, triples: Vec<[f32; 3]>| {
        let bytes = triples.into_iter().flatten().flat_map(f32::to_le_bytes);
        fs::write(folder.join(name), bytes.collect::<Vec<u8>>())
    };
    floats("points", points.into_iter().map(<[f32; 3]>::from).collect())?;
    floats(
        "normals",
        normals.into_iter().map(<[f32; 3]>::from).collect(),
    )?;
    floats(
        "colors",
        colors.iter().copied().map(<[f32; 3]>::from).collect(),
    )?;
    let bytes = colors.iter().flat_map(|color| color.to_srgb8());
    fs::write(folder.join("bytes"), bytes.collect::<Vec<u8>>())
}

fn main() -> ExitCode {
    let Some(folder) = env::args_os().nth(1) else {
        eprintln!("usage: scene FOLDER");
        return ExitCode::from(2);
    };
    match write(Path::new(&folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("scene: {}: {error}", Path::new(&folder).display());
            ExitCode::FAILURE
        }
    }
}
