//! The files.

use crate::dialect::{C, Dialect, GLSL, HLSL, METAL, Powers, WGSL, filled};
use crate::given::{built_in_powers, encodings, is_extreme, operations_on_bits};
use crate::graph::{Graph, with};
use crate::kind::{Arguments, Kind};
use crate::number::Expr;
use crate::print::{Printer, Text};
use crate::table::{Function, functions};
use crate::tree::{Tree, explore};
use crate::values::Values;
use crate::wrap::wrapped;

/// The names of the files, and what is in them.
#[must_use]
pub fn files() -> Vec<(&'static str, String)> {
    let exact = Dialect {
        powers: Powers::Own,
        ..WGSL
    };
    let exact = Box::leak(Box::new(exact));
    let files: [(&str, &'static Dialect); 6] = [
        ("shading.wgsl", &WGSL),
        ("shading_exact.wgsl", exact),
        ("shading.glsl", &GLSL),
        ("shading.hlsl", &HLSL),
        ("shading.metal", &METAL),
        ("shading.h", &C),
    ];
    files
        .iter()
        .map(|(name, dialect)| (*name, text(dialect)))
        .collect()
}

const HEAD: [&str; 5] = [
    "shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.",
    "Written by the package shading-languages from the source of the crate shading; do not edit it.",
    "All directions have length 1 and point away from the surface. A direction that does not exist is 0.",
    "Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.",
    "",
];

/// The text of a file.
#[must_use]
pub fn text(dialect: &'static Dialect) -> String {
    let mut out = String::new();
    for line in HEAD {
        out += &comment(dialect, line);
    }
    out += "\n";
    out += dialect.file[0];
    out += dialect.vectors;
    for kind in Kind::STRUCTS {
        out += &structure(dialect, *kind);
    }
    let (powers, others) = functions().split_at(2);
    let own = || {
        let functions: String = powers
            .iter()
            .map(|function| function_text(dialect, function))
            .collect();
        operations_on_bits(dialect) + &functions
    };
    match dialect.powers {
        Powers::Own => out += &own(),
        Powers::BuiltIn => out += &built_in_powers(dialect),
        Powers::Defined => {
            let all = [
                "#ifdef SHADING_EXACT_POWER\n\n",
                &own(),
                "#else\n\n",
                &built_in_powers(dialect),
            ];
            out += &all.concat();
            out += "#endif\n\n";
        }
    }
    out += &is_extreme(dialect);
    for function in others {
        out += &function_text(dialect, function);
    }
    if !dialect.encodings.is_empty() {
        out += &encodings(dialect);
    }
    format!("{}{}", out, dialect.file[1])
}

pub(crate) fn comment(dialect: &Dialect, text: &str) -> String {
    let [begin, end] = dialect.comment;
    if text.is_empty() {
        String::new()
    } else {
        format!("{begin}{text}{end}\n")
    }
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

/// The variables of a function's parameters.
fn arguments(function: &Function) -> Arguments<Expr> {
    let of = |(name, kind): &(&str, Kind)| kind.variables(name);
    Arguments::new(function.parameters.iter().flat_map(of).collect())
}

/// Records a function in a new graph.
fn recorded(function: &Function) -> Tree {
    // a product with 0 tells what is not finite in this function alone
    let drops_zeros = function.name != "normal_transformed";
    with(|g| *g = Graph::new(function.name, function.selects, drops_zeros));
    let tree = explore(&|| (function.record)(arguments(function)), &[]);
    with(|g| (g.given, g.path) = (vec![], vec![]));
    tree
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
    let tree = recorded(function);
    let doc = function
        .doc
        .lines()
        .map(|line| comment(dialect, line.trim()));
    let name = dialect.named(function.name);
    // a struct is changed in place where structs are passed by pointers
    let changed = function.parameters.iter().find(|(_, kind)| {
        *kind == function.result && kind.fields().is_some() && dialect.pointers.is_some()
    });
    let changed = changed.map(|(name, _)| *name);
    let result = match changed {
        Some(_) => "void".into(),
        None => dialect.type_of(function.result),
    };
    let head = head(dialect, &name, &function.parameters, changed, &result);
    let body = with(|g| {
        let printer = Printer {
            dialect,
            values: Values::new(g),
            result: function.result,
            parameters: &function.parameters,
            changed,
            prefix: dialect.prefix.into(),
            text: Text::default(),
        };
        printer.body(&tree, &names(function.name))
    });
    format!("{}{head}{body}}}\n\n", doc.collect::<String>())
}

/// A function of the user's.
pub(crate) fn own_function(
    dialect: &'static Dialect,
    name: &str,
    parameters: &[(&str, Kind)],
    result: Kind,
    formula: &dyn Fn() -> Vec<Expr>,
) -> String {
    with(|g| *g = Graph::new("", false, true));
    let tree = explore(formula, &[]);
    let head = head(dialect, name, parameters, None, &dialect.type_of(result));
    let body = with(|g| {
        let printer = Printer {
            dialect,
            values: Values::new(g),
            result,
            parameters: &[],
            changed: None,
            prefix: [dialect.namespace, dialect.prefix].concat(),
            text: Text::default(),
        };
        printer.body(&tree, &[])
    });
    format!("{head}{body}}}\n")
}
