//! Writes a recorded function in a language.

use std::collections::HashMap;
use std::mem::{replace, take};

use crate::dialect::{Dialect, WGSL, filled};
use crate::graph::{Op, Test};
use crate::kind::Kind;
use crate::tree::{Condition, Tree};
use crate::values::{Value, Values};
use crate::wrap::wrapped;

/// How strongly an operation binds.
const CHOICE: u8 = 1;
const COMPARISON: u8 = 2;
const SUM: u8 = 3;
const PRODUCT: u8 = 4;
const SIGN: u8 = 5;
const ATOM: u8 = 6;

pub struct Printer<'a> {
    pub dialect: &'static Dialect,
    pub values: Values<'a>,
    pub result: Kind,
    pub parameters: &'a [(&'a str, Kind)],
    /// The parameter that is changed in place of a result.
    pub changed: Option<&'static str>,
    /// What stands before the functions of the files that it calls.
    pub prefix: String,
    pub text: Text,
}

/// What is known of the text.
#[derive(Default)]
pub struct Text {
    /// The names that the books have for values.
    names: HashMap<usize, String>,
    /// The values that have a variable, and its name.
    variables: HashMap<usize, String>,
    uses: HashMap<usize, usize>,
    out: String,
}

impl Printer<'_> {
    /// The statements of a function.
    pub fn body(mut self, tree: &Tree, names: &[(&str, &str)]) -> String {
        self.count(tree, &mut vec![]);
        self.name_values(names);
        self.tree(tree, "    ");
        self.text.out
    }

    /// Counts how often each value is used on the path on which it is used most.
    fn count(&mut self, tree: &Tree, path: &mut Vec<usize>) {
        let before = path.len();
        match tree {
            Tree::Leaf(numbers) => {
                path.extend(self.results(numbers));
                for (value, count) in self.uses(path.clone()) {
                    let most = self.text.uses.entry(value).or_default();
                    *most = count.max(*most);
                }
            }
            Tree::Branch(condition, yes, no) => {
                path.extend(self.tests(condition));
                self.count(yes, path);
                self.count(no, path);
            }
        }
        path.truncate(before);
    }

    /// How often each value is used by some and by each other.
    fn uses(&self, mut of: Vec<usize>) -> HashMap<usize, usize> {
        let mut uses: HashMap<usize, usize> = HashMap::new();
        while let Some(value) = of.pop() {
            let count = uses.entry(value).or_default();
            *count += 1;
            if *count == 1 || self.values.is_part(value) {
                of.extend(self.values.children(value));
            }
        }
        uses
    }

    /// Names values as the books do, by their formulas in WGSL.
    fn name_values(&mut self, names: &[(&str, &str)]) {
        let (dialect, prefix) = (replace(&mut self.dialect, &WGSL), take(&mut self.prefix));
        for value in 0..self.values.all.len() {
            let text = self.formula(value).0;
            let is_formula = |formula: &str| match formula.split_once("...") {
                Some((beginning, end)) => text.starts_with(beginning) && text.ends_with(end),
                None => text == formula,
            };
            if let Some((name, _)) = names.iter().find(|(_, formula)| is_formula(formula)) {
                self.text.variables.insert(value, (*name).into());
            }
        }
        self.text.names = take(&mut self.text.variables);
        (self.dialect, self.prefix) = (dialect, prefix);
    }

    /// The values of the fields of a result.
    fn results(&mut self, numbers: &[usize]) -> Vec<usize> {
        let Some((_, _, fields)) = self.result.fields() else {
            return vec![self.values.value(numbers)];
        };
        let mut rest = numbers.iter().copied();
        let mut field = |kind: Kind| -> Vec<_> { rest.by_ref().take(kind.width()).collect() };
        let fields: Vec<_> = fields.iter().map(|(_, kind)| field(*kind)).collect();
        fields
            .iter()
            .map(|field| self.values.value(field))
            .collect()
    }

    fn tests(&mut self, condition: &Condition) -> Vec<usize> {
        condition
            .tests
            .iter()
            .map(|test| self.values.test(*test))
            .collect()
    }

    fn line(&mut self, indent: &str, text: &str) {
        self.text.out += &wrapped(indent, text);
    }

    fn tree(&mut self, tree: &Tree, indent: &str) {
        match tree {
            Tree::Leaf(numbers) => {
                let results = self.results(numbers);
                for &value in &results {
                    self.declare(value, true, indent);
                }
                let texts: Vec<_> = results.iter().map(|value| self.text(*value, 0)).collect();
                self.returned(&texts, indent);
            }
            Tree::Branch(condition, yes, no) => {
                let tests = self.tests(condition);
                for &test in &tests {
                    self.declare(test, true, indent);
                }
                let sign = if condition.is_any { " || " } else { " && " };
                let mut test = self.joined(&tests, sign);
                // the shorter of the two stands in braces and returns
                let (mut short, mut long) = (yes, no);
                if self.size(yes) >= self.size(no)
                    && !matches!(condition.tests[0], Test::Extreme(_))
                {
                    (short, long) = (no, yes);
                    test = format!("!({test})");
                }
                let variables = self.text.variables.clone();
                self.line(indent, &filled(self.dialect.branch, &[("test", &test)]));
                self.tree(short, &format!("{indent}    "));
                self.line(indent, "}");
                self.text.variables = variables;
                self.tree(long, indent);
            }
        }
    }

    /// How much there is to compute in a tree.
    fn size(&mut self, tree: &Tree) -> usize {
        match tree {
            Tree::Leaf(numbers) => {
                let results = self.results(numbers);
                self.uses(results).len()
            }
            Tree::Branch(_, yes, no) => self.size(yes) + self.size(no),
        }
    }

    /// Returns a result, given the texts of its fields.
    fn returned(&mut self, texts: &[String], indent: &str) {
        let Some((name, _, fields)) = self.result.fields() else {
            return self.line(indent, &format!("return {};", texts[0]));
        };
        let places = |of: &str| -> Vec<_> {
            let place = |(field, _): &(&str, Kind)| self.variable(&format!("{of}.{field}"));
            fields.iter().map(place).collect()
        };
        if let Some(changed) = self.changed {
            for (place, text) in places(changed).iter().zip(texts) {
                if place != text {
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
        let places = [
            ("type", &self.dialect.named(name)[..]),
            ("values", &texts.join(", ")),
        ];
        for line in filled(self.dialect.made, &places).lines() {
            self.line(indent, line);
        }
    }

    /// Declares variables for what a value needs, and for itself, if it has a name or is used more than once.
    fn declare(&mut self, value: usize, is_result: bool, indent: &str) {
        if self.text.variables.contains_key(&value) {
            return;
        }
        for child in self.values.children(value) {
            self.declare(child, false, indent);
        }
        if self.values.is_trivial(value) {
            return;
        }
        let is_used_again = self.text.uses[&value] > 1;
        let name = match self.text.names.get(&value) {
            Some(name) if !is_result || is_used_again => name.clone(),
            _ if is_used_again => self.name(value),
            _ => return,
        };
        let (of, text) = (
            self.dialect.type_of(self.values.kinds[value]),
            self.formula(value).0,
        );
        let places = [("type", &of[..]), ("name", &name), ("value", &text)];
        self.line(indent, &filled(self.dialect.variable, &places));
        self.text.variables.insert(value, name);
    }

    /// A name for a value that nobody has named: by what it is, or else by a number.
    fn name(&self, value: usize) -> String {
        let is_free = |name: &String| !self.text.variables.values().any(|used| used == name);
        if let Value::Call("dot", of) = &self.values.all[value] {
            let [a, b] = [of[0], of[1]].map(|value| self.text(value, 0));
            let name = format!("{a}_dot_{b}");
            if name.chars().all(|c| c.is_alphanumeric() || c == '_') && is_free(&name) {
                return name;
            }
        }
        let mut numbered = (1..).map(|n| format!("t{n}"));
        numbered.find(is_free).expect("a number is free")
    }

    /// The text of a value, in parentheses if it binds less strongly than it has to.
    fn text(&self, value: usize, least: u8) -> String {
        if let Some(name) = self.text.variables.get(&value) {
            return name.clone();
        }
        let (text, level) = self.formula(value);
        if level < least {
            format!("({text})")
        } else {
            text
        }
    }

    /// A parameter, or a field of one.
    fn variable(&self, name: &str) -> String {
        let of = name.split('.').next();
        let is_of =
            |(parameter, kind): &(&str, Kind)| kind.fields().is_some() && of == Some(parameter);
        match self.dialect.pointers {
            Some([.., arrow]) if self.parameters.iter().any(is_of) => name.replacen('.', arrow, 1),
            _ => name.into(),
        }
    }

    fn joined(&self, values: &[usize], separator: &str) -> String {
        let texts: Vec<_> = values.iter().map(|value| self.text(*value, 0)).collect();
        texts.join(separator)
    }

    fn call(&self, name: &str, arguments: &[usize]) -> (String, u8) {
        let name = self.dialect.function_named(name, &self.prefix);
        (format!("{name}({})", self.joined(arguments, ", ")), ATOM)
    }

    /// The formula of a value, and how strongly it binds.
    fn formula(&self, value: usize) -> (String, u8) {
        let is_vector = self.values.kinds[value].width() == 3;
        match &self.values.all[value] {
            Value::Variable(name) => (self.variable(name), ATOM),
            Value::Constant(bits) => {
                let x = f32::from_bits(*bits);
                (self.dialect.number(x), if x < 0.0 { SIGN } else { ATOM })
            }
            Value::Binary(op, a, b) => self.binary(*op, *a, *b, is_vector),
            Value::Neg(a) => match self.dialect.operators {
                Some([.., neg]) if is_vector => self.call(neg, &[*a]),
                _ => (format!("-{}", self.text(*a, ATOM)), SIGN),
            },
            Value::Call(name, arguments) => self.call(name, arguments),
            Value::Field(of, field) => (format!("{}.{field}", self.text(*of, ATOM)), ATOM),
            Value::Vector(numbers) => (self.vector(numbers), ATOM),
            Value::Above(a, b) => (self.comparison(*a, *b, ""), COMPARISON),
            Value::AtLeast(a, b) => (self.comparison(*a, *b, "="), COMPARISON),
            Value::Select(tests, yes, no) => {
                let is_call = self.dialect.choice.starts_with("select");
                let (least, level) = if is_call {
                    (0, ATOM)
                } else {
                    (CHOICE + 1, CHOICE)
                };
                let test = self.joined(tests, " && ");
                let [yes, no] = [yes, no].map(|value| self.text(*value, least));
                let places = [("test", &test[..]), ("yes", &yes), ("no", &no)];
                (filled(self.dialect.choice, &places), level)
            }
        }
    }

    fn vector(&self, numbers: &[usize; 3]) -> String {
        let (name, takes_one) = self.dialect.vector;
        let is_uniform = takes_one && *numbers == [numbers[0]; 3];
        let numbers = if is_uniform { &numbers[..1] } else { numbers };
        format!("{name}({})", self.joined(numbers, ", "))
    }

    fn binary(&self, op: Op, a: usize, b: usize, is_vector: bool) -> (String, u8) {
        let by_number = is_vector && self.values.kinds[b].width() == 1;
        if let (Some([add, sub, mul, over, at_most, scale, _]), true) =
            (self.dialect.operators, is_vector)
        {
            let name = match op {
                Op::Add => add,
                Op::Sub => sub,
                Op::Mul if by_number => scale,
                Op::Mul => mul,
                Op::Div => over,
                Op::Min => at_most,
                Op::Max => panic!("no formula has the maximum of vectors"),
            };
            return self.call(name, &[a, b]);
        }
        let (sign, level) = match op {
            Op::Add => ("+", SUM),
            Op::Sub => ("-", SUM),
            Op::Mul => ("*", PRODUCT),
            Op::Div => ("/", PRODUCT),
            Op::Max => return self.call("max", &[a, b]),
            Op::Min if by_number => {
                return (
                    format!("min({}, {})", self.text(a, 0), self.vector(&[b; 3])),
                    ATOM,
                );
            }
            Op::Min => return self.call("min", &[a, b]),
        };
        let (left, right) = (self.text(a, level), self.text(b, level + 1));
        (format!("{left} {sign} {right}"), level)
    }

    /// left > right; a constant stands on the right.
    fn comparison(&self, left: usize, right: usize, equal: &str) -> String {
        let is_constant = |value: usize| matches!(self.values.all[value], Value::Constant(_));
        let is_turned = is_constant(left) && !is_constant(right);
        let (left, sign, right) = if is_turned {
            (right, "<", left)
        } else {
            (left, ">", right)
        };
        let [left, right] = [left, right].map(|value| self.text(value, SUM));
        format!("{left} {sign}{equal} {right}")
    }
}
