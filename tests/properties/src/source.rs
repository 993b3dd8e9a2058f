//! Inputs as Rust, for what a failed test prints.

use crate::given::{down, shiny, up};
use shading::{Attenuation, Cone, Light, Material, PointLight, Rgb, UnitVec3, Vec3};

pub trait Source {
    fn source(&self) -> String;
}

impl Source for f64 {
    fn source(&self) -> String {
        format!("{self:?}")
    }
}

impl Source for u32 {
    fn source(&self) -> String {
        format!("{self}")
    }
}

impl Source for Vec3<f64> {
    fn source(&self) -> String {
        format!("vec3({:?}, {:?}, {:?})", self.x, self.y, self.z)
    }
}

impl Source for UnitVec3<f64> {
    fn source(&self) -> String {
        let axes = [
            (Self::X, "X"),
            (Self::Y, "Y"),
            (Self::Z, "Z"),
            (Self::NEG_X, "NEG_X"),
            (Self::NEG_Y, "NEG_Y"),
            (Self::NEG_Z, "NEG_Z"),
        ];
        let (x, y, z) = (self.x, self.y, self.z);
        let is_short = format!("{x:?}{y:?}{z:?}").len() < 20;
        match axes.iter().find(|(axis, _)| axis == self) {
            Some((_, name)) => format!("UnitVec3::{name}"),
            None if is_short => format!("unit({x:?}, {y:?}, {z:?})"),
            None if *self == up(x, y) => format!("up({x:?}, {y:?})"),
            None if *self == down(x, y) => format!("down({x:?}, {y:?})"),
            None => format!("unit({x:?}, {y:?}, {z:?})"),
        }
    }
}

impl Source for Rgb<f64> {
    fn source(&self) -> String {
        if *self == Rgb::WHITE {
            return "Rgb::WHITE".into();
        }
        if *self == Rgb::BLACK {
            return "Rgb::BLACK".into();
        }
        format!("rgb({:?}, {:?}, {:?})", self.r, self.g, self.b)
    }
}

impl Source for Material<f64> {
    fn source(&self) -> String {
        if *self == shiny(self.m) {
            return format!("shiny({})", self.m);
        }
        let [a, d, s] = [self.k_a, self.k_d, self.k_s].map(|k| k.source());
        format!("material({a}, {d}, {s}, {})", self.m)
    }
}

impl Source for Attenuation<f64> {
    fn source(&self) -> String {
        if *self == Self::NONE {
            return "Attenuation::NONE".into();
        }
        let [a, b, c] = self.coefficients();
        let range = self.range();
        let range = range.map_or(String::new(), |r| format!(".within({r:?}).unwrap()"));
        format!("coefficients({a:?}, {b:?}, {c:?}){range}")
    }
}

impl Source for Cone<f64> {
    fn source(&self) -> String {
        let [inner, outer] = self.cosines();
        let smoothstep = if self.is_smoothstep() {
            ".smoothstep()"
        } else {
            ""
        };
        format!("cone({inner:?}, {outer:?}){smoothstep}")
    }
}

impl Source for PointLight<f64> {
    fn source(&self) -> String {
        let [position, intensity] = [self.position.source(), self.intensity.source()];
        format!(
            "lamp({position}, {intensity}, {})",
            self.attenuation.source()
        )
    }
}

impl Source for Light<f64> {
    fn source(&self) -> String {
        match self {
            Self::Directional(sun) => {
                format!("sun({}, {})", sun.l.source(), sun.intensity.source())
            }
            Self::Point(lamp) => format!("{}.into()", lamp.source()),
            Self::Spot(spot) => {
                let [lamp, axis] = [spot.point.source(), spot.axis.source()];
                format!("spot({lamp}, {axis}, {})", spot.cone.source())
            }
        }
    }
}

impl<S: Source, const N: usize> Source for [S; N] {
    fn source(&self) -> String {
        format!("[{}]", list(self))
    }
}

impl<S: Source> Source for Vec<S> {
    fn source(&self) -> String {
        format!("vec![{}]", list(self))
    }
}

fn list(values: &[impl Source]) -> String {
    let values: Vec<String> = values.iter().map(Source::source).collect();
    values.join(", ")
}

/// A statement on lines of at most 110 columns, broken between the fields of a struct and the
/// elements of a list.
pub fn wrapped(statement: &str) -> String {
    let (mut pieces, mut open) = (vec![String::new()], Vec::new());
    for part in statement.split_inclusive([' ', '(', ')', '[', ']', '{', '}']) {
        let piece = pieces.last_mut().expect("a piece");
        let may_break = piece.ends_with("{ ") || piece.ends_with(", ");
        if may_break && matches!(open.last(), Some('{' | '[')) {
            pieces.push(part.into());
        } else {
            piece.push_str(part);
        }
        match part.chars().last() {
            Some(bracket @ ('(' | '[' | '{')) => open.push(bracket),
            Some(')' | ']' | '}') => drop(open.pop()),
            _ => {}
        }
    }
    let mut lines = vec![String::new()];
    for piece in pieces {
        let line = lines.last_mut().expect("a line");
        if line.is_empty() || line.len() + piece.trim_end().len() <= 110 {
            line.push_str(&piece);
        } else {
            lines.push(format!("    {piece}"));
        }
    }
    let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n")
}
