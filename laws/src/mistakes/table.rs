//! The table of mistakes: a row each, and operations that each of several ingredients may suffer.

use std::f64::consts::{FRAC_1_PI, PI};

#[allow(clippy::wildcard_imports)] // what the rows are made of
use super::*;
#[allow(clippy::enum_glob_use)]
use crate::formula::Part::*;
use crate::formula::{BLACK, Change};
use crate::profile::{from_srgb, to_srgb};
use crate::scene::{add, mul, sub, unit, Kind, Model, Number};

/// A name that does not change, what is wrong, the numbers that are tried for `{}`, and what changes where.
type Row = (&'static str, &'static str, &'static [f64], &'static [(Part, Change)]);

/// Which lights or models have a mistake, the whole first.
pub static SCOPES: [Scope; 11] = [
    Scope { id: "All", says: "", has: |_| true },
    Scope { id: "Suns", says: ", of directional lights only", has: |at| at.is_of(Kind::Directional) },
    Scope { id: "Points", says: ", of point lights only", has: |at| at.is_of(Kind::Point) },
    Scope { id: "Spots", says: ", of spots only", has: |at| at.is_of(Kind::Spot) },
    Scope { id: "Lamps", says: ", of point lights and spots only", has: |at| at.is_of(Kind::Point) || at.is_of(Kind::Spot) },
    Scope { id: "Phong", says: ", in Phong's model only", has: |at| at.model == Model::Phong },
    Scope { id: "Blinn", says: ", in Blinn's model only", has: |at| at.model == Model::BlinnPhong },
    Scope { id: "First", says: ", of the first light only", has: |at| at.light.is_some() && at.i == 0.0 },
    Scope { id: "Later", says: ", of all lights but the first", has: |at| at.light.is_some() && at.i > 0.0 },
    Scope { id: "Last", says: ", of the last light only", has: |at| at.light.is_some() && at.i + 1.0 == at.count },
    Scope { id: "Earlier", says: ", of all lights but the last", has: |at| at.light.is_some() && at.i + 1.0 < at.count },
];

const ENDS: &[f64] = &[10.0, 5.0, 8.0, 16.0, 20.0, 25.0, 32.0, 50.0, 64.0, 100.0, 200.0, 256.0, 500.0, 1000.0, 1024.0, 10000.0];

