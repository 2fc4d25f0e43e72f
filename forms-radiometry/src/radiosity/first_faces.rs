//! First faces: the faces of a scene at the coarsest tessellation, with the screens that occlude
//! them. The plan needs them for its prediction and the solver for its elements; they are built
//! once, when they are first needed.

use crate::faces::faces;
use crate::scene::Scene;
use crate::visibility::{Face, Screens};
use std::sync::{Arc, OnceLock};

/// The faces of a scene at the coarsest tessellation, and all their screens.
#[derive(Clone, Debug, Default)]
pub(crate) struct FirstFaces {
    faces: OnceLock<Arc<Vec<Face>>>,
    screens: OnceLock<Arc<Screens>>,
}

impl FirstFaces {
    /// Returns the faces of the scene, which is the same in every call.
    pub(crate) fn faces(&self, scene: &Scene) -> Arc<Vec<Face>> {
        Arc::clone(self.faces.get_or_init(|| Arc::new(faces(scene, 0))))
    }

    /// Returns the screens of these faces.
    pub(crate) fn screens(&self, scene: &Scene) -> Arc<Screens> {
        Arc::clone(self.screens.get_or_init(|| Arc::new(Screens::of(&self.faces(scene)))))
    }
}
