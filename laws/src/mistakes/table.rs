//! The table of mistakes: those that public trackers of renderers report again and again. What has
//! no row is placed without one.

use std::f64::consts::{FRAC_1_PI, PI};

use super::{Changes, Mistake};
use crate::bounded::{Bounded, Bounded3};
use crate::formula::Part::{
    Against, Ambient, AmbientToo, Angle, Cone, Cosine, Diffuse, Encode, Falloff, Gate, Half,
    Intensity, L, Lambert, Level, M, N, OfLight, Once, Power, Q, ShinyFalloff, Side, Specular, Sum,
    ToLight, V, Within,
};
use crate::formula::{At, BLACK, ONE};
use crate::profile::to_srgb;
use crate::scene::{Light, Model, add, dot, mul, scale};

const fn row(id: &'static str, says: &'static str) -> Mistake {
    Mistake {
        id,
        says,
        values: &[0.0],
        changes: &[],
        is_fatal: false,
    }
}

impl Mistake {
    const fn changes(self, changes: Changes) -> Self {
        Self { changes, ..self }
    }

    /// Has one of these numbers.
    const fn of(self, values: &'static [f64]) -> Self {
        Self { values, ..self }
    }

    const fn fatal(self) -> Self {
        Self {
            is_fatal: true,
            ..self
        }
    }
}

fn one(x: Bounded) -> Bounded3 {
    [x; 3]
}

