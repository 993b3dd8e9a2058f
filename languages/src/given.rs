//! What stands in the files beside the recorded functions.

use shading::{Real, Rgb};

use crate::dialect::{Dialect, filled};
use crate::file::{comment, head};
use crate::kind::Kind;

/// A function of numbers: what it says of itself, its name, its parameters, and the lines of its body.
type Given = (
    &'static str,
    &'static str,
    &'static [&'static str],
    &'static str,
);

fn text(dialect: &Dialect, of: &str, given: Given, places: &[(&str, &str)]) -> String {
    let (doc, name, parameters, body) = given;
    let number = |name: &&'static str| (*name, Kind::Number);
    let parameters: Vec<_> = parameters.iter().map(number).collect();
    let head = head(dialect, &dialect.named(name), &parameters, None, of);
    let (doc, body) = (comment(dialect, doc), filled(body, places));
    format!("{doc}{head}    {body}\n}}\n\n")
}

const IS_EXTREME: Given = (
    "Whether a square is so small or large that it is not exact.",
    "is_extreme",
    &["square"],
    "return {test};",
);

pub fn is_extreme(dialect: &Dialect) -> String {
    let ends = [1.0 / f32::EXTREME, f32::EXTREME];
    let [low, high] = ends.map(|x| dialect.number(x));
    let [low_bits, high_bits] = ends.map(f32::to_bits);
    let places = [
        ("test", dialect.is_extreme),
        ("low", &low),
        ("high", &high),
        ("low_bits", &format!("0x{low_bits:08X}")),
        ("width", &format!("0x{:08X}", high_bits - low_bits)),
    ];
    text(dialect, dialect.types[3], IS_EXTREME, &places)
}

/// The operations on the bits of a number. `{bits}` is the function that gives the bits as an integer, and
/// `{of_bits}` the one that takes them.
const OPERATIONS_ON_BITS: [Given; 4] = [
    (
        "e of x = 2^e z, where z is within [least, 2 least).",
        "exponent",
        &["x", "least"],
        "return {number}(({bits}(x) - {bits}(least)) >> 23);",
    ),
    (
        "z of x = 2^e z.",
        "significand",
        &["x", "least"],
        "{above}\n    return {of_bits}({bits}(x) - (above & -0x800000));",
    ),
    (
        "2^(n - 127) for the low byte n of the bits of x.",
        "two_to_low_bits",
        &["x"],
        "return {of_bits}({bits}(x) << 23);",
    ),
    (
        "How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.",
        "steps_above",
        &["x", "shift"],
        "return {number}({bits}(x) - {bits}(shift));",
    ),
];

pub fn operations_on_bits(dialect: &Dialect) -> String {
    let [bits, of_bits] = match dialect.bits {
        Ok(functions) => functions,
        Err(text) => return text.into(),
    };
    let above = format!("{bits}(x) - {bits}(least)");
    let above = [("type", "int"), ("name", "above"), ("value", &above)];
    let above = filled(dialect.variable, &above);
    let number = dialect.types[0];
    let places = [
        ("bits", bits),
        ("of_bits", of_bits),
        ("number", number),
        ("above", &above),
    ];
    let text = |operation| text(dialect, number, operation, &places);
    OPERATIONS_ON_BITS.map(text).concat()
}

/// A text with the least light of each level.
pub fn filled_with_levels(dialect: &Dialect, text: &str) -> String {
    let rgb565 = |x: f32| u32::from(Rgb::gray(x).to_rgb565());
    let of_5_bits = edges(dialect, 32, |x| rgb565(x) & 31);
    let of_6_bits = edges(dialect, 64, |x| rgb565(x) >> 5 & 63);
    let of_8_bits = edges(dialect, 256, |x| u32::from(Rgb::gray(x).to_srgb8()[0]));
    let places = [
        ("5_bits", &of_5_bits[..]),
        ("6_bits", &of_6_bits),
        ("8_bits", &of_8_bits),
    ];
    filled(text, &places)
}

/// The least number of each level but 0, found by bisection.
fn edges(dialect: &Dialect, count: u32, level: impl Fn(f32) -> u32) -> String {
    let edge = |of| {
        let (mut below, mut from) = (0.0_f32.to_bits(), 1.0_f32.to_bits());
        while from - below > 1 {
            let middle = u32::midpoint(below, from);
            if level(f32::from_bits(middle)) < of {
                below = middle;
            } else {
                from = middle;
            }
        }
        dialect.number(f32::from_bits(from)) + ","
    };
    let edges: Vec<_> = (1..count).map(edge).collect();
    let line = |edges: &[String]| format!("    {}\n", edges.join(" "));
    edges.chunks(7).map(line).collect()
}