pub const ROWS: &[Row] = &[
    // N, L, V
    ("NormalNotNormalized", "N is not normalized after interpolation", &[], &[(N, |_, at| at.raw_n)]),
    ("NormalNotNormalizedInDiffuse", "N is not normalized in the diffuse term", &[], &[(Lambert, |_, at| one(dot(at.raw_n, at.l).at_least_zero()))]),
    ("NormalNotNormalizedInHighlight", "N is not normalized in the highlight", &[], &[(Cosine, |_, at| one(at.cosine_of(at.raw_n, at.l, 2.0)))]),
    ("NormalReversed", "N points into the surface", &[], &[(N, |x, _| minus(x))]),
    ("NormalTowardEye", "N is turned toward the eye, so the back of a surface is lit like its front", &[], &[(Side, |x, at| one(x[0] * side(at.v, at.n)))]),
    ("NormalTowardLight", "N is turned toward each light", &[], &[(OfThisLight, |x, at| scale(x, side(at.l, x)))]),
    ("NormalInSteps", "the components of N are rounded to multiples of 1/{}", &[127.0, 511.0, 127.5], &[(N, in_steps)]),
    ("NormalInStepsUnit", "the components of N are rounded to multiples of 1/{}, and N is normalized again", &[127.0, 511.0, 127.5], &[(N, |x, at| unit(in_steps(x, at)))]),
    ("ViewNotNormalized", "V is not normalized", &[], &[(V, |_, at| at.raw_v)]),
    ("ViewReversed", "V points from the eye to the surface", &[], &[(V, |x, _| minus(x))]),
    ("EyeAtOrigin", "the eye is taken to be at the origin: V = -p", &[], &[(V, |_, at| unit(minus(at.p)))]),
    ("ViewTakenForEye", "v is taken for the position of the eye: V = v - p", &[], &[(V, |_, at| unit(sub(at.raw_v, at.p)))]),
    ("ViewAlongZ", "V is always (0, 0, 1)", &[], &[(V, |_, _| [0.0, 0.0, 1.0].map(exact))]),
    ("LightNotNormalized", "L is not normalized", &[], &[(L, |_, at| at.way)]),
    ("LightNotNormalizedInDiffuse", "L is not normalized in the diffuse term", &[], &[(Lambert, |_, at| one(dot(at.n, at.way).at_least_zero()))]),
    ("LightNotNormalizedInHighlight", "L is not normalized in the highlight", &[], &[(Cosine, |_, at| one(at.cosine_of(at.n, at.way, 2.0)))]),
    ("LightReversed", "L points from the light to the surface", &[], &[(L, |x, _| minus(x))]),
    ("SunTakenForPosition", "the direction to a directional light is taken for a position, from which p is subtracted", &[], &[(L, |x, at| if at.light.is_some_and(|l| l.lamp().is_none()) { unit(sub(x, at.p)) } else { x })]),
    ("PointForgotten", "L is the position of the lamp, from which p is not subtracted", &[], &[(Way, |_, at| at.position)]),
    ("LengthPlus", "{} is added to the length by which a vector is normalized", &[1e-4, 1e-3, 1e-5, 1e-6],
        &[(N, |_, at| unit_by(at.raw_n, |q| q + at.number())), (V, |_, at| unit_by(at.raw_v, |q| q + at.number())), (Half, |_, at| unit_by(at.sum, |q| q + at.number())), (L, |x, at| lamp_by(x, at, |q| q + at.number()))]),
    ("LengthAtLeast", "the length by which a vector is normalized is at least {}", &[0.01, 0.001, 0.0001, 0.1],
        &[(N, |_, at| unit_by(at.raw_n, |q| q.at_least(at.value))), (V, |_, at| unit_by(at.raw_v, |q| q.at_least(at.value))), (Half, |_, at| unit_by(at.sum, |q| q.at_least(at.value))), (L, |x, at| lamp_by(x, at, |q| q.at_least(at.value)))]),
    ("PositionsInHalf", "positions are rounded to half precision", &[], &[(P, in_half), (Position, in_half)]),
    // attenuation
    ("DistanceFromOrigin", "the distance is that of the lamp to the origin, not to p", &[], &[(Q, |_, at| one(length(at.position)))]),
    ("SquaredDistance", "the attenuation gets q² for q", &[], &[(Q, |x, _| x.map(|q| q * q))]),
    ("ExpandedSquares", "the distance is computed from expanded squares, |a|² - 2a·b + |b|², which cancel", &[],
        &[(Q, |_, at| one((dot(at.position, at.position) - exact(2.0) * dot(at.position, at.p) + dot(at.p, at.p)).at_least_zero().root())), (L, |x, at| if at.light.is_some_and(|l| l.lamp().is_none()) { x } else { at.way.map(|c| c / at.q) })]),
    ("DistanceAtLeast", "the distance is at least {}", &[0.01, 0.001, 0.0001, 0.1, 0.25, 0.5, 1.0], &[(Q, |x, at| x.map(|q| q.at_least(at.value)))]),
    ("LampDistanceAtLeast", "the distance is at least {}, and L is the way to the lamp divided by it", &[0.01, 0.001, 0.1, 0.0001, 0.5, 1.0],
        &[(Q, |x, at| x.map(|q| q.at_least(at.value))), (L, |x, at| if at.light.is_some_and(|l| l.lamp().is_none()) { x } else { at.way.map(|c| c / at.q) })]),
    ("CoefficientsReversed", "the coefficients of the attenuation are in reverse order", &[], &[(Abc, |[a, b, c], _| [c, b, a])]),
    ("LinearForQuadratic", "b and c of the attenuation are exchanged", &[], &[(Abc, |[a, b, c], _| [a, c, b])]),
    ("ConstantForgotten", "the attenuation lacks a", &[], &[(Abc, |[_, b, c], _| [ZERO, b, c])]),
    ("LinearForgotten", "the attenuation lacks bq", &[], &[(Abc, |[a, _, c], _| [a, ZERO, c])]),
    ("QuadraticForgotten", "the attenuation lacks cq²", &[], &[(Abc, |[a, b, _], _| [a, b, ZERO])]),
    ("ConstantOne", "the attenuation takes 1 for a", &[], &[(Abc, |[_, b, c], _| [ONE, b, c])]),
    ("ZeroConstantOne", "the attenuation takes 1 for a where a is 0", &[], &[(Abc, |[a, b, c], _| [if a.value == 0.0 { ONE } else { a }, b, c])]),
    ("QuadraticByDistance", "the attenuation has cq for cq²", &[], &[(Denominator, |_, at| one(at.abc[0] + at.abc[1] * at.q + at.abc[2] * at.q))]),
    ("DenominatorPlus", "{} is added to a + bq + cq²", &[1.0, 0.1, 0.01, 0.001, 1e-4, 1e-5, 1e-6], &[(Denominator, |x, at| x.map(|c| c + at.number()))]),
    ("AttenuationInverted", "the light is multiplied by a + bq + cq², not divided", &[], &[(Falloff, |_, at| one(at.denominator))]),
    ("AttenuationRoot", "the attenuation is 1/√(a + bq + cq²)", &[], &[(Denominator, |x, _| x.map(Number::root))]),
    ("InverseSquareAlone", "the attenuation is 1/q², whatever a, b and c", &[], &[(Denominator, |_, at| one(at.q * at.q))]),
    ("InverseAlone", "the attenuation is 1/q, whatever a, b and c", &[], &[(Denominator, |_, at| one(at.q))]),
    ("NotAttenuated", "the light is not attenuated", &[], &[(Falloff, |_, _| one(ONE))]),
    ("AttenuationCutBelow", "an attenuation below {} is taken for 0", &[0.004, 0.01, 1.0 / 256.0, 1.0 / 255.0, 0.001, 0.005, 0.02, 0.05], &[(Falloff, |x, at| if_positive(x[0] - exact(at.value), x))]),
    ("CulledBeyond", "lamps farther away than {} are left out", &[1000.0, 2.0, 4.0, 5.0, 8.0, 10.0, 16.0, 20.0, 32.0, 50.0, 64.0, 100.0, 128.0, 256.0, 500.0, 512.0, 1024.0, 4096.0, 10000.0], &[(Falloff, |x, at| if_positive(exact(at.value) - at.q, x))]),
    ("Windowed", "the attenuation is windowed by (1 - (q/{})⁴)²", ENDS, &[(Falloff, |x, at| { let s = at.q / exact(at.value); let w = (ONE - s * s * (s * s)).at_least_zero(); scale(x, w * w) })]),
    ("FadedTo", "the attenuation fades by 1 - q/{}", ENDS, &[(Falloff, |x, at| scale(x, (ONE - at.q / exact(at.value)).at_least_zero()))]),
    ("HighlightNotAttenuated", "the highlight is not attenuated", &[], &[(ShinyFalloff, |_, _| one(ONE))]),
    ("HighlightAttenuatedTwice", "the highlight is attenuated twice", &[], &[(Specular, |x, at| scale(x, at.falloff))]),
    ("DiffuseNotAttenuated", "the diffuse term is not attenuated", &[], &[(MatteFalloff, |_, _| one(ONE))]),
    ("ArrivingClamped", "the light that arrives is clamped to 1", &[],
        &[(MatteLight, |x, at| scale(x, at.falloff).map(|c| c.at_most(1.0))), (MatteFalloff, |_, _| one(ONE)), (ShinyLight, |x, at| scale(x, at.falloff).map(|c| c.at_most(1.0))), (ShinyFalloff, |_, _| one(ONE))]),
    // cones
    ("DegreesForRadians", "the angle of the cone is taken for degrees", &[], &[(Angle, |x, at| one(at.given(x[0].value.to_radians())))]),
    ("HalfAngleHalved", "the half-angle of the cone is taken for the whole one, and halved", &[], &[(Angle, |x, _| scale(x, exact(0.5)))]),
    ("WholeAngleForHalf", "the whole angle of the cone is used where the half belongs", &[], &[(Angle, |x, _| scale(x, exact(2.0)))]),
    ("ConeBySine", "the edge of the cone is at the sine of its angle", &[], &[(Angle, |x, at| one(at.given(PI / 2.0 - x[0].value)))]),
    ("ConeAngleForCosine", "the angle of the cone is compared with a cosine", &[], &[(Edge, |_, at| one(at.given(at.spot().1)))]),
    ("ConeReversed", "the cone opens against its axis", &[], &[(Against, |x, _| minus(x))]),
    ("ConeForgotten", "the cone of a spot is ignored", &[], &[(Cone, |_, at| one(at.within))]),
    ("RightAngleForgotten", "the cone of a spot is ignored where its half-angle is 90°", &[], &[(Cone, |x, at| if at.spot().1.to_degrees() >= 89.99 { one(at.within) } else { x })]),
    ("ConeByWay", "the cone is tested with the way to the lamp, which is not normalized", &[], &[(Against, |_, at| one(-dot(at.spot().0, at.way)))]),
    ("ConeExponent", "the light of a spot falls off within its cone, as the cosine to the power of {}", &[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 3.0, 5.0, 10.0], &[(Within, |_, at| one(at.against.at_least_zero().power(at.value)))]),
    ("ConeFaded", "the light of a spot fades from its axis to its edge", &[], &[(Within, |_, at| one(within(at)))]),
    ("ConeSmooth", "the light of a spot fades from its axis to its edge, by smoothstep", &[], &[(Within, |_, at| { let t = within(at); one(t * t * (exact(3.0) - t - t)) })]),
    ("AngleTruncated", "the angle of the cone is cut to whole degrees", &[], &[(Edge, |_, at| edge_in_degrees(at, true))]),
    ("AngleRounded", "the angle of the cone is rounded to whole degrees", &[], &[(Edge, |_, at| edge_in_degrees(at, false))]),
    ("ConeNotOfHighlight", "the cone of a spot does not end its highlight", &[], &[(ShinyCone, |_, _| one(ONE))]),
    ("ConeNotOfDiffuse", "the cone of a spot does not end its diffuse light", &[], &[(MatteCone, |_, _| one(ONE))]),
    // the diffuse term
    ("DiffuseNotClamped", "N·L is not clamped to 0, so light from behind is subtracted", &[], &[(Lambert, |_, at| one(at.n_l))]),
    ("DiffuseTwoSided", "the diffuse term takes |N·L|, so light from behind is added", &[], &[(Lambert, |_, at| one(at.n_l.abs()))]),
    ("HalfLambert", "the diffuse term takes half-Lambert, (N·L + 1)/2", &[], &[(Lambert, |_, at| one((at.n_l + ONE) / exact(2.0)))]),
    ("HalfLambertSquared", "the diffuse term takes half-Lambert squared, ((N·L + 1)/2)²", &[], &[(Lambert, |_, at| { let h = (at.n_l + ONE) / exact(2.0); one(h * h) })]),
    ("Wrapped", "the diffuse term is wrapped: (N·L + {})/(1 + {})", &[0.5, 0.25, 0.2, 0.1, 0.3, 0.4, 0.6, 0.75], &[(Lambert, |_, at| one(((at.n_l + at.number()) / (ONE + at.number())).at_least_zero()))]),
    ("CosineForgotten", "the diffuse term is not multiplied by N·L", &[], &[(Lambert, |_, at| one(at.n_l.if_positive(ONE, ZERO)))]),
    ("DiffuseMinusSpecular", "the diffuse term is multiplied by 1 - k_s", &[], &[(Diffuse, |x, at| mul(x, at.k_s.map(|c| ONE - c)))]),
    ("DiffuseMinusLargest", "the diffuse term is multiplied by 1 - the largest channel of k_s", &[], &[(Diffuse, |x, at| scale(x, ONE - at.k_s[0].max(at.k_s[1]).max(at.k_s[2])))]),
    ("DiffuseWithoutLight", "the diffuse term does not have the color of the light", &[], &[(MatteLight, |_, _| one(ONE))]),
    ("DiffuseBySpecular", "the diffuse term takes k_s for k_d", &[], &[(Kd, |_, at| at.k_s)]),
    ("LightClampedBelow", "each light is clamped at 0, in place of its N·L: light from behind is subtracted from its highlight", &[],
        &[(Lambert, |_, at| one(at.n_l)), (Gate, |_, _| one(ONE)), (OfLight, |x, _| x.map(Bounded::at_least_zero))]),
    ("TotalClampedBelow", "the sum of the light is clamped at 0, in place of N·L: light from behind is subtracted from that of others", &[],
        &[(Lambert, |_, at| one(at.n_l)), (Sum, |x, _| x.map(Bounded::at_least_zero))]),
    // the highlight
    ("HighlightNotGated", "the highlight is not gated on N·L > 0, so faces turned away from a light have one", &[], &[(Gate, |_, _| one(ONE))]),
    ("HighlightGatedOnEye", "the highlight needs N·V > 0", &[], &[(Specular, |x, at| if_positive(dot(at.n, at.v), x))]),
    ("ReflectionReversed", "R points the wrong way: reflect() of GLSL and HLSL takes −L", &[], &[(Cosine, |x, at| if at.model == Model::Phong { minus(x) } else { x })]),
    ("ReflectionWithoutTwo", "R lacks the factor 2 of 2(N·L)N - L", &[], &[(Cosine, |x, at| if at.model == Model::Phong { one(at.cosine_of(at.n, at.l, 1.0)) } else { x })]),
    ("HalfVectorNotNormalized", "H = L + V is not normalized", &[], &[(Half, |_, at| at.sum)]),
    ("HalfVectorHalved", "H = (L + V)/2 is not normalized: half of a sum is not its direction", &[], &[(Half, |_, at| scale(at.sum, exact(0.5)))]),
    ("HalfVectorUnguarded", "H is NaN where L = -V: the length of L + V is not checked before the division", &[], &[(OfLight, |x, at| if at.sum.iter().all(|c| c.value.abs() <= c.error) { one(exact(f64::NAN).looser(f64::INFINITY)) } else { x })]),
    ("EyeForHalf", "Blinn's highlight takes N·V for N·H", &[], &[(Half, |_, at| at.v)]),
    ("LightForHalf", "the highlight takes N·L for its cosine", &[], &[(Cosine, |_, at| one(at.n_l))]),
    ("OtherModel", "Phong's highlight is used for Blinn's, or Blinn's for Phong's", &[], &[(Part::Model, |x, _| x.map(|m| if m.value > 0.0 { exact(3.0) - m } else { m }))]),
    ("HighlightOnLambert", "Lambert's surfaces have a highlight", &[], &[(Part::Model, |x, _| x.map(|m| if m.value > 0.0 { m } else { exact(2.0) }))]),
    ("PowerNotClamped", "the cosine of the highlight is not clamped to 0 before the power", &[], &[(Power, |_, at| one(if at.cosine.value < at.cosine.error && at.m.fract() != 0.0 {
        Bounded::UNKNOWN // a shader's power of a negative number may be anything
    } else if at.cosine.value < 0.0 && at.m % 2.0 == 1.0 { -at.cosine.abs().power(at.m) } else { at.cosine.abs().power(at.m) }))]),
    ("CosineOfHighlightAbsolute", "the highlight takes the absolute value of its cosine", &[], &[(Cosine, |x, _| x.map(Bounded::abs))]),
    ("CosineOfHighlightAtLeast", "the cosine of the highlight is at least {}", &[0.00001, 0.0001, 0.001, 0.01, 0.000_001], &[(Cosine, |x, at| x.map(|c| c.at_least_zero().at_least(at.value)))]),
    ("PowerOfSchlick", "the power is Schlick's approximation, c/(m - mc + c)", &[], &[(Power, |_, at| { let (c, m) = (at.cosine.at_least_zero(), at.given(at.m)); one(c / (m - m * c + c)) })]),
    ("NormalizedByEight", "the highlight is normalized by (m + 8)/(8π)", &[], &[(Power, |x, at| normalized(x, at, |m| (m + 8.0) / (8.0 * PI)))]),
    ("NormalizedByTwo", "the highlight is normalized by (m + 2)/(2π)", &[], &[(Power, |x, at| normalized(x, at, |m| (m + 2.0) / (2.0 * PI)))]),
    ("NormalizedByOne", "the highlight is normalized by (m + 1)/(2π)", &[], &[(Power, |x, at| normalized(x, at, |m| (m + 1.0) / (2.0 * PI)))]),
    ("NormalizedByTwoOfEight", "the highlight is normalized by (m + 2)/(8π)", &[], &[(Power, |x, at| normalized(x, at, |m| (m + 2.0) / (8.0 * PI)))]),
    ("NormalizedExactly", "the highlight is normalized by (m + 2)(m + 4)/(8π(2^(-m/2) + m))", &[], &[(Power, |x, at| normalized(x, at, |m| (m + 2.0) * (m + 4.0) / (8.0 * PI * ((-m / 2.0).exp2() + m))))]),
    ("Fresnel", "k_s has a Fresnel term, k_s + (1 - k_s)(1 - V·H)⁵", &[], &[(Reflectance, |x, at| fresnel(x, dot(at.v, unit(at.sum))))]),
    ("FresnelOfEye", "k_s has a Fresnel term, k_s + (1 - k_s)(1 - N·V)⁵", &[], &[(Reflectance, |x, at| fresnel(x, dot(at.n, at.v).at_least_zero()))]),
    ("HighlightTimesDiffuse", "k_s is multiplied by k_d", &[], &[(Ks, |x, at| mul(x, at.k_d))]),
    ("HighlightByDiffuse", "the highlight takes k_d for k_s", &[], &[(Ks, |_, at| at.k_d)]),
    ("HighlightWithoutMaterial", "the highlight is not multiplied by k_s", &[], &[(Ks, |_, _| one(ONE))]),
    ("HighlightWithoutLight", "the highlight does not have the color of the light", &[], &[(ShinyLight, |_, _| one(ONE))]),
    ("HighlightTimesCosine", "the highlight is multiplied by N·L", &[], &[(Specular, |x, at| scale(x, at.n_l.at_least_zero()))]),
    ("HighlightOverCosine", "the highlight is divided by N·L", &[], &[(Specular, |x, at| if_positive(at.n_l, x.map(|c| c / at.n_l)))]),
    ("ShininessTruncated", "the shininess is cut to an integer", &[], &[(M, |x, _| x.map(|m| exact(m.value.floor())))]),
    ("ShininessRounded", "the shininess is rounded to an integer", &[], &[(M, |x, _| x.map(|m| exact(m.value.round())))]),
    ("ShininessOff", "the shininess is off by {}", &[1.0, -1.0, 2.0, 0.5], &[(M, |x, at| x.map(|m| exact((m.value + at.value).max(0.0))))]),
    ("ShininessTimes", "the shininess is multiplied by {}", &[4.0, 2.0, 0.5, 0.25, 3.0, 128.0], &[(M, |x, at| x.map(|m| exact(m.value * at.value)))]),
    ("ShininessAtMost", "the shininess is at most {}", &[128.0, 127.0, 100.0, 64.0, 50.0, 32.0, 96.0, 120.0, 200.0, 255.0, 256.0, 500.0, 512.0, 1000.0, 1024.0, 2048.0], &[(M, |x, at| x.map(|m| m.at_most(at.value)))]),
    ("ShininessAtLeast", "the shininess is at least {}", &[2.0, 5.0, 10.0, 4.0, 8.0, 16.0], &[(M, |x, at| x.map(|m| m.at_least(at.value)))]),
    ("ShininessToPowerOfTwo", "the shininess is cut to a power of two", &[], &[(M, |x, _| x.map(|m| exact(m.value.log2().floor().exp2())))]),
    // the ambient term
    ("AmbientPerLight", "the ambient term is added once for each light", &[], &[(Once, |_, _| BLACK), (AmbientToo, |_, at| at.ambient)]),
    ("AmbientPerLightToo", "the ambient term is added once more for each light", &[], &[(AmbientToo, |_, at| at.ambient)]),
    ("AmbientPerLightInFront", "the ambient term is added once for each light with N·L > 0", &[], &[(Once, |_, _| BLACK), (AmbientToo, |_, at| if_positive(at.n_l, at.ambient))]),
    ("AmbientPerLightInFrontToo", "the ambient term is added once more for each light with N·L > 0", &[], &[(AmbientToo, |_, at| if_positive(at.n_l, at.ambient))]),
    ("AmbientArriving", "the ambient term is added for each light, attenuated and within its cone", &[], &[(Once, |_, _| BLACK), (AmbientToo, |_, at| scale(at.ambient, at.falloff * at.cone))]),
    ("AmbientAttenuated", "the ambient term is added for each light, attenuated", &[], &[(Once, |_, _| BLACK), (AmbientToo, |_, at| scale(at.ambient, at.falloff))]),
    ("AmbientByDiffuse", "the ambient term takes k_d for k_a", &[], &[(Ka, |_, at| at.k_d)]),
    ("AmbientTimesDiffuse", "the ambient term is multiplied by k_d", &[], &[(Ambient, |x, at| mul(x, at.k_d))]),
    ("AmbientWithoutMaterial", "the ambient term is not multiplied by k_a", &[], &[(Ka, |_, _| one(ONE))]),
    ("AmbientWithoutLight", "the ambient term is not multiplied by I_a", &[], &[(Ia, |_, _| one(ONE))]),
    ("BlackWithoutLights", "without lights there is no ambient term", &[], &[(Once, |x, at| if at.count == 0.0 { BLACK } else { x })]),
    ("UnlitWithoutLights", "without lights the surface is shown unlit: k_d is added", &[], &[(Once, |x, at| if at.count == 0.0 { add(x, at.k_d) } else { x })]),
    ("AmbientAtLeast", "the ambient term is the least color, in place of a term of the sum", &[], &[(Sum, |_, at| max(at.ambients, at.lit))]),
    // lights
    ("LightsAtMost", "only the first {} lights count", &[4.0, 2.0, 3.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0, 32.0, 64.0], &[(OfLight, |x, at| if at.i >= at.value { BLACK } else { x })]),
    ("BrightestLightOnly", "the brightest light is taken, in place of the sum", &[], &[(OfLight, |x, at| sub(max(x, at.lit), at.lit))]),
    ("LightsAssigned", "each light replaces the color, in place of adding to it: = for +=", &[], &[(OfLight, |x, at| if_positive(at.n_l, sub(x, add(at.lit, at.ambients))))]),
    ("LightsAveraged", "the light is divided by the number of lights", &[], &[(Sum, |_, at| add(at.ambients, at.lit.map(|c| c / exact(at.count.max(1.0)))))]),
    ("CosineCutBelow", "light with N·L below {} is left out", &[0.01, 0.001, 0.0001, 0.00001, 0.05, 0.1], &[(OfLight, |x, at| if_positive(at.n_l - at.number(), x))]),
    ("LitFromEyeOnly", "only a surface that faces the eye is lit: light needs N·V > 0", &[], &[(OfLight, |x, at| if_positive(dot(at.n, at.v), x))]),
    ("EachLightClamped", "each light is clamped before the sum, in place of the sum", &[], &[(OfLight, |x, at| at.clamped(x)), (Clamp, |_, at| of_linear(at, |x| x))]),
    ("EachLightEncoded", "each light is encoded as sRGB before the sum", &[],
        &[(Once, |x, _| x.map(|c| c.map(to_srgb))), (OfLight, |x, _| x.map(|c| c.map(to_srgb))), (Encode, |_, at| of_linear(at, |x| x)), (Clamp, |_, at| of_linear(at, |x| x))]),
    // the sum
    ("TermsClamped", "diffuse and specular light are clamped before the sum", &[], &[(Sum, |_, at| add(at.ambients, add(at.clamped(at.diffuse), at.clamped(at.specular))))]),
    ("DiffuseClamped", "ambient and diffuse light are clamped before the highlight is added", &[], &[(Sum, |_, at| add(at.clamped(add(at.ambients, at.diffuse)), at.specular))]),
    ("ChannelsSwapped", "red and blue are swapped", &[], &[(Sum, |[r, g, b], _| [b, g, r])]),
    ("RedAndGreenSwapped", "red and green are swapped", &[], &[(Sum, |[r, g, b], _| [g, r, b])]),
    ("GreenAndBlueSwapped", "green and blue are swapped", &[], &[(Sum, |[r, g, b], _| [r, b, g])]),
    ("ChannelsShifted", "channels are {} places away", &[1.0, 2.0], &[(Sum, |[r, g, b], at| if at.value > 1.0 { [g, b, r] } else { [b, r, g] })]),
    ("Gray", "colors are gray: the mean of the channels", &[], &[(Sum, |x, _| mean(x))]),
    ("Luminance", "colors are gray: the luminance", &[], &[(Sum, |x, at| one(dot(x, [0.2126, 0.7152, 0.0722].map(|w| at.given(w)))))]),
    ("Scaled", "all colors are multiplied by {}", &[0.5, 2.0, FRAC_1_PI, PI, 1.0 / 255.0, 255.0, 4.0, 0.25], &[(Sum, times)]),
    ("Black", "all colors are black", &[], &[(Sum, |_, _| BLACK)]),
    ("Reinhard", "colors are mapped by c/(1 + c)", &[], &[(Sum, |x, _| x.map(|c| c / (ONE + c)))]),
    ("ExponentialTone", "colors are mapped by 1 - exp(-c)", &[], &[(Sum, |x, at| x.map(|c| c.map(|x| 1.0 - (-x).exp()).looser(4.0 * at.how.u)))]),
    // the reply
    ("ClampedUnasked", "colors are clamped to [0, 1], which the profile does not say", &[], &[(Clamp, |x, _| x.map(|c| exact(c.value.clamp(0.0, 1.0))))]),
    ("ClampForgotten", "colors are not clamped to the range of the profile", &[], &[(Clamp, |_, at| of_linear(at, |x| x))]),
    ("SrgbUnasked", "sRGB is applied where linear light was promised", &[], &[(Encode, |_, at| of_linear(at, to_srgb))]),
    ("SrgbTwice", "sRGB is applied twice", &[], &[(Encode, |x, _| x.map(|c| exact(to_srgb(c.value))))]),
    ("SrgbForgotten", "sRGB is not applied: the colors are linear", &[], &[(Encode, |_, at| of_linear(at, |x| x))]),
    ("SrgbDecoded", "colors are decoded from sRGB where they should be encoded", &[], &[(Encode, |_, at| of_linear(at, from_srgb))]),
    ("SrgbWithoutToe", "sRGB is encoded without its linear part: max(0, 1.055 x^(1/2.4) - 0.055)", &[], &[(Encode, |_, at| of_linear(at, |x| (1.055 * x.max(0.0).powf(1.0 / 2.4) - 0.055).max(0.0)))]),
    ("Gamma", "a gamma of {} is applied, not what the profile says", &[2.2, 2.0, 1.8, 2.4], &[(Encode, |_, at| gamma(at, at.value))]),
    ("ResultInSteps", "colors are rounded to multiples of 1/{}", &[256.0, 255.0, 65536.0, 65535.0, 1024.0], &[(Encode, |x, at| x.map(|c| exact((c.value * at.value).round() / at.value)))]),
    ("ResultCut", "colors are cut to multiples of 1/{}", &[256.0, 255.0, 65536.0, 4096.0], &[(Encode, |x, at| x.map(|c| exact((c.value * at.value).floor() / at.value)))]),
    ("LevelsTruncated", "levels are truncated, not rounded", &[], &[(Level, |_, at| level(at, |x, most| (x * most).floor()))]),
    ("LevelsRoundedUp", "levels are rounded up", &[], &[(Level, |_, at| level(at, |x, most| (x * most).ceil()))]),
    ("LevelsOf256", "levels are taken by 256, not 255", &[], &[(Level, |_, at| level(at, |x, most| (x * (most + 1.0)).floor().min(most)))]),
    ("LevelsOverflow", "levels above the largest wrap around to 0", &[], &[(Clamp, |_, at| of_linear(at, |x| x)), (Level, |_, at| level(at, |x, most| (x * most).round().rem_euclid(most + 1.0)))]),
    ("FewerBits", "colors have only {} bits", &[5.0, 6.0, 7.0, 4.0], &[(Level, |_, at| level(at, |x, most| { let few = at.value.exp2() - 1.0; ((x * few).round() / few * most).round() }))]),
    // what is no change of one ingredient
    ("InBits", "colors are computed in {} bits; half precision has 11, bfloat 8", &[8.0, 11.0], &[]),
    ("Imprecise", "it behaves like a roundoff of 2^-{}, lower than the profile says, as half precision, bfloat, a table or a fast inverse root would",
        &[24.0, 22.0, 20.0, 18.0, 16.0, 14.0, 13.0, 12.0, 11.0, 10.0, 9.0, 8.0, 7.0], &[]),
    ("Leak", "a scene changes the color of the scenes after it", &[], &[]),
    ("NotRepeatable", "the same scene, asked again, has another color", &[], &[]),
];

