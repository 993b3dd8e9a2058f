//! A ball in the light of a scene, shaded by the crate, and shaded with a mistake.

use shading::f64::{
    Attenuation, Cone, DirectionalLight, IncidentLight, PointLight, Rgb, SpotLight, UnitVec3, Vec3,
};
use shading::{Material, shade};
use shading_laws::{Fault, Kind, Light, Model, Scene};

/// The scene of these numbers: the model, m, k_a, k_d, k_s and I_a, and five triples of each light.
pub fn scene(numbers: &[f64]) -> Option<Scene> {
    let (&[model, m], numbers) = numbers.split_first_chunk()?;
    let (colors, lights) = numbers.as_chunks::<3>().0.split_at_checked(4)?;
    let &[k_a, k_d, k_s, i_a] = colors else {
        return None;
    };
    let lights = lights.chunks_exact(5).map(light);
    Some(Scene {
        model: *Model::ALL.get(model as usize)?,
        p: [0.0; 3],
        n: [0.0; 3],
        v: [0.0; 3],
        k_a,
        k_d,
        k_s,
        m,
        i_a,
        lights: lights.collect::<Option<_>>()?,
    })
}

/// A light: its intensity, its direction or its position, its attenuation, its axis, and its kind and angle.
fn light(triples: &[[f64; 3]]) -> Option<Light> {
    let &[
        intensity,
        position,
        attenuation,
        axis,
        [kind, half_angle, _],
    ] = triples
    else {
        return None;
    };
    Some(match Kind::ALL.get(kind as usize)? {
        Kind::Directional => Light::Directional {
            intensity,
            l: position,
        },
        Kind::Point => Light::Point {
            intensity,
            position,
            attenuation,
        },
        Kind::Spot => Light::Spot {
            intensity,
            position,
            attenuation,
            axis,
            half_angle,
        },
    })
}

/// p, n, v, the right color and the color with the mistake of each pixel; all are 0 beside the ball.
pub fn ball(scene: &Scene, size: usize, fault: Option<Fault>) -> Vec<f64> {
    let pixels = (0..size * size).map(|i| pixel(scene, size, i, fault));
    pixels.flatten().flatten().collect()
}

fn pixel(scene: &Scene, size: usize, i: usize, fault: Option<Fault>) -> [[f64; 3]; 5] {
    let at = |i: usize| (i as f64 + 0.5) / size as f64 * 2.1 - 1.05;
    let (x, y) = (at(i % size), -at(i / size));
    let square = 1.0 - x * x - y * y;
    if square < 0.0 {
        return [[0.0; 3]; 5];
    }
    let p = [x, y, square.sqrt()];
    // as long as one that is interpolated between the corners of a coarse mesh
    let length = 0.6 + 0.4 * (6.0 * x).cos().abs().max((6.0 * y).cos().abs());
    let (n, v) = (p.map(|c| c * length), [-p[0], -p[1], 4.0 - p[2]]);
    let scene = Scene {
        p,
        n,
        v,
        ..scene.clone()
    };
    let wrong = fault.map_or([0.0; 3], |fault| fault.color(&scene));
    [p, n, v, right(&scene), wrong]
}

fn unit(v: [f64; 3]) -> UnitVec3 {
    Vec3::from(v).unit_or(UnitVec3::Z)
}

/// The color by the crate.
fn right(scene: &Scene) -> [f64; 3] {
    let (n, v) = (unit(scene.n), unit(scene.v));
    let [k_a, k_d, k_s, i_a] = [scene.k_a, scene.k_d, scene.k_s, scene.i_a].map(Rgb::from);
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: scene.m,
    };
    let lights = scene
        .lights
        .iter()
        .map(|light| arriving(light, scene.p.into()));
    let shaded = match scene.model {
        Model::Lambert => shade::lambert(n, &material, i_a, lights),
        Model::Phong => shade::phong(n, v, &material, i_a, lights),
        Model::BlinnPhong => shade::blinn_phong(n, v, &material, i_a, lights),
    };
    shaded.total().into()
}

fn arriving(light: &Light, p: Vec3) -> IncidentLight {
    match *light {
        Light::Directional { intensity, l } => DirectionalLight {
            l: unit(l),
            intensity: intensity.into(),
        }
        .at(p),
        Light::Point {
            intensity,
            position,
            attenuation,
        } => lamp(position, intensity, attenuation).at(p),
        Light::Spot {
            intensity,
            position,
            attenuation,
            axis,
            half_angle,
        } => {
            let point = lamp(position, intensity, attenuation);
            let axis = unit(axis);
            match Cone::from_half_angle(half_angle) {
                Some(cone) => SpotLight { point, axis, cone }.at(p),
                None => point.at(p),
            }
        }
    }
}

fn lamp(position: [f64; 3], intensity: [f64; 3], [a, b, c]: [f64; 3]) -> PointLight {
    PointLight {
        position: position.into(),
        intensity: intensity.into(),
        attenuation: Attenuation::new(a, b, c).unwrap_or_default(),
    }
}
