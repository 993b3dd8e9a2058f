//! The light that arrives at a point.

use shading::{PointLight, Rgb};
use shading_proofs::{Given, Goal, Term};

use super::given::*;

pub fn lamp_of_any(given: Given) -> Vec<Goal> {
    let lamp = lamp(given, any_vector(given, "position"));
    arrives(given, lamp.at(any_vector(given, "p")))
}

pub fn distance_of_finite(given: Given) -> Vec<Goal> {
    let lamp = lamp(given, finite_vector(given, "position"));
    let distance = lamp.at(finite_vector(given, "p")).distance();
    within([distance], not_negative(given))
}

pub fn lamp_with_a_range(given: Given) -> Vec<Goal> {
    let lamp = PointLight {
        position: any_vector(given, "position"),
        intensity: given.rgb("I"),
        attenuation: ranged(given),
    };
    arrives(given, lamp.at(any_vector(given, "p")))
}

pub fn spot_of_any(given: Given) -> Vec<Goal> {
    let spot = spot(given, any_vector(given, "position"));
    spot.map_or(vec![], |spot| {
        arrives(given, spot.at(any_vector(given, "p")))
    })
}

pub fn light_at_the_point(given: Given) -> Vec<Goal> {
    let position = any_vector(given, "position");
    let Some(spot) = spot(given, position) else {
        return vec![];
    };
    [
        black(spot.point.at(position).intensity()),
        black(spot.at(position).intensity()),
    ]
    .concat()
}

pub fn light_at_infinity(given: Given) -> Vec<Goal> {
    let (finite, broken) = (finite_vector(given, "finite"), broken(given, "broken"));
    let (position, p) = match given.one_of(2) {
        0 => (finite, broken),
        _ => (broken, finite),
    };
    black(lamp(given, position).at(p).intensity())
}

pub fn black_lamp(given: Given) -> Vec<Goal> {
    let lamp = PointLight {
        intensity: Rgb::<Term>::BLACK,
        ..lamp(given, any_vector(given, "position"))
    };
    black(lamp.at(any_vector(given, "p")).intensity())
}
