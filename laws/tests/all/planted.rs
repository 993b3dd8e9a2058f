//! Every known mistake and some that are not known, in three kinds of renderers, at three seeds.

use std::time::Duration;

use shading_laws::{Fault, Laws, Mistake, Profile, Report};

use crate::by_hand::{Odd, Plan, renderer};

const SEEDS: [u64; 3] = [0, 1, 2];

fn single() -> Profile {
    Profile {
        most_shiny: 1024.0,
        ..Profile::default()
    }
}

fn double() -> Profile {
    Profile {
        roundoff: f64::EPSILON / 2.0,
        ..single()
    }
}

fn bytes() -> Profile {
    Profile {
        srgb: true,
        bits: Some(8),
        ..single()
    }
}

/// A mistake with the number that is planted at a seed: one of those that the laws try, and another at the next seed.
fn planted(mistake: Mistake, profile: &Profile, seed: u64) -> Option<Fault> {
    let values = mistake.values().iter();
    let mut faults: Vec<Fault> = values.map(|&value| Fault { mistake, value }).collect();
    if faults.is_empty() {
        faults.push(mistake.into());
    }
    faults.retain(|fault| shows(*fault, profile));
    let count = faults.len().max(1);
    faults.get(seed as usize % count).copied()
}

/// Whether a mistake can be seen in such a renderer at all.
fn shows(fault: Fault, profile: &Profile) -> bool {
    use Mistake::*;
    let is_bytes = profile.bits.is_some();
    match fault.mistake {
        // there is no sRGB to be wrong, or there are no levels
        SrgbTwice | SrgbForgotten | Gamma22ForSrgb | GammaForSrgb | SrgbWithoutToe
        | LevelsTruncated | LevelsRoundedUp | LevelsOf256 | LevelsOverflow | FewerBits
        | ClampForgotten => is_bytes,
        // what is already so; less than a level; the least of 1 and a sum, where no term is negative
        SrgbUnasked
        | Gamma22Unasked
        | GammaUnasked
        | ClampedUnasked
        | TermsClamped
        | DiffuseClamped
        | ColorsInSteps
        | ColorsCut
        | ColorsInHalf
        | ColorsInBfloat
        | LightsInSteps
        | LightsCut
        | LightsInHalf
        | LightsInBfloat
        | ReflectancesInSteps
        | ReflectancesCut
        | ReflectancesInHalf
        | ReflectancesInBfloat
        | DiffuseInSteps
        | DiffuseCut
        | DiffuseInHalf
        | DiffuseInBfloat
        | SpecularInSteps
        | SpecularCut
        | SpecularInHalf
        | SpecularInBfloat
        | InBits
        | ResultInSteps
        | ResultCut
        | ExpandedSquares
        | CosineOfHighlightAtLeast => !is_bytes,
        // as many as it says it has
        LightsAtMost => fault.value < 8.0,
        ShininessAtMost => fault.value < 1024.0,
        // less than a level
        // more steps are as precise as the renderer
        FastInverseRoot | FastInverseRootBesideLamps if is_bytes => fault.value < 2.0,
        FastInverseRoot | FastInverseRootBesideLamps => {
            fault.value < 3.0 || profile.roundoff < 1e-10
        }
        AttenuationCutBelow => !is_bytes || fault.value > 0.0035,
        DenominatorPlus => !is_bytes || fault.value > 0.05,
        DistanceAtLeast => !is_bytes || fault.value > 0.005,
        // the laws name it; it is planted as the precision that a renderer does not have
        Imprecise => false,
        _ => true,
    }
}

