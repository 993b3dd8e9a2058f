//! The digest: 64-bit FNV-1a (Fowler, Noll, and Vo) over the bits of numbers.

use shading::{Dual, IncidentLight, Rgb, Shaded, UnitVec3, Vec3};

pub struct Fnv(pub u64);

impl Fnv {
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn absorb(&mut self, value: impl Absorb) {
        value.absorb_into(self);
    }

    pub fn bytes<const N: usize>(&mut self, bytes: [u8; N]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

/// A value whose bits can be digested.
pub trait Absorb {
    fn absorb_into(self, digest: &mut Fnv);
}

// the bits of NaN differ between processors
macro_rules! float {
    ($float:ident, $nan:literal) => {
        impl Absorb for $float {
            fn absorb_into(self, digest: &mut Fnv) {
                let bits = if self.is_nan() { $nan } else { self.to_bits() };
                digest.bytes(bits.to_le_bytes());
            }
        }
    };
}

float!(f32, 0x7fc0_0000);
float!(f64, 0x7ff8_0000_0000_0000);

#[cfg(feature = "fixed")]
impl Absorb for shading::fixed::Fixed {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.bytes(self.to_bits().to_le_bytes());
    }
}

impl Absorb for bool {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.bytes([self.into()]);
    }
}

impl<T: Absorb> Absorb for Option<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        match self {
            Some(value) => digest.absorb(value),
            None => digest.bytes(*b"none"),
        }
    }
}

impl<T: Absorb, const N: usize> Absorb for [T; N] {
    fn absorb_into(self, digest: &mut Fnv) {
        for part in self {
            digest.absorb(part);
        }
    }
}

/// Every value of an iterator.
pub struct Each<I>(pub I);

impl<T: Absorb, I: IntoIterator<Item = T>> Absorb for Each<I> {
    fn absorb_into(self, digest: &mut Fnv) {
        for value in self.0 {
            digest.absorb(value);
        }
    }
}

impl<T: Absorb> Absorb for Vec3<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(<[T; 3]>::from(self));
    }
}

impl<T: Absorb> Absorb for UnitVec3<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(<[T; 3]>::from(self));
    }
}

impl<T: Absorb> Absorb for Rgb<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(<[T; 3]>::from(self));
    }
}

impl<T: Absorb> Absorb for Dual<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(self.value);
        digest.absorb(self.gradient);
    }
}

impl<T: Absorb> Absorb for IncidentLight<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(self.l);
        digest.absorb(self.intensity);
        digest.absorb(self.distance);
    }
}

impl<T: Absorb> Absorb for Shaded<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb([self.ambient, self.diffuse, self.specular]);
    }
}
