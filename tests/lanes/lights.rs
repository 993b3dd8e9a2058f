//! Lights in lanes: which light is in which lane, and in which order the lanes add up.

use proptest::prelude::*;
use shading::{
    Attenuation, DirectionalLight, Exponent, IncidentLight, Light, Material, PointLight, Ranged,
    Real, Rgb, Shaded, SoftCone, SpotLight, UnitVec3, Vec3, shade,
};

use crate::{Lamp, Lanes, Scalar, Surface, any_lamp, lamp, number};

/// Lights with what they differ in beside their numbers: the kind, whether the attenuation is clamped,
/// and the way the cone's edge is soft.
pub fn kinds() -> impl Strategy<Value = Vec<(Lamp, [usize; 3])>> {
    let kind = [0..3_usize, 0..2, 0..2];
    let few_kinds = prop::collection::vec(
        (any_lamp(), prop::sample::select(vec![[0; 3], [1; 3]])),
        0..40,
    );
    prop_oneof![prop::collection::vec((any_lamp(), kind), 0..40), few_kinds]
}

/// One of the edges, by its index, or any number.
pub fn edge() -> impl Strategy<Value = (usize, f64)> {
    (0..40_usize, number())
}

pub type AnyLight<S> = Light<S, SoftCone<S>, Ranged<S>>;

pub fn of_kind<S: Scalar>(lamp_: &Lamp, [kind, clamped, smoothstep]: [usize; 3]) -> AnyLight<S> {
    let [Light::Point(point), sun, Light::Spot(spot)] = lamp::<S>(lamp_) else {
        unreachable!("a point, a sun, a spot");
    };
    let attenuation = [point.attenuation, point.attenuation.clamped()][clamped];
    let point = PointLight {
        position: point.position,
        intensity: point.intensity,
        attenuation: Ranged::of(attenuation, S::of(8.0)).unwrap(),
    };
    let cone = SoftCone::of_cosines(S::ONE, spot.cone.cosine()).unwrap();
    let spot = SpotLight {
        point,
        axis: spot.axis,
        cone: [cone, cone.smoothstep()][smoothstep],
    };
    match (kind, sun) {
        (0, _) => point.into(),
        (1, _) => spot.into(),
        (_, Light::Directional(sun)) => sun.into(),
        _ => unreachable!("a sun"),
    }
}

fn black<S: Scalar>(mut light: AnyLight<S>) -> AnyLight<S> {
    match &mut light {
        Light::Directional(sun) => sun.intensity = Rgb::BLACK,
        Light::Point(point) | Light::Spot(SpotLight { point, .. }) => point.intensity = Rgb::BLACK,
    }
    light
}

/// Kinds come in the order of their first lights, and the lights of a kind in their own.
pub fn packs_hold<L: Lanes>(lights: &[(Lamp, [usize; 3])]) {
    // the sun has no attenuation, only the spot has a cone
    let kind = |[kind, clamped, smoothstep]: [usize; 3]| match kind {
        0 => [0, clamped, 0],
        1 => [1, clamped, smoothstep],
        _ => [2, 0, 0],
    };
    let mut kinds: Vec<([usize; 3], Vec<_>)> = vec![];
    for (lamp, differences) in lights {
        let (kind, light) = (kind(*differences), of_kind::<L::Scalar>(lamp, *differences));
        match kinds.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, lights)) => lights.push(light),
            None => kinds.push((kind, vec![light])),
        }
    }
    let expected = kinds.iter().flat_map(|(_, lights)| lights.chunks(L::COUNT));
    let expected = expected.map(|lights| {
        let first = black(lights[0]);
        let lane = |i| lights.get(i).copied().unwrap_or(first);
        (0..L::COUNT).map(lane).collect::<Vec<_>>()
    });

    let all: Vec<_> = lights
        .iter()
        .map(|(lamp, kind)| of_kind(lamp, *kind))
        .collect();
    let packs = AnyLight::packed::<L>(&all);
    let lanes = packs.map(|pack| {
        let lane = |i| pack.cast(|x: L| x.lane(i));
        (0..L::COUNT).map(lane).collect::<Vec<_>>()
    });
    assert_eq!(lanes.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
}

/// The sum as its page gives it.
fn halves<S: Real>(lanes: &[S]) -> S {
    if let [one] = lanes {
        return *one;
    }
    let (lower, upper) = lanes.split_at(lanes.len() / 2);
    let sums: Vec<_> = lower.iter().zip(upper).map(|(&a, &b)| a + b).collect();
    halves(&sums)
}

pub fn assert_same<S: Scalar>(lanes: impl Into<[S; 3]>, expected: impl Into<[S; 3]>) {
    let (lanes, expected) = (lanes.into(), expected.into());
    assert!(
        lanes.map(S::bits) == expected.map(S::bits),
        "{lanes:?} instead of {expected:?}"
    );
}

pub fn add_up_in_halves<L: Lanes>(numbers: &[(usize, f64)]) {
    let edges = L::Scalar::EDGES;
    let number = |i: usize| {
        let (edge, number) = numbers[i];
        edges.get(edge).copied().unwrap_or(L::Scalar::of(number))
    };
    let lanes: Vec<_> = (0..L::COUNT).map(number).collect();
    let of_lanes = L::from_fn(number);
    assert_same([of_lanes.sum(); 3], [halves(&lanes); 3]);
    assert_same([of_lanes.first(); 3], [lanes[0]; 3]);

    let part = Rgb::gray(of_lanes);
    let shaded = Shaded {
        ambient: part,
        diffuse: part,
        specular: part,
    }
    .sum_of_lanes();
    let sum = Rgb::gray(halves(&lanes).at_most(L::Scalar::MAX));
    assert_same(shaded.ambient, [lanes[0]; 3]);
    assert_same(shaded.diffuse, sum);
    assert_same(shaded.specular, sum);
}

