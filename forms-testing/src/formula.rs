//! Parser of formulas in tests: a text over named variables becomes an expression.
//!
//! sum = product { (+|−) product } · product = sign { (*|/) sign } · sign = −sign | power · power = atom [** exponent]

/// Expressions that a formula can be made of.
pub trait Expressions {
    /// Expression.
    type Expr: Copy;
    /// Returns a number, written with digits and at most one decimal point.
    fn number(&mut self, decimal: &str) -> Self::Expr;
    /// Returns the variable, the named subformula or the constant of this name.
    fn named(&mut self, name: &str) -> Self::Expr;
    /// Returns a + b, a − b, a b or a/b, by the operator's sign.
    fn combined(&mut self, operator: char, operands: [Self::Expr; 2]) -> Self::Expr;
    /// Returns −a.
    fn negative(&mut self, operand: Self::Expr) -> Self::Expr;
    /// Returns a power whose exponent is a numerator and a denominator.
    fn power(&mut self, base: Self::Expr, exponent: [i64; 2]) -> Self::Expr;
    /// Returns a function of arguments.
    fn applied(&mut self, function: &str, arguments: &[Self::Expr]) -> Self::Expr;
    /// Returns `if a < b { then } else { otherwise }`, or with `<=` if the relation is not strict.
    fn selected(&mut self, sides: [Self::Expr; 2], strict: bool, branches: [Self::Expr; 2]) -> Self::Expr;
}

/// Parses a formula.
///
/// # Panics
/// If the text is not a formula.
pub fn parse<E: Expressions>(expressions: &mut E, formula: &str) -> E::Expr {
    let mut reader = Reader { expressions, tokens: tokens(formula), place: 0 };
    let expression = reader.sum();
    assert_eq!(reader.place, reader.tokens.len(), "unread text in {formula}");
    expression
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

struct Reader<'a, E> {
    expressions: &'a mut E,
    tokens: Vec<String>,
    place: usize,
}

impl<E: Expressions> Reader<'_, E> {
    fn is_next(&self, token: &str) -> bool {
        self.tokens.get(self.place).is_some_and(|next| next == token)
    }

    fn accept(&mut self, token: &str) -> bool {
        let found = self.is_next(token);
        self.place += usize::from(found);
        found
    }

    fn accept_one_of(&mut self, operators: [char; 2]) -> Option<char> {
        operators.into_iter().find(|operator| self.accept(&operator.to_string()))
    }

    fn expect(&mut self, token: &str) {
        assert!(self.accept(token), "expected {token} at {:?}", &self.tokens[self.place..]);
    }

    fn sum(&mut self) -> E::Expr {
        let mut sum = self.product();
        while let Some(operator) = self.accept_one_of(['+', '-']) {
            let term = self.product();
            sum = self.expressions.combined(operator, [sum, term]);
        }
        sum
    }

    fn product(&mut self) -> E::Expr {
        let mut product = self.sign();
        while let Some(operator) = self.accept_one_of(['*', '/']) {
            let factor = self.sign();
            product = self.expressions.combined(operator, [product, factor]);
        }
        product
    }

    fn sign(&mut self) -> E::Expr {
        if self.accept("-") {
            let positive = self.sign();
            return self.expressions.negative(positive);
        }
        let base = self.atom();
        if self.accept("**") {
            let exponent = self.exponent();
            return self.expressions.power(base, exponent);
        }
        base
    }

    /// Parses `3`, `-2`, `(3/2)`, `(-1/3)`.
    fn exponent(&mut self) -> [i64; 2] {
        let bracketed = self.accept("(");
        let sign = if self.accept("-") { -1 } else { 1 };
        let numerator = self.integer();
        let denominator = if bracketed && self.accept("/") { self.integer() } else { 1 };
        if bracketed {
            self.expect(")");
        }
        [sign * numerator, denominator]
    }

    fn integer(&mut self) -> i64 {
        self.place += 1;
        self.tokens[self.place - 1].parse().expect("an integer")
    }

    fn atom(&mut self) -> E::Expr {
        if self.accept("(") {
            let inner = self.sum();
            self.expect(")");
            return inner;
        }
        let token = self.tokens[self.place].clone();
        self.place += 1;
        if token.starts_with(|c: char| c.is_ascii_digit()) {
            self.expressions.number(&token)
        } else if token == "if" {
            self.select()
        } else if self.is_next("(") {
            let arguments = self.arguments();
            self.expressions.applied(&token, &arguments)
        } else {
            self.expressions.named(&token)
        }
    }

    fn arguments(&mut self) -> Vec<E::Expr> {
        self.expect("(");
        let mut arguments = vec![self.sum()];
        while self.accept(",") {
            arguments.push(self.sum());
        }
        self.expect(")");
        arguments
    }

    /// Parses `a < b { x } else { y }`.
    fn select(&mut self) -> E::Expr {
        let left = self.sum();
        let is_strict = !self.accept("<=");
        if is_strict {
            self.expect("<");
        }
        let right = self.sum();
        let then = self.branch();
        self.expect("else");
        let otherwise = self.branch();
        self.expressions.selected([left, right], is_strict, [then, otherwise])
    }

    fn branch(&mut self) -> E::Expr {
        self.expect("{");
        let value = self.sum();
        self.expect("}");
        value
    }
}

