//! Reference elements: a shape and an order determine nodes, weights, and the polynomials that are
//! one at one node and zero at the others.
//!
//! The nodes are those of Gauss rules, so that the residual of collocation is orthogonal to
//! polynomials: the light that an element sends out is more accurate than the polynomial on it.

use crate::form_factor::gauss;
use std::sync::OnceLock;

/// Maximum number of nodes of an element.
pub(super) const MOST_NODES: usize = 9;

/// The shape of an element in its own coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// 0 ≤ u, 0 ≤ v, u + v ≤ 1.
    Triangle,
    /// 0 ≤ u ≤ 1, 0 ≤ v ≤ 1.
    Square,
}

/// The nodes of a shape and the polynomials that belong to them.
pub(super) struct Reference {
    shape: Shape,
    order: usize,
    /// Positions of the nodes, in the element's coordinates.
    pub(super) nodes: Vec<[f64; 2]>,
    /// The fraction of the element's area that belongs to each node.
    pub(super) weights: Vec<f64>,
    /// For a triangle: row by row the coefficients of each node's polynomial in the monomials.
    coefficients: Vec<Vec<f64>>,
    /// For a square: the Gauss points along a side, and the factors that make their polynomials one
    /// there.
    points: Vec<[f64; 2]>,
}

/// Returns the reference element of a shape with polynomials of degree below this order (1 to 3).
pub(super) fn reference(shape: Shape, order: usize) -> &'static Reference {
    static REFERENCES: [OnceLock<Reference>; 6] = [const { OnceLock::new() }; 6];
    let slot = 2 * (order - 1) + usize::from(shape == Shape::Square);
    REFERENCES[slot].get_or_init(|| match shape {
        Shape::Triangle => triangle(order),
        Shape::Square => square(order),
    })
}

fn square(order: usize) -> Reference {
    let rule = gauss(order);
    let pairs = || rule.iter().flat_map(|&t| rule.iter().map(move |&s| (s, t)));
    Reference {
        shape: Shape::Square,
        order,
        nodes: pairs().map(|(s, t)| [s[0], t[0]]).collect(),
        weights: pairs().map(|(s, t)| s[1] * t[1]).collect(),
        coefficients: Vec::new(),
        points: (0..order).map(|i| [rule[i][0], barycentric(rule, i)]).collect(),
    }
}

/// The leading coefficients of the Legendre polynomials on [0, 1].
const LEADING: [f64; 3] = [1.0, 2.0, 6.0];

/// Returns a Legendre polynomial on [0, 1].
fn legendre(degree: usize, x: f64) -> f64 {
    match degree {
        0 => 1.0,
        1 => 2.0 * x - 1.0,
        _ => 6.0 * x * (x - 1.0) + 1.0,
    }
}

/// Returns the triangle with the rule of 1, 3 or 6 points, exact to degree 1, 2 or 4 (Strang and
/// Fix 1973; Dunavant 1985).
fn triangle(order: usize) -> Reference {
    let orbit = |a: f64| [[a, a], [1.0 - 2.0 * a, a], [a, 1.0 - 2.0 * a]];
    let (nodes, weights) = match order {
        1 => (vec![[1.0 / 3.0; 2]], vec![1.0]),
        2 => (orbit(1.0 / 6.0).to_vec(), vec![1.0 / 3.0; 3]),
        _ => {
            // a = (8 − √10 ± √(38 − 44√(2/5)))/18, and the weights that make degree 4 exact
            let (middle, root) = (8.0 - 10_f64.sqrt(), (38.0 - 44.0 * 0.4_f64.sqrt()).sqrt());
            let [a, b] = [(middle + root) / 18.0, (middle - root) / 18.0];
            let spread = (213_125.0 - 53_320.0 * 10_f64.sqrt()).sqrt();
            let [of_a, of_b] = [(620.0 + spread) / 3720.0, (620.0 - spread) / 3720.0];
            ([orbit(a), orbit(b)].concat(), [[of_a; 3], [of_b; 3]].concat())
        }
    };
    let rows: Vec<Vec<f64>> = nodes.iter().map(|&[u, v]| monomials(u, v)[..nodes.len()].to_vec()).collect();
    Reference {
        shape: Shape::Triangle,
        order,
        coefficients: inverse(rows),
        points: Vec::new(),
        nodes,
        weights,
    }
}

