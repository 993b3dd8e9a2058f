//! Prints how many bytes of stack, below the caller, the sum over a slice of lights takes: Lambert,
//! Phong and Blinn–Phong with an integer m, the last two with a real m; then, in fixed point, the
//! first three.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::{AMBIENT, CAP, LIGHTS, board, brass};
use shading::fixed::Fixed;
use shading::{Light, Lobe, Material, Real, Rgb, Shaded, UnitVec3, Vec3, shade};

firmware::program!(
    depth::<f32, _>(lambert, 32),
    depth::<f32, _>(phong, 32),
    depth::<f32, _>(blinn_phong, 32),
    depth::<f32, _>(phong, 32.5),
    depth::<f32, _>(blinn_phong, 32.5),
    depth::<Fixed, _>(lambert, 32),
    depth::<Fixed, _>(phong, 32),
    depth::<Fixed, _>(blinn_phong, 32)
);

/// The measured call, as firmware makes it: one function that gets everything it needs.
type Sum<T, M> = fn(Vec3<T>, [UnitVec3<T>; 2], &Material<T, M>, Rgb<T>, &[Light<T>]) -> Shaded<T>;

macro_rules! sums {
    ($($sum:ident($($v:ident)?);)*) => {$(
        fn $sum<T: Real, M: Lobe<T>>(
            p: Vec3<T>,
            [n, _v]: [UnitVec3<T>; 2],
            material: &Material<T, M>,
            i_a: Rgb<T>,
            lights: &[Light<T>],
        ) -> Shaded<T> {
            $(let $v = _v;)?
            shade::$sum(n, $($v,)? material, i_a, lights.iter().map(|light| light.at(p)))
        }
    )*};
}

sums! {
    lambert();
    phong(v);
    blinn_phong(v);
}

fn depth<T: Real, M: Lobe<T>>(sum: Sum<T, M>, m: M) -> usize {
    let [n, v] = black_box([CAP[1], CAP[0]].map(|n| n.cast(T::of_f32)));
    let (material, i_a) = (&brass(m), black_box(AMBIENT.map(T::of_f32)));
    let sum = black_box(sum); // a call that cannot be inlined
    let lights = &LIGHTS.map(|light| light.cast(T::of_f32));
    board::stack(|| _ = black_box(&sum(*n, [n, v], material, i_a, black_box(lights))))
}
