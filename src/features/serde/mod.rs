//! Lights and materials in files; `docs/schema.md` describes the forms.
//!
//! They are written by hand over `serde_core`, without `serde_derive` and the parser of Rust that it
//! needs: derived code would neither name the field of a wrong value nor see private fields from here.
//!
//! Nothing is written that could not be read again: both ways go through [`Field::check`].

mod checked;
mod complaint;
mod record;
mod scene;
mod triple;

use core::fmt::{Debug, Display};

use serde_core::Serialize;

use self::complaint::{Complaint, Problem};
use self::record::Field;
use crate::{Attenuation, Cone, Real};

/// The number types of files.
trait Number: Real + PartialOrd + Debug + Serialize + Field {
    fn attenuation(coefficients: [Self; 3]) -> Option<Attenuation<Self>>;
    fn cone_of_half_angle(radians: Self) -> Option<Cone<Self>>;
    fn cone_of_cosine(cosine: Self) -> Option<Cone<Self>>;

    fn is_finite(self) -> bool {
        self.abs() <= Self::MAX
    }
}

macro_rules! number {
    ($float:ident) => {
        impl Number for $float {
            fn attenuation([a, b, c]: [Self; 3]) -> Option<Attenuation<Self>> {
                Attenuation::<Self>::new(a, b, c)
            }

            fn cone_of_half_angle(radians: Self) -> Option<Cone<Self>> {
                Cone::<Self>::from_half_angle(radians)
            }

            fn cone_of_cosine(cosine: Self) -> Option<Cone<Self>> {
                Cone::<Self>::from_cosine(cosine)
            }
        }

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
