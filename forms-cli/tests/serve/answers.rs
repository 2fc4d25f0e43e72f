//! Answers of the server: errors at their places, verdicts with their grounds, steps, source code
//! and plots.

use crate::server::Server;
use serde_json::{Value, json};

const CLAIM: &str = "chart Plane(x, y); prove binomial: (x + y)**2 == x**2 + 2*x*y + y**2 where x > 0;";
const KERNEL: &str = "/// A root.\npub kernel root(x, y) = sqrt(x - y) where 0 < x < 2;";

fn list<'a>(answer: &'a Value, key: &str) -> &'a Vec<Value> {
    answer[key].as_array().unwrap_or_else(|| panic!("no {key} in {answer}"))
}

#[test]
fn a_false_statement_is_answered_by_a_witness_and_the_mended_one_by_a_proof() {
    let server = Server::start(&[]);
    let answer = server.check(&CLAIM.replace("2*x*y", "3*x*y"));
    let verdict = &list(&answer, "verdicts")[0];
    assert_eq!((&verdict["verdict"], &verdict["ok"]), (&json!("refuted"), &json!(false)), "{answer}");
    assert!(
        verdict["witness"]["point"]["x"].is_string()
            && verdict["witness"]["left"] != verdict["witness"]["right"]
    );

    let answer = server.check(CLAIM);
    let verdict = &list(&answer, "verdicts")[0];
    assert_eq!((&verdict["verdict"], &verdict["ok"]), (&json!("proved"), &json!(true)), "{answer}");
    assert_eq!(verdict["conditions"], json!(["x > 0"]));
    let statement = &list(&answer, "statements")[0];
    assert_eq!((&statement["line"], &statement["name"]), (&json!(1), &json!("binomial")));
    assert!(statement["mathml"].as_str().is_some_and(|math| math.starts_with("<math")), "{statement}");
    assert_eq!(answer["stopped"], Value::Null);
}

#[test]
fn an_error_has_the_line_the_column_and_the_length_of_what_it_speaks_of() {
    let server = Server::start(&[]);
    let answer = server.check("chart Plane(x, y);\nlet β = 1;\nprove wrong: x + unknown == 2;");
    let errors = list(&answer, "diagnostics");
    let places: Vec<_> =
        errors.iter().map(|error| (&error["line"], &error["column"], &error["length"])).collect();
    assert!(places.contains(&(&json!(2), &json!(5), &json!(1))), "{answer}");
    assert!(places.contains(&(&json!(3), &json!(18), &json!(7))), "{answer}");
    assert!(errors.iter().all(|error| error["message"].as_str().is_some_and(|text| !text.is_empty())));
}

#[test]
fn a_statement_about_no_point_is_an_error_at_its_place() {
    let server = Server::start(&[]);
    let answer = server.check("chart L(x);\nprove nothing: x == 1 where x > 1, x < 0;");
    assert_eq!(list(&answer, "diagnostics")[0]["line"], 2, "{answer}");
    assert_eq!(list(&answer, "verdicts")[0]["ok"], false, "{answer}");
}

#[test]
fn the_steps_of_a_statement_are_sentences_and_formulas() {
    let server = Server::start(&[]);
    let answer = server.post("/api/derive", &json!({ "text": CLAIM, "name": "binomial" })).json();
    let steps = list(&answer, "steps");
    assert_eq!(
        (&steps[0]["title"], &steps[steps.len() - 1]["title"]),
        (&json!("Claimed to hold"), &json!("Proved"))
    );
    let formula = &steps[0]["lines"][0];
    assert!(formula["text"].is_string() && formula["mathml"].is_string(), "{answer}");
    let answer = server.post("/api/derive", &json!({ "text": CLAIM, "name": "other" })).json();
    assert!(answer["refusal"].as_str().is_some_and(|text| text.contains("`other`")), "{answer}");
}

#[test]
fn a_kernel_is_told_with_its_ranges_and_written_in_three_languages() {
    let server = Server::start(&[]);
    let answer = server.check(KERNEL);
    let kernel = &list(&answer, "kernels")[0];
    assert_eq!(kernel["docs"], json!(["A root."]));
    assert_eq!(kernel["arguments"][0], json!({ "name": "x", "unit": null, "from": 0.0, "to": 2.0 }));
    let answer = server.post("/api/emit", &json!({ "text": KERNEL, "kernel": "root" })).json();
    let starts =
        ["pub fn root(x: f64, y: f64)", "double root(double x, double y)", "fn root(x: f32, y: f32)"];
    for (code, start) in list(&answer, "code").iter().zip(starts) {
        assert!(code["text"].as_str().is_some_and(|text| text.contains(start)), "{start}: {code}");
    }
    assert_eq!(list(&answer, "code").len(), starts.len());
}

