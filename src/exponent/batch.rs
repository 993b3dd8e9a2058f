//! The powers of a sum's cosines, computed one by one or four at a time.

use super::Exponent;
use crate::real::Real;

/// Takes items with their cosines. It may compute the powers later.
pub trait Powers<I, T> {
    fn take(&mut self, item: I, cosine: T);
    fn finish(self);
}

pub(crate) struct OneByOne<P, F> {
    pub(crate) power: P,
    pub(crate) each: F,
}

impl<I, T, P: Fn(T) -> T, F: FnMut(I, T)> Powers<I, T> for OneByOne<P, F> {
    #[inline(always)]
    fn take(&mut self, item: I, cosine: T) {
        (self.each)(item, (self.power)(cosine));
    }

    #[inline(always)]
    fn finish(self) {}
}

/// The shininess of a surface without a highlight: nothing is added up.
#[derive(Clone, Copy)]
pub(crate) struct NoHighlight;

impl<T: Real> Exponent<T> for NoHighlight {
    #[inline(always)]
    fn raise(self, _cosine: T) -> T {
        T::ZERO
    }

    #[inline(always)]
    fn powers<I: Copy>(self, _none: I, _each: impl FnMut(I, T)) -> impl Powers<I, T> {
        Self
    }
}

impl<I, T> Powers<I, T> for NoHighlight {
    #[inline(always)]
    fn take(&mut self, _item: I, _cosine: T) {}

    #[inline(always)]
    fn finish(self) {}
}

/// Where a SIMD register holds four numbers, four powers take little longer than one.
#[cfg(any(
    target_feature = "sse2",
    target_feature = "neon",
    target_feature = "simd128"
))]
pub(crate) mod by_fours {
    use super::Powers;
    use crate::exponent::power::power;

    pub(crate) struct ByFours<I, F> {
        m: f32,
        items: [I; 4],
        cosines: [f32; 4],
        waiting: usize,
        each: F,
    }

    impl<I: Copy, F: FnMut(I, f32)> ByFours<I, F> {
        #[inline]
        pub(crate) fn new(m: f32, none: I, each: F) -> Self {
            Self {
                m,
                items: [none; 4],
                cosines: [0.0; 4],
                waiting: 0,
                each,
            }
        }

        #[inline(always)]
        fn hand_on(&mut self) {
            let [a, b, c, d] = self.cosines;
            let powers = four_powers(a, b, c, d, self.m);
            for i in 0..self.waiting {
                (self.each)(self.items[i % 4], powers[i % 4]);
            }
            self.waiting = 0;
        }
    }

    impl<I: Copy, F: FnMut(I, f32)> Powers<I, f32> for ByFours<I, F> {
        #[inline(always)]
        fn take(&mut self, item: I, cosine: f32) {
            self.items[self.waiting % 4] = item;
            self.cosines[self.waiting % 4] = cosine;
            self.waiting += 1;
            if self.waiting == 4 {
                self.hand_on();
            }
        }

        #[inline(always)]
        fn finish(mut self) {
            if self.waiting > 0 {
                self.hand_on();
            }
        }
    }

    /// The power of each of four cosines.
    ///
    /// The function is out of line and takes numbers instead of an array, for two reasons. LLVM
    /// sees a loop of four and nothing around it, so it vectorizes the loop. And the cosines arrive
    /// in registers: if they were written to memory one by one, the vector load would have to wait
    /// for all four stores.
    #[inline(never)]
    fn four_powers(a: f32, b: f32, c: f32, d: f32, m: f32) -> [f32; 4] {
        let mut powers = [a, b, c, d];
        for power_of_c in &mut powers {
            *power_of_c = power(*power_of_c, m);
        }
        powers
    }
}
