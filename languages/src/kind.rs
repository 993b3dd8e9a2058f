//! What the functions take and give.

use shading::number::{Measured, power};
use shading::{Arrival, Lobe, Material, Real, Rgb, Scalar, UnitVec3, Vec3};

use crate::light::Light;
use crate::number::{Expr, variable};

/// A number that the table can be computed with.
pub trait Number: Real + Scalar + Lobe<Self> + power::Bits {}
impl<T: Real + Scalar + Lobe<T> + power::Bits> Number for T {}

/// The kind of a parameter or a result: its type, and which numbers it may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A number of at least 0.
    Positive,
    /// A cosine.
    Cosine,
    /// A number within 0 and 1.
    Fraction,
    /// 0 or 1.
    Flag,
    /// A texture coordinate.
    Pair,
    /// The cosines of the inner and the outer edge of a cone.
    Cosines,
    Vector,
    /// A vector of length 1.
    Unit,
    Color,
    Measured,
    Light,
    Material,
    Arrival,
    Tangent,
    Sums,
}

/// The names and the kinds of a struct's fields.
type Fields = &'static [(&'static str, Kind)];

macro_rules! structs {
    ($(#[doc = $doc:literal] $kind:ident: $type:ty { $($name:ident($field:ident): $of:ident),* $(,)? })*) => {
        impl Kind {
            pub const STRUCTS: &[Self] = &[$(Self::$kind),*];

            /// The name of a struct, what it is, and its fields.
            #[must_use]
            pub fn fields(self) -> Option<(&'static str, &'static str, Fields)> {
                match self {
                    $(Self::$kind => {
                        let fields = &[$((stringify!($name), Self::$of)),*];
                        Some((stringify!($kind), $doc, fields))
                    })*
                    _ => None,
                }
            }
        }

        $(impl<T: Number> Parts<T> for $type {
            fn parts(self) -> Vec<T> {
                [$(self.$field.parts()),*].concat()
            }
        }

        impl<T: Number> Taken<T> for $type {
            fn take(from: &mut Arguments<T>) -> Self {
                Self { $($field: Taken::take(from)),* }
            }
        })*
    };
}

// beside the name of a field, the crate's
structs! {
    /// A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.
    Light: Light<T> {
        position(position): Vector,
        is_sun(is_sun): Flag,
        intensity(intensity): Color,
        limit(limit): Positive,
        coefficients(coefficients): Color,
        range(range): Positive,
        axis(axis): Unit,
        is_smoothstep(is_smoothstep): Flag,
        cosines(cosines): Cosines,
        is_gltf(is_gltf): Flag,
    }

    /// The reflectances of a surface, and its shininess m.
    Material: Material<T, T> { k_a(k_a): Color, m(m): Positive, k_d(k_d): Color, k_s(k_s): Color }

    /// What arrives at a point from one light: L, the distance q and I.
    Arrival: Arrival<T> { l(l): Unit, q(distance): Positive, i(intensity): Color }

    /// The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.
    Sums: Sums<T> { diffuse(diffuse): Color, specular(specular): Color }

    /// The tangent t of a triangle with texture coordinates, and its handedness h.
    Tangent: Tangent<T> { t(t): Unit, h(h): Number }

    /// A vector w of the direction of another, whose square is in range, |w|, and the length of the other.
    Measured: Measured<T> { w(w): Vector, w_length(w_length): Positive, v_length(length): Positive }
}

pub(crate) struct Sums<T> {
    pub diffuse: Rgb<T>,
    pub specular: Rgb<T>,
}

pub(crate) struct Tangent<T> {
    pub t: Vec3<T>,
    pub h: T,
}

impl Kind {
    /// How many numbers it has.
    #[must_use]
    pub fn width(self) -> usize {
        match self {
            Self::Number | Self::Positive | Self::Cosine | Self::Fraction | Self::Flag => 1,
            Self::Pair | Self::Cosines => 2,
            _ => self.fields().map_or(3, |(_, _, fields)| {
                fields.iter().map(|field| field.1.width()).sum()
            }),
        }
    }

    /// The variables of a parameter of this kind, in order.
    pub(crate) fn variables(self, name: &str) -> Vec<Expr> {
        if let Some((_, _, fields)) = self.fields() {
            let field = |(field, kind): &(&str, Self)| kind.variables(&format!("{name}.{field}"));
            return fields.iter().flat_map(field).collect();
        }
        match self.width() {
            1 => vec![variable(name, None)],
            width => (0..3)
                .take(width)
                .map(|i| variable(name, Some(i)))
                .collect(),
        }
    }
}

/// The numbers of a value, in the order of its fields.
pub trait Parts<T> {
    fn parts(self) -> Vec<T>;
}

/// A value that takes its numbers from the arguments.
pub trait Taken<T> {
    fn take(from: &mut Arguments<T>) -> Self;
}

macro_rules! parts {
    ($($type:ty: |$value:ident| $numbers:expr;)*) => {$(
        impl<T: Number> Parts<T> for $type {
            fn parts(self) -> Vec<T> {
                let $value = self;
                $numbers
            }
        }
    )*};
}

parts! {
    T: |x| vec![x];
    Vec<T>: |all| all;
    Vec3<T>: |v| vec![v.x, v.y, v.z];
    Rgb<T>: |color| vec![color.r, color.g, color.b];
    UnitVec3<T>: |v| (*v).parts();
    [T; 2]: |pair| pair.to_vec();
    Option<UnitVec3<T>>: |v| v.map_or(Vec3::ZERO, |v| *v).parts(); // 0 where there is no direction
}

macro_rules! taken {
    ($($type:ty: |$from:ident| $value:expr;)*) => {$(
        impl<T: Number> Taken<T> for $type {
            fn take($from: &mut Arguments<T>) -> Self {
                $value
            }
        }
    )*};
}

taken! {
    T: |from| from.0.next().expect("an argument has all its numbers");
    [T; 2]: |from| [T::take(from), T::take(from)];
    Vec3<T>: |from| Vec3::new(T::take(from), T::take(from), T::take(from));
    UnitVec3<T>: |from| UnitVec3::assume_unit(Vec3::take(from));
    Rgb<T>: |from| Rgb::new(T::take(from), T::take(from), T::take(from));
}

/// The arguments of a function, from its numbers.
pub struct Arguments<T>(std::vec::IntoIter<T>);

impl<T: Number> Arguments<T> {
    #[must_use]
    pub fn new(numbers: Vec<T>) -> Self {
        Self(numbers.into_iter())
    }
}
