//! Command-line arguments.

mod simulate;
mod solve;
mod view_factors;

use clap::{Parser, Subcommand, ValueEnum};
use forms::math::Instructions;
use forms_radiometry::simulation::{Budget, Exposure};
pub(crate) use simulate::SimulateArguments;
pub(crate) use solve::{SolveArguments, ThreadArguments, TimeArguments};
use std::net::IpAddr;
use std::time::Duration;
pub(crate) use view_factors::ViewFactorArguments;

/// Exterior calculus that proves identities exactly and turns them into numeric kernels.
///
/// Without a command it gives a demonstration: it proves the theory of radiance that comes with it,
/// generates the library's kernels and computes the direct light in the Cornell box.
#[derive(Debug, Parser)]
#[command(name = "forms", version, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Decide every statement of files: proved, refuted by an exact point, or unknown
    ///
    /// Exit status: 0 if every statement is as stated, 1 if some are not, 2 if a file has errors.
    Prove {
        /// Files of the forms language
        #[arg(required = true, value_name = "FILE")]
        files: Vec<String>,
        /// Print one JSON object per line
        #[arg(long)]
        json: bool,
        /// Write a certificate: the data needed to check each verdict
        #[arg(long, value_name = "FILE")]
        certificate: Option<String>,
        /// Multiply the work limit of each statement (by default about one second) by N
        #[arg(long, default_value_t = 1, value_name = "N", allow_negative_numbers = true,
            value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
        budget: u32,
    },
    /// Check a certificate of `prove` without the prover
    ///
    /// Certificates do not cover the claims of kernels, which the prover decides again. Exit status:
    /// 0 if every entry is accepted and shows what its file states, 1 if some are rejected, not
    /// covered (without --allow-uncovered) or not as stated, or if a claim of a kernel is not
    /// proved, 2 if the certificate or a file it names cannot be read, or if a file has errors or
    /// differs from the certified one.
    Check {
        /// A certificate; file names in it are relative to its folder
        file: String,
        /// Skip entries outside the checker's coverage
        #[arg(long)]
        allow_uncovered: bool,
    },
    /// Print one named object of a file, simplified
    Show {
        /// A file of the forms language, or - for the library
        file: String,
        /// A name declared in it, or the name of a statement
        name: String,
        /// Notation of the output
        #[arg(long = "as", value_enum, default_value_t = Notation::Text, value_name = "NOTATION")]
        notation: Notation,
        /// For a closed form, report whether it has a potential, or else a cycle with its period
        #[arg(long, conflicts_with = "notation")]
        topology: bool,
    },
    /// Print the steps that decide one statement
    ///
    /// Exit status: 0 if the statement is as stated, 1 if it is not, 2 if the file has errors.
    Derive {
        /// A file of the forms language, or - for the library
        file: String,
        /// The name of a statement in it
        name: String,
        /// Notation of the output; latex prints a document, mathml a page
        #[arg(long = "as", value_enum, default_value_t = Notation::Text, value_name = "NOTATION")]
        notation: Notation,
    },
    /// Evaluate a kernel on rows of CSV from standard input
    ///
    /// The first row names the kernel's arguments, in any order. A row outside the kernel's domain gives NaN.
    Eval {
        /// A file of the forms language, or - for the library
        file: String,
        /// Name of a kernel in it
        kernel: String,
        /// Arithmetic: f32, f64, dd for double-double, or exact for 50 certain digits
        #[arg(long, default_value = "f64")]
        precision: String,
        /// Program of the kernel: its formula as written, or the generated form
        #[arg(long, value_enum, default_value_t = Tier::Stable)]
        tier: Tier,
    },
    /// Print the kernels of a file as source code that compiles without changes
    ///
    /// In C, CUDA and WGSL each kernel is also computed over arrays, by a function NAME_batch. A
    /// kernel that the target cannot express is omitted and reported. Exit status: 0 if every
    /// kernel was written, 2 if some were omitted or if the file has errors.
    Emit {
        /// A file of the forms language, or - for the library
        file: String,
        /// Only this kernel
        #[arg(long)]
        kernel: Option<String>,
        /// Target language: rust, c, wgsl or cuda
        #[arg(long)]
        target: String,
        /// Number type: f32, f64 or dd; by default f64, in wgsl f32
        #[arg(long)]
        precision: Option<String>,
        /// Prefix of the names of all functions of kernels
        #[arg(long, default_value = "", hide_default_value = true, value_name = "TEXT",
            value_parser = prefix)]
        prefix: String,
        /// Program of each kernel: its formula as written, without promises, or the generated form
        #[arg(long, value_enum, default_value_t = Tier::Stable)]
        tier: Tier,
    },
    /// Show the run time and the accuracy of each precision and form of a kernel, on typical and on
    /// hard arguments
    ///
    /// Times are measured if rustc is available. With --write, the program searches for forms that
    /// lose fewer bits, proves them equal to the formulas, and writes them to a file next to the
    /// input, with the extension `stable`; kernels are computed by them from then on.
    Accuracy {
        /// A file of the forms language, or - for the library
        #[arg(default_value = "-")]
        file: String,
        /// Only this kernel
        kernel: Option<String>,
        /// Print one JSON object per line
        #[arg(long)]
        json: bool,
        /// Search for better forms and write them to a file next to the input
        #[arg(long, conflicts_with_all = ["json", "pages", "kernel"])]
        write: bool,
        /// Write accuracy.md and its figures into this folder
        #[arg(long, value_name = "FOLDER")]
        pages: Option<String>,
        /// Number of arguments in each regime
        #[arg(long, default_value_t = 128, value_name = "COUNT", value_parser = sample_count)]
        samples: usize,
        /// Do not measure times
        #[arg(long)]
        no_times: bool,
    },
    /// Simulate a scene: print the plan with its reasons, then the result of each receiver with its
    /// error
    ///
    /// Ctrl-C stops the work; the results so far are printed and written. Exit status: 0 if the
    /// work was done, 3 if it was done but a number is less accurate than requested, 2 if the scene
    /// has errors or a file cannot be written, 130 if the work was stopped.
    ///
    /// A path-tracing run that was killed resumes from its --checkpoint with bit-identical results.
    /// Such a run can also be divided among machines: each computes one --shard, and `forms merge`
    /// combines the parts into the results of a single run, bit for bit.
    Simulate(SimulateArguments),
    /// Combine the parts of a simulation that were written with --shard into the results of a
    /// single run
    ///
    /// The parts can be given in any order, and more than once. A part that is damaged or belongs
    /// to another run is reported, and so is a missing shard, with the call that creates it. Exit
    /// status: 0 if all shards are present, 3 if they are but a number is less accurate than
    /// requested, 2 otherwise.
    Merge {
        /// Files written by `forms simulate --shard`
        #[arg(required = true, value_name = "PART")]
        parts: Vec<String>,
        /// Write results.csv, error.svg, and for each map an EXR and a PNG file into this folder
        #[arg(long, value_name = "DIR")]
        out: Option<String>,
        /// Also write into the folder --out a .vtu file for each receiver of points, faces or maps,
        /// with its results on its geometry, and scene.vtu with all surfaces, for ParaView
        #[arg(long, requires = "out")]
        vtu: bool,
        #[command(flatten)]
        threads: ThreadArguments,
        /// Print one JSON object per line
        #[arg(long)]
        json: bool,
    },
    /// Print the view factors between the surfaces of a scene as CSV
    ///
    /// A row holds the fractions of the flux from one surface that arrive at each surface, their
    /// sum, which is 1 if nothing leaves the scene, and the emitting area of the surface in m². A
    /// two-sided surface emits from both sides. Each row is printed as soon as it is complete; on
    /// Ctrl-C the work ends after the complete rows. The rows of few faces are found by pairs of
    /// faces, those of many faces and of curved surfaces by rays; then the errors are standard
    /// errors. Exit status: 0 if every factor is as accurate as requested, 3 if some are not.
    ViewFactors(ViewFactorArguments),
    /// List the kernels of the library with their arguments, units and formulas
    Kernels,
    /// Write the book as HTML pages, each statement with its verdict and the steps that decide it
    ///
    /// The pages need no network and no scripts. With --preprocess, a book in the format of mdBook
    /// is read from standard input and written with formulas and verdicts inserted: see
    /// docs/book/book.toml.
    Book {
        /// Output folder
        #[arg(long, value_name = "DIR", default_value = "target/book")]
        out: String,
        /// Run as a preprocessor of mdBook
        #[arg(long, conflicts_with = "out")]
        preprocess: bool,
        /// Query of mdBook before it sends a book: `supports html`
        #[arg(requires = "preprocess", num_args = 2, value_names = ["supports", "RENDERER"], hide = true)]
        question: Vec<String>,
    },
    /// Print the manual page of the program, or of one of its commands
    Man {
        /// A command
        command: Option<String>,
        /// Write the pages of the program and of all commands into this folder
        #[arg(long, value_name = "DIR", conflicts_with = "command")]
        out: Option<String>,
    },
    /// Print the completion script of a shell for the commands and options of this program
    Completions {
        /// The shell
        #[arg(value_enum)]
        shell: clap_complete::Shell,
    },
    /// Serve a local web page: an editor with verdicts, steps, plots and generated kernels
    ///
    /// Prints the address and runs until Ctrl-C. Worker processes of this program decide the
    /// statements in the editor, each with bounded time and memory. No file except FILE is read,
    /// and none is written.
    Serve {
        /// A file of the forms language to open in the editor
        file: Option<String>,
        /// IP address to bind; if it is not a loopback address, other machines can use the page
        #[arg(long, default_value = "127.0.0.1", value_name = "ADDRESS")]
        bind: IpAddr,
        /// Port, or 0 for any free port
        #[arg(long, default_value_t = forms_serve::USUAL_PORT, value_name = "PORT")]
        port: u16,
        /// Time limit of one request
        #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = interval)]
        time_limit: Duration,
    },
    /// Answer a request of the page of `serve`: the request from standard input, JSON lines to
    /// standard output
    #[command(hide = true)]
    Work {
        /// Task of the request
        task: Task,
        /// Limit of processor time
        #[arg(long, value_name = "SECONDS")]
        seconds: u64,
        /// Limit of memory
        #[arg(long, value_name = "COUNT")]
        mebibytes: u64,
    },
}

