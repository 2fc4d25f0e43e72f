//! The kernels as this project generates them, from formulas with the arguments that the expert's functions have.

forms::include_forms!("benches/kernels/forms/geometry.forms");
forms::include_forms!("benches/kernels/forms/form_factor.forms");
forms::include_forms!("benches/kernels/forms/scattering.forms");
