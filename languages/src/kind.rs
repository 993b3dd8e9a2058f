//! What the functions take and give.

use shading::number::Measured;
use shading::{Arrival, Lobe, Real, Rgb, Scalar, UnitVec3, Vec3};

use crate::number::{Expr, variable};

/// A number that the table can be computed with.
pub trait Number: Real + Scalar + Lobe<Self> + shading::number::power::Bits {}
impl<T: Real + Scalar + Lobe<T> + shading::number::power::Bits> Number for T {}

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

type Fields = &'static [(&'static str, Kind)];

impl Kind {
    pub const STRUCTS: [Self; 6] = [
        Self::Light,
        Self::Material,
        Self::Arrival,
        Self::Sums,
        Self::Tangent,
        Self::Measured,
    ];

    /// The name of a struct, what it is, and its fields.
    #[must_use]
    pub fn fields(self) -> Option<(&'static str, &'static str, Fields)> {
        Some(match self {
            Self::Light => (
                "Light",
                "A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.",
                &[
                    ("position", Self::Vector),
                    ("is_sun", Self::Flag),
                    ("intensity", Self::Color),
                    ("limit", Self::Positive),
                    ("coefficients", Self::Color),
                    ("range", Self::Positive),
                    ("axis", Self::Unit),
                    ("is_smoothstep", Self::Flag),
                    ("cosines", Self::Cosines),
                    ("is_gltf", Self::Flag),
                ],
            ),
            Self::Material => (
                "Material",
                "The reflectances of a surface, and its shininess m.",
                &[
                    ("k_a", Self::Color),
                    ("m", Self::Positive),
                    ("k_d", Self::Color),
                    ("k_s", Self::Color),
                ],
            ),
            Self::Arrival => (
                "Arrival",
                "What arrives at a point from one light: L, the distance q and I.",
                &[("l", Self::Unit), ("q", Self::Positive), ("i", Self::Color)],
            ),
            Self::Sums => (
                "Sums",
                "The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.",
                &[("diffuse", Self::Color), ("specular", Self::Color)],
            ),
            Self::Tangent => (
                "Tangent",
                "The tangent t of a triangle with texture coordinates, and its handedness h.",
                &[("t", Self::Unit), ("h", Self::Number)],
            ),
            Self::Measured => (
                "Measured",
                "A vector w of the direction of another, whose square is in range, |w|, and the length of the other.",
                &[
                    ("w", Self::Vector),
                    ("w_length", Self::Positive),
                    ("v_length", Self::Positive),
                ],
            ),
            _ => return None,
        })
    }

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

impl<T: Number> Parts<T> for T {
    fn parts(self) -> Vec<T> {
        vec![self]
    }
}

impl<T: Number> Parts<T> for Vec3<T> {
    fn parts(self) -> Vec<T> {
        vec![self.x, self.y, self.z]
    }
}

impl<T: Number> Parts<T> for Rgb<T> {
    fn parts(self) -> Vec<T> {
        vec![self.r, self.g, self.b]
    }
}

impl<T: Number> Parts<T> for UnitVec3<T> {
    fn parts(self) -> Vec<T> {
        Vec3::from(self).parts()
    }
}

/// 0 where there is no direction.
impl<T: Number> Parts<T> for Option<UnitVec3<T>> {
    fn parts(self) -> Vec<T> {
        self.map_or_else(|| Vec3::ZERO.parts(), Parts::parts)
    }
}

impl<T: Number> Parts<T> for Option<(UnitVec3<T>, T)> {
    fn parts(self) -> Vec<T> {
        self.map_or_else(|| vec![T::ZERO; 4], |(t, h)| [t.parts(), vec![h]].concat())
    }
}

impl<T: Number> Parts<T> for Measured<T> {
    fn parts(self) -> Vec<T> {
        [self.w.parts(), vec![self.w_length, self.length]].concat()
    }
}

impl<T: Number> Parts<T> for Arrival<T> {
    fn parts(self) -> Vec<T> {
        [self.l.parts(), vec![self.distance], self.intensity.parts()].concat()
    }
}

impl<T: Number> Parts<T> for [Rgb<T>; 2] {
    fn parts(self) -> Vec<T> {
        self.map(Parts::parts).concat()
    }
}

/// The arguments of a function, from its numbers.
pub struct Arguments<T>(std::vec::IntoIter<T>);

impl<T: Number> Arguments<T> {
    #[must_use]
    pub fn new(numbers: Vec<T>) -> Self {
        Self(numbers.into_iter())
    }

    fn next(&mut self) -> T {
        self.0.next().expect("an argument has all its numbers")
    }
}

/// A value that takes its numbers from the arguments.
pub trait Taken<T> {
    fn take(from: &mut Arguments<T>) -> Self;
}

impl<T: Number> Taken<T> for T {
    fn take(from: &mut Arguments<T>) -> T {
        from.next()
    }
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
    [T; 2]: |from| [from.next(), from.next()];
    Vec3<T>: |from| Vec3::new(from.next(), from.next(), from.next());
    UnitVec3<T>: |from| UnitVec3::assume_unit(Vec3::take(from));
    Rgb<T>: |from| Rgb::new(from.next(), from.next(), from.next());
}
