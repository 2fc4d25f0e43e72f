//! Linearising: sums and products become binary operations again, in the order in which the outputs
//! need them.
//!
//! Σ: the first positive term, then additions and subtractions. Π: the powers in the numerator,
//! over the product of the powers in the denominator. All powers of one base come from one addition
//! chain, half-integer ones with one √.

use super::chain::addition_chain;
use super::constant::Constant;
use super::graph::{Coefficient, Exponent, Form, Graph, Node, Scaled};
use super::program::{Instruction, Program, Value};
use num_integer::Integer;
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// Returns the program that computes the graph's roots, with the name, arguments and conditions of
/// `program`.
pub(super) fn linearise(graph: &Graph, program: &Program) -> Program {
    let mut powers: FxHashMap<Node, Vec<i32>> = FxHashMap::default();
    for node in graph.reachable() {
        if let Form::Product(factors) = graph.form(node) {
            for (base, exponent) in factors.iter() {
                powers.entry(*base).or_default().push(exponent.0.abs());
            }
        }
    }
    let mut lines = Lines {
        graph,
        powers,
        instructions: Vec::new(),
        values: FxHashMap::default(),
        chains: FxHashMap::default(),
    };
    for node in graph.reachable() {
        let value = lines.node(node);
        lines.values.insert(node, value);
    }
    let roots: Vec<Value> = graph.roots.iter().map(|&root| lines.scaled(root)).collect();
    program.with_roots(lines.instructions, &roots)
}

struct Lines<'a> {
    graph: &'a Graph,
    /// Magnitudes of the exponents that each base is raised to, in 24ths.
    powers: FxHashMap<Node, Vec<i32>>,
    instructions: Vec<Instruction>,
    values: FxHashMap<Node, Value>,
    /// Available powers of each base, by the magnitude of the exponent in 24ths.
    chains: FxHashMap<Node, FxHashMap<i32, Value>>,
}

