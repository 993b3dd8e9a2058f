//! What the functions take and give.

use shading::number::{Measured, power};
use shading::{Arrival, Elementary, Lobe, Material, Rgb, Scalar, UnitVec3, Vec3};

/// A number that the table can be computed with.
pub trait Number: Elementary + Scalar + Lobe<Self> + power::Bits {}
impl<T: Elementary + Scalar + Lobe<T> + power::Bits> Number for T {}

/// The kind of a parameter or a result: its type, and which numbers it may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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

/// Names and kinds of fields.
type Fields = &'static [(&'static str, Kind)];

impl Kind {
    /// Its fields or components; a number has none.
    pub(crate) fn parts(self) -> Fields {
        use Kind::{Cosine, Cosines, Flag, Fraction, Number, Pair, Positive};
        match (self, self.fields()) {
            (_, Some((_, _, fields))) => fields,
            (Number | Positive | Cosine | Fraction | Flag, _) => &[],
            (Pair | Cosines, _) => &[("x", Number), ("y", Number)],
            _ => &[("x", Number), ("y", Number), ("z", Number)],
        }
    }

    /// How many numbers it has.
    #[must_use]
    pub fn width(self) -> usize {
        let widths = self.parts().iter().map(|part| part.1.width());
        widths.sum::<usize>().max(1)
    }
}

/// A value of some numbers.
pub trait Value<T> {
    /// Takes its numbers from the next ones.
    fn take(from: &mut dyn Iterator<Item = T>) -> Self;
    /// Its numbers, in the order of its fields.
    fn numbers(self) -> Vec<T>;
}

macro_rules! values {
    ($($type:ty: |$from:ident| $taken:expr, |$value:ident| $numbers:expr;)*) => {$(
        impl<T: Number> Value<T> for $type {
            fn take($from: &mut dyn Iterator<Item = T>) -> Self {
                $taken
            }
            fn numbers(self) -> Vec<T> {
                let $value = self;
                $numbers
            }
        }
    )*};
}

/// The type of a kind.
macro_rules! of_kind {
    (Vector) => { Vec3<T> };
    (Unit) => { UnitVec3<T> };
    (Color) => { Rgb<T> };
    (Pair) => { [T; 2] };
    (Cosines) => { [T; 2] };
    (Light) => { Light<T> };
    (Material) => { Material<T, T> };
    (Arrival) => { Arrival<T> };
    (Sums) => { Sums<T> };
    (Tangent) => { Tangent<T> };
    (Measured) => { Measured<T> };
    ($number:ident) => { T };
}
pub(crate) use of_kind;

macro_rules! defined {
    (the_crates $kind:ident $fields:tt) => {};
    (own $kind:ident { $($field:ident: $of:ident),* }) => {
        pub struct $kind<T> {
            $(pub $field: of_kind!($of)),*
        }
    };
}

macro_rules! structs {
    ($(#[doc = $doc:literal] $whose:ident $kind:ident { $($name:ident($field:ident): $of:ident),* $(,)? })*) => {
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

        $(defined!($whose $kind { $($field: $of),* });)*

        values! {$(
            of_kind!($kind):
                |from| Self { $($field: Value::take(from)),* },
                |all| [$(all.$field.numbers()),*].concat();
        )*}
    };
}

values! {
    T: |from| from.next().expect("a value has all its numbers"), |x| vec![x];
    [T; 2]: |from| [T::take(from), T::take(from)], |pair| pair.to_vec();
    [T; 3]: |from| [T::take(from), T::take(from), T::take(from)], |all| all.to_vec();
    Vec3<T>: |from| <[T; 3]>::take(from).into(), |v| vec![v.x, v.y, v.z];
    Rgb<T>: |from| <[T; 3]>::take(from).into(), |color| vec![color.r, color.g, color.b];
    UnitVec3<T>: |from| UnitVec3::assume_unit(Vec3::take(from)), |v| (*v).numbers();
    // 0 where there is no direction
    Option<UnitVec3<T>>: |from| Some(UnitVec3::take(from)), |v| v.map_or(Vec3::ZERO, |v| *v).numbers();
}

// beside the name of a field, the crate's
structs! {
    /// A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.
    own Light {
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
    the_crates Material { k_a(k_a): Color, m(m): Positive, k_d(k_d): Color, k_s(k_s): Color }

    /// What arrives at a point from one light: L, the distance q and I.
    the_crates Arrival { l(l): Unit, q(distance): Positive, i(intensity): Color }

    /// The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.
    own Sums { diffuse(diffuse): Color, specular(specular): Color }

    /// The tangent t of a triangle with texture coordinates, and its handedness h.
    own Tangent { t(t): Unit, h(h): Number }

    /// A vector w of the direction of another, whose square is in range, |w|, and the length of the other.
    the_crates Measured { w(w): Vector, w_length(w_length): Positive, v_length(length): Positive }
}
