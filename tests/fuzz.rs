//! Fuzz test with damaged theories: all steps from text to verdict end in errors or verdicts, for
//! every text.
//!
//! A case consists of the declarations of a case file and one of its statements, in which a few
//! tokens are removed, duplicated, exchanged or replaced by others of the file.
//! `FORMS_FUZZ=1000000` runs this number of cases.

use forms::core::decide::decide;
use forms::core::resolve::resolve;
use forms::core::syntax::{Source, lex, read};
use forms_testing::SplitMix;
use std::path::Path;

/// Default number of cases.
const CASES: u64 = 10_000;
/// Longest statement in characters; longer ones cost seconds each and are left to the tests of the
/// prover.
const LONGEST_STATEMENT: usize = 120;
/// Files whose statements are too expensive for this test.
const EXPENSIVE: &[&str] =
    &["triangle_gradient", "sampling_densities", "half_vectors", "integrals", "lie_and_cartan"];

/// Number of tokens (`prove name:`) before a statement's equation.
const HEAD: usize = 3;

/// Seed of a case: the declarations of a file before a statement, and the tokens of the statement.
struct Seed {
    name: String,
    declarations: String,
    statement: Vec<String>,
    vocabulary: Vec<String>,
}

fn seeds() -> Vec<Seed> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases");
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .expect("the workspace has its case files")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| !EXPENSIVE.iter().any(|name| path.file_stem().is_some_and(|stem| stem == *name)))
        .collect();
    paths.sort();
    paths.iter().flat_map(|path| seeds_of(path)).collect()
}

fn seeds_of(path: &Path) -> Vec<Seed> {
    let text = std::fs::read_to_string(path).expect("case files are UTF-8");
    let (tokens, vocabulary) = (lex(&text).0, words(&text));
    let (mut declarations, mut seeds, mut start) = (String::new(), Vec::new(), 0);
    for token in tokens {
        let (from, to) = (token.span.start as usize, token.span.end as usize);
        if &text[from..to] != ";" {
            continue;
        }
        let item: String =
            text[start..to].lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        start = to;
        if !item.starts_with("prove") && !item.starts_with("refute") {
            declarations.push_str(&item);
        } else if item.len() <= LONGEST_STATEMENT {
            let (name, declarations) = (path.display().to_string(), declarations.clone());
            seeds.push(Seed { name, declarations, statement: words(&item), vocabulary: vocabulary.clone() });
        }
    }
    seeds
}

/// Returns the tokens of a text.
fn words(text: &str) -> Vec<String> {
    let spans = lex(text).0.into_iter().map(|token| token.span.start as usize..token.span.end as usize);
    spans.map(|span| text[span].to_string()).collect()
}

/// Returns a statement with one to three random edits after its name. Most edits replace a name by
/// a name, a number by a number or an operator by an operator, so that many of the results are
/// valid statements.
fn damaged(seed: &Seed, random: &mut SplitMix) -> String {
    let mut statement = seed.statement.clone();
    for _ in 0..=random.below(3) {
        let body = HEAD..statement.len() - 1;
        if body.len() < 2 {
            break;
        }
        let (one, other) = (HEAD + random.below(body.len()), HEAD + random.below(body.len()));
        match random.below(16) {
            0 => drop(statement.remove(one)),
            1 => statement.insert(one, statement[other].clone()),
            2 => statement.swap(one, other),
            3 => statement[one] = seed.vocabulary[random.below(seed.vocabulary.len())].clone(),
            _ => {
                let kind = kind(&statement[one]);
                let alike: Vec<&String> =
                    seed.vocabulary.iter().filter(|word| self::kind(word) == kind).collect();
                if !alike.is_empty() {
                    statement[one] = alike[random.below(alike.len())].clone();
                }
            }
        }
    }
    format!("{}\n{}", seed.declarations, statement.join(" "))
}

/// Classifies a token roughly, by the syntactic positions in which it can occur.
fn kind(word: &str) -> u8 {
    let first = word.as_bytes().first().copied().unwrap_or_default();
    let differential = word.len() > 1 && first == b'd';
    match first {
        b'0'..=b'9' => 0,
        b'+' | b'-' | b'*' | b'/' | b'^' => 1,
        b'a'..=b'z' | b'A'..=b'Z' if word.len() > 3 => 2,
        b'a'..=b'z' if differential => 3,
        b'a'..=b'z' => 4,
        b'A'..=b'Z' => 5,
        other => other,
    }
}

/// Guard that prints the damaged text when a test fails.
struct Witness<'a>(&'a str, &'a str);

impl Drop for Witness<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("damaged from {}:\n{}", self.0, self.1);
        }
    }
}

/// Runs all steps on a text; returns whether the text was valid enough for its statement to be
/// decided.
fn survives(name: &str, text: &str) -> bool {
    let _witness = Witness(name, text);
    let source = Source::new("damaged", text);
    let (tree, mut diagnostics) = read(text);
    let (mut theory, found) = resolve(&tree);
    diagnostics.extend(found);
    for diagnostic in &diagnostics {
        assert!(source.render(diagnostic).starts_with("error: "));
    }
    for statement in &theory.statements.clone() {
        decide(&mut theory, statement);
    }
    !theory.statements.is_empty()
}

#[test]
fn damaged_theories_end_in_errors_or_verdicts() {
    let wanted = std::env::var("FORMS_FUZZ").map_or(CASES, |count| count.parse().expect("a number of cases"));
    let seeds = seeds();
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let decided: u64 = std::thread::scope(|scope| {
        let work: Vec<_> = (0..threads)
            .map(|first| {
                let seeds = &seeds;
                let work = move || {
                    let cases = (first..wanted).step_by(threads as usize);
                    cases.filter(|&case| survives_case(seeds, case)).count() as u64
                };
                let stack = std::thread::Builder::new().stack_size(64 << 20);
                stack.spawn_scoped(scope, work).expect("a thread")
            })
            .collect();
        work.into_iter().map(|thread| thread.join().expect("no case panics")).sum()
    });
    assert!(decided * 20 > wanted, "only {decided} of {wanted} cases reached the prover");
}

fn survives_case(seeds: &[Seed], case: u64) -> bool {
    let mut random = SplitMix(case);
    let seed = &seeds[random.below(seeds.len())];
    survives(&seed.name, &damaged(seed, &mut random))
}
