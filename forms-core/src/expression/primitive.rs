//! Primitives: integrals of products of unknown functions, represented as unknown functions of
//! their upper limits.
//!
//! ```text
//! Φ(b₁ … bₘ; q₁ … qₖ) = ∫₀^b₁ … ∫₀^bₘ f₁(…) f₂(…) … e ds₁ … dsₘ      each argument of an fᵢ is one sⱼ or one qⱼ
//! ```
//! An integrand f₁f₂…e is a product of jets and one remaining factor e: elementary expressions, and
//! jets at arguments that are composed of integration variables. Every argument of a jet that is
//! not an integration variable becomes a parameter of its own, whatever expression it is. Φ is
//! therefore recognised at other arguments, its derivative with respect to a parameter is the
//! derivative of one jet and is written as an order of Φ, and integrals taken in another order are
//! the same function. ∂Φ/∂bⱼ is the primitive without sⱼ: no order of Φ in an upper limit is above
//! zero.
//!
//! The lower limit 0 stands for an arbitrary point where 0 is outside the integrand's domain:
//! definite integrals are differences and do not depend on the integrand outside their ranges.

use super::integral_table::{Place, Primitive};
use super::node::{Expr, FunctionId, Node, Symbol, SymbolKind};
use super::pool::Pool;
use super::substitution::Substitution;

impl Pool {
    /// Whether a function is a primitive.
    pub(crate) fn is_primitive(&self, function: FunctionId) -> bool {
        self.primitives.integrands.contains_key(&function)
    }

    /// Returns how many of a function's leading arguments are upper limits of integration: where
    /// any of these limits is 0, the function is 0.
    pub(crate) fn upper_ends(&self, function: FunctionId) -> usize {
        self.primitives.integrands.get(&function).map_or(0, |primitive| primitive.integrated)
    }

    /// Integrates a product that contains unknown functions of a variable with respect to that
    /// variable, up to that variable.
    pub(crate) fn primitive(&mut self, product: Expr, variable: Symbol) -> Expr {
        let at = self.symbol(variable);
        self.primitive_over(product, vec![(variable, at)])
    }

