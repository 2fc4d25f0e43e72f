//! Cells: the numbers of all points, faces or pixels of a receiver become its map and its mean.

use super::error_budget::ErrorParts;
use super::error_kind::ErrorKind;
use super::quantity::Quantity;
use super::results::{Answer, Layout, Map};
use crate::scene::{Receiver, ReceiverKind};

/// For each band the values and the errors of all cells, and the scales of their tolerance.
pub(crate) type Numbers = (Vec<Vec<f64>>, Vec<Vec<f64>>, Vec<f64>);

impl Map {
    /// Returns the map of the cells of a receiver, whose layout follows from its kind.
    pub(crate) fn of_cells(
        receiver: &Receiver,
        quantity: Quantity,
        (values, errors, scales): Numbers,
        kind: ErrorKind,
    ) -> Self {
        let layout = match (&receiver.kind, receiver.kind.raster()) {
            (ReceiverKind::Camera(_), _) => Layout::Image,
            (_, Some(_)) => Layout::Grid,
            (_, None) => Layout::List,
        };
        let count = values.first().map_or(0, Vec::len);
        let size = receiver.kind.raster().unwrap_or([count, 1]);
        Self { receiver: receiver.name.clone(), quantity, size, values, errors, scales, kind, layout }
    }
}

/// Returns the mean over the cells of a receiver, in a band. The part `common` of the errors of
/// samples does not average out.
pub(crate) fn mean_of_cells(
    (receiver, quantity, band): (&str, Quantity, Option<usize>),
    cells: &[(f64, ErrorParts)],
    kind: ErrorKind,
    common: f64,
) -> Answer {
    let sum: f64 = cells.iter().map(|(value, _)| value).sum();
    let parts = ErrorParts::of_mean(cells.iter().map(|(_, parts)| *parts), common);
    Answer {
        receiver: receiver.to_owned(),
        quantity,
        band,
        bin: None,
        value: sum / cells.len() as f64,
        error: parts.error(kind),
        parts,
        kind,
        seconds: 0.0,
    }
}
