//! What a scene asks of the solver: checked, so that nothing asked for is silently left out.
//!
//! Direct light is computed exactly and without random numbers, so it keeps to any tolerance and any seed.

use super::element::Element;
use super::error::Report;
use super::value::{Domain, Value, number};
use toml::de::{DeTable, DeValue};

const TOLERANCE: Domain =
    Domain { expected: "a number above 0 and below 1", contains: |x| x > 0.0 && x < 1.0 };
const SEED: Domain =
    Domain { expected: "a whole number of at least 0", contains: |x| x >= 0.0 && x.fract() == 0.0 };
const ORDERS: Domain = Domain {
    expected: "\"on\", \"off\", or a whole number of orders",
    contains: |x| x >= 0.0 && x.fract() == 0.0,
};

/// The effects that a scene file can force, and whether they are simulated.
const EFFECTS: [(&str, bool); 8] = [
    ("direct", true),
    ("occlusion", true),
    ("interreflection", false),
    ("scattering", false),
    ("absorption", false),
    ("mirror", false),
    ("refraction", false),
    ("dispersion", false),
];

pub(super) fn check(report: &mut Report, root: &DeTable) {
    let Some(value) = root.get("solve") else { return };
    let Some(table) = value.get_ref().as_table() else {
        report.error(value.span(), "`solve` is not a table", "[solve]");
        return;
    };
    let element = Element { kind: "solve", table, place: value.span() };
    element.check_keys(report, &["tolerance", "seed", "effects"], &[]);
    for (key, domain) in [("tolerance", TOLERANCE), ("seed", SEED)] {
        if let Some(value) = element.optional(key) {
            number(report, value, &format!("`{key}`"), &domain);
        }
    }
    if let Some(value) = element.optional("effects") {
        effects(report, value);
    }
}

fn effects(report: &mut Report, value: &Value) {
    let Some(table) = value.get_ref().as_table() else {
        report.error(value.span(), "`effects` is not a table", "effects = { interreflection = \"off\" }");
        return;
    };
    let element = Element { kind: "table of effects", table, place: value.span() };
    element.check_keys(report, &EFFECTS.map(|(name, _)| name), &[]);
    for (name, simulated) in EFFECTS {
        let Some(value) = element.optional(name) else { continue };
        let Some(on) = forced(report, value, name) else { continue };
        if on && !simulated {
            report.error(value.span(), format!("the effect `{name}` is not supported yet"), "\"off\"");
        } else if !on && simulated {
            report.error(
                value.span(),
                format!("leaving out the effect `{name}` is not supported yet"),
                "\"on\"",
            );
        }
    }
}

/// Whether an effect is forced on.
fn forced(report: &mut Report, value: &Value, name: &str) -> Option<bool> {
    match value.get_ref() {
        DeValue::String(text) if text == "on" => Some(true),
        DeValue::String(text) if text == "off" => Some(false),
        DeValue::String(text) => {
            report.error(value.span(), format!("the effect `{name}` cannot be `{text}`"), ORDERS.expected);
            None
        }
        _ => number(report, value, &format!("the effect `{name}`"), &ORDERS).map(|orders| orders > 0.0),
    }
}
