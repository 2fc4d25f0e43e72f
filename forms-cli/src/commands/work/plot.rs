//! Task `plot`: the values of one kernel of a text over one or two of its arguments, as a drawing.

use super::Refusal;
use super::record::{read, tell};
use crate::json::write_record;
use crate::kernel::{find, generated};
use forms::core::generation::Generated;
use forms_figures::{self as figures, ColourScale, HeatMap, Plot as Curve, Series};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Number of cells of a map: columns and rows.
const CELLS: [usize; 2] = [112, 84];
/// Number of points of a curve.
const POINTS: usize = 512;

#[derive(Deserialize)]
pub(super) struct Request {
    text: String,
    /// Name of a kernel.
    kernel: String,
    /// Index of the plotted value, from 0.
    #[serde(default)]
    output: usize,
    across: Axis,
    /// Vertical axis; `None` for a curve.
    up: Option<Axis>,
    /// Values of all other arguments.
    #[serde(default)]
    fixed: BTreeMap<String, f64>,
}

/// Argument with the range over which it is plotted.
#[derive(Deserialize)]
struct Axis {
    name: String,
    from: f64,
    to: f64,
}

impl Axis {
    /// Returns the value at a fraction of the range.
    fn at(&self, share: f64) -> f64 {
        self.from * (1.0 - share) + self.to * share
    }

    /// Returns the axis of the figure.
    fn drawn(&self) -> figures::Axis {
        figures::Axis::linear(&self.name).over([self.from, self.to])
    }
}

#[derive(Serialize)]
struct Plot {
    drawing: DrawingRecord,
}

#[derive(Serialize)]
struct DrawingRecord {
    svg: String,
    least: Option<f64>,
    greatest: Option<f64>,
    /// Number of NaN values, and number of all values.
    undefined: usize,
    values: usize,
}

/// Writes the drawing, or the errors of the kernel or of the request.
pub(super) fn plot(request: &Request, output: &mut dyn Write) -> io::Result<()> {
    let Some((_, file)) = read(&request.text, output)? else { return Ok(()) };
    let files = [file];
    let (file, kernel) = match find(&files, &request.kernel) {
        Ok(found) => found,
        Err(refusal) => return write_record(output, &Refusal { refusal }),
    };
    let generated = match generated(file, kernel) {
        Ok(generated) => generated,
        Err(errors) => return tell(&errors, output),
    };
    match request.drawing(&generated) {
        Ok(drawing) => write_record(output, &Plot { drawing }),
        Err(refusal) => write_record(output, &Refusal { refusal }),
    }
}

impl Request {
    fn drawing(&self, generated: &Generated) -> Result<DrawingRecord, String> {
        let Request { across, up, .. } = self;
        let values = self.values(generated)?;
        let scale = ColourScale::of(&values);
        let (title, note) = (self.title(generated), self.note());
        let svg = match up {
            None => curve(title, note, across, &values),
            Some(up) => {
                let (x, y) = (across.drawn(), up.drawn());
                HeatMap { title: &title, note: &note, x, y, values: &values, columns: CELLS[0] }.svg()
            }
        };
        let undefined = values.iter().filter(|value| value.is_nan()).count();
        let [least, greatest] = scale.map_or([None; 2], |scale| scale.ends.map(Some));
        Ok(DrawingRecord { svg, least, greatest, undefined, values: values.len() })
    }

    /// Computes the values at the centres of the cells, row by row from the lower end, or at the
    /// points of a curve.
    fn values(&self, generated: &Generated) -> Result<Vec<f64>, String> {
        let mut arguments = self.arguments(generated)?;
        let place = |axis: &Axis| generated.optimised.arguments().iter().position(|name| *name == axis.name);
        let across = place(&self.across).ok_or_else(|| self.unknown(&self.across))?;
        let mut value = kernel_of(generated, self.output);
        let Some(up) = &self.up else {
            let at = |index| self.across.at(index as f64 / (POINTS - 1) as f64);
            let mut at_point = |index| {
                arguments[across] = at(index);
                value(&arguments)
            };
            return Ok((0..POINTS).map(&mut at_point).collect());
        };
        let upwards = place(up).ok_or_else(|| self.unknown(up))?;
        let [columns, rows] = CELLS;
        let middle = |index: usize, count: usize| (index as f64 + 0.5) / count as f64;
        let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        Ok(cells
            .map(|(column, row)| {
                arguments[across] = self.across.at(middle(column, columns));
                arguments[upwards] = up.at(middle(row, rows));
                value(&arguments)
            })
            .collect())
    }

