//! Every macro at item position and at statement position.

forms::prove! { chart Line(x); d(x**2) == 2*x*dx }
forms::kernel! { pub cube(x) = x**3; }
forms::forms! {}

#[allow(dead_code, reason = "a module may use only some of its kernels")]
mod inner {
    forms::forms! {
        kernel unused(x) = x;
    }
}

fn main() {
    forms::prove!(chart Line(x); d(x**2) == 2*x*dx);
    forms::prove! { param n; (n + 1)**2 == n**2 + 2*n + 1 where n > 0; }
    forms::kernel! { chart Line(x); let p = x**2; square(x) = p where x > 0 }
    const FORM: forms::Form = forms::form! { chart Line(x); d(x**3) };
    assert_eq!((square(3.0), cube(2.0)), (9.0, 8.0));
    assert_eq!(FORM.to_string(), "3*x**2*dx");
}
