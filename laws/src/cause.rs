//! What explains the colors of a run: a mistake of the table, or a form of the reply that the profile does
//! not say.

use std::cmp::Reverse;

use serde::Serialize;

use crate::bounded::Bounded;
use crate::formula::Formula;
use crate::mistakes::{Fault, formula};
use crate::profile::Profile;
use crate::random::Random;
use crate::scene::{Scene, Triple, mul};

/// The most colors that are kept, wrong ones and right ones.
const MOST: usize = 600;

/// The percentage of the wrong colors that is nearly all. A mistake of the table has a number that is a little
/// off in some renderers, so a tenth may be wrong for another reason; what explains half is told as a part. The
/// mistakes of `tests/mistakes.txt` are named with these numbers.
const NEARLY_ALL: usize = 90;
const HALF: usize = 50;

/// The same for a form, which has no such number. Three in a hundred are for rounding at the edges of levels.
const OF_FORM: usize = 97;

/// The percentage that one of two mistakes explains, and the most mistakes that are tried as the first of two.
const SOME: usize = 5;
const MOST_PARTS: usize = 8;

/// The fewest wrong colors that tell a form: with fewer, one of 255 sets of forms fits by chance.
pub const FEW: usize = 12;

/// A scene, and the color that the renderer gave it.
type Sample = (Scene, Triple);

/// A form of colors in words, the member of the profile that declares it, if it is no departure,
/// and what that changes.
type Form = (&'static str, &'static str, fn(&mut Profile));

/// What scenes may lack, and whether one does.
type Lack = (&'static str, fn(&Scene) -> bool);

/// The forms in which renderers give colors that are not linear light.
const FORMS: &[Form] = &[
    ("clamped to [0, 1]", "\"clamps\":[0,1]", |p| {
        p.clamps = p.clamps.or(Some([0.0, 1.0]));
    }),
    ("encoded as sRGB", "\"srgb\":true", |p| p.srgb = true),
    ("rounded to 8 bits", "\"bits\":8", |p| p.bits = Some(8)),
    ("rounded to 16 bits", "\"bits\":16", |p| p.bits = Some(16)),
    ("rounded to 5 bits", "\"bits\":5", |p| p.bits = Some(5)),
    ("from 0 to 255, not to 1", "\"white\":255", |p| {
        p.white = 255.0;
    }),
    ("raised to the power of 1/2.2", "", |p| {
        p.departs.push("Gamma=2.2".into());
    }),
    ("cut to levels, not rounded", "", |p| {
        p.departs.push("LevelsTruncated".into());
    }),
];

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
    /// What the renderer would say of itself if this were on purpose.
    #[serde(skip)]
    pub(crate) then: Option<Box<Profile>>,
    /// The number of colors, wrong or right, that this does not give.
    #[serde(skip)]
    errors: usize,
}

impl Cause {
    /// A mistake, in the form in which the profile names it, that explains so much.
    fn of(fault: Fault, profile: &Profile, score: Self) -> Self {
        let mut says = fault.to_string();
        let mut is_declared = !fault.mistake.is_fatal;
        if fault.mistake.is_rough() {
            // the power's condition is m, so rounding of u explains m·u of a highlight; half a level of 8 bits
            // is what nobody sees
            let hidden = profile.most_shiny * (-fault.value).exp2();
            if hidden > 0.5 / 255.0 {
                is_declared = false;
                let percent = (100.0 * hidden).min(100.0);
                let of_m = profile.most_shiny;
                let hides = format!(
                    "; if it has all its digits, something else is wrong, which a roundoff would hide: with a \
                     shininess of {of_m} it explains {percent:.0} % of a highlight"
                );
                says.push_str(&hides);
            }
        }
        let declare = if fault.mistake.is_rough() {
            format!("\"roundoff\":{:e}", (-fault.value).exp2())
        } else {
            format!("\"departs\":[\"{}\"]", fault.name())
        };
        let mut then = profile.clone();
        then.departs.push(fault.name());
        Self {
            mistake: Some(fault),
            says,
            declare: Some(declare).filter(|_| is_declared),
            then: Some(Box::new(then)).filter(|_| !fault.mistake.is_rough()),
            ..score
        }
    }

    /// That colors depend on what was asked before.
    pub(crate) fn state() -> Self {
        Self {
            says:
                "a scene changes the color of the scenes after it, or the same scene, asked again, \
                   has another color"
                    .into(),
            ..Self::default()
        }
    }

    /// Whether it explains nearly all wrong colors.
    #[must_use]
    pub fn is_nearly_all(&self) -> bool {
        self.explained * 100 >= self.of * NEARLY_ALL
    }
}

