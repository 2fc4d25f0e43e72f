//! Spectra of Mitsuba 3 over wavelength: tables and black bodies are read as their means in bands.

use crate::{errors, scene};
use forms_radiometry::scene::{LightKind, Scene};

const FILE: &str = "box.xml";

/// Returns a scene with a point light of this intensity.
fn lamp(intensity: &str) -> String {
    format!("<scene version=\"3.0.0\"><emitter type=\"point\">{intensity}</emitter></scene>")
}

fn intensity(scene: &Scene) -> &[f64] {
    match &scene.lights[0].kind {
        LightKind::Point { intensity, .. } => intensity,
        LightKind::Distant { .. } => panic!("the light is a point"),
    }
}

fn table(values: &str) -> String {
    lamp(&format!("<spectrum name=\"intensity\" value=\"{values}\"/>"))
}

#[test]
fn a_table_is_its_mean_in_each_band_linear_between_entries_and_zero_outside() {
    // tables, and their means in the bands of red, green and blue
    let cases: &[(&str, [f64; 3])] = &[
        ("400:2, 700:2", [2.0, 2.0, 2.0]),
        ("400:0 500:8 600:16 700:20", [18.0, 12.0, 4.0]),
        ("300:1, 450:1", [0.0, 0.0, 0.5]),
        ("550:0, 650:4", [1.0 + 0.5, 0.5, 0.0]),
        ("600:1, 601:1", [0.01, 0.0, 0.0]),
        ("550:7", [0.0, 0.0, 0.0]),
    ];
    for (text, means) in cases {
        let scene = scene(&table(text), FILE);
        assert_eq!(scene.bands.len(), 3, "{text}");
        for (value, mean) in intensity(&scene).iter().zip(means) {
            assert!((value - mean).abs() < 1e-14, "{text}: {:?}", intensity(&scene));
        }
        let note = "spectra over wavelength are replaced by their means in the bands 600–700, 500–600 and 400–500 nm";
        assert_eq!(scene.notes, [note]);
    }
    assert_eq!(intensity(&scene(&table("7"), FILE)), [7.0]);
}

#[test]
fn a_table_that_is_out_of_order_or_out_of_range_is_an_error() {
    let cases = [
        ("400:1, 400:2", "`400:2` is not the next entry of a spectrum"),
        ("400:1, 2", "`2` is not the next entry of a spectrum"),
        ("400:x", "`400:x` is not the next entry of a spectrum"),
        ("-1:1", "`-1:1` is not the next entry of a spectrum"),
        ("400:-1", "`intensity` is out of range"),
        ("400:inf", "`intensity` is not finite"),
    ];
    for (text, message) in cases {
        assert_eq!(errors(&table(text), FILE)[0].message, message, "{text}");
    }
}

/// The mean over 500–600 nm at 5000 K is about B(550 nm) = 2hc²/λ⁵/(exp(hc/λkT) − 1) = 12.7 kW/(m²
/// sr nm); the sum over all wavelengths is σT⁴/π.
#[test]
fn a_black_body_is_its_mean_in_each_band() {
    let body = |temperature: &str| {
        lamp(&format!(
            "<spectrum type=\"blackbody\" name=\"intensity\"><float name=\"temperature\" value=\"{temperature}\"/></spectrum>"
        ))
    };
    let planck = |nanometres: f64, temperature: f64| {
        let (h, c, k) = (6.626_070_15e-34_f64, 299_792_458.0, 1.380_649e-23);
        let wavelength = 1e-9 * nanometres;
        2e-9 * h * c * c / wavelength.powi(5) / ((h * c / (wavelength * k * temperature)).exp() - 1.0)
    };
    let scene = scene(&body("5000"), FILE);
    for (value, low) in intensity(&scene).iter().zip([600, 500, 400]) {
        let mean =
            (0..10_000).map(|i| planck(f64::from(low) + (f64::from(i) + 0.5) / 100.0, 5000.0)).sum::<f64>()
                / 1e4;
        assert!((value / mean - 1.0).abs() < 1e-8, "{value} {mean}");
    }
    assert_eq!(errors(&body("-5"), FILE)[0].message, "`temperature` is out of range");
    let unknown = lamp("<spectrum type=\"d65\" name=\"intensity\"/>");
    assert_eq!(errors(&unknown, FILE)[0].message, "a spectrum of type `d65` is not supported");
}
