//! Early exit: finds the lights that may light a surface, without computing a root.
//!
//! For a slice of lights, the test is also free of branches: it avoids one unpredictable branch per
//! light.

use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// Whether a light in the direction P_light − p may light a surface. It is `false` if N·L would not
/// be positive in any lane.
#[inline]
pub(super) fn is_in_front<T: Real>(n: UnitVec3<T>, to_light: Vec3<T>) -> bool {
    // The light is left out if the dot product is below zero by more than 2⁻⁹ of |x| + |y| + |z|,
    // which is at least the distance. In any number type of 12 bits or more, this dot product and
    // N·L have smaller rounding errors, so N·L is not positive either. A product that may have lost
    // bits below the range of the type keeps the light.
    let size = to_light.x.abs() + to_light.y.abs() + to_light.z.abs();
    let beyond_doubt = size * T::of_f32(-1.0 / 512.0) - T::ONE / T::EXTREME;
    let in_front = beyond_doubt.if_above(n.dot(to_light), T::ZERO, T::ONE);
    in_front.any_positive()
}

/// The elements of a slice that pass a test, in order. It tests 32 elements before it yields the
/// first.
pub(super) struct Filtered<'a, L, F> {
    is_chosen: F,
    tried: Tried<'a, L>,
}

struct Tried<'a, L> {
    chunk: &'a [L],
    /// A bit for each element of the chunk that passed and has not been yielded yet.
    chosen: u32,
    /// The elements that are not tested yet.
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

/// It takes the test by value and returns the tested chunk. It gets no reference to the filter, so
/// the filter stays in registers.
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
