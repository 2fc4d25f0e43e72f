//! Shapes of arrays, and the signature of a kernel: the names and shapes of its arguments and the
//! shapes of its results.
//!
//! Expressions and programs know numbers only: an array is the list of its entries by rows, each a
//! number of its own. A signature says which numbers form an array. The entries of an array `p` of
//! three numbers are the arguments `p_0`, `p_1`, `p_2`, those of a matrix `R` `R_0_0`, `R_0_1`, ….

use std::fmt;

/// Shape of a value of numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shape {
    /// One number.
    #[default]
    Number,
    /// Column of this many numbers.
    Vector(usize),
    /// Matrix with these numbers of rows and columns.
    Matrix(usize, usize),
}

impl Shape {
    /// Returns the shape with these extents; `None` for more than two.
    pub fn of(extents: &[usize]) -> Option<Self> {
        match *extents {
            [] => Some(Shape::Number),
            [entries] => Some(Shape::Vector(entries)),
            [rows, columns] => Some(Shape::Matrix(rows, columns)),
            _ => None,
        }
    }

    /// Returns its extents: none for a number, then the number of rows, then of columns.
    pub fn extents(self) -> Vec<usize> {
        match self {
            Shape::Number => vec![],
            Shape::Vector(entries) => vec![entries],
            Shape::Matrix(rows, columns) => vec![rows, columns],
        }
    }

    /// Returns the number of its entries.
    pub fn entries(self) -> usize {
        self.extents().iter().product()
    }

    /// Returns the indices of each entry, by rows.
    pub fn indices(self) -> Vec<Vec<usize>> {
        let extended = |indices: Vec<Vec<usize>>, extent: usize| -> Vec<Vec<usize>> {
            let with = |index: Vec<usize>| (0..extent).map(move |last| [index.clone(), vec![last]].concat());
            indices.into_iter().flat_map(with).collect()
        };
        self.extents().into_iter().fold(vec![vec![]], extended)
    }

    /// Joins the texts of the entries, by rows; `array` joins the texts of the parts of an array.
    pub fn nested(self, entries: &[String], array: impl Fn(&[String]) -> String) -> String {
        match self {
            Shape::Number => entries.concat(),
            Shape::Vector(_) => array(entries),
            Shape::Matrix(_, columns) => {
                let rows: Vec<String> = entries.chunks(columns).map(&array).collect();
                array(&rows)
            }
        }
    }

    /// Joins the texts of the entries of several values, given in one list; returns a text for each
    /// value.
    pub fn split(shapes: &[Shape], entries: &[String], array: impl Fn(&[String]) -> String) -> Vec<String> {
        let mut rest = entries;
        let mut next = |shape: &Shape| {
            let (own, others) = rest.split_at(shape.entries().min(rest.len()));
            rest = others;
            shape.nested(own, &array)
        };
        shapes.iter().map(&mut next).collect()
    }

    /// Returns the names of the entries of an array with this name: `p_0`, `R_1_2`.
    pub fn names(self, name: &str) -> Vec<String> {
        let of = |index: Vec<usize>| index.iter().fold(name.to_owned(), |name, at| format!("{name}_{at}"));
        self.indices().into_iter().map(of).collect()
    }
}

impl fmt::Display for Shape {
    /// Describes the shape: `a number`, `a 3-vector`, `a 2×3 matrix`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Shape::Number => write!(f, "a number"),
            Shape::Vector(entries) => write!(f, "a {entries}-vector"),
            Shape::Matrix(rows, columns) => write!(f, "a {rows}×{columns} matrix"),
        }
    }
}

/// Declared argument of a kernel: a number, or an array whose entries are arguments of its program.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Its shape.
    pub shape: Shape,
}

/// Arguments and results of a kernel as their author declared them.
///
/// ```
/// use forms_core::expression::{Parameter, Shape, Signature};
/// let parameter = |name: &str, shape| Parameter { name: name.to_string(), shape };
/// let signature = Signature {
///     parameters: vec![parameter("p", Shape::Vector(2)), parameter("t", Shape::Number)],
///     results: vec![Shape::Matrix(1, 2)],
/// };
/// assert_eq!(signature.arguments(), ["p_0", "p_1", "t"]);
/// assert_eq!(signature.columns("f"), ["f_0_0", "f_0_1"]);
/// assert_eq!(signature.to_string(), "p[2], t");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Signature {
    /// Its arguments in order.
    pub parameters: Vec<Parameter>,
    /// Shapes of its results in order.
    pub results: Vec<Shape>,
}

impl Signature {
    /// Returns the signature of a kernel of numbers.
    pub fn of_numbers(arguments: &[String], outputs: usize) -> Self {
        let parameter = |name: &String| Parameter { name: name.clone(), shape: Shape::Number };
        Signature {
            parameters: arguments.iter().map(parameter).collect(),
            results: vec![Shape::Number; outputs],
        }
    }

    /// Returns the names of all numbers among the arguments, arrays by their entries.
    pub fn arguments(&self) -> Vec<String> {
        self.parameters.iter().flat_map(|parameter| parameter.shape.names(&parameter.name)).collect()
    }

    /// Returns the number of numbers in the results.
    pub fn outputs(&self) -> usize {
        self.results.iter().map(|shape| shape.entries()).sum()
    }

    /// Returns a name for each number in the results of a kernel with this name: the name itself for
    /// a single number, with the indices of an entry for an array, and with the place of the result
    /// before them if there are several.
    pub fn columns(&self, name: &str) -> Vec<String> {
        match self.results.as_slice() {
            [single] => single.names(name),
            several => {
                let of = |(place, shape): (usize, &Shape)| shape.names(&format!("{name}_{place}"));
                several.iter().enumerate().flat_map(of).collect()
            }
        }
    }

    /// Whether every result is a number.
    pub fn has_numbers_only(&self) -> bool {
        self.results.iter().all(|&shape| shape == Shape::Number)
    }
}

impl fmt::Display for Parameter {
    /// Writes the argument as it is declared: `t`, `R[3, 3]`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Parameter { name, shape } = self;
        match shape {
            Shape::Number => write!(f, "{name}"),
            Shape::Vector(entries) => write!(f, "{name}[{entries}]"),
            Shape::Matrix(rows, columns) => write!(f, "{name}[{rows}, {columns}]"),
        }
    }
}

impl fmt::Display for Signature {
    /// Writes the arguments as they are declared: `p[3], R[3, 3], t`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let declared: Vec<String> = self.parameters.iter().map(Parameter::to_string).collect();
        write!(f, "{}", declared.join(", "))
    }
}
