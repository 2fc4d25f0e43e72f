//! Media of Mitsuba 3: the media that boundaries and sensors declare are compared with the regions
//! of space.

use crate::mitsuba::EVERYTHING;
use crate::{check_each, errors, scene};
use forms_radiometry::scene::MaterialKind;

const FILE: &str = "box.xml";

fn everything() -> forms_radiometry::scene::Scene {
    scene(EVERYTHING, FILE)
}

#[test]
fn a_medium_is_told_by_albedo_extinction_and_scale_and_takes_its_index_from_its_boundary() {
    let scene = everything();
    let inside = |name: &str| {
        let surface = scene.surfaces.iter().find(|surface| surface.name == name).unwrap();
        match scene.materials[surface.material].kind {
            MaterialKind::Dielectric { inside } => &scene.media[inside],
            _ => panic!("{name} is a boundary"),
        }
    };
    for (name, n) in [("ball", 1.5), ("cloud", 1.0)] {
        let medium = inside(name);
        assert_eq!((&medium.absorption, &medium.scattering), (&vec![4.0, 2.0, 0.0], &vec![4.0, 6.0, 8.0]));
        assert_eq!((&medium.asymmetry, &medium.index), (&vec![-0.25; 3], &vec![n; 3]), "{name}");
    }
    assert_eq!(scene.ambient.medium, None);
}

#[test]
fn the_index_around_all_boundaries_is_that_of_the_ambient_medium() {
    let scene = scene(&EVERYTHING.replace("value=\"vacuum\"", "value=\"air\""), FILE);
    let ambient = &scene.media[scene.ambient.medium.unwrap()];
    assert_eq!(ambient.index, [1.000277; 3]);
    assert!(ambient.absorption == [0.0; 3] && ambient.scattering == [0.0; 3]);
}

#[test]
fn what_is_outside_of_every_boundary_and_around_the_sensors_fills_the_scene() {
    let text = r#"<scene version="3.0.0">
        <medium type="homogeneous" id="haze"><float name="sigma_t" value="0.1"/></medium>
        <shape type="sphere">
            <bsdf type="dielectric"><float name="ext_ior" value="1"/></bsdf>
            <ref name="exterior" id="haze"/>
        </shape>
        <sensor type="perspective"><float name="fov" value="40"/><ref id="haze"/></sensor>
    </scene>"#;
    let scene = scene(text, FILE);
    let ambient = &scene.media[scene.ambient.medium.unwrap()];
    assert_eq!((&*ambient.name, &ambient.index), ("haze", &vec![1.0]));
    assert!((ambient.scattering[0] - 0.075).abs() < 1e-16 && (ambient.absorption[0] - 0.025).abs() < 1e-16);
    let found = errors(&text.replace("<ref id=\"haze\"/></sensor>", "</sensor>"), FILE);
    assert_eq!(
        found[0].message,
        "the exterior medium of `shape 1` is not `ambient medium`, the medium in front of it"
    );
}

/// A glass ball, and a cloud, in a cube of water.
const AQUARIUM: &str = r#"<scene version="3.0.0">
    <medium type="homogeneous" id="water"><float name="albedo" value="0"/></medium>
    <medium type="homogeneous" id="ink"><float name="albedo" value="0.5"/></medium>
    <shape type="cube" id="tank">
        <bsdf type="dielectric"><float name="int_ior" value="1.33"/><float name="ext_ior" value="1"/></bsdf>
        <ref name="interior" id="water"/>
    </shape>
    <shape type="sphere" id="ball">
        <float name="radius" value="0.25"/>
        <bsdf type="dielectric"><float name="int_ior" value="1.5"/><float name="ext_ior" value="1.33"/></bsdf>
        <ref name="exterior" id="water"/>
    </shape>
    <shape type="sphere" id="cloud">
        <float name="radius" value="0.25"/>
        <point name="center" value="0.6, 0.6, 0.6"/>
        <bsdf type="null"/>
        <ref name="interior" id="ink"/>
        <ref name="exterior" id="water"/>
    </shape>
    <sensor type="perspective" id="eye"><float name="fov" value="40"/></sensor>
</scene>"#;

#[test]
fn media_may_lie_in_each_other_if_each_boundary_says_what_is_outside_of_it() {
    let scene = scene(AQUARIUM, FILE);
    let inside = |surface: usize| match scene.materials[scene.surfaces[surface].material].kind {
        MaterialKind::Dielectric { inside } => &scene.media[inside],
        _ => panic!("it is a boundary"),
    };
    assert_eq!([0, 1, 2].map(|surface| inside(surface).index[0]), [1.33, 1.5, 1.33]);
    assert_eq!([0, 1, 2].map(|surface| inside(surface).absorption[0]), [1.0, 0.0, 0.5]);
    assert_eq!(scene.ambient.medium, None);
    let cases = [
        (
            "value=\"1.33\"/></bsdf>",
            "value=\"1.3\"/></bsdf>",
            "the exterior index 1.3 of `ball` is not the index of `water`",
        ),
        (
            "<ref name=\"exterior\" id=\"water\"/>",
            "",
            "the exterior medium of `ball` is not `water`, the medium in front of it",
        ),
        (
            "<bsdf type=\"null\"/>\n        <ref name=\"interior\" id=\"ink\"/>\n        <ref name=\"exterior\" id=\"water\"/>",
            "<bsdf type=\"null\"/>\n        <ref name=\"interior\" id=\"ink\"/>\n        <ref name=\"exterior\" id=\"ink\"/>",
            "the exterior medium of `cloud` is not `water`, the medium in front of it",
        ),
        (
            "<sensor type=\"perspective\" id=\"eye\">",
            "<sensor type=\"perspective\"><float name=\"fov\" value=\"9\"/></sensor><sensor type=\"perspective\" id=\"eye\"><ref id=\"ink\"/>",
            "this sensor is not in the ambient medium `ambient medium`",
        ),
    ];
    check_each(AQUARIUM, FILE, &cases, 6);
}
