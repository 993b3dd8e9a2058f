//! Writes a recorded function in a language.

use std::collections::{HashMap, HashSet};
use std::mem::{replace, take};

use crate::dialect::{Dialect, WGSL, filled};
use crate::graph::{Op, Test};
use crate::kind::Kind;
use crate::tree::{Condition, Tree};
use crate::values::{Comparison, Type, Value, Values};

/// How strongly an operation binds.
const CHOICE: u8 = 1;
const SUM: u8 = 3;
const PRODUCT: u8 = 4;
const SIGN: u8 = 5;
const ATOM: u8 = 6;

/// The longest line.
const WIDTH: usize = 110;

pub struct Printer<'a> {
    dialect: &'static Dialect,
    values: Values<'a>,
    result: Kind,
    pub parameters: Vec<(&'static str, Kind)>,
    /// The parameter that is changed in place of a result.
    pub changed: Option<&'static str>,
    /// The names that the books have for values.
    named: HashMap<usize, String>,
    /// What stands before the functions of the files that it calls.
    pub prefix: String,
    /// The values that have a variable, and its name.
    variables: HashMap<usize, String>,
    uses: HashMap<usize, usize>,
    out: String,
}

impl<'a> Printer<'a> {
    pub fn new(dialect: &'static Dialect, values: Values<'a>, result: Kind) -> Self {
        let (named, variables, uses) = (HashMap::new(), HashMap::new(), HashMap::new());
        Self {
            dialect,
            values,
            result,
            parameters: vec![],
            changed: None,
            named,
            prefix: dialect.prefix.into(),
            variables,
            uses,
            out: String::new(),
        }
    }

    /// The statements of a function.
    pub fn body(mut self, tree: &Tree, names: &[(&str, &str)]) -> String {
        let mut path = vec![];
        self.count(tree, &mut path);
        self.name_values(names);
        self.tree(tree, "    ");
        self.out
    }

    /// Names values as the books do, by their formulas in WGSL.
    fn name_values(&mut self, names: &[(&str, &str)]) {
        let (dialect, prefix) = (replace(&mut self.dialect, &WGSL), take(&mut self.prefix));
        for value in 0..self.values.all.len() {
            let text = self.body_of(value).0;
            let is_formula = |formula: &str| match formula.split_once("...") {
                Some((beginning, end)) => text.starts_with(beginning) && text.ends_with(end),
                None => text == formula,
            };
            if let Some((name, _)) = names.iter().find(|(_, formula)| is_formula(formula)) {
                self.variables.insert(value, (*name).into());
            }
        }
        self.named = take(&mut self.variables);
        (self.dialect, self.prefix) = (dialect, prefix);
    }

    /// Counts how often each value is used on the path on which it is used most.
    fn count(&mut self, tree: &Tree, path: &mut Vec<usize>) {
        match tree {
            Tree::Leaf(numbers) => {
                let before = path.len();
                path.extend(self.results(numbers));
                let mut uses: HashMap<usize, usize> = HashMap::new();
                let mut rest = path.clone();
                while let Some(value) = rest.pop() {
                    let count = uses.entry(value).or_default();
                    *count += 1;
                    // a field has no variable of its own: its struct has
                    if *count == 1 || matches!(self.values.all[value], Value::Field(..)) {
                        rest.extend(self.values.children(value));
                    }
                }
                for (value, count) in uses {
                    let most = self.uses.entry(value).or_default();
                    *most = count.max(*most);
                }
                path.truncate(before);
            }
            Tree::Branch(condition, yes, no) => {
                let before = path.len();
                path.extend(self.compared(condition));
                self.count(yes, path);
                self.count(no, path);
                path.truncate(before);
            }
        }
    }

    /// The values of the fields of a result.
    fn results(&mut self, numbers: &[u32]) -> Vec<usize> {
        let Some((_, _, fields)) = self.result.fields() else {
            return vec![self.values.value(numbers)];
        };
        let mut rest = numbers;
        let field = |(_, kind): &(&str, Kind)| {
            let (first, others) = rest.split_at(kind.width());
            rest = others;
            self.values.value(first)
        };
        fields.iter().map(field).collect()
    }

