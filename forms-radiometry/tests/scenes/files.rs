//! Scenes and meshes in files of a folder.

use crate::{EVERYTHING, PART_OBJ, mitsuba};
use forms_radiometry::scene::{Scene, SceneError, Shape, open};
use std::path::{Path, PathBuf};

/// Creates a folder of its own with these files.
fn folder(name: &str, files: &[(&str, &[u8])]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    for (file, bytes) in files {
        std::fs::write(folder.join(file), bytes).unwrap();
    }
    folder
}

fn part_of(scene: &Scene) -> usize {
    let part = scene.surfaces.iter().find(|surface| surface.name == "part").unwrap();
    match &part.shape {
        Shape::Mesh(mesh) => mesh.faces().len(),
        _ => panic!("the part is a mesh"),
    }
}

fn refused(path: &Path) -> Vec<SceneError> {
    open(path).map(|_| ()).expect_err("the file is refused")
}

#[test]
fn a_scene_in_a_file_finds_its_meshes_beside_it() {
    let files: &[(&str, &[u8])] = &[
        ("box.toml", EVERYTHING.as_bytes()),
        ("box.xml", mitsuba::EVERYTHING.as_bytes()),
        ("part.obj", PART_OBJ.as_bytes()),
    ];
    let folder = folder("meshes_beside", files);
    for file in ["box.toml", "box.xml"] {
        assert_eq!(part_of(&open(&folder.join(file)).unwrap()), 4, "{file}");
    }
}

#[test]
fn a_mark_of_the_order_of_bytes_is_no_part_of_a_file() {
    let marked = |text: &str| [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let files = [("box.toml", EVERYTHING), ("box.xml", mitsuba::EVERYTHING), ("part.obj", PART_OBJ)];
    let files = files.map(|(name, text)| (name, marked(text)));
    let folder = folder("marked", &files.each_ref().map(|(name, bytes)| (*name, &bytes[..])));
    for file in ["box.toml", "box.xml"] {
        assert_eq!(part_of(&open(&folder.join(file)).unwrap()), 4, "{file}");
    }
}

#[test]
fn an_error_names_the_path_as_it_was_given_and_that_of_a_mesh_beside_it() {
    let folder = folder("broken_beside", &[("box.toml", EVERYTHING.as_bytes()), ("part.obj", b"f 1 2\n")]);
    let found = refused(&folder.join("box.toml"));
    assert_eq!(Path::new(&found[0].file), folder.join("part.obj"));
}

#[test]
fn a_file_that_is_no_text_is_refused_with_the_line_from_which_it_is_none() {
    let folder = folder("no_text", &[("box.toml", b"name = \"Box\"\nunit = \"\xff\"\n")]);
    let found = refused(&folder.join("box.toml"));
    assert_eq!(found[0].message, "the file is not valid UTF-8 from line 2 on");
    let found = refused(&folder);
    assert!(found[0].message.starts_with("the file cannot be read: "), "{}", found[0]);
}
