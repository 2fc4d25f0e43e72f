//! Received light: rows of weights and direct light at the nodes of each element become those of all
//! nodes, band by band.

use super::operator::Row;

/// Rows and direct light of the nodes of an element.
#[derive(Default)]
pub(super) struct Received {
    pub(super) rows: Vec<Row>,
    /// For each node, in each band, the direct light, and the direct light of point and distant
    /// lights alone.
    pub(super) direct: Vec<Vec<f64>>,
    pub(super) beams: Vec<Vec<f64>>,
    /// For each band the mean deviation of the irradiance from this light.
    pub(super) jump: Vec<f64>,
}

/// Rows and direct light of all nodes.
pub(super) struct OfNodes {
    pub(super) rows: Vec<Row>,
    /// For each band the direct light of each node, and that of point and distant lights alone.
    pub(super) direct: Vec<Vec<f64>>,
    pub(super) beams: Vec<Vec<f64>>,
    /// For each band the mean deviation on each element.
    pub(super) jumps: Vec<Vec<f64>>,
}

impl OfNodes {
    /// Joins what the elements receive, in their order, in this number of bands.
    pub(super) fn of(elements: Vec<Received>, bands: usize) -> Self {
        let mut rows = Vec::new();
        let [mut direct, mut beams, mut jumps] = [(); 3].map(|()| vec![Vec::new(); bands]);
        for Received { rows: of_element, direct: light, beams: of_beams, jump } in elements {
            rows.extend(of_element);
            jumps.iter_mut().zip(jump).for_each(|(band, jump)| band.push(jump));
            for (all, points) in [(&mut direct, light), (&mut beams, of_beams)] {
                for of_point in points {
                    all.iter_mut().zip(of_point).for_each(|(band, value)| band.push(value));
                }
            }
        }
        Self { rows, direct, beams, jumps }
    }
}
