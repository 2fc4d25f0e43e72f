//! Clusters: where there are more elements than a rough solution is worth, elements that are close
//! to each other, face the same way and have the same material share a node.

use super::element::Element;
use crate::geometry::Vector;
use std::collections::HashMap;

/// Growth of the cells while there are too many clusters, and the maximum number of growth steps.
const GROWTH: f64 = 1.25;
const MOST_STEPS: usize = 64;

/// Common properties of the elements in a cluster: the cell, the dominant axis of the normal, and
/// the material.
type Key = ([i64; 3], [i8; 2], usize);

/// Returns for each element its cluster, and for each cluster its largest element, which represents
/// all of them. The number of clusters is close to the allowed maximum.
pub(super) fn clusters(
    elements: &[Element],
    material: impl Fn(&Element) -> usize,
    most: usize,
) -> (Vec<u32>, Vec<u32>) {
    if elements.len() <= most {
        let all = || (0..elements.len() as u32).collect();
        return (all(), all());
    }
    let whole: f64 = elements.iter().map(|element| element.area).sum();
    let mut size = (whole / most as f64).sqrt();
    let mut found = of_size(elements, &material, size);
    for _ in 0..MOST_STEPS {
        if found.1.len() <= most {
            break;
        }
        size *= GROWTH;
        found = of_size(elements, &material, size);
    }
    found
}

fn of_size(elements: &[Element], material: &impl Fn(&Element) -> usize, size: f64) -> (Vec<u32>, Vec<u32>) {
    let mut numbers: HashMap<Key, u32> = HashMap::new();
    let (mut of_element, mut largest) = (Vec::with_capacity(elements.len()), Vec::<u32>::new());
    for (index, element) in elements.iter().enumerate() {
        let Vector { x, y, z } = element.centre();
        let cell = [x, y, z].map(|x| (x / size).floor() as i64);
        let number = *numbers.entry((cell, side(element.normal), material(element))).or_insert_with(|| {
            largest.push(index as u32);
            largest.len() as u32 - 1
        });
        let standing = &mut largest[number as usize];
        if element.area > elements[*standing as usize].area {
            *standing = index as u32;
        }
        of_element.push(number);
    }
    (of_element, largest)
}

/// Returns the axis along which a normal is longest, and its sign.
fn side(normal: Vector) -> [i8; 2] {
    let components = [normal.x, normal.y, normal.z];
    let axis = (0..3).max_by(|&a, &b| components[a].abs().total_cmp(&components[b].abs())).unwrap_or(0);
    [axis as i8, components[axis].signum() as i8]
}
