//! Writes a recorded function in a language.

use std::collections::HashMap;
use std::mem::take;

use crate::dialect::{Dialect, WGSL, filled};
use crate::graph::{DOT, Graph, Node, Op, VECTOR};
use crate::kind::Kind;
use crate::tree::{Formula, Tree, recorded};
use crate::wrap::wrapped;

/// How strongly an operation binds.
const CHOICE: u8 = 1;
const ATOM: u8 = 8;

/// The sign of an operation, and how strongly it binds.
fn operator(op: Op) -> (&'static str, u8) {
    match op {
        Op::Any => ("||", 2),
        Op::All => ("&&", 3),
        Op::Above => (">", 4),
        Op::AtLeast => (">=", 4),
        Op::Add => ("+", 5),
        Op::Sub => ("-", 5),
        Op::Mul | Op::Scale => ("*", 6),
        Op::Div => ("/", 6),
        _ => panic!("{op:?} has no sign"),
    }
}

struct Printer<'a> {
    dialect: &'static Dialect,
    formula: &'a Formula<'a>,
    graph: &'a Graph,
    /// The names that the books have for values.
    names: HashMap<usize, String>,
    /// The values that have a variable, and its name.
    variables: HashMap<usize, String>,
    uses: HashMap<usize, usize>,
    out: String,
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

/// The text of a function with the given name.
pub fn function(dialect: &'static Dialect, name: &str, formula: &Formula) -> String {
    let (graph, tree) = recorded(dialect, formula);
    let mut printer = Printer {
        dialect: &WGSL,
        formula,
        graph: &graph,
        names: HashMap::new(),
        variables: HashMap::new(),
        uses: HashMap::new(),
        out: String::new(),
    };
    let names = names(formula.defining);
    // a text of all that a value comes from can be long, so none is written in vain
    for value in (0..graph.nodes.len()).filter(|_| !names.is_empty()) {
        let text = printer.expression(value).0;
        let is_formula = |formula: &str| match formula.split_once("...") {
            Some((beginning, end)) => text.starts_with(beginning) && text.ends_with(end),
            None => text == formula,
        };
        if let Some((name, _)) = names.iter().find(|(_, formula)| is_formula(formula)) {
            printer.variables.insert(value, (*name).into());
        }
    }
    printer.names = take(&mut printer.variables);
    printer.dialect = dialect;
    printer.count(&tree, &[]);
    printer.head(name);
    printer.tree(&tree, "    ");
    printer.out + "}"
}

impl<'a> Printer<'a> {
    fn head(&mut self, name: &str) {
        let changed = self.changed();
        let parameter = |(name, kind): &(&str, Kind)| {
            let form = match self.dialect.pointers {
                Some([_, form, _]) if Some(*name) == changed => form,
                Some([form, ..]) if kind.fields().is_some() => form,
                _ => self.dialect.parameter,
            };
            let of = self.dialect.type_of(*kind);
            filled(form, &[("type", &of), ("name", name)])
        };
        let parameters: Vec<_> = self.formula.parameters.iter().map(parameter).collect();
        let parameters = parameters.join(", ");
        let result = self.dialect.type_of(self.formula.result);
        let of = changed.map_or(&result[..], |_| "void");
        let places = [("type", of), ("name", name), ("parameters", &parameters)];
        self.line("", &filled(self.dialect.function, &places));
    }

