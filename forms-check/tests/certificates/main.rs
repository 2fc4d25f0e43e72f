//! Certificates of the prover are accepted, and those with a mistake are not.

mod support;
use support::*;

#[test]
fn try_it() {
    let path = std::env::var("FORMS").unwrap();
    for file in path.split(' ') {
        let source = std::fs::read_to_string(file).unwrap();
        if !forms_core::check::read_theory(&source).1.is_empty() { continue; }
        let lines = certificate(&source);
        if std::env::var("SHOW").is_ok() { println!("{lines}"); }
        let start = std::time::Instant::now();
        match checked(&lines, &source) {
            Err(e) => println!("{file}: {e}"),
            Ok(all) => {
                for one in &all { if one.outcome != forms_check::Outcome::Accepted { println!("    {} {:?}", one.name, one.outcome); } }
                println!("{file}: {} of {} in {:?}", all.iter().filter(|o| o.outcome == forms_check::Outcome::Accepted).count(), all.len(), start.elapsed());
            }
        }
    }
}
