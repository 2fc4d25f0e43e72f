//! Boundary of a box: Stokes' theorem holds for it, and for no boundary with a face, a sign or an
//! end changed.
//!
//! A boundary is a rule that determines which faces count and with which sign. The integral over it
//! is a sum over its faces, each a box of its own with a map that sets one variable to a bound. So
//! the rule can be compared with `boundary_integral`, which does not use it, and with ∫ dη over the
//! interior.

use super::quadrature::theory_of;
use forms_core::decide::decide;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Number of scenes of each dimension.
const SCENES: usize = 4;

const BOX: [&str; 3] = ["u", "v", "w"];
const SPACE: [&str; 4] = ["x", "y", "z", "t"];

/// One face of a box.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// Index of the fixed variable, outermost first.
    place: usize,
    /// Whether it is fixed at its upper bound.
    upper: bool,
}

/// Sign with which a face of a box of some dimension counts; `None` if the face is omitted.
type Boundary = fn(Face, usize) -> Option<i8>;

/// Gives (−1)^place at the upper bound, and the opposite at the lower one.
fn induced(face: Face, _: usize) -> Option<i8> {
    Some(if face.upper == face.place.is_multiple_of(2) { 1 } else { -1 })
}

/// Gives every pair of faces the orientation of the first.
fn without_signs_of_places(face: Face, _: usize) -> Option<i8> {
    Some(if face.upper { 1 } else { -1 })
}

/// Gives both ends of a range the same sign.
fn without_signs_of_ends(face: Face, _: usize) -> Option<i8> {
    Some(if face.place.is_multiple_of(2) { 1 } else { -1 })
}

/// Exchanges the lower and the upper ends.
fn with_ends_swapped(face: Face, dimension: usize) -> Option<i8> {
    induced(face, dimension).map(|sign| -sign)
}

/// Counts places from the innermost variable.
fn counted_from_within(face: Face, dimension: usize) -> Option<i8> {
    induced(Face { place: dimension - 1 - face.place, ..face }, dimension)
}

fn without_the_first_face(face: Face, dimension: usize) -> Option<i8> {
    induced(face, dimension).filter(|_| face.place > 0 || face.upper)
}

fn without_the_last_face(face: Face, dimension: usize) -> Option<i8> {
    induced(face, dimension).filter(|_| face.place + 1 < dimension || !face.upper)
}

fn without_the_innermost_faces(face: Face, dimension: usize) -> Option<i8> {
    induced(face, dimension).filter(|_| face.place + 1 < dimension)
}

/// Form of degree n − 1 on a space, map of an n-dimensional box into it, and bounds of the box.
#[derive(Clone, Debug)]
struct Scene {
    dimension: usize,
    map: Vec<String>,
    form: String,
    bounds: Vec<[String; 2]>,
}

/// Σ c m over products m of at most two variables.
fn polynomial(variables: &'static [&'static str]) -> impl Strategy<Value = String> {
    let factor = move || prop_oneof![1 => Just("1"), 3 => prop::sample::select(variables)];
    let term = (prop_oneof![-3..=-1i64, 1..=3i64], factor(), factor());
    prop::collection::vec(term, 2..=3).prop_map(|terms| {
        let terms: Vec<String> = terms.iter().map(|(c, a, b)| format!("({c})*{a}*{b}")).collect();
        format!("({})", terms.join(" + "))
    })
}

/// All basis forms of a degree, each with a polynomial.
fn form(degree: usize, dimension: usize) -> impl Strategy<Value = String> {
    let space = &SPACE[..dimension];
    let blades: Vec<String> = (0..1_usize << dimension)
        .filter(|set| set.count_ones() as usize == degree)
        .map(|set| {
            let factors = (0..dimension).filter(|place| set >> place & 1 == 1);
            factors.map(|place| format!("d{}", SPACE[place])).collect::<Vec<_>>().join("^")
        })
        .collect();
    prop::collection::vec(polynomial(space), blades.len()).prop_map(move |coefficients| {
        let written = |(c, blade): (&String, &String)| {
            if blade.is_empty() { c.clone() } else { format!("{c}*{blade}") }
        };
        coefficients.iter().zip(&blades).map(written).collect::<Vec<_>>().join(" + ")
    })
}

/// Boxes whose bounds are numbers in the first variable, and polynomials in the outer variables in
/// the others.
fn scene(dimension: usize) -> impl Strategy<Value = Scene> {
    let variables = &BOX[..dimension];
    let bound = |place: usize| {
        let outer = if place == 0 { &["1"] } else { &BOX[..place] };
        (polynomial(outer), polynomial(outer)).prop_map(<[String; 2]>::from)
    };
    let bounds: Vec<_> = (0..dimension).map(bound).collect();
    let map = prop::collection::vec(polynomial(variables), dimension);
    (map, form(dimension - 1, dimension), bounds).prop_map(move |(map, form, bounds)| Scene {
        dimension,
        map,
        form,
        bounds,
    })
}

