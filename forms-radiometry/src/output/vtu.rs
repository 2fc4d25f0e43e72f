//! VTK output: results on the geometry of their receivers, and the surfaces of a scene, become
//! unstructured grids in XML, for ParaView. Coordinates are in the unit of the scene.
//!
//! ```text
//! faces   ─▶ polygons, with the results of the face    map of a surface ─▶ quadrilaterals
//! points  ─▶ vertices                                  scene ─▶ polygons, with optical data
//! ```
//! Numbers are in binary form, so that they are read back unchanged.

use crate::answer::{Answer, Map, Simulation};
use crate::faces::faces;
use crate::geometry::{BoundingRectangle, Polygon, Vector};
use crate::scene::{Receiver, ReceiverKind, Scene, Shape, Surface};
use std::io;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};

/// Fineness of the polygons that represent disks and spheres.
const FINENESS: usize = 2;

/// Cells with columns of numbers.
struct Grid {
    kind: CellType,
    points: Vec<Vector>,
    /// Number of points of each cell; the cells follow each other and share no points.
    counts: Vec<usize>,
    columns: Vec<(String, Vec<f64>)>,
}

/// Encodes the results of a receiver on its geometry; `None` for rays, for images, and for the mean
/// of a surface.
///
/// A cell has the values and the errors of each quantity in each band. A cell of a map that lies off
/// its surface is left out; one that was not reached holds NaN.
pub fn vtu(scene: &Scene, receiver: &Receiver, found: &Simulation) -> Option<io::Result<Vec<u8>>> {
    let maps: Vec<&Map> = found.maps.iter().filter(|map| map.receiver == receiver.name).collect();
    let grid = match &receiver.kind {
        ReceiverKind::Point { .. } | ReceiverKind::Sphere { .. } => {
            let answers = found.answers.iter().filter(|answer| answer.receiver == receiver.name);
            Grid::of_points(receiver, answers.flat_map(columns_of_answer).collect())
        }
        ReceiverKind::Points(_) => Grid::of_points(receiver, columns(&maps, None)),
        ReceiverKind::Faces { surface, .. } => Grid::of_faces(&scene.surfaces[*surface].shape, &maps),
        ReceiverKind::Surface { surface, grid: Some(size), .. } => {
            Grid::of_map(scene, *surface, *size, maps.first()?)?
        }
        ReceiverKind::Surface { .. } | ReceiverKind::Ray { .. } | ReceiverKind::Camera(_) => return None,
    };
    Some(grid.encoded(&receiver.name))
}

/// Encodes the surfaces of a scene: each polygon has the index of its surface, from 0 in the order of
/// the file, and the exitance and the reflectance of its front in each band; a surface whose
/// reflectance depends on the direction of light has the reflectance NaN.
pub fn scene_vtu(scene: &Scene) -> io::Result<Vec<u8>> {
    let (mut points, mut counts, mut surfaces) = (Vec::new(), Vec::new(), Vec::new());
    for face in faces(scene, FINENESS).into_iter().filter(|face| !face.is_back) {
        counts.push(face.vertices.len());
        points.extend(face.vertices);
        surfaces.push(face.surface);
    }
    let column = |name: String, of: &dyn Fn(&Surface) -> f64| {
        (name, surfaces.iter().map(|&surface| of(&scene.surfaces[surface])).collect())
    };
    let reflectance = |surface: &Surface, band: usize| {
        let known = surface.texture.is_none().then_some(&scene.materials[surface.material].kind);
        known.and_then(|kind| kind.reflectance_in(band)).unwrap_or(f64::NAN)
    };
    let mut columns = vec![("surface".to_owned(), surfaces.iter().map(|&surface| surface as f64).collect())];
    for band in 0..scene.band_count() {
        let name = |what: &str| named(what, "", (scene.band_count() > 1).then_some(band));
        columns.push(column(name("exitance"), &|surface| surface.exitance_in(band)));
        columns.push(column(name("reflectance"), &|surface| reflectance(surface, band)));
    }
    Grid { kind: CellType::Polygon, points, counts, columns }.encoded(&scene.name)
}

impl Grid {
    fn of_points(receiver: &Receiver, columns: Vec<(String, Vec<f64>)>) -> Self {
        let points: Vec<Vector> = receiver.kind.points().map(|(position, _)| position).collect();
        Self { kind: CellType::Vertex, counts: vec![1; points.len()], points, columns }
    }

