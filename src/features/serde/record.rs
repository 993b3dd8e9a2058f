//! Structs as records of named fields. Each error names the field that it is about.

use core::convert::Infallible;
use core::fmt::{self, Display, Formatter};
use core::marker::PhantomData;

use serde_core::Deserializer;
use serde_core::de::{DeserializeOwned, DeserializeSeed, Error, SeqAccess, Unexpected, Visitor};

/// A type that a field of a record may have.
pub trait Field: DeserializeOwned {
    /// Refuses a value that a file may not contain.
    fn check(&self, _name: &'static str) -> Result<(), impl Display> {
        Ok::<(), Infallible>(())
    }

    fn read<'de, D: Deserializer<'de>>(name: &'static str, from: D) -> Result<Self, D::Error> {
        let value = Self::deserialize(from)?;
        value.check(name).map_err(D::Error::custom)?;
        Ok(value)
    }
}

impl Field for bool {}
impl Field for u32 {}

/// Reads the field with this name.
pub struct Named<F>(pub &'static str, pub PhantomData<F>);

impl<'de, F: Field> DeserializeSeed<'de> for Named<F> {
    type Value = F;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<F, D::Error> {
        F::read(self.0, from)
    }
}

/// Reads the next field of a record without names.
pub fn next<'de, F: Field, A: SeqAccess<'de>>(
    list: &mut A,
    name: &'static str,
) -> Result<F, A::Error> {
    required(list.next_element_seed(Named(name, PhantomData))?, name)
}

pub fn required<F, E: Error>(field: Option<F>, name: &'static str) -> Result<F, E> {
    field.ok_or_else(|| E::missing_field(name))
}

/// Reads a value that has several parts, which have names or an order. Either is read, whatever the
/// format says of itself: what serde buffers for an untagged enum or a flattened field says that it is
/// human-readable, also if a binary format wrote it without names.
pub struct Form<V> {
    /// Whether the format says that it is human-readable, and so can say what comes next.
    pub has_names: bool,
    value: PhantomData<V>,
}

impl<V> Form<V> {
    pub fn of<'de, D: Deserializer<'de>>(from: &D) -> Self {
        let (has_names, value) = (from.is_human_readable(), PhantomData);
        Self { has_names, value }
    }
}

/// Reads the name of a field or a variant, or its index in a format without names.
pub enum Key {
    Field(&'static [&'static str]),
    Variant(&'static [&'static str]),
}

impl Key {
    fn names(&self) -> &'static [&'static str] {
        let (Self::Field(names) | Self::Variant(names)) = self;
        names
    }
}

impl<'de> DeserializeSeed<'de> for Key {
    type Value = &'static str;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<&'static str, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Key {
    type Value = &'static str;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "one of {:?}", self.names())
    }

    fn visit_u64<E: Error>(self, index: u64) -> Result<&'static str, E> {
        let mut names = self.names().iter().zip(0..);
        let name = names.find(|(_, i)| *i == index).map(|(name, _)| *name);
        name.ok_or_else(|| E::invalid_value(Unexpected::Unsigned(index), &self))
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<&'static str, E> {
        let name = self.names().iter().copied().find(|name| *name == key);
        name.ok_or_else(|| match self {
            Self::Field(names) => E::unknown_field(key, names),
            Self::Variant(names) => E::unknown_variant(key, names),
        })
    }
}

/// Reads the entries of a map into variables of the same names, each an `Option`. A repeated entry
/// is an error.
macro_rules! entries {
    ($map:ident: $($field:ident),+) => {
        $(let mut $field = None;)+
        while let Some(key) = $map.next_key_seed(Key::Field(&[$(stringify!($field)),+]))? {
            $(if key == stringify!($field) {
                if $field.is_some() {
                    return Err(A::Error::duplicate_field(key));
                }
                $field = Some($map.next_value_seed(Named(key, PhantomData))?);
            })+
        }
    };
}

/// Reads and writes a struct as a map of all its fields, or as a list of them in a format without
/// names.
macro_rules! record {
    ($type:ident<$($parameter:ty),+> { $($field:ident),+ }) => {
        impl Field for $type<$($parameter),+> {}

        impl Serialize for $type<$($parameter),+> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                let count = [$(stringify!($field)),+].len();
                let mut record = to.serialize_struct(stringify!($type), count)?;
                $(
                    self.$field.check(stringify!($field)).map_err(S::Error::custom)?;
                    record.serialize_field(stringify!($field), &self.$field)?;
                )+
                record.end()
            }
        }

        impl<'de> Deserialize<'de> for $type<$($parameter),+> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let form = Form::<Self>::of(&from);
                from.deserialize_struct(stringify!($type), &[$(stringify!($field)),+], form)
            }
        }

        impl<'de> Visitor<'de> for Form<$type<$($parameter),+>> {
            type Value = $type<$($parameter),+>;

            fn expecting(&self, f: &mut Formatter) -> fmt::Result {
                write!(f, "a map with the fields {:?}", [$(stringify!($field)),+])
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                entries!(map: $($field),+);
                Ok($type {
                    $($field: required($field, stringify!($field))?),+
                })
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                Ok($type {
                    $($field: next(&mut list, stringify!($field))?),+
                })
            }
        }
    };
}

pub(super) use {entries, record};
