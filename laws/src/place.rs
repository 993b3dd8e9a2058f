//! Where a renderer is wrong, in words: the things without which its colors are right.

use serde::Serialize;

use crate::edit::{DARKER, EDITS};

/// What wrong colors follow.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// Without one of these, the colors are right.
    pub only_with: Vec<&'static str>,
    /// Without one of these, they are as wrong.
    pub also_without: Vec<&'static str>,
}

impl Place {
    /// The first edit that takes one thing out, if one does.
    pub(crate) fn particular(&self) -> Option<usize> {
        let mut ids = self.only_with.iter();
        number(ids.find(|id| !GENERAL.contains(id))?)
    }

    /// Whether it may be that of two things.
    pub(crate) fn is_general(&self) -> bool {
        self.particular().is_none()
    }

    /// An edit that tells this place beside the whole that it is found in, if one does.
    pub(crate) fn beside(&self, whole: &Self) -> Option<usize> {
        let is_of_whole = |id: &&&str| whole.only_with.contains(id);
        let ids = self.only_with.iter();
        if whole.is_general() {
            // what takes away a part of the light may take away what is wrong with it, too
            let others = ids.filter(|id| !is_of_whole(id));
            let mut others = others.filter_map(|id| number(id));
            others.find(|k| whole.only_with.len() < 2 || !DARKER.contains(&EDITS[*k].id))
        } else {
            let mut shared = ids.filter(is_of_whole);
            let particular = self.particular();
            particular.filter(|_| shared.all(|id| GENERAL.contains(id)))
        }
    }

    /// Whether all that another one needs is needed by this, too, so that this is the smaller one.
    pub(crate) fn is_within(&self, other: &Self) -> bool {
        let mut ids = other.only_with.iter();
        ids.all(|id| self.only_with.contains(id))
    }
}

/// Parts that make up one thing. A surface and a light are factors of one product.
const PARTS: [[&str; 2]; 6] = [
    ["Phong", "Blinn"],
    ["spot", "point"],
    ["color of the surface", "color of lights"],
    ["lamps", "directional"],
    ["diffuse", "highlight"],
    ["ambient", "lights"],
];

/// What else may be told of one part alone: where both are wrong, the lamps, the lights, or everything is.
const WHOLE: [&str; 4] = ["cone", "lamps", "lights", "several lights"];

/// What may be two things.
const GENERAL: [&str; 3] = ["highlight", "lamps", "lights"];

/// The place of an edit among all.
pub fn number(id: &str) -> Option<usize> {
    EDITS.iter().position(|edit| edit.id == id)
}

/// Makes one place of two that are the parts of one thing, which is wrong as a whole.
pub fn merge(places: &mut Vec<Place>) {
    for parts in PARTS {
        let of_part = |part| places.iter().position(|it| it.only_with.contains(&part));
        let [Some(a), Some(b)] = parts.map(of_part) else {
            continue;
        };
        let is_other = |id: &&&str| !parts.contains(id) && !WHOLE.contains(id);
        let others = |i: usize| places[i].only_with.iter().filter(is_other);
        if a != b && others(a).eq(others(b)) {
            let other = places[b].only_with.clone();
            places[a].only_with.retain(|id| other.contains(id));
            places.remove(b);
            return merge(places);
        }
    }
}
