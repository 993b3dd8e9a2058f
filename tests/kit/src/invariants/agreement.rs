//! What T computes is what the formula says, within the error that follows from the formula.

use core::fmt::Debug;
use std::format;
use std::vec::Vec;

use shading::{Dual, Lobe, Real, Vec3, attenuation, half_vector, normal, reflection, shade, term};

use super::tracked::decided;
use super::{Case, Law, Parts, Tracked, Tried, Verdict, n};

fn torus<T: Real>(p: Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

fn agrees<T: Tried>(computed: &[T], tracked: &[Tracked<T>], is_decided: bool) -> Verdict {
    if !is_decided || tracked.iter().any(|x| !x.error.is_finite()) {
        return Verdict::Open;
    }
    let is_near = |(x, t): (&T, &Tracked<T>)| (x.exact() - t.exact).abs() <= t.error;
    if computed.len() == tracked.len() && computed.iter().zip(tracked).all(is_near) {
        Verdict::Holds
    } else {
        let exact = tracked
            .iter()
            .map(|t| (t.exact, t.error))
            .collect::<Vec<_>>();
        Verdict::Fails(format!("{computed:?} instead of {exact:?}"))
    }
}

/// Each row runs in T and in the number that tracks its errors.
macro_rules! agreements {
    ($($name:ident: |$c:ident| $call:expr;)*) => {
        $(fn $name<T: Real + PartialOrd + Debug>($c: &Case<T>) -> Vec<T> {
            $call.parts()
        })*

        pub fn laws<T: Tried>() -> Vec<Law<T>> {
            [$((stringify!($name), (|case| {
                let (tracked, is_decided) = decided(|| $name(&case.tracked()));
                agrees(&$name(case), &tracked, is_decided)
            }) as fn(&Case<T>) -> Verdict)),*].into()
        }
    };
}

agreements! {
    operations: |c| n([c.x + c.y, c.x - c.y, c.x * c.y, c.x / (c.y + T::ONE), (c.x * c.y).sqrt()]);
    dot_cross: |c| [Vec3::splat(c.n.dot(c.v)), c.n.cross(c.l)];
    length: |c| n([c.a.length()]);
    direction: |c| c.a.unit();
    halfway_power: |c| n([T::halfway_power(*c.n, T::measured(c.a), *c.v, c.m)]);
    power_of_root: |c| n([c.m.raise_root(c.x)]);
    reflected: |c| reflection(c.n, c.l);
    halfway: |c| half_vector(c.l, c.v);
    lambert: |c| n([term::lambert(c.n, c.l)]);
    power: |c| n([c.m.raise(c.x)]);
    phong: |c| n([term::phong(c.n, c.v, c.m)]);
    normalization: |c| n([term::phong_normalization(c.q)]);
    falloff: |c| n([c.falloff.at(c.q), c.falloff.clamped().at(c.q), attenuation(c.x + T::ONE, c.y, c.x, c.q)]);
    ranged: |c| n([c.ranged.at(c.q), c.gltf().at(c.q)]);
    hard_cone: |c| n([c.hard.factor(c.axis, c.l)]);
    soft_cone: |c| n([c.soft.factor(c.axis, c.l), c.soft.smoothstep().factor(c.axis, c.l)]);
    lamp_direction: |c| c.lamp.at(c.p).l();
    lamp_distance: |c| n([c.lamp.at(c.p).distance()]);
    lamp_intensity: |c| c.lamp.at(c.p).intensity();
    ranged_lamp: |c| c.spot.point.at(c.p).intensity();
    spot: |c| c.spot.at(c.p).intensity();
    lambert_sum: |c| shade::lambert(c.n, &c.material, c.rgb, c.arriving());
    phong_sum: |c| shade::phong(c.n, c.v, &c.material, c.rgb, c.arriving());
    blinn_phong_sum: |c| shade::blinn_phong(c.n, c.v, &c.material, c.rgb, c.arriving());
    plane: |c| normal::plane(c.a.x, c.a.y, c.a.z);
    triangle: |c| normal::triangle(c.a, c.b, c.c);
    sphere: |c| normal::sphere(c.a, c.p);
    tangents: |c| normal::from_tangents(c.a, c.b);
    implicit: |c| normal::implicit(torus, c.grid[0]);
    parametric: |c| normal::parametric(|u, v| Vec3::new(u, v, u * u - v * v), c.x, c.y);
    transformed: |c| normal::transformed(c.n, [c.a, c.b, c.c]);
    corner: |c| normal::corner(c.grid[0], c.grid[1], c.grid[2]);
    mapped: |c| normal::mapped(c.n, *c.l, T::ONE, *c.v);
    tangent: |c| normal::tangent([c.a, c.b, c.c], [[c.x, c.y], [c.q, c.x], [c.y, c.q]]).map(|(t, _)| t);
    dual: |c| { let x = Dual::point(Vec3::new(c.x + T::ONE, c.y, c.q)); let y = (x.x * x.y + x.z / x.x).sqrt(); [Vec3::splat(y.value),
        y.gradient] };
}
