//! A field where a form is expected; an error in the declarations.

fn main() {
    let _ = forms::form! { chart Line(x); x*@x };
    let form = forms::form! { chart Line(x); d(y) };
    assert_eq!(form.degree, 1);
}
