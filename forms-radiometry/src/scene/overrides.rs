//! Overrides of solver settings: parses the texts of command-line options into a tolerance, a seed
//! and forced effects that replace those of a scene. Settings without an option keep the value of
//! the scene. Options and `[solve]` of a scene file accept the same values.

use super::effect::{Effect, ForcedEffect};
use super::element::Element;
use super::error::Report;
use super::model::Scene;
use super::place::Source;
use super::solve::{self, SEED, TOLERANCE};
use super::value::{Domain, Value, plain_number};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The option that forces effects, as it appears in errors.
const OPTION: &str = "--effects";
/// An example value of that option.
const EXAMPLE: &str = "effect=value, for example interreflection=2,occlusion=off";

/// Settings that replace those of a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Overrides {
    /// The tolerance, if it is replaced.
    pub tolerance: Option<f64>,
    /// The seed, if it is replaced.
    pub seed: Option<u64>,
    /// The effects that are forced instead of their settings in the scene.
    pub effects: Option<EffectList>,
}

/// Effects that are turned on or off, or limited to a number of orders, as in
/// `interreflection=2,occlusion=off`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct EffectList(String);

impl Overrides {
    /// Parses a tolerance. An error message states the expected value.
    pub fn tolerance(text: &str) -> Result<f64, String> {
        of_domain(text, &TOLERANCE)
    }

    /// Parses a seed. An error message states the expected value.
    pub fn seed(text: &str) -> Result<u64, String> {
        of_domain(text, &SEED).map(|seed| seed as u64)
    }

    /// Replaces the settings of a scene.
    pub fn apply(&self, scene: &mut Scene) {
        let solve = &mut scene.solve;
        solve.tolerance = self.tolerance.unwrap_or(solve.tolerance);
        solve.seed = self.seed.unwrap_or(solve.seed);
        let forced = self.effects.as_ref().map(EffectList::forced).unwrap_or_default();
        solve.forced.retain(|old| forced.iter().all(|new| new.effect != old.effect));
        solve.forced.extend(forced);
        solve
            .forced
            .sort_by_key(|forced| Effect::ALL.iter().position(|(_, effect)| *effect == forced.effect));
    }

    /// Formats the equivalent command-line options; each is preceded by a space.
    pub fn options(&self) -> String {
        let tolerance = self.tolerance.map(|tolerance| format!(" --tolerance {tolerance:?}"));
        let seed = self.seed.map(|seed| format!(" --seed {seed}"));
        let effects = self.effects.as_ref().map(|effects| format!(" {OPTION} {effects}"));
        [tolerance, seed, effects].into_iter().flatten().collect()
    }
}

impl EffectList {
    fn forced(&self) -> Vec<ForcedEffect> {
        read(&self.0).unwrap_or_default()
    }
}

impl FromStr for EffectList {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        read(text).map(|_| Self(text.to_owned()))
    }
}

impl fmt::Display for EffectList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Parses a number of a domain.
fn of_domain(text: &str, domain: &Domain) -> Result<f64, String> {
    let value = DeValue::parse(text).ok();
    let number = value.and_then(|value| plain_number(value.get_ref()));
    number.filter(|&number| (domain.contains)(number)).ok_or_else(|| format!("expected {}", domain.expected))
}

/// Parses the effects that a text forces, with their places in it. An error message contains all
/// errors of the text.
fn read(text: &str) -> Result<Vec<ForcedEffect>, String> {
    let source = Source::of_option(OPTION, text);
    let mut report = Report::new(&source);
    let table = table(&mut report, text);
    let element = Element { kind: "list of effects", table: &table, place: 0..text.len() };
    let forced = solve::forced(&mut report, &element);
    if report.is_empty() {
        return Ok(forced);
    }
    let messages = report.into_errors().into_iter();
    let messages = messages.map(|error| format!("{}: expected {}", error.message, error.expected));
    Err(messages.collect::<Vec<_>>().join("; "))
}

/// Builds the equivalent table of a scene file.
fn table<'t>(report: &mut Report, text: &'t str) -> DeTable<'t> {
    let mut table = DeTable::new();
    let mut start = 0;
    for item in text.split(',') {
        let range = start..start + item.len();
        start = range.end + 1;
        let Some((name, value)) = item.split_once('=') else {
            report.error(range, format!("`{item}` has no value"), EXAMPLE);
            continue;
        };
        let middle = range.start + name.len();
        let name = Cow::Borrowed(name.trim());
        let value: Value = Spanned::new(middle + 1..range.end, of_word(value.trim()));
        if table.contains_key(name.as_ref()) {
            report.error(range, format!("the effect `{name}` is given twice"), "each effect once");
        } else {
            table.insert(Spanned::new(range.start..middle, name), value);
        }
    }
    table
}

