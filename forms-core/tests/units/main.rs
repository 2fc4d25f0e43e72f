//! Units: the unit of every operation, refused sources, and an independent check by rescaling.

mod errors;
mod laws;
mod mixtures;
mod rescaling;

use forms_core::check::read_theory;
use forms_core::theory::{Named, Theory};

/// Two charts, maps between them, functions and numbers, all with units.
pub const SCENE: &str = "
chart Line(s: m); chart Space(x: m, y: m, z: m); chart Time(t: s); chart Event = Space * Time;
chart Sphere(theta: rad, phi: rad); chart Free(u, v);
param r: m where r > 0; param c: m/s, n: 1, E: W/m**2, L: W/m**2/sr, w: W, omega: sr, lambda: nm, j: J, free;
fn f(x, y, z): K; fn flux(theta, phi): W; fn height(t): m; fn h(u);
map globe: Sphere -> Space = (r*sin(theta)*cos(phi), r*sin(theta)*sin(phi), r*cos(theta));
map path: Time -> Space = (height, 2*height, c*t);
field X on Space = x*@x + r*@y;
field rotation on Space = x*@y - y*@x;
field rise on Time = @t;
metric g on Space = dx**2 + dy**2 + dz**2;
metric round on Sphere = r**2*(dtheta**2 + sin(theta)**2*dphi**2);
form beta: 2, sr on Space = (x*dy^dz + y*dz^dx + z*dx^dy)/sqrt(x**2 + y**2 + z**2)**3;
";

/// Reads declarations and claims after the scene; returns the theory and the messages of all
/// errors.
pub fn read(text: &str) -> (Theory, Vec<String>) {
    let (theory, errors) = read_theory(&format!("{SCENE}{text}"));
    (theory, errors.into_iter().map(|error| error.message).collect())
}

/// Returns the unit of an expression over the scene, and the messages of all errors.
pub fn unit(expression: &str) -> (Option<String>, Vec<String>) {
    let (theory, errors) = read(&format!("let it = {expression};"));
    let unit = match theory.named("it") {
        Some(Named::Object(number)) => theory.objects[*number].unit.clone(),
        _ => None,
    };
    (unit, errors)
}
