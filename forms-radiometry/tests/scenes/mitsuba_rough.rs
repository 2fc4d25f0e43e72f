//! Rough materials of Mitsuba 3: each reflects the light of the sun, of the sky and of a lamp as there.

use crate::{errors, scene, shown};
use forms_radiometry::scene::{Distribution, Facet, MaterialKind, not_simulated};
use forms_radiometry::simulation::{Unwatched, plan, simulate};

const FILE: &str = "box.xml";
const SKY: &str = "<emitter type=\"constant\"/>";
const SUN: &str = "<emitter type=\"directional\"><vector name=\"direction\" value=\"0.6, 0, -0.8\"/>\
    <float name=\"irradiance\" value=\"1\"/></emitter>";
const LAMP: &str = "<shape type=\"disk\"><transform name=\"to_world\"><rotate x=\"1\" angle=\"180\"/>\
    <translate z=\"2\"/></transform><emitter type=\"area\"><float name=\"radiance\" value=\"1\"/></emitter></shape>";
const BECKMANN: &str = "<bsdf type=\"roughplastic\"><float name=\"alpha\" value=\"0.3\"/>\
    <float name=\"int_ior\" value=\"1.5\"/><float name=\"ext_ior\" value=\"1\"/>\
    <float name=\"diffuse_reflectance\" value=\"0.25\"/></bsdf>";
const GGX: &str = "<bsdf type=\"roughplastic\"><string name=\"distribution\" value=\"ggx\"/>\
    <float name=\"alpha\" value=\"0.2\"/><float name=\"int_ior\" value=\"1.5\"/><float name=\"ext_ior\" value=\"1\"/>\
    <float name=\"diffuse_reflectance\" value=\"0.6\"/><float name=\"specular_reflectance\" value=\"0.5\"/>\
    <boolean name=\"nonlinear\" value=\"true\"/></bsdf>";
const METAL: &str = "<bsdf type=\"roughconductor\"><float name=\"alpha\" value=\"0.2\"/>\
    <float name=\"eta\" value=\"0.2\"/><float name=\"k\" value=\"3\"/></bsdf>";
const DULL_METAL: &str = "<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"ggx\"/>\
    <float name=\"alpha\" value=\"0.4\"/><float name=\"eta\" value=\"1.5\"/><float name=\"k\" value=\"2\"/>\
    <float name=\"specular_reflectance\" value=\"0.8\"/></bsdf>";
const MIRROR: &str = "<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"ggx\"/>\
    <float name=\"alpha_u\" value=\"0.5\"/><float name=\"alpha_v\" value=\"0.5\"/></bsdf>";

fn text(elements: &str) -> String {
    format!("<scene version=\"3.0.0\">{elements}</scene>")
}

/// Returns the radiance of a plate towards an eye at an angle whose cosine is 0.6.
fn radiance(bsdf: &str, light: &str) -> [f64; 2] {
    let eye = "<sensor type=\"orthographic\"><transform name=\"to_world\"><scale value=\"0.001\"/>\
        <lookat origin=\"2.4, 0, 1.8\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform>\
        <film type=\"hdrfilm\"><integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/>\
        </film></sensor>";
    let mut scene = scene(&text(&format!("<shape type=\"disk\">{bsdf}</shape>{light}{eye}")), FILE);
    scene.solve.tolerance = 2e-3;
    assert_eq!(not_simulated(&scene), []);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    let answer = &simulate(&plan, &Unwatched).answers[0];
    [answer.value, answer.error]
}

/// The integrals of the bidirectional reflectances of Mitsuba 3.9.1. Its transmittances of rough coats
/// are accurate to 10⁻³.
#[test]
fn rough_surfaces_reflect_as_in_mitsuba() {
    for (name, bsdf, [sun, sky, lamp]) in [
        ("Beckmann plastic", BECKMANN, [0.114_497, 0.263_712, 0.047_194]),
        ("GGX plastic", GGX, [0.120_965, 0.346_543, 0.068_077]),
        ("metal", METAL, [1.909_670, 0.909_539, 0.042_074]),
        ("dull metal", DULL_METAL, [0.209_321, 0.255_491, 0.041_586]),
        ("mirror", MIRROR, [0.414_771, 0.680_247, 0.122_236]),
    ] {
        for (light, expected) in [(SUN, sun), (SKY, sky), (LAMP, lamp)] {
            let [value, error] = radiance(bsdf, light);
            let difference = (value - expected).abs();
            assert!(difference < 4.0 * error + 2e-3 * expected, "{name}: {value} ± {error}, {expected}");
        }
    }
}

#[test]
fn rough_metals_and_plastics_are_read_with_their_defaults() {
    let kinds = |bsdf: &str| {
        let scene = scene(&text(&format!("<shape type=\"disk\"><bsdf type=\"{bsdf}\"/></shape>")), FILE);
        let MaterialKind::Rough(rough) = scene.materials[0].kind.clone() else { panic!("a rough material") };
        assert_eq!((rough.facets.distribution, rough.facets.alpha), (Distribution::Beckmann, 0.1));
        rough.facet
    };
    assert_eq!(kinds("roughconductor"), Facet::Mirror);
    assert_eq!(kinds("roughplastic"), Facet::Coat { index: 1.49 / 1.000_277 });
}

#[test]
fn roughness_that_is_not_supported_is_an_error() {
    let metal = |inside: &str| {
        let text =
            text(&format!("<shape type=\"disk\"><bsdf type=\"roughconductor\">{inside}</bsdf></shape>"));
        errors(&text, FILE)[0].message.clone()
    };
    let uneven = "<float name=\"alpha_u\" value=\"0.1\"/><float name=\"alpha_v\" value=\"0.2\"/>";
    assert_eq!(metal(uneven), "a roughness that differs between directions is not supported");
    let distribution = "<string name=\"distribution\" value=\"phong\"/>";
    assert_eq!(metal(distribution), "the distribution `phong` of microfacets is not known");
    assert_eq!(metal("<float name=\"alpha\" value=\"0\"/>"), "`alpha` is out of range");
    let texture = "<texture name=\"alpha\" type=\"checkerboard\"/>";
    assert_eq!(metal(texture), "a texture of type `checkerboard` is not supported");
}
