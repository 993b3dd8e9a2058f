//! Several lights at a time, at one point: the bits of a sum over the lights one by one.

use shading::{
    Exponent, InLanes, IncidentLight, Material, PointLight, Ranged, Real, Rgb, SpotLight, UnitVec3,
    Vec3, shade,
};

use crate::lights::{AnyLight, assert_same, of_kind};
use crate::{Lamp, Lanes, Surface, lamp};

/// A point, with N, V and m.
struct Place<L: Lanes, M> {
    p: Vec3<L::Scalar>,
    n: UnitVec3<L::Scalar>,
    v: UnitVec3<L::Scalar>,
    m: M,
}

impl<L: Lanes, M: Exponent<L> + Exponent<L::Scalar>> Place<L, M> {
    fn assert_same_sums(
        &self,
        all: impl Fn() -> Vec<IncidentLight<L>>,
        one_by_one: impl Fn() -> Vec<IncidentLight<L::Scalar>>,
    ) {
        let Self { n, v, m, .. } = *self;
        let material = Material {
            k_a: Rgb::gray(L::Scalar::of(0.5)),
            k_d: Rgb::new(0.75, 0.5, 0.0).map(L::Scalar::of),
            k_s: Rgb::new(0.25, 1.0, 0.1).map(L::Scalar::of),
            m,
        };
        let i_a = Rgb::gray(L::Scalar::of(0.25));
        let (of_all, alone) = (all(), one_by_one());
        assert_eq!(of_all.len(), alone.len().div_ceil(L::COUNT));
        for (all, alone) in [
            (
                shade::lambert(n, &material, i_a, InLanes(all().into_iter())),
                shade::lambert(n, &material, i_a, one_by_one()),
            ),
            (
                shade::phong(n, v, &material, i_a, InLanes(all().into_iter())),
                shade::phong(n, v, &material, i_a, one_by_one()),
            ),
            (
                shade::blinn_phong(n, v, &material, i_a, InLanes(all().into_iter())),
                shade::blinn_phong(n, v, &material, i_a, one_by_one()),
            ),
        ] {
            assert_same(all.ambient, alone.ambient);
            assert_same(all.diffuse, alone.diffuse);
            assert_same(all.specular, alone.specular);
        }
        // what arrives is the same too, and the lanes of no light are black
        for (i, alone) in alone.iter().enumerate() {
            let lane = of_all[i / L::COUNT].cast(|x| x.lane(i % L::COUNT));
            assert_same(*lane.l, *alone.l);
            assert_same(lane.intensity, alone.intensity);
            assert_same([lane.distance; 3], [alone.distance; 3]);
        }
        for i in alone.len()..of_all.len() * L::COUNT {
            let lane = of_all[i / L::COUNT].cast(|x| x.lane(i % L::COUNT));
            assert_same(lane.intensity, Rgb::BLACK);
        }
    }

    fn assert_same_for(&self, lights: &[(Lamp, [usize; 3])]) {
        let p = self.p;
        let mixed: Vec<AnyLight<_>> = lights
            .iter()
            .map(|(lamp, kind)| of_kind(lamp, *kind))
            .collect();
        self.assert_same_sums(
            || AnyLight::all_at::<L>(&mixed, p).0.collect(),
            || mixed.iter().map(|light| light.at(p)).collect(),
        );

        // each kind alone, with a hard cone and without a range
        let kinds = lights.iter().map(|(numbers, _)| lamp::<L::Scalar>(numbers));
        let (points, spots): (Vec<PointLight<_>>, Vec<SpotLight<_>>) = kinds
            .map(|kinds| match kinds {
                [shading::Light::Point(point), _, shading::Light::Spot(spot)] => (point, spot),
                _ => unreachable!("a point, a sun, a spot"),
            })
            .unzip();
        self.assert_same_sums(
            || PointLight::all_at(&points, p).0.collect(),
            || points.iter().map(|light| light.at(p)).collect(),
        );
        let ranged: Vec<PointLight<_, Ranged<_>>> = points
            .iter()
            .zip(lights)
            .map(|(point, (_, [.., unsquared]))| {
                let range = Ranged::of(point.attenuation, L::Scalar::of(8.0)).unwrap();
                PointLight {
                    position: point.position,
                    intensity: point.intensity,
                    attenuation: [range, range.unsquared()][*unsquared],
                }
            })
            .collect();
        self.assert_same_sums(
            || PointLight::all_at(&ranged, p).0.collect(),
            || ranged.iter().map(|light| light.at(p)).collect(),
        );
        self.assert_same_sums(
            || SpotLight::all_at(&spots, p).0.collect(),
            || spots.iter().map(|light| light.at(p)).collect(),
        );
    }
}

pub fn are_as_one_by_one<L: Lanes>(
    (p, n, v, at_the_light): Surface,
    lights: &[(Lamp, [usize; 3])],
    m: f64,
) {
    let p = match lights.first() {
        Some((lamp, _)) if at_the_light => lamp.0,
        _ => p,
    };
    let [p, n, v] = [p, n, v].map(|v| Vec3::from(v.map(L::Scalar::of)));
    let [n, v] = [n, v].map(|direction| direction.unit_or(UnitVec3::X));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    Place::<L, u32> {
        p,
        n,
        v,
        m: m as u32,
    }
    .assert_same_for(lights);
    let m = L::Scalar::of(m);
    Place::<L, L::Scalar> { p, n, v, m }.assert_same_for(lights);
}
