//! Every diagnostic that a macro's user can meet, as rustc shows it; and what compiles in silence.

#[test]
fn mistakes_are_reported_on_the_users_own_text() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}

#[test]
fn what_is_right_compiles() {
    trybuild::TestCases::new().pass("tests/ui/pass/*.rs");
}
