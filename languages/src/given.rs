//! What stands in the files beside the recorded functions.

use shading::{Real, Rgb};

use crate::dialect::{Dialect, filled};
use crate::file::{comment, head};
use crate::kind::Kind;
use crate::table::functions;

/// A function of numbers, given the lines of its body.
fn function(
    dialect: &Dialect,
    doc: &str,
    name: &str,
    parameters: &[&str],
    of: &str,
    body: &str,
) -> String {
    let parameters: Vec<_> = parameters
        .iter()
        .map(|name| (*name, Kind::Number))
        .collect();
    let head = head(dialect, &dialect.named(name), &parameters, None, of);
    format!("{}{head}{body}\n}}\n\n", comment(dialect, doc))
}

/// Whether the square of a length is out of range.
pub fn is_extreme(dialect: &Dialect) -> String {
    let ends = [1.0 / f32::EXTREME, f32::EXTREME];
    let [low, high] = ends.map(|x| dialect.number(x));
    let [low_bits, high_bits] = ends.map(f32::to_bits);
    let places = [
        ("low", &low[..]),
        ("high", &high),
        ("low_bits", &format!("0x{low_bits:08X}")),
        ("width", &format!("0x{:08X}", high_bits - low_bits)),
    ];
    let body = format!("    return {};", filled(dialect.is_extreme, &places));
    let doc = "Whether a square is so small or large that it is not exact.";
    function(
        dialect,
        doc,
        "is_extreme",
        &["square"],
        dialect.truth,
        &body,
    )
}

/// The powers of the language.
pub fn built_in_powers(dialect: &Dialect) -> String {
    let [pow, min] = ["pow", "min"].map(|name| dialect.function_named(name, ""));
    let [of_quotient, of] = [format!("{min}(c / d, {})", dialect.number(1.0)), "c".into()];
    let power = |function_of: usize, cosine: &str| {
        let known = &functions()[function_of];
        let formula = known.doc.split(',').next().expect("a formula").trim();
        let doc = format!("{formula}, by the language's own power.");
        let parameters: Vec<_> = known
            .parameters
            .iter()
            .map(|parameter| parameter.0)
            .collect();
        let body = format!("    return {pow}({cosine}, m);");
        function(
            dialect,
            &doc,
            known.name,
            &parameters,
            dialect.types[0],
            &body,
        )
    };
    power(0, &of_quotient) + &power(1, &of)
}

/// The operations on the bits of a number: what each says of itself, its name and its body, in which `{bits}` is
/// the function that gives the bits as an integer, and `{of_bits}` the one that takes them.
const OPERATIONS_ON_BITS: [(&str, &str, &[&str], &str); 4] = [
    (
        "e of x = 2^e z, where z is within [least, 2 least).",
        "exponent",
        &["x", "least"],
        "    return {number}(({bits}(x) - {bits}(least)) >> 23);",
    ),
    (
        "z of x = 2^e z.",
        "significand",
        &["x", "least"],
        "    {above}\n    return {of_bits}({bits}(x) - (above & -0x800000));",
    ),
    (
        "2^(n - 127) for the low byte n of the bits of x.",
        "two_to_low_bits",
        &["x"],
        "    return {of_bits}({bits}(x) << 23);",
    ),
    (
        "How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.",
        "steps_above",
        &["x", "shift"],
        "    return {number}({bits}(x) - {bits}(shift));",
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
    let of = |(doc, name, parameters, body): (_, _, &[&str], _)| {
        function(
            dialect,
            doc,
            name,
            parameters,
            number,
            &filled(body, &places),
        )
    };
    OPERATIONS_ON_BITS.map(of).concat()
}

/// The text of the encodings, with the least light of each level.
pub fn encodings(dialect: &Dialect) -> String {
    let rgb565 = |x: f32| u32::from(Rgb::gray(x).to_rgb565());
    let of_5_bits = edges(dialect, 32, |x| rgb565(x) & 31);
    let of_6_bits = edges(dialect, 64, |x| rgb565(x) >> 5 & 63);
    let of_8_bits = edges(dialect, 256, |x| u32::from(Rgb::gray(x).to_srgb8()[0]));
    let places = [
        ("5_bits", &of_5_bits[..]),
        ("6_bits", &of_6_bits),
        ("8_bits", &of_8_bits),
    ];
    filled(dialect.encodings, &places)
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
