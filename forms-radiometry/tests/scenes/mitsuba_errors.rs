//! Elements of a Mitsuba 3 scene without an equivalent in this library are named with their line.

use crate::mitsuba::EVERYTHING;
use crate::{check_each, errors};

const FILE: &str = "box.xml";

/// Text that is replaced, its replacement, and the message that follows.
const CASES: &[(&str, &str, &str)] = &[
    ("version=\"3.5.0\"", "version=\"0.6.0\"", "scene version `0.6.0` is not supported"),
    (
        "<default name=\"width\" value=\"8\"/>",
        "<default name=\"\" value=\"8\"/><default name=\"width\" value=\"8\"/>",
        "this `default` has no valid `name`",
    ),
    ("value=\"$n\"", "value=\"$m\"", "there is no parameter `m`"),
    ("    <bsdf type=\"twosided\"", "text <bsdf type=\"twosided\"", "unexpected text"),
    (
        "<bsdf type=\"conductor\" id=\"mirror\"/>",
        "<bsdf type=\"conductor\" id=\"mirror\"/><texture type=\"volume\"/>",
        "a texture of type `volume` is not supported",
    ),
    (
        "<bsdf type=\"conductor\" id=\"mirror\"/>",
        "<bsdf type=\"conductor\" id=\"mirror\" x=\"1\"/>",
        "unknown attribute `x` of `bsdf`",
    ),
    ("type=\"volpath\"", "type=\"bdpt\"", "an integrator of type `bdpt` is not supported"),
    ("type=\"volpath\"", "type=\"path\"", "this integrator ignores the participating media of the scene"),
    ("value=\"-1\"", "value=\"0\"", "`max_depth` is out of range"),
    (
        "<integer name=\"rr_depth\" value=\"10\"/>",
        "<boolean name=\"hide_emitters\" value=\"true\"/>",
        "emitters hidden from the camera are not supported",
    ),
    (
        "<integer name=\"rr_depth\" value=\"10\"/>",
        "<integer name=\"samples\" value=\"1\"/>",
        "`integer` named `samples` is not supported in an integrator of type `volpath`",
    ),
    ("<bsdf type=\"diffuse\">", "<bsdf type=\"principled\">", "a bsdf of type `principled` is not supported"),
    ("<bsdf type=\"diffuse\">", "<bsdf type=\"null\">", "a bsdf of type `null` cannot be two-sided"),
    (
        "<rgb name=\"reflectance\" value=\"0.7, 0.6, 0.5\"/>",
        "<texture name=\"reflectance\" type=\"volume\"/>",
        "a texture of type `volume` is not supported",
    ),
    ("0.7, 0.6, 0.5", "0.7, 0.6, 1.5", "`reflectance` is out of range"),
    ("0.7, 0.6, 0.5", "0.7, 0.6", "`reflectance` has 2 values"),
    ("0.7, 0.6, 0.5", "0.7, 0.6, red", "`red` is not a number"),
    ("0.7, 0.6, 0.5", "", "`reflectance` is empty"),
    (
        "<spectrum name=\"k\" value=\"2\"/>",
        "<spectrum name=\"k\" value=\"700:2, 400:3\"/>",
        "`400:3` is not the next entry of a spectrum",
    ),
    (
        "<spectrum name=\"k\" value=\"2\"/>",
        "<spectrum name=\"k\" filename=\"k.spd\"/>",
        "unknown attribute `filename` of `spectrum`",
    ),
    ("<spectrum name=\"k\" value=\"2\"/>", "", "this conductor has `eta` but no `k`"),
    (
        "id=\"mirror\"/>",
        "id=\"mirror\"><string name=\"material\" value=\"gold\"/></bsdf>",
        "the refractive index of the metal `gold` is not known",
    ),
    (
        "<float name=\"int_ior\" value=\"$n\"/>",
        "<string name=\"int_ior\" value=\"glas\"/>",
        "the refractive index of `glas` is not known",
    ),
    (
        "<float name=\"int_ior\" value=\"$n\"/>",
        "<float name=\"roughness\" value=\"$n\"/>",
        "`float` named `roughness` is not supported in a bsdf of type `dielectric`",
    ),
    (
        "type=\"dielectric\" id=\"glass\"",
        "type=\"roughdielectric\" id=\"glass\"",
        "a bsdf of type `roughdielectric` is not supported",
    ),
    ("type=\"homogeneous\"", "type=\"heterogeneous\"", "a medium of type `heterogeneous` is not supported"),
    ("0.5, 0.75, 1", "0.5, 0.75, 1.25", "`albedo` is out of range"),
    ("type=\"hg\"", "type=\"rayleigh\"", "a phase of type `rayleigh` is not supported"),
    ("value=\"-0.25\"", "value=\"-1\"", "`g` is out of range"),
    ("id=\"lamp\"", "id=\"floor\"", "the id `floor` is already defined in line 31"),
    ("<ref id=\"gold\"/>", "<ref id=\"silver\"/>", "no element has the id `silver`"),
    ("type=\"cube\"", "type=\"sdfgrid\"", "a shape of type `sdfgrid` is not supported"),
    ("<scale x=\"2\" y=\"3\"/>", "<scale x=\"2\" y=\"0\"/>", "the transform has no inverse"),
    ("<scale x=\"2\" y=\"3\"/>", "<shear x=\"2\"/>", "`shear` is not supported in a transform"),
    ("<rotate x=\"1\" angle=\"180\"/>", "<rotate x=\"1\"/>", "this rotate has no `angle`"),
    ("<rotate x=\"1\" angle=\"180\"/>", "<rotate angle=\"180\"/>", "the axis has length zero"),
    ("value=\"0, 0, 10\"", "value=\"0, 10\"", "`value` has 2 values"),
    ("0 0 0 1\"", "0 0 1 1\"", "the matrix is not affine"),
    ("0 0 0 1\"", "\"", "the matrix has 12 values"),
    ("0 0 2 0", "0 0 -2 0", "a transform with reflection would turn this shape inside out"),
    ("<scale value=\"2\"/>", "<scale x=\"2\"/>", "non-uniform scaling of a sphere is not supported"),
    (
        "<float name=\"radius\" value=\"0.5\"/>",
        "<float name=\"radius\" value=\"0\"/>",
        "`radius` is out of range",
    ),
    (
        "<lookat origin=\"0, 9, 0\" target=\"0, 8, 0\" up=\"1, 0, 0\"/>",
        "<scale x=\"2\"/>",
        "non-uniform scaling of a disk is not supported",
    ),
    ("up=\"1, 0, 0\"", "up=\"0, 1, 0\"", "the orientation of the lookat is undefined"),
    ("up=\"1, 0, 0\"", "", "this lookat has no `up`"),
    ("<bsdf type=\"null\"/>", "", "an interior or exterior medium of an opaque surface is not supported"),
    (
        "<boolean name=\"face_normals\" value=\"true\"/>",
        "<emitter type=\"area\"><float name=\"radiance\" value=\"1\"/></emitter>",
        "emission and irradiance of `part.obj` by interpolated normals are not supported",
    ),
    (
        "<boolean name=\"face_normals\" value=\"true\"/>",
        "<boolean name=\"face_normals\" value=\"yes\"/>",
        "`face_normals` cannot be `yes`",
    ),
    ("value=\"part.obj\"", "value=\"parts.obj\"", "there is no file `parts.obj`"),
    (
        "value=\"part.obj\"",
        "value=\"part.ply\"",
        "`part.ply` does not have the extension `.obj` of the shape type",
    ),
    (
        "<emitter type=\"area\">",
        "<emitter type=\"directionalarea\">",
        "an emitter of type `directionalarea` is not supported",
    ),
    ("<rgb name=\"radiance\" value=\"18, 11, 3\"/>", "", "this emitter has no `radiance`"),
    ("type=\"point\"", "type=\"projector\"", "an emitter of type `projector` is not supported"),
    ("z=\"-2\"", "z=\"0\"", "the direction has length zero"),
    (
        "<emitter type=\"directional\" id=\"sun\">",
        "<emitter type=\"directional\" id=\"sun\"><transform name=\"to_world\"/>",
        "this emitter has both `direction` and `to_world`",
    ),
    (
        "<emitter type=\"constant\">",
        "<emitter type=\"constant\"><float name=\"radiance\" value=\"1\"/></emitter><emitter type=\"constant\">",
        "more than one emitter of type `constant` or `envmap`",
    ),
    ("type=\"perspective\"", "type=\"thinlens\"", "a sensor of type `thinlens` is not supported"),
    (
        "<float name=\"fov\" value=\"90\"/>",
        "<float name=\"fov\" value=\"90\"/><float name=\"fov\" value=\"90\"/>",
        "`fov` occurs twice in a sensor of type `perspective`",
    ),
    ("<float name=\"fov\" value=\"90\"/>", "<float name=\"fov\" value=\"180\"/>", "`fov` is out of range"),
    ("fov_axis\" value=\"x\"", "fov_axis\" value=\"z\"", "`fov_axis` cannot be `z`"),
    (
        "<float name=\"near_clip\" value=\"0.1\"/>",
        "<string name=\"focal_length\" value=\"50mm\"/>",
        "this sensor has both `fov` and `focal_length`",
    ),
    (
        "<float name=\"fov\" value=\"90\"/>\n        <string name=\"fov_axis\" value=\"x\"/>",
        "<string name=\"focal_length\" value=\"0mm\"/>",
        "`focal_length` cannot be `0mm`",
    ),
    (
        "<float name=\"near_clip\" value=\"0.1\"/>",
        "<float name=\"principal_point_offset_x\" value=\"0.1\"/>",
        "a `principal_point_offset_x` other than 0 is not supported",
    ),
    (
        "<integer name=\"height\" value=\"4\"/>",
        "<integer name=\"height\" value=\"4\"/><integer name=\"crop_height\" value=\"2\"/>",
        "`crop_height` selects a part of the film, which is not supported",
    ),
    (
        "<float name=\"near_clip\" value=\"0.1\"/>",
        "<spectrum name=\"srf\" value=\"1\"/>",
        "`spectrum` named `srf` is not supported in a sensor of type `perspective`",
    ),
    ("value=\"$width\"", "value=\"0\"", "`width` is out of range"),
    (
        "<integer name=\"height\" value=\"1\"/>",
        "<integer name=\"height\" value=\"2\"/>",
        "an irradiance meter with more than one pixel is not supported",
    ),
    (
        "<emitter type=\"point\">",
        "<emitter type=\"area\" id=\"spare\"/><emitter type=\"point\">",
        "this area emitter belongs to no shape",
    ),
    (
        "<emitter type=\"point\">",
        "<alias id=\"part\" as=\"sun\"/><emitter type=\"point\">",
        "the id `sun` is already defined in line 88",
    ),
    (
        "<emitter type=\"point\">",
        "<alias id=\"nothing\" as=\"all\"/><emitter type=\"point\">",
        "no element has the id `nothing`",
    ),
    (
        "<emitter type=\"point\">",
        "<shape type=\"instance\"><ref id=\"ball\"/></shape><emitter type=\"point\">",
        "this instance refers to no group of shapes",
    ),
    (
        "type=\"irradiancemeter\"",
        "type=\"radiancemeter\"",
        "a sensor of type `radiancemeter` is not supported",
    ),
];

