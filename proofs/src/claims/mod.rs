//! The promises of the documentation, for every input that they speak of.

#![allow(clippy::wildcard_imports)] // each table of claims uses nearly all that is here

mod constructors;
mod derived;
mod duals;
mod lights;
mod normals;
mod sums;
mod terms;
mod vectors;

use shading::{
    Attenuation, Cone, IncidentLight, Material, PointLight, Ranged, Real, Rgb, SoftCone,
};
use shading::{UnitVec3, Vec3};
use shading_proofs::{Format, Given, Goal, Range, Term};

pub struct Claim {
    pub name: &'static str,
    pub promise: &'static str,
    pub formula: fn(Given) -> Vec<Goal>,
}

pub fn all() -> impl Iterator<Item = &'static Claim> {
    [
        vectors::CLAIMS,
        constructors::CLAIMS,
        duals::CLAIMS,
        normals::CLAIMS,
        terms::CLAIMS,
        lights::CLAIMS,
        sums::CLAIMS,
    ]
    .into_iter()
    .flatten()
}

/// The claims that intervals leave open, and Bitwuzla decides.
pub fn solved() -> impl Iterator<Item = &'static Claim> {
    derived::CLAIMS.iter()
}

macro_rules! claims {
    ($($name:ident: $promise:literal |$given:pat_param| $body:expr)*) => {
        pub const CLAIMS: &[super::Claim] = &[$(super::Claim {
            name: stringify!($name),
            promise: $promise,
            formula: |$given| $body,
        }),*];
    };
}
use claims;

const INF: f64 = f64::INFINITY;
const UP_TO_ONE: Range = Range {
    low: 0.0,
    high: 1.0,
    nan: false,
    minus_zero: true,
    finite: true,
};

fn finite(given: Given) -> Range {
    Range::within(-given.format().max(), given.format().max())
}
fn not_negative(given: Given) -> Range {
    Range::within(0.0, given.format().max())
}
/// 0 or ∞ or anything between them: light.
fn light() -> Range {
    Range::within(0.0, INF)
}
fn any_vector(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, Range::ANY)
}
fn any_direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(any_vector(given, name))
}
/// Any vector with one component of a kind, whichever it is.
fn with_one(given: Given, name: &str, kind: Range) -> Vec3<Term> {
    let (mut v, one) = (
        any_vector(given, name),
        given.number(&format!("{name}'"), kind),
    );
    *[&mut v.x, &mut v.y, &mut v.z][given.one_of(3) as usize] = one;
    v
}
/// A component is infinite or NaN, and the others are anything.
fn broken(given: Given, name: &str) -> Vec3<Term> {
    with_one(given, name, Range::NOT_FINITE)
}
fn nan_direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(with_one(given, name, Range::NAN))
}
fn broken_direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(broken(given, name))
}
/// The zero vector, whatever the signs of its zeros.
fn zero(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, Range::within(0.0, 0.0))
}

fn within(terms: impl IntoIterator<Item = Term>, range: Range) -> Vec<Goal> {
    terms
        .into_iter()
        .map(|term| Goal::Within(term, range))
        .collect()
}
fn components(v: impl Into<Vec3<Term>>, range: Range) -> Vec<Goal> {
    let v = v.into();
    within([v.x, v.y, v.z], range)
}
fn channels(color: Rgb<Term>, range: Range) -> Vec<Goal> {
    within([color.r, color.g, color.b], range)
}
fn same(a: impl Into<[Term; 3]>, b: impl Into<[Term; 3]>) -> Vec<Goal> {
    a.into()
        .into_iter()
        .zip(b.into())
        .map(|(a, b)| Goal::Same(a, b))
        .collect()
}
/// `None`, or a vector of finite components.
fn none_or_finite(given: Given, n: Option<UnitVec3<Term>>) -> Vec<Goal> {
    n.map_or(vec![], |n| components(n, finite(given)))
}
fn none<T>(result: Option<T>) -> Vec<Goal> {
    result.map_or(vec![], |_| vec![Goal::Never])
}

/// Divides a claim into cases, of which each is proved: whether a difference is too large or too small to be squared, and
/// whether it vanishes. Returns it as the formulas rescale it.
fn decide_scale(from: Vec3<Term>, to: Vec3<Term>) -> Vec3<Term> {
    let plain = (to - from).dot(to - from);
    let _ = [plain > Term::EXTREME, Term::ONE / Term::EXTREME > plain];
    let (rescaled, _) = Term::rescaled_difference(to.into(), from.into());
    let _ = Term::dot(rescaled, rescaled) > Term::ZERO;
    rescaled.into()
}

fn coefficients(given: Given) -> [Term; 3] {
    let a = given.number("a", Range::unsigned(0.0, given.format().max())); // `new` adds 0 to a
    [a, given.not_negative("b"), given.not_negative("c")]
}
fn attenuation(given: Given) -> Attenuation<Term> {
    attenuation_of(coefficients(given))
}
fn attenuation_of(coefficients: [Term; 3]) -> Attenuation<Term> {
    let mut fields = coefficients.into_iter();
    Attenuation::<f32>::NONE.cast(|_| fields.next().unwrap())
}
fn ranged(given: Given, r: Range) -> Ranged<Term> {
    let mut fields = coefficients(given)
        .into_iter()
        .chain([given.number("r", r)]);
    Attenuation::<f32>::NONE
        .within(1.0)
        .unwrap()
        .cast(|_| fields.next().unwrap())
}
/// Any range that `Attenuation::within` takes.
fn any_ranged(given: Given) -> Ranged<Term> {
    ranged(given, Range::within(given.format().tiny(), INF))
}
fn cone(cosine: Term) -> Cone<Term> {
    Cone::<f32>::from_cosine(0.5).unwrap().cast(|_| cosine)
}
/// How far below −1 a cosine may be stored.
fn slack(given: Given) -> f64 {
    16.0 * given.format().u()
}
/// Cosines as `SoftCone` stores them: the inner one is not below the outer one.
fn soft_cone(given: Given) -> SoftCone<Term> {
    let stored = Range::within(-1.0 - slack(given), 1.0);
    let (inner, outer) = (given.number("inner", stored), given.number("outer", stored));
    given.assume_at_most(outer, inner);
    soft_cone_of(inner, outer)
}
fn soft_cone_of(inner: Term, outer: Term) -> SoftCone<Term> {
    let mut fields = [inner, outer].into_iter();
    SoftCone::<f32>::from_cosines(0.9, 0.5)
        .unwrap()
        .cast(|_| fields.next().unwrap())
}
fn material(given: Given, m: u32) -> Material<Term, u32> {
    Material {
        k_a: given.rgb("k_a"),
        k_d: given.rgb("k_d"),
        k_s: given.rgb("k_s"),
        m,
    }
}
/// A light that arrives along a direction of length 1.
fn incident(given: Given, name: &str) -> IncidentLight<Term> {
    let intensity = given.rgb(&format!("{name}.intensity"));
    IncidentLight {
        l: given.unit(name),
        intensity,
        distance: given.not_negative("distance"),
    }
}
fn lamp(given: Given, position: Vec3<Term>) -> PointLight<Term> {
    PointLight {
        position,
        intensity: given.rgb("I"),
        attenuation: attenuation(given),
    }
}
fn number(x: f64) -> Term {
    Term::of(x)
}
fn is_single(given: Given) -> bool {
    given.format() == Format::F32
}