fn plans(profile: &Profile, seed: u64) -> Vec<Plan> {
    let named = Mistake::ALL.iter();
    let named = named.filter_map(|mistake| planted(*mistake, profile, seed));
    let named = named.map(|fault| Plan {
        faults: vec![fault],
        odd: None,
    });
    let mut odds = vec![
        Odd::DiffuseTimes(0.9),
        Odd::DiffuseTimes(1.2),
        Odd::Wrap(0.37),
        Odd::Wrap(0.05),
        Odd::CosineTo(1.3),
        Odd::CosineTo(0.8),
        Odd::PowerTable(64.0),
        Odd::PowerTable(256.0),
        Odd::Normals(6.0),
        Odd::Tilt(0.05),
        Odd::AttenuationTo(0.9),
        Odd::SoftEdge(0.1),
        Odd::ShininessTo(1.1),
        Odd::Red(1.1),
        Odd::Plus(0.02),
        Odd::Hue(0.1),
        Odd::Later(0.2),
        Odd::Banded(8.0),
        Odd::CosineAtLeast(0.05),
        Odd::LightSquared,
        Odd::GrayHighlight,
        Odd::DistanceAlongAxis,
        Odd::NoMoreThanOne,
        Odd::RedDecides,
        Odd::AmbientIfLit,
        Odd::PowerByBits,
        Odd::Fog(0.01),
        Odd::EyeForHalf,
    ];
    if profile.bits.is_none() {
        odds.extend([
            Odd::DiffuseTimes(1.001),
            Odd::PowerTable(4096.0),
            Odd::Normals(11.0),
            Odd::Normals(9.0),
            Odd::Tilt(0.001),
            Odd::Rounded(11.0),
            Odd::Rounded(8.0),
            Odd::SumCut(11.0),
            Odd::SumCut(8.0),
        ]);
    }
    let odds = odds.into_iter().map(|odd| Plan {
        faults: Vec::new(),
        odd: Some(odd),
    });
    named.chain(odds).collect()
}

#[derive(Default)]
struct Tally {
    planted: usize,
    missed: Vec<String>,
    right_first: usize,
    unnamed: Vec<String>,
    wrong_first: Vec<String>,
}

fn judge(plan: &Plan, report: &Report, tally: &mut Tally) {
    tally.planted += 1;
    if report.passes() {
        tally.missed.push(format!("{plan:?}"));
        return;
    }
    let first = report
        .findings
        .first()
        .and_then(|finding| finding.cause.as_ref());
    let Some(cause) = first else {
        tally.unnamed.push(format!("{plan:?}"));
        return;
    };
    let is_rough = |fault: &Fault| [Mistake::Imprecise, Mistake::InBits].contains(&fault.mistake);
    // small deviations to either side
    let is_roughness = matches!(
        plan.odd,
        Some(
            Odd::PowerTable(_)
                | Odd::Normals(_)
                | Odd::Rounded(_)
                | Odd::Banded(_)
                | Odd::Tilt(_)
                | Odd::PowerByBits
                | Odd::SumCut(_)
        )
    );
    let is_same = |faults: &Vec<Fault>| *faults == plan.faults;
    if is_same(&cause.mistakes) {
        tally.right_first += 1;
    } else if cause.alternatives.iter().any(is_same) {
        // the colors are the same
        tally
            .unnamed
            .push(format!("{plan:?} after {:?}", cause.mistakes));
    } else if is_roughness && cause.mistakes.iter().all(is_rough) {
        tally.right_first += 1;
    } else {
        tally
            .wrong_first
            .push(format!("{plan:?}: {:?}", cause.mistakes));
    }
}

fn measure(name: &str, profile: &Profile, seed: u64) {
    let mut tally = Tally::default();
    let laws = Laws::new().seed(seed).shrinking(0, Duration::ZERO);
    let prepared = laws.cases(64).prepared(profile);
    for plan in plans(profile, seed) {
        let report = prepared.run(&mut renderer(profile, plan.clone()));
        judge(&plan, &report.expect("colors"), &mut tally);
    }
    let Tally {
        planted,
        missed,
        right_first,
        unnamed,
        wrong_first,
    } = tally;
    // seen with --nocapture
    println!("unnamed: {unnamed:#?}");
    println!(
        "{name}, seed {seed}: {planted} planted, {} found, {right_first} with the right cause first, {} with a wrong one",
        planted - missed.len(),
        wrong_first.len(),
    );
    assert!(planted >= 150, "{planted} planted");
    assert!(missed.is_empty(), "missed: {missed:#?}");
    assert!(
        wrong_first.is_empty(),
        "wrong cause first: {wrong_first:#?}"
    );
    assert!(
        right_first * 10 >= planted * 7,
        "{right_first} of {planted} named"
    );
}

/// All seeds at once, so that each core is busy to the end.
fn at_each_seed(name: &str, profile: &Profile) {
    std::thread::scope(|scope| {
        for seed in SEEDS {
            scope.spawn(move || measure(name, profile, seed));
        }
    });
}

#[test]
fn mistakes_in_f32_are_found_and_named() {
    at_each_seed("f32", &single());
}

#[test]
fn mistakes_in_f64_are_found_and_named() {
    at_each_seed("f64", &double());
}

#[test]
fn mistakes_in_bytes_are_found_and_named() {
    at_each_seed("8-bit sRGB", &bytes());
}
