//! Every public function that computes something, each called by a function of its own.

#[cfg(feature = "wide")]
mod packed;

use std::hint::black_box;

use functions::{Given, Input, row};
use shading::{Rgb, UnitVec3, Vec3};

/// The number of places.
pub const CALLS: u16 = 4096;

/// Everything that a function may take, at a random surface point.
pub type Place = Given<f32>;

/// A function's name, and a function that calls it.
pub type Function = (&'static str, extern "C" fn(&Place));

macro_rules! counted {
    ($($row:ident $name:literal $call:path;)*) => {
        &[$({
            #[unsafe(export_name = concat!("shading_counted_", stringify!($row)))]
            #[inline(never)]
            extern "C" fn $row(place: &Place) {
                black_box($call(place));
            }
            ($name, $row)
        }),*]
    };
}

macro_rules! rows {
    (
        ARITHMETIC: Number $arithmetic:tt SWEEPS: Number $sweeps:tt SERIES: Float $series:tt
        $($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*
    ) => {
        counted! { $($($row $name row::$row;)*)* }
    };
}

/// The functions of the table.
const ROWS: &[Function] = functions::for_each_function!(rows);

/// What a call takes that does nothing.
const NOTHING: &[Function] = counted! { baseline "nothing" nothing; };

fn nothing(place: &Place) -> f32 {
    place.x
}

#[cfg(feature = "wide")]
const IN_LANES: &[Function] = counted! {
    points_packed "PointLight::packed, eight" packed::points;
    lights_packed "Light::packed, three kinds" packed::lights;
    sum_all_integer "shade::blinn_phong, integer m, four lights all at once" packed::sum_all_integer;
    sum_all_real "shade::blinn_phong, real m, four lights all at once" packed::sum_all_real;
    sum_all_kinds "shade::blinn_phong, integer m, three kinds all at once" packed::sum_all_kinds;
    sum_of_lanes "Shaded::sum_of_lanes, eight" packed::sum_of_lanes;
    sum_4_packed_integer "shade::blinn_phong, integer m, four lanes" packed::sum_4_integer;
    sum_4_packed_real "shade::blinn_phong, real m, four lanes" packed::sum_4_real;
    sum_8_packed_integer "shade::blinn_phong, integer m, eight lanes" packed::sum_8_integer;
    sum_8_packed_real "shade::blinn_phong, real m, eight lanes" packed::sum_8_real;
};
#[cfg(not(feature = "wide"))]
const IN_LANES: &[Function] = &[];

/// All functions.
pub fn all() -> impl Iterator<Item = &'static Function> {
    [NOTHING, ROWS, IN_LANES].into_iter().flatten()
}

/// Random places, with an m of 50 and 50.5.
pub fn places() -> Vec<Place> {
    let mut random = fastrand::Rng::with_seed(1975);
    (0..CALLS)
        .map(|_| Given::new(&input(&mut random)))
        .collect()
}

fn input(random: &mut fastrand::Rng) -> Input<f32> {
    let mut vector = || Vec3::from([(); 3].map(|()| 4.0 * random.f32() - 2.0));
    let [p, a, b, c, scalars] = [(); 5].map(|()| vector());
    let [n, l, v, axis] = [(); 4].map(|()| *vector().unit_or(UnitVec3::Z));
    let share = |v: Vec3<f32>| v.map(|x| x.abs() / 2.0);
    let [rgb, k_a, k_d, k_s, intensity] =
        [(); 5].map(|()| Rgb::from(<[f32; 3]>::from(share(vector()))));
    let (coefficients, Vec3 { x, y, z: cosine }) = (share(vector()), share(scalars));
    Input {
        is_valid: true,
        p,
        a,
        b,
        c,
        n,
        l,
        v,
        axis,
        x,
        y,
        cosine,
        rgb,
        k_a,
        k_d,
        k_s,
        intensity,
        coefficients,
        range: 4.0,
        edge: 0.877, // the cosine of half a radian
        edges: [0.955, 0.877],
        integer_m: 50,
        real_m: 50.5,
        bits: scalars.x.to_bits(),
    }
}