    fn compared(&mut self, condition: &Condition) -> Vec<usize> {
        let (Condition::All(tests) | Condition::Any(tests)) = condition;
        let of = |test: &Test| match *test {
            Test::Above(a, b) | Test::AtLeast(a, b) => {
                vec![self.values.number(a), self.values.number(b)]
            }
            Test::Extreme(a) => vec![self.values.number(a)],
        };
        tests.iter().flat_map(of).collect()
    }

    fn line(&mut self, indent: &str, text: &str) {
        self.out += &wrapped(indent, text);
    }

    fn tree(&mut self, tree: &Tree, indent: &str) {
        match tree {
            Tree::Leaf(numbers) => {
                let results = self.results(numbers);
                for &value in &results {
                    self.declare(value, true, indent);
                }
                let texts: Vec<_> = results.iter().map(|value| self.text(*value, 0)).collect();
                let Some((name, _, fields)) = self.result.fields() else {
                    return self.line(indent, &format!("return {};", texts[0]));
                };
                if let Some(changed) = self.changed {
                    for (text, (field, _)) in texts.iter().zip(fields) {
                        let place = self.variable(&format!("{changed}.{field}"));
                        if *text != place {
                            self.line(indent, &format!("{place} = {text};"));
                        }
                    }
                    if indent.len() > 4 {
                        self.line(indent, "return;");
                    }
                    return;
                }
                if let Some(whole) = self.whole(&results, fields) {
                    return self.line(indent, &format!("return {whole};"));
                }
                let (of, values) = (self.dialect.named(name), texts.join(", "));
                match self.dialect.made {
                    Ok(made) => {
                        let made = filled(made, &[("type", &of), ("values", &values)]);
                        self.line(indent, &format!("return {made};"));
                    }
                    Err(made) => {
                        let places = [("type", &of[..]), ("name", "result"), ("values", &values)];
                        self.line(indent, &filled(made, &places));
                        self.line(indent, "return result;");
                    }
                }
            }
            Tree::Branch(condition, yes, no) => {
                for value in self.compared(condition) {
                    self.declare(value, true, indent);
                }
                // the shorter of the two stands in braces and returns
                let (size_of_yes, size_of_no) = (self.size(yes), self.size(no));
                let (short, long, is_negated) = if size_of_yes < size_of_no || is_extreme(condition)
                {
                    (yes, no, false)
                } else {
                    (no, yes, true)
                };
                let test = self.condition(condition, is_negated);
                let variables = self.variables.clone();
                self.line(indent, &filled(self.dialect.branch, &[("test", &test)]));
                self.tree(short, &format!("{indent}    "));
                self.line(indent, "}");
                self.variables = variables;
                self.tree(long, indent);
            }
        }
    }

    /// The struct whose fields these are, in order.
    fn whole(&self, values: &[usize], fields: &[(&str, Kind)]) -> Option<String> {
        let of = |(value, (field, _)): (&usize, &(&str, Kind))| match &self.values.all[*value] {
            Value::Variable(name) => name
                .strip_suffix(field)?
                .strip_suffix('.')
                .map(String::from),
            _ => None,
        };
        let mut all = values.iter().zip(fields).map(of);
        let first = all.next()??;
        all.all(|name| name.as_ref() == Some(&first))
            .then_some(first)
    }

    /// How much there is to compute in a tree.
    fn size(&mut self, tree: &Tree) -> usize {
        match tree {
            Tree::Leaf(numbers) => {
                let (mut all, mut rest) = (HashSet::new(), self.results(numbers));
                while let Some(value) = rest.pop() {
                    if all.insert(value) {
                        rest.extend(self.values.children(value));
                    }
                }
                all.len()
            }
            Tree::Branch(_, yes, no) => self.size(yes) + self.size(no),
        }
    }

    fn condition(&mut self, condition: &Condition, is_negated: bool) -> String {
        let (tests, sign) = match condition {
            Condition::All(tests) => (tests, " && "),
            Condition::Any(tests) => (tests, " || "),
        };
        let of = |test: &Test| {
            let (left, right, or_equal) = match *test {
                Test::Above(a, b) => (a, b, false),
                Test::AtLeast(a, b) => (a, b, true),
                Test::Extreme(a) => {
                    let square = self.values.number(a);
                    return format!(
                        "{}({})",
                        self.dialect.function_named("is_extreme", &self.prefix),
                        self.text(square, 0)
                    );
                }
            };
            let (left, right) = (self.values.number(left), self.values.number(right));
            self.comparison(&Comparison {
                left,
                right,
                or_equal,
            })
        };
        let text = tests.iter().map(of).collect::<Vec<_>>().join(sign);
        if is_negated {
            format!("!({text})")
        } else {
            text
        }
    }

