//! Early exit: which lights may light a surface, told without a root, and for a slice of lights without
//! a branch for each, which a processor could only guess.

use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// Whether a light along P_light − p may light a surface: `false` where N·L would not be positive in
/// any lane.
#[inline]
pub(super) fn is_in_front<T: Real>(n: UnitVec3<T>, to_light: Vec3<T>) -> bool {
    // Below zero by more than 2⁻⁹ of |x| + |y| + |z|, which is at least the distance: this dot product
    // and N·L round by less in any number type of 12 bits or more, so N·L is not positive either. A
    // product that may have lost bits below its range is in doubt.
    let size = to_light.x.abs() + to_light.y.abs() + to_light.z.abs();
    let beyond_doubt = size * T::of_f32(-1.0 / 512.0) - T::ONE / T::EXTREME;
    let in_front = beyond_doubt.if_above(n.dot(to_light), T::ZERO, T::ONE);
    in_front.any_positive()
}

/// Those of a slice that a test chooses, in order: 32 are tried before the first is given.
pub(super) struct Filtered<'a, L, F> {
    is_chosen: F,
    tried: Tried<'a, L>,
}

struct Tried<'a, L> {
    chunk: &'a [L],
    /// A bit for each of the chunk that is chosen and still to come.
    chosen: u32,
    /// What is not tried yet.
    rest: &'a [L],
}

impl<'a, L, F: Fn(&L) -> bool + Copy> Filtered<'a, L, F> {
    #[inline]
    pub(super) fn by(is_chosen: F, all: &'a [L]) -> Self {
        let tried = try_some(is_chosen, all);
        Self { is_chosen, tried }
    }
}

#[inline]
fn try_some<L>(is_chosen: impl Fn(&L) -> bool, all: &[L]) -> Tried<'_, L> {
    let (chunk, rest) = all.split_at(all.len().min(32));
    let bit = |light| u32::from(is_chosen(light));
    let chosen = chunk
        .iter()
        .rev()
        .fold(0, |bits, light| bits << 1 | bit(light));
    Tried {
        chunk,
        chosen,
        rest,
    }
}

/// Takes the test by value and returns what it tried. It gets no reference to the filter, which
/// therefore stays in registers.
#[cold]
#[inline(never)]
fn try_more<L>(is_chosen: impl Fn(&L) -> bool, rest: &[L]) -> Tried<'_, L> {
    try_some(is_chosen, rest)
}

impl<'a, L, F: Fn(&L) -> bool + Copy> Iterator for Filtered<'a, L, F> {
    type Item = &'a L;

    #[inline]
    fn next(&mut self) -> Option<&'a L> {
        while self.tried.chosen == 0 {
            if self.tried.rest.is_empty() {
                return None;
            }
            self.tried = try_more(self.is_chosen, self.tried.rest);
        }
        let first = self.tried.chosen.trailing_zeros() as usize;
        self.tried.chosen &= self.tried.chosen - 1;
        self.tried.chunk.get(first)
    }
}
