//! Searches for the largest error by climbing hills from random places.

/// The number of random places tried before a climb.
const LOOKS: u32 = 100;
/// The number of steps that lead nowhere before it starts again.
const PATIENCE: u32 = match option_env!("PAT") {
    Some(p) => p.as_bytes()[0] as u32 * 100 - 4800,
    None => 1500,
};
/// The number of places tried on one hill, over all climbs.
const STEPS: u32 = 20_000;

/// The largest number of numbers that an input is made from.
const MOST: usize = 32;

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
/// its own random numbers, so more hills never find less.
pub fn largest(error: &dyn Fn(&mut Numbers) -> f64, digits: usize, hills: u64) -> f64 {
    let heights = (0..hills).map(|hill| climb(error, digits, Random(hill)));
    heights.fold(0.0, f64::max)
}

/// Starts at the highest of some random places, and takes every step that does not lead down. A
/// step changes one or two of the numbers, by anything from 2 down to their last digit. Where no
/// step has led up for long, it starts again elsewhere.
#[allow(clippy::cast_precision_loss)] // powers of two
fn climb(error: &dyn Fn(&mut Numbers) -> f64, digits: usize, mut random: Random) -> f64 {
    let (mut highest, mut top, mut height, mut used) = (0.0_f64, [0.0; MOST], 0.0, 0);
    let mut step = 0; // since the start, or since the last one up
    for _ in 0..STEPS {
        let mut place = top;
        if step < LOOKS {
            place = std::array::from_fn(|_| random.signed());
        } else {
            for _ in 0..=random.below(2) {
                let number = &mut place[random.below(used)];
                let size = 2.0 / (1_u64 << random.below(digits + 8)) as f64;
                *number = (*number + size * random.signed()).clamp(-1.0, 1.0);
            }
        }
        let mut numbers = Numbers {
            all: &place,
            used: 0,
        };
        let found = error(&mut numbers);
        used = used.max(numbers.used);
        if found > height {
            step = step.min(LOOKS);
        }
        if found >= height {
            (top, height) = (place, found);
            highest = highest.max(found);
        }
        step += 1;
        if step > LOOKS + PATIENCE {
            (step, height) = (0, 0.0);
        }
    }
    highest
}

/// SplitMix64 (Steele, Lea, and Flood 2014): the same numbers in each run, on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    #[allow(clippy::cast_possible_truncation)] // less than the limit
    fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit as u64) as usize
    }

    /// A number in [−1, 1).
    #[allow(clippy::cast_precision_loss)] // 53 bits
    fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
