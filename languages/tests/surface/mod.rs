//! Surfaces as a user writes them.

#![allow(dead_code)] // each test uses a part

use shading::{Elementary, Vec3};

/// A box with round edges, in operations on vectors that C has for numbers alone, and with decisions.
pub fn rounded_box<T: Elementary + PartialOrd>(p: Vec3<T>) -> T {
    let size = Vec3::new(T::of(1.0), T::of(2.0), T::of(3.0));
    let part = Vec3::new(p.x / size.x, p.y / size.y, p.z / size.z);
    let outside = part.map(|x| (x.abs() - T::ONE).at_least(T::ZERO));
    let inside = part.map(|x| x.at_most(T::ONE));
    let square = outside.dot(outside);
    if square >= T::of(0.25) || p.x < p.y {
        return square.sqrt() + inside.cross(p).dot(p);
    }
    square.powf(p.z).atan2(p.x)
}

/// A ball above a plane and a cylinder below: each comparison, of numbers that are equal at some points.
pub fn figure<T: Elementary + PartialOrd>(p: Vec3<T>) -> T {
    let ball = p.length() - T::ONE;
    if p.z > T::ONE {
        return ball.at_least(-p.x); // it is no |ball|
    }
    if p.z <= T::ZERO {
        return (p.x * p.x + p.y * p.y).sqrt() - T::of(0.5);
    }
    if p.x == p.y {
        return ball + p.x;
    }
    if p.x >= p.y && p.x != T::ONE {
        return ball + p.x * p.y;
    }
    match p.z.partial_cmp(&p.x) {
        Some(std::cmp::Ordering::Less) => ball * p.z,
        Some(std::cmp::Ordering::Greater) => ball - p.z,
        _ => ball + ball,
    }
}

pub fn wave<T: Elementary>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u, v, u.sin() * v.cos()) * (u.exp() + v.tan())
}

/// A cylinder with a cone on top.
pub fn pencil<T: Elementary + PartialOrd>(u: T, v: T) -> Vec3<T> {
    let top = T::of(0.75);
    let radius = if v < top {
        T::ONE
    } else {
        (T::ONE - v) * T::of(4.0)
    };
    Vec3::new(radius * u.cos(), radius * u.sin(), v)
}
