//! Files of `--out`: creates the folder and writes the results into it.

use super::figure;
use crate::files::{reason, replace};
use forms_radiometry::output::{csv, exr, file_names, photograph, png};
use forms_radiometry::scene::Scene;
use forms_radiometry::simulation::Simulation;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

const TABLE: &str = "results.csv";
const FIGURE: &str = "error.svg";

/// Creates the folder and its parents. The error is a message with the name of the folder.
pub(super) fn folder(path: &str) -> Result<PathBuf, String> {
    match std::fs::create_dir_all(path) {
        Ok(()) => Ok(PathBuf::from(path)),
        Err(error) => Err(format!("cannot create the folder `{path}`: {}", reason(&error))),
    }
}

/// Writes every file that can be written; returns the names of the written files, and messages
/// about the others.
pub(super) fn write(scene: &Scene, found: &Simulation, folder: &Path) -> (Vec<String>, Vec<String>) {
    let mut files = Files { folder, written: Vec::new(), refused: Vec::new() };
    files.write(TABLE, |output| csv(found, output));
    let names = file_names(found.maps.iter().map(|map| map.receiver.as_str()));
    for (map, name) in found.maps.iter().zip(&names) {
        files.write(&format!("{name}.exr"), |output| output.write_all(&exr(map, scene)?));
        files.write(&format!("{name}.png"), |output| {
            output.write_all(&if map.is_image { photograph(map, scene)? } else { png(map)? })
        });
    }
    let figure = figure::svg(&scene.name, &found.history, scene.solve.tolerance);
    files.write(FIGURE, |output| output.write_all(figure.as_bytes()));
    (files.written, files.refused)
}

struct Files<'f> {
    folder: &'f Path,
    written: Vec<String>,
    refused: Vec<String>,
}

impl Files<'_> {
    fn write(&mut self, name: &str, content: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) {
        let path = self.folder.join(name);
        match replace(&path, content) {
            Ok(()) => self.written.push(name.to_owned()),
            Err(error) => {
                self.refused.push(format!("`{}` cannot be written: {}", path.display(), reason(&error)));
            }
        }
    }
}
