//! Grammar of forgeries: lines of real certificates transplanted and changed, declarations with
//! disguised expressions, numbers at the limits of every type.
//!
//! Nothing here decides whether a claim is false; the caller that requests a forgery knows that.

use forms_testing::SplitMix;

/// Statement for which a certificate is forged.
#[derive(Clone, Debug)]
pub(crate) struct Target {
    /// Source whose only statement is `p`.
    pub(crate) source: String,
    /// `proved` for a false claim, `refuted` for a true one.
    pub(crate) verdict: &'static str,
    /// Lines of a real certificate of a similar claim, integrals first.
    pub(crate) integrals: Vec<String>,
    pub(crate) proof: Vec<String>,
}

const NUMBERS: &str = "0 1 -1 2 3 4 1/2 -1/2 6 16 60 64 119 120 121 127 128 255 256 4096 32767 65536 9223372036854775807 \
                       18446744073709551616";

/// Expressions equal to q wherever they are defined: `@` stands for q, `#` for another expression.
const DISGUISES: [&str; 26] = [
    "sqrt(@)**2",
    "sqrt(@)*sqrt(@)",
    "exp(log(@))",
    "(@)*(#)/(#)",
    "(#)*(@)/(#)",
    "(@)**2/(@)",
    "1/(1/(@))",
    "(@)**(1/3)*(@)**(2/3)",
    "((@)**3)**(1/3)",
    "abs(@)**2/(@)",
    "sin(asin(@))",
    "tan(atan(@))",
    "(@) + 0*(#)",
    "(@) + (#) - (#)",
    "sqrt(@)**3/sqrt(@)",
    "sqrt((@)*(#))**2/(#)",
    "-(-(@))",
    "(@)*(#)**2/(#)**2",
    "2*(@)/2",
    "sqrt(@*(#)**2)**2/(#)**2",
    "(@)**1",
    "log(exp(@))",
    "sqrt(-(-(@)))**2",
    "(sqrt(sqrt(@)))**4",
    "((@)*sin(#)/sin(#))",
    "(@)*(1 + cos(#))/(1 + cos(#))",
];

/// Expressions that are not negative where they are defined.
const SQUARES: [&str; 8] =
    ["(@)**2", "abs(@)", "sqrt(@)", "exp(@)", "(@)*(@)", "sqrt((@)**2)", "(@)**2/(#)**2", "abs(@)*abs(#)"];

/// Returns the parts of a source: its names, and all expressions in brackets, on a side, or in a
/// condition.
fn parts_of(source: &str) -> Vec<String> {
    let claim = source.rsplit("p:").next().unwrap_or_default().trim_end_matches(';');
    let (claim, conditions) = claim.split_once(" where ").unwrap_or((claim, ""));
    let mut parts: Vec<String> = claim.split("==").map(|side| side.trim().to_string()).collect();
    for condition in conditions.split(',') {
        let sides: Vec<&str> =
            condition.split(['<', '>', '=', '!']).filter(|side| !side.is_empty()).collect();
        parts.extend(sides.iter().map(|side| side.trim().to_string()));
        if let [left, right] = sides.as_slice() {
            parts.push(format!("({}) - ({})", left.trim(), right.trim()));
        }
    }
    let mut open: Vec<usize> = Vec::new();
    for (place, c) in claim.char_indices() {
        match c {
            '(' => open.push(place),
            ')' => {
                if let Some(start) = open.pop() {
                    parts.extend(claim[start + 1..place].split(',').map(|part| part.trim().to_string()));
                }
            }
            _ => {}
        }
    }
    let mut word = String::new();
    for c in claim.chars().chain([' ']) {
        if c.is_ascii_alphanumeric() {
            word.push(c);
        } else {
            let is_variable = word.len() == 1 && word.chars().all(|c| c.is_ascii_alphabetic());
            if is_variable {
                parts.push(word.clone());
            }
            word.clear();
        }
    }
    let balanced = |part: &String| part.matches('(').count() == part.matches(')').count();
    parts.retain(|part| !part.is_empty() && part.len() < 60 && balanced(part) && !part.contains(['=', '.']));
    parts.sort();
    parts.dedup();
    if parts.is_empty() {
        parts.push("2".into());
    }
    parts
}

/// Forges a certificate for a target.
pub(crate) fn forgery(random: &mut SplitMix, target: &Target, donors: &[Target]) -> String {
    let parts = parts_of(&target.source);
    let mut forger = Forger { random, parts: &parts, donors };
    let mut integrals = target.integrals.clone();
    let mut proof = match forger.random.below(4) {
        0 => forger.proof(0),
        1 if target.verdict == "proved" => forger.sign_proof(),
        _ => target.proof.clone(),
    };
    if target.verdict == "refuted" {
        proof = if forger.random.below(3) == 0 { forger.point() } else { target.proof.clone() };
    }
    for _ in 0..forger.random.below(4) {
        forger.change(&mut proof);
    }
    if forger.random.below(3) == 0 && !integrals.is_empty() {
        forger.change_offer(&mut integrals);
    }
    let mut lines = integrals;
    lines.push(format!("{} p", target.verdict));
    lines.extend(proof);
    lines.join("\n") + "\n"
}

