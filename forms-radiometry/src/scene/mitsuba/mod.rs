//! stub
use super::error::Report;
use super::mesh_file::MeshFiles;
use super::model::Scene;
pub(super) fn read(_: &mut Report, _: &str, _: &mut MeshFiles) -> Option<Scene> {
    None
}
