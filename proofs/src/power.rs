//! The power by a real m in `f32`, tried at every input of its two halves.
//!
//! `power` computes y = m log₂ c and then 2^y. A number that stands for m takes the logarithm out of the product and
//! puts any y in its place, so that each half has one input, and every one is tried.

#![allow(clippy::float_cmp)] // a power of 0 or 1 is exact
#![allow(clippy::inline_always)] // as in the crate, whose power it compiles

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::thread;

use shading::{Exponent, Real};

#[allow(unexpected_cfgs, clippy::pedantic)] // the crate's own settings
#[path = "../../src/exponent/power.rs"]
mod shipped;

use shipped::{Binary32, power};

/// The claims that are tried at every input, each with what it promises.
pub const CLAIMS: [(&str, &str); 1] = [(
    "real_powers",
    "`Exponent::raise` of `f32`, and so `term::phong` and `term::blinn`, by a real m, any bits: in [0, 1]; 0 for a cosine \
     that is not above 0 or is NaN; otherwise 1 for a cosine of 1 or above, and for an m that is not above 0 or is NaN, and \
     at least c − 2⁻²⁰ for m ≤ 1; every input of its logarithm and of its exponential is tried",
)];

/// A number, or m: its product with a logarithm is another number, which is given.
#[derive(Clone, Copy)]
struct Half<'a> {
    x: f32,
    product: Option<&'a Product>,
}

struct Product {
    y: f32,
    logarithm: Cell<f32>,
}

const fn plain<'a>(x: f32) -> Half<'a> {
    Half { x, product: None }
}

macro_rules! operators {
    ($($trait:ident::$method:ident)*) => {
        $(impl<'a> $trait for Half<'a> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                plain(self.x.$method(other.x))
            }
        })*
    };
}
operators!(Add::add Sub::sub Div::div);

impl Mul for Half<'_> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.product.map_or(plain(self.x * other.x), |product| {
            product.logarithm.set(other.x);
            plain(product.y)
        })
    }
}

impl Neg for Half<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        plain(-self.x)
    }
}

impl Real for Half<'_> {
    const ZERO: Self = plain(0.0);
    const ONE: Self = plain(1.0);
    const NEG_ONE: Self = plain(-1.0);
    const MAX: Self = plain(f32::MAX);
    const EXTREME: Self = plain(<f32 as Real>::EXTREME);
    #[inline(always)]
    fn of(literal: f64) -> Self {
        plain(Real::of(literal))
    }
    #[inline(always)]
    fn of_f32(literal: f32) -> Self {
        plain(literal)
    }
    fn sqrt(self) -> Self {
        plain(Real::sqrt(self.x))
    }
    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self.x > 0.0 { then } else { otherwise }
    }
    fn any_positive(self) -> bool {
        self.x > 0.0
    }
    #[inline(always)]
    fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
        if self.x > threshold.x {
            then
        } else {
            otherwise
        }
    }
}

impl Binary32 for Half<'_> {
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let (e, z) = self.x.split();
        (plain(e), plain(z))
    }
    #[inline(always)]
    fn two_to_low_byte(self) -> Self {
        plain(self.x.two_to_low_byte())
    }
}

/// The logarithm of a cosine below 1.
fn logarithm(c: f32) -> f32 {
    let product = Product {
        y: 0.0,
        logarithm: Cell::new(f32::NAN),
    };
    power(
        plain(c),
        Half {
            x: 1.0,
            product: Some(&product),
        },
    );
    product.logarithm.get()
}

/// 2^y.
fn exponential(y: f32) -> f32 {
    let product = Product {
        y,
        logarithm: Cell::new(f32::NAN),
    };
    power(
        plain(0.5),
        Half {
            x: 1.0,
            product: Some(&product),
        },
    )
    .x
}

/// The most by which 2^y falls where y rises.
const FALL: f32 = 1.0 / 8_388_608.0;
/// What cᵐ may lack of c, if m ≤ 1.
const LACK: f32 = 1.0 / 1_048_576.0;

/// For y from 0 down to −126: 2^y is in [0, 1], and falls no further than that from what a lesser y has. So does any
/// m log₂ c ≥ log₂ c from log₂ c, which is what m ≤ 1 gives, as rounding is monotone.
fn exponentials(from: u32, to: u32) -> bool {
    let mut largest = 0.0;
    (from..=to).rev().all(|bits| {
        let power = exponential(-f32::from_bits(bits));
        let is_right = (0.0..=1.0).contains(&power) && power >= largest - FALL;
        largest = power.max(largest);
        is_right
    })
}

/// For a cosine from 0 to 1: the logarithm is below 0 and finite, so that its product with any m is below 0, −0 or −∞,
/// and 2 to its power is no less than the cosine, but for what the falls leave.
fn logarithms(from: u32, to: u32) -> bool {
    (from..=to).all(|bits| {
        let c = f32::from_bits(bits);
        let y = logarithm(c);
        y < 0.0 && y > -200.0 && exponential(y) >= c - (LACK - FALL)
    })
}

/// For a cosine of 1 or above, and ∞: m is not used, and the power is 1.
fn bright(from: u32, to: u32) -> bool {
    (from..=to).all(|bits| power(f32::from_bits(bits), f32::NAN) == 1.0)
}

/// For any other cosine, which is not above 0 or NaN: 0, whatever the other half gives.
fn dark(from: u32, to: u32) -> bool {
    (from..=to).all(|bits| {
        let product = Product {
            y: 0.0,
            logarithm: Cell::new(f32::NAN),
        };
        power(
            plain(f32::from_bits(bits)),
            Half {
                x: 1.0,
                product: Some(&product),
            },
        )
        .x == 0.0
    })
}

/// For an m that is not above 0, or NaN: 1.
fn flat(from: u32, to: u32) -> bool {
    (from..=to).all(|bits| f32::from_bits(bits).raise(0.5_f32) == 1.0)
}

/// The two halves are those of what ships.
fn together(from: u32, to: u32) -> bool {
    (from..=to).all(|i| {
        let [c, m] = [
            i.wrapping_mul(0x9E37_79B9),
            i.wrapping_mul(0x85EB_CA6B) >> 1,
        ]
        .map(f32::from_bits);
        let y = (m * logarithm(c)).at_least(-126.0);
        !(c > 0.0 && c < 1.0 && m > 0.0) || m.raise(c).to_bits() == exponential(y).to_bits()
    })
}

/// What is tried, with inputs from these bits to those.
type Part = (fn(u32, u32) -> bool, u32, u32);

/// Tries everything.
pub fn is_proved() -> bool {
    let (one, infinity, minus) = (1.0_f32.to_bits(), f32::INFINITY.to_bits(), 1 << 31);
    let parts: [Part; 8] = [
        (exponentials, 0, 126.0_f32.to_bits()),
        (logarithms, 1, one - 1),
        (bright, one, infinity),
        (dark, infinity + 1, u32::MAX),
        (dark, 0, 0),
        (flat, minus, u32::MAX),
        (flat, infinity + 1, minus - 1),
        (together, 0, 1 << 24),
    ];
    thread::scope(|scope| {
        let parts = parts.map(|(each, from, to)| scope.spawn(move || each(from, to)));
        parts.into_iter().all(|part| part.join().unwrap_or(false))
    })
}
