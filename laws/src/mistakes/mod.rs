//! The mistakes that renderers often make: one table, whose rows name what is wrong, and which a
//! renderer names to say where it departs from the formulas on purpose.

mod table;

use std::f64::consts::{FRAC_1_PI, PI};
use std::fmt;
use std::str::FromStr;

use serde::{Serialize, Serializer};
pub use table::MISTAKES;

use crate::formula::{Change, Formula, Part};
use crate::profile::Profile;
use crate::scene::{Scene, Triple};

/// A known mistake: what it changes in the formulas.
#[derive(Debug)]
pub struct Mistake {
    pub id: &'static str,
    /// What is wrong, in words; `{}` stands for a number that the renderer has in its code.
    pub says: &'static str,
    /// The numbers that are tried for `{}`; a 0 where there is none.
    pub values: &'static [f64],
    /// An ingredient that it changes, and others.
    pub change: (Part, Change),
    pub more: &'static [(Part, Change)],
}

/// A known mistake with its number.
#[derive(Clone, Copy, Debug)]
pub struct Fault {
    pub(crate) mistake: &'static Mistake,
    pub(crate) value: f64,
}

impl Fault {
    /// The name of the mistake, which does not change.
    #[must_use]
    pub fn id(&self) -> &'static str {
        self.mistake.id
    }

    /// The mistake as a profile names it in `departs`: `HighlightNotGated`, `ConeExponent=2`.
    #[must_use]
    pub fn name(&self) -> String {
        if self.has_number() {
            format!("{}={}", self.id(), self.value)
        } else {
            self.id().into()
        }
    }

    fn has_number(&self) -> bool {
        self.mistake.says.contains("{}")
    }

    /// The known mistakes, each with the first number that is tried for it.
    pub fn known() -> impl Iterator<Item = Self> {
        Self::all().filter(|fault| fault.value == fault.mistake.values[0])
    }

    /// The linear light that a renderer with this mistake, and with no other, gives a scene. It may be
    /// negative or not finite.
    ///
    /// ```
    /// use shading_laws::{Fault, Scene};
    ///
    /// let behind = r#"{"model":"lambert","p":[0,0,0],"n":[0,0,1],"v":[0,0,2],"k_a":[0,0,0],"k_d":[0.5,0.5,0.5],
    ///     "k_s":[0,0,0],"m":8,"i_a":[0,0,0],"lights":[{"kind":"directional","intensity":[1,1,1],"l":[0,0,-1]}]}"#;
    /// let scene = Scene::from_json(behind).unwrap();
    /// let fault: Fault = "DiffuseNotClamped".parse().unwrap();
    /// assert_eq!(fault.color(&scene), [-0.5; 3]);
    /// ```
    #[must_use]
    pub fn color(&self, scene: &Scene) -> Triple {
        let profile = Profile::default();
        formula(&profile, Some(*self)).reply(scene)
    }

    /// Every mistake with every number that is tried for it.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        MISTAKES.iter().flat_map(|mistake| {
            let values = mistake.values.iter();
            values.map(move |&value| Self { mistake, value })
        })
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let (id, number) = name.split_once('=').unwrap_or((name, ""));
        let fault = Self::known().find(|fault| fault.id() == id);
        let fault = fault.ok_or_else(|| {
            let names: Vec<String> = Self::known().map(|fault| fault.name()).collect();
            format!("there is no departure {id}; there are {}", names.join(", "))
        })?;
        match (name.contains('='), fault.has_number()) {
            (false, true) => Err(format!("{id} needs a number, as in {}", fault.name())),
            (true, false) => Err(format!("{id} has no number, but {name} gives it one")),
            (false, false) => Ok(fault),
            (true, true) => {
                let value = number.parse().ok().filter(|x: &f64| x.is_finite());
                let value = value.ok_or(format!("{name}: {number} is no number"))?;
                Ok(Self { value, ..fault })
            }
        }
    }
}

impl Serialize for Fault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let named = [(PI, "π"), (FRAC_1_PI, "1/π"), (1.0 / 255.0, "1/255")];
        let name = named.iter().find(|(value, _)| *value == self.value);
        let number = name.map_or(self.value.to_string(), |(_, name)| (*name).into());
        f.write_str(&self.mistake.says.replace("{}", &number))
    }
}

/// What a renderer departs from on purpose.
pub fn departures(profile: &Profile) -> Result<Vec<Fault>, String> {
    profile.departs.iter().map(|name| name.parse()).collect()
}

/// The formulas as a renderer has them, with what it departs from on purpose and with this mistake.
pub fn formula(profile: &Profile, fault: Option<Fault>) -> Formula<'_> {
    let departures = departures(profile).unwrap_or_default().into_iter();
    let is_made = |it: &Fault| fault.is_some_and(|fault| fault.id() == it.id());
    let others = departures.filter(|it| !is_made(it));
    let changes = fault.into_iter().chain(others).flat_map(|fault| {
        let (Mistake { change, more, .. }, value) = (fault.mistake, fault.value);
        let changes = [change].into_iter().chain(*more);
        changes.map(move |&(part, change)| (part, change, value))
    });
    Formula {
        profile,
        changes: changes.collect(),
        u: profile.roundoff,
        is_wrong: fault.is_some(),
    }
}
