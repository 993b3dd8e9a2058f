//! The mistakes that renderers make: one table, from which they are named, planted and listed.

#[rustfmt::skip] // a table
mod table;

use std::f64::consts::{FRAC_1_PI, PI};
use std::fmt;
use std::sync::LazyLock;

use serde::{Serialize, Serializer};
pub use table::SCOPES;
use table::{OPERATIONS, ROWS};

use crate::bounded::{Bounded, Bounded3, rounded};
use crate::formula::{At, Change, ONE, Part, ZERO};
use crate::profile::Profile;
use crate::scene::{Light, dot, length, scale, zip};

/// A known mistake: what it changes in the formulas.
pub struct Mistake {
    pub id: String,
    /// What is wrong, in words; `{}` stands for a number that the renderer has in its code.
    pub says: String,
    /// The numbers that are tried for `{}`.
    pub values: &'static [f64],
    pub changes: Vec<(Part, Change)>,
}

/// A known mistake with its number, and the lights or models that have it.
#[derive(Clone, Copy)]
pub struct Fault {
    pub(crate) mistake: &'static Mistake,
    pub(crate) value: f64,
    pub(crate) of: &'static Scope,
}

/// Which lights or models have a mistake.
pub struct Scope {
    pub id: &'static str,
    /// In words, after those of the mistake.
    pub says: &'static str,
    pub has: fn(&At) -> bool,
}

impl Mistake {
    /// Whether it explains any color that is off by so little.
    pub fn is_rough(&self) -> bool {
        ["InBits", "Imprecise"].contains(&&*self.id)
    }

    /// Whether it explains any color that is off by little, so that others beside it explain no more.
    pub fn is_loose(&self) -> bool {
        self.is_rough() || self.id == "ExpandedSquares"
    }
}

impl Fault {
    /// The name of the mistake, which does not change.
    #[must_use]
    pub fn id(&self) -> &'static str {
        &self.mistake.id
    }

    pub(crate) fn new(mistake: &'static Mistake, value: f64) -> Self {
        let of = &SCOPES[0];
        Self { mistake, value, of }
    }

    /// The mistake of this name, with the first of its numbers.
    pub(crate) fn named(id: &str) -> Self {
        let mut all = Self::all();
        all.find(|fault| fault.mistake.id == id).expect("a mistake")
    }

    /// Every mistake with every number that is tried for it.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        MISTAKES.iter().flat_map(|mistake| {
            let values = match mistake.values {
                [] => &[0.0],
                values => values,
            };
            values.iter().map(move |&value| Self::new(mistake, value))
        })
    }
}

impl PartialEq for Fault {
    fn eq(&self, other: &Self) -> bool {
        let of = |fault: &Self| (&fault.mistake.id, fault.of.id);
        of(self) == of(other) && self.value == other.value
    }
}

impl Serialize for Fault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (of, says) = (self.of.id, self.to_string());
        let told =
            serde_json::json!({ "id": self.id(), "value": self.value, "of": of, "says": says });
        told.serialize(serializer)
    }
}

impl fmt::Debug for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {} {}", self.mistake.id, self.value, self.of.id)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let named = [(PI, "π"), (FRAC_1_PI, "1/π"), (1.0 / 255.0, "1/255")];
        let name = named.iter().find(|(value, _)| *value == self.value);
        let number = name.map_or(self.value.to_string(), |(_, name)| (*name).into());
        let says = self.mistake.says.replace("{}", &number);
        write!(f, "{says}{}", self.of.says)
    }
}

