//! A falloff in another number type: between each two types it stays a falloff, keeps the order of falloffs, and
//! gives the light of coefficients that are rounded once.

#![allow(clippy::float_cmp, clippy::cast_possible_truncation)] // exact on purpose, and a cast rounds

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kit::random::Random;
use shading::{Attenuation, Real, Rgb};

trait Number: Real + PartialOrd + Debug + 'static {
    const NAME: &str;
    /// Half the distance from 1 to the next number, and from 0.
    const U: f64;
    const HALF_STEP: f64;
    fn exact(self) -> f64;
}

macro_rules! numbers {
    ($(
        $name:ident: $u:expr, $half_step:expr, max $max:expr, extreme $extreme:expr,
        |$x:ident| $round:expr;
    )*) => {$(
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        struct $name(f64);

        impl $name {
            fn rounded($x: f64) -> Self {
                Self($round)
            }
        }

        impl Number for $name {
            const NAME: &str = stringify!($name);
            const U: f64 = $u;
            const HALF_STEP: f64 = $half_step;
            fn exact(self) -> f64 {
                self.0
            }
        }

        operators!($name Add add, Sub sub, Mul mul, Div div);

        impl Neg for $name {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Real for $name {
            type Mask = bool;
            type Sum = Rgb<Self>;
            const ZERO: Self = Self(0.0);
            const ONE: Self = Self(1.0);
            const NEG_ONE: Self = Self(-1.0);
            const MAX: Self = Self($max);
            const EXTREME: Self = Self($extreme);
            fn of(literal: f64) -> Self {
                Self::rounded(literal)
            }
            fn sqrt(self) -> Self {
                Self::rounded(self.0.sqrt())
            }
            fn above(self, other: Self) -> bool {
                self > other
            }
        }
    )*};
}

macro_rules! operators {
    ($name:ident $($operator:ident $method:ident),*) => {$(
        impl $operator for $name {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::rounded(self.0.$method(other.0))
            }
        }
    )*};
}

/// Rounds to so many bits, and to multiples of a smallest number; beyond the largest, infinite.
fn float(x: f64, bits: i32, smallest: f64, max: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let exponent = x.abs().log2().floor() + 1.0 - f64::from(bits);
    let spacing = exponent.max(-1022.0).exp2().max(smallest);
    let rounded = (x / spacing).round_ties_even() * spacing;
    if rounded.abs() > max {
        f64::INFINITY.copysign(x)
    } else {
        rounded
    }
}

const BF16_LEAST: f64 = f32::from_bits(0x0001_0000) as f64;
const BF16_MAX: f64 = f32::from_bits(0x7f7f_0000) as f64;

numbers! {
    Half: 1.0 / 2048.0, 0.5 / 16_777_216.0, max 65_504.0, extreme 256.0,
        |x| float(x, 11, 1.0 / 16_777_216.0, 65_504.0);
    Bf16: 1.0 / 256.0, BF16_LEAST / 2.0, max BF16_MAX, extreme <f32 as Real>::EXTREME as f64,
        |x| float(x, 8, BF16_LEAST, BF16_MAX);
    // four digits after the point, as accounts have them; a tie goes away from 0
    Decimal: 0.0, 0.000_05, max 1e8, extreme 4096.0,
        |x| (x * 1e4).round().clamp(-1e12, 1e12) / 1e4;
}

impl Number for f32 {
    const NAME: &str = "f32";
    const U: f64 = f32::EPSILON as f64 / 2.0;
    const HALF_STEP: f64 = f32::from_bits(1) as f64 / 2.0;
    fn exact(self) -> f64 {
        self.into()
    }
}

impl Number for f64 {
    const NAME: &str = "f64";
    const U: f64 = f64::EPSILON / 2.0;
    const HALF_STEP: f64 = 0.0; // half the least number is none
    fn exact(self) -> f64 {
        self
    }
}

#[cfg(feature = "fixed")]
impl Number for shading::fixed::Fixed {
    const NAME: &str = "Fixed";
    const U: f64 = 0.0;
    const HALF_STEP: f64 = 0.5 / 65_536.0;
    fn exact(self) -> f64 {
        self.into()
    }
}

