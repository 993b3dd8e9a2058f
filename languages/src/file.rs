//! The files.

use shading::{Real, Rgb};

use crate::dialect::{C, Dialect, GLSL, HLSL, METAL, WGSL, WGSL_EXACT, filled};
use crate::kind::Kind;
use crate::print::function;
use crate::table::{BUILT_IN_POWERS, Function, functions};
use crate::tree::Formula;

const FILES: [(&str, &Dialect); 6] = [
    ("shading.wgsl", &WGSL),
    ("shading_exact.wgsl", &WGSL_EXACT),
    ("shading.glsl", &GLSL),
    ("shading.hlsl", &HLSL),
    ("shading.metal", &METAL),
    ("shading.h", &C),
];

const HEAD: [&str; 4] = [
    "shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.",
    "Written by the package shading-languages from the source of the crate shading; do not edit it.",
    "All directions have length 1 and point away from the surface. A direction that does not exist is 0.",
    "Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.",
];

/// The names of the files, and what is in them.
#[must_use]
pub fn files() -> Vec<(&'static str, String)> {
    FILES.map(|(name, dialect)| (name, text(dialect))).into()
}

/// The text of a file.
#[must_use]
pub fn text(dialect: &'static Dialect) -> String {
    let head = HEAD.iter().chain(dialect.extremes);
    let head: String = head.map(|line| comment(dialect, line)).collect();
    let structs = Kind::STRUCTS.iter().map(|kind| structure(dialect, *kind));
    let structs: Vec<_> = structs.collect();
    let texts = |functions: &[Function]| {
        let texts = functions.iter().map(|of| function_text(dialect, of));
        texts.collect::<Vec<_>>().join("\n\n")
    };
    let (powers, others) = functions().split_at(2);
    let (inline, _) = dialect.function.split_once("{type}").unwrap_or_default();
    let ends = [1.0 / f32::EXTREME, f32::EXTREME];
    let [low_bits, high_bits] = ends.map(f32::to_bits);
    let rgb565 = |x: f32| u32::from(Rgb::gray(x).to_rgb565());
    let srgb8 = |x: f32| Rgb::gray(x).to_srgb8()[0].into();
    let places = [
        ("structs", structs.join("\n\n")),
        ("own", texts(powers)),
        ("built_in", texts(BUILT_IN_POWERS)),
        ("functions", texts(others)),
        ("inline", inline.into()),
        ("prefix", dialect.prefix[0].into()),
        ("bits", dialect.bits[0].into()),
        ("of_bits", dialect.bits[1].into()),
        ("low", dialect.number(ends[0])),
        ("high", dialect.number(ends[1])),
        ("low_bits", format!("0x{low_bits:08X}")),
        ("width", format!("0x{:08X}", high_bits - low_bits)),
        ("5_bits", edges(dialect, 32, |x| rgb565(x) & 31)),
        ("6_bits", edges(dialect, 64, |x| rgb565(x) >> 5 & 63)),
        ("8_bits", edges(dialect, 256, srgb8)),
    ];
    let places = places.each_ref().map(|(place, text)| (*place, &text[..]));
    let [begin, end] = dialect.around;
    [&head, "\n", begin, &filled(dialect.file, &places), end].concat()
}

fn comment(dialect: &Dialect, text: &str) -> String {
    let [begin, end] = dialect.comment;
    format!("{begin}{text}{end}\n")
}

fn structure(dialect: &Dialect, kind: Kind) -> String {
    let (name, doc, fields) = kind.fields().expect("a struct has fields");
    let name = dialect.named(name);
    let [begin, field, end] = dialect.structure;
    let [begin, end] = [begin, end].map(|text| filled(text, &[("name", &name)]));
    let mut lines = vec![comment(dialect, doc.trim()) + &begin];
    let mut add = |of: &str, name: &str| {
        let line = filled(field, &[("type", of), ("field", name)]);
        lines.push(format!("    {line}"));
    };
    let is_stored = matches!(kind, Kind::Light | Kind::Material);
    for (i, (name, kind)) in fields.iter().enumerate() {
        let is_packed = is_stored && kind.width() == 3;
        let packed = if is_packed { dialect.packed } else { "" };
        add(&[packed, &dialect.type_of(*kind)].concat(), name);
        let is_followed = fields.get(i + 1).is_some_and(|next| next.1.width() == 1);
        let is_short = kind.width() == 3 && !is_followed || *name == "is_gltf";
        if is_stored && dialect.pads && is_short {
            add(dialect.types[0], &format!("padding_{name}"));
        }
    }
    lines.push(end);
    lines.join("\n")
}

fn function_text(dialect: &'static Dialect, of: &Function) -> String {
    let formula = Formula {
        defining: of.name,
        parameters: of.parameters,
        result: of.result,
        record: &of.record,
    };
    comment(dialect, of.doc.trim()) + &function(dialect, &dialect.named(of.name), &formula)
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
    let lines: Vec<_> = edges.chunks(7).map(|edges| edges.join(" ")).collect();
    lines.join("\n    ")
}
