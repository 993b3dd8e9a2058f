//! The light that arrives at a point.

use shading::{Light, Rgb};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

/// What arrives through any filter, or none.
pub fn light_that_arrives(given: Given) -> Vec<Goal> {
    let Some(light) = any_arrival(given) else {
        return vec![];
    };
    let light = match given.one_of(2) {
        0 => light,
        _ => light * given.rgb("filter"),
    };
    components(light.intensity(), not_negative(given))
}

pub fn direction_that_arrives(given: Given) -> Vec<Goal> {
    let (position, p) = (any_vector(given, "position"), any_vector(given, "p"));
    any_lamp(given, position).map_or(vec![], |lamp| {
        let lamp = lamp.at(p);
        [lamp.l(), lamp.arrival().l]
            .map(|l| components(l, component()))
            .concat()
    })
}

pub fn distance_of_finite(given: Given) -> Vec<Goal> {
    let max = given.format().max();
    let [position, p] = ["position", "p"].map(|name| given.vector(name, Range::within(-max, max)));
    let Some(light) = light_at(given, position) else {
        return vec![];
    };
    let range = match light {
        Light::Directional(_) => Range::within(max, max),
        _ => not_negative(given),
    };
    let light = light.at(p);
    within([light.distance(), light.arrival().distance], range)
}

/// At its own position, or with a coordinate of either that is infinite or NaN.
pub fn light_of_nowhere(given: Given) -> Vec<Goal> {
    let (any, broken) = (any_vector(given, "any"), broken(given, "broken"));
    let (position, p) = match given.one_of(3) {
        0 => (any, any),
        1 => (any, broken),
        _ => (broken, any),
    };
    let lamp = any_lamp(given, position);
    lamp.map_or(vec![], |lamp| black(lamp.at(p).intensity()))
}

pub fn black_light(given: Given) -> Vec<Goal> {
    let light = any_arrival(given);
    light.map_or(vec![], |light| {
        black((light * Rgb::<Term>::BLACK).intensity())
    })
}

pub fn spot_at_most_its_lamp(given: Given) -> Vec<Goal> {
    let (position, p) = (any_vector(given, "position"), any_vector(given, "p"));
    any_spot(given, position).map_or(vec![], |spot| {
        at_most(spot.at(p).intensity(), spot.point.at(p).intensity())
    })
}
