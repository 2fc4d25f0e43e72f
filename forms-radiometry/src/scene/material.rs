//! Materials: parses each `[[material]]` of the file into a law of reflection and transmission.

use super::element::{Element, Names};
use super::error::Report;
use super::known::Known;
use super::model::{Material, MaterialKind};
use super::value::{FRACTION, NOT_NEGATIVE, POSITIVE, choice};

#[derive(Clone, Copy)]
enum Kind {
    Diffuse,
    Mirror,
    Dielectric,
    Conductor,
}

const KINDS: [(&str, Kind); 4] = [
    ("diffuse", Kind::Diffuse),
    ("mirror", Kind::Mirror),
    ("dielectric", Kind::Dielectric),
    ("conductor", Kind::Conductor),
];

pub(super) fn read(
    report: &mut Report,
    element: &Element,
    names: &mut Names,
    known: &mut Known,
    index: usize,
) -> Option<Material> {
    let name = known.materials.name(report, element, names, index);
    let expected = "kind = \"diffuse\", \"mirror\", \"dielectric\" or \"conductor\"";
    let (kind, place) = element.text(report, "kind", expected)?;
    let kind = choice(report, place.clone(), kind, "the kind of material", &KINDS)?;
    if matches!(kind, Kind::Dielectric) {
        known.dielectrics.insert(index);
    }
    let kind = law(report, element, known, kind);
    Some(Material { name: name?, kind: kind?, place: report.place(place) })
}

fn law(report: &mut Report, element: &Element, known: &Known, kind: Kind) -> Option<MaterialKind> {
    let own: &[&str] = match kind {
        Kind::Diffuse | Kind::Mirror => &["name", "kind", "reflectance"],
        Kind::Dielectric => &["name", "kind", "inside"],
        Kind::Conductor => &["name", "kind", "eta", "k"],
    };
    element.check_keys(report, own);
    match kind {
        Kind::Diffuse | Kind::Mirror => {
            let reflectance = element.spectrum(report, "reflectance", &FRACTION, known.bands)?;
            Some(match kind {
                Kind::Mirror => MaterialKind::Mirror { reflectance },
                _ => MaterialKind::Diffuse { reflectance },
            })
        }
        Kind::Dielectric => {
            let inside =
                element.reference(report, "inside", "the name of a medium", "medium", &known.media)?;
            Some(MaterialKind::Dielectric { inside })
        }
        Kind::Conductor => {
            let eta = element.spectrum(report, "eta", &POSITIVE, known.bands);
            let k = element.spectrum(report, "k", &NOT_NEGATIVE, known.bands);
            Some(MaterialKind::Conductor { eta: eta?, k: k? })
        }
    }
}
