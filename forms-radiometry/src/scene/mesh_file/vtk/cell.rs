//! Cells: the faces among the cells of a VTK file.

use super::super::Read;
use super::super::parts::{Elements, Parts};
use crate::scene::SceneError;
use crate::scene::place::Source;
use std::ops::Range;
use std::sync::Arc;

/// Kinds of cells.
pub(super) const STRIP: u8 = 6;
pub(super) const POLYGON: u8 = 7;
const TRIANGLE: u8 = 5;
const PIXEL: u8 = 8;
const QUADRILATERAL: u8 = 9;
/// Curved triangles and quadrilaterals; their corners come first.
const CURVED_TRIANGLES: [u8; 3] = [22, 34, 69];
const CURVED_QUADRILATERALS: [u8; 5] = [23, 28, 30, 70, 77];

/// The cells read so far.
#[derive(Default)]
pub(super) struct Cells {
    pub(super) parts: Parts,
    elements: Elements,
}

impl Cells {
    /// Adds the faces of a cell; its nodes count from this vertex.
    pub(super) fn add(
        &mut self,
        kind: u8,
        nodes: &[u64],
        first: usize,
        place: Range<usize>,
    ) -> Result<(), String> {
        let count = self.parts.vertices.len() - first;
        if let Some(wrong) = nodes.iter().find(|&&node| node >= count as u64) {
            return Err(format!(
                "there is no point {wrong}: the points are 0 to {}",
                count.saturating_sub(1)
            ));
        }
        let nodes: Vec<u32> = nodes.iter().map(|&node| first as u32 + node as u32).collect();
        let corners = match kind {
            TRIANGLE => 3,
            QUADRILATERAL | PIXEL => 4,
            POLYGON | STRIP => 3.max(nodes.len()),
            kind if CURVED_TRIANGLES.contains(&kind) => 3,
            kind if CURVED_QUADRILATERALS.contains(&kind) => 4,
            _ => {
                self.elements.skipped += 1;
                return Ok(());
            }
        };
        let Some(corners) = nodes.get(..corners) else {
            return Err(format!("a cell has {} of its {corners} corners", nodes.len()));
        };
        self.elements.curved += usize::from(nodes.len() > corners.len());
        match kind {
            STRIP => corners.windows(3).enumerate().for_each(|(index, window)| {
                let &[a, b, c] = window else { return };
                self.parts.face(if index % 2 == 0 { [a, b, c] } else { [b, a, c] }, place.clone());
            }),
            PIXEL => self.parts.face([0, 1, 3, 2].map(|corner| corners[corner]), place),
            _ => self.parts.face(corners.iter().copied(), place),
        }
        Ok(())
    }

    /// Returns the mesh, if there are faces among the cells.
    pub(super) fn finish(mut self, source: &Arc<Source>) -> Result<Read, Vec<SceneError>> {
        self.elements.note(&mut self.parts, "cell", "triangles, quadrilaterals or polygons");
        self.parts.mesh(source)
    }
}
