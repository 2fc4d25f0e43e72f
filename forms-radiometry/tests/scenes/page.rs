//! The page on scenes shows valid scenes, and quotes the messages of invalid ones.
//!
//! ```text
//! docs/scenes.md ─ fenced blocks ─┬─ toml, xml                a scene without errors
//!                                 ├─ toml,error xml,error …   exactly the errors in the next block
//!                                 └─ toml,refused             exactly the unsupported ones there
//! ```
//! With `FORMS_WRITE=1` quoted messages are rewritten.

use crate::{files, shown};
use forms_radiometry::scene::{SceneError, not_simulated, read_with_files};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/scenes.md");

/// Returns a scene that names a mesh.
fn scene_of(mesh: &str) -> String {
    format!(
        "[[material]]\nname = \"white\"\nkind = \"diffuse\"\nreflectance = 0.5\n[[surface]]\nname = \"part\"\n\
         material = \"white\"\nmesh = \"{mesh}\"\n"
    )
}

/// A scene that names a table of points.
const POINTS: &str = "[[receiver]]\nname = \"sensors\"\nkind = \"point\"\npoints = \"sensors.csv\"\n";

/// Returns the errors of a block of some kind.
fn said(kind: &str, text: &str) -> Option<Vec<SceneError>> {
    let read = |text: &str, name: &str| read_with_files(text, name, &files);
    let mesh = |name: &str| read_with_files(&scene_of(name), "scene.toml", &|_| Ok(text.into()));
    let scene = match kind.split(',').next()? {
        "toml" => read(text, "scene.toml"),
        "xml" => read(text, "scene.xml"),
        "obj" => mesh("part.obj"),
        "ply" => mesh("part.ply"),
        "csv" => read_with_files(POINTS, "scene.toml", &|_| Ok(text.into())),
        _ => return None,
    };
    Some(match (scene, kind.ends_with(",refused")) {
        (Ok(scene), true) => not_simulated(&scene),
        (Ok(_), false) => Vec::new(),
        (Err(errors), _) => errors,
    })
}

/// Returns the blocks of a page: the info string of the fence, and the text.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let fenced = page.split("```").skip(1).step_by(2);
    fenced.map(|block| block.split_once('\n').expect("a block begins with a line of its own")).collect()
}

#[test]
fn the_page_shows_what_is_read_and_quotes_what_is_said() {
    let page = std::fs::read_to_string(PAGE).unwrap();
    let mut mended = page.clone();
    let (mut right, mut quoted) = (0, 0);
    let blocks = blocks(&page);
    for (place, (kind, text)) in blocks.iter().enumerate() {
        let Some(errors) = said(kind, text) else { continue };
        let messages = shown(&errors);
        if !kind.contains(',') {
            assert!(errors.is_empty(), "{messages}");
            right += 1;
            continue;
        }
        assert!(!errors.is_empty(), "nothing is wrong with\n{text}");
        let (next, found) = blocks[place + 1];
        assert_eq!(next, "text", "no message below\n{text}");
        let quotation = |messages: &str| format!("```{kind}\n{text}```\n\n```text\n{messages}```\n");
        mended = mended.replace(&quotation(found), &quotation(&format!("{messages}\n")));
        quoted += errors.len();
    }
    if std::env::var_os("FORMS_WRITE").is_some() {
        std::fs::write(PAGE, &mended).unwrap();
    } else {
        assert_eq!(page, mended, "FORMS_WRITE=1 cargo test -p forms-radiometry --test scenes");
    }
    assert!(right >= 2 && quoted >= 80, "{right} scenes, {quoted} messages");
}
