//! Wavefront OBJ: reads the vertices, the faces and the names of their groups, or of their materials
//! if the file has no groups, the normals and the texture coordinates. Lines and points are ignored:
//! they have no area.

use super::parts::Parts;
use super::words::{Word, extent, lines, words};
use super::{Fault, Read};
use crate::geometry::Vector;
use crate::scene::SceneError;
use crate::scene::place::Source;
use crate::scene::value::values;

/// Statements that do not affect the shape: parameters of surfaces, weights of vertices
/// and tags of subdivision, display settings, points, lines and curves.
const WITHOUT_SHAPE: &[&str] = &[
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
                self.add_attributes(arguments);
                self.face(face, extent(statement));
            }),
            "vn" => {
                let [x, y, z] = numbers(arguments);
                self.normals.values.push(Vector::new(x, y, z));
                Ok(())
            }
            "vt" => {
                self.texture.values.push(numbers(arguments));
                Ok(())
            }
            keyword @ ("g" | "o" | "usemtl") => {
                if by_material || keyword != "usemtl" {
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
    /// Adds the texture coordinates and the normals at the corners of the next face.
    fn add_attributes(&mut self, arguments: &[Word]) {
        let face = self.face_count();
        if !self.texture.values.is_empty() {
            self.texture.push(face, attributes(arguments, 1, self.texture.values.len()));
        }
        if !self.normals.values.is_empty() {
            self.normals.push(face, attributes(arguments, 2, self.normals.values.len()));
        }
    }
}

/// Parses the numbers of `vn x y z` or `vt u v w`; an invalid or missing number is zero.
fn numbers<const N: usize>(arguments: &[Word]) -> [f64; N] {
    std::array::from_fn(|i| arguments.get(i).and_then(|word| word.float().ok()).unwrap_or(0.0))
}

/// Returns the indices, from zero, at the corners of a face, of the texture coordinates (place 1) or
/// the normals (place 2), of which there are `count` so far. There are none if a corner has none.
fn attributes(arguments: &[Word], place: usize, count: usize) -> Vec<u32> {
    let index = |word: &Word| {
        let number = word.text.split('/').nth(place)?.parse::<i64>().ok()?;
        u32::try_from(if number < 0 { count as i64 + number } else { number - 1 }).ok()
    };
    arguments.iter().map(index).collect::<Option<_>>().unwrap_or_default()
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