#[test]
fn what_cannot_be_said_is_named_with_its_line() {
    // An element that lacks something, or is wrong as a whole, is reported at its head.
    check_each(EVERYTHING, FILE, CASES, 6);
}

#[test]
fn a_two_sided_lamp_cannot_be_said() {
    let text = EVERYTHING.replace("<emitter type=\"area\">", "<ref id=\"white\"/><emitter type=\"area\">");
    let found = errors(&text, FILE);
    assert_eq!(found[0].message, "a two-sided surface that emits from one side only is not supported");
}

#[test]
fn boundaries_with_different_surroundings_cannot_be_said() {
    let text = EVERYTHING.replace(
        "<shape type=\"disk\"",
        "<shape type=\"sphere\"><point name=\"center\" value=\"0, 50, 0\"/><bsdf type=\"dielectric\"/></shape><shape type=\"disk\"",
    );
    let found = errors(&text, FILE);
    assert_eq!(
        found[0].message,
        "the exterior index 1.000277 differs from the exterior index 1 of the first boundary \
         in the ambient medium"
    );
}

#[test]
fn a_text_that_is_not_xml_is_an_error_with_its_place() {
    let cases = [
        ("<scene version=\"3.0.0\">\n  <shape></scene>", 2),
        ("<scene version=\"3.0.0\">\n  <shape type=\"a\" type=\"b\"/></scene>", 2),
        ("", 1),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><scene version=\"3.0.0\"/>", 1),
        ("<box/>", 1),
    ];
    for (text, line) in cases {
        assert_eq!(errors(text, FILE)[0].line, line, "{text}");
    }
    let deep = format!("<scene version=\"3.0.0\">{}", "<shape>".repeat(100_000));
    assert!(!errors(&deep, FILE).is_empty());
    let deep = format!("{}{}", "<shape type=\"a\">".repeat(100_000), "</shape>".repeat(100_000));
    assert!(!errors(&format!("<scene version=\"3.0.0\">{deep}</scene>"), FILE).is_empty());
}

#[test]
fn parameters_that_double_each_other_end_in_an_error() {
    let mut text = String::from("<scene version=\"3.0.0\"><default name=\"p0\" value=\"1, 1\"/>");
    for i in 0..64 {
        text += &format!("<default name=\"p{}\" value=\"$p{i}, $p{i}\"/>", i + 1);
    }
    let found = errors(&(text + "</scene>"), FILE);
    assert_eq!(found[0].message, "the value is too long after substitution of parameters");
}

#[test]
fn references_in_a_circle_are_an_error() {
    let text = "<scene version=\"3.0.0\"><bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf></scene>";
    assert_eq!(errors(text, FILE)[0].message, "a bsdf of type `twosided` cannot be two-sided");
    let text = "<scene version=\"3.0.0\"><default name=\"k\" value=\"twosided\"/>\
                <bsdf type=\"$k\" id=\"a\"><ref id=\"a\"/></bsdf></scene>";
    assert_eq!(errors(text, FILE)[0].message, "a bsdf of type `twosided` cannot be two-sided");
}
