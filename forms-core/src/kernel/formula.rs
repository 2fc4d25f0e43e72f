//! Formulas of unit tests.

forms_testing::formulas!();
