//! Wavefront OBJ: reads the vertices, the faces and the names of their groups, or of their materials
//! if the file has no groups. A surface of a scene is flat between its edges, so normals are only
//! compared with those of the faces. Texture coordinates are ignored, and so are lines and points,
//! which have no area.

use super::parts::Parts;
use super::words::{Word, extent, lines, words};
use super::{Fault, Read, is_same_normal};
use crate::geometry::{Polygon, Vector};
use crate::scene::SceneError;
use crate::scene::place::Source;
use crate::scene::value::values;

/// Statements that do not affect the shape: texture coordinates and parameters, weights of vertices
/// and tags of subdivision, display settings, points, lines and curves.
const WITHOUT_SHAPE: &[&str] = &[
    "vt",
    "vp",
    "vw",
    "t",
    "s",
    "mg",
    "mtllib",
    "usemap",
    "maplib",
    "lod",
    "bevel",
    "c_interp",
    "d_interp",
    "shadow_obj",
    "trace_obj",
    "p",
    "l",
    "cstype",
    "deg",
    "bmat",
    "step",
    "parm",
    "curv",
    "curv2",
    "end",
];

pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Read, Vec<SceneError>> {
    let text = String::from_utf8_lossy(bytes);
    let source = Source::new(file, text.strip_prefix('\u{feff}').unwrap_or(&text));
    let names_groups = |line: &str| matches!(line.split_whitespace().next(), Some("g" | "o"));
    let by_material = !source.text.lines().any(names_groups);
    let mut parts = Parts::default();
    let mut statement: Vec<Word> = Vec::new();
    for (start, line) in lines(&source.text, 0) {
        let before_comment = line.split('#').next().unwrap_or_default();
        let (line, continues) = match before_comment.trim_end().strip_suffix('\\') {
            Some(line) => (line, true),
            None => (before_comment, false),
        };
        statement.extend(words(start, line));
        if !continues {
            parts.add(&statement, by_material);
            statement.clear();
        }
    }
    parts.add(&statement, by_material);
    parts.mesh(&source)
}

impl Parts {
    fn add(&mut self, statement: &[Word], by_material: bool) {
        let Some((keyword, arguments)) = statement.split_first() else { return };
        let added = match keyword.text {
            "v" => vertex(keyword, arguments).map(|vertex| self.vertices.push(vertex)),
            "f" => face(arguments, self.vertices.len()).map(|face| {
                self.faces_with_own_normal += usize::from(self.has_own_normal(&face, arguments));
                self.face(face, extent(statement));
            }),
            "vn" => {
                self.has_normals = true;
                self.normals.push(normal(arguments));
                Ok(())
            }
            "g" | "o" => {
                self.group(&name(arguments));
                Ok(())
            }
            "usemtl" => {
                if by_material {
                    self.group(&name(arguments));
                }
                Ok(())
            }
            word if WITHOUT_SHAPE.contains(&word) => Ok(()),
            word => {
                let message = match word {
                    "surf" => "free-form surfaces are not supported".to_owned(),
                    _ => format!("the statement `{word}` is not supported"),
                };
                let expected = "`v` (vertex), `f` (face), or an ignored statement such as `vn` or `l`";
                Err(Fault::new(keyword.range.clone(), message, expected))
            }
        };
        if let Err(fault) = added {
            self.fault(fault);
        }
    }
}

impl Parts {
    /// Whether all corners of a face are known to have the normal of the face, and the face is flat.
    fn has_own_normal(&self, face: &[u32], arguments: &[Word]) -> bool {
        if self.normals.is_empty() || !self.have_own_normals() {
            return false;
        }
        let corner = |&index: &u32| self.vertices.get(index as usize).copied();
        let Some(corners) = face.iter().map(corner).collect::<Option<Vec<Vector>>>() else { return false };
        let Ok(polygon) = Polygon::new(corners) else { return false };
        arguments.iter().all(|word| {
            let number = word.text.split('/').nth(2).and_then(|number| number.parse::<i64>().ok());
            let from_zero = number.map(|n| if n < 0 { self.normals.len() as i64 + n } else { n - 1 });
            let index = from_zero.and_then(|index| usize::try_from(index).ok());
            let own = index.and_then(|index| *self.normals.get(index)?);
            own.is_some_and(|own| is_same_normal(own, polygon.normal()))
        })
    }
}

/// Parses `vn x y z` into a unit vector; an invalid normal is `None`.
fn normal(arguments: &[Word]) -> Option<Vector> {
    let numbers: Vec<f64> = arguments.iter().map(|word| word.float().ok()).collect::<Option<_>>()?;
    let [x, y, z] = numbers[..] else { return None };
    Vector::new(x, y, z).unit()
}

/// Returns the name of a group, or of all groups to which the next faces belong.
fn name(arguments: &[Word]) -> String {
    arguments.iter().map(|word| word.text).collect::<Vec<_>>().join(" ")
}

/// Parses `v x y z`, optionally followed by a weight, a colour, or both. Weights matter only to
/// free-form curves and surfaces.
fn vertex(keyword: &Word, arguments: &[Word]) -> Result<Vector, Fault> {
    let number = |(place, word): (usize, &Word)| if place < 3 { word.coordinate() } else { word.float() };
    let numbers: Vec<f64> = arguments.iter().enumerate().map(number).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] | [x, y, z, _] | [x, y, z, _, _, _] | [x, y, z, _, _, _, _] => Ok(Vector::new(x, y, z)),
        _ => {
            let message = format!("a vertex has {}", values(numbers.len()));
            Err(Fault::new(keyword.range.clone(), message, "x y z"))
        }
    }
}

/// Parses `f a b c …`, where each corner is `vertex`, `vertex/texture`, `vertex/texture/normal` or
/// `vertex//normal`.
fn face(arguments: &[Word], vertices: usize) -> Result<Vec<u32>, Fault> {
    arguments.iter().map(|word| corner(word, vertices)).collect()
}

/// Parses a corner. Positive vertex numbers count from 1; negative ones count backwards, −1 being
/// the last vertex before the face.
fn corner(word: &Word, vertices: usize) -> Result<u32, Fault> {
    const EXPECTED: &str = "the number of a vertex, as in 7, 7/1, 7/1/3 or 7//3";
    let mut numbers = word.text.split('/');
    let index = numbers.next().and_then(|number| number.parse::<i64>().ok());
    let others: Vec<&str> = numbers.collect();
    let are_numbers = others.iter().all(|number| number.is_empty() || number.parse::<i64>().is_ok());
    let Some(index) = index.filter(|_| others.len() <= 2 && are_numbers) else {
        return Err(Fault::new(
            word.range.clone(),
            format!("`{}` is not a vertex reference", word.text),
            EXPECTED,
        ));
    };
    let from_zero = if index < 0 { vertices as i64 + index } else { index - 1 };
    u32::try_from(from_zero)
        .map_err(|_| Fault::new(word.range.clone(), format!("there is no vertex {index}"), EXPECTED))
}
