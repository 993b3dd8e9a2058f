//! What claims are about, and what they say of it.
//!
//! The functions that are named `any_` make everything that the crate's constructors make. A test
//! compares the lists here with the crate's interface, so that a claim about "any light" is about
//! every kind of light that there is.

use shading::number::Mask;
use shading::{Attenuation, Cone, DirectionalLight, IncidentLight, Light, Material, PointLight};
use shading::{Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, shade};
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

pub fn not_negative(given: Given) -> Range {
    Range::within(0.0, given.format().max())
}

/// A coefficient or a channel that a constructor has checked: finite and not negative, and not −0.
pub fn checked(given: Given, name: &str) -> Term {
    given.number(name, Range::unsigned(0.0, given.format().max()))
}

pub fn checked_rgb(given: Given, name: &str) -> Rgb<Term> {
    ["r", "g", "b"]
        .map(|channel| checked(given, &format!("{name}.{channel}")))
        .into()
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

/// a·b, with the products written out, for a claim that must not assume what the crate decides by.
pub fn dot(a: impl Into<[Term; 3]>, b: impl Into<[Term; 3]>) -> Term {
    let ([a, b, c], [x, y, z]) = (a.into(), b.into());
    a * x + b * y + c * z
}

/// Assumes that the square of a vector is between 1/p and p, where it needs no scaling. Returns the square.
pub fn assume_tame(given: Given, v: [Term; 3]) -> Term {
    let square = dot(v, v);
    given.assume_at_most(Term::ONE / Term::EXTREME, square);
    given.assume_above(Term::EXTREME, square);
    square
}

/// The vector from p to a light.
pub fn way(position: Vec3<Term>, p: Vec3<Term>) -> [Term; 3] {
    [position.x - p.x, position.y - p.y, position.z - p.z]
}

/// One of two numbers, by whether a > b.
pub fn choose(a: Term, b: Term, then: Term, otherwise: Term) -> Term {
    a.above(b).select(then, otherwise)
}

pub fn larger(x: Term, floor: Term) -> Term {
    choose(x, floor, x, floor)
}

pub fn smaller(x: Term, limit: Term) -> Term {
    choose(x, limit, limit, x)
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

pub fn at_most(a: impl Into<[Term; 3]>, b: impl Into<[Term; 3]>) -> Vec<Goal> {
    let pairs = a.into().into_iter().zip(b.into());
    pairs.map(|(a, b)| Goal::AtMost(a, b)).collect()
}

pub fn black(color: Rgb<Term>) -> Vec<Goal> {
    components(color, nothing())
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

/// Any attenuation without a range and a limit: what `Attenuation::new` makes of any bits has such
/// coefficients, which `attenuation_of_any` proves.
pub fn unlimited(given: Given) -> Attenuation<Term> {
    let [a, b, c] = ["a", "b", "c"].map(|name| checked(given, name));
    Attenuation::new(a, b, c).unwrap_or(Attenuation::NONE)
}

/// What limits an attenuation, and what ends it at a range, by the names of the methods.
type Limit = fn(Attenuation<Term>, Term) -> Option<Attenuation<Term>>;
pub const LIMITS: [(&str, Limit); 3] = [
    ("new", |free, _| Some(free)),
    ("clamped", |free, _| Some(free.clamped())),
    ("clamped_to", Attenuation::clamped_to),
];
pub const WINDOWS: [(&str, Limit); 3] = [
    ("new", |free, _| Some(free)),
    ("within", Attenuation::within),
    ("within_gltf", Attenuation::within_gltf),
];

/// Any attenuation with any of the limits.
pub fn limited(given: Given) -> Option<Attenuation<Term>> {
    LIMITS[given.one_of(3) as usize].1(unlimited(given), given.any("limit"))
}

pub fn any_attenuation(given: Given) -> Option<Attenuation<Term>> {
    WINDOWS[given.one_of(3) as usize].1(limited(given)?, given.any("r"))
}

/// What makes the edge of a cone, by the name of the method.
type Edge = fn(Cone<Term>) -> Cone<Term>;
pub const EDGES: [(&str, Edge); 2] = [
    ("from_cosines", |cone| cone),
    ("smoothstep", Cone::smoothstep),
];

/// Any cone as `Cone::from_cosines` makes it of any bits, with a hard edge or any soft one.
pub fn any_cone(given: Given) -> Option<Cone<Term>> {
    let cone = Cone::from_cosines(given.any("inner"), given.any("outer"))?;
    Some(EDGES[given.one_of(2) as usize].1(cone))
}

fn lamp(given: Given, position: Vec3<Term>) -> Option<PointLight<Term>> {
    Some(PointLight {
        position,
        intensity: given.rgb("I"),
        attenuation: any_attenuation(given)?,
    })
}

pub fn any_spot(given: Given, position: Vec3<Term>) -> Option<SpotLight<Term>> {
    Some(SpotLight {
        point: lamp(given, position)?,
        axis: any_direction(given, "axis"),
        cone: any_cone(given)?,
    })
}

pub fn sun(given: Given, name: &str) -> DirectionalLight<Term> {
    DirectionalLight {
        l: any_direction(given, name),
        intensity: given.rgb(&format!("I.{name}")),
    }
}

/// Any light with a position, at this one.
pub fn any_lamp(given: Given, position: Vec3<Term>) -> Option<Light<Term>> {
    Some(match given.one_of(2) {
        0 => lamp(given, position)?.into(),
        _ => any_spot(given, position)?.into(),
    })
}

/// Any light; one that has a position is at this one. A new kind of light does not compile until it
/// has a place here.
pub fn light_at(given: Given, position: Vec3<Term>) -> Option<Light<Term>> {
    let light = match given.one_of(2) {
        0 => sun(given, "l").into(),
        _ => any_lamp(given, position)?,
    };
    match light {
        Light::Directional(_) | Light::Point(_) | Light::Spot(_) => Some(light),
    }
}

/// Any light as it arrives at any point, and the vector to it: L, or position − p.
pub fn any_light_and_way(given: Given) -> Option<(IncidentLight<Term>, [Term; 3])> {
    let (position, p) = (any_vector(given, "position"), any_vector(given, "p"));
    let light = light_at(given, position)?;
    let to_light = match light {
        Light::Directional(sun) => sun.l.into(),
        _ => way(position, p),
    };
    Some((light.at(p), to_light))
}

/// What arrives of any light at any point.
pub fn any_arrival(given: Given) -> Option<IncidentLight<Term>> {
    let position = any_vector(given, "position");
    Some(light_at(given, position)?.at(any_vector(given, "p")))
}

/// A surface, the eye and the ambient light. Of the power by its shininess, which is any bits, only
/// the contract is known, which integer and real ones have in common.
pub struct Scene {
    pub n: UnitVec3<Term>,
    pub v: UnitVec3<Term>,
    pub material: Material<Term, Term>,
    pub i_a: Rgb<Term>,
}

pub fn any_scene(given: Given) -> Scene {
    let [n, v] = ["n", "v"].map(|name| any_direction(given, name));
    let material = Material {
        k_a: checked_rgb(given, "k_a"),
        k_d: checked_rgb(given, "k_d"),
        k_s: checked_rgb(given, "k_s"),
        m: given.any("m"),
    };
    let i_a = given.rgb("I_a");
    Scene {
        n,
        v,
        material,
        i_a,
    }
}

/// The names of the models in `shade`.
pub const MODELS: [&str; 3] = ["lambert", "phong", "blinn_phong"];

impl Scene {
    /// One of the models, each of which is proved apart.
    pub fn shade(&self, model: u32, lights: &[IncidentLight<Term>]) -> Shaded<Term> {
        let (material, lights) = (&self.material, lights.iter().copied());
        match MODELS[model as usize] {
            "lambert" => shade::lambert(self.n, material, self.i_a, lights),
            "phong" => shade::phong(self.n, self.v, material, self.i_a, lights),
            _ => shade::blinn_phong(self.n, self.v, material, self.i_a, lights),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{EDGES, LIMITS, MODELS, WINDOWS};

    /// The names of the public functions of a file, with this indentation, that return one of these.
    fn made(source: &'static str, indentation: &str, results: &[&str]) -> Vec<&'static str> {
        let begins = format!("\n{indentation}pub ");
        let items = source.split(&begins);
        let functions = items.filter_map(|item| {
            let function = item
                .strip_prefix("fn ")
                .or(item.strip_prefix("const fn "))?;
            let (name, _) = function.split_once(['(', '<'])?;
            let (head, _) = function.split_once('{')?;
            let is_made = results
                .iter()
                .any(|result| head.contains(&format!("-> {result}")));
            is_made.then_some(name)
        });
        sorted(functions.collect())
    }

    fn sorted(mut names: Vec<&str>) -> Vec<&str> {
        names.sort_unstable();
        names.dedup();
        names
    }

    #[test]
    fn any_means_all_that_constructors_make() {
        let own = ["Self", "Option<Self>"];
        let attenuations = LIMITS
            .iter()
            .chain(&WINDOWS)
            .map(|(name, _)| *name)
            .collect();
        let source = include_str!("../../../src/light/attenuation.rs");
        assert_eq!(sorted(attenuations), made(source, "    ", &own));
        let apart = ["from_cosine", "from_half_angle", "from_half_angles"]; // in claims of their own
        let cones = EDGES.iter().map(|(name, _)| *name).chain(apart).collect();
        let source = include_str!("../../../src/light/cone.rs");
        assert_eq!(sorted(cones), made(source, "    ", &own));
        let source = include_str!("../../../src/shade.rs");
        assert_eq!(sorted(MODELS.to_vec()), made(source, "", &["Shaded<T>"]));
    }
}
