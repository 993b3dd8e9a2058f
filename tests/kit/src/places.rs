//! Places with exact numbers, the same on every machine.

#[cfg(feature = "fixed")]
use shading::fixed::Fixed;
use shading::{Rgb, UnitVec3, Vec3};

use crate::given::{Given, Input};
use crate::number::Number;

/// The shininess, as an integer and as a real number.
pub const INTEGER: [u32; 8] = [0, 1, 2, 5, 32, 33, 1000, u32::MAX];
pub const REAL: [f32; 8] = [0.0, 0.5, 1.0, 10.25, 32.0, 100.5, 1e4, f32::MAX];

/// A linear congruential generator (Knuth's multiplier and Lewis's increment, as in *Numerical Recipes*).
pub struct Numbers(pub u32);

impl Numbers {
    pub(crate) fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.0
    }

    pub(crate) fn next_u64(&mut self) -> u64 {
        u64::from(self.next()) << 32 | u64::from(self.next())
    }

    #[cfg(feature = "fixed")]
    pub(crate) fn next_i32(&mut self) -> i32 {
        i32::from_le_bytes(self.next().to_le_bytes())
    }

    /// A number of any size, each as often as the others.
    #[cfg(feature = "fixed")]
    pub fn next_fixed(&mut self) -> Fixed {
        let bits = self.next_i32();
        Fixed::from_bits(bits >> (self.next() >> 27))
    }

    /// A number in [0, 1).
    #[cfg(feature = "fixed")]
    pub fn next_fraction(&mut self) -> Fixed {
        Fixed::from_bits(self.next_i32() >> 16 & 0xFFFF)
    }

    /// A number with any bits.
    #[cfg(feature = "fixed")]
    pub fn next_bits(&mut self) -> Fixed {
        Fixed::from_bits(self.next_i32())
    }

    /// Chooses one of several values.
    fn choose<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        const { assert!(N > 0) }
        // uses the upper bits, the better ones of a linear congruential generator
        choices[(self.next() >> 8) as usize % N]
    }

    /// A vector with each coordinate in [−1, 1).
    fn vector<T: Number>(&mut self) -> Vec3<T> {
        Vec3::new(T::draw(self), T::draw(self), T::draw(self))
    }

    fn along_an_axis<T: Number>(&mut self) -> Vec3<T> {
        let [x, y, z] = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z];
        *self.choose([x, y, z, -x, -z]) * self.choose(T::SIZES)
    }
}

/// The number of places at which the functions are called.
const PLACES: u32 = 1024;

/// Most places are ordinary. An eighth of them have vectors of any size, an eighth have vectors
/// whose components are of any size, and an eighth have vectors and directions along the axes, many
/// of which coincide or are opposite.
pub fn places<T: Number>() -> impl Iterator<Item = Given<T>> {
    let mut numbers = Numbers(1);
    (0..PLACES).map(move |i| {
        let vector: fn(&mut Numbers) -> Vec3<T> = match i % 8 {
            5 => |numbers| numbers.vector() * T::draw_any(numbers),
            6 => |numbers| Vec3::from([(); 3].map(|()| T::draw_any(numbers))),
            7 => Numbers::along_an_axis,
            _ => |numbers| numbers.vector() * T::of_f32(4.0),
        };
        let shininess = (i / 8 % 8) as usize;
        let mut input = input(&mut numbers, vector);
        input.integer_m = INTEGER[shininess];
        input.real_m = T::of_f32(REAL[shininess]);
        Given::new(&input)
    })
}

fn input<T: Number>(numbers: &mut Numbers, vector: fn(&mut Numbers) -> Vec3<T>) -> Input<T> {
    let [p, a, b, c] = [(); 4].map(|()| vector(numbers));
    let [n, l, v, axis] = [(); 4].map(|()| *vector(numbers).unit_or(UnitVec3::Z));
    let [k_a, k_d, k_s, rgb, intensity] =
        [(); 5].map(|()| Rgb::from(<[T; 3]>::from(vector(numbers))).map(T::abs));
    let coefficients = vector(numbers);
    let Vec3 { x, y, .. } = coefficients;

    let fraction = T::draw(numbers).abs();
    let near_one = T::ONE - fraction * T::of_f32(64.0) * T::EPSILON;
    let any = T::draw_any(numbers).abs().at_most(T::ONE);
    let cosine = numbers.choose([fraction, fraction, near_one, any]);
    Input {
        is_valid: true,
        p,
        a,
        b,
        c,
        n,
        l,
        v,
        axis,
        x,
        y,
        cosine,
        rgb,
        k_a,
        k_d,
        k_s,
        intensity,
        coefficients: coefficients.map(T::abs),
        range: y.abs() + (c - p).length(), // often close to the distance
        edge: T::draw(numbers),
        edges: [cosine, -T::ONE],
        integer_m: 0,
        real_m: T::ZERO,
        bits: numbers.0,
    }
}
