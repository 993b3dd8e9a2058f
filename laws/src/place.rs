//! Where a renderer is wrong, in words: the things without which its colors are right.

use serde::Serialize;

use crate::edit::EDITS;

/// What wrong colors follow.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// Without one of these, the colors are right.
    pub only_with: Vec<&'static str>,
    /// Without one of these, they are as wrong.
    pub also_without: Vec<&'static str>,
}

impl Place {
    /// Whether it may be that of two things.
    pub(crate) fn is_general(&self) -> bool {
        self.only_with.iter().all(|id| GENERAL.contains(id))
    }

    /// An edit that tells this place beside the whole that it is found in, if one does.
    pub(crate) fn beside(&self, whole: &Self) -> Option<usize> {
        let is_of_whole = |id: &&str| whole.only_with.contains(id);
        if !whole.is_general() {
            let mut particular = self.only_with.iter().filter(|id| !GENERAL.contains(id));
            let first = particular.clone().next()?;
            return (!particular.any(is_of_whole)).then(|| number(first))?;
        }
        // what takes away a part of the light may take away what is wrong with it, too
        let is_told = |id: &&&str| !is_of_whole(id) && (whole.only_with.len() < 2 || !darkens(id));
        number(self.only_with.iter().find(is_told)?)
    }

    /// Whether all that another one needs is needed by this, too, so that this is the smaller one.
    pub(crate) fn is_within(&self, other: &Self) -> bool {
        let mut ids = other.only_with.iter();
        ids.all(|id| self.only_with.contains(id))
    }

    /// Whether both say the same but for what is general.
    pub(crate) fn is_as_particular(&self, other: &Self) -> bool {
        let particular = |place: &Self| -> Vec<&str> {
            let ids = place.only_with.iter().copied();
            ids.filter(|id| !GENERAL.contains(id)).collect()
        };
        self.only_with == other.only_with
            || !self.is_general() && particular(self) == particular(other)
    }
}

/// Parts that make up one thing, and what else may be told of either: where both are wrong, the
/// highlight, the lamps, the lights, or everything is. A surface and a light are factors of one product.
const PARTS: [([&str; 2], &[&str]); 6] = [
    (
        ["Phong", "Blinn"],
        &["highlight", "lights", "several lights"],
    ),
    (
        ["spot", "point"],
        &["cone", "lamps", "lights", "several lights"],
    ),
    (["color of the surface", "color of lights"], &[]),
    (["lamps", "directional"], &["lights", "several lights"]),
    (["diffuse", "highlight"], &["lights", "several lights"]),
    (["ambient", "lights"], &["several lights"]),
];

/// What may be two things.
pub const GENERAL: [&str; 3] = ["highlight", "lamps", "lights"];

/// The place of an edit among all.
pub fn number(id: &str) -> Option<usize> {
    EDITS.iter().position(|edit| edit.id == id)
}

/// Whether an edit takes away a part of the light.
fn darkens(id: &str) -> bool {
    EDITS.iter().any(|edit| edit.id == id && edit.darkens)
}

/// Makes one place of two that are the parts of one thing, which is wrong as a whole.
pub fn merge(places: &mut Vec<Place>) {
    'merged: loop {
        for (parts, too) in PARTS {
            let of_part = |part| {
                places
                    .iter()
                    .position(|place| place.only_with.contains(&part))
            };
            let [Some(a), Some(b)] = parts.map(of_part) else {
                continue;
            };
            let others = |place: &Place| -> Vec<&str> {
                let others = place.only_with.iter().copied();
                others
                    .filter(|id| !parts.contains(id) && !too.contains(id))
                    .collect()
            };
            if a != b && others(&places[a]) == others(&places[b]) {
                let other = places[b].clone();
                places[a]
                    .only_with
                    .retain(|id| other.only_with.contains(id));
                places.remove(b);
                continue 'merged;
            }
        }
        return;
    }
}
