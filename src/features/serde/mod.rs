//! Lights and materials in files. `docs/schema.md` describes the format.
//!
//! The implementations use `serde_core` directly, without `serde_derive` and the Rust parser that
//! it needs. Derived code could neither name the field of a wrong value nor access the private
//! fields of other modules.
//!
//! Nothing is written that could not be read back: reading and writing both call [`Field::check`].

mod complaint;
mod cone;
mod falloff;
mod record;
mod scene;
mod vector;

use core::fmt::{Debug, Display};

use serde_core::Serialize;

use self::complaint::{Complaint, Problem};
use self::record::Field;
use crate::Real;

/// The number types that files can hold.
trait Number: Real + PartialOrd + Debug + Serialize + Field {
    fn is_finite(self) -> bool {
        self.abs() <= Self::MAX
    }
}

macro_rules! number {
    ($float:ident) => {
        impl Number for $float {}

        impl Field for $float {
            fn check(&self, name: &'static str) -> Result<(), impl Display> {
                if self.is_finite() {
                    Ok(())
                } else {
                    Err(Complaint(name, Problem::NotFinite("", *self)))
                }
            }
        }
    };
}

number!(f32);
number!(f64);