/// What a renderer answered, and a sample of it, of a size that does not grow with the run.
#[derive(Default)]
pub struct Evidence {
    wrong: Vec<Sample>,
    right: Vec<Sample>,
}

impl Evidence {
    /// Notes a color.
    pub fn note(&mut self, is_right: bool, scene: &Scene, reply: Triple) {
        let samples = if is_right {
            &mut self.right
        } else {
            &mut self.wrong
        };
        samples.push((scene.clone(), reply));
    }

    /// Keeps some colors, in random order, so that the first ones are like all.
    pub fn sample(&mut self) {
        let mut random = Random::new(0);
        for samples in [&mut self.wrong, &mut self.right] {
            random.shuffle(samples);
            samples.truncate(MOST);
        }
    }

    /// What explains nearly all wrong colors and no right one away, the simplest first; else what explains half.
    pub fn cause(&self, profile: &Profile) -> Option<Cause> {
        if self.wrong.is_empty() {
            return None;
        }
        let alone = |least| self.best(profile, Fault::exact(), least);
        let causes = [self.form(profile), alone(NEARLY_ALL)];
        let cause = causes.into_iter().flatten().min_by_key(|it| it.errors);
        let roughness = || Fault::rough().find_map(|it| self.roughness(profile, it));
        let cause = cause.or_else(roughness);
        cause
            .or_else(|| self.form_of_some(profile))
            .or_else(|| self.one_of_two(profile))
            .or_else(|| alone(HALF))
    }

    /// A mistake of the table, without which another one explains all.
    fn one_of_two(&self, profile: &Profile) -> Option<Cause> {
        let mut parts = self.parts(profile);
        parts.truncate(MOST_PARTS);
        parts.into_iter().find(|part| {
            let then = part.then.as_deref().unwrap_or(profile);
            let (rest, exact) = (self.rest(profile, then), Fault::exact());
            rest.wrong.len() >= FEW && rest.best(then, exact, NEARLY_ALL).is_some()
        })
    }

    /// The mistakes that explain some of the wrong colors and no right one away, those that explain most first.
    pub fn parts(&self, profile: &Profile) -> Vec<Cause> {
        let scored = Fault::exact().filter_map(|fault| {
            let score = self.score(&formula(profile, Some(fault)), SOME)?;
            Some(Cause::of(fault, profile, score))
        });
        let mut parts: Vec<Cause> = scored.filter(|it| it.explained >= FEW).collect();
        parts.sort_by_key(|it| (it.errors, Reverse(it.explained)));
        parts
    }

    /// What is wrong and what is right if the renderer says more of itself than before.
    pub fn rest(&self, before: &Profile, then: &Profile) -> Self {
        let (formula, ratio) = (formula(then, None), before.white / then.white);
        let mut rest = Self::default();
        for (scene, reply) in self.wrong.iter().chain(&self.right) {
            let reply = reply.map(|c| c * ratio);
            rest.note(formula.fits(scene, reply) != Some(false), scene, reply);
        }
        rest
    }

    /// The scenes whose colors are wrong.
    pub fn wrong_scenes(&self) -> Vec<Scene> {
        self.wrong.iter().map(|(scene, _)| scene.clone()).collect()
    }

    /// The best of the candidates.
    fn best(
        &self,
        profile: &Profile,
        candidates: impl Iterator<Item = Fault>,
        least: usize,
    ) -> Option<Cause> {
        let scored = candidates.filter_map(|fault| {
            let score = self.score(&formula(profile, Some(fault)), least)?;
            Some(Cause::of(fault, profile, score))
        });
        let mut ranked: Vec<Cause> = scored.collect();
        ranked.sort_by_key(|it| it.errors);
        let (best, others) = ranked.split_first()?;
        let alike = others.iter().take_while(|it| it.errors == best.errors);
        Some(Cause {
            alternatives: alike.filter_map(|cause| cause.mistake).collect(),
            ..best.clone()
        })
    }

    /// How well formulas explain the colors, if they give at least this percentage of the wrong ones and
    /// contradict nearly no right one.
    fn score(&self, formula: &Formula, least: usize) -> Option<Cause> {
        let (mut unexplained, mut unknown) = (0, 0);
        for (i, (scene, reply)) in self.wrong.iter().enumerate() {
            match formula.fits(scene, *reply) {
                Some(true) => {}
                Some(false) => unexplained += 1,
                None => unknown += 1, // such as that of the eye in the surface, which has no direction
            }
            // what fails so often at the beginning hardly ever explains enough in the end
            if unexplained * 100 > 2 * i * (100 - least) + 300 {
                return None;
            }
        }
        let of = self.wrong.len() - unknown;
        let is_contradicted = |(scene, reply): &&Sample| formula.fits(scene, *reply) == Some(false);
        // a right color that is wrong with the mistake shows that it is not made there; rounding may decide of few
        let contradicted = self.right.iter().filter(is_contradicted).take(3).count();
        let is_enough = unexplained * 100 <= of * (100 - least) && of * 4 >= self.wrong.len();
        (is_enough && contradicted <= 2).then(|| Cause {
            explained: of - unexplained,
            of,
            errors: unexplained + unknown + contradicted,
            ..Cause::default()
        })
    }