    /// Returns the integrand of a primitive at these arguments and its integration variables. The
    /// variables are fresh, one for each of the upper limits, which are the first arguments.
    pub(crate) fn primitive_integrand_at(
        &mut self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Expr],
    ) -> Option<(Expr, Vec<Symbol>)> {
        let primitive = self.primitives.integrands.get(&function)?.clone();
        let count = primitive.integrated;
        let variables: Vec<Symbol> =
            (1..=count).map(|number| self.declare_symbol(format!("s{number}"), SymbolKind::Local)).collect();
        let ends: Vec<Expr> = variables.iter().map(|&variable| self.symbol(variable)).collect();
        let places: Vec<Expr> = ends.iter().chain(&arguments[count..]).copied().collect();
        Some((self.value_of_integrand(&primitive, orders, &places), variables))
    }

    /// Rewrites a derivative of a primitive with respect to its upper limits, or to the parameters
    /// of its integrand outside the jets, as primitives without such orders. `None` if there is no
    /// such order.
    pub(super) fn lowered(
        &mut self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Expr],
    ) -> Option<Expr> {
        let primitive = self.primitives.integrands.get(&function)?.clone();
        let end = orders[..primitive.integrated].iter().position(|&order| order > 0);
        if end.is_none() && orders[primitive.first_beside_jets()..].iter().all(|&order| order == 0) {
            return None;
        }
        let formal: Vec<Expr> = (0..arguments.len())
            .map(|number| {
                let symbol = self.formal(&primitive, number);
                self.symbol(symbol)
            })
            .collect();
        let inner: Vec<Symbol> =
            (0..primitive.integrated).map(|number| self.inner_variable(number)).collect();
        let mut places = formal.clone();
        let mut integrated = Vec::new();
        for number in (0..primitive.integrated).filter(|&number| Some(number) != end) {
            places[number] = self.symbol(inner[number]);
            integrated.push((inner[number], formal[number]));
        }
        let product = self.value_of_integrand(&primitive, orders, &places);
        let mut value =
            if integrated.is_empty() { product } else { self.primitive_over(product, integrated) };
        for (number, &order) in orders[..primitive.integrated].iter().enumerate() {
            let by = self.formal(&primitive, number);
            for _ in 0..order - u32::from(Some(number) == end) {
                value = self.derivative(value, by);
            }
        }
        let values: Substitution =
            (0..arguments.len()).map(|number| (self.formal(&primitive, number), arguments[number])).collect();
        Some(self.substitute(value, &values))
    }

    /// Returns a primitive with the parameters of equal factors sorted, or `None` if they are
    /// sorted already. Exchanging equal factors does not change the value.
    pub(super) fn in_order(&self, function: FunctionId, orders: &[u32], arguments: &[Expr]) -> Option<Node> {
        let primitive = self.primitives.integrands.get(&function)?;
        let (mut orders, mut arguments) = (orders.to_vec(), arguments.to_vec());
        let (mut first, mut changed) = (primitive.integrated, false);
        for alike in primitive.factors.chunk_by(|a, b| a == b) {
            let width = alike[0].places.iter().filter(|place| **place == Place::Parameter).count();
            let block = |number: usize| first + number * width..first + (number + 1) * width;
            let mut blocks: Vec<Vec<(Expr, u32)>> = (0..alike.len())
                .map(|number| block(number).map(|place| (arguments[place], orders[place])).collect())
                .collect();
            if !blocks.is_sorted() {
                changed = true;
                blocks.sort();
                for (place, (argument, order)) in (first..).zip(blocks.concat()) {
                    (arguments[place], orders[place]) = (argument, order);
                }
            }
            first += alike.len() * width;
        }
        changed.then(|| Node::Jet { function, orders: orders.into(), arguments: arguments.into() })
    }

    /// Returns the formal argument with this number.
    fn formal(&mut self, primitive: &Primitive, number: usize) -> Symbol {
        match number.checked_sub(primitive.integrated) {
            None => self.formal_variable(number),
            Some(parameter) => self.formal_parameter(parameter),
        }
    }

    pub(super) fn formal_variable(&mut self, number: usize) -> Symbol {
        while self.primitives.integrated.len() <= number {
            let name = format!("s{}", self.primitives.integrated.len() + 1);
            let symbol = self.declare_symbol(name, SymbolKind::Local);
            self.primitives.integrated.push(symbol);
        }
        self.primitives.integrated[number]
    }

    /// Returns the formal variable for a limit of a quadrature.
    pub(super) fn formal_end(&mut self, number: usize) -> Symbol {
        while self.primitives.ends.len() <= number {
            let symbol = self.declare_symbol(["a", "b"][self.primitives.ends.len() % 2], SymbolKind::Local);
            self.primitives.ends.push(symbol);
        }
        self.primitives.ends[number]
    }

    pub(super) fn formal_parameter(&mut self, number: usize) -> Symbol {
        while self.primitives.parameters.len() <= number {
            let name = format!("q{}", self.primitives.parameters.len() + 1);
            let symbol = self.declare_symbol(name, SymbolKind::Local);
            self.primitives.parameters.push(symbol);
        }
        self.primitives.parameters[number]
    }

    pub(super) fn inner_variable(&mut self, number: usize) -> Symbol {
        while self.primitives.inner.len() <= number {
            let name = format!("s{}", self.primitives.inner.len() + 1);
            let symbol = self.declare_symbol(name, SymbolKind::Local);
            self.primitives.inner.push(symbol);
        }
        self.primitives.inner[number]
    }

    /// Returns the integrand at these arguments, differentiated with respect to its parameters by the
    /// orders that follow those of the upper limits.
    pub(super) fn value_of_integrand(
        &mut self,
        primitive: &Primitive,
        orders: &[u32],
        places: &[Expr],
    ) -> Expr {
        let mut next = primitive.integrated;
        let mut product = self.integer(1);
        for factor in &primitive.factors {
            let (mut own, mut arguments) = (Vec::new(), Vec::new());
            for place in &factor.places {
                let (number, order) = match *place {
                    Place::Integrated(number, order) => (number, order),
                    Place::Parameter => {
                        next += 1;
                        (next - 1, orders[next - 1])
                    }
                };
                own.push(order);
                arguments.push(places[number]);
            }
            let jet = self.jet(factor.function, &own, &arguments);
            product = self.multiply(product, jet);
        }
        let mut elementary = primitive.elementary;
        for (number, &order) in orders.iter().enumerate().skip(next) {
            let by = self.formal(primitive, number);
            for _ in 0..order {
                elementary = self.derivative(elementary, by);
            }
        }
        let values: Substitution =
            (0..places.len()).map(|number| (self.formal(primitive, number), places[number])).collect();
        let elementary = self.substitute(elementary, &values);
        self.multiply(product, elementary)
    }

    pub(super) fn function_of_primitive(&mut self, primitive: Primitive) -> FunctionId {
        if let Some(&known) = self.primitives.functions.get(&primitive) {
            return known;
        }
        let count = primitive.integrated + primitive.parameters;
        let arguments: Vec<Symbol> = (0..count).map(|number| self.formal(&primitive, number)).collect();
        let function = self.declare_function("integral", arguments);
        self.primitives.functions.insert(primitive.clone(), function);
        self.primitives.integrands.insert(function, primitive);
        function
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Creates a pool with variables x, y, s and functions k(x, s), f(s).
    fn scene() -> (Pool, [Symbol; 3], [FunctionId; 2]) {
        let mut pool = Pool::new();
        let symbols = ["x", "y", "s"].map(|name| pool.declare_symbol(name, SymbolKind::Coordinate));
        let k = pool.declare_function("k", vec![symbols[0], symbols[2]]);
        let f = pool.declare_function("f", vec![symbols[2]]);
        (pool, symbols, [k, f])
    }

    fn k_times_f(pool: &mut Pool, first: Symbol, second: Symbol, [k, f]: [FunctionId; 2]) -> Expr {
        let (x, s) = (pool.symbol(first), pool.symbol(second));
        let (k, f) = (pool.jet(k, &[0, 0], &[x, s]), pool.jet(f, &[0], &[s]));
        pool.multiply(k, f)
    }

    #[test]
    fn the_derivative_of_a_primitive_is_what_it_integrates() {
        let (mut pool, [x, _, s], functions) = scene();
        let product = k_times_f(&mut pool, x, s, functions);
        let primitive = pool.primitive(product, s);
        assert_ne!(primitive, product);
        assert_eq!(pool.derivative(primitive, s), product);
    }

    #[test]
    fn an_integral_over_nothing_is_nothing() {
        let (mut pool, [x, _, s], functions) = scene();
        let product = k_times_f(&mut pool, x, s, functions);
        let primitive = pool.primitive(product, s);
        let (zero, one) = (pool.integer(0), pool.integer(1));
        let at_zero: Substitution = [(s, zero)].into_iter().collect();
        let at_one: Substitution = [(s, one)].into_iter().collect();
        assert_eq!(pool.substitute(primitive, &at_zero), zero);
        assert_ne!(pool.substitute(primitive, &at_one), zero);
    }

    #[test]
    fn names_of_variables_do_not_matter() {
        let (mut pool, [x, y, s], functions) = scene();
        let over_s = k_times_f(&mut pool, x, s, functions);
        let over_y = k_times_f(&mut pool, x, y, functions);
        let (over_s, over_y) = (pool.primitive(over_s, s), pool.primitive(over_y, y));
        let renamed: Substitution = [(y, pool.symbol(s))].into_iter().collect();
        assert_eq!(pool.substitute(over_y, &renamed), over_s);
    }

    #[test]
    fn derivatives_by_parameters_are_taken_under_the_integral() {
        let (mut pool, [x, _, s], functions) = scene();
        let product = k_times_f(&mut pool, x, s, functions);
        let inside = pool.derivative(product, x);
        let (inside, outside) = (pool.primitive(inside, s), pool.primitive(product, s));
        assert_eq!(pool.derivative(outside, x), inside);
    }

    #[test]
    fn the_order_of_integration_does_not_matter() {
        let (mut pool, [x, _, s], functions) = scene();
        let product = k_times_f(&mut pool, x, s, functions);
        let (by_s, by_x) = (pool.primitive(product, s), pool.primitive(product, x));
        let (s_then_x, x_then_s) = (pool.primitive(by_s, x), pool.primitive(by_x, s));
        assert_eq!(pool.derivative(s_then_x, x), by_s);
        assert_eq!(s_then_x, x_then_s);
    }
}
