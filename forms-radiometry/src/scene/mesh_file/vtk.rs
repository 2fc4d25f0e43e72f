//! VTK: reads the triangles, quadrilaterals, polygons and strips of legacy files (.vtk), and of XML
//! files with unstructured grids (.vtu) or polygons (.vtp). Volumes, lines and points are skipped.

mod cell;
mod legacy;

use super::parts::{Parts, told};
use super::words::coordinate;
use super::{Fault, Read};
use crate::geometry::Vector;
use crate::scene::SceneError;
use crate::scene::place::Source;
use crate::scene::xml;
use cell::Cells;
pub(super) use legacy::read as read_legacy;
use vtkio::model::{DataSet, IOBuffer, Piece, PolyDataPiece, UnstructuredGridPiece, VertexNumbers, Vtk};

/// Reads an XML file.
pub(super) fn read_xml(file: &str, bytes: &[u8]) -> Result<Read, Vec<SceneError>> {
    let source = Source::new(file, "");
    let fault = |message: String| {
        told(
            &source,
            vec![Fault::new(0..0, message, "an unstructured grid or polygons, with all data in the file")],
            0,
        )
    };
    let vtk = Vtk::parse_xml(bytes).map_err(|error| {
        not_xml(file, bytes).unwrap_or_else(|| fault(format!("the file is not a VTK file: {error}")))
    })?;
    let mut cells = Cells::default();
    match vtk.data {
        DataSet::UnstructuredGrid { pieces, .. } => loaded(pieces)
            .and_then(|pieces| pieces.into_iter().try_for_each(|piece| add_grid(&mut cells, piece))),
        DataSet::PolyData { pieces, .. } => loaded(pieces)
            .and_then(|pieces| pieces.into_iter().try_for_each(|piece| add_polygons(&mut cells, piece))),
        _ => Err("the file has neither an unstructured grid nor polygons".to_owned()),
    }
    .map_err(fault)?;
    cells.finish(&source)
}

/// Returns the place at which a file that is a text is not valid XML.
fn not_xml(file: &str, bytes: &[u8]) -> Option<Vec<SceneError>> {
    let source = Source::new(file, str::from_utf8(bytes).ok()?);
    let (byte, message) = xml::parsed(&source.text).err()?;
    Some(told(&source, vec![Fault::new(byte..byte, message, "well-formed XML")], 0))
}

/// Returns the pieces of a file. Pieces in other files are refused.
fn loaded<P>(pieces: Vec<Piece<P>>) -> Result<Vec<P>, String> {
    let inline = |piece| match piece {
        Piece::Inline(piece) => Ok(*piece),
        _ => Err("a piece of the mesh is in another file".to_owned()),
    };
    pieces.into_iter().map(inline).collect()
}

fn add_grid(cells: &mut Cells, piece: UnstructuredGridPiece) -> Result<(), String> {
    let first = cells.parts.vertices.len();
    add_points(&mut cells.parts, piece.points)?;
    let kinds = piece.cells.types.iter().map(|&kind| kind as u8);
    let lists = lists(piece.cells.cell_verts)?;
    if kinds.len() != lists.len() {
        return Err(format!("there are {} cells, but {} types of cells", lists.len(), kinds.len()));
    }
    kinds.zip(&lists).try_for_each(|(kind, nodes)| cells.add(kind, nodes, first, 0..0))
}

fn add_polygons(cells: &mut Cells, piece: PolyDataPiece) -> Result<(), String> {
    let first = cells.parts.vertices.len();
    add_points(&mut cells.parts, piece.points)?;
    for (kind, numbers) in [(cell::POLYGON, piece.polys), (cell::STRIP, piece.strips)] {
        for nodes in numbers.map_or(Ok(Vec::new()), lists)? {
            cells.add(kind, &nodes, first, 0..0)?;
        }
    }
    Ok(())
}

fn add_points(parts: &mut Parts, points: IOBuffer) -> Result<(), String> {
    let numbers: Vec<f64> = points.cast_into().ok_or("the points are not numbers")?;
    for (index, point) in numbers.chunks(3).enumerate() {
        let &[x, y, z] = point else {
            return Err("the last point has less than three coordinates".to_owned());
        };
        for number in [x, y, z] {
            coordinate(0..0, number).map_err(|wrong| format!("point {}: {}", index + 1, wrong.message))?;
        }
        parts.vertices.push(Vector::new(x, y, z));
    }
    Ok(())
}

/// Returns the nodes of each cell.
fn lists(numbers: VertexNumbers) -> Result<Vec<Vec<u64>>, String> {
    let (connectivity, offsets) = match numbers {
        VertexNumbers::XML { connectivity, offsets } => (connectivity, offsets),
        VertexNumbers::Legacy { .. } => return Err("the cells have no offsets".to_owned()),
    };
    let mut start = 0;
    let list = |end: u64| {
        let nodes = connectivity.get(start..end as usize).map(<[u64]>::to_vec);
        start = end as usize;
        nodes.ok_or_else(|| format!("an offset of cells is {end}, of {} nodes", connectivity.len()))
    };
    offsets.into_iter().map(list).collect()
}
