//! The light that arrives at a point.

use shading::{
    DirectionalLight, IncidentLight, Light, PointLight, Ranged, Rgb, SoftCone, SpotLight,
};
use shading_proofs::{Goal, Range};

use super::*;

/// Light that arrives: no channel is negative, infinite or NaN, and neither is the distance.
fn arrives(given: Given, light: IncidentLight<Term>) -> Vec<Goal> {
    let mut goals = channels(light.intensity, not_negative(given));
    goals.push(Goal::Within(light.distance, not_negative(given)));
    goals
}
fn black(light: IncidentLight<Term>) -> Vec<Goal> {
    channels(light.intensity, Range::within(0.0, 0.0))
}
fn ranged_lamp(given: Given) -> PointLight<Term, Ranged<Term>> {
    let position = any_vector(given, "position");
    PointLight {
        position,
        intensity: given.rgb("I"),
        attenuation: any_ranged(given),
    }
}
type Spot = SpotLight<Term, SoftCone<Term>>;
type Kind = Light<Term, SoftCone<Term>>;
fn spot(given: Given, position: Vec3<Term>) -> Spot {
    let (point, axis) = (lamp(given, position), any_direction(given, "axis"));
    SpotLight {
        point,
        axis,
        cone: soft_cone(given).smoothstep(),
    }
}

claims! {
    directional_at: "`DirectionalLight::at` changes no bit, and its distance is the largest number" |given| {
        let sun = DirectionalLight { l: any_direction(given, "l"), intensity: given.rgb("I") };
        let light = sun.at(any_vector(given, "p"));
        let max = given.format().max();
        [same(*light.l, *sun.l), same(light.intensity, sun.intensity), within([light.distance], Range::within(max, max))].concat()
    }
    point_light_of_finite: "`PointLight::at`, finite positions: intensity and distance are in [0, MAX], L is finite" |given| {
        let light = lamp(given, given.vector("position", finite(given))).at(given.vector("p", finite(given)));
        [arrives(given, light), components(*light.l, finite(given))].concat()
    }
    point_light_of_any: "`PointLight::at`, positions of any bits: intensity and distance are in [0, MAX]" |given| {
        arrives(given, lamp(given, any_vector(given, "position")).at(any_vector(given, "p")))
    }
    ranged_light_of_any: "`PointLight::at` with `Ranged`, unsquared or not, positions of any bits: intensity and distance are in [0, MAX]" |given| {
        let (lamp, p) = (ranged_lamp(given), any_vector(given, "p"));
        let unsquared = PointLight { attenuation: lamp.attenuation.unsquared(), ..lamp };
        [arrives(given, lamp.at(p)), arrives(given, unsquared.at(p))].concat()
    }
    spot_light_of_any: "`SpotLight::at` with `SoftCone`, positions and axis of any bits: intensity and distance are in [0, MAX]" |given| {
        arrives(given, spot(given, any_vector(given, "position")).at(any_vector(given, "p")))
    }
    light_is_its_kind: "`Light::at` is `at` of its kind, to the bit, positions of any bits" |given| {
        let (spot, p) = (spot(given, any_vector(given, "position")), any_vector(given, "p"));
        let (point, spot) = ((Kind::from(spot.point).at(p), spot.point.at(p)), (Kind::from(spot).at(p), spot.at(p)));
        [point, spot].iter().flat_map(|(a, b)| [same(*a.l, *b.l), same(a.intensity, b.intensity)].concat()).collect()
    }
    light_at_the_point: "`PointLight::at` and `SpotLight::at` where the light is: black, at the largest distance" |given| {
        let (position, max) = (any_vector(given, "position"), given.format().max());
        let spot = spot(given, position);
        let (point, spot) = (spot.point.at(position), spot.at(position));
        [black(point), black(spot), within([point.distance, spot.distance], Range::within(max, max))].concat()
    }
    light_at_infinity: "`PointLight::at` is black and its distance the largest number, if a coordinate of the light is infinite or NaN and none of p is" |given| {
        let (position, max) = (broken(given, "position"), given.format().max());
        let light = lamp(given, position).at(given.vector("p", finite(given)));
        let mut goals = within([light.distance], Range::within(max, max));
        goals.extend(black(light));
        goals
    }
    light_from_infinity: "`PointLight::at` is black and its distance the largest number, if a coordinate of p is infinite or NaN and none of the light is" |given| {
        let (p, max) = (broken(given, "p"), given.format().max());
        let light = lamp(given, given.vector("position", finite(given))).at(p);
        let mut goals = within([light.distance], Range::within(max, max));
        goals.extend(black(light));
        goals
    }
    black_light: "`PointLight::at` of a black light is black, whatever the attenuation, positions of any bits" |given| {
        let mut lamp = lamp(given, any_vector(given, "position"));
        lamp.intensity = Rgb::BLACK;
        black(lamp.at(any_vector(given, "p")))
    }
    incident_of_nan: "`IncidentLight::in_front` is `None` if L is NaN" |given| {
        let l = nan_direction(given, "l");
        let light = IncidentLight { l, ..incident(given, "light") };
        none(light.in_front(any_direction(given, "n")))
    }
}
