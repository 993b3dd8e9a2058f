//! The table of mistakes: those that public trackers of renderers report again and again. What has
//! no row is placed without one.

use std::f64::consts::{FRAC_1_PI, PI};

use super::Mistake;
use crate::bounded::{Bounded, Bounded3};
use crate::formula::Part::{
    Against, Ambient, AmbientToo, Angle, Cone, Cosine, Diffuse, Encode, Falloff, Gate, Half,
    Intensity, L, Lambert, Level, M, N, OfLight, Once, Power, Q, ShinyFalloff, Side, Specular, Sum,
    ToLight, V, Within,
};
use crate::formula::{At, BLACK, Change, ONE, Part};
use crate::profile::to_srgb;
use crate::scene::{Light, Model, add, dot, mul, scale};

/// A mistake that changes an ingredient; what it is stands in `says`.
const fn row(id: &'static str, part: Part, change: Change) -> Mistake {
    Mistake {
        id,
        says: "",
        values: &[0.0],
        change: (part, change),
        more: &[],
    }
}

impl Mistake {
    const fn says(self, says: &'static str) -> Self {
        Self { says, ..self }
    }

    /// Changes more ingredients.
    const fn and(self, more: &'static [(Part, Change)]) -> Self {
        Self { more, ..self }
    }

    /// Has one of these numbers.
    const fn of(self, values: &'static [f64]) -> Self {
        Self { values, ..self }
    }
}

fn one(x: Bounded) -> Bounded3 {
    [x; 3]
}

fn exact(x: f64) -> Bounded {
    Bounded::exact(x)
}

fn times(x: Bounded3, at: &At) -> Bounded3 {
    scale(x, at.number())
}

fn minus(x: Bounded3) -> Bounded3 {
    x.map(|c| -c)
}

/// 1 where N is on the side of the eye, −1 where it is not; either where they are perpendicular.
fn side_of_eye(at: &At) -> Bounded {
    let cosine = dot(at.v, at.n);
    if cosine.value == 0.0 {
        ONE.looser(2.0)
    } else {
        cosine.if_positive(ONE, -ONE)
    }
}

/// 1/√x by the bits of x and one step of Newton's.
///
/// Source: Lomont 2003, *Fast Inverse Square Root*.
fn fast_inverse_root(x: Bounded, at: &At) -> Bounded {
    #[allow(clippy::cast_possible_truncation)] // it is one of f32
    let bits = (x.value as f32).to_bits();
    let guess = f64::from(f32::from_bits(0x5f37_59df_u32.wrapping_sub(bits >> 1)));
    let root = guess * (1.5 - 0.5 * x.value * guess * guess);
    Bounded::rounded(root, 0.0, 16.0, at.u.max(f64::from(f32::EPSILON)))
        .looser(root * x.error / x.value)
}

fn unit_by_bits(v: Bounded3, at: &At) -> Bounded3 {
    scale(v, fast_inverse_root(dot(v, v), at))
}

fn if_so(is_so: bool, then: Bounded3, otherwise: Bounded3) -> Bounded3 {
    if is_so { then } else { otherwise }
}

/// Where a renderer may have done either.
fn either(a: Bounded3, b: Bounded3) -> Bounded3 {
    [0, 1, 2].map(|i| a[i].looser((a[i].value - b[i].value).abs() + b[i].error))
}

/// What linear light is encoded as.
fn of_linear(at: &At, f: impl Fn(f64) -> f64) -> Bounded3 {
    one(exact(f(at.linear)))
}

/// What a term, or a light, may be multiplied by; it is missing if that is 0.
const FACTORS: &[f64] = &[0.0, 0.5, 2.0, FRAC_1_PI, PI, 0.25, 4.0, 0.1, 10.0];

