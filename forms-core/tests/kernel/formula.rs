//! Parser of formulas in tests: a text over named variables becomes an expression of a pool.
//!
//! sum = product { (+|−) product } · product = sign { (*|/) sign } · sign = −sign | power · power = atom [** exponent]

use forms_core::expression::{
    Condition, Expr, Operation, Pool, Rational, Relation, Seam, Symbol, SymbolKind,
};
use forms_core::kernel::{KernelSource, Program, lower};
use num_rational::Ratio;

/// Pool with named variables, the arguments of the kernels made from it, and names for subformulas.
pub(crate) struct Formulas {
    pub(crate) pool: Pool,
    pub(crate) arguments: Vec<Symbol>,
    name: String,
    parts: Vec<(String, Expr)>,
}

impl Formulas {
    /// Creates a parser of formulas over these variables, written with spaces between them.
    pub(crate) fn over(variables: &str) -> Self {
        let mut pool = Pool::new();
        let arguments =
            variables.split_whitespace().map(|name| pool.declare_symbol(name, SymbolKind::Local)).collect();
        Formulas { pool, arguments, name: "kernel".to_string(), parts: Vec::new() }
    }

    /// Names a subformula for later formulas.
    pub(crate) fn name(&mut self, name: &str, part: Expr) -> Expr {
        self.parts.push((name.to_string(), part));
        part
    }

    pub(crate) fn define(&mut self, name: &str, formula: &str) -> Expr {
        let part = self.parse(formula);
        self.name(name, part)
    }

    /// Sets the name of the kernels made from here on.
    pub(crate) fn named(&mut self, name: &str) -> &mut Self {
        self.name = name.to_string();
        self
    }

    pub(crate) fn symbol(&self, name: &str) -> Symbol {
        let found = self.arguments.iter().find(|&&symbol| self.pool.symbol_name(symbol) == name);
        *found.unwrap_or_else(|| panic!("no variable {name}"))
    }

    pub(crate) fn parse(&mut self, formula: &str) -> Expr {
        let tokens = tokens(formula);
        let mut reader = Reader { formulas: self, tokens, place: 0 };
        let expression = reader.sum();
        assert_eq!(reader.place, reader.tokens.len(), "unread text in {formula}");
        expression
    }

    /// Lowers the kernel with these outputs.
    pub(crate) fn program(&self, outputs: &[Expr]) -> Program {
        self.program_where(outputs, &[])
    }

    pub(crate) fn program_where(&self, outputs: &[Expr], domain: &[(Expr, Relation, Expr)]) -> Program {
        let source = KernelSource {
            name: self.name.clone(),
            public: true,
            arguments: self.arguments.clone(),
            outputs: outputs.to_vec(),
            domain: domain
                .iter()
                .map(|&(left, relation, right)| Condition { left, relation, right })
                .collect(),
            ..KernelSource::default()
        };
        lower(&self.pool, &source).expect("a kernel")
    }
}

/// Lowers the kernel of formulas over these variables.
pub(crate) fn program(variables: &str, formulas: &[&str]) -> Program {
    let mut written = Formulas::over(variables);
    let outputs: Vec<Expr> = formulas.iter().map(|formula| written.parse(formula)).collect();
    written.program(&outputs)
}

fn tokens(formula: &str) -> Vec<String> {
    let characters: Vec<char> = formula.chars().collect();
    let mut tokens = Vec::new();
    let mut place = 0;
    while place < characters.len() {
        let start = place;
        let word = |c: &char| c.is_alphanumeric() || *c == '_' || *c == '.';
        if word(&characters[place]) {
            place += characters[place..].iter().take_while(|c| word(c)).count();
        } else if characters[place..].starts_with(&['*', '*']) || characters[place..].starts_with(&['<', '='])
        {
            place += 2;
        } else {
            place += 1;
        }
        if characters[start] != ' ' {
            tokens.push(characters[start..place].iter().collect());
        }
    }
    tokens
}

struct Reader<'a> {
    formulas: &'a mut Formulas,
    tokens: Vec<String>,
    place: usize,
}

