//! The kernels that this project generates, from formulas with the same arguments as the expert's
//! functions.

forms::include_forms!("kernels/geometry.forms");
forms::include_forms!("kernels/form_factor.forms");
forms::include_forms!("kernels/scattering.forms");
