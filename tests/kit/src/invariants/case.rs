//! The inputs of the invariants: one strategy, in `f64`, for every number type.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use proptest::sample::select;
use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Light, Material, PointLight, Real, Rgb,
    SpotLight, UnitVec3, Vec3,
};

use super::{Tracked, Tried};
use crate::{rgb, vector};

/// What a case is made of.
#[derive(Clone, Debug)]
pub struct Numbers {
    directions: [[f64; 3]; 4],
    points: [[f64; 3]; 4],
    /// Numbers of few bits, whose sums and products every number type has exactly.
    grid: [[f64; 3]; 4],
    colors: [[f64; 3]; 6],
    shares: [f64; 8],
    m: u32,
    size: i32,
}

/// What the laws are tried with.
#[derive(Clone, Copy, Debug)]
pub struct Case<T> {
    pub n: UnitVec3<T>,
    pub l: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub axis: UnitVec3<T>,
    pub p: Vec3<T>,
    pub a: Vec3<T>,
    pub b: Vec3<T>,
    pub c: Vec3<T>,
    pub grid: [Vec3<T>; 4],
    pub q: T,
    pub x: T,
    pub y: T,
    pub rgb: Rgb<T>,
    pub falloff: Attenuation<T>,
    pub ranged: Attenuation<T>,
    pub hard: Cone<T>,
    pub soft: Cone<T>,
    pub material: Material<T>,
    pub sun: DirectionalLight<T>,
    pub lamp: PointLight<T>,
    pub far: PointLight<T>,
    pub spot: SpotLight<T>,
    pub m: u32,
}

const AXES: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [-1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, -1.0],
];

/// A direction by its angles, or along an axis, so that none shrinks to zero. Of four, the second may be
/// the first or opposite.
fn directions() -> impl Strategy<Value = [[f64; 3]; 4]> {
    let direction = || {
        let of_angles = |(polar, azimuth): (f64, f64)| {
            let ((s, c), (sine, cosine)) = (polar.sin_cos(), azimuth.sin_cos());
            [s * cosine, s * sine, c]
        };
        prop_oneof![1 => select(&AXES[..]), 8 => (0.0..PI, 0.0..TAU).prop_map(of_angles)]
    };
    let relation = prop_oneof![8 => Just(None), 1 => Just(Some(1.0)), 1 => Just(Some(-1.0))];
    (
        [direction(), direction(), direction(), direction()],
        relation,
    )
        .prop_map(|(mut d, relation)| {
            if let Some(sign) = relation {
                d[2] = d[1].map(|x| sign * x);
            }
            d
        })
}

/// Cases whose vectors are of ordinary size, and some of any size that the number type has.
pub fn numbers<T: Tried>() -> impl Strategy<Value = Numbers> {
    let point = || [-4.0..4.0, -4.0..4.0, -4.0..4.0];
    let grid = || [-8..=8, -8..=8, -8..=8].prop_map(|v| v.map(|x| f64::from(x) / 4.0));
    let color = || [0.0..2.0, 0.0..2.0, 0.0..2.0];
    let share = || prop_oneof![1 => select(&[0.0, 0.25, 0.5, 1.0][..]), 6 => 0.0..1.0];
    #[allow(clippy::cast_possible_truncation)]
    let exponents = (T::SMALLEST.log2() as i32)..(T::LARGEST.log2() as i32);
    (
        directions(),
        [point(), point(), point(), point()],
        [grid(), grid(), grid(), grid()],
        [color(), color(), color(), color(), color(), color()],
        [
            share(),
            share(),
            share(),
            share(),
            share(),
            share(),
            share(),
            share(),
        ],
        select(&[0_u32, 1, 2, 3, 8, 33, 100][..]),
        prop_oneof![4 => Just(0), 1 => exponents],
    )
        .prop_map(
            |(directions, points, grid, colors, shares, m, size)| Numbers {
                directions,
                points: points.map(|p| p.map(|x| x * f64::exp2(size.into()))),
                grid,
                colors,
                shares,
                m,
                size,
            },
        )
}