/// Defines `Formulas`, expressions of a pool of `forms-core` with names, and `program`, the kernel
/// of some formulas.
///
/// It is a macro because `forms-core` exists twice where it is tested: its unit tests have types of
/// their own, and its integration tests those of the library.
#[macro_export]
macro_rules! formulas {
    () => {
        use forms_core::expression::{
            Condition, Expr, Operation, Pool, Rational, Relation, Seam, Symbol, SymbolKind,
        };
        use forms_core::kernel::{KernelSource, Program, lower};
        use num_rational::Ratio;
        use $crate::formula::{Expressions, parse};

        /// Pool with named variables, the arguments of the kernels made from it, and names for
        /// subformulas.
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
                let arguments = variables
                    .split_whitespace()
                    .map(|name| pool.declare_symbol(name, SymbolKind::Local))
                    .collect();
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
                parse(self, formula)
            }

            /// Lowers the kernel with these outputs.
            pub(crate) fn program(&self, outputs: &[Expr]) -> Program {
                self.program_where(outputs, &[])
            }

            pub(crate) fn program_where(
                &self,
                outputs: &[Expr],
                domain: &[(Expr, Relation, Expr)],
            ) -> Program {
                let condition =
                    |&(left, relation, right): &(Expr, Relation, Expr)| Condition { left, relation, right };
                let source = KernelSource {
                    name: self.name.clone(),
                    public: true,
                    arguments: self.arguments.clone(),
                    outputs: outputs.to_vec(),
                    domain: domain.iter().map(condition).collect(),
                    ..KernelSource::default()
                };
                lower(&self.pool, &source).expect("a kernel")
            }
        }

        impl Expressions for Formulas {
            type Expr = Expr;

            fn number(&mut self, decimal: &str) -> Expr {
                let (whole, fraction) = decimal.split_once('.').unwrap_or((decimal, ""));
                let digits: num_bigint::BigInt = format!("{whole}{fraction}").parse().expect("digits");
                self.pool
                    .number(Rational::new(digits, num_bigint::BigInt::from(10).pow(fraction.len() as u32)))
            }

            fn named(&mut self, name: &str) -> Expr {
                if let Some((_, part)) = self.parts.iter().rev().find(|(part, _)| part == name) {
                    return *part;
                }
                if name == "pi" {
                    return self.pool.pi();
                }
                let symbol = self.symbol(name);
                self.pool.symbol(symbol)
            }

            fn combined(&mut self, operator: char, [a, b]: [Expr; 2]) -> Expr {
                match operator {
                    '+' => self.pool.add(a, b),
                    '-' => self.pool.subtract(a, b),
                    '*' => self.pool.multiply(a, b),
                    _ => self.pool.divide(a, b),
                }
            }

            fn negative(&mut self, operand: Expr) -> Expr {
                self.pool.negate(operand)
            }

            fn power(&mut self, base: Expr, [numerator, denominator]: [i64; 2]) -> Expr {
                self.pool.power(base, Ratio::new(numerator, denominator))
            }

            fn applied(&mut self, function: &str, arguments: &[Expr]) -> Expr {
                if function == "sqrt" {
                    return self.pool.sqrt(arguments[0]);
                }
                let operation =
                    Operation::named(function).unwrap_or_else(|| panic!("no function {function}"));
                self.pool.apply(operation, arguments)
            }

            fn selected(&mut self, [left, right]: [Expr; 2], strict: bool, branches: [Expr; 2]) -> Expr {
                let relation = if strict { Relation::Less } else { Relation::LessEqual };
                let [then, otherwise] = branches;
                self.pool.select((left, relation, right), then, otherwise, Seam::Agrees)
            }
        }

        /// Lowers the kernel of formulas over these variables.
        #[allow(dead_code, reason = "not every test has a kernel without names")]
        pub(crate) fn program(variables: &str, formulas: &[&str]) -> Program {
            let mut written = Formulas::over(variables);
            let outputs: Vec<Expr> = formulas.iter().map(|formula| written.parse(formula)).collect();
            written.program(&outputs)
        }
    };
}

