//! The color in linear light.

use shading_laws::{Light, Mistake, Model, Profile, Scene};

use super::float::{Float, Vec3, add, bits, dot, mul, normalize, of, scale, sub};
use super::plan::{Odd, Plan};
use super::reply::{encoded, from_srgb, srgb};

/// The color that a shader with the mistakes gives.
#[allow(clippy::too_many_lines, clippy::cognitive_complexity)] // it is the shader, as people write it
pub fn shade<T: Float>(scene: &Scene, profile: &Profile, plan: &Plan) -> [f64; 3] {
    use Mistake::*;
    let is = |mistake| plan.faults.iter().any(|fault| fault.mistake == mistake);
    let value = |mistake| {
        let fault = plan.faults.iter().find(|fault| fault.mistake == mistake);
        fault.map(|fault| fault.value)
    };
    let odd = plan.odd;
    let (zero, one, pi) = (T::of(0.0), T::of(1.0), T::of(std::f64::consts::PI));

    let stored = |c: [f64; 3], so: [Mistake; 4]| {
        let [in_steps, cut, in_half, in_bfloat] = so;
        c.map(|c| match (value(in_steps), value(cut)) {
            (Some(steps), _) => (c * steps).round() / steps,
            (_, Some(steps)) => (c * steps).floor() / steps,
            _ if is(in_half) => bits(c, 11.0),
            _ if is(in_bfloat) => bits(c, 8.0),
            _ => c,
        })
    };
    let color = |c| stored(c, [ColorsInSteps, ColorsCut, ColorsInHalf, ColorsInBfloat]);
    let reflectance = |k: [f64; 3]| {
        let so = [
            ReflectancesInSteps,
            ReflectancesCut,
            ReflectancesInHalf,
            ReflectancesInBfloat,
        ];
        let k: Vec3<T> = of(stored(color(k), so));
        if is(MaterialDecoded) {
            of(k.map(|c| from_srgb(c.get())))
        } else if is(MaterialGamma22) {
            k.map(|c| c.powf(T::of(2.2)))
        } else {
            k
        }
    };
    let unit = |a: Vec3<T>| {
        let square = dot(a, a);
        if let Some(steps) = value(FastInverseRoot).or(value(FastInverseRootBesideLamps)) {
            let mut y = square.guess_of_inverse_root();
            for _ in 0..steps as u32 {
                y = y * (T::of(1.5) - T::of(0.5) * square * y * y);
            }
            return scale(a, y);
        }
        match (value(LengthPlus), value(LengthAtLeast)) {
            (Some(more), _) => scale(a, one / (square.sqrt() + T::of(more))),
            (_, Some(least)) => scale(a, one / square.sqrt().max(T::of(least))),
            _ => normalize(a),
        }
    };
    let place = |p: [f64; 3]| {
        of::<T>(if is(PositionsInHalf) {
            p.map(|c| bits(c, 11.0))
        } else {
            p
        })
    };
    let (p, mut n, mut v) = (place(scene.p), of::<T>(scene.n), of::<T>(scene.v));
    let mut long_n = n;
    if is(EyeAtOrigin) {
        v = scale(p, -one);
    }
    if is(ViewTakenForEye) {
        v = sub(v, p);
    }
    if is(ViewAlongZ) {
        v = [zero, zero, one];
    }
    if !is(NormalNotNormalized) {
        n = unit(n);
    }
    if let Some(steps) = value(NormalInSteps).or(value(NormalInStepsUnit)) {
        n = n.map(|c| T::of((c.get() * steps).round() / steps));
    }
    if is(NormalInStepsUnit) {
        n = normalize(n);
    }
    let keeps_length = match scene.model {
        Model::Lambert => false,
        Model::Phong => is(ViewNotNormalizedOfPhong),
        Model::BlinnPhong => is(ViewNotNormalizedOfBlinn),
    };
    if !is(ViewNotNormalized) && !keeps_length {
        v = unit(v);
    }
    if is(ViewReversed) {
        v = scale(v, -one);
    }
    if is(NormalReversed) {
        n = scale(n, -one);
    }
    if (is(NormalTowardEye) || profile.normal_faces_eye) && dot(n, v) < zero {
        n = scale(n, -one);
        long_n = scale(long_n, -one);
    }
    match odd {
        Some(Odd::Normals(of)) => n = n.map(|c| T::of(bits(c.get(), of))),
        Some(Odd::Tilt(by)) => n = normalize(add(n, [T::of(by), zero, zero])),
        _ => {}
    }
    let material = &scene.material;
    let so = [DiffuseInSteps, DiffuseCut, DiffuseInHalf, DiffuseInBfloat];
    let (k_a, mut k_d) = (
        reflectance(material.k_a),
        reflectance(stored(material.k_d, so)),
    );
    let so = [
        SpecularInSteps,
        SpecularCut,
        SpecularInHalf,
        SpecularInBfloat,
    ];
    let mut k_s = reflectance(stored(material.k_s, so));
    if is(DiffuseDecoded) {
        k_d = of(k_d.map(|c| from_srgb(c.get())));
    }
    if is(DiffuseGamma22) {
        k_d = k_d.map(|c| c.powf(T::of(2.2)));
    }
    if is(SpecularGamma22) {
        k_s = k_s.map(|c| c.powf(T::of(2.2)));
    }
    if is(SpecularDecoded) {
        k_s = of(k_s.map(|c| from_srgb(c.get())));
    }
    if is(HighlightTimesDiffuse) {
        k_s = mul(k_s, k_d);
    }
    if is(HighlightByDiffuse) {
        k_s = k_d;
    }
    if is(HighlightInGray) {
        k_s = [(k_s[0] + k_s[1] + k_s[2]) / T::of(3.0); 3];
    }
    if is(HighlightWithoutMaterial) {
        k_s = [one; 3];
    }
    if is(HighlightForgotten) {
        k_s = [zero; 3];
    }
    if odd == Some(Odd::NoMoreThanOne) {
        let sum = add(k_d, k_s);
        let most = sum[0].max(sum[1]).max(sum[2]).max(one);
        (k_d, k_s) = (scale(k_d, one / most), scale(k_s, one / most));
    }
    let i_a = of::<T>(color(scene.i_a));
    let mut ambient = mul(if is(AmbientByDiffuse) { k_d } else { k_a }, i_a);
    if is(AmbientWithoutMaterial) {
        ambient = i_a;
    }
    if is(AmbientWithoutLight) {
        ambient = k_a;
    }
    if is(AmbientTimesDiffuse) || profile.ambient_times_diffuse {
        ambient = mul(ambient, k_d);
    }
    if is(AmbientTwice) {
        ambient = add(ambient, ambient);
    }
    let no_lights =
        (is(BlackWithoutLights) || profile.black_without_lights) && scene.lights.is_empty();
    if is(AmbientForgotten) || no_lights {
        ambient = [zero; 3];
    }
    if (is(UnlitWithoutLights) || profile.unlit_without_lights) && scene.lights.is_empty() {
        ambient = add(ambient, k_d);
    }
    let by_light = is(AmbientPerLight)
        || is(AmbientPerLightInFront)
        || is(AmbientArriving)
        || is(AmbientAttenuated)
        || profile.attenuated_ambient;
    let base = if by_light || is(AmbientAtLeast) || odd == Some(Odd::AmbientIfLit) {
        [zero; 3]
    } else {
        ambient
    };

    let m = material.m;
    let m = match () {
        () if is(ShininessTruncated) => m.floor(),
        () if is(ShininessRounded) => m.round(),
        () => m,
    };
    let m = (m + value(ShininessOff).unwrap_or(0.0)).max(0.0);
    let m = m * value(ShininessTimes).unwrap_or(1.0);
    let m = m.max(value(ShininessAtLeast).unwrap_or(0.0));
    let m = match value(ShininessOfBlinnTimes) {
        Some(times) if scene.model == Model::BlinnPhong => m * times,
        _ if is(ShininessToPowerOfTwo) => m.log2().floor().exp2(),
        _ => m,
    };
    let mut m = m.min(value(ShininessAtMost).unwrap_or(f64::INFINITY));
    if let Some(Odd::ShininessTo(power)) = odd {
        m = m.powf(power);
    }

    let range = profile.clamps.or(profile.bits.map(|_| [0.0, 1.0]));
    let [low, high] = range.unwrap_or([0.0, 1.0]);
    let clamp = |c: T| c.max(T::of(low)).min(T::of(high));
    let most = value(LightsAtMost).unwrap_or(1e9) as usize;
    let (mut diffuse, mut specular) = ([zero; 3], [zero; 3]);
    let mut any_in_front = false;
    let mut brightest = [zero; 3];
    for (i, light) in scene.lights.iter().enumerate() {
        if i >= most || is(FirstLightOnly) && i > 0 {
            break;
        }
        let is_last = i + 1 == scene.lights.len();
        if is(FirstLightForgotten) && i == 0 || is(LastLightForgotten) && is_last {
            continue;
        }
        let so = [LightsInSteps, LightsCut, LightsInHalf, LightsInBfloat];
        let mut intensity = of::<T>(stored(color(light.intensity()), so));
        if is(LightClamped) {
            intensity = intensity.map(|c| c.min(one));
        }
        if let Some(times) = value(LightScaled) {
            intensity = scale(intensity, T::of(times));
        }
        if is(LightInGray) {
            intensity = [(intensity[0] + intensity[1] + intensity[2]) / T::of(3.0); 3];
        }
        if is(LightInRed) {
            intensity = [intensity[0]; 3];
        }
        if is(LightDecoded) {
            intensity = of(intensity.map(|c| from_srgb(c.get())));
        }
        match odd {
            Some(Odd::RedDecides) if intensity[0] <= zero => continue,
            Some(Odd::Hue(by)) => intensity[i % 3] = intensity[i % 3] * T::of(1.0 + by),
            Some(Odd::Later(by)) if i > 0 => intensity = scale(intensity, T::of(1.0 - by)),
            _ => {}
        }
        let is_sun = matches!(light, Light::Directional { .. });
        let left_out = match light {
            Light::Directional { .. } => SunsForgotten,
            Light::Point { .. } => PointsForgotten,
            Light::Spot { .. } => SpotsForgotten,
        };
        if is(left_out) {
            continue;
        }
        let mut q = one;
        let mut way = match light {
            Light::Directional { l, .. } if is(SunTakenForPosition) => {
                normalize(sub(of::<T>(*l), p))
            }
            Light::Directional { l, .. } => of::<T>(*l),
            Light::Point { position, .. } | Light::Spot { position, .. } => {
                let position = place(*position);
                let way = if is(PointForgotten) {
                    position
                } else {
                    sub(position, p)
                };
                q = dot(way, way).sqrt();
                if is(DistanceFromOrigin) {
                    q = dot(position, position).sqrt();
                }
                if is(ExpandedSquares) {
                    let twice = T::of(2.0) * dot(position, p);
                    q = (dot(position, position) - twice + dot(p, p))
                        .max(zero)
                        .sqrt();
                }
                way
            }
        };
        if is(LightReversed) || is(SunReversed) && is_sun || is(LampReversed) && !is_sun {
            way = scale(way, -one);
        }
        let l = if is_sun || is(LightNotNormalized) {
            way
        } else if let Some(least) = value(LampDistanceAtLeast) {
            q = q.max(T::of(least));
            scale(way, one / q)
        } else if is(FastInverseRootBesideLamps) {
            scale(way, one / q)
        } else {
            unit(way)
        };
        if let (Light::Spot { axis, .. }, Some(Odd::DistanceAlongAxis)) = (light, odd) {
            q = (q * -dot(of::<T>(*axis), l)).max(T::of(1e-6));
        }
        let mut attenuation = match light {
            Light::Directional { .. } => one,
            Light::Point { attenuation, .. } | Light::Spot { attenuation, .. } => {
                let [mut a, mut b, mut c] = of::<T>(*attenuation);
                if is(CoefficientsReversed) {
                    (a, c) = (c, a);
                }
                if is(LinearForQuadratic) {
                    (b, c) = (c, b);
                }
                if is(ConstantForgotten) {
                    a = zero;
                }
                if is(LinearForgotten) {
                    b = zero;
                }
                if is(QuadraticForgotten) {
                    c = zero;
                }
                if is(ConstantOne) || is(ZeroConstantOne) && a == zero {
                    a = one;
                }
                if is(SquaredDistance) {
                    q = q * q;
                }
                if let Some(least) = value(DistanceAtLeast) {
                    q = q.max(T::of(least));
                }
                let square = if is(QuadraticByDistance) { q } else { q * q };
                let sum = a + b * q + c * square;
                let sum = sum + T::of(value(DenominatorPlus).unwrap_or(0.0));
                match () {
                    () if is(AttenuationInverted) => sum,
                    () if is(InverseSquareAlone) => one / (q * q),
                    () if is(InverseAlone) => one / q,
                    () if is(AttenuationRoot) => one / sum.sqrt(),
                    () if is(AttenuatedTwice) => one / (sum * sum),
                    () if is(NotAttenuated) => one,
                    () => one / sum,
                }
            }
        };
        let is_spot = matches!(light, Light::Spot { .. });
        if is_spot && is(SpotsNotAttenuated) || !is_spot && is(PointsNotAttenuated) {
            attenuation = one;
        }
        if !is_sun {
            if value(AttenuationCutBelow).is_some_and(|least| attenuation.get() < least) {
                attenuation = zero;
            }
            if let Some(most) = value(AttenuationAtMost) {
                attenuation = attenuation.min(T::of(most));
            }
            if let Some(least) = value(AttenuationAtLeast) {
                attenuation = attenuation.max(T::of(least));
            }
            if value(CulledBeyond).is_some_and(|end| q.get() >= end) {
                attenuation = zero;
            }
            if let Some(end) = value(Windowed) {
                let share = q / T::of(end);
                let window = (one - share * share * share * share).max(zero);
                attenuation = attenuation * window * window;
            }
            if let Some(end) = value(FadedTo) {
                attenuation = attenuation * (one - q / T::of(end)).max(zero);
            }
            if let Some(Odd::AttenuationTo(power)) = odd {
                attenuation = attenuation.powf(T::of(power));
            }
        }
        if is(ArrivingClamped) {
            intensity = scale(intensity, attenuation).map(|c| c.min(one));
            attenuation = one;
        }
        let mut cone = one;
        if let Light::Spot {
            axis, half_angle, ..
        } = light
        {
            let mut toward = -dot(of::<T>(*axis), if is(ConeByWay) { way } else { l });
            if is(ConeReversed) {
                toward = -toward;
            }
            let half_angle = if profile.whole_angle {
                half_angle / 2.0
            } else {
                *half_angle
            };
            let edge = T::of(match () {
                () if is(DegreesForRadians) => half_angle.to_radians(),
                () if is(HalfAngleHalved) => half_angle / 2.0,
                () if is(WholeAngleForHalf) => 2.0 * half_angle,
                () if is(AngleTruncated) => half_angle.to_degrees().floor().to_radians(),
                () if is(AngleRounded) => half_angle.to_degrees().round().to_radians(),
                () if is(ConeBySine) => std::f64::consts::FRAC_PI_2 - half_angle,
                () => half_angle,
            })
            .cos();
            let edge = if is(ConeAngleForCosine) {
                T::of(half_angle)
            } else {
                edge
            };
            let exponent = value(ConeExponent).unwrap_or(profile.spot_exponent);
            if exponent > 0.0 {
                cone = toward.max(zero).powf(T::of(exponent));
            }
            if is(ConeFaded) || is(ConeSmooth) {
                let t = ((toward - edge) / (one - edge)).max(zero).min(one);
                cone = if is(ConeSmooth) {
                    t * t * (T::of(3.0) - t - t)
                } else {
                    t
                };
            }
            if let Some(Odd::SoftEdge(width)) = odd {
                cone = ((toward - edge) / T::of(width)).max(zero).min(one);
            } else if toward < edge
                && !is(ConeForgotten)
                && !(is(RightAngleForgotten) && half_angle.to_degrees() > 89.99)
            {
                cone = zero;
            }
        }
        let whole_light = intensity;
        let intensity = scale(intensity, cone);

        let n = if is(NormalTowardLight) && dot(n, l) < zero {
            scale(n, -one)
        } else {
            n
        };
        let n_dot_l = dot(n, l);
        let half = (n_dot_l + one) / T::of(2.0);
        let is_signed = is(DiffuseNotClamped) || is(LightClampedBelow) || is(TotalClampedBelow);
        let mut lambert = match () {
            () if is_signed => n_dot_l,
            () if is(DiffuseTwoSided) => n_dot_l.abs(),
            () if is(HalfLambert) => half,
            () if is(HalfLambertSquared) => half * half,
            () if is(CosineForgotten) => {
                if n_dot_l > zero {
                    one
                } else {
                    zero
                }
            }
            () if is(NormalNotNormalizedInDiffuse) => dot(long_n, l).max(zero),
            () if is(LightNotNormalizedInDiffuse) => dot(n, way).max(zero),
            () => n_dot_l.max(zero),
        };
        let is_lit = n_dot_l.get() > value(CosineCutBelow).unwrap_or(f64::NEG_INFINITY)
            && (!is(LitFromEyeOnly) || dot(n, v) > zero);
        if !is_lit {
            lambert = zero;
        }
        let wrap = match odd {
            Some(Odd::Wrap(by)) => Some(by),
            _ => value(Wrapped),
        };
        if let Some(wrap) = wrap {
            lambert = ((n_dot_l + T::of(wrap)) / (one + T::of(wrap))).max(zero);
        }
        match () {
            () if is(DiffuseOverPi) => lambert = lambert / pi,
            () if is(DiffuseTimesPi) => lambert = lambert * pi,
            () if is(CosineSquared) => lambert = lambert * lambert,
            () if is(DiffuseForgotten) => lambert = zero,
            () => {}
        }
        match odd {
            Some(Odd::DiffuseTimes(by)) => lambert = lambert * T::of(by),
            Some(Odd::CosineTo(power)) => lambert = lambert.powf(T::of(power)),
            Some(Odd::CosineAtLeast(least)) if n_dot_l > zero => {
                lambert = lambert.max(T::of(least));
            }
            Some(Odd::Banded(by)) => lambert = T::of((lambert.get() * by).round() / by),
            _ => {}
        }
        if !is(DiffuseNotAttenuated) {
            lambert = lambert * attenuation;
        }
        let of_light = match () {
            () if is(DiffuseWithoutLight) => [cone; 3],
            () if is(ConeNotOfDiffuse) => whole_light,
            () => intensity,
        };
        let k = if is(DiffuseMinusSpecular) {
            mul(k_d, k_s.map(|c| one - c))
        } else if is(DiffuseMinusLargest) {
            scale(k_d, one - k_s[0].max(k_s[1]).max(k_s[2]))
        } else {
            k_d
        };
        let mut matte = scale(mul(k, of_light), lambert);
        let mut shiny = [zero; 3];
        let of_kind = match light {
            Light::Directional { .. } => HighlightNotGatedOfSuns,
            Light::Point { .. } => HighlightNotGatedOfPoints,
            Light::Spot { .. } => HighlightNotGatedOfSpots,
        };
        let is_gated = !(is(of_kind)
            || is(HighlightNotGated)
            || is(LightClampedBelow)
            || profile.highlight_on_the_dark_side);
        let has_model = scene.model != Model::Lambert || is(HighlightOnLambert);
        let has_highlight = has_model
            && is_lit
            && !(is(HighlightOfFirstLightOnly) && i > 0)
            && (n_dot_l > zero || !is_gated)
            && (!is(HighlightGatedOnEye) || dot(n, v) > zero);
        if has_highlight {
            let is_phong = match scene.model {
                Model::Lambert => false,
                Model::Phong => !is(OtherModel),
                Model::BlinnPhong => is(OtherModel),
            };
            let l = if is(LightNotNormalizedInHighlight) {
                way
            } else {
                l
            };
            let long = is(NormalNotNormalizedInHighlight);
            let n = if long { long_n } else { n };
            let n_dot_l = dot(n, l);
            let sum = add(l, v);
            // opposite directions have no half vector
            let has_half = dot(sum, sum) > zero || is(HalfVectorUnguarded);
            let cosine = if is_phong {
                let times = if is(ReflectionWithoutTwo) { 1.0 } else { 2.0 };
                let mut r = sub(scale(n, T::of(times) * n_dot_l), l);
                if is(ReflectionReversed) {
                    r = scale(r, -one);
                }
                dot(r, v)
            } else if odd == Some(Odd::EyeForHalf) {
                dot(n, v)
            } else if is(HalfVectorHalved) {
                dot(n, scale(sum, T::of(0.5)))
            } else if is(HalfVectorNotNormalized) {
                dot(n, sum)
            } else if has_half {
                dot(n, unit(sum))
            } else {
                zero
            };
            let cosine = match () {
                () if is(PowerNotClamped) => cosine,
                () if is(CosineOfHighlightAbsolute) => cosine.abs(),
                // a maximum that lets NaN through
                () if cosine < zero => zero,
                () => cosine,
            };
            let cosine = match value(CosineOfHighlightAtLeast) {
                Some(least) => cosine.max(T::of(least)),
                None => cosine,
            };
            let of_m = T::of(m);
            let mut factor = cosine.powf(of_m);
            if is(PowerOfSchlick) {
                factor = cosine / (of_m - of_m * cosine + cosine);
            }
            if let Some(Odd::PowerTable(entries)) = odd {
                let entry = (cosine.get().clamp(0.0, 1.0) * entries).round() / entries;
                factor = T::of(entry.powf(m));
            }
            if let (Some(Odd::PowerByBits), true) = (odd, cosine > zero) {
                let of_one = 1_064_866_805.0;
                let bits = m * (f64::from((cosine.get() as f32).to_bits()) - of_one) + of_one;
                factor = T::of(f64::from(f32::from_bits(bits.max(0.0) as u32)));
            }
            let eight_pi = T::of(8.0) * pi;
            let (two, eight) = (T::of(2.0), T::of(8.0));
            match () {
                () if is(NormalizedByEight) => factor = factor * (of_m + eight) / eight_pi,
                () if is(NormalizedByTwo) => factor = factor * (of_m + two) / (two * pi),
                () if is(NormalizedByOne) => factor = factor * (of_m + one) / (two * pi),
                () if is(NormalizedByTwoOfEight) => factor = factor * (of_m + two) / eight_pi,
                () if is(NormalizedExactly) => {
                    let below = T::of((-m / 2.0).exp2()) + of_m;
                    factor = factor * (of_m + two) * (of_m + T::of(4.0)) / (eight_pi * below);
                }
                () => {}
            }
            factor = match () {
                () if is(HighlightNotAttenuated) || profile.unattenuated_highlight => factor,
                () if is(HighlightAttenuatedTwice) => factor * attenuation * attenuation,
                () if is(HighlightTimesCosine) => factor * attenuation * n_dot_l,
                () if is(HighlightOverCosine) => factor * attenuation / n_dot_l,
                () if is(HighlightOverPi) => factor * attenuation / pi,
                () => factor * attenuation,
            };
            factor = factor * T::of(value(HighlightScaled).unwrap_or(1.0));
            let of_light = match () {
                () if is(HighlightWithoutLight) => [cone; 3],
                () if is(ConeNotOfHighlight) => whole_light,
                () => intensity,
            };
            let mean = (intensity[0] + intensity[1] + intensity[2]) / T::of(3.0);
            let of_light = match odd {
                Some(Odd::LightSquared) => mul(of_light, intensity),
                Some(Odd::GrayHighlight) => [mean; 3],
                _ => of_light,
            };
            let grazing = if is(Fresnel) {
                Some(one - dot(v, normalize(sum)))
            } else {
                is(FresnelOfEye).then(|| one - dot(n, v).max(zero))
            };
            let k = match grazing {
                Some(x) => {
                    let x = x.max(zero);
                    k_s.map(|c| c + (one - c) * (x * x * x * x * x))
                }
                None => k_s,
            };
            shiny = scale(mul(k, of_light), factor);
        }
        let lit = add(matte, shiny);
        if is(LightClampedBelow) {
            (matte, shiny) = (lit.map(|c| c.max(zero)), [zero; 3]);
        }
        if is(EachLightClamped) {
            (matte, shiny) = (lit.map(clamp), [zero; 3]);
        }
        if is(EachLightEncoded) {
            (matte, shiny) = (of(lit.map(|c| srgb(c.get()))), [zero; 3]);
        }
        if is(LastLightOnly) {
            (diffuse, specular) = ([zero; 3], [zero; 3]);
        }
        if is(BrightestLightOnly) {
            brightest = [0, 1, 2].map(|i| brightest[i].max(matte[i] + shiny[i]));
            (diffuse, specular) = (brightest, [zero; 3]);
        } else {
            diffuse = add(diffuse, matte);
            specular = add(specular, shiny);
        }
        if odd == Some(Odd::AmbientIfLit) && n_dot_l > zero && !any_in_front {
            any_in_front = true;
            specular = add(specular, ambient);
        }
        let in_front = is(AmbientPerLightInFront) || is(AmbientPerLightInFrontToo);
        if is(AmbientPerLight) || is(AmbientPerLightToo) || in_front && n_dot_l > zero {
            specular = add(specular, ambient);
        }
        if is(AmbientArriving) && cone > zero {
            specular = add(specular, scale(ambient, attenuation));
        }
        if is(AmbientAttenuated) || profile.attenuated_ambient {
            specular = add(specular, scale(ambient, attenuation));
        }
        if let Some(Odd::SumCut(of_bits)) = odd {
            let cut = |c: T| {
                let unit = (c.get().abs().log2().floor() + 1.0 - of_bits).exp2();
                T::of(if c > zero {
                    (c.get() / unit).floor() * unit
                } else {
                    0.0
                })
            };
            let first = if i == 0 { base } else { [zero; 3] };
            diffuse = add(add(diffuse, specular), first).map(cut);
            specular = [zero; 3];
        }
        if let Some(Odd::Rounded(of_bits)) = odd {
            diffuse = diffuse.map(|c| T::of(bits(c.get(), of_bits)));
            specular = specular.map(|c| T::of(bits(c.get(), of_bits)));
        }
    }
    if is(LightsAveraged) && !scene.lights.is_empty() {
        let count = T::of(scene.lights.len() as f64);
        diffuse = diffuse.map(|c| c / count);
        specular = specular.map(|c| c / count);
    }
    if is(TermsClamped) {
        diffuse = diffuse.map(clamp);
        specular = specular.map(clamp);
    }
    let base = if is(EachLightEncoded) {
        of(base.map(|c| srgb(c.get())))
    } else {
        base
    };
    let is_summed = matches!(odd, Some(Odd::SumCut(_))) && !scene.lights.is_empty();
    let mut sum = if is_summed {
        diffuse
    } else {
        add(base, diffuse)
    };
    if is(DiffuseClamped) {
        sum = sum.map(clamp);
    }
    sum = add(sum, specular);
    if is(AmbientAtLeast) {
        sum = [0, 1, 2].map(|i| sum[i].max(ambient[i]));
    }
    if is(TotalClampedBelow) {
        sum = sum.map(|c| c.max(zero));
    }
    if let Some(of_bits) = value(InBits) {
        sum = sum.map(|c| T::of(bits(c.get(), of_bits)));
    }
    match odd {
        Some(Odd::Red(by)) => sum[0] = sum[0] * T::of(by),
        Some(Odd::Fog(by)) => {
            let far = dot(of::<T>(scene.v), of(scene.v)).sqrt();
            sum = scale(sum, (-far * T::of(by)).exp());
        }
        Some(Odd::Plus(by)) => sum = sum.map(|c| c + T::of(by)),
        _ => {}
    }
    let [r, g, b] = sum;
    let sum = match () {
        () if is(ChannelsSwapped) => [b, g, r],
        () if is(RedAndGreenSwapped) => [g, r, b],
        () if is(GreenAndBlueSwapped) => [r, b, g],
        () if is(Gray) => [(r + g + b) / T::of(3.0); 3],
        () if is(Luminance) => [r * T::of(0.2126) + g * T::of(0.7152) + b * T::of(0.0722); 3],
        () if is(Black) => [zero; 3],
        () => match value(ChannelsShifted) {
            Some(places) if places > 1.0 => [g, b, r],
            Some(_) => [b, r, g],
            None => [r, g, b],
        },
    };
    let sum = scale(sum, T::of(value(Scaled).unwrap_or(1.0)));
    let sum = match () {
        () if is(Reinhard) => sum.map(|c| c / (one + c)),
        () if is(ExponentialTone) => sum.map(|c| one - (-c).exp()),
        () => sum,
    };
    encoded(sum, profile, plan)
}