type Ingredient = (&'static str, &'static str, &'static [Part]);
const TERMS: &[Ingredient] = &[
    ("Ambient", "the ambient term", &[Ambient]),
    ("Diffuse", "the diffuse term", &[Diffuse]),
    ("Highlight", "the highlight", &[Specular]),
];
const LIGHT: &[Ingredient] = &[("Light", "the color of a light", &[Intensity])];
const REFLECTANCES: &[Ingredient] = &[
    ("Reflectance", "each reflectance", &[Ka, Kd, Ks]),
    ("DiffuseReflectance", "k_d", &[Kd]),
    ("SpecularReflectance", "k_s", &[Ks]),
];
const COLORS: &[Ingredient] = &[("Color", "each color that is given", &[Intensity, Ia, Ka, Kd, Ks])];
const FACTORS: &[Ingredient] = &[
    ("Attenuation", "the attenuation", &[Falloff]),
    ("Cosine", "N·L", &[Lambert]),
    ("Power", "the power of the highlight", &[Power]),
];
const STEPS: &[f64] = &[255.0, 256.0, 128.0, 1024.0, 65535.0, 65536.0, 64.0];

/// What each of some ingredients may suffer.
type Operation = (&'static str, &'static str, &'static [f64], Change, &'static [&'static [Ingredient]]);

pub const OPERATIONS: &[Operation] = &[
    ("Times", "is multiplied by {}", &[0.5, 2.0, FRAC_1_PI, PI, 0.25, 4.0, FRAC_1_PI / 4.0, 4.0 * PI, 0.1, 10.0], times, &[TERMS, LIGHT]),
    ("Forgotten", "is missing", &[], |_, _| BLACK, &[TERMS, LIGHT]),
    ("AtMost", "is at most {}", &[1.0, 2.0, 4.0, 10.0, 100.0, 0.5], |x, at| x.map(|c| c.at_most(at.value)), &[TERMS, LIGHT, FACTORS]),
    ("AtLeast", "is at least {}", &[0.01, 0.05, 0.1, 0.2, 0.25, 0.5, 0.001], |x, at| x.map(|c| c.at_least(at.value)), &[FACTORS]),
    ("Squared", "is squared", &[], |x, _| mul(x, x), &[TERMS, LIGHT, FACTORS]),
    ("InGray", "has the mean of its channels", &[], |x, _| mean(x), &[TERMS, LIGHT, REFLECTANCES]),
    ("InRed", "has its red in all channels", &[], |x, _| one(x[0]), &[TERMS, LIGHT, REFLECTANCES]),
    ("InSteps", "is rounded to multiples of 1/{}", STEPS, in_steps, &[LIGHT, REFLECTANCES, COLORS, FACTORS]),
    ("Cut", "is cut to multiples of 1/{}", &[256.0, 255.0, 65536.0, 4096.0], |x, at| stored(x, at, |c| (c * at.value).floor() / at.value), &[LIGHT, REFLECTANCES, COLORS]),
    ("InHalf", "is rounded to half precision", &[], in_half, &[LIGHT, REFLECTANCES, COLORS]),
    ("InBfloat", "is rounded to bfloat", &[], |x, at| stored(x, at, |c| rounded(c, (-8_f64).exp2())), &[LIGHT, REFLECTANCES, COLORS]),
    ("Decoded", ", which is linear, is decoded from sRGB", &[], |x, _| x.map(|c| c.map(from_srgb)), &[LIGHT, REFLECTANCES]),
    ("Gamma22", ", which is linear, is raised to the power of 2.2", &[], |x, _| x.map(|c| c.power(2.2)), &[LIGHT, REFLECTANCES]),
];
