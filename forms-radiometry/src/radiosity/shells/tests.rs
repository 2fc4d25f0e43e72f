//! Light between concentric spheres is that of the textbook, and what elements find.

use super::{Side, all_orders};
use crate::answer::Answer;
use crate::plan::method::Method;
use crate::scene::read;
use crate::simulation::{Unwatched, plan, simulate};
use forms_testing::SplitMix;
use forms_testing::scene_text::elements::{probe, ray, sphere, two_sided};
use forms_testing::scene_text::{material, point_receiver, surface};

fn answers(text: &str) -> Vec<Answer> {
    let scene = read(text, "shells.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    assert_eq!(plan.methods(), [Method::ClosedForms], "{text}");
    simulate(&plan, &Unwatched).answers
}

fn on(surface: &str) -> String {
    format!("[[receiver]]\nname = \"on {surface}\"\nkind = \"surface\"\nsurface = \"{surface}\"\n")
}

/// Net exchange of two concentric grey spheres with the emissivities ε₁, ε₂:
/// Q = A₁ (M₁ − M₂)/(1/ε₁ + (1/ε₂ − 1) (r₁/r₂)²), M the exitances of black surfaces.
#[test]
fn two_concentric_spheres_exchange_what_the_textbook_says() {
    let mut random = SplitMix(1);
    for _ in 0..60 {
        let [e1, e2] = [random.between([0.01, 1.0]), random.between([0.01, 1.0])];
        let [m1, m2] = [random.between([0.0, 5.0]), random.between([0.0, 5.0])];
        let (r1, r2) = (random.between([0.01, 1.0]), random.between([1.0, 20.0]));
        let shell = |name: &str, radius: f64, inward: bool, exitance: f64| {
            surface(name, name, &sphere([0.3, -0.2, 7.0], radius, inward))
                + &format!("exitance = {exitance:e}\n")
        };
        let text = material("inner", 1.0 - e1)
            + &material("outer", 1.0 - e2)
            + &shell("inner", r1, false, e1 * m1)
            + &shell("outer", r2, true, e2 * m2)
            + &on("inner")
            + &on("outer");
        let found = answers(&text);
        let area = 4.0 * std::f64::consts::PI * r1 * r1;
        let expected = area * (m1 - m2) / (1.0 / e1 + (1.0 / e2 - 1.0) * (r1 / r2).powi(2));
        // what is emitted less what is absorbed
        let net = |flux: &Answer, emissivity: f64, exitance: f64, area: f64| {
            (emissivity * (exitance * area - flux.value), emissivity * (flux.error + 1e-14 * flux.value))
        };
        let (inner, error) = net(&found[1], e1, m1, area);
        assert!((inner - expected).abs() <= error + 1e-13 * area * (m1 + m2), "{inner}, {expected}\n{text}");
        let (outer, error) = net(&found[3], e2, m2, area * (r2 / r1).powi(2));
        let scale = area * (r2 / r1).powi(2) * (m1 + m2);
        assert!((outer + expected).abs() <= error + 1e-13 * scale, "{outer}, {expected}\n{text}");
    }
}

/// Returns nested spheres, one of them two-sided, with receivers in each gap, and these settings.
fn nested(settings: &str) -> String {
    let materials = [("dark", 0.1), ("grey", 0.5), ("light", 0.8)];
    let materials: String = materials.map(|(name, reflectance)| material(name, reflectance)).concat();
    let shell = |name: &str, of: &str, radius: f64, inward: bool, radiance: f64| {
        surface(name, of, &sphere([0.1, 0.2, 0.3], radius, inward)) + &format!("radiance = {radiance:?}\n")
    };
    let middle =
        two_sided(&surface("middle", "grey", &sphere([0.1, 0.2, 0.3], 1.0, true))) + "\nradiance = 0.5\n";
    let receivers = point_receiver("inside", [0.3, 0.2, 0.8], [0.6, 0.0, -0.8])
        + &point_receiver("between", [0.1, 1.7, 0.3], [0.0, -0.6, 0.8])
        + &probe("probe", [1.6, 0.2, 0.3])
        + &ray("in", [1.6, 0.2, 0.3], [-1.0, 0.0, 0.0])
        + &ray("by", [1.6, 0.2, 0.3], [0.0, 0.0, 1.0])
        + &point_receiver("outside", [4.0, 0.2, 0.3], [-1.0, 0.0, 0.0]);
    [
        materials,
        shell("core", "light", 0.4, false, 1.0),
        middle,
        shell("shell", "light", 2.0, true, 0.0),
        shell("cover", "dark", 3.0, false, 2.0),
        on("core"),
        on("middle"),
        on("shell"),
        on("cover"),
        receivers,
        "[ambient]\nradiance = 0.3\n[solve]\ntolerance = 0.02\n".to_owned(),
        settings.to_owned(),
    ]
    .concat()
}

/// A small black square, far away, takes the closed form from a scene.
#[test]
fn nested_spheres_have_the_light_that_other_methods_find() {
    let speck = "[[surface]]\nname = \"speck\"\nmaterial = \"dark\"
        polygon = [[90, 0, 0], [90.001, 0, 0], [90, 0.001, 0]]\n";
    for effects in [
        "",
        "interreflection = 1",
        "interreflection = \"off\"",
        "direct = \"off\"",
        "direct = \"off\", interreflection = 2",
        "direct = \"off\", interreflection = \"off\"",
    ] {
        let text = nested(&format!("effects = {{ {effects} }}\n"));
        let exact = answers(&text);
        let scene =
            read(&(speck.to_owned() + &text), "speck.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        assert_ne!(plan.methods(), [Method::ClosedForms]);
        for (exact, other) in exact.iter().zip(simulate(&plan, &Unwatched).answers) {
            let off = (exact.value - other.value).abs();
            let allowed = 5.0 * other.error + 1e-5 * exact.value.abs() + exact.error;
            assert!(off <= allowed, "{effects}: {exact:?}\n{other:?}");
            assert!(exact.error <= 1e-12 * (1.0 + exact.value.abs()));
        }
    }
}

#[test]
fn a_gap_without_light_stays_dark_even_if_nothing_is_absorbed() {
    let white = Side { emitted: 0.0, reflectance: 1.0 };
    assert_eq!(all_orders([white; 2], [0.25, 0.75]), [0.0; 2]);
}
