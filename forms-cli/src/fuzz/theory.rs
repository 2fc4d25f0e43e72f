//! Theories that a grammar makes: declarations of every kind, statements about them, and kernels.

use super::Random;
use forms::core::certificate::{HEADER, antiderivatives, entry, file_lines};
use forms::core::check::{decide_all, read_theory};
use std::fmt::Write;

/// The variables of all expressions.
const VARIABLES: [&str; 4] = ["x", "y", "z", "c"];

/// Names that mean something else somewhere.
const NAMES: [&str; 16] = [
    "k",
    "printf",
    "main",
    "double",
    "match",
    "Some",
    "fn_",
    "M_PI",
    "forms_power",
    "self",
    "float4",
    "t0",
    "outputs",
    "_",
    "x__y",
    "type",
];

/// A theory as text, with what it declares.
#[derive(Default)]
pub(super) struct Theory {
    pub(super) text: String,
    scalars: Vec<String>,
    forms: Vec<String>,
    fields: Vec<String>,
    statements: Vec<String>,
    /// Kernels with their arguments.
    kernels: Vec<(String, Vec<&'static str>)>,
}

impl Theory {
    pub(super) fn random(random: &mut Random) -> Self {
        let mut theory = Theory::default();
        let domain =
            random.of(&["", " where x > 0", " where 0 < x < 1, y >= x", " where x**2 + y**2 < 1, z != 0"]);
        let _ = writeln!(theory.text, "chart P(x, y, z){domain};");
        let _ = writeln!(theory.text, "param c{};", random.of(&["", " where c > 0", " where c != 1"]));
        if random.one_in(2) {
            theory.text += "fn f(x, y);\n";
        }
        for number in 0..random.below(4) {
            theory.declaration(number, random);
        }
        for number in 0..1 + random.below(3) {
            theory.statement(number, random);
        }
        for number in 0..1 + random.below(2) {
            theory.new_kernel(number, random);
        }
        theory
    }

    /// A name that is declared, or one that may be.
    pub(super) fn name(&self, random: &mut Random) -> String {
        let all: Vec<&String> =
            self.scalars.iter().chain(&self.forms).chain(&self.fields).chain(&self.statements).collect();
        if all.is_empty() || random.one_in(8) {
            return random.of(&["P", "x", "dx", "f", "nobody", "k0"]).to_string();
        }
        all[random.below(all.len())].clone()
    }

    pub(super) fn kernel(&self, random: &mut Random) -> String {
        self.kernels[random.below(self.kernels.len())].0.clone()
    }

    /// A kernel, and rows for it.
    pub(super) fn rows(&self, random: &mut Random) -> (String, String) {
        let (name, arguments) = &self.kernels[random.below(self.kernels.len())];
        let mut rows = arguments.join(",") + "\n";
        for _ in 0..random.below(5) {
            let number = |_: &&str| {
                random
                    .of(&["0", "1", "-1", "0.5", "1/3", "1e-17", "-2.5e10", "1e300", "3e-310", "7", "1e-150"])
                    .to_string()
            };
            let row: Vec<String> = arguments.iter().map(number).collect();
            rows += &(row.join(",") + "\n");
        }
        (name.clone(), rows)
    }

    /// A certificate of the theory, as it would be written.
    pub(super) fn certificate(&self, file: &str) -> String {
        let (mut theory, errors) = read_theory(&self.text);
        let mut lines = HEADER.to_string() + &file_lines(file, &self.text);
        if !errors.is_empty() {
            return lines;
        }
        lines += &antiderivatives(&mut theory);
        let verdicts = decide_all(&mut theory);
        for (statement, verdict) in theory.statements.clone().iter().zip(&verdicts) {
            lines += &entry(&mut theory, statement, verdict);
        }
        lines
    }

    /// A scalar expression of some depth.
    fn scalar(&self, depth: usize, random: &mut Random) -> String {
        if depth == 0 || random.one_in(6) {
            return match random.below(8) {
                0..4 => random.of(&VARIABLES).to_string(),
                4 if !self.scalars.is_empty() => self.scalars[random.below(self.scalars.len())].clone(),
                5 => "pi".to_string(),
                _ => random.of(&["0", "1", "2", "3", "1/2", "0.1", "7/3", "1e-3"]).to_string(),
            };
        }
        let mut part = || self.scalar(depth - 1, random);
        let (a, b) = (part(), part());
        match random.below(14) {
            0..3 => format!("({a} + {b})"),
            3 => format!("({a} - {b})"),
            4..6 => format!("{a}*{b}"),
            6 => format!("{a}/({b})"),
            7 => format!("({a})**{}", random.of(&["2", "3", "-1", "(1/2)", "(-3/2)", "(2/3)"])),
            8 => format!("-({a})"),
            9 => format!("atan2({a}, {b})"),
            10 => format!("diff({a}, {})", random.of(&["x", "y", "c"])),
            _ => {
                let functions = [
                    "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh",
                    "tanh", "abs", "expm1",
                ];
                format!("{}({a})", random.of(&functions))
            }
        }
    }