fn scenes(dimension: usize) -> Vec<Scene> {
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::default(), random);
    (0..SCENES).map(|_| scene(dimension).new_tree(&mut runner).unwrap().current()).collect()
}

impl Scene {
    fn variables(&self) -> &'static [&'static str] {
        &BOX[..self.dimension]
    }

    /// Returns the declarations of the map F of the box, the form η, and a map of a smaller box
    /// onto each face.
    fn preamble(&self) -> String {
        let chart = |name: &str, coordinates: &[&str]| format!("chart {name}({});\n", coordinates.join(", "));
        let mut text = chart("S", &SPACE[..self.dimension]) + &chart("B", self.variables());
        text += &format!("map F: B -> S = ({});\n", self.map.join(", "));
        text += &format!("let eta = {};\n", self.form);
        for place in (0..self.dimension).filter(|_| self.dimension > 1) {
            let mut rest = self.variables().to_vec();
            rest.remove(place);
            text += &chart(&format!("B{place}"), &rest);
            for (end, name) in ["lower", "upper"].iter().enumerate() {
                let mut values: Vec<&str> = self.variables().to_vec();
                values[place] = &self.bounds[place][end];
                text += &format!("map {name}{place}: B{place} -> B = ({});\n", values.join(", "));
            }
        }
        text
    }

    /// Returns `u = a..b, v = c..e`, without the fixed variable, which is set to one of its bounds.
    fn ranges(&self, fixed: Option<Face>) -> String {
        let mut ranges = Vec::new();
        for (place, variable) in self.variables().iter().enumerate() {
            if fixed.is_some_and(|face| face.place == place) {
                continue;
            }
            let [from, to] = self.bounds[place].clone().map(|bound| match fixed {
                Some(face) => {
                    bound.replace(BOX[face.place], &self.bounds[face.place][usize::from(face.upper)])
                }
                None => bound,
            });
            ranges.push(format!("{variable} = {from}..{to}"));
        }
        ranges.join(", ")
    }

    fn face_integral(&self, face: Face) -> String {
        let Face { place, upper } = face;
        if self.dimension == 1 {
            let end = &self.bounds[0][usize::from(upper)];
            return self.form.replace(SPACE[0], &self.map[0].replace(BOX[0], end));
        }
        let name = if upper { "upper" } else { "lower" };
        format!("integral(pullback({name}{place}, pullback(F, eta)), {})", self.ranges(Some(face)))
    }

    /// Returns the signed sum over the faces that count.
    fn sum_over(&self, boundary: Boundary) -> String {
        let mut terms = Vec::new();
        for place in 0..self.dimension {
            for upper in [true, false] {
                let face = Face { place, upper };
                let sign = boundary(face, self.dimension);
                terms.extend(sign.map(|sign| format!("({sign})*({})", self.face_integral(face))));
            }
        }
        terms.join(" + ")
    }

    fn inside(&self) -> String {
        format!("integral(pullback(F, d(eta)), {})", self.ranges(None))
    }

    fn boundary_integral(&self) -> String {
        format!("boundary_integral(F, eta, {})", self.ranges(None))
    }

    fn verdict(&self, left: &str, right: &str) -> &'static str {
        let text = format!("{}prove it: {left} == {right};", self.preamble());
        let (mut theory, errors) = theory_of(&text);
        assert_eq!(errors, [""; 0], "{text}");
        let statement = theory.statements[0].clone();
        decide(&mut theory, &statement).name()
    }
}

#[test]
fn the_boundary_integral_is_that_of_the_derivative_and_the_oriented_sum_over_the_faces() {
    for scene in [1, 2, 3].into_iter().flat_map(scenes) {
        let boundary = scene.boundary_integral();
        assert_eq!(scene.verdict(&scene.inside(), &boundary), "proved", "{scene:?}");
        assert_eq!(scene.verdict(&boundary, &scene.sum_over(induced)), "proved", "{scene:?}");
    }
}

#[test]
fn a_boundary_with_a_sign_an_end_or_a_face_changed_is_not_that_of_stokes() {
    let mutants: [(&str, Boundary, std::ops::RangeInclusive<usize>); 7] = [
        ("without the signs of places", without_signs_of_places, 2..=3),
        ("without the signs of ends", without_signs_of_ends, 1..=3),
        ("with the ends swapped", with_ends_swapped, 1..=3),
        ("counted from within", counted_from_within, 2..=2),
        ("without the first face", without_the_first_face, 1..=3),
        ("without the last face", without_the_last_face, 1..=3),
        ("without the innermost faces", without_the_innermost_faces, 2..=3),
    ];
    for (name, mutant, dimensions) in mutants {
        for dimension in dimensions {
            let scenes = scenes(dimension);
            let sees = |left: fn(&Scene) -> String| {
                scenes.iter().any(|scene| scene.verdict(&left(scene), &scene.sum_over(mutant)) == "refuted")
            };
            assert!(sees(Scene::inside), "Stokes' theorem does not see a boundary {name} in {dimension}D");
            assert!(
                sees(Scene::boundary_integral),
                "`boundary_integral` is a boundary {name} in {dimension}D"
            );
        }
    }
}
