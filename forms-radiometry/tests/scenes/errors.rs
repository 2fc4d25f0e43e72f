//! All errors of a scene file are reported, with their places.

use crate::{EVERYTHING, check_each, errors};
use forms_radiometry::scene;

const FILE: &str = "box.toml";

#[test]
fn an_error_names_the_file_and_the_place_quotes_the_line_and_says_what_was_expected() {
    let found =
        errors(&EVERYTHING.replace("reflectance = 0.75", "reflectance = [0.75, 1.5] # α"), "rooms/box.toml");
    let shown = "rooms/box.toml:19:22: `reflectance` is out of range
   |
19 | reflectance = [0.75, 1.5] # α
   |                      ^^^
   = expected a number from 0 to 1";
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].to_string(), shown);
}

/// Text that is replaced in the scene, its replacement, and the message that follows.
const OF_THE_SCENE: &[(&str, &str, &str)] = &[
    ("unit = \"m\"", "unit = \"km\"", "the unit `km` is unknown"),
    ("unit = \"m\"", "unti = \"m\"", "unknown key `unti` in a scene"),
    ("unit = \"m\"", "unit = 3", "`unit` has the wrong type: found integer"),
    ("[500, 600]", "[600, 500]", "the band ends before it begins"),
    ("[500, 600]", "[500]", "a band has 1 value"),
    ("[500, 600]", "[0, 600]", "the end of a band is out of range"),
    ("medium = \"haze\"", "medium = \"mist\"", "no medium is named `mist`"),
    ("radiance = 0.25", "radiance = [1, 2, 3]", "`radiance` has 3 values"),
    ("radiance = 0.25", "radiance = -0.25", "`radiance` is out of range"),
    ("radiance = 0.25", "colour = 0.25", "unknown key `colour` in a table [ambient]"),
    ("tolerance = 1e-2", "tolerance = 0", "`tolerance` is out of range"),
    ("seed = 7", "seed = 0.5", "`seed` is out of range"),
    ("seed = 7", "seeds = 7", "unknown key `seeds` in a table [solve]"),
    ("\"on\"", "\"maybe\"", "the effect `occlusion` cannot be `maybe`"),
    ("\"on\"", "1", "the effect `occlusion` has no orders"),
    ("\"on\"", "true", "the effect `occlusion` has the wrong type: found boolean"),
    ("scattering = 2", "scattering = 0.5", "the effect `scattering` is out of range"),
    ("scattering = 2", "diffraction = 2", "unknown key `diffraction` in a table of effects"),
    ("[ambient]", "[[ambient]]", "`ambient` is not a table"),
];

/// The same for media, materials and lights.
const OF_OPTICS: &[(&str, &str, &str)] = &[
    ("sigma_a = 0.1", "sigma_a = -0.1", "`sigma_a` is out of range"),
    ("sigma_a = 0.1", "sigma = 0.1", "unknown key `sigma` in a medium"),
    ("[0.2, 0.3]", "[0.2, 0.3, 0.4]", "`sigma_s` has 3 values"),
    ("g = -0.5", "g = -1", "`g` is out of range"),
    ("n = 1\n", "n = 0\n", "`n` is out of range"),
    (
        "[[medium]]\nname = \"glass\"",
        "[[medium]]\nname = \"haze\"\n[[medium]]\nname = \"glass\"",
        "the medium `haze` is already defined in line 7",
    ),
    ("\"diffuse\"", "\"matt\"", "the kind of material `matt` is unknown"),
    ("reflectance = 0.75", "reflectance = -0.1", "`reflectance` is out of range"),
    ("reflectance = 0.75", "reflectance = 1.000001", "`reflectance` is out of range"),
    ("reflectance = 0.75", "reflectance = nan", "`reflectance` is not finite"),
    ("reflectance = 0.75", "reflectance = [1, 1, 1]", "`reflectance` has 3 values"),
    ("reflectance = [0.9, 1]", "reflectance = 1.1", "`reflectance` is out of range"),
    ("inside = \"glass\"", "inside = \"ice\"", "no medium is named `ice`"),
    ("inside = \"glass\"", "inside = \"glass\"\nn = 1.5", "unknown key `n` in a material"),
    ("eta = [1.4, 0.4]", "eta = 0", "`eta` is out of range"),
    ("k = 2", "k = -2", "`k` is out of range"),
    ("k = 2", "k = 2\nreflectance = 1", "unknown key `reflectance` in a material"),
    (
        "[[material]]\nname = \"gold\"",
        "[[material]]\nname = \"white\"\nkind = \"diffuse\"\nreflectance = 0\n[[material]]\nname = \"gold\"",
        "the material `white` is already defined in line 17",
    ),
    ("kind = \"point\"\nposition = [0, 0, 2]", "kind = \"lamp\"", "the kind of light `lamp` is unknown"),
    ("intensity = 1.5", "intensity = -1", "`intensity` is out of range"),
    ("intensity = 1.5", "intensity = 1\nnormal = [0, 0, 1]", "unknown key `normal` in a light"),
    ("direction = [0, 3, -4]", "direction = [0, 0, 0]", "`direction` has length zero"),
    ("[1000, 900]", "[1000, \"bright\"]", "`irradiance` has the wrong type: found string"),
];

