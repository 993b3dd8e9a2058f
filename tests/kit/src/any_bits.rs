//! Fixed-point arithmetic on numbers with any bits, in addition to that at the places: a processor
//! without a long multiply computes every product in another way.

use shading::fixed::{Attenuation, Fixed, PointLight, Rgb, Vec3};
use shading::{Elementary, Lobe, Real};

use crate::digest::Fnv;
use crate::places::Numbers;

/// Digests the results for many numbers, half of which have any bits and half of which any size.
pub fn absorb(digest: &mut Fnv) {
    let mut numbers = Numbers(2);
    for _ in 0..4096 {
        let [v, w] = [(); 2].map(|()| Vec3::from([(); 3].map(|()| numbers.next_bits())));
        let [p, q] = [(); 2].map(|()| Vec3::from([(); 3].map(|()| numbers.next_fixed())));
        let (x, fraction) = (numbers.next_bits(), numbers.next_fraction());
        digest.absorb([x, fraction].map(|x| [v * x, v / x, q * x, q / x]));
        digest.absorb([v + w, v - w, -v, v.cross(w), p.cross(q)]);
        digest.absorb([v.dot(w), p.dot(q), v.length(), q.length(), x.sqrt()]);
        digest.absorb([v.unit(), q.unit()]);
        digest.absorb([1, 2, 33, 1000, u32::MAX].map(|m| m.raise(fraction)));
        digest.absorb(Fixed::halfway_power(p, Fixed::measured(q), p, 5));
        let [a, b, c] = p.map(Elementary::abs).into();
        let mut lamp = PointLight {
            position: q,
            intensity: Rgb::new(x, fraction, Fixed::ONE).map(Elementary::abs),
            attenuation: Attenuation::new(a, b, c).unwrap_or_default(),
        };
        let points = [v, p, q + Vec3::splat(fraction)];
        digest.absorb(points.map(|p| lamp.at(p)));
        let ended = lamp.attenuation.clamped().within(fraction);
        lamp.attenuation = ended.unwrap_or(lamp.attenuation);
        digest.absorb(points.map(|p| lamp.at(p)));
    }
}
