//! Textures of Mitsuba 3 by images, and checkerboards on round shapes: the radiance of a place is that of
//! its reflectance.

use crate::shown;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use forms_radiometry::scene::{MaterialKind, Scene, SceneError, not_simulated, read_with_files};
use forms_radiometry::simulation::{Unwatched, plan, simulate};
use std::f64::consts::PI;

const SUN: &str = "<emitter type=\"directional\"><vector name=\"direction\" value=\"0, 0, -1\"/>\
    <float name=\"irradiance\" value=\"1\"/></emitter>";
const SKY: &str = "<emitter type=\"constant\"/>";
/// A JPEG file of 8 × 8 pixels (200, 100, 50).
const JPEG: &str = "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEB\
    AQEBAQEBAQEBAQEBAQH/2wBDAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEB\
    AQEBAQEBAQH/wAARCAAIAAgDAREAAhEBAxEB/8QAHwAAAQUBAQEBAQEAAAAAAAAAAAECAwQFBgcICQoL/8QAtRAAAgEDAwIEAwUF\
    BAQAAAF9AQIDAAQRBRIhMUEGE1FhByJxFDKBkaEII0KxwRVS0fAkM2JyggkKFhcYGRolJicoKSo0NTY3ODk6Q0RFRkdISUpTVFVW\
    V1hZWmNkZWZnaGlqc3R1dnd4eXqDhIWGh4iJipKTlJWWl5iZmqKjpKWmp6ipqrKztLW2t7i5usLDxMXGx8jJytLT1NXW19jZ2uHi\
    4+Tl5ufo6erx8vP09fb3+Pn6/8QAHwEAAwEBAQEBAQEBAQAAAAAAAAECAwQFBgcICQoL/8QAtREAAgECBAQDBAcFBAQAAQJ3AAEC\
    AxEEBSExBhJBUQdhcRMiMoEIFEKRobHBCSMzUvAVYnLRChYkNOEl8RcYGRomJygpKjU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVm\
    Z2hpanN0dXZ3eHl6goOEhYaHiImKkpOUlZaXmJmaoqOkpaanqKmqsrO0tba3uLm6wsPExcbHyMnK0tPU1dbX2Nna4uPk5ebn6Onq\
    8vP09fb3+Pn6/9oADAMBAAIRAxEAPwDn6/yvP9sD/9k=";

fn read(elements: &str, file: &[u8]) -> Result<Scene, Vec<SceneError>> {
    let text = format!("<scene version=\"3.0.0\">{elements}</scene>");
    read_with_files(&text, "box.xml", &|_| Ok(file.to_vec()))
}

fn first_error(elements: &str, file: &[u8]) -> String {
    read(elements, file).map(|_| ()).expect_err("the scene has an error")[0].message.clone()
}

/// Returns a PNG file of two by two pixels.
fn image(color: png::ColorType, pixels: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(pixels).unwrap();
    bytes
}

/// Returns the radiances, in each band, with their errors, of the place that an eye above sees.
fn radiances(elements: &str, file: &[u8], [x, y]: [f64; 2]) -> Vec<[f64; 2]> {
    let eye = format!(
        "<sensor type=\"orthographic\"><transform name=\"to_world\"><scale value=\"0.001\"/>\
         <lookat origin=\"{x}, {y}, 3\" target=\"{x}, {y}, 0\" up=\"0, 1, 0\"/></transform>\
         <film type=\"hdrfilm\"><integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/>\
         </film></sensor>"
    );
    let scene =
        read(&(elements.to_owned() + &eye), file).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    assert_eq!(not_simulated(&scene), []);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    simulate(&plan, &Unwatched).answers.iter().map(|answer| [answer.value, answer.error]).collect()
}

