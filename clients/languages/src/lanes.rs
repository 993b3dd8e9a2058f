//! Numbers side by side in a register of one processor, by its instructions.
//!
//! The lanes of `wide` are chosen when the program is built, and take several instructions for some operations
//! that take one here. Everything here is inlined, and so compiled for the processor of the function that it is
//! inlined into. That function runs only where the processor has the instructions, on which each `unsafe` here
//! relies.

macro_rules! operators {
    ($lanes:ident by $by:ident, $($trait:ident $function:ident),*) => {$(
        impl std::ops::$trait for $lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(unsafe { $by::$function(self.0, other.0) })
            }
        }
    )*};
}
pub(crate) use operators;

/// Lanes by a module of functions, which are named as those of AVX2 are used: `max` and `min` give the second
/// operand unless the first is greater or less, and `blend` gives the second where the third holds.
macro_rules! lanes {
    (
        $lanes:ident, $above:ident: $count:literal $float:ident in $register:ident by $by:ident, as $wide:ident
        $(; $($method:item)*)?
    ) => {
        #[derive(Clone, Copy)]
        pub struct $lanes($register);

        /// The lanes in which a comparison holds.
        #[derive(Clone, Copy)]
        pub struct $above($register);

        impl $lanes {
            const fn all(x: $float) -> Self {
                Self(unsafe { std::mem::transmute::<[$float; $count], $register>([x; $count]) })
            }
        }

        operators!($lanes by $by, Add add, Sub sub, Mul mul, Div div);

        impl std::ops::Neg for $lanes {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(unsafe { $by::negative(self.0) })
            }
        }

        impl Real for $lanes {
            type Mask = $above;
            type Sum = Rgb<Self>;

            const ZERO: Self = Self::all(0.0);
            const ONE: Self = Self::all(1.0);
            const NEG_ONE: Self = Self::all(-1.0);
            const MAX: Self = Self::all($float::MAX);
            const EXTREME: Self = Self::all(<$float as Real>::EXTREME);

            #[inline(always)]
            fn of(literal: f64) -> Self {
                Self::all($float::of(literal))
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $by::sqrt(self.0) })
            }

            #[inline(always)]
            fn above(self, other: Self) -> $above {
                $above(unsafe { $by::above(self.0, other.0) })
            }

            // the comparison of the default
            #[inline(always)]
            fn at_least(self, floor: Self) -> Self {
                Self(unsafe { $by::max(self.0, floor.0) })
            }

            #[inline(always)]
            fn at_most(self, limit: Self) -> Self {
                Self(unsafe { $by::min(limit.0, self.0) })
            }

            #[inline(always)]
            fn finite(self) -> Self {
                Self(unsafe { $by::min(self.0, Self::MAX.0) })
            }
        }

        impl Mask<$lanes> for $above {
            #[inline(always)]
            fn any(self) -> bool {
                unsafe { $by::bits(self.0) != 0 }
            }

            #[inline(always)]
            fn all(self) -> bool {
                unsafe { $by::bits(self.0) == (1 << $count) - 1 }
            }

            #[inline(always)]
            fn select(self, then: $lanes, otherwise: $lanes) -> $lanes {
                $lanes(unsafe { $by::blend(otherwise.0, then.0, self.0) })
            }
        }

        impl Pack for $lanes {
            type Lane = $float;
            const COUNT: usize = $count;

            #[inline(always)]
            fn splat(x: $float) -> Self {
                Self::all(x)
            }

            #[inline(always)]
            fn gather(lane: impl Fn(usize) -> $float) -> Self {
                let lanes: [$float; $count] = std::array::from_fn(lane);
                Self(unsafe { std::mem::transmute::<[$float; $count], $register>(lanes) })
            }

            #[inline(always)]
            fn scatter(self, mut put: impl FnMut(usize, $float)) {
                let lanes = unsafe { std::mem::transmute::<$register, [$float; $count]>(self.0) };
                for (i, lane) in lanes.into_iter().enumerate() {
                    put(i, lane);
                }
            }

            $($($method)*)?
        }

        impl $lanes {
            #[inline(always)]
            fn wide(self) -> wide::$wide {
                unsafe { std::mem::transmute::<$register, wide::$wide>(self.0) }
            }

            #[inline(always)]
            fn of_wide(lanes: wide::$wide) -> Self {
                Self(unsafe { std::mem::transmute::<wide::$wide, $register>(lanes) })
            }
        }

        /// A real power by the crate's lanes, whose integer steps are not public.
        impl Lobe<$lanes> for $float {
            #[inline(always)]
            fn raise(self, cosine: $lanes) -> $lanes {
                $lanes::of_wide(self.raise(cosine.wide()))
            }

            #[inline(always)]
            fn raise_root(self, square: $lanes) -> $lanes {
                $lanes::of_wide(self.raise_root(square.wide()))
            }

            #[inline(always)]
            fn raise_quotient(self, square: $lanes, of: $lanes) -> $lanes {
                $lanes::of_wide(self.raise_quotient(square.wide(), of.wide()))
            }
        }
    };
}
pub(crate) use lanes;
