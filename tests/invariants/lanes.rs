//! The sum over lights in lanes: of w lanes, each of which takes every w-th light.
//!
//! Its terms have the bits that they have one by one, and are not negative. So a sum of n lights is off
//! by its own roundings only: ⌈n/w⌉ − 1 additions, the product with k and log₂ w additions, each by u of
//! the sum at most. A product that underflows is off by half of the smallest number.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestCaseResult;
use shading::{
    DirectionalLight, Exponent, IncidentLight, Lanes, Material, Real, Rgb, Shaded, Vec3, shade,
};
use shading_laws::Number;
use shading_laws::number::check::{check, same, to_f64, within};
use shading_laws::number::generators::{
    Model, Scene, Shine, adversarial_scene, model, scene, unit,
};

/// The shininess of a scene, for its lanes.
#[derive(Clone, Copy)]
struct InLanes(Shine);

impl<L: Lanes> Exponent<L> for InLanes
where
    L::Lane: Number + Exponent<L>,
{
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn raise(self, cosine: L) -> L {
        if self.0.whole {
            (self.0.m as u32).raise(cosine)
        } else {
            L::Lane::of(self.0.m).raise(cosine)
        }
    }

    fn half(self) -> Option<Self> {
        Exponent::<L::Lane>::half(self.0).map(Self)
    }
}

/// The scene, its lights in lanes.
fn in_lanes<L: Lanes>(model: Model, scene: &Scene<L::Lane>) -> Shaded<L::Lane>
where
    L::Lane: Number + Exponent<L>,
{
    let splat = |x| L::from_fn(|_| x);
    let (n, v, i_a) = (
        scene.n.cast(splat),
        scene.v.cast(splat),
        scene.i_a.map(splat),
    );
    let Material { k_a, k_d, k_s, m } = scene.material.cast(splat);
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: InLanes(m),
    };
    let lights: Vec<_> = scene.lights.iter().map(sun).collect();
    let packs = DirectionalLight::packed::<L>(&lights);
    let lit = packs.filter_map(|pack| pack.in_front(Vec3::ZERO, n));
    match model {
        Model::Lambert => shade::lambert(n, &material, i_a, lit),
        Model::Phong => shade::phong(n, v, &material, i_a, lit),
        Model::BlinnPhong => shade::blinn_phong(n, v, &material, i_a, lit),
    }
    .sum_of_lanes()
}

fn sun<T: Real>(&IncidentLight { l, intensity, .. }: &IncidentLight<T>) -> DirectionalLight<T> {
    DirectionalLight { l, intensity }
}

/// A scene with up to forty lights.
fn bright_scene<T: Number>() -> impl Strategy<Value = Scene<T>> {
    (scene::<T>(), vec(scene::<T>(), 0..5)).prop_map(|(mut scene, others)| {
        let more = others.into_iter().flat_map(|other| other.lights);
        scene.lights.extend(more);
        scene
    })
}

/// The roundings of a sum of so many lights.
fn roundings<L: Lanes>(lights: usize) -> f64 {
    lights.div_ceil(L::COUNT) as f64 + (L::COUNT as f64).log2()
}

/// Sums of `lights` lights, which differ by so many roundings, and by an underflow for each light on
/// either side.
fn agree<T: Number>(a: Shaded<T>, b: Shaded<T>, roundings: f64, lights: usize) -> TestCaseResult {
    same(a.ambient, b.ambient)?;
    for (a, b) in [(a.diffuse, b.diffuse), (a.specular, b.specular)] {
        for (a, b) in to_f64(a).into_iter().zip(to_f64(b)) {
            let underflow = lights as f64 * T::TINY.to_f64();
            within(a - b, roundings * T::U * a.max(b) + underflow)?;
        }
    }
    Ok(())
}

fn identical<T: Number>(a: Shaded<T>, b: Shaded<T>) -> TestCaseResult {
    same(a.ambient, b.ambient)?;
    same(a.diffuse, b.diffuse)?;
    same(a.specular, b.specular)
}

/// (1), (2) There is no negative light and no NaN. Nor is there infinite light but the ambient: a sum
/// that overflows is the largest number.
fn light_in_lanes_is_light<L: Lanes>()
where
    L::Lane: Number + Exponent<L>,
{
    let (none, most) = (L::Lane::ZERO, L::Lane::MAX);
    check((model(), adversarial_scene()), |(model, scene)| {
        let shaded = in_lanes::<L>(model, &scene);
        let is_light = |part: Rgb<L::Lane>| {
            let [r, g, b] = part.into();
            [r, g, b].into_iter().all(|channel| channel >= none)
        };
        let parts = [
            shaded.ambient,
            shaded.diffuse,
            shaded.specular,
            shaded.total(),
        ];
        prop_assert!(parts.into_iter().all(is_light), "{shaded:?}");
        for part in [shaded.diffuse, shaded.specular] {
            let [r, g, b] = part.into();
            prop_assert!(r <= most && g <= most && b <= most, "{shaded:?}");
        }
        Ok(())
    });
}

