//! Files of `--out`: creates the folder and writes the results into it.

use super::figure;
use crate::files::{reason, replace};
use forms_radiometry::output::{csv, exr, file_names, photograph, png, scene_vtu, vtu};
use forms_radiometry::scene::{Receiver, Scene};
use forms_radiometry::simulation::{Layout, Map, Simulation};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

const TABLE: &str = "results.csv";
const FIGURE: &str = "error.svg";
/// File of the surfaces, without its extension.
const SURFACES: &str = "scene";

/// Creates the folder and its parents. The error is a message with the name of the folder.
pub(super) fn folder(path: &str) -> Result<PathBuf, String> {
    match std::fs::create_dir_all(path) {
        Ok(()) => Ok(PathBuf::from(path)),
        Err(error) => Err(format!("cannot create the folder `{path}`: {}", reason(&error))),
    }
}

/// Writes every file that can be written, with `is_vtu` also those of VTK; returns the names of the
/// written files, and messages about the others.
pub(super) fn write(
    scene: &Scene,
    found: &Simulation,
    (folder, is_vtu): (&Path, bool),
) -> (Vec<String>, Vec<String>) {
    let mut files = Files { folder, written: Vec::new(), refused: Vec::new() };
    files.write(TABLE, |output| csv(found, output));
    files.pictures(scene, found);
    if is_vtu {
        files.geometry(scene, found);
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
    /// Writes the maps and images, except for points and faces in no order. The first quantity of a
    /// receiver is named after the receiver alone.
    fn pictures(&mut self, scene: &Scene, found: &Simulation) {
        let drawn: Vec<&Map> = found.maps.iter().filter(|map| map.layout != Layout::List).collect();
        let named = |(index, map): (usize, &&Map)| match index.checked_sub(1).map(|before| drawn[before]) {
            Some(before) if before.receiver == map.receiver => {
                format!("{}_{}", map.receiver, map.quantity.name())
            }
            _ => map.receiver.clone(),
        };
        let names: Vec<String> = drawn.iter().enumerate().map(named).collect();
        let names = file_names(names.iter().map(String::as_str));
        for (map, name) in drawn.into_iter().zip(&names) {
            self.write(&format!("{name}.exr"), |output| output.write_all(&exr(map, scene)?));
            self.write(&format!("{name}.png"), |output| {
                let is_image = map.layout == Layout::Image;
                output.write_all(&if is_image { photograph(map, scene)? } else { png(map)? })
            });
        }
    }

    /// Writes the results on the geometry of each receiver that has one, and the surfaces.
    fn geometry(&mut self, scene: &Scene, found: &Simulation) {
        let encoded = |receiver: &Receiver| Some((receiver.name.clone(), vtu(scene, receiver, found)?));
        let all: Vec<(String, io::Result<Vec<u8>>)> = scene.receivers.iter().filter_map(encoded).collect();
        // the surfaces come first, so that no receiver takes the name of their file
        let names = file_names(std::iter::once(SURFACES).chain(all.iter().map(|(name, _)| name.as_str())));
        let surfaces = (SURFACES.to_owned(), scene_vtu(scene));
        for ((_, bytes), name) in std::iter::once(surfaces).chain(all).zip(&names) {
            self.write(&format!("{name}.vtu"), |output| output.write_all(&bytes?));
        }
    }

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