/// 0, or a number of a size between 2^low and 2^high.
fn coefficient(random: &mut Random, [low, high]: [f64; 2]) -> f64 {
    if random.fraction() < 0.2 {
        0.0
    } else {
        random.within(low, high).exp2()
    }
}

fn cast<A: Number, B: Number>(falloff: Attenuation<A>) -> Attenuation<B> {
    falloff.cast(|x| B::of(x.exact()))
}

fn exact_light(coefficients: [f64; 3], q: f64) -> f64 {
    let [a, b, c] = coefficients;
    1.0 / (a + q * (b + c * q))
}

/// From A to B: the cast is a falloff, and its light that of coefficients off by half a step at
/// most, or by one where all of them would be 0.
fn pair<A: Number, B: Number>() {
    let mut random = Random(1);
    for round in 0..2000 {
        let range = [[-40.0, 6.0], [-160.0, -100.0], [-14.0, 4.0]][round % 3];
        let [a, b, c] = [(); 3].map(|()| A::of(coefficient(&mut random, range)));
        let Some(falloff) = Attenuation::new(a, b, c) else {
            continue;
        };
        let is = cast::<A, B>(falloff);
        let [x, y, z] = is.coefficients();
        let context = format!("{} to {}: {falloff:?} becomes {is:?}", A::NAME, B::NAME);
        assert!(Attenuation::new(x, y, z) == Some(is), "{context}");

        let given = falloff.coefficients().map(Number::exact);
        let vanish = given.iter().all(|x| B::of(*x).exact() == 0.0);
        for q in [0.0, 0.01, 0.5, 1.0, 3.0, 25.0, 200.0] {
            let q = B::of(q);
            let denominator = |side: f64| {
                let moved = given.map(|x| {
                    let step = if vanish {
                        2.0 * B::HALF_STEP
                    } else {
                        B::HALF_STEP
                    };
                    (x + side * (step + 2.0 * B::U * x)).max(0.0)
                });
                1.0 / exact_light(moved, q.exact())
            };
            // the sums and the quotient round, too
            let slack = 8.0 * B::U + 1e-9;
            let light = is.at(q).exact();
            // the denominator of fixed point is off by a step for each of its roundings, times q
            let roundings = 4.0 * B::HALF_STEP * (1.0 + q.exact());
            let brightest =
                1.0 / (denominator(-1.0) - roundings).max(0.0) * (1.0 + slack) + 4.0 * B::HALF_STEP;
            let darkest = 1.0 / (denominator(1.0) + roundings) * (1.0 - slack) - 4.0 * B::HALF_STEP;
            let most = B::MAX.exact();
            if denominator(1.0) > most / 4.0 {
                continue; // a sum overflows
            }
            assert!(
                light <= brightest.min(most),
                "{context} at {q:?}: {light} above {brightest}"
            );
            assert!(
                light >= darkest.min(most),
                "{context} at {q:?}: {light} below {darkest}"
            );
        }
    }
}

/// Of two falloffs, one of which is nowhere brighter, the cast is nowhere brighter, unless the new
/// type can say only one of them.
fn order<A: Number, B: Number>() {
    let mut random = Random(2);
    for _ in 0..2000 {
        let low = [(); 3].map(|()| A::of(coefficient(&mut random, [-30.0, 4.0])));
        let high = low.map(|x| x + A::of(coefficient(&mut random, [-30.0, 0.0])));
        let [Some(bright), Some(dark)] = [low, high].map(|[a, b, c]| Attenuation::new(a, b, c))
        else {
            continue;
        };
        let vanish = [low, high].map(|x| x.iter().all(|x| B::of(x.exact()).exact() == 0.0));
        if vanish[0] != vanish[1] {
            continue;
        }
        let [bright, dark] = [bright, dark].map(cast::<A, B>);
        for q in [0.0, 0.5, 3.0, 25.0, 200.0].map(B::of) {
            let context = format!("{} to {}: {low:?} and {high:?} at {q:?}", A::NAME, B::NAME);
            assert!(bright.at(q) >= dark.at(q), "{context}");
        }
    }
    // one coefficient alone keeps its order down to the least number
    let mut before: Option<Attenuation<B>> = None;
    for i in -600..20 {
        let c = A::of((f64::from(i) / 4.0).exp2());
        let Some(falloff) = Attenuation::new(A::ZERO, A::ZERO, c) else {
            continue;
        };
        let falloff = cast::<A, B>(falloff);
        if let Some(before) = before {
            assert!(
                before.at(B::ONE) >= falloff.at(B::ONE),
                "{} to {}: {c:?}",
                A::NAME,
                B::NAME
            );
        }
        before = Some(falloff);
    }
}

