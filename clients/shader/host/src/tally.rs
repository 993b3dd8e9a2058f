//! How the GPU's numbers compare with the CPU's.

#[derive(Default)]
pub struct Tally {
    pub numbers: u64,
    pub same_bits: u64,
    /// How many zeros have the other sign.
    pub zeros: u64,
    /// The largest difference in units in the last place, and as a number.
    pub units: u64,
    pub difference: f32,
}

impl Tally {
    pub fn compare(&mut self, gpu: &[f32], cpu: &[f32]) {
        assert_eq!(gpu.len(), cpu.len());
        for (gpu, cpu) in gpu.iter().zip(cpu) {
            // what a function does not fill is 0 on both sides
            if gpu.to_bits() | cpu.to_bits() == 0 {
                continue;
            }
            self.numbers += 1;
            // nobody promises the bits of a NaN
            if gpu.to_bits() == cpu.to_bits() || gpu.is_nan() && cpu.is_nan() {
                self.same_bits += 1;
            } else if gpu == cpu {
                self.zeros += 1;
            } else {
                self.units = self.units.max(rank(*gpu).abs_diff(rank(*cpu)));
                self.difference = self.difference.max((gpu - cpu).abs());
            }
        }
    }

    pub fn add(&mut self, other: &Self) {
        self.numbers += other.numbers;
        self.same_bits += other.same_bits;
        self.zeros += other.zeros;
        self.units = self.units.max(other.units);
        self.difference = self.difference.max(other.difference);
    }

    /// Whether all bits are the same except the sign of zeros: drivers simplify 0 − x to −x and x·0 to 0.
    pub fn is_exact(&self) -> bool {
        self.same_bits + self.zeros == self.numbers
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Self {
            numbers,
            same_bits,
            zeros,
            units,
            difference,
        } = self;
        write!(f, "{same_bits} of {numbers} numbers have the same bits")?;
        if *zeros > 0 {
            write!(f, "; {zeros} are 0 with the other sign")?;
        }
        if !self.is_exact() {
            write!(
                f,
                "; largest difference {units} units in the last place, {difference:e}"
            )?;
        }
        Ok(())
    }
}

/// The index of a number among all numbers, so that a difference counts units in the last place.
fn rank(x: f32) -> i64 {
    let bits = i64::from(x.to_bits() as i32);
    if bits < 0 {
        i64::from(i32::MIN) - bits
    } else {
        bits
    }
}
