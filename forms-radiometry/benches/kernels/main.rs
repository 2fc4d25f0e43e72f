//! Generated kernels beside what an expert writes by hand and what other generators emit.
//!
//! ```text
//! inputs ──▶ columns ──┐
//! expert, elsewhere ── catalogue ── measure ──▶ times a value, ratios of medians
//! ```
//! `cargo bench --bench kernels [NAME…]` prints a table of the kernels whose name contains one of the words, or of all.

mod catalogue;
mod elsewhere;
mod expert;
mod inputs;
mod measure;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let set = expert::batch::InstructionSet::detected();
    println!("{set:?}");
    for entry in catalogue::all(set) {
        if words.is_empty() || words.iter().any(|word| entry.name.contains(word.as_str())) {
            print!("{:50}", entry.name);
            for (author, time) in measure::seconds_per_value(&entry) {
                print!("  {author:?} {:.2}", time * 1e9);
            }
            println!();
        }
    }
}