fn linear(byte: u8) -> f64 {
    let value = f64::from(byte) / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

fn textured(shape: &str, texture: &str) -> String {
    format!(
        "<shape type=\"{shape}\" id=\"it\"><bsdf type=\"diffuse\"><texture name=\"reflectance\" \
         type=\"bitmap\"><string name=\"filename\" value=\"wood.png\"/>{texture}</texture></bsdf></shape>"
    )
}

/// Checks the radiance in the light of the sun at places against reflectances.
fn check(elements: &str, file: &[u8], places: &[([f64; 2], [f64; 3])]) {
    for &(place, expected) in places {
        let found = radiances(&(elements.to_owned() + SUN), file, place);
        assert_eq!(found.len(), 3);
        for ([value, error], reflectance) in found.into_iter().zip(expected) {
            let difference = (value - reflectance / PI).abs();
            assert!(
                difference <= 4.0 * error + 2e-3 * reflectance + 1e-3,
                "{place:?}: {value}, {reflectance}/π"
            );
        }
    }
}

const NEAREST: &str = "<string name=\"filter_type\" value=\"nearest\"/>";
/// Red and green above, blue and a dark grey below; v = 0 is above in an image, and below on a shape.
const COLOURS: [u8; 12] = [255, 0, 0, 0, 200, 0, 0, 0, 100, 30, 30, 30];

#[test]
fn the_pixels_of_an_image_are_reflectances() {
    let file = image(png::ColorType::Rgb, &COLOURS);
    let dark = [linear(30); 3];
    let places = [
        ([-0.5, -0.5], [1.0, 0.0, 0.0]),
        ([0.5, -0.5], [0.0, linear(200), 0.0]),
        ([-0.5, 0.5], [0.0, 0.0, linear(100)]),
        ([0.5, 0.5], dark),
    ];
    check(&textured("rectangle", NEAREST), &file, &places);
    // the centres of pixels, and the middle of all
    check(&textured("rectangle", ""), &file, &places);
    let middle = [(1.0 + dark[0]) / 4.0, (linear(200) + dark[0]) / 4.0, (linear(100) + dark[0]) / 4.0];
    check(&textured("rectangle", ""), &file, &[([0.0, 0.0], middle)]);
    // half of the image to the right: the left half shows the right column again
    let shifted = "<transform name=\"to_uv\"><translate x=\"0.5\"/></transform>";
    check(&textured("rectangle", &(NEAREST.to_owned() + shifted)), &file, &[([-0.5, 0.5], dark)]);
    let clamped = format!("{NEAREST}{shifted}<string name=\"wrap_mode\" value=\"clamp\"/>");
    check(&textured("rectangle", &clamped), &file, &[([0.9, 0.5], dark), ([0.1, 0.5], dark)]);
}

#[test]
fn images_can_be_grey_linear_or_transparent_and_in_jpeg_files() {
    let grey = image(png::ColorType::Grayscale, &[0, 0, 128, 255]);
    check(&textured("rectangle", NEAREST), &grey, &[([-0.5, 0.5], [linear(128); 3])]);
    let raw = format!("{NEAREST}<boolean name=\"raw\" value=\"true\"/>");
    check(&textured("rectangle", &raw), &grey, &[([-0.5, 0.5], [128.0 / 255.0; 3])]);
    let pair = image(png::ColorType::GrayscaleAlpha, &[0, 9, 0, 9, 128, 0, 255, 9]);
    check(&textured("rectangle", NEAREST), &pair, &[([-0.5, 0.5], [linear(128); 3])]);
    let jpeg = BASE64_STANDARD.decode(JPEG).unwrap();
    check(&textured("rectangle", ""), &jpeg, &[([0.3, 0.2], [200, 100, 50].map(linear))]);
}

/// The base of plastic with `nonlinear` reflects like one of the reflectance of the place everywhere.
#[test]
fn plastic_with_an_image_reflects_as_plastic_of_the_colour_of_the_place() {
    let file = image(png::ColorType::Grayscale, &[255, 255, 128, 255]);
    let plastic = |kind: &str, reflectance: &str| {
        format!(
            "<shape type=\"rectangle\"><bsdf type=\"{kind}\"><boolean name=\"nonlinear\" value=\"true\"/>\
             {reflectance}</bsdf></shape>{SKY}"
        )
    };
    let texture = format!(
        "<texture name=\"diffuse_reflectance\" type=\"bitmap\"><string name=\"filename\" value=\"a.png\"/>\
         {NEAREST}</texture>"
    );
    let same = format!("<float name=\"diffuse_reflectance\" value=\"{}\"/>", linear(128));
    for kind in ["plastic", "roughplastic"] {
        let [value, error] = radiances(&plastic(kind, &texture), &file, [-0.5, 0.5])[0];
        let [expected, other] = radiances(&plastic(kind, &same), &file, [-0.5, 0.5])[0];
        assert!((value - expected).abs() <= 4.0 * (error + other), "{kind}: {value}, {expected}");
    }
}

fn board(shape: &str, scale: &str) -> String {
    format!(
        "<shape type=\"{shape}\" id=\"it\"><bsdf type=\"diffuse\"><texture name=\"reflectance\" \
         type=\"checkerboard\"><rgb name=\"color0\" value=\"0.5\"/><rgb name=\"color1\" value=\"0.2, 0.3, 0.4\"/>\
         <transform name=\"to_uv\"><scale {scale}/></transform></texture></bsdf></shape>"
    )
}

/// The fields follow from the texture coordinates of Mitsuba 3.9.1.
#[test]
fn spheres_disks_and_cubes_have_checkerboards() {
    let [first, second] = [[0.5; 3], [0.2, 0.3, 0.4]];
    let ten = "x=\"10\" y=\"10\"";
    let cosine = (1.0_f64 - 0.13).sqrt();
    let tilted = |colour: [f64; 3]| colour.map(|part| cosine * part);
    check(&board("sphere", ten), b"", &[([0.3, 0.2], tilted(second)), ([0.3, -0.2], tilted(first))]);
    check(&board("disk", ten), b"", &[([0.3, 0.2], first), ([0.3, -0.2], second)]);
    let cube = board("cube", "x=\"1.5\" y=\"1\"");
    check(&cube, b"", &[([0.2, -0.2], first), ([0.2, 0.9], second)]);
    assert_eq!(
        first_error(&board("cylinder", ten), b""),
        "the shape `it` has no texture coordinates here, which is not supported"
    );
}

#[test]
fn the_material_of_a_texture_has_its_largest_reflectance() {
    let file = image(png::ColorType::Rgb, &COLOURS);
    let scene = read(&textured("disk", NEAREST), &file).unwrap();
    let MaterialKind::Diffuse { reflectance } = &scene.materials[0].kind else { panic!("diffuse") };
    let expected = [1.0, linear(200), linear(100)];
    assert!(reflectance.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-7));
    assert!(scene.surfaces[0].texture.is_some());
}

#[test]
fn an_image_that_cannot_be_read_is_an_error() {
    let square = |texture: &str| textured("rectangle", texture);
    let found = first_error(&square(""), b"no image");
    assert!(found.starts_with("the image `wood.png` cannot be read: "), "{found}");
    let file = image(png::ColorType::Rgb, &COLOURS);
    let cubic = "<string name=\"filter_type\" value=\"cubic\"/>";
    assert_eq!(first_error(&square(cubic), &file), "`filter_type` cannot be `cubic`");
    assert_eq!(
        first_error(
            "<texture type=\"bitmap\" id=\"a\"/><shape type=\"disk\"><bsdf type=\"diffuse\">\
             <ref name=\"reflectance\" id=\"a\"/></bsdf></shape>",
            b""
        ),
        "this texture of type `bitmap` has no `filename`"
    );
    let gloss = "<shape type=\"disk\"><bsdf type=\"conductor\"><texture name=\"specular_reflectance\" \
        type=\"bitmap\"><string name=\"filename\" value=\"a.png\"/></texture></bsdf></shape>";
    assert_eq!(first_error(gloss, &file), "a texture of type `bitmap` is not supported");
}