impl Profile {
    /// What the renderer departs from on purpose.
    pub(crate) fn departures(&self) -> Vec<Fault> {
        let table = [
            (self.attenuated_ambient, "AmbientAttenuated"),
            (self.unattenuated_highlight, "HighlightNotAttenuated"),
            (self.highlight_on_the_dark_side, "HighlightNotGated"),
            (self.normal_faces_eye, "NormalTowardEye"),
            (self.black_without_lights, "BlackWithoutLights"),
            (self.unlit_without_lights, "UnlitWithoutLights"),
            (self.spot_exponent > 0.0, "ConeExponent"),
            (self.ambient_times_diffuse, "AmbientTimesDiffuse"),
        ];
        let made = table.into_iter().filter(|(is_made, _)| *is_made);
        made.map(|(_, id)| Fault {
            value: self.spot_exponent,
            ..Fault::named(id)
        })
        .collect()
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

/// 1 where a vector is on the side of another, −1 where it is not; either where they are perpendicular.
fn side(of: Bounded3, v: Bounded3) -> Bounded {
    let cosine = dot(of, v);
    if cosine.value == 0.0 {
        return ONE.looser(2.0);
    }
    cosine.if_positive(ONE, -ONE)
}

fn mean([r, g, b]: Bounded3) -> Bounded3 {
    one((r + g + b) / exact(3.0))
}

fn max(a: Bounded3, b: Bounded3) -> Bounded3 {
    zip(a, b, Bounded::max)
}

/// Colors and directions as they are stored, each rounded by `f`.
fn stored(x: Bounded3, at: &At, f: impl Fn(f64) -> f64) -> Bounded3 {
    x.map(|c| at.given(f(c.value)).looser(c.error))
}

fn in_steps(x: Bounded3, at: &At) -> Bounded3 {
    stored(x, at, |c| (c * at.value).round() / at.value)
}

fn in_half(x: Bounded3, at: &At) -> Bounded3 {
    stored(x, at, |c| rounded(c, (-11_f64).exp2()))
}

fn times(x: Bounded3, at: &At) -> Bounded3 {
    scale(x, at.number())
}

/// A factor that follows from the shininess.
fn normalized(x: Bounded3, at: &At, by: impl Fn(f64) -> f64) -> Bounded3 {
    scale(x, Bounded::computed(by(at.m), 16.0, at.how))
}

/// k_s with Schlick's approximation of the Fresnel term.
fn fresnel(k_s: Bounded3, cosine: Bounded) -> Bounded3 {
    let grazing = (ONE - cosine.at_most(1.0)).at_least_zero().power(5.0);
    k_s.map(|c| c + (ONE - c) * grazing)
}

fn unit_by(v: Bounded3, by: impl Fn(Bounded) -> Bounded) -> Bounded3 {
    let length = by(length(v));
    v.map(|c| c / length)
}

/// L of a lamp, where the renderer may divide by the distance, which it needs in any case; a sun's is not normalized.
fn lamp_by(x: Bounded3, at: &At, by: impl Fn(Bounded) -> Bounded) -> Bounded3 {
    if matches!(at.light, Some(Light::Directional { .. })) {
        return x;
    }
    let l = unit_by(at.way, by);
    [0, 1, 2].map(|i| l[i].looser((l[i].value - x[i].value).abs()))
}

/// The edge of a cone at a whole number of degrees.
fn edge_in_degrees(at: &At, cut: bool) -> Bounded3 {
    let degrees = at.spot().1.to_degrees();
    let whole = degrees.round();
    let cosine = |degrees: f64| degrees.to_radians().cos();
    if cut && (degrees - whole).abs() < 1e3 * at.how.u * degrees && !at.how.rounds {
        // rounding decides to which side a whole number of degrees is cut
        return one(Bounded::between(cosine(whole), cosine(whole - 1.0), at.how));
    }
    let degrees = if cut { degrees.floor() } else { whole };
    one(at.given(degrees.to_radians()).cos())
}

/// From 0 at the edge of a cone to 1 on its axis.
fn within(at: &At) -> Bounded {
    ((at.against - at.edge) / (ONE - at.edge)).at_least_zero()
}

/// x where a number is positive, black elsewhere.
fn if_positive(number: Bounded, x: Bounded3) -> Bounded3 {
    x.map(|c| number.if_positive(c, ZERO))
}

/// What linear light is encoded as.
fn gamma(at: &At, gamma: f64) -> Bounded3 {
    one(exact(at.linear.max(0.0).powf(1.0 / gamma)))
}

fn of_linear(at: &At, f: impl Fn(f64) -> f64) -> Bounded3 {
    one(exact(f(at.linear)))
}

/// A level of the color that is told, of so many.
fn level(at: &At, f: impl Fn(f64, f64) -> f64) -> Bounded3 {
    let most = 1.0 / at.level.unwrap_or(1.0);
    of_linear(at, |x| f(x, most) / most)
}

/// Every known mistake.
pub static MISTAKES: LazyLock<Vec<Mistake>> = LazyLock::new(|| {
    let rows = ROWS.iter().map(|(id, says, values, changes)| Mistake {
        id: (*id).into(),
        says: (*says).into(),
        values,
        changes: changes.to_vec(),
    });
    let mut all: Vec<Mistake> = rows.collect();
    for (does, says, values, change, ingredients) in OPERATIONS {
        all.extend(
            ingredients
                .iter()
                .copied()
                .flatten()
                .map(|(id, name, parts)| Mistake {
                    id: format!("{id}{does}"),
                    says: format!("{name} {says}").replace(" ,", ","),
                    values,
                    changes: parts.iter().map(|part| (*part, *change)).collect(),
                }),
        );
    }
    all
});
