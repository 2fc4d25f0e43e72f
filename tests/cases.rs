//! Turns every statement of the case files into a test, through the macro.

macro_rules! case_files {
    ($($name:ident $path:literal;)*) => {
        $(mod $name {
            forms::proof_tests!($path);
        })*
    };
}

case_files! {
    angles "tests/cases/angles.forms";
    change_of_variables "tests/cases/change_of_variables.forms";
    elementary_functions "tests/cases/elementary_functions.forms";
    equations "tests/cases/equations.forms";
    etendue "tests/cases/etendue.forms";
    exponentials "tests/cases/exponentials.forms";
    exterior_derivative "tests/cases/exterior_derivative.forms";
    half_vectors "tests/cases/half_vectors.forms";
    harmonic_and_pde "tests/cases/harmonic_and_pde.forms";
    hodge "tests/cases/hodge.forms";
    integrals "tests/cases/integrals.forms";
    integration "tests/cases/integration.forms";
    inverse_trigonometry "tests/cases/inverse_trigonometry.forms";
    lie_and_cartan "tests/cases/lie_and_cartan.forms";
    logarithms "tests/cases/logarithms.forms";
    magnitudes "tests/cases/magnitudes.forms";
    metrics "tests/cases/metrics.forms";
    nested_radicals "tests/cases/nested_radicals.forms";
    not_identities "tests/cases/not_identities.forms";
    opaque_functions "tests/cases/opaque_functions.forms";
    potentials "tests/cases/potentials.forms";
    pullbacks "tests/cases/pullbacks.forms";
    radicals "tests/cases/radicals.forms";
    sampling_densities "tests/cases/sampling_densities.forms";
    special_functions "tests/cases/special_functions.forms";
    solid_angle "tests/cases/solid_angle.forms";
    sphere_pullbacks "tests/cases/sphere_pullbacks.forms";
    stokes "tests/cases/stokes.forms";
    symplectic "tests/cases/symplectic.forms";
    triangle_gradient "tests/cases/triangle_gradient.forms";
    triangle_harmonicity "tests/cases/triangle_harmonicity.forms";
    trigonometry "tests/cases/trigonometry.forms";
    warps "tests/cases/warps.forms";
    wedge_and_interior "tests/cases/wedge_and_interior.forms";
}