/// (3) The light is that of the lamps one by one, whose sum rounds n times: n − 1 additions and the
/// product with k.
fn lights_in_lanes_agree_with_one_by_one<L: Lanes>()
where
    L::Lane: Number + Exponent<L>,
{
    check((model(), bright_scene()), |(model, scene)| {
        let n = scene.lights.len();
        let k = n as f64 + roundings::<L>(n);
        agree(in_lanes::<L>(model, &scene), scene.shade(model), k, n)
    });
}

/// (3) The light of many lamps is the sum of the light of each; that of the two halves rounds once more.
fn light_in_lanes_is_additive<L: Lanes>()
where
    L::Lane: Number + Exponent<L>,
{
    let inputs = (model(), bright_scene(), any::<Index>());
    check(inputs, |(model, scene, length_of_a)| {
        let n = scene.lights.len();
        let (a, b) = scene.lights.split_at(length_of_a.index(n + 1));
        let of = |lights: &[_], i_a| {
            let lights = lights.to_vec();
            let scene = Scene {
                i_a,
                lights,
                ..scene.clone()
            };
            in_lanes::<L>(model, &scene)
        };
        let (both, a, b) = (
            of(&scene.lights, scene.i_a),
            of(a, scene.i_a),
            of(b, Rgb::BLACK),
        );
        agree(both, a + b, 2.0 * roundings::<L>(n) + 1.0, n)
    });
}

/// (4) The order of the lights does not matter beyond rounding.
fn order_of_lights_in_lanes_does_not_matter<L: Lanes>()
where
    L::Lane: Number + Exponent<L>,
{
    let shuffled = bright_scene().prop_flat_map(|scene| {
        let lights = Just(scene.lights.clone()).prop_shuffle();
        (Just(scene), lights)
    });
    check((model(), shuffled), |(model, (scene, lights))| {
        let n = lights.len();
        let shuffled = Scene {
            lights,
            ..scene.clone()
        };
        let [a, b] = [scene, shuffled].map(|scene| in_lanes::<L>(model, &scene));
        agree(a, b, 2.0 * roundings::<L>(n), n)
    });
}

/// (5) Black lights change nothing: not by a bit behind the others, where they take the place of those
/// that fill the last pack. Elsewhere they move the others to other lanes, as another order does.
fn black_lights_in_lanes_change_nothing<L: Lanes>()
where
    L::Lane: Number + Exponent<L>,
{
    let inputs = (model(), bright_scene(), vec(unit(), 1..20), any::<Index>());
    check(inputs, |(model, scene, directions, place)| {
        let black = directions.into_iter().map(|l| IncidentLight {
            l,
            intensity: Rgb::BLACK,
            distance: L::Lane::MAX,
        });
        let with_black_at = |place: usize| {
            let mut scene = scene.clone();
            scene.lights.splice(place..place, black.clone());
            (in_lanes::<L>(model, &scene), scene.lights.len())
        };
        let shaded = in_lanes::<L>(model, &scene);
        let (behind, _) = with_black_at(scene.lights.len());
        identical(behind, shaded)?;
        let (anywhere, n) = with_black_at(place.index(scene.lights.len() + 1));
        agree(anywhere, shaded, 2.0 * roundings::<L>(n), n)
    });
}

/// (9), (13) Neither no lights nor lights from behind add anything to the ambient light.
fn lights_behind_add_nothing_in_lanes<L: Lanes>()
where
    L::Lane: Number + Exponent<L>,
{
    check((model(), bright_scene()), |(model, mut scene)| {
        let none = scene.lit_by(model, &[]);
        scene
            .lights
            .retain(|light| scene.n.dot(light.l) <= L::Lane::ZERO);
        identical(in_lanes::<L>(model, &scene), none)?;
        scene.lights.clear();
        identical(in_lanes::<L>(model, &scene), none)
    });
}

/// Makes a test of each property for each type of lanes.
macro_rules! properties {
    ($($property:ident,)*) => {
        tests! { wide::f32x4 as four: $($property,)* }
        tests! { wide::f32x8 as eight: $($property,)* }
        tests! { wide::f64x4 as four_of_double: $($property,)* }
    };
}

macro_rules! tests {
    ($lanes:ty as $module:ident: $($property:ident,)*) => {
        mod $module {
            $(
                #[test]
                fn $property() {
                    super::$property::<$lanes>();
                }
            )*
        }
    };
}

properties! {
    light_in_lanes_is_light,
    lights_in_lanes_agree_with_one_by_one,
    light_in_lanes_is_additive,
    order_of_lights_in_lanes_does_not_matter,
    black_lights_in_lanes_change_nothing,
    lights_behind_add_nothing_in_lanes,
}
