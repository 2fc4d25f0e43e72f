//! Decides every statement and generates every kernel of the given files, and prints the time for
//! each.

use forms_core::{check::read_theory, compile::compile_kernel, decide::decide, syntax};
use std::time::Instant;

fn main() {
    for name in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&name).expect("the file can be read");
        let start = Instant::now();
        let (mut theory, errors) = read_theory(&text);
        let source = syntax::Source::new(&name, &text);
        for error in &errors {
            println!("{}", source.render(error));
        }
        let resolved = start.elapsed();
        for statement in theory.statements.clone() {
            let begin = Instant::now();
            let verdict = decide(&mut theory, &statement);
            let mark = if verdict.bears_out(statement.claim) { "ok " } else { "BAD" };
            println!("{mark} {:>8.0?} {} {:?}", begin.elapsed(), statement.name, verdict);
        }
        for kernel in theory.kernels.clone() {
            let begin = Instant::now();
            match compile_kernel(&mut theory.pool, &kernel) {
                Ok(generated) => {
                    let (all, account) = (begin.elapsed(), generated.account());
                    println!("ok  {all:>8.0?} {} {account}", kernel.name);
                }
                Err(errors) => errors.iter().for_each(|error| println!("{}", source.render(error))),
            }
        }
        println!("{name}: resolved in {resolved:.1?}, all in {:.1?}", start.elapsed());
    }
}
