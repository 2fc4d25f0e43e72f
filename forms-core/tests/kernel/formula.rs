//! Formulas of these tests.

forms_testing::formulas!();