#[cfg(test)]
mod tests {
    use super::{Expressions, parse};

    /// Expressions as their texts, with brackets around everything.
    struct Texts(Vec<String>);

    impl Texts {
        fn put(&mut self, text: String) -> usize {
            self.0.push(text);
            self.0.len() - 1
        }
    }

    impl Expressions for Texts {
        type Expr = usize;
        fn number(&mut self, decimal: &str) -> usize {
            self.put(decimal.to_owned())
        }
        fn named(&mut self, name: &str) -> usize {
            self.put(name.to_owned())
        }
        fn combined(&mut self, operator: char, [a, b]: [usize; 2]) -> usize {
            self.put(format!("({}{operator}{})", self.0[a], self.0[b]))
        }
        fn negative(&mut self, operand: usize) -> usize {
            self.put(format!("(-{})", self.0[operand]))
        }
        fn power(&mut self, base: usize, [numerator, denominator]: [i64; 2]) -> usize {
            self.put(format!("({}^{numerator}/{denominator})", self.0[base]))
        }
        fn applied(&mut self, function: &str, arguments: &[usize]) -> usize {
            let arguments: Vec<&str> = arguments.iter().map(|&argument| self.0[argument].as_str()).collect();
            self.put(format!("{function}[{}]", arguments.join(",")))
        }
        fn selected(&mut self, [a, b]: [usize; 2], strict: bool, [then, otherwise]: [usize; 2]) -> usize {
            let relation = if strict { "<" } else { "<=" };
            let [a, b, then, otherwise] = [a, b, then, otherwise].map(|part| self.0[part].as_str());
            self.put(format!("[{a}{relation}{b}?{then}:{otherwise}]"))
        }
    }

    #[test]
    fn powers_bind_before_signs_and_products_before_sums() {
        let cases = [
            ("a - b*c/d + 1.5", "((a-((b*c)/d))+1.5)"),
            ("-x**2 + y**(-1/3)", "((-(x^2/1))+(y^-1/3))"),
            ("atan2(-x, f(y)) - if x <= y { x } else { -y }", "(atan2[(-x),f[y]]-[x<=y?x:(-y)])"),
        ];
        for (formula, expected) in cases {
            let mut texts = Texts(Vec::new());
            let read = parse(&mut texts, formula);
            assert_eq!(texts.0[read], expected);
        }
    }
}
