//! The right color, by `shading` in `f64`.

use shading::f64::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Material, PointLight, Rgb, SpotLight,
    UnitVec3, Vec3,
};
use shading::{half_vector, reflection, shade, term};

use crate::profile::Profile;
use crate::scene::{Light, Model, Scene, Triple};

/// The color of a scene, by the formulas or as the renderer departs from them on purpose.
pub fn color(scene: &Scene, profile: &Profile) -> Triple {
    let p = Vec3::from(scene.p);
    let [n, v] = [scene.n, scene.v].map(unit);
    let n = if profile.normal_faces_eye && n.dot(v) < 0.0 {
        -n
    } else {
        n
    };
    let [k_a, k_d, k_s] = [scene.material.k_a, scene.material.k_d, scene.material.k_s].map(rgb);
    let m = scene.material.m;
    let k_a = if profile.ambient_times_diffuse {
        k_a * k_d
    } else {
        k_a
    };
    let (material, i_a) = (Material { k_a, k_d, k_s, m }, rgb(scene.i_a));
    let is_dark = scene.lights.is_empty();
    if profile.black_without_lights && is_dark {
        return [0.0; 3];
    }
    let one = |model, i_a, light: Option<IncidentLight>| match model {
        Model::Lambert => shade::lambert(n, &material, i_a, light),
        Model::Phong => shade::phong(n, v, &material, i_a, light),
        Model::BlinnPhong => shade::blinn_phong(n, v, &material, i_a, light),
    };

    let mut sum = if profile.attenuated_ambient {
        Rgb::BLACK
    } else {
        one(scene.model, i_a, None).ambient
    };
    if profile.unlit_without_lights && is_dark {
        sum += k_d;
    }
    for light in &scene.lights {
        let arriving = arriving(light, p, true, profile);
        sum += one(Model::Lambert, Rgb::BLACK, Some(arriving)).diffuse;
        let bright = self::arriving(light, p, !profile.unattenuated_highlight, profile);
        sum += match scene.model {
            Model::Phong if profile.highlight_on_the_dark_side => {
                k_s * bright.intensity * term::phong(reflection(n, bright.l), v, m)
            }
            Model::BlinnPhong if profile.highlight_on_the_dark_side => {
                k_s * bright.intensity
                    * half_vector(bright.l, v).map_or(0.0, |h| term::blinn(n, h, m))
            }
            model => one(model, Rgb::BLACK, Some(bright)).specular,
        };
        if profile.attenuated_ambient {
            sum += k_a * i_a * falloff(light, p);
        }
    }
    <[f64; 3]>::from(sum)
}

fn rgb(c: Triple) -> Rgb {
    Rgb::from(c)
}

/// No scene has a vector without a direction.
fn unit(v: Triple) -> UnitVec3 {
    Vec3::from(v).unit().unwrap_or(UnitVec3::Z)
}

/// A light where it arrives, attenuated or not.
fn arriving(light: &Light, p: Vec3, attenuated: bool, profile: &Profile) -> IncidentLight {
    let point = |position: Triple, intensity, attenuation| PointLight {
        position: Vec3::from(position),
        intensity: rgb(intensity),
        attenuation: if attenuated {
            coefficients(attenuation)
        } else {
            Attenuation::NONE
        },
    };
    match *light {
        Light::Directional { l, intensity } => DirectionalLight {
            l: unit(l),
            intensity: rgb(intensity),
        }
        .at(p),
        Light::Point {
            position,
            intensity,
            attenuation,
        } => point(position, intensity, attenuation).at(p),
        Light::Spot {
            position,
            intensity,
            attenuation,
            axis,
            half_angle,
        } => {
            let cone = Cone::from_half_angle(half_angle).expect("an angle up to π/2");
            let point = point(position, intensity, attenuation);
            let axis = unit(axis);
            let mut arriving = SpotLight { point, axis, cone }.at(p);
            if profile.spot_exponent > 0.0 {
                let cosine = -axis.dot(arriving.l);
                arriving.intensity *= cosine.max(0.0).powf(profile.spot_exponent);
            }
            arriving
        }
    }
}

fn coefficients([a, b, c]: Triple) -> Attenuation {
    Attenuation::new(a, b, c).expect("coefficients that are not negative")
}

/// What the attenuation leaves of a light.
pub fn falloff(light: &Light, p: Vec3) -> f64 {
    light.lamp().map_or(1.0, |(position, attenuation)| {
        coefficients(attenuation).at((Vec3::from(position) - p).length())
    })
}