    /// The form in which the renderer gives its colors, if the profile does not say it.
    fn form(&self, profile: &Profile) -> Option<Cause> {
        let causes = (1..1 << FORMS.len()).filter_map(|set: usize| {
            let mut form = profile.clone();
            let chosen = FORMS.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
            let chosen: Vec<&Form> = chosen.map(|(_, form)| form).collect();
            for (.., declare) in &chosen {
                let before = form.clone();
                declare(&mut form);
                if form == before || before.bits.is_some_and(|bits| form.bits != Some(bits)) {
                    return None; // it is declared already, or another number of bits is
                }
            }
            let ratio = profile.white / form.white;
            let mut replies = self.wrong.iter().chain(&self.right);
            let is_other = |c: &f64| form.is_not_as_said(c * ratio).is_some();
            if replies.any(|(_, reply)| reply.iter().any(is_other)) {
                return None;
            }
            let as_form = |(scene, reply): &Sample| (scene.clone(), reply.map(|c| c * ratio));
            let evidence = Self {
                wrong: self.wrong.iter().map(as_form).collect(),
                right: self.right.iter().map(as_form).collect(),
            };
            let words: Vec<&str> = chosen.iter().map(|(words, ..)| *words).collect();
            let words = words.join(", ");
            let says = format!("colors are {words}, which the profile does not say");
            let members = chosen.iter().map(|(_, member, _)| (*member).to_owned());
            let mut members: Vec<String> = members.filter(|member| !member.is_empty()).collect();
            if form.departs != profile.departs {
                members.push(format!("\"departs\":{:?}", form.departs));
            }
            let score = evidence.score(&formula(&form, None), OF_FORM)?;
            Some(Cause {
                says,
                declare: Some(members.join(",")),
                then: Some(Box::new(form)),
                ..score
            })
        });
        causes.min_by_key(|cause| (cause.errors, Reverse(cause.explained)))
    }

    /// The form of the colors of scenes that lack something, where a mistake of that hides the form of the others.
    fn form_of_some(&self, profile: &Profile) -> Option<Cause> {
        let is_unlit = |scene: &Scene| scene.lights.is_empty();
        let is_dark = |scene: &Scene| mul(scene.k_a, scene.i_a) == [0.0; 3];
        let without: [Lack; 2] = [("lights", is_unlit), ("ambient light", is_dark)];
        without.into_iter().find_map(|(what, is_without)| {
            let of = |samples: &[Sample]| -> Vec<Sample> {
                let some = samples.iter().filter(|(scene, _)| is_without(scene));
                some.cloned().collect()
            };
            let (wrong, right) = (of(&self.wrong), of(&self.right));
            if wrong.len() < FEW {
                return None;
            }
            let cause = Self { wrong, right }.form(profile)?;
            let says = &cause.says;
            let says =
                format!("{says}; that is so without {what}, and there is more wrong with it");
            Some(Cause {
                says,
                of: 0,
                ..cause
            })
        })
    }

    /// The cause if all colors are as if they were rounded so, some too bright and some too dark.
    fn roughness(&self, profile: &Profile, fault: Fault) -> Option<Cause> {
        let [right, rough] = [formula(profile, None), formula(profile, Some(fault))];
        let (mut explained, mut of, mut brighter) = (0, 0, 0);
        for (scene, reply) in &self.wrong {
            // with so few bits, hardly anything is known of some colors
            let is_vague = |c: &Bounded| c.error * 2.0 > c.value.abs();
            match rough.fits(scene, *reply) {
                Some(true) if !rough.linear(scene).iter().all(is_vague) => explained += 1,
                Some(false) => {}
                _ => continue,
            }
            of += 1;
            let mut channels = right.linear(scene).into_iter().zip(reply);
            let is_brighter =
                channels.any(|(c, reply)| right.ends(c).is_some_and(|[_, high]| *reply > high));
            brighter += usize::from(is_brighter);
        }
        let is_balanced = brighter.min(of - brighter) * 8 >= of;
        let is_so = explained == of && of * 2 >= self.wrong.len();
        let score = Cause {
            explained,
            of,
            ..Cause::default()
        };
        (is_so && is_balanced).then(|| Cause::of(fault, profile, score))
    }
}