/// Returns 1, u, v, u², uv, v².
fn monomials(u: f64, v: f64) -> [f64; 6] {
    [1.0, u, v, u * u, u * v, v * v]
}

/// Returns the inverse of a small regular matrix, transposed, by elimination with pivots.
fn inverse(mut rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let count = rows.len();
    for (i, row) in rows.iter_mut().enumerate() {
        row.extend((0..count).map(|j| f64::from(u8::from(i == j))));
    }
    for column in 0..count {
        let size = |row: &usize| rows[*row][column].abs();
        let pivot = (column..count).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(column);
        rows.swap(column, pivot);
        let of_pivot = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[column] / of_pivot[column];
            for (value, &other) in row.iter_mut().zip(&of_pivot) {
                *value = if i == column { other / of_pivot[column] } else { *value - factor * other };
            }
        }
    }
    (0..count).map(|node| rows.iter().map(|row| row[count + node]).collect()).collect()
}

impl Reference {
    /// Returns the values of all nodes' polynomials at a point.
    pub(super) fn basis(&self, [u, v]: [f64; 2]) -> [f64; MOST_NODES] {
        let mut values = [0.0; MOST_NODES];
        match self.shape {
            Shape::Triangle => {
                let powers = monomials(u, v);
                for (value, coefficients) in values.iter_mut().zip(&self.coefficients) {
                    *value = coefficients.iter().zip(powers).map(|(c, power)| c * power).sum();
                }
            }
            Shape::Square => {
                let [along, across] = [self.lagrange(u), self.lagrange(v)];
                for (node, value) in values.iter_mut().enumerate().take(self.nodes.len()) {
                    *value = along[node % self.order] * across[node / self.order];
                }
            }
        }
        values
    }

    /// Returns the sizes of the terms of highest degree, and of one degree less, in the polynomial
    /// with these values at the nodes. For a square they are Legendre terms on its side, in each
    /// coordinate. For a triangle the terms of all directions together come first, followed by
    /// zeros. For a constant, both sizes are that of the constant.
    pub(super) fn highest(&self, values: &[f64]) -> [[f64; 2]; 2] {
        match self.shape {
            Shape::Triangle => {
                let of_degree = |degree: usize| {
                    let first = degree * (degree + 1) / 2;
                    let term = |power: usize| {
                        let of_nodes = values.iter().zip(&self.coefficients);
                        of_nodes.map(|(value, of_node)| value * of_node[power]).sum()
                    };
                    (first..=first + degree).map(|power| f64::abs(term(power))).sum::<f64>() / LEADING[degree]
                };
                let highest = self.order - 1;
                [[of_degree(highest), of_degree(highest.saturating_sub(1))], [0.0; 2]]
            }
            Shape::Square => {
                let n = self.order;
                let mean = |of: &dyn Fn(usize) -> [f64; 2]| {
                    let sum = (0..n).map(of).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
                    sum.map(|sum| sum / n as f64)
                };
                [
                    mean(&|j| self.highest_along(|i| values[j * n + i])),
                    mean(&|i| self.highest_along(|j| values[j * n + i])),
                ]
            }
        }
    }

    /// Returns the sizes of the two highest Legendre terms of a polynomial with these values at the
    /// Gauss points of a side.
    fn highest_along(&self, value: impl Fn(usize) -> f64) -> [f64; 2] {
        let term = |degree: usize| {
            let rule = gauss(self.order);
            let moment: f64 =
                rule.iter().enumerate().map(|(i, &[x, w])| w * value(i) * legendre(degree, x)).sum();
            (2.0 * degree as f64 + 1.0) * moment.abs()
        };
        let highest = self.order - 1;
        [term(highest), term(highest.saturating_sub(1))]
    }

