//! One test for each program.

use std::f64::consts::FRAC_1_PI;

use properties::Tracked;
use shading::{
    Attenuation, Cone, Material, PointLight, Real, Rgb, SpotLight, UnitVec3, Vec3, shade,
};

use crate::scene::{Lamp, Scene, Source, Spot};
use crate::{Comparison, Fields, compare};

/// Mesa's power is right to 2·10⁻⁵, and the result is multiplied out in single precision.
#[test]
fn mesa_fixed_function() {
    for (file, rows) in [("gl_single_light.csv", 400), ("gl_multi_light.csv", 80)] {
        for renderer in [0, 1] {
            compare(file, rows, |fields| {
                let _id_and_class = (fields.text(), fields.text());
                let count = fields.text();
                let soft_and_llvm = [fields.three_bits(), fields.three_bits()];
                let [p, n, emission, k_a, k_d, k_s] = [(); 6].map(|()| fields.three_bits());
                let (m, i_a) = (fields.bits(), fields.three_bits());
                let count: usize = count.parse().expect("the number of lights");
                let lamps = (0..count).map(|_| mesa_lamp(fields)).collect();
                let scene = Scene {
                    p,
                    n,
                    n_as_given: true,
                    emission,
                    ambient: [k_a, i_a],
                    k_a,
                    k_d,
                    blinn: (k_s, m),
                    lamps,
                    ..Scene::default()
                };
                let expected = soft_and_llvm[renderer];
                let tolerance = expected.map(|c| 1e-7 + 2.5e-5 * c);
                Comparison {
                    color: scene.shade(),
                    expected,
                    tolerance,
                }
            });
        }
    }
}

fn mesa_lamp(fields: &mut Fields) -> Lamp {
    let (position, w) = (fields.three_bits(), fields.bits());
    let [ambient, diffuse, specular, attenuation, axis] = [(); 5].map(|()| fields.three_bits());
    let (exponent, cutoff) = (fields.bits(), fields.bits());
    let spot = (cutoff < 180.0).then(|| Spot {
        axis,
        half_angles_degrees: [cutoff; 2],
        profile: Box::new(move |cosine| cosine.max(0.0).powf(exponent)),
    });
    let source = match w {
        0.0 => Source::Directional(position),
        _ => Source::Point(position.map(|c| c / w)),
    };
    Lamp {
        source,
        attenuation,
        spot,
        ambient,
        diffuse,
        specular,
        ..Lamp::default()
    }
}

/// Tachyon prints in single precision, with a relative error of 3·10⁻⁷, and prints 0 for less than half the
/// smallest `f32`. In one case, a highlight of 5·10⁻⁸ with m = 151.6 and a light at a distance of 0.4, it
/// differs by 4.9·10⁻⁷ itself from the closed form in `f64`: m amplifies the error of its intersection.
#[test]
fn tachyon() {
    compare("tachyon.csv", 250, |fields| {
        let relative = if fields.text() == "607" { 5e-7 } else { 3e-7 };
        let (_class, model) = (fields.text(), fields.text());
        let [expected, p, n, eye, color] = [(); 5].map(|()| fields.three());
        let [ambient, diffuse, shine, m] = [(); 4].map(|()| fields.number());
        let (highlight, none) = (([shine; 3], m), ([0.0; 3], 1.0));
        let (phong, blinn) = if model == "phong" {
            (highlight, none)
        } else {
            (none, highlight)
        };
        let scene = Scene {
            p,
            n,
            eye,
            ambient: [color, [ambient; 3]],
            k_d: color.map(|c| c * diffuse),
            phong,
            blinn,
            lamps: fields.lamps(tachyon_lamp),
            ..Scene::default()
        };
        let underflow = f64::from(f32::from_bits(1)) / 2.0;
        let tolerance = expected.map(|c| relative * c + underflow);
        Comparison {
            color: scene.shade(),
            expected,
            tolerance,
        }
    });
}

/// Only the diffuse part is attenuated: if N·L times the attenuation exceeds 0.001959, the highlight has the
/// light's full color. A spot fades linearly with the angle, between two half-angles.
fn tachyon_lamp(fields: &mut Fields) -> Lamp {
    let kind = fields.text();
    let [place, color, attenuation, axis] = [(); 4].map(|()| fields.three());
    let [start, end] = [(); 2].map(|()| fields.number());
    let fades = move |cosine: f64| {
        let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
        ((end - angle) / (end - start)).clamp(0.0, 1.0)
    };
    let spot = Spot {
        axis,
        half_angles_degrees: [end; 2],
        profile: Box::new(fades),
    };
    let source = match kind {
        "directional" => Source::Directional(place.map(|c| -c)),
        _ => Source::Point(place),
    };
    Lamp {
        source,
        attenuation,
        spot: (kind == "spot").then_some(spot),
        diffuse: color,
        specular: color,
        bare_highlight_above: Some(0.001_959),
        ..Lamp::default()
    }
}