impl Reader<'_> {
    fn accept(&mut self, token: &str) -> bool {
        let found = self.tokens.get(self.place).is_some_and(|next| next == token);
        self.place += usize::from(found);
        found
    }

    fn expect(&mut self, token: &str) {
        assert!(self.accept(token), "expected {token} at {:?}", &self.tokens[self.place..]);
    }

    fn sum(&mut self) -> Expr {
        let mut sum = self.product();
        loop {
            if self.accept("+") {
                let term = self.product();
                sum = self.formulas.pool.add(sum, term);
            } else if self.accept("-") {
                let term = self.product();
                sum = self.formulas.pool.subtract(sum, term);
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> Expr {
        let mut product = self.sign();
        loop {
            if self.accept("*") {
                let factor = self.sign();
                product = self.formulas.pool.multiply(product, factor);
            } else if self.accept("/") {
                let factor = self.sign();
                product = self.formulas.pool.divide(product, factor);
            } else {
                return product;
            }
        }
    }

    fn sign(&mut self) -> Expr {
        if self.accept("-") {
            let positive = self.sign();
            return self.formulas.pool.negate(positive);
        }
        let base = self.atom();
        if self.accept("**") {
            let exponent = self.exponent();
            return self.formulas.pool.power(base, exponent);
        }
        base
    }

    /// Parses `3`, `-2`, `(3/2)`, `(-1/3)`.
    fn exponent(&mut self) -> Ratio<i64> {
        let bracketed = self.accept("(");
        let sign = if self.accept("-") { -1 } else { 1 };
        let numerator = self.integer();
        let denominator = if bracketed && self.accept("/") { self.integer() } else { 1 };
        if bracketed {
            self.expect(")");
        }
        Ratio::new(sign * numerator, denominator)
    }

    fn integer(&mut self) -> i64 {
        self.place += 1;
        self.tokens[self.place - 1].parse().expect("an integer")
    }

    fn atom(&mut self) -> Expr {
        if self.accept("(") {
            let inner = self.sum();
            self.expect(")");
            return inner;
        }
        let token = self.tokens[self.place].clone();
        self.place += 1;
        if token.starts_with(|c: char| c.is_ascii_digit()) {
            return self.formulas.pool.number(decimal(&token));
        }
        if let Some((_, part)) = self.formulas.parts.iter().rev().find(|(name, _)| *name == token) {
            return *part;
        }
        match token.as_str() {
            "pi" => self.formulas.pool.pi(),
            "sqrt" => {
                let argument = self.arguments()[0];
                self.formulas.pool.sqrt(argument)
            }
            "if" => self.select(),
            _ if Operation::named(&token).is_some() => {
                let arguments = self.arguments();
                let operation = Operation::named(&token).expect("a function");
                self.formulas.pool.apply(operation, &arguments)
            }
            _ => {
                let symbol = self.formulas.symbol(&token);
                self.formulas.pool.symbol(symbol)
            }
        }
    }

    fn arguments(&mut self) -> Vec<Expr> {
        self.expect("(");
        let mut arguments = vec![self.sum()];
        while self.accept(",") {
            arguments.push(self.sum());
        }
        self.expect(")");
        arguments
    }

    /// Parses `if a < b { x } else { y }`.
    fn select(&mut self) -> Expr {
        let left = self.sum();
        let relation = if self.accept("<=") { Relation::LessEqual } else { Relation::Less };
        if relation == Relation::Less {
            self.expect("<");
        }
        let right = self.sum();
        self.expect("{");
        let then = self.sum();
        self.expect("}");
        self.expect("else");
        self.expect("{");
        let otherwise = self.sum();
        self.expect("}");
        self.formulas.pool.select((left, relation, right), then, otherwise, Seam::Agrees)
    }
}

fn decimal(text: &str) -> Rational {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits: num_bigint::BigInt = format!("{whole}{fraction}").parse().expect("digits");
    Rational::new(digits, num_bigint::BigInt::from(10).pow(fraction.len() as u32))
}
