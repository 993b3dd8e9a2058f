//! A renderer written by hand in `f32`, with each known mistake to choose from.

use shading_laws::{Light, Mistake, Model, Profile, Renderer, Scene, from_fn};

type Vec3 = [f32; 3];

fn dot(a: Vec3, b: Vec3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn scale(a: Vec3, s: f32) -> Vec3 {
    a.map(|c| c * s)
}

fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn mul(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

fn normalize(a: Vec3) -> Vec3 {
    scale(a, 1.0 / dot(a, a).sqrt())
}

fn single(triple: [f64; 3]) -> Vec3 {
    triple.map(|c| c as f32)
}

fn srgb(x: f32) -> f32 {
    if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * x.powf(1.0 / 2.4) - 0.055
    }
}

/// The color that a shader with the mistakes gives.
#[allow(clippy::too_many_lines)] // it is the shader, as people write it
pub fn shade(scene: &Scene, profile: &Profile, mistakes: &[Mistake]) -> [f64; 3] {
    use Mistake::*;
    let is = |mistake| mistakes.contains(&mistake);
    let (p, mut n, mut v) = (single(scene.p), single(scene.n), single(scene.v));
    if !is(NormalNotNormalized) {
        n = normalize(n);
    }
    if !is(ViewNotNormalized) {
        v = normalize(v);
    }
    let material = &scene.material;
    let (k_a, k_d, mut k_s) = (
        single(material.k_a),
        single(material.k_d),
        single(material.k_s),
    );
    if is(HighlightTimesDiffuse) {
        k_s = mul(k_s, k_d);
    }
    let i_a = single(scene.i_a);
    let ambient = mul(if is(AmbientByDiffuse) { k_d } else { k_a }, i_a);

    let mut color = if is(AmbientPerLight) || is(AmbientAttenuated) || is(AmbientForgotten) {
        [0.0; 3]
    } else {
        ambient
    };
    let base = color;
    for (i, light) in scene.lights.iter().enumerate() {
        if is(FirstLightOnly) && i > 0 {
            break;
        }
        let mut intensity = single(light.intensity());
        if is(LightInGray) {
            intensity = [(intensity[0] + intensity[1] + intensity[2]) / 3.0; 3];
        }
        let mut way = match light {
            Light::Directional { l, .. } => single(*l),
            Light::Point { position, .. } | Light::Spot { position, .. } => {
                add(single(*position), scale(p, -1.0))
            }
        };
        if is(LightReversed) {
            way = scale(way, -1.0);
        }
        let is_sun = matches!(light, Light::Directional { .. });
        let l = if is_sun || is(LightNotNormalized) {
            way
        } else {
            normalize(way)
        };
        let mut attenuation = match light {
            Light::Directional { .. } => 1.0,
            Light::Point { attenuation, .. } | Light::Spot { attenuation, .. } => {
                let [mut a, b, mut c] = single(*attenuation);
                if is(CoefficientsReversed) {
                    (a, c) = (c, a);
                }
                let mut q = dot(way, way).sqrt();
                if is(SquaredDistance) {
                    q = dot(way, way);
                }
                1.0 / (a + b * q + c * q * q)
            }
        };
        if is(NotAttenuated) {
            attenuation = 1.0;
        }
        if let Light::Spot {
            axis, half_angle, ..
        } = light
        {
            let mut toward = -dot(single(*axis), l);
            if is(ConeReversed) {
                toward = -toward;
            }
            let edge = match () {
                () if is(DegreesForRadians) => half_angle.to_radians(),
                () if is(HalfAngleHalved) => half_angle / 2.0,
                () if is(WholeAngleForHalf) => 2.0 * half_angle,
                () => *half_angle,
            } as f32;
            if toward < edge.cos() && !is(ConeForgotten) {
                intensity = [0.0; 3];
                if is(HighlightWithoutLight) {
                    continue;
                }
            }
        }

        let n_dot_l = dot(n, l);
        let mut lambert = n_dot_l.max(0.0);
        match () {
            () if is(DiffuseNotClamped) => lambert = n_dot_l,
            () if is(DiffuseTwoSided) => lambert = n_dot_l.abs(),
            () if is(DiffuseOverPi) => lambert /= std::f32::consts::PI,
            () => {}
        }
        let mut lit = scale(mul(k_d, intensity), lambert * attenuation);
        let has_highlight =
            scene.model != Model::Lambert && (n_dot_l > 0.0 || is(HighlightNotGated));
        if has_highlight {
            let is_phong = (scene.model == Model::Phong) != is(OtherModel);
            let cosine = if is_phong {
                let mut r = add(scale(n, 2.0 * n_dot_l), scale(l, -1.0));
                if is(ReflectionReversed) {
                    r = scale(r, -1.0);
                }
                dot(r, v)
            } else {
                let mut h = add(l, v);
                if is(HalfVectorHalved) {
                    h = scale(h, 0.5);
                } else if !is(HalfVectorNotNormalized) {
                    h = normalize(h);
                }
                dot(n, h)
            };
            let cosine = if is(PowerNotClamped) {
                cosine
            } else {
                cosine.max(0.0)
            };
            let mut factor = cosine.powf(material.m as f32);
            factor *= match () {
                () if is(HighlightNotAttenuated) => 1.0,
                () if is(HighlightAttenuatedTwice) => attenuation * attenuation,
                () if is(HighlightTimesCosine) => attenuation * n_dot_l,
                () => attenuation,
            };
            let of_light = if is(HighlightWithoutLight) {
                [1.0; 3]
            } else {
                intensity
            };
            lit = add(lit, scale(mul(k_s, of_light), factor));
        }
        if is(EachLightClamped) {
            lit = lit.map(|c| c.clamp(0.0, 1.0));
        }
        if is(LastLightOnly) {
            color = base;
        }
        color = add(color, lit);
        if is(AmbientPerLight) {
            color = add(color, ambient);
        }
        if is(AmbientAttenuated) {
            color = add(color, scale(ambient, attenuation));
        }
    }
    if is(ChannelsSwapped) {
        color.reverse();
    }
    let is_clamped = profile.clamps.is_some() || profile.bits.is_some();
    if is_clamped && !is(EachLightClamped) {
        color = color.map(|c| c.clamp(0.0, 1.0));
    }
    if is(SrgbUnasked) || profile.srgb && !is(SrgbForgotten) {
        color = color.map(if is(Gamma22ForSrgb) {
            |x: f32| x.powf(1.0 / 2.2)
        } else {
            srgb
        });
        if is(SrgbTwice) {
            color = color.map(srgb);
        }
    }
    if let Some(bits) = profile.bits {
        let most = f64::from(bits).exp2() - 1.0;
        let level = if is(LevelsTruncated) {
            f64::floor
        } else {
            f64::round
        };
        return color.map(|c| level(f64::from(c) * most) / most);
    }
    color.map(f64::from)
}

pub fn renderer(profile: &Profile, mistakes: &[Mistake]) -> impl Renderer + use<> {
    let (of, mistakes) = (profile.clone(), mistakes.to_vec());
    from_fn(profile.clone(), move |scene| shade(scene, &of, &mistakes))
}