struct Forger<'a> {
    random: &'a mut SplitMix,
    parts: &'a [String],
    donors: &'a [Target],
}

impl Forger<'_> {
    fn number(&mut self) -> String {
        let numbers: Vec<&str> = NUMBERS.split(' ').collect();
        self.random.of(&numbers).to_string()
    }

    fn part(&mut self) -> String {
        if self.random.below(8) == 0 {
            self.number()
        } else {
            self.parts[self.random.below(self.parts.len())].clone()
        }
    }

    /// Makes an expression of parts of the statement.
    fn expression(&mut self, depth: usize) -> String {
        if depth == 0 {
            return self.part();
        }
        let (a, b) = (self.expression(depth - 1), self.part());
        match self.random.below(9) {
            0 => format!("({a}) + ({b})"),
            1 => format!("({a}) - ({b})"),
            2 => format!("({a})*({b})"),
            3 => format!("({a})/({b})"),
            4 => format!("-({a})"),
            5 => self.filled(SQUARES[b.len() % SQUARES.len()], &a),
            6 => format!("({a})**({})", self.number()),
            _ => a,
        }
    }

    fn filled(&mut self, form: &str, q: &str) -> String {
        let other = self.part();
        form.replace('@', q).replace('#', &other)
    }

    /// Returns an expression that equals another wherever it is defined.
    fn disguised(&mut self, q: &str) -> String {
        let mut disguised = q.to_string();
        for _ in 0..=self.random.below(2) {
            let form = self.random.of(&DISGUISES);
            disguised = self.filled(form, &format!("({disguised})"));
        }
        disguised
    }

    /// Adds a base; the reason for its sign is often the base itself in disguise.
    fn base(&mut self, lines: &mut Vec<String>) {
        let depth = usize::from(self.random.below(4) == 0);
        let (base, is_positive) = (self.expression(depth), self.random.below(2) == 0);
        lines.push(format!("base {base}"));
        if self.random.below(2) == 0 {
            let order = ["2", "3", "4", "6", "1", "0", "64", "65", "256"][self.random.below(9)];
            lines.push(format!("root {order}"));
        }
        if self.random.below(4) == 0 {
            lines.push("logarithm".into());
        }
        if self.random.below(5) > 0 {
            let side = if is_positive { base } else { format!("-({base})") };
            let reason = self.disguised(&side);
            lines.push(format!("{} {reason}", if is_positive { "positive" } else { "negative" }));
        }
    }

    fn unit(&mut self) -> String {
        let (keyword, unit) = (["circle", "tangent", "exponent"][self.random.below(3)], self.part());
        if self.random.below(3) == 0 {
            let number = self.number();
            return format!("{keyword} ({unit})*({number})");
        }
        format!("{keyword} {unit}")
    }

    /// Makes the shortest forgery of a sign: one base with a disguised reason, and nothing else.
    fn sign_proof(&mut self) -> Vec<String> {
        let base = self.part();
        let (keyword, side) = if self.random.below(2) == 0 {
            ("positive", base.clone())
        } else {
            ("negative", format!("-({base})"))
        };
        let reason = self.disguised(&side);
        let mut lines = Vec::new();
        if self.random.below(3) == 0 {
            lines.push(self.unit());
        }
        lines.push(format!("base {base}"));
        if self.random.below(3) == 0 {
            lines.push(format!("root {}", 2 + self.random.below(5)));
        }
        lines.push(format!("{keyword} {reason}"));
        if self.random.below(4) == 0 {
            lines.push(format!("root {}", 2 + self.random.below(5)));
        }
        match self.random.below(4) {
            0 => lines.extend(["split 1".to_string(), "end".to_string()]),
            1 => lines.push("undefined".into()),
            _ => lines.push("zero".into()),
        }
        lines
    }

    fn proof(&mut self, depth: usize) -> Vec<String> {
        let mut lines = Vec::new();
        let mut bases = 0;
        for _ in 0..self.random.below(4) {
            if self.random.below(3) == 0 {
                lines.push(self.unit());
            } else {
                self.base(&mut lines);
                bases += 1;
            }
        }
        if bases > 0 && depth < 2 && self.random.below(3) == 0 {
            let numbers: Vec<String> =
                (0..=self.random.below(2)).map(|_| (1 + self.random.below(bases)).to_string()).collect();
            lines.push(format!("split {}", numbers.join(" ")));
            for _ in 0..self.random.below(3) {
                let signs: String = numbers.iter().map(|_| ['+', '-'][self.random.below(2)]).collect();
                lines.push(format!("case {signs}"));
                lines.extend(self.proof(depth + 1));
            }
            lines.push("end".into());
        } else {
            lines.push(if self.random.below(5) == 0 { "undefined" } else { "zero" }.into());
        }
        lines
    }

    /// Makes a point with values at the boundary of the domain, and two values of the sides.
    fn point(&mut self) -> Vec<String> {
        let mut lines = Vec::new();
        for part in self.parts {
            if part.len() == 1 && self.random.below(8) > 0 {
                let value = self.number();
                lines.push(format!("at {part} = {value}"));
            }
        }
        if self.random.below(2) == 0 {
            for _ in 0..=self.random.below(2) {
                let (place, value) = (self.number(), self.number());
                lines.push(format!("at f({place}, 1e-13) = {value}"));
            }
        }
        let (left, right) = (self.number(), self.number());
        lines.extend(["component ".to_string(), format!("left {left}"), format!("right {right}")]);
        lines
    }

    /// Changes one line, or transplants lines of another certificate.
    fn change(&mut self, lines: &mut Vec<String>) {
        let place = self.random.below(lines.len() + 1);
        let at = place.min(lines.len().saturating_sub(1));
        match self.random.below(11) {
            0 => lines.insert(place, self.unit()),
            1 => {
                let mut more = Vec::new();
                self.base(&mut more);
                lines.splice(place..place, more);
            }
            2 if !lines.is_empty() => {
                lines.remove(at);
            }
            3 if !lines.is_empty() => lines.insert(place, lines[at].clone()),
            4 if lines.len() > 1 => {
                let other = self.random.below(lines.len().max(1));
                lines.swap(at, other);
            }
            5 => {
                let donor = &self.donors[self.random.below(self.donors.len())].proof.clone();
                let start = self.random.below(donor.len() + 1);
                let end = start + self.random.below(donor.len() - start + 1);
                lines.splice(place..place, donor[start..end].to_vec());
            }
            6 if !lines.is_empty() => {
                let keyword = lines[at].split(' ').next().unwrap_or_default().to_string();
                let other = match keyword.as_str() {
                    "positive" => "negative",
                    "negative" => "positive",
                    "circle" => "tangent",
                    "tangent" => "circle",
                    "zero" => "undefined",
                    "undefined" => "zero",
                    other => other,
                };
                lines[at] = lines[at].replacen(&keyword, other, 1);
            }
            7 if !lines.is_empty() => {
                let line = lines[at].clone();
                if let Some((keyword, rest)) = line.split_once(' ')
                    && ["positive", "negative", "base", "circle", "tangent", "exponent"].contains(&keyword)
                {
                    lines[at] = format!("{keyword} {}", self.disguised(&format!("({rest})")));
                }
            }
            8 if !lines.is_empty() => {
                let line = lines[at].clone();
                if let Some((keyword, _)) = line.split_once(' ') {
                    let expression = self.expression(1);
                    let name = line.split(" = ").next().unwrap_or_default();
                    lines[at] = if keyword == "at" {
                        format!("{name} = {}", self.number())
                    } else {
                        format!("{keyword} {expression}")
                    };
                }
            }
            9 => {
                // only one of the cases remains
                if let (Some(first), Some(last)) = (
                    lines.iter().position(|line| line.starts_with("case")),
                    lines.iter().rposition(|line| line.starts_with("case")),
                ) && last > first
                {
                    lines.drain(first..last);
                }
            }
            _ => {
                // the digits of a line are replaced by a number at some limit
                if let Some(line) = lines.get(at).cloned()
                    && let Some(digit) = line.find(|c: char| c.is_ascii_digit())
                {
                    let rest = line[digit..].trim_start_matches(|c: char| c.is_ascii_digit());
                    lines[at] = format!("{}{}{rest}", &line[..digit], self.number());
                }
            }
        }
    }

    /// Changes an antiderivative, or its proof.
    fn change_offer(&mut self, lines: &mut Vec<String>) {
        let at = self.random.below(lines.len().max(1));
        let parts: Vec<&str> = lines[at].splitn(3, ' ').collect();
        if let ["integral", place, offer] = parts.as_slice() {
            let other = self.part();
            lines[at] = match self.random.below(7) {
                0 => format!("integral {place} {offer} + abs({other})/({other})"),
                1 => format!("integral {place} {offer} + atan(1/({other})) + atan({other})"),
                2 => format!("integral {place} {offer} + ({other})"),
                3 => format!("integral {place} ({offer})*abs({other})/({other})"),
                4 => format!("integral {place} {}", self.disguised(&format!("({offer})"))),
                5 => format!("integral {place} {offer} + 1/({other} - ({other}))"),
                _ => format!("integral {place} 2*({offer})"),
            };
        } else {
            let mut rest = lines.split_off(at);
            self.change(&mut rest);
            lines.extend(rest);
        }
    }
}