/// Parses a number, or else a text.
fn of_word(word: &str) -> DeValue<'_> {
    let number = DeValue::parse(word).ok().map(Spanned::into_inner);
    let number = number.filter(|value| plain_number(value).is_some());
    number.unwrap_or(DeValue::String(Cow::Borrowed(word)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Force, read as read_scene};

    fn list(text: &str) -> EffectList {
        text.parse().expect("effects")
    }

    #[test]
    fn a_list_says_what_a_scene_file_says() {
        let file = "[solve]\neffects = { occlusion = \"off\", interreflection = 2, bands = \"on\", scattering = 0 }\n";
        let in_file = read_scene(file, "scene.toml").expect("a scene").solve.forced;
        let in_list = list("bands=on, interreflection=2,scattering=0,occlusion=off").forced();
        let effects = |forced: &[ForcedEffect]| -> Vec<_> {
            forced.iter().map(|forced| (forced.effect, forced.force)).collect()
        };
        assert_eq!(effects(&in_list), effects(&in_file));
        assert_eq!(in_list.iter().map(|forced| forced.place.is_option()).collect::<Vec<_>>(), [true; 4]);
    }

    #[test]
    fn what_is_given_replaces_what_the_scene_says_and_the_rest_stays() {
        let file =
            "[solve]\ntolerance = 0.1\nseed = 3\neffects = { occlusion = \"off\", interreflection = 2 }\n";
        let mut scene = read_scene(file, "scene.toml").expect("a scene");
        Overrides::default().apply(&mut scene);
        assert_eq!((scene.solve.tolerance, scene.solve.seed), (0.1, 3));
        let effects = Some(list("interreflection=off,direct=on"));
        let overrides = Overrides { tolerance: Some(0.01), seed: Some(7), effects };
        overrides.apply(&mut scene);
        assert_eq!((scene.solve.tolerance, scene.solve.seed), (0.01, 7));
        let forced: Vec<_> = scene.solve.forced.iter().map(|forced| (forced.effect, forced.force)).collect();
        let expected = [
            (Effect::Direct, Force::On),
            (Effect::Occlusion, Force::Off),
            (Effect::Interreflection, Force::Off),
        ];
        assert_eq!(forced, expected);
        assert_eq!(overrides.options(), " --tolerance 0.01 --seed 7 --effects interreflection=off,direct=on");
    }

    #[test]
    fn wrong_values_are_named_with_what_was_expected() {
        let cases = [
            ("occlusion", "`occlusion` has no value: expected effect=value, for example"),
            ("", "`` has no value"),
            ("occlusion=maybe", "the effect `occlusion` cannot be `maybe`: expected \"on\" or \"off\""),
            ("occlusion=2", "the effect `occlusion` has no orders: expected \"on\" or \"off\""),
            (
                "interreflection=-1",
                "the effect `interreflection` is out of range: expected \"on\", \"off\", or",
            ),
            ("interreflection=0.5", "the effect `interreflection` is out of range"),
            ("shade=on", "unknown key `shade` in a list of effects: expected `direct`, `occlusion`"),
            ("direct=on,direct=off", "the effect `direct` is given twice: expected each effect once"),
        ];
        for (text, message) in cases {
            let found = text.parse::<EffectList>().expect_err(text);
            assert!(found.starts_with(message), "{text}: {found}");
        }
        for text in ["0", "1", "-1e-3", "nan", "inf", "1e999", "small", ""] {
            assert_eq!(Overrides::tolerance(text), Err("expected a number above 0 and below 1".to_owned()));
        }
        for text in ["-1", "0.5", "1e16", "9007199254740994", "one", ""] {
            let expected = Err("expected an integer from 0 to 2^53".to_owned());
            assert_eq!(Overrides::seed(text), expected, "{text}");
        }
        assert_eq!(
            (Overrides::tolerance("1e-5"), Overrides::seed("9007199254740992")),
            (Ok(1e-5), Ok(1 << 53))
        );
    }
}