#[test]
fn a_plot_is_of_the_stable_form_and_a_false_claim_of_a_kernel_is_told() {
    let server = Server::start(&[]);
    let across = json!({ "name": "x", "from": 1e-18, "to": 1e-17 });
    let request = json!({ "text": "kernel growth(x) = exp(x) - 1;", "kernel": "growth", "across": across });
    let drawing = &server.post("/api/plot", &request).json()["drawing"];
    assert_eq!((&drawing["least"], &drawing["greatest"]), (&json!(1e-18), &json!(1e-17)));
    let text = "kernel k(u, v) = sqrt(u**2 + v**2) by abs(u)*sqrt(1 + (v/u)**2);";
    let answer = server.post("/api/check", &json!({ "text": text })).body;
    assert!(answer.contains("is undefined at a point where its formula has a value"), "{answer}");
}

#[test]
fn a_plot_shows_where_a_kernel_is_not_defined() {
    let server = Server::start(&[]);
    let axis = |name: &str, to: f64| json!({ "name": name, "from": 0.0, "to": to });
    let plot = |request: Value| server.post("/api/plot", &request).json();
    let request = json!({ "text": KERNEL, "kernel": "root", "across": axis("x", 1.0), "up": axis("y", 1.0) });
    let drawing = &plot(request.clone())["drawing"];
    let svg = drawing["svg"].as_str().expect("a drawing");
    assert!(svg.starts_with("<svg") && svg.contains("not defined"), "{svg}");
    // The kernel is undefined on one side of the diagonal, half of the square.
    let (undefined, values) = (drawing["undefined"].as_u64(), drawing["values"].as_u64());
    let share = undefined.expect("a count") as f64 / values.expect("a count") as f64;
    assert!((share - 0.5).abs() < 0.02, "{share}");

    let mut curve = request.clone();
    curve["up"] = Value::Null;
    curve["fixed"] = json!({ "y": -1.0 });
    assert_eq!(plot(curve)["drawing"]["undefined"], 1, "at the open end of the domain");
}

#[test]
fn a_plot_of_what_cannot_be_drawn_is_refused_with_the_reason() {
    let server = Server::start(&[]);
    let axis = |name: &str, to: f64| json!({ "name": name, "from": 0.0, "to": to });
    for (across, up, output, reason) in [
        (axis("x", 0.0), axis("y", 1.0), 0, "smaller number"),
        (axis("z", 1.0), axis("y", 1.0), 0, "`x` needs a value"),
        (axis("x", 1.0), axis("x", 1.0), 0, "different arguments"),
        (axis("x", 1.0), axis("y", 1.0), 1, "values 0 to 0"),
    ] {
        let request =
            json!({ "text": KERNEL, "kernel": "root", "across": across, "up": up, "output": output });
        let answer = server.post("/api/plot", &request).json();
        assert!(answer["refusal"].as_str().is_some_and(|text| text.contains(reason)), "{reason}: {answer}");
    }
    let answer = server.post("/api/plot", &json!({ "text": KERNEL })).json();
    assert!(answer["refusal"].as_str().is_some_and(|text| text.contains("cannot be read")), "{answer}");
}

#[test]
fn the_editor_begins_with_the_file_that_was_named_and_each_example_is_what_its_title_says() {
    let file = format!("{}/serve-opened.forms", env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(&file, CLAIM).expect("a file in the build's folder");
    let server = Server::start(&[&file]);
    let start = server.get("/api/start").json();
    assert_eq!(start["opened"], json!({ "name": "serve-opened.forms", "text": CLAIM }));
    assert!(start["words"]["items"].as_array().is_some_and(|words| words.contains(&json!("chart"))));
    for example in list(&start, "examples") {
        let (name, answer) = (&example["name"], server.check(example["text"].as_str().expect("a text")));
        let has_error = answer.get("diagnostics").is_some();
        assert_eq!(has_error, name == "5_mistake", "{name}: {answer}");
        if !has_error {
            let wrong = list(&answer, "verdicts").iter().filter(|verdict| verdict["ok"] == false).count();
            assert_eq!(wrong, if name == "3_false_statement" { 2 } else { 0 }, "{name}: {answer}");
        }
    }
}