    /// Checks the ranges and names of the request, and returns the values of the fixed arguments at
    /// their indices.
    fn arguments(&self, generated: &Generated) -> Result<Vec<f64>, String> {
        let outputs = generated.optimised.outputs().len();
        if self.output >= outputs {
            return Err(format!(
                "`{}` has values 0 to {}; there is no value {}",
                self.kernel,
                outputs - 1,
                self.output
            ));
        }
        let axes = || [Some(&self.across), self.up.as_ref()].into_iter().flatten();
        for axis in axes() {
            if !(axis.from < axis.to && (axis.to - axis.from).is_finite()) {
                return Err(format!(
                    "the range of `{}` must go from a smaller number to a larger one",
                    axis.name
                ));
            }
        }
        if self.up.as_ref().is_some_and(|up| up.name == self.across.name) {
            return Err("the two axes must be different arguments".to_owned());
        }
        let argument = |name: &String| {
            let drawn = axes().find(|axis| axis.name == *name).map(|axis| axis.from);
            let known = drawn.or_else(|| self.fixed.get(name).copied());
            known.ok_or_else(|| format!("`{name}` needs a value"))
        };
        generated.optimised.arguments().iter().map(argument).collect()
    }

    fn unknown(&self, axis: &Axis) -> String {
        format!("`{}` is not an argument of `{}`", axis.name, self.kernel)
    }

    /// Returns the title `density(u, v)`, with the index of the value if there are several.
    fn title(&self, generated: &Generated) -> String {
        let arguments = generated.optimised.arguments().join(", ");
        let several = generated.optimised.outputs().len() > 1;
        let which = if several { format!(", value {}", self.output) } else { String::new() };
        format!("{}({arguments}){which}", self.kernel)
    }

    /// Returns the note `at r = 1, s = 2`.
    fn note(&self) -> String {
        let drawn = |name: &str| {
            [Some(&self.across), self.up.as_ref()].into_iter().flatten().any(|axis| axis.name == name)
        };
        let fixed = self.fixed.iter().filter(|(name, _)| !drawn(name));
        let fixed: Vec<String> = fixed.map(|(name, value)| format!("{name} = {value}")).collect();
        if fixed.is_empty() { String::new() } else { format!("at {}", fixed.join(", ")) }
    }
}

/// Draws the curve through values at equal steps of an argument, with gaps where it is undefined.
fn curve(title: String, note: String, across: &Axis, values: &[f64]) -> String {
    let last = values.len().max(2) as f64 - 1.0;
    let at = |(index, &value): (usize, &f64)| [across.at(index as f64 / last), value];
    let curve = Curve {
        title,
        description: format!("The values over {}.", across.name),
        note,
        x: across.drawn(),
        y: figures::Axis::linear("value"),
        series: vec![Series::curve("", values.iter().enumerate().map(at).collect())],
        missing: "not defined".to_owned(),
        ..Curve::default()
    };
    curve.svg()
}

/// Function from the arguments of a kernel to one number.
type Value<'a> = Box<dyn FnMut(&[f64]) -> f64 + 'a>;

/// Returns a function for one value of a kernel, as generated, in double precision.
fn kernel_of(generated: &Generated, output: usize) -> Value<'_> {
    let program = &generated.optimised;
    match generated.within() {
        Some(within) => Box::new(move |arguments| program.interpret_within(arguments, within)[output]),
        None => {
            let interpreter = program.interpreter::<f64>();
            Box::new(move |arguments| interpreter.values(arguments)[output])
        }
    }
}