/// The same for surfaces.
const OF_SHAPES: &[(&str, &str, &str)] = &[
    ("material = \"white\"", "material = \"wite\"", "no material is named `wite`"),
    ("radiance = [0.5, 1]", "radiance = -1", "`radiance` is out of range"),
    ("radiance = [0.5, 1]", "radiance = [1, inf]", "`radiance` is not finite"),
    ("radiance = [0.5, 1]", "radiance = [1e999, 1]", "`radiance` is not finite"),
    ("two_sided = false", "two_sided = 0", "`two_sided` has the wrong type: found integer"),
    ("two_sided = false", "exitance = 1", "the surface has both a radiance and an exitance"),
    ("two_sided = false", "mesh = \"part.obj\"", "the surface has more than one shape: `polygon` and `mesh`"),
    (", [1, 1, 0], [0, 1, 0]]", "]", "a polygon needs at least three vertices, found 2"),
    (
        "[1, 1, 0]",
        "[1, 1, 0], [0.5, 1, 0.1]",
        "the polygon is not planar: vertex 4 is 5.993e-2 away from its plane (tolerance: 1.0e-6)",
    ),
    ("[1, 1, 0]", "[1, 0, 0]", "vertex 2 and the next vertex coincide"),
    ("[1, 1, 0]", "[1, 1]", "a vertex has 2 values"),
    ("[1, 1, 0]", "[1, 1e153, 0]", "a coordinate of a vertex is out of range"),
    ("[1, 1, 0]", "[1, nan, 0]", "a coordinate of a vertex is not finite"),
    ("[1, 1, 0], [0, 1, 0]", "[0, 1, 0], [2, 3, 0]", "the edges from vertex 2 and from vertex 4 cross"),
    ("[1, 1, 0], [0, 1, 0]", "[2, 0, 0]", "the polygon encloses no area"),
    ("mesh = \"part.obj\"", "mesh = \"part.dwg\"", "`part.dwg` is not a supported mesh file"),
    ("mesh = \"part.obj\"", "mesh = \"parts.obj\"", "there is no file `parts.obj`"),
    ("mesh = \"part.obj\"", "mesh = 3", "`mesh` has the wrong type: found integer"),
    ("radius = 0.5", "radius = 0", "`radius` is out of range"),
    ("inward = false", "outward = true", "unknown key `outward` in a `sphere`"),
    (
        "sphere = { center = [0, 0, 4], radius = 0.5, inward = false }",
        "sphere = 1",
        "`sphere` is not a table",
    ),
    (
        "radius = 0.5, inward = false }",
        "radius = 0.5 }\ntwo_sided = true",
        "a dielectric cannot be two-sided: it has a medium behind it",
    ),
    ("normal = [0, 0, -3]", "normal = [0, 0, 0]", "`normal` has length zero"),
    ("radius = 2 }", "radius = -2 }", "`radius` is out of range"),
    ("name = \"lid\"", "name = \"ball\"", "the surface `ball` is already defined in line 45"),
];

/// The same for receivers.
const OF_RECEIVERS: &[(&str, &str, &str)] = &[
    ("normal = [0, 0, -2]", "normal = [0, 0, 0]", "`normal` has length zero"),
    (
        "kind = \"point\"\nposition = [0.5",
        "kind = \"dot\"\nposition = [0.5",
        "the kind of receiver `dot` is unknown",
    ),
    ("name = \"eye\"", "name = \"here\"", "the receiver `here` is already defined in line 66"),
    ("surface = \"floor\"", "surface = \"flor\"", "no surface is named `flor`"),
    ("grid = [64, 32]", "grid = [64, 0]", "`grid` is out of range"),
    ("grid = [64, 32]", "grid = 64", "`grid` has the wrong type: found integer"),
    ("direction = [0, 2, 0]", "direction = [0, 0, 0]", "`direction` has length zero"),
    ("up = [0, 1, 0]", "up = [0, 0, 1]", "the orientation of the camera is undefined"),
    ("fov = 40", "fov = 180", "`fov` is out of range"),
    ("[8, 6]", "[8, 0.5]", "`resolution` is out of range"),
    ("[8, 6]", "[8, 6]\nnormal = [0, 0, 1]", "unknown key `normal` in a receiver"),
    ("width = 1e-9", "width = 0", "`width` is out of range"),
    ("bins = 100", "bins = 0", "`bins` is out of range"),
    ("bins = 100", "bins = 100, end = 1", "unknown key `end` in a `time`"),
];

