//! Floor 0: a filter without a branch for each element, of which a processor can only guess the way.

/// Those of a slice that a test chooses, in order: 32 are tried before the first is given.
pub(crate) struct Filtered<'a, L, F> {
    is_chosen: F,
    chunk: &'a [L],
    /// A bit for each of the chunk that is still to come.
    chosen: u32,
    rest: &'a [L],
}

impl<'a, L, F: Fn(&L) -> bool> Filtered<'a, L, F> {
    #[inline]
    pub(crate) fn by(is_chosen: F, rest: &'a [L]) -> Self {
        let mut filtered = Self {
            is_chosen,
            chunk: &[],
            chosen: 0,
            rest,
        };
        filtered.choose();
        filtered
    }

    #[inline]
    fn choose(&mut self) {
        (self.chunk, self.rest) = self.rest.split_at(self.rest.len().min(32));
        let bit = |light| u32::from((self.is_chosen)(light));
        self.chosen = self
            .chunk
            .iter()
            .rev()
            .fold(0, |bits, light| bits << 1 | bit(light));
    }

    #[cold]
    #[inline(never)]
    fn choose_more(&mut self) {
        self.choose();
    }
}

impl<'a, L, F: Fn(&L) -> bool> Iterator for Filtered<'a, L, F> {
    type Item = &'a L;

    #[inline]
    fn next(&mut self) -> Option<&'a L> {
        while self.chosen == 0 {
            if self.rest.is_empty() {
                return None;
            }
            self.choose_more();
        }
        let first = self.chosen.trailing_zeros() as usize;
        self.chosen &= self.chosen - 1;
        self.chunk.get(first)
    }
}
