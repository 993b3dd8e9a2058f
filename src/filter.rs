//! Floor 0: a filter without a branch for each element, of which a processor can only guess the way.

/// Those of a slice that a test chooses, in order: 32 are tried before the first is given.
pub(crate) struct Filtered<'a, L, F> {
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
    pub(crate) fn by(is_chosen: F, all: &'a [L]) -> Self {
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

/// Takes the test by value and returns what it tried: it is given no reference to the filter, which
/// so stays in registers.
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