#[test]
fn each_error_is_reported_in_its_line_with_its_own_message() {
    for cases in [OF_THE_SCENE, OF_OPTICS, OF_SHAPES, OF_RECEIVERS] {
        check_each(EVERYTHING, FILE, cases, 0);
    }
}

#[test]
fn the_camera_without_a_direction_is_reported_where_its_upright_stands() {
    let found = errors(&EVERYTHING.replace("target = [0, 0, 0]", "target = [0, 0, 9]"), FILE);
    assert_eq!((found.len(), found[0].line), (1, 85));
}

#[test]
fn what_is_missing_is_reported_at_the_head_of_its_element() {
    let cases = [
        ("name = \"glass\"\n", "this medium has no `name`"),
        ("name = \"white\"\n", "this material has no `name`"),
        ("kind = \"mirror\"\n", "this material has no `kind`"),
        ("inside = \"glass\"\n", "this material has no `inside`"),
        ("k = 2\n", "this material has no `k`"),
        ("material = \"white\"\n", "this surface has no `material`"),
        ("mesh = \"part.obj\"\n", "this surface has no shape"),
        ("intensity = 1.5\n", "this light has no `intensity`"),
        ("normal = [0, 0, -2]\n", "this receiver has no `normal`"),
        ("surface = \"floor\"\n", "this receiver has no `surface`"),
        ("fov = 40\n", "this receiver has no `fov`"),
    ];
    for (removed, message) in cases {
        let head = EVERYTHING[..EVERYTHING.find(removed).unwrap()].rfind("\n[[").unwrap() + 1;
        let line = EVERYTHING[..head].matches('\n').count() + 1;
        let found = errors(&EVERYTHING.replacen(removed, "", 1), FILE);
        let told = found.iter().any(|error| error.line == line && error.message == message);
        assert!(told, "{message}: {found:?}");
    }
}

#[test]
fn all_errors_are_collected_in_the_order_of_the_text() {
    let text = EVERYTHING.replace("0.75", "7").replace("[0, 0, -2]", "[0, 0, 0]").replace("\"m\"", "\"km\"");
    let lines: Vec<usize> = errors(&text, FILE).iter().map(|error| error.line).collect();
    assert_eq!(lines, [3, 19, 69]);
}

#[test]
fn an_error_in_a_mesh_stands_where_the_mesh_is_named_and_once_however_often_it_is() {
    let text = EVERYTHING
        .replace("0.75", "7")
        .replace("exitance = 3", "exitance = -3")
        .replace("disk = { center = [0, 0, 8], normal = [0, 0, -3], radius = 2 }", "mesh = \"part.obj\"");
    let broken = |_: &str| Ok(b"v 0 0 0\nf 1 2 3\n".to_vec());
    let found = scene::read_with_files(&text, "rooms/box.toml", &broken).map(|_| ()).unwrap_err();
    let places: Vec<(&str, usize)> = found.iter().map(|error| (&*error.file, error.line)).collect();
    assert_eq!(places, [("rooms/box.toml", 19), ("rooms/part.obj", 2), ("rooms/box.toml", 52)]);
}

#[test]
fn an_element_that_is_no_list_is_an_error() {
    let found = errors("[light]\nkind = \"point\"\n", FILE);
    assert_eq!(found[0].message, "`light` is not a list");
    assert_eq!(errors("light = [3]\n", FILE)[0].message, "this light is not a table");
}

#[test]
fn brackets_without_end_are_an_error_and_not_an_overflow_of_the_stack() {
    for bracket in ["[", "{a=", "[[", "a."] {
        assert!(!errors(&format!("bands = {}", bracket.repeat(100_000)), FILE).is_empty());
    }
}

#[test]
fn a_text_that_is_not_toml_is_an_error_with_its_place() {
    let found = errors("name = \"Box\"\nunit = = 3\n", FILE);
    assert_eq!((found[0].line, found[0].column), (2, 8), "{found:?}");
}

#[test]
fn a_file_that_cannot_be_read_is_named_with_the_reason() {
    let found = scene::open("no such folder/box.toml".as_ref()).map(|_| ()).unwrap_err();
    assert_eq!((found.len(), &*found[0].file, found[0].line), (1, "no such folder/box.toml", 0));
    assert!(found[0].to_string().starts_with("no such folder/box.toml: the file cannot be read: "));
}
