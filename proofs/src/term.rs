//! A number that records a formula instead of computing it.
//!
//! Every operation adds a node to the graph of the [run](super::run), and every comparison is a decision of it.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::number::Mask;
use shading::{Lobe, Real, Rgb};

use super::graph::{MINUS_ONE, Node, ONE, Test, ZERO};
use super::range::Range;
use super::run::{decide, node, told, with};

/// A number that records the formula which it is put into. It implements [`Real`], and so every
/// formula that is generic over it can be proved.
#[derive(Clone, Copy, Debug)]
pub struct Term(#[doc(hidden)] pub u32);

/// A variable with a range.
pub(super) fn var(name: &str, range: Range) -> Term {
    with(|g| {
        g.names.push((name.into(), range));
        let index = u32::try_from(g.names.len() - 1).expect("fewer than 2³² variables");
        Term(g.node(Node::Var(index)))
    })
}

/// Makes a vector one of length 1, in a run with numbers.
pub(super) fn normalize(v: [Term; 3]) {
    with(|g| {
        let [x, y, z] = v.map(|c| g.values[c.0 as usize]);
        let length = (x * x + y * y + z * z).sqrt();
        if g.is_numeric() {
            let divisible = length > 0.1 && length.is_finite();
            let unit = if divisible {
                [x, y, z].map(|c| c / length)
            } else {
                [0.0, 0.0, 1.0]
            };
            for (c, x) in v.into_iter().zip(unit) {
                g.values[c.0 as usize] = g.format.round(x);
            }
        }
    });
}

macro_rules! operator {
    ($trait:ident::$method:ident) => {
        impl $trait for Term {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(node(Node::$trait(self.0, other.0)))
            }
        }
    };
}
operator!(Add::add);
operator!(Sub::sub);
operator!(Mul::mul);
operator!(Div::div);

impl Neg for Term {
    type Output = Self;
    fn neg(self) -> Self {
        Self(node(Node::Neg(self.0)))
    }
}

impl PartialEq for Term {
    fn eq(&self, other: &Self) -> bool {
        decide(Test::Equal(self.0, other.0))
    }
}

impl PartialOrd for Term {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self > other {
            Some(Ordering::Greater)
        } else if self < other {
            Some(Ordering::Less)
        } else {
            (self == other).then_some(Ordering::Equal)
        }
    }
    fn gt(&self, other: &Self) -> bool {
        decide(Test::Above(self.0, other.0))
    }
    fn lt(&self, other: &Self) -> bool {
        other > self
    }
    fn le(&self, other: &Self) -> bool {
        decide(Test::AtMost(self.0, other.0))
    }
    fn ge(&self, other: &Self) -> bool {
        decide(Test::AtMost(other.0, self.0))
    }
}

impl Real for Term {
    type Mask = Above;
    type Sum = Rgb<Self>;

    const ZERO: Self = Self(ZERO);
    const ONE: Self = Self(ONE);
    const NEG_ONE: Self = Self(MINUS_ONE);
    const MAX: Self = Self(3);
    const EXTREME: Self = Self(4);

    fn of(literal: f64) -> Self {
        let bits = with(|g| g.format.round(literal).to_bits());
        Self(node(Node::Constant(bits)))
    }
    fn sqrt(self) -> Self {
        Self(node(Node::Sqrt(self.0)))
    }
    fn above(self, other: Self) -> Above {
        Above(Test::Above(self.0, other.0))
    }
    // one decision, for what floats decide by one comparison of bits
    fn any_outside(self, low: Self, high: Self) -> bool {
        let below_high = high.above(self).select(Self::ONE, Self::ZERO).0;
        let test = Test::AtMost(low.0, self.0);
        let is_inside = Self(node(Node::Select(test, below_high, ZERO)));
        !is_inside.above(Self::ZERO).any()
    }
}

/// A comparison, which is a decision only where a path depends on it.
#[derive(Clone, Copy, Debug)]
pub struct Above(Test);

impl Mask<Term> for Above {
    fn any(self) -> bool {
        decide(self.0)
    }

    fn all(self) -> bool {
        decide(self.0)
    }

    fn select(self, then: Term, otherwise: Term) -> Term {
        let Self(test) = self;
        if then.0 == otherwise.0 {
            return then;
        }
        match told(test) {
            Some(answer) => [otherwise, then][usize::from(answer)],
            None => Term(node(Node::Select(test, then.0, otherwise.0))),
        }
    }
}

impl Lobe<Self> for Term {
    fn raise(self, cosine: Self) -> Self {
        Self(node(Node::Power(cosine.0, self.0)))
    }
}