    /// Returns the faces of a polygon or a mesh. A face with holes is several convex polygons.
    fn of_faces(shape: &Shape, maps: &[&Map]) -> Self {
        let polygons: Vec<Polygon> = match shape {
            Shape::Polygon(polygon) => vec![polygon.clone()],
            Shape::Mesh(mesh) => mesh.polygons().collect(),
            _ => Vec::new(),
        };
        let (mut points, mut counts, mut cells) = (Vec::new(), Vec::new(), Vec::new());
        for (face, polygon) in polygons.iter().enumerate() {
            let is_whole = polygon.holes().is_empty() && polygon.round_holes().is_empty();
            let whole = [polygon.vertices().to_vec()];
            for outline in if is_whole { &whole[..] } else { polygon.convex_pieces() } {
                points.extend_from_slice(outline);
                counts.push(outline.len());
                cells.push(face);
            }
        }
        let mut columns = columns(maps, Some(&cells));
        columns.push(("face".to_owned(), cells.iter().map(|&face| face as f64).collect()));
        Self { kind: CellType::Polygon, points, counts, columns }
    }

    /// Returns the cells of a map that have a value.
    fn of_map(scene: &Scene, surface: usize, size: [usize; 2], map: &Map) -> Option<Self> {
        let (outline, normal) = match &scene.surfaces[surface].shape {
            Shape::Polygon(polygon) => (polygon.vertices().to_vec(), polygon.normal()),
            Shape::Disk(disk) => (disk.polygon(FINENESS), disk.normal),
            _ => return None,
        };
        let rectangle = BoundingRectangle::of(&outline, normal)?;
        let numbers = |count: usize| (0..=count).map(|number| number as f64);
        let [columns, rows] = size;
        let across = rectangle.on_lowest_edge(numbers(columns), columns);
        let up = rectangle.offsets(numbers(rows), rows);
        let has_value = |&cell: &usize| map.values.iter().any(|values| !values[cell].is_nan());
        let cells: Vec<usize> = (0..columns * rows).filter(has_value).collect();
        let corners = |&cell: &usize| {
            let [i, j] = [cell % columns, cell / columns];
            [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[i, j]| across[i] + up[j])
        };
        Some(Self {
            kind: CellType::Quad,
            points: cells.iter().flat_map(corners).collect(),
            counts: vec![4; cells.len()],
            columns: self::columns(&[map], Some(&cells)),
        })
    }

    fn encoded(self, title: &str) -> io::Result<Vec<u8>> {
        let Self { kind, points, counts, columns } = self;
        let ends = counts.iter().scan(0, |end, &count| {
            *end += count as u64;
            Some(*end)
        });
        let cells = Cells {
            cell_verts: VertexNumbers::XML {
                connectivity: (0..points.len() as u64).collect(),
                offsets: ends.collect(),
            },
            types: vec![kind; counts.len()],
        };
        let attribute = |(name, numbers): (String, Vec<f64>)| Attribute::scalars(name, 1).with_data(numbers);
        let columns: Vec<Attribute> = columns.into_iter().map(attribute).collect();
        // vertices are points and cells at once
        let data = match kind {
            CellType::Vertex => Attributes { point: columns, cell: Vec::new() },
            _ => Attributes { point: Vec::new(), cell: columns },
        };
        let coordinates: Vec<f64> = points.iter().flat_map(|point| point.coordinates()).collect();
        let piece = UnstructuredGridPiece { points: coordinates.into(), cells, data };
        let vtk = Vtk {
            version: Version::new_xml(1, 0),
            title: title.to_owned(),
            byte_order: ByteOrder::LittleEndian,
            data: DataSet::inline(piece),
            file_path: None,
        };
        let mut file = Vec::new();
        vtk.write_xml(&mut file).map_err(io::Error::other)?;
        Ok(file)
    }
}

/// Returns the values and the errors of maps in each band: of these cells, or of all.
fn columns(maps: &[&Map], cells: Option<&[usize]>) -> Vec<(String, Vec<f64>)> {
    let mut columns = Vec::new();
    for map in maps {
        for (band, (values, errors)) in map.values.iter().zip(&map.errors).enumerate() {
            let band = (map.values.len() > 1).then_some(band);
            for (what, numbers) in [("", values), ("_error", errors)] {
                let numbers = match cells {
                    Some(cells) => cells.iter().map(|&cell| numbers[cell]).collect(),
                    None => numbers.clone(),
                };
                columns.push((named(map.quantity.name(), what, band), numbers));
            }
        }
    }
    columns
}

/// Returns the value and the error of the answer of a single point.
fn columns_of_answer(answer: &Answer) -> [(String, Vec<f64>); 2] {
    let bin = answer.bin.map_or(String::new(), |bin| format!("_bin{bin}"));
    let name = |what: &str| named(answer.quantity.name(), what, answer.band) + &bin;
    [(name(""), vec![answer.value]), (name("_error"), vec![answer.error])]
}

fn named(quantity: &str, what: &str, band: Option<usize>) -> String {
    let band = band.map_or(String::new(), |band| format!("_band{band}"));
    format!("{quantity}{what}{band}")
}
