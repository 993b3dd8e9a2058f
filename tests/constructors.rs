//! The constructors for generic code have the bits of those that work in constants, and prove the same.

#[cfg(feature = "fixed")]
use shading::fixed::Fixed;
use shading::{Attenuation, Cone, Ranged, Real, SoftCone, UnitVec3};

/// A linear congruential generator (Knuth's constants, as in *Numerical Recipes*).
struct Numbers(u32);

impl Numbers {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.0 >> 8
    }

    /// A number in [0, 1).
    fn share(&mut self) -> f64 {
        f64::from(self.next() << 8 | self.next() & 0xFF) / 4_294_967_296.0
    }

    /// One of the numbers at which a constructor decides, next to it, or any other.
    fn any<T: Real>(&mut self, decisive: &[T]) -> T {
        let place = self.next() as usize;
        let chosen = decisive[place % decisive.len()];
        let step = T::of(1.0 / 65_536.0 / 128.0) * T::of(f64::from(self.next() % 5) - 2.0);
        match self.next() % 4 {
            0 => chosen,
            1 => chosen + step,
            2 => T::of(self.share() * 4.0 - 0.5),
            _ => T::of(self.share() * 2.0 - 1.0),
        }
    }
}

macro_rules! same {
    ($name:ident, $number:ty, $decisive:expr) => {
        #[test]
        fn $name() {
            type T = $number;
            let decisive: Vec<T> = $decisive;
            let mut numbers = Numbers(1);
            for _ in 0..30_000 {
                let [a, b, c] = [(); 3].map(|()| numbers.any(&decisive));
                // as text, which tells −0 from 0
                let [of, new] = [Attenuation::of(a, b, c), Attenuation::<T>::new(a, b, c)];
                assert_eq!(format!("{of:?}"), format!("{new:?}"), "{a:?}, {b:?}, {c:?}");
                let free = Attenuation::<T>::NONE;
                assert_eq!(Ranged::of(free, a), free.within(a), "{a:?}");
                assert_eq!(
                    Cone::of_half_angle(a),
                    Cone::<T>::from_half_angle(a),
                    "{a:?}"
                );
                assert_eq!(Cone::of_cosine(a), Cone::<T>::from_cosine(a), "{a:?}");
                assert_eq!(
                    SoftCone::of_half_angles(a, b),
                    SoftCone::<T>::from_half_angles(a, b),
                    "{a:?}, {b:?}"
                );
                assert_eq!(
                    SoftCone::of_cosines(a, b),
                    SoftCone::<T>::from_cosines(a, b),
                    "{a:?}, {b:?}"
                );
                assert_eq!(
                    UnitVec3::of(a, b, c),
                    UnitVec3::<T>::new(a, b, c),
                    "{a:?}, {b:?}, {c:?}"
                );
                // nearly of length 1
                let b = (T::ONE - a * a).at_least(T::ZERO).sqrt();
                for b in [b, b + b * T::of(1.0 / 8192.0), b + numbers.any(&decisive)] {
                    let z = T::ZERO;
                    assert_eq!(
                        UnitVec3::of(a, z, b),
                        UnitVec3::<T>::new(a, z, b),
                        "{a:?}, {b:?}"
                    );
                }
            }
        }
    };
}

macro_rules! decisive {
    ($float:ident) => {{
        use std::$float::consts::{FRAC_PI_2, FRAC_PI_4, PI};
        let near_one = (0_u8..20).map(|i| 1.0 - $float::from(i) * $float::EPSILON / 2.0);
        let cosines = near_one.flat_map(|x| [x, -x, 2.0 - x, x - 2.0]);
        let others = [
            0.0,
            -0.0,
            $float::from_bits(1),
            $float::MIN_POSITIVE,
            FRAC_PI_4,
            FRAC_PI_2,
            3.0 * FRAC_PI_4,
            PI,
            PI.next_up(),
            PI.next_down(),
            $float::MAX,
            $float::INFINITY,
            -$float::INFINITY,
            $float::NAN,
        ];
        cosines.chain(others).collect()
    }};
}

same!(in_single_precision_the_bits_agree, f32, decisive!(f32));
same!(in_double_precision_the_bits_agree, f64, decisive!(f64));
#[cfg(feature = "fixed")]
same!(
    in_fixed_point_the_bits_agree,
    Fixed,
    (-12..=12)
        .flat_map(|i| [0, 0x1_0000, -0x1_0000, 51_472, 102_944, 205_887]
            .map(|bits| Fixed::from_bits(bits + i)))
        .chain([Fixed::MAX, Fixed::MIN])
        .collect()
);

/// `cast(Fixed::from_f32)`, as the page of `Fixed` says it.
#[cfg(feature = "fixed")]
#[test]
#[allow(clippy::cast_possible_truncation)] // of random numbers
fn casts_from_single_precision_to_fixed_point_keep_what_was_proved() {
    let mut numbers = Numbers(7);
    let narrow = Cone::<f32>::from_half_angle(0.0).expect("an angle");
    let all = Cone::<f32>::from_half_angle(std::f32::consts::PI).expect("an angle");
    for _ in 0..100_000 {
        let mut direction = || {
            let v = shading::Vec3::from([(); 3].map(|()| numbers.share() as f32 - 0.5));
            v.unit_or(UnitVec3::Z).cast(Fixed::from_f32)
        };
        let [axis, l] = [direction(), direction()];
        let [narrow, all] = [narrow, all].map(|cone| cone.cast(Fixed::from_f32));
        assert_eq!(narrow.factor(axis, -axis), Fixed::ONE, "{axis:?}");
        assert_eq!(all.factor(axis, l), Fixed::ONE, "{axis:?}, {l:?}");
        assert_eq!(all.factor(axis, axis), Fixed::ONE, "{axis:?}");
    }
}

/// A soft cone of equal angles is the hard cone, to the bit: before a cast and after it.
#[test]
#[allow(clippy::cast_possible_truncation)] // as a cast does
fn a_cast_keeps_the_hard_cone_among_soft_ones() {
    use std::f64::consts::PI;

    let mut numbers = Numbers(8);
    for i in 0..100_000_u32 {
        let near = numbers.share() * f64::from(i % 50).exp2().recip();
        let half_angle = [near, PI - near, PI * near][(i % 3) as usize];
        let hard = Cone::<f64>::from_half_angle(half_angle.clamp(0.0, PI)).expect("an angle");
        let soft = SoftCone::from(hard);
        let single = |x| x as f32;
        assert_eq!(soft.cast(single), SoftCone::from(hard.cast(single)));
        #[cfg(feature = "fixed")]
        assert_eq!(soft.cast(Fixed::new), SoftCone::from(hard.cast(Fixed::new)));
    }
}