    /// The parameter that is changed in place of a result, where structs are passed by pointers.
    fn changed(&self) -> Option<&'static str> {
        self.dialect.pointers?;
        self.formula.result.fields()?;
        let mut parameters = self.formula.parameters.iter();
        let changed = parameters.find(|parameter| parameter.1 == self.formula.result)?;
        Some(changed.0)
    }

    fn node(&self, value: usize) -> &'a Node {
        &self.graph.nodes[value]
    }

    /// Counts how often each value is used on the path on which it is used most.
    fn count(&mut self, tree: &Tree, path: &[usize]) {
        match tree {
            Tree::Leaf(results) => {
                for (value, count) in self.uses([path, results].concat()) {
                    let most = self.uses.entry(value).or_default();
                    *most = count.max(*most);
                }
            }
            Tree::Branch(test, yes, no) => {
                for side in [yes, no] {
                    self.count(side, &[path, &[*test]].concat());
                }
            }
        }
    }

    /// How often each value is used by some and by each other.
    fn uses(&self, mut of: Vec<usize>) -> HashMap<usize, usize> {
        let mut uses: HashMap<usize, usize> = HashMap::new();
        while let Some(value) = of.pop() {
            let count = uses.entry(value).or_default();
            *count += 1;
            if *count == 1 || self.is_trivial(value) {
                of.extend(&self.node(value).of);
            }
        }
        uses
    }

    /// What has no variable, however often it is used.
    fn is_trivial(&self, value: usize) -> bool {
        let Node { op, kind, of } = self.node(value);
        let is_constant = |n: &usize| matches!(self.node(*n).op, Op::Constant(_));
        match op {
            Op::Parameter(_) | Op::Constant(_) | Op::Field(_) => true,
            _ => *kind == Kind::Flag || *op == VECTOR && of.iter().all(is_constant),
        }
    }

    /// How much there is to compute in a tree.
    fn size(&self, tree: &Tree) -> usize {
        match tree {
            Tree::Leaf(results) => self.uses(results.clone()).len(),
            Tree::Branch(_, yes, no) => self.size(yes) + self.size(no),
        }
    }

    fn line(&mut self, indent: &str, text: &str) {
        self.out += &wrapped(indent, &format!("{indent}        "), text);
    }

    fn tree(&mut self, tree: &Tree, indent: &str) {
        match tree {
            Tree::Leaf(results) => {
                for &value in results {
                    self.declare(value, true, indent);
                }
                self.returned(results, indent);
            }
            Tree::Branch(test, yes, no) => {
                self.declare(*test, true, indent);
                let mut text = self.text(*test, 0);
                // the shorter of the two stands in braces and returns
                let (mut short, mut long) = (yes, no);
                if self.size(yes) >= self.size(no) && !text.contains("is_extreme") {
                    (short, long) = (no, yes);
                    text = format!("!({text})");
                }
                let variables = self.variables.clone();
                self.line(indent, &filled(self.dialect.branch, &[("test", &text)]));
                self.tree(short, &format!("{indent}    "));
                self.line(indent, "}");
                self.variables = variables;
                self.tree(long, indent);
            }
        }
    }

    /// Returns a result, given its fields.
    fn returned(&mut self, results: &[usize], indent: &str) {
        let texts: Vec<_> = results.iter().map(|value| self.text(*value, 0)).collect();
        let Some((name, _, fields)) = self.formula.result.fields() else {
            return self.line(indent, &format!("return {};", texts[0]));
        };
        let places =
            |of: &str| -> Vec<_> { fields.iter().map(|field| self.field(of, field.0)).collect() };
        if let Some(changed) = self.changed() {
            for (place, text) in places(changed).iter().zip(texts) {
                if *place != text {
                    self.line(indent, &format!("{place} = {text};"));
                }
            }
            if indent.len() > 4 {
                self.line(indent, "return;");
            }
            return;
        }
        let whole = texts[0].split('.').next().expect("a text");
        if places(whole) == texts {
            return self.line(indent, &format!("return {whole};"));
        }
        let of = self.dialect.named(name);
        let made = [("type", &of[..]), ("values", &texts.join(", "))];
        for line in filled(self.dialect.made, &made).lines() {
            self.line(indent, line);
        }
    }

    /// Declares variables for what a value needs, and for itself, if it has a name or is used more than once.
    fn declare(&mut self, value: usize, is_result: bool, indent: &str) {
        if self.variables.contains_key(&value) {
            return;
        }
        for &child in &self.node(value).of {
            self.declare(child, false, indent);
        }
        let is_used_again = self.uses[&value] > 1;
        let name = match self.names.get(&value) {
            _ if self.is_trivial(value) => return,
            Some(name) if !is_result || is_used_again => name.clone(),
            _ if is_used_again => self.name(value),
            _ => return,
        };
        let of = self.dialect.type_of(self.node(value).kind);
        let text = self.expression(value).0;
        let places = [("type", &of[..]), ("name", &name), ("value", &text)];
        self.line(indent, &filled(self.dialect.variable, &places));
        self.variables.insert(value, name);
    }

    /// A name for a value that nobody has named: by what it is, or else by a number.
    fn name(&self, value: usize) -> String {
        let Node { op, of, .. } = self.node(value);
        let dot = (*op == DOT).then(|| self.joined(of, "_dot_"));
        let is_name = |text: &String| text.chars().all(|c| c.is_alphanumeric() || c == '_');
        let is_free = |name: &String| !self.variables.values().any(|used| used == name);
        let numbered = (1..).map(|n| format!("t{n}"));
        let mut names = dot.filter(is_name).into_iter().chain(numbered);
        names.find(is_free).expect("a number is free")
    }

    /// The text of a value, in parentheses if it binds less strongly than it has to.
    fn text(&self, value: usize, least: u8) -> String {
        if let Some(name) = self.variables.get(&value) {
            return name.clone();
        }
        match self.expression(value) {
            (text, level) if level < least => format!("({text})"),
            (text, _) => text,
        }
    }

    /// A field of what has a text.
    fn field(&self, of: &str, field: &str) -> String {
        let is_pointer = |(name, kind): &(&str, Kind)| *name == of && kind.fields().is_some();
        let is_pointer = self.formula.parameters.iter().any(is_pointer);
        let arrow = self.dialect.pointers.filter(|_| is_pointer);
        format!("{of}{}{field}", arrow.map_or(".", |[.., arrow]| arrow))
    }

    fn joined(&self, values: &[usize], separator: &str) -> String {
        let texts: Vec<_> = values.iter().map(|value| self.text(*value, 0)).collect();
        texts.join(separator)
    }

    /// The text of an operation, and how strongly it binds.
    fn expression(&self, value: usize) -> (String, u8) {
        let Node { op, kind, of } = self.node(value);
        let is_vector = kind.width() == 3;
        let call = |name: &str| format!("{name}({})", self.joined(of, ", "));
        let functions = self.dialect.vector_functions;
        let function = functions.iter().find(|(known, _)| is_vector && known == op);
        let text = match (*op, function) {
            (_, Some((_, name))) => call(name),
            (Op::Parameter(name), _) => name.into(),
            (Op::Constant(bits), _) => self.dialect.number(f32::from_bits(bits)),
            (Op::Field(name), _) => self.field(&self.text(of[0], ATOM), name),
            (Op::Call(name), _) => {
                // a user's function stands after the file
                let is_users = self.graph.defining.is_empty();
                call(&[self.dialect.prefix[usize::from(is_users)], name].concat())
            }
            (VECTOR, _) => self.vector(of),
            (Op::Own(name), _) => call(&(self.dialect.own)(name)),
            (Op::Neg, _) => return (format!("-{}", self.text(of[0], ATOM)), 7),
            (Op::Select, _) => return self.choice(of),
            _ => return self.operation(*op, of),
        };
        (text, ATOM)
    }

    fn vector(&self, mut numbers: &[usize]) -> String {
        if self.dialect.splats && *numbers == [numbers[0]; 3] {
            numbers = &numbers[..1];
        }
        let numbers = self.joined(numbers, ", ");
        format!("{}({numbers})", self.dialect.types[3])
    }

    fn choice(&self, of: &[usize]) -> (String, u8) {
        let [test, yes, no] = [0, 1, 2].map(|i| self.text(of[i], CHOICE + 1));
        let places = [("test", &test[..]), ("yes", &yes), ("no", &no)];
        let is_call = self.dialect.choice.starts_with("select");
        let level = if is_call { ATOM } else { CHOICE };
        (filled(self.dialect.choice, &places), level)
    }

    fn operation(&self, op: Op, of: &[usize]) -> (String, u8) {
        let (sign, level) = operator(op);
        let [first, .., last] = of else {
            panic!("{op:?} takes two");
        };
        // a constant stands on the right of a comparison
        if sign.starts_with('>') && matches!(self.node(*first).op, Op::Constant(_)) {
            let [left, right] = [last, first].map(|n| self.text(*n, level + 1));
            return (format!("{left} {} {right}", sign.replace('>', "<")), level);
        }
        let first = self.text(*first, level);
        let rest = of[1..].iter().map(|n| self.text(*n, level + 1));
        let text = rest.fold(first, |text, next| format!("{text} {sign} {next}"));
        (text, level)
    }
}