pub fn lights_add_up_in_halves<L: Lanes>((p, n, v, at_the_light): Surface, lamps: &[Lamp], m: f64) {
    let p = if at_the_light {
        lamps.first().map_or(p, |lamp| lamp.0)
    } else {
        p
    };
    let [p, n, v] = [p, n, v].map(|v| Vec3::from(v.map(L::Scalar::of)));
    let [n, v] = [n, v].map(|direction| direction.unit_or(UnitVec3::X));
    let m = L::Scalar::of(m);
    for kind in 0..3 {
        let lights: Vec<_> = lamps.iter().map(|l| lamp::<L::Scalar>(l)[kind]).collect();
        lights_add_up::<L, _>(p, [n, v], &lights, m);
        lights_add_up::<L, u32>(p, [n, v], &lights, 50);
    }
}

/// Lights of one kind: each lane is the sum of every `COUNT`-th.
fn lights_add_up<L: Lanes, M: Exponent<L> + Exponent<L::Scalar>>(
    p: Vec3<L::Scalar>,
    [n, v]: [UnitVec3<L::Scalar>; 2],
    lights: &[Light<L::Scalar>],
    m: M,
) {
    let material = Material {
        k_a: Rgb::gray(L::Scalar::of(0.5)),
        k_d: Rgb::new(0.75, 0.5, 0.0).map(L::Scalar::of),
        k_s: Rgb::new(0.25, 1.0, 0.1).map(L::Scalar::of),
        m,
    };
    let i_a = Rgb::gray(L::Scalar::of(0.25));
    let in_lane = |i| {
        lights
            .iter()
            .skip(i)
            .step_by(L::COUNT)
            .map(|light| light.at(p))
    };
    let alone: Vec<_> = (0..L::COUNT)
        .map(|i| shade::blinn_phong(n, v, &material, i_a, in_lane(i)))
        .collect();
    let sum = |channel: fn(&Shaded<L::Scalar>) -> L::Scalar| {
        let lanes: Vec<_> = alone.iter().map(channel).collect();
        halves(&lanes).at_most(L::Scalar::MAX)
    };

    let packs: Vec<_> = Light::packed::<L>(lights).collect();
    assert_eq!(packs.len(), lights.len().div_ceil(L::COUNT));
    let (p, n, v) = (p.map(L::splat), n.cast(L::splat), v.cast(L::splat));
    let shaded = |lit: &mut dyn Iterator<Item = IncidentLight<L>>| {
        let (material, i_a) = (material.cast(L::splat), i_a.map(L::splat));
        shade::blinn_phong(n, v, &material, i_a, lit).sum_of_lanes()
    };
    for shaded in [
        shaded(&mut packs.iter().map(|pack| pack.at(p))),
        shaded(&mut packs.iter().filter_map(|pack| pack.in_front(p, n))),
    ] {
        assert_same(shaded.ambient, material.k_a * i_a);
        assert_same(
            shaded.diffuse,
            [
                sum(|s| s.diffuse.r),
                sum(|s| s.diffuse.g),
                sum(|s| s.diffuse.b),
            ],
        );
        assert_same(
            shaded.specular,
            [
                sum(|s| s.specular.r),
                sum(|s| s.specular.g),
                sum(|s| s.specular.b),
            ],
        );
    }
}

/// One by one the largest number comes out too.
pub fn overflow<L: Lanes>() {
    let sun = DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(L::Scalar::MAX),
    };
    let suns = vec![sun; L::COUNT + 1];
    let k = Rgb::gray(L::ONE);
    let mirror = Material {
        k_a: k,
        k_d: k,
        k_s: k,
        m: 1,
    };
    let packs = DirectionalLight::packed::<L>(&suns).map(|pack| pack.at(Vec3::ZERO));
    let shaded = shade::phong(UnitVec3::Z, UnitVec3::Z, &mirror, Rgb::BLACK, packs).sum_of_lanes();
    let largest = Rgb::gray(L::Scalar::MAX);
    assert_same(shaded.diffuse, largest);
    assert_same(shaded.specular, largest);
}

/// Lamps at the point, at infinity and nowhere leave the light of the one beside them as it is.
pub fn nowhere<L: Lanes>() {
    let zero = L::Scalar::ZERO;
    let at = |x| PointLight {
        position: Vec3::new(x, zero, zero),
        intensity: Rgb::gray(L::Scalar::ONE),
        attenuation: Attenuation::of(zero, zero, L::Scalar::ONE).unwrap(),
    };
    let [.., infinity, minus_infinity, nan] = L::Scalar::EDGES;
    let k = Rgb::gray(L::Scalar::ONE);
    let mirror = Material {
        k_a: k,
        k_d: k,
        k_s: k,
        m: 1,
    };
    let (p, n) = (Vec3::ZERO, UnitVec3::X);
    let lamp = at(L::Scalar::of(2.0));
    let alone = shade::blinn_phong(n, n, &mirror, k, [lamp.at(p)]);
    for place in [zero, infinity, minus_infinity, nan] {
        let lamps = [at(place), lamp, at(place)];
        let (p, n, i_a) = (p.map(L::splat), n.cast(L::splat), k.map(L::splat));
        let packs = PointLight::packed::<L>(&lamps).map(|pack| pack.at(p));
        let shaded = shade::blinn_phong(n, n, &mirror.cast(L::splat), i_a, packs).sum_of_lanes();
        assert_same(shaded.total(), alone.total());
    }
}
