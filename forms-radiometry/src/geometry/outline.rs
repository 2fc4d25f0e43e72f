//! Outlines of flat pieces. Those of triangles, of which a mesh can have millions, lie in place:
//! they take no allocation, and rays find them without a further read of memory.

use super::Vector;
use smallvec::SmallVec;

/// The vertices of a flat piece, in the order of its outline.
pub(crate) type Outline = SmallVec<[Vector; 3]>;