impl Lines<'_> {
    fn push(&mut self, instruction: Instruction) -> Value {
        self.instructions.push(instruction);
        Value(self.instructions.len() as u32 - 1)
    }

    fn constant(&mut self, constant: Constant) -> Value {
        self.push(Instruction::Constant(constant))
    }

    /// c n
    fn scaled(&mut self, scaled: Scaled) -> Value {
        let magnitude = self.multiple(scaled.coefficient.magnitude(), scaled.node);
        if scaled.coefficient.is_negative() { self.push(Instruction::Negate(magnitude)) } else { magnitude }
    }

    /// c n for c ≥ 0; the coefficient is multiplied into a number among the factors.
    fn multiple(&mut self, coefficient: Coefficient, node: Node) -> Value {
        if coefficient == Coefficient::ONE {
            return self.values[&node];
        }
        match self.graph.form(node) {
            Form::One => self.constant(coefficient.constant()),
            Form::Product(factors) if self.is_numeric(factors) => self.product(coefficient, factors),
            Form::Number(number) => self.constant(number.times(&coefficient.constant())),
            _ => {
                let (factor, value) = (self.constant(coefficient.constant()), self.values[&node]);
                self.push(Instruction::Multiply(factor, value))
            }
        }
    }

    /// Whether a product contains a number, or has no factor in its numerator.
    fn is_numeric(&self, factors: &[(Node, Exponent)]) -> bool {
        let is_number = |base: &Node| matches!(self.graph.form(*base), Form::Number(_));
        factors.iter().any(|(base, _)| is_number(base)) || factors.iter().all(|(_, e)| e.is_negative())
    }

    fn node(&mut self, node: Node) -> Value {
        let graph = self.graph;
        match graph.form(node) {
            Form::One => self.constant(Constant::integer(1)),
            Form::Argument(place) => self.push(Instruction::Argument(*place)),
            Form::Number(constant) => self.constant(constant.clone()),
            Form::Call(operation, operands) => {
                let operands: Vec<Value> = operands.iter().map(|&operand| self.scaled(operand)).collect();
                self.push(Instruction::Call(*operation, operands.into()))
            }
            Form::Quadrature(integrand, operands) => {
                let operands = operands.iter().map(|&operand| self.scaled(operand)).collect();
                self.push(Instruction::Quadrature { integrand: integrand.clone(), operands })
            }
            Form::Power(base, exponent) => {
                let base = self.scaled(*base);
                self.push(Instruction::Power(base, *exponent))
            }
            Form::Select(relation, operands) => {
                let [left, right, then, otherwise] = operands.map(|operand| self.scaled(operand));
                self.push(Instruction::Select { left, relation: *relation, right, then, otherwise })
            }
            Form::Sum(terms) => self.sum(terms),
            Form::Product(factors) => self.product(Coefficient::ONE, factors),
        }
    }

    /// Σ cᵢ nᵢ, starting with a positive term if there is one.
    fn sum(&mut self, terms: &[(Coefficient, Node)]) -> Value {
        let first = terms.iter().position(|(c, _)| !c.is_negative());
        let start = first.unwrap_or(0);
        let mut sum = self.multiple(terms[start].0.magnitude(), terms[start].1);
        for (place, &(coefficient, node)) in terms.iter().enumerate() {
            if place == start {
                continue;
            }
            let term = self.multiple(coefficient.magnitude(), node);
            let is_added = coefficient.is_negative() == first.is_none();
            sum = self.push(if is_added {
                Instruction::Add(sum, term)
            } else {
                Instruction::Subtract(sum, term)
            });
        }
        if first.is_none() { self.push(Instruction::Negate(sum)) } else { sum }
    }

    /// c Π nᵢ^eᵢ for c ≥ 0
    fn product(&mut self, coefficient: Coefficient, factors: &[(Node, Exponent)]) -> Value {
        let mut number = coefficient.constant();
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for &(base, exponent) in factors {
            if let (Form::Number(constant), Some(whole)) = (self.graph.form(base), exponent.integer()) {
                let inverted = if whole < 0 { constant.reciprocal() } else { constant.clone() };
                number = (0..whole.abs()).fold(number, |product, _| product.times(&inverted));
                continue;
            }
            let power = self.power(base, exponent.0.abs());
            if exponent.is_negative() { below.push(power) } else { above.push(power) }
        }
        if !number.is_one() || above.is_empty() {
            let number = self.constant(number);
            above.insert(0, number);
        }
        let numerator = self.multiplied(&above).expect("there is a number or a factor above the line");
        match self.multiplied(&below) {
            Some(denominator) => self.push(Instruction::Divide(numerator, denominator)),
            None => numerator,
        }
    }

    fn multiplied(&mut self, values: &[Value]) -> Option<Value> {
        let (&first, rest) = values.split_first()?;
        Some(rest.iter().fold(first, |product, &value| self.push(Instruction::Multiply(product, value))))
    }

    /// Returns a power of a base, from the chain of all its powers.
    fn power(&mut self, base: Node, exponent: i32) -> Value {
        if exponent == Exponent::WHOLE {
            return self.values[&base];
        }
        if !self.chains.contains_key(&base) {
            let chain = self.chain(base);
            self.chains.insert(base, chain);
        }
        self.chains[&base][&exponent]
    }

    /// Computes all powers of a base that occur, counted in the greatest common unit u of the
    /// exponents.
    fn chain(&mut self, base: Node) -> FxHashMap<i32, Value> {
        let value = self.values[&base];
        let mut exponents = self.powers[&base].clone();
        exponents.sort_unstable();
        exponents.dedup();
        let mut chain = FxHashMap::from_iter([(Exponent::WHOLE, value)]);
        let unit = exponents.iter().fold(Exponent::WHOLE, |unit, exponent| unit.gcd(exponent));
        let parts = Exponent::WHOLE / unit;
        let fractions = exponents.iter().filter(|&exponent| exponent % Exponent::WHOLE != 0).count();
        if parts.count_ones() == 1 {
            // √x, √√x, …
            let mut root = (Exponent::WHOLE, value);
            while root.0 > unit {
                root = (root.0 / 2, self.push(Instruction::Sqrt(root.1)));
                chain.insert(root.0, root.1);
            }
        } else if fractions == 1 {
            exponents.retain(|&exponent| {
                let is_whole = exponent % Exponent::WHOLE == 0;
                if !is_whole {
                    let ratio = Ratio::new(i64::from(exponent), i64::from(Exponent::WHOLE));
                    chain.insert(exponent, self.push(Instruction::Power(value, ratio)));
                }
                is_whole
            });
        } else {
            let root = self.push(Instruction::Power(value, Ratio::new(1, i64::from(parts))));
            chain.insert(unit, root);
        }
        let unit = exponents.iter().fold(Exponent::WHOLE, |unit, exponent| unit.gcd(exponent));
        self.multiply_up(&exponents, unit, &mut chain);
        chain
    }

    fn multiply_up(&mut self, exponents: &[i32], unit: i32, chain: &mut FxHashMap<i32, Value>) {
        let mut given: Vec<u32> =
            chain.keys().filter(|&key| key % unit == 0).map(|key| (key / unit) as u32).collect();
        given.sort_unstable();
        let wanted: Vec<u32> = exponents.iter().map(|exponent| (exponent / unit) as u32).collect();
        for (i, j) in addition_chain(&given, &wanted) {
            let [left, right] = [i, j].map(|part| chain[&(part as i32 * unit)]);
            let product = self.push(Instruction::Multiply(left, right));
            chain.insert((i + j) as i32 * unit, product);
        }
    }
}
