//! Solver settings: parses `[solve]` of the file into a tolerance, a seed and forced effects.

use super::effect::{Effect, Force, ForcedEffect};
use super::element::Element;
use super::error::Report;
use super::model::Solve;
use super::value::{Domain, LARGEST_WHOLE, Value, number};
use toml::de::{DeTable, DeValue};

pub(super) const TOLERANCE: Domain =
    Domain { expected: "a number above 0 and below 1", contains: |x| x > 0.0 && x < 1.0 };
pub(super) const SEED: Domain = Domain {
    expected: "an integer from 0 to 2^53",
    contains: |x| x.fract() == 0.0 && (0.0..=LARGEST_WHOLE).contains(&x),
};
const ORDERS: Domain = Domain {
    expected: "\"on\", \"off\", or an integer number of orders",
    contains: |x| x.fract() == 0.0 && (0.0..=1e9).contains(&x),
};

pub(super) fn read(report: &mut Report, root: &DeTable) -> Solve {
    let mut solve = Solve::default();
    let Some(value) = root.get("solve") else { return solve };
    let Some(element) = Element::single(report, value, "table [solve]", "`solve`", "[solve]") else {
        return solve;
    };
    element.check_keys(report, &["tolerance", "seed", "effects"]);
    let mut checked = |key: &str, domain: &Domain| {
        element.optional(key).and_then(|value| number(report, value, &format!("`{key}`"), domain))
    };
    if let Some(tolerance) = checked("tolerance", &TOLERANCE) {
        solve.tolerance = tolerance;
    }
    if let Some(seed) = checked("seed", &SEED) {
        solve.seed = seed as u64;
    }
    if let Some(value) = element.optional("effects") {
        solve.forced = effects(report, value);
    }
    solve
}

fn effects(report: &mut Report, value: &Value) -> Vec<ForcedEffect> {
    const EXPECTED: &str = "effects = { interreflection = \"off\" }";
    let Some(element) = Element::single(report, value, "table of effects", "`effects`", EXPECTED) else {
        return Vec::new();
    };
    forced(report, &element)
}

/// Returns the effects that the keys of an element force, in the order of [`Effect::ALL`].
pub(super) fn forced(report: &mut Report, element: &Element) -> Vec<ForcedEffect> {
    element.check_keys(report, &Effect::ALL.map(|(name, _)| name));
    let forced = |(name, effect): (&str, Effect)| {
        let value = element.optional(name)?;
        let force = force(report, value, name, effect)?;
        Some(ForcedEffect { effect, force, place: report.place(value.span()) })
    };
    Effect::ALL.into_iter().filter_map(forced).collect()
}

fn force(report: &mut Report, value: &Value, name: &str, effect: Effect) -> Option<Force> {
    let expected = if effect.has_orders() { ORDERS.expected } else { "\"on\" or \"off\"" };
    match value.get_ref() {
        DeValue::String(text) if text == "on" => Some(Force::On),
        DeValue::String(text) if text == "off" => Some(Force::Off),
        DeValue::String(text) => {
            report.error(value.span(), format!("the effect `{name}` cannot be `{text}`"), expected);
            None
        }
        DeValue::Integer(_) | DeValue::Float(_) if !effect.has_orders() => {
            report.error(value.span(), format!("the effect `{name}` has no orders"), expected);
            None
        }
        _ => number(report, value, &format!("the effect `{name}`"), &ORDERS).map(|orders| match orders {
            0.0 => Force::Off,
            _ => Force::Orders(orders as u32),
        }),
    }
}