/// What there is not stays so, and what there is stays so.
fn ends<A: Number, B: Number>() {
    let free = cast::<A, B>(Attenuation::NONE);
    assert_eq!(free, Attenuation::NONE);
    for x in [0.25, 1.0, 8.0].map(A::of) {
        let some = |made: Option<Attenuation<A>>| cast::<A, B>(made.expect("above 0"));
        let squared = some(Attenuation::NONE.within(x));
        assert_eq!(
            (squared.range().map(B::exact), squared.is_gltf()),
            (Some(x.exact()), false)
        );
        let gltf = some(Attenuation::NONE.within_gltf(x));
        assert_eq!(
            (gltf.range().map(B::exact), gltf.is_gltf()),
            (Some(x.exact()), true)
        );
        let limited = some(Attenuation::NONE.clamped_to(x));
        assert_eq!(
            (limited.limit().map(B::exact), limited.range()),
            (Some(x.exact()), None)
        );
    }
    // the least range of one type is one above 0 in the other
    let least = A::of(2.0 * A::HALF_STEP);
    if let Some(ranged) = Attenuation::<A>::NONE.within(least) {
        let range = cast::<A, B>(ranged).range().unwrap_or(B::MAX);
        assert!(
            range > B::ZERO && range < B::ONE,
            "{} to {}: {range:?}",
            A::NAME,
            B::NAME
        );
    }
}

fn each<A: Number, B: Number>() {
    pair::<A, B>();
    order::<A, B>();
    ends::<A, B>();
}

fn from<A: Number>() {
    each::<A, f64>();
    each::<A, f32>();
    each::<A, Half>();
    each::<A, Bf16>();
    each::<A, Decimal>();
    #[cfg(feature = "fixed")]
    each::<A, shading::fixed::Fixed>();
}

#[test]
fn between_all_pairs_of_types() {
    from::<f64>();
    from::<f32>();
    from::<Half>();
    from::<Bf16>();
    from::<Decimal>();
    #[cfg(feature = "fixed")]
    from::<shading::fixed::Fixed>();
}

/// The least number above 0 of each type, where all coefficients would round to 0.
#[test]
fn the_least_number_of_a_type() {
    let faint = shading::f64::Attenuation::new(0.0, 0.0, 1e-300).expect("above 0");
    assert_eq!(
        faint.cast(|x| x as f32).coefficients()[2],
        f32::from_bits(1)
    );
    assert_eq!(faint.cast(Half::of).coefficients()[2].0, 2.0_f64.powi(-24));
    assert_eq!(faint.cast(Bf16::of).coefficients()[2].0, BF16_LEAST);
    assert_eq!(faint.cast(Decimal::of).coefficients()[2].0, 0.0001);
    #[cfg(feature = "fixed")]
    assert_eq!(
        faint.cast(shading::fixed::Fixed::new).coefficients()[2],
        shading::fixed::Fixed::STEP
    );
}

/// 1/(1 + 10⁻⁶ · 200²) = 0.96.
#[cfg(feature = "fixed")]
#[test]
fn a_coefficient_below_half_a_step_does_not_darken() {
    use shading::fixed::Fixed;
    let lamp = shading::f64::Attenuation::new(1.0, 0.0, 1e-6)
        .expect("valid")
        .cast(Fixed::new);
    assert_eq!(lamp.at(Fixed::from(200)), Fixed::ONE);
}