impl<T: Tried> Case<T> {
    pub fn new(numbers: &Numbers) -> Self {
        let [n, l, v, axis] = numbers.directions.map(vector).map(UnitVec3::assume_unit);
        let [p, a, b, c] = numbers.points.map(vector);
        let [k_a, k_d, k_s, intensity, other, rgb_] = numbers.colors.map(rgb);
        let [x, y, inner, outer, range, i, j, k] = numbers.shares;
        let size = f64::exp2(numbers.size.clamp(-4, 4).into());
        let falloff = Attenuation::new(T::of(i + 0.125), T::of(j / size), T::of(k / size / size));
        let falloff = falloff.expect("coefficients");
        let [inner, outer] = [inner, inner - (1.0 + inner) * outer]
            .map(|x| x * 0.875)
            .map(T::of);
        let soft = Cone::from_cosines(inner, outer).expect("in order");
        let lamp = PointLight {
            position: a,
            intensity,
            attenuation: falloff,
        };
        // often close to the distance
        let ranged = (a - p).length().at_most(T::of(T::LARGEST / 8.0)) * T::of(2.0 * range);
        let ranged = falloff.within(ranged.at_least(T::of(0.5)));
        let ranged = ranged.expect("above 0");
        let spot = PointLight {
            position: b,
            intensity: other,
            attenuation: ranged,
        };
        Self {
            n,
            l,
            v,
            axis,
            p,
            a,
            b,
            c,
            grid: numbers.grid.map(vector),
            q: T::of(4.0 * range),
            x: T::of(x),
            y: T::of(y),
            rgb: rgb_,
            falloff,
            ranged,
            hard: Cone::from_cosine(outer).expect("within 1"),
            soft,
            material: Material {
                k_a,
                k_d,
                k_s,
                m: numbers.m,
            },
            sun: DirectionalLight {
                l,
                intensity: other,
            },
            lamp,
            far: PointLight {
                position: c,
                intensity: other,
                attenuation: falloff.clamped(),
            },
            spot: SpotLight {
                point: spot,
                axis,
                cone: soft,
            },
            m: numbers.m,
        }
    }

    /// Any one case.
    pub fn sample() -> Self {
        Self::new(&Numbers {
            directions: [
                [0.0, 0.0, 1.0],
                [0.6, 0.0, 0.8],
                [0.0, 0.6, 0.8],
                [0.0, 0.0, -1.0],
            ],
            points: [
                [0.0; 3],
                [-2.0, 1.0, 5.0],
                [1.0, -2.0, 3.0],
                [3.0, 1.25, -0.75],
            ],
            grid: [[0.25, 0.5, 1.0]; 4],
            colors: [[1.0, 0.5, 0.25]; 6],
            shares: [0.25, 0.75, 0.9, 0.5, 1.0, 0.25, 0.5, 0.75],
            m: 9,
            size: 0,
        })
    }

    /// The same case, in the number that tracks the errors of T.
    pub fn tracked(&self) -> Case<Tracked<T>> {
        self.cast(Tracked::input)
    }
}

impl<T: Real> Case<T> {
    pub fn cast<U: Real>(&self, f: impl Fn(T) -> U + Copy) -> Case<U> {
        Case {
            n: self.n.cast(f),
            l: self.l.cast(f),
            v: self.v.cast(f),
            axis: self.axis.cast(f),
            p: self.p.map(f),
            a: self.a.map(f),
            b: self.b.map(f),
            c: self.c.map(f),
            grid: self.grid.map(|v| v.map(f)),
            q: f(self.q),
            x: f(self.x),
            y: f(self.y),
            rgb: self.rgb.map(f),
            falloff: self.falloff.cast(f),
            ranged: self.ranged.cast(f),
            hard: self.hard.cast(f),
            soft: self.soft.cast(f),
            material: self.material.cast(f),
            sun: self.sun.cast(f),
            lamp: self.lamp.cast(f),
            far: self.far.cast(f),
            spot: self.spot.cast(f),
            m: self.m,
        }
    }

    /// The falloff with a range, as in glTF.
    pub fn gltf(&self) -> Attenuation<T>
    where
        T: PartialOrd,
    {
        self.falloff
            .within_gltf(self.ranged.range())
            .expect("above 0")
    }

    /// A light of each kind.
    pub fn lights(&self) -> [Light<T>; 4] {
        [
            self.sun.into(),
            self.lamp.into(),
            self.spot.into(),
            self.far.into(),
        ]
    }

    pub fn arriving(&self) -> [IncidentLight<T>; 4] {
        self.lights().map(|light| light.at(self.p))
    }
}
