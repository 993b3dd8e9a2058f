//! The files.

use crate::dialect::{C, Dialect, GLSL, HLSL, METAL, Powers, WGSL, WGSL_EXACT, filled};
use crate::given::{built_in_powers, encodings, is_extreme, operations_on_bits};
use crate::graph::{Graph, with};
use crate::kind::Kind;
use crate::print::{Printer, Text};
use crate::table::{Function, functions};
use crate::tree::explore;
use crate::values::Values;
use crate::wrap::wrapped;

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
    let (powers, others) = functions().split_at(2);
    let texts = |functions: &[Function]| -> String {
        let text = |function| function_text(dialect, function);
        functions.iter().map(text).collect()
    };
    let (own, built_in) = (
        operations_on_bits(dialect) + &texts(powers),
        built_in_powers(dialect),
    );
    let powers = match dialect.powers {
        Powers::Own => own,
        Powers::BuiltIn => built_in,
        Powers::Defined => {
            format!("#ifdef SHADING_EXACT_POWER\n\n{own}#else\n\n{built_in}#endif\n\n")
        }
    };
    let [begin, end] = dialect.file;
    [
        &head,
        "\n",
        begin,
        dialect.vectors,
        &structs.collect::<String>(),
        &powers,
        &is_extreme(dialect),
        &texts(others),
        &encodings(dialect),
        end,
    ]
    .concat()
}

pub(crate) fn comment(dialect: &Dialect, text: &str) -> String {
    let [begin, end] = dialect.comment;
    format!("{begin}{text}{end}\n")
}

fn structure(dialect: &Dialect, kind: Kind) -> String {
    let (name, doc, fields) = kind.fields().expect("a struct has fields");
    let name = dialect.named(name);
    let [begin, field, end] = dialect.structure;
    let mut out = comment(dialect, doc.trim()) + &filled(begin, &[("name", &name)]) + "\n";
    let is_stored = matches!(kind, Kind::Light | Kind::Material);
    let mut add = |of: &str, name: &str| {
        let line = filled(field, &[("type", of), ("field", name)]);
        out += &["    ", &line, "\n"].concat();
    };
    for (i, (name, kind)) in fields.iter().enumerate() {
        let of = match kind.width() {
            3 if is_stored => dialect.stored.into(),
            _ => dialect.type_of(*kind),
        };
        add(&of, name);
        let is_followed = fields.get(i + 1).is_some_and(|next| next.1.width() == 1);
        let is_short = kind.width() == 3 && !is_followed || *name == "is_gltf";
        if is_stored && dialect.pads && is_short {
            add(dialect.types[0], &format!("padding_{name}"));
        }
    }
    out + &filled(end, &[("name", &name)]) + "\n\n"
}

pub(crate) fn head(
    dialect: &Dialect,
    name: &str,
    parameters: &[(&str, Kind)],
    changed: Option<&str>,
    result: &str,
) -> String {
    let parameter = |(name, kind): &(&str, Kind)| {
        let form = match dialect.pointers {
            Some([_, form, _]) if Some(*name) == changed => form,
            Some([form, ..]) if kind.fields().is_some() => form,
            _ => dialect.parameter,
        };
        filled(form, &[("type", &dialect.type_of(*kind)), ("name", name)])
    };
    let parameters: Vec<_> = parameters.iter().map(parameter).collect();
    let places = [
        ("type", result),
        ("name", name),
        ("parameters", &parameters.join(", ")),
    ];
    wrapped("", &filled(dialect.function, &places))
}

/// The books' names for the values of a function, and their formulas.
fn names(function: &str) -> Vec<(&'static str, &'static str)> {
    let sections = include_str!("names.txt").split("\n[").skip(1);
    let of = |section: &'static str| {
        let (title, lines) = section.split_once("]\n")?;
        let lines = lines.lines().filter_map(|line| line.split_once(" = "));
        function.starts_with(title).then_some(lines)
    };
    sections.filter_map(of).flatten().collect()
}

fn function_text(dialect: &'static Dialect, function: &Function) -> String {
    let variables = || {
        let of = |(name, kind): &(&str, Kind)| kind.variables(name);
        let variables = function.parameters.iter().flat_map(of);
        variables.map(|x| x.0).collect()
    };
    // a product with 0 tells what is not finite in this function alone
    let drops_zeros = function.name != "normal_transformed";
    let recorded = Recorded {
        graph: Graph::new(function.name, function.selects, drops_zeros),
        name: &dialect.named(function.name),
        parameters: &function.parameters,
        result: function.result,
        formula: &|| (function.record)(variables()),
    };
    let doc = comment(dialect, function.doc.trim());
    let text = recorded.text(dialect, dialect.prefix.into(), &names(function.name));
    format!("{doc}{text}\n")
}

/// A function to record.
pub(crate) struct Recorded<'a> {
    pub graph: Graph,
    pub name: &'a str,
    pub parameters: &'a [(&'static str, Kind)],
    pub result: Kind,
    pub formula: &'a dyn Fn() -> Vec<usize>,
}

impl Recorded<'_> {
    /// Its text, given what stands before the functions of the files that it calls, and names of values.
    pub fn text(self, dialect: &'static Dialect, prefix: String, names: &[(&str, &str)]) -> String {
        with(|g| *g = self.graph);
        let tree = explore(self.formula, &[]);
        // a struct is changed in place where structs are passed by pointers
        let is_changed = |(_, kind): &&(_, Kind)| *kind == self.result && kind.fields().is_some();
        let changed = self.parameters.iter().find(is_changed);
        let changed = changed
            .filter(|_| dialect.pointers.is_some())
            .map(|(name, _)| *name);
        let result = match changed {
            Some(_) => "void".into(),
            None => dialect.type_of(self.result),
        };
        let head = head(dialect, self.name, self.parameters, changed, &result);
        let body = with(|g| {
            let printer = Printer {
                dialect,
                values: Values::new(g),
                result: self.result,
                parameters: self.parameters,
                changed,
                prefix,
                text: Text::default(),
            };
            printer.body(&tree, names)
        });
        format!("{head}{body}}}\n")
    }
}