    /// Declares variables for what a value needs, and for itself, if it has a name or is used more than once.
    fn declare(&mut self, value: usize, is_result: bool, indent: &str) {
        if self.variables.contains_key(&value) {
            return;
        }
        for child in self.values.children(value) {
            self.declare(child, false, indent);
        }
        if self.values.is_trivial(value) {
            return;
        }
        let name = self
            .named
            .get(&value)
            .filter(|_| !is_result || self.uses[&value] > 1)
            .cloned();
        let name = match name {
            Some(name) => name,
            None if self.uses[&value] > 1 => self.name(value),
            None => return,
        };
        let of = match self.values.types[value] {
            Type::Number => self.dialect.types[0].into(),
            Type::Vector => self.dialect.types[2].into(),
            Type::Struct(kind) => self
                .dialect
                .named(kind.fields().expect("a struct has fields").0),
        };
        let text = self.body_of(value).0;
        let places = [("type", &of[..]), ("name", &name), ("value", &text)];
        self.line(indent, &filled(self.dialect.variable, &places));
        self.variables.insert(value, name);
    }

    /// A name for a value that nobody has named: by what it is, or else by a number.
    fn name(&self, value: usize) -> String {
        let plain = |value: &usize| match &self.values.all[*value] {
            Value::Variable(name) if !name.contains('.') => Some(name.clone()),
            _ => self.variables.get(value).cloned(),
        };
        let own = match &self.values.all[value] {
            Value::Call("dot", of) => plain(&of[0])
                .zip(plain(&of[1]))
                .map(|(a, b)| format!("{a}_dot_{b}")),
            _ => None,
        };
        let is_free = |name: &String| !self.variables.values().any(|used| used == name);
        let numbered = || {
            let mut all = (1..=self.variables.len() + 1).map(|n| format!("t{n}"));
            all.find(is_free)
                .expect("one more than there are variables")
        };
        own.filter(is_free).unwrap_or_else(numbered)
    }

    /// The text of a value, in parentheses if it binds less strongly than it has to.
    fn text(&self, value: usize, least: u8) -> String {
        if let Some(name) = self.variables.get(&value) {
            return name.clone();
        }
        let (text, level) = self.body_of(value);
        if level < least {
            format!("({text})")
        } else {
            text
        }
    }

    /// A parameter, or a field of one.
    fn variable(&self, name: &str) -> String {
        let is_of = |(of, kind): &(&str, Kind)| {
            let rest = name.strip_prefix(of);
            kind.fields().is_some() && rest.is_some_and(|rest| rest.starts_with('.'))
        };
        match self.dialect.pointers {
            Some([.., arrow]) if self.parameters.iter().any(is_of) => name.replacen('.', arrow, 1),
            _ => name.into(),
        }
    }

    fn call(&self, name: &str, arguments: &[usize]) -> (String, u8) {
        let arguments: Vec<_> = arguments.iter().map(|value| self.text(*value, 0)).collect();
        (format!("{name}({})", arguments.join(", ")), ATOM)
    }

    /// The text of a value, and how strongly it binds.
    fn body_of(&self, value: usize) -> (String, u8) {
        let is_vector = self.values.types[value] == Type::Vector;
        match &self.values.all[value] {
            Value::Variable(name) => (self.variable(name), ATOM),
            Value::Constant(bits) => {
                let x = f32::from_bits(*bits);
                (self.dialect.number(x), if x < 0.0 { SIGN } else { ATOM })
            }
            Value::Binary(op, a, b) => self.binary(*op, *a, *b, is_vector),
            Value::Neg(a) => match self.dialect.operators {
                Some(operators) if is_vector => self.call(operators[6], &[*a]),
                _ => (format!("-{}", self.text(*a, ATOM)), SIGN),
            },
            Value::Call(name, arguments) => {
                self.call(&self.dialect.function_named(name, &self.prefix), arguments)
            }
            Value::Field(of, field) => (format!("{}.{field}", self.text(*of, ATOM)), ATOM),
            Value::Vector(numbers) => {
                let (name, takes_one) = self.dialect.vector;
                let is_uniform = takes_one && numbers.iter().all(|n| n == &numbers[0]);
                self.call(name, if is_uniform { &numbers[..1] } else { numbers })
            }
            Value::Select(tests, yes, no) => {
                let tests: Vec<_> = tests.iter().map(|test| self.comparison(test)).collect();
                let level = if self.dialect.choice.starts_with("select") {
                    0
                } else {
                    CHOICE + 1
                };
                let (test, yes, no) = (
                    tests.join(" && "),
                    self.text(*yes, level),
                    self.text(*no, level),
                );
                let places = [("test", &test[..]), ("yes", &yes), ("no", &no)];
                (
                    filled(self.dialect.choice, &places),
                    if level == 0 { ATOM } else { CHOICE },
                )
            }
        }
    }

