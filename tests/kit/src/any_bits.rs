//! Fixed-point arithmetic on numbers with any bits, in addition to that at the places: a processor
//! without a long multiply computes every product in another way.

use shading::fixed::{Attenuation, Fixed, PointLight, Rgb, Vec3};
use shading::{Elementary, Exponent, Real};

use crate::digest::{Each, Fnv};
use crate::places::Numbers;

/// Digests the results for many numbers, half of which have any bits and half of which any size.
pub fn absorb(digest: &mut Fnv) {
    let mut numbers = Numbers(2);
    for _ in 0..4096 {
        let [v, w] = [(); 2].map(|()| Vec3::from([(); 3].map(|()| numbers.next_bits())));
        let [p, q] = [(); 2].map(|()| Vec3::from([(); 3].map(|()| numbers.next_fixed())));
        let (x, y) = (numbers.next_bits(), numbers.next_fixed());
        let share = numbers.next_share();
        digest.absorb(Each([x, y, share].map(|x| [v * x, v / x, q * x, q / x])));
        digest.absorb([v + w, v - w, p + q, p - q, -v, v.cross(w), p.cross(q)]);
        digest.absorb([
            v.dot(w),
            v.dot(q),
            p.dot(q),
            v.dot(v),
            v.length(),
            q.length(),
        ]);
        digest.absorb([v.unit(), q.unit()]);
        digest.absorb([x.sqrt(), y.sqrt(), share.sqrt(), x.abs(), y.abs()]);
        digest.absorb([1, 2, 5, 32, 33, 1000, u32::MAX].map(|m| m.raise(share)));
        let [a, b, c] = p.map(Elementary::abs).into();
        let attenuation = Attenuation::new(a, b, c).unwrap_or_default();
        let lamp = PointLight {
            position: q,
            intensity: Rgb::new(x, y, share).map(Elementary::abs),
            attenuation,
        };
        let near = q + Vec3::new(share, share, Fixed::STEP);
        digest.absorb([v, p, near].map(|p| lamp.at(p)));
        for (p, r) in [(p, x.abs()), (near, share + share)] {
            let ranged = attenuation.clamped().within(r.at_least(Fixed::STEP));
            let attenuation = ranged.unwrap_or(attenuation);
            digest.absorb(
                PointLight {
                    attenuation,
                    ..lamp
                }
                .at(p),
            );
        }
    }

    // a Cortex-M0 divides by numbers above 1 in its own way: all up to 2, and some of each larger size
    for leading in 0x8000..0x1_0000 {
        let larger = (leading << 15 | leading) >> (leading & 7);
        for steps in [2 * leading, 2 * leading + 1, larger] {
            let (divisor, zero) = (Fixed::from_bits(steps), Fixed::ZERO);
            let dividends = [Fixed::MAX, -Fixed::MAX, Fixed::ONE];
            digest.absorb(Fixed::attenuated(
                dividends,
                [divisor, zero, zero],
                zero,
                Fixed::MAX,
            ));
        }
    }
}
