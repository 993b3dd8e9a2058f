//! The functions of the library that a shader can call, from the table of all functions, on inputs of any kind.

mod given;
mod output;

use functions::row::{saddle, torus};
use shading::f32::Vec3;
use shading::{
    Attenuation, Cone, Elementary, Exponent, Ranged, Real, SoftCone, UnitVec3, normal, shade, term,
};

use given::Given;
pub use given::Input;
pub use output::Output;
use output::Value;

/// `f32`, in generic code: the rows of the table take the operations of the traits, which are the same on
/// every processor.
pub trait Number: Elementary + PartialOrd + Into<f32> + Value {
    fn normalized(v: shading::Vec3<Self>) -> Option<UnitVec3<Self>>;
}

impl Number for f32 {
    fn normalized(v: Vec3) -> Option<UnitVec3> {
        UnitVec3::<f32>::normalized(v.x, v.y, v.z)
    }
}

pub trait Float: Number + Exponent<Self> {}

impl Float for f32 {}

fn operations<T: Number>(g: &Given<T>) -> impl Value {
    shading::Vec3::new(g.a.x / g.b.x, g.a.y / g.b.y, Real::sqrt(g.a.z.abs()))
}

macro_rules! kernels {
    (
        ARITHMETIC: Number $arithmetic:tt SWEEPS: Number $sweeps:tt SERIES: Float $series:tt
        BYTES: Number $bytes:tt ANGLES: Number $angles:tt OFF_GPU: Number $off_gpu:tt
        $($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*
    ) => {
        $($(
            fn $row<T: $bound>($given: &Given<T>) -> impl Value { $call }
        )*)*

        /// The functions, in the order of their numbers, which begin at 1.
        #[allow(non_camel_case_types)]
        enum Row { $($($row,)*)* }

        /// The name of each number; 0 is ÷ and √, which the functions take from the driver.
        pub const NAMES: &[&str] = &["÷ and √", $($($name,)*)*];

        pub fn call(function: u32, input: &Input) -> Output {
            let given = Given::by(input);
            $($(
                if function == Row::$row as u32 + 1 {
                    return $row(&given).output();
                }
            )*)*
            operations(&given).output()
        }
    };
}
functions::for_each_function!(kernels);
