//! Spectra: a table over wavelength, or Planck’s law, becomes its mean in each band.

use super::metals::METALS;
use super::{Node, RGB, Reader};
use crate::scene::model::Band;
use crate::scene::value::{Domain, within};
use forms_kernels::planck;
use std::ops::Range;

/// An entry of a table: a wavelength in nm and the value there.
#[derive(Clone, Copy)]
struct Entry {
    wavelength: f64,
    value: f64,
}

const TABLE: &str = "wavelength:value pairs in nm, with increasing wavelengths";
const TEMPERATURE: Domain =
    Domain { expected: "a temperature in K, above 0 and up to 1e6", contains: |x| x > 0.0 && x <= 1e6 };

/// Whether a property has a value for each band: a colour, a table, a black body, the name of a metal,
/// an image, or an environment map.
pub(super) fn has_bands(node: Node, value: impl Fn(&str) -> Option<String>) -> bool {
    let is_table = || node.attribute("value").and_then(value).is_some_and(|value| value.contains(':'));
    match node.tag_name().name() {
        "rgb" => true,
        "string" => node.attribute("name") == Some("material") && is_metal(node),
        "emitter" => node.attribute("type") == Some("envmap"),
        "texture" => node.attribute("type") == Some("bitmap"),
        "spectrum" => node.attribute("type") == Some("blackbody") || is_table(),
        _ => false,
    }
}

/// Whether a name is that of a metal, and not of a perfect mirror.
fn is_metal(node: Node) -> bool {
    METALS.iter().any(|metal| node.attribute("value") == Some(metal.name))
}

impl<'a> Reader<'a, '_, '_> {
    /// Returns the mean of a table in each band.
    pub(super) fn table(
        &mut self,
        text: &str,
        place: &Range<usize>,
        what: &str,
        domain: &Domain,
    ) -> Option<Vec<f64>> {
        let mut entries: Vec<Entry> = Vec::new();
        let words = text.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
        for word in words {
            let entry = word.split_once(':').and_then(|(wavelength, value)| {
                Some(Entry { wavelength: wavelength.parse().ok()?, value: value.parse().ok()? })
            });
            let last = entries.last().map_or(0.0, |entry| entry.wavelength);
            let follows = |entry: &Entry| entry.wavelength.is_finite() && entry.wavelength > last;
            let Some(entry) = entry.filter(follows) else {
                let message = format!("`{word}` is not the next entry of a spectrum");
                self.report.error(place.clone(), message, TABLE);
                return None;
            };
            within(self.report, place.clone(), what, entry.value, domain)?;
            entries.push(entry);
        }
        self.has_tables = true;
        self.means(place, what, domain, |band| table_mean(&entries, band))
    }

    /// Returns the mean of Planck’s law in each band, in W/(m² sr nm).
    pub(super) fn black_body(&mut self, node: Node<'a>, what: &str, domain: &Domain) -> Option<Vec<f64>> {
        let mut object = self.object(node);
        if object.kind != "blackbody" {
            self.unknown(&mut object, &["blackbody"]);
            return None;
        }
        if !object.has("temperature") {
            self.error(node, "this spectrum has no `temperature`", "a float in K");
        }
        let temperature = self.float(&mut object, "temperature", 6500.0, &TEMPERATURE);
        self.finish(object, &["temperature"]);
        self.has_tables = true;
        self.means(&node.range(), what, domain, |band| black_body_mean(temperature, band))
    }

    fn means(
        &mut self,
        place: &Range<usize>,
        what: &str,
        domain: &Domain,
        mean: impl Fn(Band) -> f64,
    ) -> Option<Vec<f64>> {
        let what = format!("the mean of {what} in a band");
        RGB.iter().map(|&band| within(self.report, place.clone(), &what, mean(band), domain)).collect()
    }
}

/// Returns the mean over a band of a table, linear between its entries and zero outside.
fn table_mean(entries: &[Entry], band: Band) -> f64 {
    let integral = |pair: &[Entry]| {
        let [start, end] = [pair[0], pair[1]];
        let (low, high) = (start.wavelength.max(band.low), end.wavelength.min(band.high));
        let at = |wavelength: f64| {
            let t = (wavelength - start.wavelength) / (end.wavelength - start.wavelength);
            start.value + t * (end.value - start.value)
        };
        if low < high { 0.5 * (at(low) + at(high)) * (high - low) } else { 0.0 }
    };
    entries.windows(2).map(integral).sum::<f64>() / (band.high - band.low)
}

/// Returns the mean over a band of the spectral radiance of a black body in W/(m² sr nm), by
/// Simpson’s rule.
fn black_body_mean(temperature: f64, band: Band) -> f64 {
    const INTERVALS: usize = 200;
    let radiance = |nanometres: f64| 1e-9 * planck(1e-9 * nanometres, temperature);
    let step = (band.high - band.low) / INTERVALS as f64;
    let weighted = |i: usize| {
        let weight = match i {
            0 | INTERVALS => 1.0,
            _ if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * radiance(band.low + step * i as f64)
    };
    (0..=INTERVALS).map(weighted).sum::<f64>() * step / 3.0 / (band.high - band.low)
}
