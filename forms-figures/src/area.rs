//! Axis-aligned boxes on the canvas.

/// Axis-aligned box on the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Area {
    pub(crate) fn around([x, y]: [f64; 2], half: f64) -> Self {
        Area { left: x - half, top: y - half, right: x + half, bottom: y + half }
    }

    /// Returns the area of the intersection of two boxes.
    pub(crate) fn shared(&self, other: &Area) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    /// Returns the area outside another box.
    pub(crate) fn outside(&self, other: &Area) -> f64 {
        (self.right - self.left) * (self.bottom - self.top) - self.shared(other)
    }

    /// Whether a segment passes through the box: clipped to the box, it has a positive length.
    pub(crate) fn is_crossed(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let sides = [(self.left, self.right), (self.top, self.bottom)];
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for (axis, (low, high)) in sides.into_iter().enumerate() {
            let (start, way) = (from[axis], to[axis] - from[axis]);
            if way == 0.0 {
                if start <= low || start >= high {
                    return false;
                }
                continue;
            }
            let (a, b) = ((low - start) / way, (high - start) / way);
            (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
        }
        first < last
    }
}
