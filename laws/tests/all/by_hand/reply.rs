//! The color as the renderer replies it.

use shading_laws::{Mistake, Profile};

use super::float::{Float, Vec3};
use super::plan::Plan;

pub fn srgb(x: f64) -> f64 {
    if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * x.powf(1.0 / 2.4) - 0.055
    }
}

pub fn from_srgb(x: f64) -> f64 {
    if x <= 0.040_45 {
        x / 12.92
    } else {
        ((x + 0.055) / 1.055).powf(2.4)
    }
}

/// What becomes of linear light on its way out.
pub fn encoded<T: Float>(sum: Vec3<T>, profile: &Profile, plan: &Plan) -> [f64; 3] {
    use Mistake::*;
    let is = |mistake| plan.faults.iter().any(|fault| fault.mistake == mistake);
    let value = |mistake| {
        let fault = plan.faults.iter().find(|fault| fault.mistake == mistake);
        fault.map(|fault| fault.value)
    };
    let range = profile.clamps.or(profile.bits.map(|_| [0.0, 1.0]));
    let keeps =
        is(EachLightClamped) || is(ClampForgotten) || is(LevelsOverflow) || is(EachLightEncoded);
    let clamp = |c: f64| match range {
        // as in a shader, NaN becomes the lower end
        Some([low, high]) if !keeps => f64::min(f64::max(c, low), high),
        None if is(ClampedUnasked) => c.clamp(0.0, 1.0),
        _ => c,
    };
    sum.map(|c| {
        let c = clamp(c.get());
        let is_encoded = profile.srgb && !is(SrgbForgotten) || is(SrgbUnasked);
        let c = match () {
            () if is(EachLightEncoded) => c,
            () if is(Gamma22ForSrgb) && profile.srgb => c.max(0.0).powf(1.0 / 2.2),
            () if is(Gamma22Unasked) && !profile.srgb => c.max(0.0).powf(1.0 / 2.2),
            () if !profile.srgb && is(GammaUnasked) => {
                c.max(0.0).powf(1.0 / value(GammaUnasked).unwrap_or(1.0))
            }
            () if is(SrgbDecoded) => from_srgb(c),
            () if is_encoded && is(SrgbWithoutToe) => (1.055 * c.powf(1.0 / 2.4) - 0.055).max(0.0),
            () if is_encoded => match value(GammaForSrgb) {
                Some(gamma) => c.powf(1.0 / gamma),
                None if is(SrgbTwice) => srgb(srgb(c)),
                None => srgb(c),
            },
            () => c,
        };
        let c = match (value(ResultInSteps), value(ResultCut)) {
            (Some(steps), _) => (c * steps).round() / steps,
            (_, Some(steps)) => (c * steps).floor() / steps,
            _ => c,
        };
        // in the precision of the renderer
        let c = T::of(clamp(c)).get();
        let Some(count) = profile.bits.map(|bits| f64::from(bits).exp2() - 1.0) else {
            return c;
        };
        match () {
            () if is(LevelsTruncated) => (c * count).floor() / count,
            () if is(LevelsRoundedUp) => (c * count).ceil() / count,
            () if is(LevelsOf256) => (c * (count + 1.0)).floor().min(count) / count,
            () if is(LevelsOverflow) => (c * count).round().rem_euclid(count + 1.0) / count,
            () => match value(FewerBits) {
                Some(bits) => {
                    let few = bits.exp2() - 1.0;
                    ((c * few).round() / few * count).round() / count
                }
                None => (c * count).round() / count,
            },
        }
    })
}
