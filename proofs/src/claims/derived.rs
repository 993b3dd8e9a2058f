//! What floats override in `Real`, against what the trait derives. Bitwuzla decides these claims.

use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::Real;
use shading_proofs::{Goal, Term};

use super::*;

/// A number that records, with the trait's own methods.
#[derive(Clone, Copy)]
struct Derived(Term);

macro_rules! operators {
    ($($trait:ident::$method:ident)*) => {
        $(impl $trait for Derived {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })*
    };
}
operators!(Add::add Sub::sub Mul::mul Div::div);

impl Neg for Derived {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Derived {
    const ZERO: Self = Self(Term::ZERO);
    const ONE: Self = Self(Term::ONE);
    const NEG_ONE: Self = Self(Term::NEG_ONE);
    const MAX: Self = Self(Term::MAX);
    const EXTREME: Self = Self(Term::EXTREME);
    fn of(literal: f64) -> Self {
        Self(Term::of(literal))
    }
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        Self(self.0.if_positive(then.0, otherwise.0))
    }
    fn any_positive(self) -> bool {
        self.0.any_positive()
    }
}

fn derived(given: Given, name: &str) -> Derived {
    Derived(given.any(name))
}

claims! {
    if_above_as_derived: "`Real::if_above` of floats is what the trait derives, to the bit, any bits" |given| {
        let [x, threshold, a, b] = ["x", "threshold", "a", "b"].map(|name| derived(given, name));
        vec![Goal::Same(x.if_above(threshold, a, b).0, x.0.if_above(threshold.0, a.0, b.0))]
    }
    at_least_as_derived: "`Real::at_least` and `Real::at_most` of floats are what the trait derives, to the bit, any bits" |given| {
        let (x, limit) = (derived(given, "x"), derived(given, "limit"));
        let (least, most) = (x.0.at_least(limit.0), x.0.at_most(limit.0));
        vec![Goal::Same(x.at_least(limit).0, least), Goal::Same(x.at_most(limit).0, most)]
    }
    abs_as_derived: "`Real::abs` of floats is what the trait derives, to the bit, any bits" |given| {
        let x = derived(given, "x");
        vec![Goal::Same(x.abs().0, x.0.abs())]
    }
    outside_as_derived: "`Real::any_outside`, as derived, is false only within the limits and true only outside or on them, any bits, for the two pairs of limits in use" |given| {
        let (x, one) = (derived(given, "x"), Derived::ONE);
        let limits = [(one / Derived::EXTREME, Derived::EXTREME), (Derived::ZERO, one)];
        let (low, high) = limits[given.one_of(2) as usize];
        if !x.any_outside(low, high) {
            vec![Goal::AtMost(low.0, x.0), Goal::AtMost(x.0, high.0)]
        } else if x.0 > low.0 && high.0 > x.0 {
            vec![Goal::Never]
        } else {
            vec![]
        }
    }
}
