//! Point files: reads positions and normals from a table of comma-separated values, with a header
//! `x,y,z` or `x,y,z,nx,ny,nz`. The order of the columns does not matter.

use crate::geometry::Vector;
use crate::scene::SceneError;
use crate::scene::error::Report;
use crate::scene::mesh_file::MeshFiles;
use crate::scene::place::{Place, Source};
use crate::scene::value::values;
use crate::scene::words::{Fault, Word, lines};
use std::ops::Range;
use std::sync::Arc;

const COLUMNS: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];
const HEADER: &str = "a header `x,y,z` or `x,y,z,nx,ny,nz`";
/// Maximum number of errors that are reported for a file.
const MOST_ERRORS: usize = 20;

/// The points of a file.
pub(super) struct PointFile {
    pub(super) positions: Vec<Vector>,
    /// The unit normal of each point, if the file has normals.
    pub(super) normals: Option<Vec<Vector>>,
}

/// Reads the file that a scene names at this place. Points of receivers that `may_face` to one side
/// can have normals.
pub(super) fn read(
    report: &mut Report,
    files: &MeshFiles,
    (place, name): (Range<usize>, &str),
    may_face: bool,
) -> Option<PointFile> {
    let found = match files.find("file", name) {
        Ok(found) => found,
        Err((message, expected)) => {
            report.error(place, message, expected);
            return None;
        }
    };
    let text = String::from_utf8_lossy(&found.bytes);
    let source = Source::new(&files.shown(&found.path), text.trim_start_matches('\u{feff}'));
    let mut faults = Vec::new();
    let table = parsed(&source.text, may_face, &mut faults);
    if faults.is_empty() {
        return table;
    }
    report.include(place.start, errors(&source, faults));
    None
}

/// Converts faults to errors with their places in the file.
fn errors(source: &Arc<Source>, faults: Vec<Fault>) -> Vec<SceneError> {
    let error =
        |fault: Fault| SceneError::new(&Place::new(source, fault.range), fault.message, fault.expected);
    faults.into_iter().take(MOST_ERRORS).map(error).collect()
}

fn parsed(text: &str, may_face: bool, faults: &mut Vec<Fault>) -> Option<PointFile> {
    let mut rows = lines(text, 0).filter(|(_, line)| !line.trim().is_empty());
    let Some((start, head)) = rows.next() else {
        faults.push(Fault::new(0..0, "the file is empty", HEADER));
        return None;
    };
    let columns = match columns(start, head, may_face) {
        Ok(columns) => columns,
        Err(fault) => {
            faults.push(fault);
            return None;
        }
    };
    let has_normals = columns.len() == COLUMNS.len();
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    for (start, line) in rows {
        match point(start, line, &columns) {
            Ok([position, normal]) => {
                positions.push(position);
                normals.push(normal);
            }
            Err(fault) => faults.push(fault),
        }
    }
    if positions.is_empty() && faults.is_empty() {
        faults.push(Fault::new(
            start..start + head.trim_end().len(),
            "the file has no points",
            "a line for each point",
        ));
    }
    Some(PointFile { positions, normals: has_normals.then_some(normals) })
}

/// Returns the fields of a line that starts at this byte.
fn fields(start: usize, line: &str) -> Vec<Word<'_>> {
    let mut begin = start;
    let mut words = Vec::new();
    for field in line.split(',') {
        let (text, own) = (field.trim(), begin + field.len() - field.trim_start().len());
        words.push(Word { text, range: own..own + text.len() });
        begin += field.len() + 1;
    }
    words
}

/// Returns the columns of the file: the index of the coordinate that each holds.
fn columns(start: usize, head: &str, may_face: bool) -> Result<Vec<usize>, Fault> {
    let names = fields(start, head);
    let mut columns = Vec::with_capacity(names.len());
    for name in &names {
        let found = COLUMNS.iter().position(|column| column.eq_ignore_ascii_case(name.text));
        let Some(column) = found else {
            return Err(Fault::new(
                name.range.clone(),
                format!("`{}` is not a column of points", name.text),
                HEADER,
            ));
        };
        if columns.contains(&column) {
            return Err(Fault::new(
                name.range.clone(),
                format!("the column `{}` occurs twice", name.text),
                HEADER,
            ));
        }
        if column >= 3 && !may_face {
            let message = "points that receive light from all sides have no normals";
            return Err(Fault::new(name.range.clone(), message, "a header `x,y,z`"));
        }
        columns.push(column);
    }
    let is_complete = |of: Range<usize>| of.into_iter().all(|column| columns.contains(&column));
    if !is_complete(0..3) || (columns.len() > 3 && !is_complete(3..6)) {
        return Err(Fault::new(start..start + head.trim_end().len(), "columns are missing", HEADER));
    }
    Ok(columns)
}

/// Returns the position and the normal of a line; without columns for it, the normal is zero.
fn point(start: usize, line: &str, columns: &[usize]) -> Result<[Vector; 2], Fault> {
    let fields = fields(start, line);
    let whole = start..start + line.trim_end().len();
    if fields.len() != columns.len() {
        let message = format!("the point has {}", values(fields.len()));
        return Err(Fault::new(whole, message, format!("{}, as in the header", values(columns.len()))));
    }
    let mut numbers = [0.0; 6];
    for (field, &column) in fields.iter().zip(columns) {
        numbers[column] = field.coordinate()?;
    }
    let [x, y, z, nx, ny, nz] = numbers;
    let normal = Vector::new(nx, ny, nz);
    if columns.len() == 3 {
        return Ok([Vector::new(x, y, z), normal]);
    }
    let Some(unit) = normal.unit() else {
        return Err(Fault::new(whole, "the normal has length zero", "a vector with a direction"));
    };
    Ok([Vector::new(x, y, z), unit])
}
