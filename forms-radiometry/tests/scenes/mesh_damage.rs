//! Damaged mesh files: none of them ends in a panic, in an error without a message, or in a part of
//! its faces.

use crate::mesh_formats::{files, gltf, meshes, meshes_of, read, stl_text, vtu};
use crate::shown;
use forms_testing::SplitMix;

#[test]
fn a_damaged_file_is_read_or_refused() {
    let cases = std::env::var("FORMS_FUZZ").map_or(300, |count| count.parse().expect("a number of cases"));
    let mut random = SplitMix(5);
    for (name, bytes) in files() {
        let mut refused = 0;
        for _ in 0..cases {
            let mut damaged = bytes.clone();
            for _ in 0..1 + random.below(3) {
                let place = random.below(damaged.len().max(1));
                match random.below(4) {
                    _ if damaged.len() < 2 => {}
                    0 => drop(damaged.remove(place)),
                    1 => damaged[place] = random.next() as u8,
                    2 => damaged[place] = b"0123456789-.e $<\n"[random.below(17)],
                    _ => damaged.truncate(place.max(1)),
                }
            }
            match read(name, &damaged, "") {
                Ok(_) => {}
                Err(errors) => {
                    refused += 1;
                    assert!(
                        errors.iter().all(|error| !error.message.is_empty() && error.file.ends_with(name))
                    );
                }
            }
        }
        assert!(refused > cases / 10, "{name}: {refused}");
    }
}

#[test]
fn a_file_that_is_cut_short_is_refused_unless_all_faces_or_none_are_left() {
    for (name, mut bytes) in files() {
        // an STL file whose second solid is missing is whole
        let last_solid = bytes.windows(10).position(|part| part == b"solid rest").unwrap_or(0);
        bytes.drain(..last_solid);
        let whole = meshes(name, &bytes, "");
        for length in 0..bytes.len() {
            let Ok(scene) = read(name, &bytes[..length], "") else { continue };
            let found = meshes_of(&scene);
            assert!(
                found.is_empty() || found == whole,
                "{name}, the first {length} of {} bytes",
                bytes.len()
            );
        }
    }
}

#[test]
fn what_is_missing_is_said_where_it_is_missing() {
    let [stl, vtu, gltf] = [stl_text(), vtu(), gltf()].map(|bytes| String::from_utf8(bytes).unwrap());
    let cases = [
        (
            "cut.stl",
            stl.split_at(stl.rfind("endfacet").unwrap()).0,
            "cut.stl:81:2: the file ends within this facet",
        ),
        (
            "cut.stl",
            stl.split_at(stl.rfind("endsolid").unwrap()).0,
            "cut.stl:17:1: the file ends within this solid",
        ),
        (
            "cut.vtu",
            vtu.strip_suffix("</VTKFile>").unwrap(),
            "cut.vtu:1:621: the root node was opened but never closed",
        ),
        ("cut.gltf", &gltf.replace("\"scene\": 0", "\"scene\": 1"), "cut.gltf: there is no scene 1"),
    ];
    for (name, text, message) in cases {
        let errors = read(name, text.as_bytes(), "").map(|_| ()).expect_err(message);
        assert!(shown(&errors).contains(message), "{}", shown(&errors));
    }
}