    /// Returns the Lagrange polynomials on the Gauss points of [0, 1]: ∏ (x − xⱼ)/(xᵢ − xⱼ) over
    /// j ≠ i.
    fn lagrange(&self, x: f64) -> [f64; 3] {
        let mut values = [0.0; 3];
        for (i, &[_, scale]) in self.points.iter().enumerate() {
            values[i] = scale;
            for (j, &[other, _]) in self.points.iter().enumerate() {
                if i != j {
                    values[i] *= x - other;
                }
            }
        }
        values
    }
}

/// Returns 1/∏ (xᵢ − xⱼ) over j ≠ i.
fn barycentric(rule: &[[f64; 2]], i: usize) -> f64 {
    let others = rule.iter().enumerate().filter(|(j, _)| *j != i);
    1.0 / others.map(|(_, other)| rule[i][0] - other[0]).product::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [(Shape, usize); 6] = [
        (Shape::Triangle, 1),
        (Shape::Triangle, 2),
        (Shape::Triangle, 3),
        (Shape::Square, 1),
        (Shape::Square, 2),
        (Shape::Square, 3),
    ];

    #[test]
    fn each_polynomial_is_one_at_its_node_and_zero_at_the_others() {
        for (shape, order) in ALL {
            let element = reference(shape, order);
            for (i, &node) in element.nodes.iter().enumerate() {
                let values = element.basis(node);
                for (j, value) in values.iter().enumerate() {
                    let expected = f64::from(u8::from(i == j));
                    assert!((value - expected).abs() < 1e-13, "{shape:?} {order}: {i} {j} {value}");
                }
            }
        }
    }

    #[test]
    fn the_rules_are_exact_to_their_degrees() {
        // ∫ uᵃ vᵇ over the triangle, divided by its area, is 2 a! b!/(a + b + 2)!;
        // over the square it is 1/((a + 1)(b + 1))
        let factorial = |n: usize| (1..=n).product::<usize>() as f64;
        for (shape, order) in ALL {
            let element = reference(shape, order);
            let degree = if shape == Shape::Triangle { [1, 2, 4][order - 1] } else { 2 * order - 1 };
            for a in 0..=degree {
                for b in 0..=(degree - a) {
                    let expected = match shape {
                        Shape::Triangle => 2.0 * factorial(a) * factorial(b) / factorial(a + b + 2),
                        Shape::Square => 1.0 / ((a + 1) * (b + 1)) as f64,
                    };
                    let value = |[u, v]: [f64; 2]| u.powi(a as i32) * v.powi(b as i32);
                    let found: f64 =
                        element.nodes.iter().zip(&element.weights).map(|(&node, w)| w * value(node)).sum();
                    assert!((found - expected).abs() < 1e-14, "{shape:?} {order}: u^{a} v^{b} {found}");
                }
            }
        }
    }

    #[test]
    fn the_highest_terms_are_those_of_legendre_polynomials() {
        let square = reference(Shape::Square, 3);
        let of = |f: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
            square.nodes.iter().map(|&[u, v]| f(u, v)).collect()
        };
        // u² = P₂/6 + P₁/2 + 1/3 on [0, 1]
        for (name, values, expected) in [
            ("1", of(&|_, _| 1.0), [[0.0, 0.0], [0.0, 0.0]]),
            ("u", of(&|u, _| u), [[0.0, 0.5], [0.0, 0.0]]),
            ("v²", of(&|_, v| v * v), [[0.0, 0.0], [1.0 / 6.0, 0.5]]),
            ("u² + v", of(&|u, v| u * u + v), [[1.0 / 6.0, 0.5], [0.0, 0.5]]),
        ] {
            let found = square.highest(&values);
            let off = found.iter().flatten().zip(expected.iter().flatten()).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-14, "{name}: {found:?}");
        }
        let triangle = reference(Shape::Triangle, 3);
        let values: Vec<f64> = triangle.nodes.iter().map(|&[u, v]| 6.0 * u * v + 2.0 * v).collect();
        let [[highest, lower], _] = triangle.highest(&values);
        assert!((highest - 1.0).abs() < 1e-13 && (lower - 1.0).abs() < 1e-13, "{highest} {lower}");
    }
}
