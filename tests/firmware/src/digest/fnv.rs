//! The digest: FNV-1a, 64 bits (Fowler, Noll and Vo), over the bits of numbers.

use shading::{IncidentLight, Rgb, Shaded, UnitVec3, Vec3};

pub struct Fnv(pub u64);

impl Fnv {
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn absorb(&mut self, value: impl Absorb) {
        value.absorb_into(self);
    }

    pub fn bits(&mut self, bits: u32) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

/// A value whose bits can be digested.
pub trait Absorb {
    fn absorb_into(self, digest: &mut Fnv);
}

impl Absorb for f32 {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.bits(self.to_bits());
    }
}

impl<T: Absorb> Absorb for [T; 3] {
    fn absorb_into(self, digest: &mut Fnv) {
        self.into_iter().for_each(|part| digest.absorb(part));
    }
}

impl Absorb for Vec3<f32> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(<[f32; 3]>::from(self));
    }
}

impl Absorb for UnitVec3<f32> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(*self);
    }
}

impl Absorb for Rgb<f32> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(<[f32; 3]>::from(self));
    }
}

impl Absorb for IncidentLight<f32> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb(self.l);
        digest.absorb(self.intensity);
        digest.absorb(self.distance);
    }
}

impl Absorb for Shaded<f32> {
    fn absorb_into(self, digest: &mut Fnv) {
        digest.absorb([self.ambient, self.diffuse, self.specular]);
    }
}

impl<T: Absorb> Absorb for Option<T> {
    fn absorb_into(self, digest: &mut Fnv) {
        match self {
            Some(value) => digest.absorb(value),
            None => digest.bits(u32::MAX), // the bits of no result
        }
    }
}