/// Every known mistake.
pub static MISTAKES: &[Mistake] = &[
    // directions
    row("NormalNotNormalized", N, |_, at| at.raw_n).says("N is not normalized after interpolation"),
    row("NormalReversed", N, |x, _| minus(x)).says("N points into the surface"),
    row("NormalTowardEye", Side, |x, at| one(x[0] * side_of_eye(at)))
        .says("N is turned toward the eye, so the back of a surface is lit like its front"),
    row("ViewNotNormalized", V, |_, at| at.raw_v).says("V is not normalized"),
    row("ViewReversed", V, |x, _| minus(x)).says("V points from the eye to the surface"),
    row("LightNotNormalized", L, |_, at| at.to_light).says("L is not normalized"),
    row("LightReversed", L, |x, _| minus(x)).says("L points from the light to the surface"),
    row("PointForgotten", ToLight, |_, at| at.position)
        .says("L is the position of the lamp, from which p is not subtracted"),
    row("FastInverseRoot", V, |_, at| unit_by_bits(at.raw_v, at))
        .and(&[
            (N, |_, at| unit_by_bits(at.raw_n, at)),
            (Q, |x, at| {
                either(x, one(ONE / fast_inverse_root(x[0] * x[0], at)))
            }),
            (L, |x, at| {
                let by_bits = unit_by_bits(at.to_light, at);
                let is_lamp = at.light.and_then(Light::lamp).is_some();
                if_so(is_lamp, by_bits, either(x, by_bits))
            }),
            (Half, |_, at| unit_by_bits(at.sum, at)),
        ])
        .says(
            "vectors are normalized by a fast inverse square root with one step of Newton's, \
             which is off by up to 0.18 %",
        ),
    // lamps
    row("NotAttenuated", Falloff, |_, _| one(ONE)).says("the light is not attenuated"),
    row("HighlightNotAttenuated", ShinyFalloff, |_, _| one(ONE))
        .says("the highlight is not attenuated"),
    row("DegreesForRadians", Angle, |x, at| {
        one(at.given(x[0].value.to_radians()))
    })
    .says("the angle of the cone is taken for degrees"),
    row("HalfAngleHalved", Angle, |x, _| scale(x, exact(0.5)))
        .says("the half-angle of the cone is taken for the whole one, and halved"),
    row("ConeReversed", Against, |x, _| minus(x)).says("the cone opens against its axis"),
    row("ConeForgotten", Cone, |_, at| one(at.within)).says("the cone of a spot is ignored"),
    row("ConeExponent", Within, |_, at| {
        one(at.against.at_least_zero().power(at.value))
    })
    .says("the light of a spot falls off within its cone, as the cosine to the power of {}")
    .of(&[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 3.0, 5.0, 10.0]),
    row("ConeSmooth", Within, |_, at| {
        let t = ((at.against - at.edge) / (ONE - at.edge)).at_least_zero();
        one(t * t * (exact(3.0) - t - t))
    })
    .says("the light of a spot fades from its axis to its edge, by smoothstep"),
    // terms
    row("DiffuseNotClamped", Lambert, |_, at| one(at.n_dot_l))
        .says("N·L is not clamped to 0, so light from behind is subtracted"),
    row("HighlightNotGated", Gate, |_, _| one(ONE))
        .says("the highlight is not gated on N·L > 0, so faces turned away from a light have one"),
    row("ReflectionReversed", Cosine, |x, at| {
        if_so(at.model == Model::Phong, minus(x), x)
    })
    .says("R points the wrong way: reflect() of GLSL and HLSL takes −L"),
    row("HalfVectorNotNormalized", Half, |_, at| at.sum).says("H = L + V is not normalized"),
    row("HalfVectorUnguarded", OfLight, |x, at| {
        let is_none = at.sum.iter().all(|c| c.value.abs() <= c.error);
        let nan = exact(f64::NAN).looser(f64::INFINITY);
        if_so(is_none && at.model == Model::BlinnPhong, one(nan), x)
    })
    .says("H is NaN where L = -V: the length of L + V is not checked before the division"),
    row("ShininessTimes", M, |x, at| {
        x.map(|m| exact(m.value * at.value))
    })
    .says("the shininess is multiplied by {}")
    .of(&[4.0, 2.0, 0.5, 0.25, 3.0, 128.0]),
    row("NormalizedByEight", Power, |x, at| {
        let by = (at.m + 8.0) / (8.0 * PI);
        scale(x, Bounded::rounded(by, 0.0, 16.0, at.u))
    })
    .says("the highlight is normalized by (m + 8)/(8π)"),
    row("HighlightTimesCosine", Specular, |x, at| {
        scale(x, at.n_dot_l.at_least_zero())
    })
    .says("the highlight is multiplied by N·L"),
    row("AmbientPerLight", Once, |_, _| BLACK)
        .and(&[(AmbientToo, |_, at| at.ambient)])
        .says("the ambient term is added once for each light"),
    row("AmbientTimesDiffuse", Ambient, |x, at| mul(x, at.k_d))
        .says("the ambient term is multiplied by k_d"),
    row("UnlitWithoutLights", Once, |x, at| {
        if_so(at.is_unlit, add(x, at.k_d), x)
    })
    .says("without lights the surface is shown unlit: k_d is added"),
    row("AmbientTimes", Ambient, times)
        .says("the ambient term is multiplied by {}")
        .of(FACTORS),
    row("DiffuseTimes", Diffuse, times)
        .says("the diffuse term is multiplied by {}")
        .of(FACTORS),
    row("HighlightTimes", Specular, times)
        .says("the highlight is multiplied by {}")
        .of(FACTORS),
    row("LightTimes", Intensity, times)
        .says("the color of a light is multiplied by {}")
        .of(FACTORS),
    // the sum, and the reply
    row("LightsAtMost", OfLight, |x, at| {
        if_so(at.i >= at.value, BLACK, x)
    })
    .says("lights beyond number {} are left out")
    .of(&[
        4.0, 1.0, 2.0, 3.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0, 32.0, 64.0,
    ]),
    row("ChannelsSwapped", Sum, |[r, g, b], _| [b, g, r]).says("red and blue are swapped"),
    row("Scaled", Sum, times)
        .says("all colors are multiplied by {}")
        .of(&[0.5, 2.0, FRAC_1_PI, PI, 1.0 / 255.0, 255.0]),
    row("SrgbOnceMore", Encode, |x, _| {
        x.map(|c| exact(to_srgb(c.value)))
    })
    .says("sRGB is applied once more than the profile says"),
    row("Gamma", Encode, |_, at| {
        of_linear(at, |x| x.max(0.0).powf(1.0 / at.value))
    })
    .says("a gamma of {} is applied, not what the profile says")
    .of(&[1.0, 2.2, 2.0, 1.8, 2.4]),
    row("LevelsTruncated", Level, |_, at| {
        let most = 1.0 / at.level.unwrap_or(1.0);
        of_linear(at, |x| (x * most).floor() / most)
    })
    .says("levels are truncated, not rounded"),
];