/// Notation in which an object is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Notation {
    /// The forms language itself
    Text,
    /// LaTeX
    Latex,
    /// MathML
    Mathml,
}

/// Task requested by the page of `serve`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Task {
    /// Errors and verdicts
    Check,
    /// Steps that decide a statement
    Derive,
    /// A kernel as source
    Emit,
    /// A kernel as a picture
    Plot,
}

/// Program of a kernel that is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Tier {
    /// The formula as written
    Plain,
    /// The generated form
    Stable,
}

/// Parses a duration in seconds.
fn interval(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.ok_or_else(|| "expected a number of seconds from 0 to 1e19".to_owned())
}

/// Parses a prefix of names.
fn prefix(text: &str) -> Result<String, String> {
    let is_name = text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let is_first = text.starts_with(|c: char| c.is_ascii_alphabetic());
    if text.is_empty() || is_name && is_first {
        return Ok(text.to_owned());
    }
    Err("expected letters, digits and underscores, a letter first".to_owned())
}

/// Largest number of arguments per regime for the measurement of accuracy.
const MOST_ARGUMENTS: usize = 1_000_000;

/// Parses a number of arguments per regime.
fn sample_count(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|count| (1..=MOST_ARGUMENTS).contains(count))
        .ok_or_else(|| format!("expected an integer from 1 to {MOST_ARGUMENTS}"))
}

/// Parses a number of samples.
fn budget(text: &str) -> Result<Budget, String> {
    let samples: u64 = text.parse().map_err(|_| "expected an integer".to_owned())?;
    Budget::new(samples).map_err(|error| error.to_string())
}

/// Parses the name of a set of vector instructions that this processor supports.
fn instructions(text: &str) -> Result<Instructions, String> {
    let available = Instructions::available();
    let found = available.iter().find(|set| set.name().eq_ignore_ascii_case(text));
    found.copied().ok_or_else(|| {
        let names: Vec<String> = available.iter().map(|set| set.name().to_lowercase()).collect();
        format!("this processor has {}", names.join(", "))
    })
}

/// Parses an exposure time.
fn exposure(text: &str) -> Result<Exposure, String> {
    let seconds: f64 =
        text.parse().map_err(|_| "expected a number of seconds from 1e-30 to 1e30".to_owned())?;
    Exposure::new(seconds).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        super::Arguments::command().debug_assert();
    }
}