    fn form(&self, random: &mut Random) -> String {
        if !self.forms.is_empty() && random.one_in(3) {
            return self.forms[random.below(self.forms.len())].clone();
        }
        format!("{}*dx + {}*dy", self.scalar(1, random), self.scalar(2, random))
    }

    fn field(&self, random: &mut Random) -> String {
        if !self.fields.is_empty() && random.one_in(2) {
            return self.fields[random.below(self.fields.len())].clone();
        }
        format!("({}*@x + {}*@z)", self.scalar(1, random), self.scalar(1, random))
    }

    fn declaration(&mut self, number: usize, random: &mut Random) {
        let text = match random.below(4) {
            0 => {
                let text = format!("let a{number} = {};", self.scalar(2, random));
                self.scalars.push(format!("a{number}"));
                text
            }
            1 => {
                let text = format!("form w{number} = {};", self.form(random));
                self.forms.push(format!("w{number}"));
                text
            }
            2 => {
                let text = format!("field v{number} = {};", self.field(random));
                self.fields.push(format!("v{number}"));
                text
            }
            _ => format!("map m{number}: P -> P = ({}, y, z);", self.scalar(1, random)),
        };
        self.text += &(text + "\n");
    }

    fn statement(&mut self, number: usize, random: &mut Random) {
        // now and then deep, where functions of functions cost most
        let depth = if random.one_in(8) { 4 + random.below(3) } else { 1 + random.below(3) };
        let equation = match random.below(7) {
            0 => format!("{} == {}", self.scalar(depth, random), self.scalar(depth, random)),
            1 => {
                let (a, b) = (self.scalar(depth, random), self.scalar(1, random));
                format!("({a})*({b}) == ({b})*({a})")
            }
            2 => {
                let (a, b) = (self.scalar(depth, random), self.scalar(1, random));
                format!("({a} + {b})**2 == ({a})**2 + 2*({a})*({b}) + ({b})**2")
            }
            3 => format!("d(d({})) == 0", self.form(random)),
            4 => {
                let (v, w) = (self.field(random), self.form(random));
                format!("lie({v}, {w}) == interior({v}, d({w})) + d(interior({v}, {w}))")
            }
            5 => format!("integral(s*{}, s = 0..1) == {}", self.scalar(1, random), self.scalar(1, random)),
            _ => format!("sin({0})**2 + cos({0})**2 == 1", self.scalar(depth, random)),
        };
        let condition = random.of(&["", "", " where x > 1", " where y != 0, z >= x", " where c < 0"]);
        let _ = writeln!(self.text, "{} s{number}: {equation}{condition};", random.of(&["prove", "refute"]));
        self.statements.push(format!("s{number}"));
    }

    fn new_kernel(&mut self, number: usize, random: &mut Random) {
        let own = match NAMES[random.below(NAMES.len())] {
            "k" => format!("k{number}"),
            name if self.kernels.iter().any(|known| known.0 == name) => format!("k{number}"),
            name => name.to_string(),
        };
        let mut outputs: Vec<String> = (0..1 + random.below(2)).map(|_| self.scalar(2, random)).collect();
        if random.one_in(3) {
            let (a, b) = (self.scalar(1, random), self.scalar(1, random));
            outputs.push(
                format!("if x {} y {{ {a} }} else jump {{ {b} }}", random.of(&["<", ">=", ">"]))
                    .replace("else jump", "else"),
            );
        }
        let body = if let [one] = &outputs[..] { one.clone() } else { format!("({})", outputs.join(", ")) };
        let domain = random.of(&["", " where x > 0", " where 0 < x <= 1e6, y > x", " where 1 >= x, 2 < x"]);
        let within = if random.one_in(6) { " within 16" } else { "" };
        let arguments = VARIABLES.to_vec();
        let _ = writeln!(self.text, "pub kernel {own}({}) = {body}{domain}{within};", arguments.join(", "));
        self.kernels.push((own, arguments));
    }
}