/// POV-Ray writes 16 bits per channel: half a step, and what `f64` rounds.
#[test]
fn povray() {
    compare("povray.csv", 250, |fields| {
        let _id_and_class = (fields.text(), fields.text());
        let [expected, p, n, eye, pigment] = [(); 5].map(|()| fields.three());
        let (ambient, i_a) = (fields.number(), fields.three());
        let [diffuse, phong, phong_m, blinn, blinn_m] = [(); 5].map(|()| fields.number());
        let scene = Scene {
            p,
            n,
            eye,
            ambient: [pigment.map(|c| c * ambient), i_a],
            k_d: pigment.map(|c| c * diffuse),
            phong: ([phong; 3], phong_m),
            blinn: ([blinn; 3], blinn_m),
            lamps: fields.lamps(povray_lamp),
            ..Scene::default()
        };
        Comparison {
            color: scene.shade().map(|c| c.clamp(0.0, 1.0)),
            expected: expected.map(|c| c / 65535.0),
            tolerance: [0.5 / 65535.0 + 1e-10; 3],
        }
    });
}

/// The attenuation is 2/(1 + (q/d)^power). A cone is smooth between two half-angles, or hard if they are
/// equal, times the cosine to the power `tightness`.
fn povray_lamp(fields: &mut Fields) -> Lamp {
    let kind = fields.text();
    let [position, at, color] = [(); 3].map(|()| fields.three());
    let [distance, power, radius, falloff, tightness] = [(); 5].map(|()| fields.number());
    let toward = [0, 1, 2].map(|i| at[i] - position[i]);
    let attenuation = match power {
        0.0 => [1.0, 0.0, 0.0],
        1.0 => [0.5, 0.5 / distance, 0.0],
        _ => [0.5, 0.0, 0.5 / (distance * distance)],
    };
    let spot = Spot {
        axis: toward,
        half_angles_degrees: [radius.min(falloff), falloff],
        profile: Box::new(move |cosine| cosine.max(0.0).powf(tightness)),
    };
    let source = match kind {
        "parallel" => Source::Directional(toward.map(|c| -c)),
        _ => Source::Point(position),
    };
    let spot = (kind == "spot").then_some(spot);
    Lamp {
        source,
        attenuation,
        spot,
        diffuse: color,
        specular: color,
        ..Lamp::default()
    }
}

/// The shader computes in single precision, but OpenGL ES and Vulkan allow an error of 5u for a division
/// and a root, which round by 1u otherwise. For the power q^decay = 2^(decay log₂ q) with |log₂ q| ≤ 2,
/// they allow 16u for the logarithm and 22u for the exponential.
#[test]
fn three_js() {
    compare("three_js.csv", 704, |fields| {
        let kind = fields.text();
        let [position, to] = [(); 2].map(|()| fields.three());
        let [inner, outer] = [(); 2].map(|()| fields.number().to_radians());
        let [range, decay, x, y] = [(); 4].map(|()| fields.number());
        let expected = fields.three();

        // 1/q^decay times a window; a range of 0 means no range
        let [a, b, c] =
            [0.0, 1.0, 2.0].map(|power: f64| f64::from(power.total_cmp(&decay).is_eq()));
        let range = if range > 0.0 { range } else { f64::INFINITY };
        let attenuation = Attenuation::new(a, b, c)
            .and_then(|free| free.within(range))
            .expect("a range");
        let position = Vec3::from(position);
        let point = PointLight {
            position,
            intensity: Rgb::new(4.0, 2.0, 1.0),
            attenuation,
        };
        let cone = Cone::from_half_angles(inner, outer)
            .expect("half-angles")
            .smoothstep();
        let axis = (Vec3::from(to) - position)
            .unit()
            .unwrap_or(UnitVec3::NEG_Z);
        let spot = (kind == "spot").then_some((axis, cone));
        let color = pixel(point, spot, [x, y]);

        let single = |x| Tracked::input(f32::of(x));
        let spot = spot.map(|(axis, cone)| (axis.cast(single), cone.cast(single)));
        let error =
            pixel(point.cast(single), spot, [x, y].map(single)).map(|channel| channel.error);
        let power = 38.0 * f64::from(f32::EPSILON) / 2.0;
        let tolerance = [0, 1, 2].map(|i| 5.0 * error[i] + power * expected[i]);
        Comparison {
            color,
            expected,
            tolerance,
        }
    });
}

/// The light of a pixel of the white plane z = 0, in an engine whose diffuse term has a factor of 1/π.
fn pixel<T: Real>(
    point: PointLight<T>,
    spot: Option<(UnitVec3<T>, Cone<T>)>,
    [x, y]: [T; 2],
) -> [T; 3] {
    let k_d = Rgb::gray(T::of(FRAC_1_PI));
    let plane = Material {
        k_a: k_d,
        k_d,
        k_s: k_d,
        m: 1,
    };
    let p = Vec3::new(x, y, T::ZERO);
    let light = match spot {
        Some((axis, cone)) => SpotLight { point, axis, cone }.at(p),
        None => point.at(p),
    };
    shade::lambert(UnitVec3::Z, &plane, Rgb::BLACK, [light])
        .diffuse
        .into()
}
