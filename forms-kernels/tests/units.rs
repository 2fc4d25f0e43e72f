//! Mistakes with units, which the table of quantities turns into errors.

use forms::core::check::read_theory;

fn table() -> &'static str {
    let is_table = |file: &&forms_kernels::TheoryFile| file.name == "units.forms";
    forms_kernels::theory().iter().find(is_table).unwrap().text
}

/// Claims about the table, with the units of their two sides.
const MISTAKES: &[(&str, &str, &str)] = &[
    // "Radiant energy expresses the rate of transfer."
    ("Q == Phi", "J", "W"),
    ("Phi == E", "W", "W/m**2"),
    // One name for exposure and irradiance, energy and flux per area.
    ("H == E", "J/m**2", "W/m**2"),
    ("I == E", "W/sr", "W/m**2"),
    ("L == E", "W/m**2/sr", "W/m**2"),
    ("L == I", "W/m**2/sr", "W/sr"),
    // "Irradiance per unit solid angle" is not an irradiance.
    ("diff(E, w) == E", "W/m**2/sr", "W/m**2"),
    // The product of first derivatives instead of the second derivative.
    ("diff(Phi, a)*diff(Phi, w) == L", "W**2/m**2/sr", "W/m**2/sr"),
    // A spectral density read as the quantity.
    ("L_l == L", "W/m**2/sr/nm", "W/m**2/sr"),
    ("E_l == E", "W/m**2/nm", "W/m**2"),
    // A density per frequency read as one per wavelength.
    ("L_nu(c*nanometres/lambda) == L_l", "W/m**2/sr/Hz", "W/m**2/sr/nm"),
    // pi is a number, and the projected hemisphere a solid angle.
    ("irradiance == pi*L0", "W/m**2", "W/m**2/sr"),
    // The distance to the first power, or none.
    ("E0 == I0*solid_angle_per_area*r", "W/m**2", "W/m"),
    ("E0 == I0", "W/m**2", "W/sr"),
    // The inverse square without the steradian.
    ("E0 == I0/r**2", "W/m**2", "W/sr/m**2"),
    ("fluence == fluence_rate", "J/m**2", "W/m**2"),
    ("photon_flux == Phi0", "1/s", "W"),
    ("illuminance == luminance", "lx", "cd/m**2"),
    ("illuminance == luminous_flux", "lx", "lm"),
    ("luminous_intensity == luminous_flux", "cd", "lm"),
    ("luminance == L0", "cd/m**2", "W/m**2/sr"),
];

#[test]
fn a_quantity_in_the_place_of_another_is_an_error() {
    for (claim, left, right) in MISTAKES {
        let (_, errors) = read_theory(&format!("{}refute mistake: {claim};", table()));
        let messages: Vec<String> = errors.into_iter().map(|error| error.message).collect();
        let wanted = format!(
            "`mistake` equates different units: the left side is in {left}, the right side in {right}"
        );
        assert_eq!(messages, [wanted], "{claim}");
    }
}

/// Altered declarations of the table: the original, the altered text, the declared unit, and the
/// unit that is found.
const ALTERED: &[(&str, &str, &str, &str)] = &[
    ("let E: W/m**2 = diff(Phi, a);", "let E: W/m**2 = Phi;", "W/m**2", "W"),
    ("let I: W/sr = diff(Phi, w);", "let I: W/m**2 = diff(Phi, w);", "W/m**2", "W/sr"),
    ("let H: J/m**2 = diff(Q, a);", "let H: W/m**2 = diff(Q, a);", "W/m**2", "J/m**2"),
    ("let L_l: W/m**2/sr/nm = diff(L, l);", "let L_l: W/m**3/sr = diff(L, l);", "W/m**3/sr", "W/m**2/sr/nm"),
    ("let photon: J = h*nu;", "let photon: J = h/nu;", "J", "J*s/Hz"),
];

#[test]
fn an_altered_row_of_the_table_is_an_error() {
    for (row, altered, declared, found) in ALTERED {
        assert!(table().contains(row), "{row}");
        let (_, errors) = read_theory(&table().replace(row, altered));
        let message = &errors.first().expect(altered).message;
        assert!(
            message.ends_with(&format!("is declared in {declared}, and its value is in {found}")),
            "{message}"
        );
    }
}

#[test]
fn every_quantity_of_the_table_has_its_unit() {
    let (theory, errors) = read_theory(table());
    assert!(errors.is_empty(), "{errors:?}");
    assert!(theory.objects.iter().all(|object| object.unit.is_some()));
}

#[test]
fn every_kernel_of_the_library_states_all_its_units() {
    for file in forms_kernels::library() {
        let (theory, errors) = read_theory(file.text);
        assert!(errors.is_empty(), "{}: {errors:?}", file.name);
        for kernel in &theory.kernels {
            let units = &kernel.units;
            assert!(units.arguments.iter().chain(&units.outputs).all(Option::is_some), "{}", kernel.name);
        }
    }
}