    fn binary(&self, op: Op, a: usize, b: usize, is_vector: bool) -> (String, u8) {
        let by_number = self.values.types[b] == Type::Number;
        if let (Some(operators), true) = (self.dialect.operators, is_vector) {
            let operator = match op {
                Op::Add => 0,
                Op::Sub => 1,
                Op::Mul if by_number => 3,
                Op::Mul => 2,
                Op::Div => 4,
                Op::Min => 5,
                Op::Max => panic!("no formula has the maximum of vectors"),
            };
            return self.call(operators[operator], &[a, b]);
        }
        let (sign, level) = match op {
            Op::Add => ("+", SUM),
            Op::Sub => ("-", SUM),
            Op::Mul => ("*", PRODUCT),
            Op::Div => ("/", PRODUCT),
            Op::Max => {
                return self.call(&self.dialect.function_named("max", &self.prefix), &[a, b]);
            }
            Op::Min if is_vector && by_number => {
                let (name, takes_one) = self.dialect.vector;
                let number = self.text(b, 0);
                let numbers = vec![number; if takes_one { 1 } else { 3 }].join(", ");
                return (format!("min({}, {name}({numbers}))", self.text(a, 0)), ATOM);
            }
            Op::Min => {
                return self.call(&self.dialect.function_named("min", &self.prefix), &[a, b]);
            }
        };
        let (left, right) = (self.text(a, level), self.text(b, level + 1));
        (format!("{left} {sign} {right}"), level)
    }

    fn comparison(
        &self,
        &Comparison {
            left,
            right,
            or_equal,
        }: &Comparison,
    ) -> String {
        let constant = |value: usize| matches!(self.values.all[value], Value::Constant(_));
        let (left, sign, right) = if constant(left) && !constant(right) {
            (right, "<", left)
        } else {
            (left, ">", right)
        };
        let equal = if or_equal { "=" } else { "" };
        format!(
            "{} {sign}{equal} {}",
            self.text(left, SUM),
            self.text(right, SUM)
        )
    }
}

fn is_extreme(condition: &Condition) -> bool {
    let (Condition::All(tests) | Condition::Any(tests)) = condition;
    matches!(tests[0], Test::Extreme(_))
}

/// Text in lines of at most [`WIDTH`], each broken where the parentheses are fewest.
pub fn wrapped(indent: &str, text: &str) -> String {
    broken(indent, &format!("{indent}        "), text)
}

fn broken(indent: &str, next: &str, text: &str) -> String {
    if indent.len() + text.len() <= WIDTH {
        return format!("{indent}{text}\n");
    }
    let (mut depth, mut best) = (0, None);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '{' => depth += 1,
            ')' | '}' => depth -= 1,
            ' ' if at > 24 && indent.len() + at <= WIDTH => {
                let rest = &text[at + 1..];
                let breaks = text[..at].ends_with(',')
                    || ["+ ", "- ", "* ", "/ ", "? ", ": ", "|| ", "&& "]
                        .iter()
                        .any(|sign| rest.starts_with(sign));
                // between arguments rather than within one
                let rank = (depth, !text[..at].ends_with(','));
                if breaks && best.is_none_or(|(least, _)| rank <= least) {
                    best = Some((rank, at));
                }
            }
            _ => {}
        }
    }
    match best {
        Some((_, at)) => format!(
            "{indent}{}\n{}",
            &text[..at],
            broken(next, next, &text[at + 1..])
        ),
        None => format!("{indent}{text}\n"),
    }
}
