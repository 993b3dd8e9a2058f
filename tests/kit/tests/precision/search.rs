//! Searches for the largest error by climbing hills from random places.

use kit::random::Random;

/// The number of random places tried before a climb, and the number of steps tried during it.
const LOOKS: u32 = 100;
const STEPS: u32 = 2000;

/// The largest number of numbers that an input is made from.
const MOST: usize = 64;

/// The numbers that an input is made from, one after the other.
pub struct Numbers<'a> {
    all: &'a [f64; MOST],
    used: usize,
}

impl Numbers<'_> {
    /// The next number, in [−1, 1].
    pub fn next(&mut self) -> f64 {
        self.used += 1;
        self.all[self.used - 1]
    }

    /// The next number, in [low, high].
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next().abs()
    }
}

/// The largest error found on `hills` hills, for numbers of `digits` binary digits. Each hill has
/// its own random numbers.
pub fn largest(error: &dyn Fn(&mut Numbers) -> f64, digits: usize, hills: u64) -> f64 {
    let heights = (0..hills).map(|hill| {
        let mut climb = Climb {
            top: [0.0; MOST],
            height: 0.0,
            used: 0,
            random: Random(hill),
        };
        climb.look(error);
        climb.steps(error, digits, STEPS);
        climb.height
    });
    heights.fold(0.0, f64::max)
}

struct Climb {
    top: [f64; MOST],
    height: f64,
    /// How many of the numbers the input is made from.
    used: usize,
    random: Random,
}

impl Climb {
    /// Tries the place, and stays there unless that leads down.
    fn visit(&mut self, error: &dyn Fn(&mut Numbers) -> f64, place: &[f64; MOST]) {
        let mut numbers = Numbers {
            all: place,
            used: 0,
        };
        let found = error(&mut numbers);
        if found >= self.height {
            (self.top, self.height) = (*place, found);
        }
        self.used = self.used.max(numbers.used);
    }

    /// Starts at the highest of some random places.
    fn look(&mut self, error: &dyn Fn(&mut Numbers) -> f64) {
        for _ in 0..LOOKS {
            let place = std::array::from_fn(|_| self.random.signed());
            self.visit(error, &place);
        }
    }

    /// A step changes one or two of the numbers, by anything from 2 down to their last digit.
    #[allow(clippy::cast_precision_loss)] // powers of two
    fn steps(&mut self, error: &dyn Fn(&mut Numbers) -> f64, digits: usize, count: u32) {
        for _ in 0..count {
            let mut place = self.top;
            for _ in 0..=self.random.below(2) {
                let number = &mut place[self.random.below(self.used)];
                let size = 2.0 / (1_u64 << self.random.below(digits + 2)) as f64;
                *number = (*number + size * self.random.signed()).clamp(-1.0, 1.0);
            }
            self.visit(error, &place);
        }
    }
}
