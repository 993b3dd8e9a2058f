//! What claims are about, and what they say of it.

use shading::{Attenuation, Cone, DirectionalLight, IncidentLight, Material, PointLight, Real};
use shading::{Rgb, SpotLight, UnitVec3, Vec3};
use shading_proofs::{Given, Goal, Range, Term};

pub const INF: f64 = f64::INFINITY;

/// 0 or ∞ or anything between them: light.
pub fn light() -> Range {
    Range::within(0.0, INF)
}

pub fn share() -> Range {
    Range::within(0.0, 1.0)
}

pub fn nothing() -> Range {
    Range::within(0.0, 0.0)
}

/// The components of a direction: no more than a quarter above 1, whatever rounding does to subnormal vectors.
pub fn component() -> Range {
    Range::within(-1.25, 1.25)
}

pub fn finite(given: Given) -> Range {
    Range::within(-given.format().max(), given.format().max())
}

pub fn not_negative(given: Given) -> Range {
    Range::within(0.0, given.format().max())
}

/// Below 0, infinite or NaN.
pub fn invalid(given: Given, name: &str) -> Term {
    let below = Range::within(-INF, -given.format().tiny());
    given.number(name, [below, Range::NOT_FINITE][given.one_of(2) as usize])
}

/// Outside of [low, high], or NaN.
pub fn outside(given: Given, name: &str, low: f64, high: f64) -> Term {
    let format = given.format();
    let above = Range::within(format.next_up(high), INF);
    let below = Range::within(-INF, format.next_down(low));
    given.number(name, [above.or_nan(), below][given.one_of(2) as usize])
}

pub fn any_vector(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, Range::ANY)
}

pub fn finite_vector(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, finite(given))
}

pub fn any_direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(any_vector(given, name))
}

/// Any vector with one component of a kind, whichever it is.
pub fn with_one(given: Given, name: &str, kind: Range) -> Vec3<Term> {
    let mut v = any_vector(given, name);
    let one = given.number(&format!("{name}'"), kind);
    *[&mut v.x, &mut v.y, &mut v.z][given.one_of(3) as usize] = one;
    v
}

/// A component is infinite or NaN, and the others are anything.
pub fn broken(given: Given, name: &str) -> Vec3<Term> {
    with_one(given, name, Range::NOT_FINITE)
}

/// A vector without a direction: zero, whatever the signs of its zeros, or broken.
pub fn without_direction(given: Given, name: &str) -> Vec3<Term> {
    match given.one_of(2) {
        0 => given.vector(name, nothing()),
        _ => broken(given, name),
    }
}

pub fn within(terms: impl IntoIterator<Item = Term>, range: Range) -> Vec<Goal> {
    let goal = |term| Goal::Within(term, range);
    terms.into_iter().map(goal).collect()
}

pub fn components(v: impl Into<[Term; 3]>, range: Range) -> Vec<Goal> {
    within(v.into(), range)
}

pub fn same(a: impl Into<[Term; 3]>, b: impl Into<[Term; 3]>) -> Vec<Goal> {
    let pairs = a.into().into_iter().zip(b.into());
    pairs.map(|(a, b)| Goal::Same(a, b)).collect()
}

/// `None`, or a direction.
pub fn none_or_unit(n: Option<UnitVec3<Term>>) -> Vec<Goal> {
    n.map_or(vec![], |n| components(n, component()))
}

/// A claim that a case gives nothing, and another for which it gives something.
pub fn none<T>(result: Option<T>) -> Vec<Goal> {
    let reached = |_| vec![Goal::Never];
    result.map_or(vec![Goal::Same(Term::ZERO, Term::ZERO)], reached)
}

/// Any attenuation without a range.
pub fn attenuation(given: Given) -> Attenuation<Term> {
    let a = given.number("a", Range::unsigned(0.0, given.format().max()));
    let (b, c) = (given.not_negative("b"), given.not_negative("c"));
    Attenuation::new(a, b, c).unwrap_or(Attenuation::NONE)
}

/// Any attenuation with a range below the largest number.
pub fn ranged(given: Given) -> Attenuation<Term> {
    let format = given.format();
    let below_max = Range::within(format.tiny(), format.next_down(format.max()));
    let ranged = attenuation(given).within(given.number("r", below_max));
    ranged.expect("a range above 0")
}

/// Any cone as `Cone::from_cosines` makes it of any bits.
pub fn cone(given: Given) -> Option<Cone<Term>> {
    Cone::from_cosines(given.any("inner"), given.any("outer"))
}

pub fn lamp(given: Given, position: Vec3<Term>) -> PointLight<Term> {
    PointLight {
        position,
        intensity: given.rgb("I"),
        attenuation: attenuation(given),
    }
}

/// A spot of any bits whose cone has one angle, or two.
pub fn spot(given: Given, position: Vec3<Term>) -> Option<SpotLight<Term>> {
    Some(SpotLight {
        point: lamp(given, position),
        axis: any_direction(given, "axis"),
        cone: cone(given)?,
    })
}

pub fn sun(given: Given, l: UnitVec3<Term>) -> IncidentLight<Term> {
    let intensity = given.rgb("I");
    DirectionalLight { l, intensity }.into()
}

/// A material whose shininess is any bits: of its power is known what integer and real ones have in common.
pub fn material(given: Given) -> Material<Term, Term> {
    Material {
        k_a: given.rgb("k_a"),
        k_d: given.rgb("k_d"),
        k_s: given.rgb("k_s"),
        m: given.any("m"),
    }
}

/// Light that arrives: no channel is negative, infinite or NaN.
pub fn arrives(given: Given, light: IncidentLight<Term>) -> Vec<Goal> {
    let mut goals = components(light.intensity(), not_negative(given));
    goals.extend(components(light.l(), component()));
    goals
}

pub fn black(color: Rgb<Term>) -> Vec<Goal> {
    components(color, nothing())
}