fn exact(x: f64) -> Bounded {
    Bounded::exact(x)
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
    row(
        "NormalNotNormalized",
        "N is not normalized after interpolation",
    )
    .changes(&[(N, |_, at| at.raw_n)]),
    row("NormalReversed", "N points into the surface").changes(&[(N, |x, _| minus(x))]),
    row(
        "NormalTowardEye",
        "N is turned toward the eye, so the back of a surface is lit like its front",
    )
    .changes(&[(Side, |x, at| one(x[0] * side_of_eye(at)))]),
    row("ViewNotNormalized", "V is not normalized").changes(&[(V, |_, at| at.raw_v)]),
    row("ViewReversed", "V points from the eye to the surface").changes(&[(V, |x, _| minus(x))]),
    row("LightNotNormalized", "L is not normalized").changes(&[(L, |_, at| at.to_light)]),
    row("LightReversed", "L points from the light to the surface").changes(&[(L, |x, _| minus(x))]),
    row(
        "PointForgotten",
        "L is the position of the lamp, from which p is not subtracted",
    )
    .changes(&[(ToLight, |_, at| at.position)]),
    row(
        "FastInverseRoot",
        "vectors are normalized by a fast inverse square root with one step of Newton's, \
         which is off by up to 0.18 %",
    )
    .changes(&[
        (V, |_, at| unit_by_bits(at.raw_v, at)),
        (N, |_, at| unit_by_bits(at.raw_n, at)),
        (Q, |x, at| {
            either(x, one(ONE / fast_inverse_root(x[0] * x[0], at)))
        }),
        (L, |x, at| {
            let by_bits = unit_by_bits(at.to_light, at);
            if at.light.and_then(Light::lamp).is_some() {
                by_bits
            } else {
                either(x, by_bits)
            }
        }),
        (Half, |_, at| unit_by_bits(at.sum, at)),
    ]),
    // lamps
    row("NotAttenuated", "the light is not attenuated").changes(&[(Falloff, |_, _| one(ONE))]),
    row("HighlightNotAttenuated", "the highlight is not attenuated")
        .changes(&[(ShinyFalloff, |_, _| one(ONE))]),
    row(
        "DegreesForRadians",
        "the angle of the cone is taken for degrees",
    )
    .changes(&[(Angle, |x, at| one(at.given(x[0].value.to_radians())))]),
    row(
        "HalfAngleHalved",
        "the half-angle of the cone is taken for the whole one, and halved",
    )
    .changes(&[(Angle, |x, _| scale(x, exact(0.5)))]),
    row("ConeReversed", "the cone opens against its axis").changes(&[(Against, |x, _| minus(x))]),
    row("ConeForgotten", "the cone of a spot is ignored")
        .changes(&[(Cone, |_, at| one(at.within))]),
    row(
        "ConeExponent",
        "the light of a spot falls off within its cone, as the cosine to the power of {}",
    )
    .changes(&[(Within, |_, at| {
        one(at.against.at_least_zero().power(at.value))
    })])
    .of(&[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 3.0, 5.0, 10.0]),
    row(
        "ConeSmooth",
        "the light of a spot fades from its axis to its edge, by smoothstep",
    )
    .changes(&[(Within, |_, at| {
        let t = ((at.against - at.edge) / (ONE - at.edge)).at_least_zero();
        one(t * t * (exact(3.0) - t - t))
    })]),
    // terms
    row(
        "DiffuseNotClamped",
        "N·L is not clamped to 0, so light from behind is subtracted",
    )
    .changes(&[(Lambert, |_, at| one(at.n_dot_l))]),
    row(
        "HighlightNotGated",
        "the highlight is not gated on N·L > 0, so faces turned away from a light have one",
    )
    .changes(&[(Gate, |_, _| one(ONE))]),
    row(
        "ReflectionReversed",
        "R points the wrong way: reflect() of GLSL and HLSL takes −L",
    )
    .changes(&[(Cosine, |x, at| {
        if at.model == Model::Phong {
            minus(x)
        } else {
            x
        }
    })]),
    row("HalfVectorNotNormalized", "H = L + V is not normalized")
        .changes(&[(Half, |_, at| at.sum)]),
    row(
        "HalfVectorUnguarded",
        "H is NaN where L = -V: the length of L + V is not checked before the division",
    )
    .changes(&[(OfLight, |x, at| {
        let is_none = at.sum.iter().all(|c| c.value.abs() <= c.error);
        let nan = exact(f64::NAN).looser(f64::INFINITY);
        if is_none && at.model == Model::BlinnPhong {
            one(nan)
        } else {
            x
        }
    })])
    .fatal(),
    row("ShininessTimes", "the shininess is multiplied by {}")
        .changes(&[(M, |x, at| x.map(|m| exact(m.value * at.value)))])
        .of(&[4.0, 2.0, 0.5, 0.25, 3.0, 128.0]),
    row(
        "NormalizedByEight",
        "the highlight is normalized by (m + 8)/(8π)",
    )
    .changes(&[(Power, |x, at| {
        scale(
            x,
            Bounded::rounded((at.m + 8.0) / (8.0 * PI), 0.0, 16.0, at.u),
        )
    })]),
    row("HighlightTimesCosine", "the highlight is multiplied by N·L")
        .changes(&[(Specular, |x, at| scale(x, at.n_dot_l.at_least_zero()))]),
    row(
        "AmbientPerLight",
        "the ambient term is added once for each light",
    )
    .changes(&[(Once, |_, _| BLACK), (AmbientToo, |_, at| at.ambient)]),
    row(
        "AmbientTimesDiffuse",
        "the ambient term is multiplied by k_d",
    )
    .changes(&[(Ambient, |x, at| mul(x, at.k_d))]),
    row(
        "UnlitWithoutLights",
        "without lights the surface is shown unlit: k_d is added",
    )
    .changes(&[(Once, |x, at| if at.is_unlit { add(x, at.k_d) } else { x })]),
    row("AmbientTimes", "the ambient term is multiplied by {}")
        .changes(&[(Ambient, |x, at| scale(x, at.number()))])
        .of(FACTORS),
    row("DiffuseTimes", "the diffuse term is multiplied by {}")
        .changes(&[(Diffuse, |x, at| scale(x, at.number()))])
        .of(FACTORS),
    row("HighlightTimes", "the highlight is multiplied by {}")
        .changes(&[(Specular, |x, at| scale(x, at.number()))])
        .of(FACTORS),
    row("LightTimes", "the color of a light is multiplied by {}")
        .changes(&[(Intensity, |x, at| scale(x, at.number()))])
        .of(FACTORS),
    // the sum, and the reply
    row("LightsAtMost", "lights beyond number {} are left out")
        .changes(&[(OfLight, |x, at| if at.i >= at.value { BLACK } else { x })])
        .of(&[
            4.0, 1.0, 2.0, 3.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0, 32.0, 64.0,
        ]),
    row("ChannelsSwapped", "red and blue are swapped").changes(&[(Sum, |[r, g, b], _| [b, g, r])]),
    row("Scaled", "all colors are multiplied by {}")
        .changes(&[(Sum, |x, at| scale(x, at.number()))])
        .of(&[0.5, 2.0, FRAC_1_PI, PI, 1.0 / 255.0, 255.0]),
    row(
        "SrgbOnceMore",
        "sRGB is applied once more than the profile says",
    )
    .changes(&[(Encode, |x, _| x.map(|c| exact(to_srgb(c.value))))]),
    row(
        "Gamma",
        "a gamma of {} is applied, not what the profile says",
    )
    .changes(&[(Encode, |_, at| {
        of_linear(at, |x| x.max(0.0).powf(1.0 / at.value))
    })])
    .of(&[1.0, 2.2, 2.0, 1.8, 2.4]),
    row("LevelsTruncated", "levels are truncated, not rounded").changes(&[(Level, |_, at| {
        let most = 1.0 / at.level.unwrap_or(1.0);
        of_linear(at, |x| (x * most).floor() / most)
    })]),
];
