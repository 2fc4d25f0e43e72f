//! A formula as a tree, and as the directed acyclic graph in which equal subexpressions are shared.

use crate::flat::at;
use forms_figures::vector::Vector;
use forms_figures::{Colour, Drawing, Pen, View};

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "A formula as a tree and with shared subexpressions",
        "Left, a tree of operations in which the sum of three squares occurs twice; right, the same with one such sum",
        [620, 260],
        View::flat(42.0, [120.0, 285.0]),
    );
    tree(&mut drawing);
    net(&mut drawing);
    drawing.finish()
}

/// Draws a line between two nodes that ends before their labels.
fn edge(drawing: &mut Drawing, from: Vector, to: Vector) {
    let between = |share: f64| at(from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]));
    drawing.line(&[between(0.25), between(0.75)], Pen::solid(Colour::Faint, 1.2));
}

/// Draws a sum of three squares below a node.
fn squares(drawing: &mut Drawing, parent: Vector, sum: Vector, colour: Colour) {
    edge(drawing, parent, sum);
    drawing.label(sum, [0.0, 0.0], "+", colour);
    for (shift, name) in [(-0.95, "u²"), (0.0, "v²"), (0.95, "h²")] {
        let square = at(sum[0] + shift, sum[1] - 1.3);
        edge(drawing, sum, square);
        drawing.label(square, [0.0, 0.0], name, colour);
    }
}

fn tree(drawing: &mut Drawing) {
    let (quotient, h, product) = (at(1.2, 6.3), at(0.0, 5.0), at(2.2, 5.0));
    let (root, first, second) = (at(3.6, 3.7), at(0.5, 2.4), at(3.6, 2.4));
    edge(drawing, quotient, h);
    edge(drawing, quotient, product);
    edge(drawing, product, root);
    squares(drawing, product, first, Colour::Vermilion);
    squares(drawing, root, second, Colour::Vermilion);
    for (place, name) in [(quotient, "/"), (h, "h"), (product, "×"), (root, "√")] {
        drawing.label(place, [0.0, 0.0], name, Colour::Ink);
    }
}

fn net(drawing: &mut Drawing) {
    let (quotient, h, product) = (at(8.4, 6.3), at(7.2, 5.0), at(9.2, 5.0));
    let (root, sum) = (at(10.2, 3.7), at(9.2, 2.4));
    edge(drawing, quotient, h);
    edge(drawing, quotient, product);
    edge(drawing, product, root);
    edge(drawing, root, sum);
    squares(drawing, product, sum, Colour::Blue);
    for (place, name) in [(quotient, "/"), (h, "h"), (product, "×"), (root, "√")] {
        drawing.label(place, [0.0, 0.0], name, Colour::Ink);
    }
}
