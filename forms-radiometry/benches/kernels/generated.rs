//! The kernels that this project generates, from formulas with the same arguments as the expert's
//! functions.

forms::include_forms!("benches/kernels/forms/geometry.forms");
forms::include_forms!("benches/kernels/forms/form_factor.forms");
forms::include_forms!("benches/kernels/forms/scattering.forms");
