//! What explains wrong colors, in words and in members of the profile.

use serde::Serialize;

use crate::mistakes::Fault;
use crate::profile::Profile;

/// What may have caused the wrong colors of a run.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Cause {
    /// The mistake; none if the colors are only given in another form.
    pub mistake: Option<Fault>,
    /// In words.
    pub says: String,
    /// The members of the profile that say so, if it is on purpose.
    pub declare: Option<String>,
    /// The number of wrong colors that this explains.
    pub explained: usize,
    /// The number of wrong colors that were compared. It is 0 for a cause that another experiment showed.
    pub of: usize,
    /// Other mistakes that give the same colors.
    pub alternatives: Vec<Fault>,
    /// What the renderer would say of itself if this were on purpose; nothing of few digits.
    #[serde(skip)]
    pub(crate) then: Option<Box<Profile>>,
    /// The number of colors, wrong or right, that this does not give.
    #[serde(skip)]
    pub(crate) errors: usize,
}

impl Cause {
    /// A mistake, in the form in which the profile names it, that explains so much.
    pub(crate) fn of(fault: Fault, profile: &Profile, score: Self) -> Self {
        let declare = format!("\"departs\":[\"{}\"]", fault.name());
        let mut then = profile.clone();
        then.departs.push(fault.name());
        Self {
            mistake: Some(fault),
            says: fault.to_string(),
            declare: Some(declare),
            then: Some(Box::new(then)),
            ..score
        }
    }

    /// That all colors are rounded to so few bits.
    pub(crate) fn rough(bits: i32, profile: &Profile, explained: usize) -> Self {
        let (u, m) = (f64::from(-bits).exp2(), profile.most_shiny);
        // the power's condition is m, so rounding of u explains m·u of a highlight
        let hidden = (m * u).min(1.0);
        // half a level of 8 bits is what nobody sees
        let is_unseen = hidden <= 0.5 / 255.0;
        let hides = format!(
            "; if it has all its digits, something else is wrong, which a roundoff would hide: with a \
             shininess of {m} it explains {:.0} % of a highlight",
            100.0 * hidden
        );
        Self {
            says: format!(
                "it behaves like a roundoff of 2^-{bits}, lower than the profile says, as half precision, bfloat, \
                 a table or a fast inverse root would{}",
                if is_unseen { "" } else { &hides }
            ),
            declare: is_unseen.then(|| format!("\"roundoff\":{u:e}")),
            explained,
            of: explained,
            ..Self::default()
        }
    }

    /// That colors depend on what was asked before.
    pub(crate) fn state() -> Self {
        let says = "a scene changes the color of the scenes after it, or the same scene, asked again, \
                    has another color";
        Self {
            says: says.into(),
            ..Self::default()
        }
    }

    /// Whether it explains nearly all wrong colors.
    #[must_use]
    pub fn is_nearly_all(&self) -> bool {
        is_nearly_all(self.explained, self.of)
    }

    /// Whether it explains at least half of them, which of two mistakes in different scenes one does.
    pub(crate) fn is_half(&self) -> bool {
        self.explained * 2 >= self.of
    }
}

/// Whether something is nearly all of a count: a tenth may miss. A mistake of the table has a number that is
/// a little off in some renderers. In some scenes an edit leaves what it is about as it was, such as a second
/// light that the wrong one hides. Of 62 mistakes alone, all were told alike where a fifth might miss, and where
/// a twentieth; but of 15 pairs, one was told in part where a twentieth might.
pub fn is_nearly_all(count: usize, of: usize) -> bool {
    count * 10 >= of * 9
}
