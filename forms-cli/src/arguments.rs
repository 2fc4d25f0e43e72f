//! The command line.

mod solve;

use clap::{Parser, Subcommand, ValueEnum};
use forms::math::Instructions;
use forms_radiometry::scene::Overrides;
use forms_radiometry::simulation::{Budget, Exposure, Share};
pub(crate) use solve::{SolveArguments, ThreadArguments};
use std::net::IpAddr;
use std::time::Duration;

/// Exterior calculus that proves identities exactly and turns them into numeric kernels.
///
/// Called without a command, it shows what it can do: it proves the theory of radiance that comes with it, generates
/// the library's kernels and lights the Cornell box.
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
        /// One JSON object a line
        #[arg(long)]
        json: bool,
        /// Write what is needed to check each verdict
        #[arg(long, value_name = "FILE")]
        certificate: Option<String>,
        /// So many times the work for each statement, of which about a second is usual
        #[arg(long, default_value_t = 1, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
        effort: u32,
    },
    /// Check a certificate of `prove` without the prover
    ///
    /// Exit status: 0 if every entry is accepted, 1 if some are rejected or not covered, 2 if the certificate or a
    /// file it names cannot be read or is not the one that was certified.
    Check {
        /// A certificate; the files it names are found from its folder
        file: String,
        /// Entries that the checker does not cover do no harm
        #[arg(long)]
        allow_uncovered: bool,
    },
    /// Print one named object of a file, simplified
    Show {
        /// A file of the forms language
        file: String,
        /// A name declared in it, or the name of a statement
        name: String,
        /// The notation
        #[arg(long = "as", value_enum, default_value_t = Notation::Text, value_name = "NOTATION")]
        notation: Notation,
        /// Of a closed form: whether it has a potential, or else a cycle with its period
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
        /// The notation; latex is a document, mathml a page
        #[arg(long = "as", value_enum, default_value_t = Notation::Text, value_name = "NOTATION")]
        notation: Notation,
    },
    /// Evaluate a kernel on rows of CSV from standard input
    ///
    /// The first row names the kernel's arguments, in any order. A row outside the kernel's domain gives NaN.
    Eval {
        /// A file of the forms language, or - for the library
        file: String,
        /// A kernel in it
        kernel: String,
        /// The arithmetic: f32, f64, dd for double-double, or exact for 50 certain digits
        #[arg(long, default_value = "f64")]
        precision: String,
        /// The kernel as it was written, or as it is generated
        #[arg(long, value_enum, default_value_t = Tier::Stable)]
        tier: Tier,
    },
    /// Print the kernels of a file as source that compiles as it stands
    Emit {
        /// A file of the forms language, or - for the library
        file: String,
        /// Only this kernel
        #[arg(long)]
        kernel: Option<String>,
        /// The language to write: rust, c, wgsl or cuda
        #[arg(long)]
        target: String,
        /// The numbers: f32, f64 or dd; f64 unless said otherwise, f32 in wgsl
        #[arg(long)]
        precision: Option<String>,
    },
    /// Show what each precision and form of a kernel costs and buys, on typical and on hard arguments
    ///
    /// Times are measured where there is a rustc. With --write, forms that lose fewer bits are looked for, proved equal to
    /// the formulas, and written beside the file, with the ending `stable`; kernels are computed by them from then on.
    Accuracy {
        /// A file of the forms language, or - for the library
        #[arg(default_value = "-")]
        file: String,
        /// Only this kernel
        kernel: Option<String>,
        /// One JSON object a line
        #[arg(long)]
        json: bool,
        /// Look for better forms and write them beside the file
        #[arg(long, conflicts_with_all = ["json", "pages", "kernel"])]
        write: bool,
        /// Write accuracy.md and its figures into this folder
        #[arg(long, value_name = "FOLDER")]
        pages: Option<String>,
        /// Arguments in each regime
        #[arg(long, default_value_t = 128, value_name = "COUNT", value_parser = sample_count)]
        samples: usize,
        /// Do not measure times
        #[arg(long)]
        no_times: bool,
    },
    /// Simulate a scene: print what is simulated and why, then what each receiver gets, with its error
    ///
    /// Ctrl-C stops the work: what is there by then is printed and written. Exit status: 0 if the work was done, 3 if it
    /// was and a number is less exact than was asked for, 2 if the scene has errors or a file cannot be written, 130 if the work
    /// was stopped.
    ///
    /// Work by paths that was killed goes on from its --checkpoint, to the same bits, and can be divided among machines: each
    /// does one --shard, and `forms merge` puts the parts together to what one run would have given, bit for bit.
    Simulate {
        /// A scene, in TOML or of Mitsuba 3 (.xml)
        scene: String,
        /// Write results.csv, error.svg, and for each map an EXR and a PNG file into this folder; with --shard the file of the part
        #[arg(long, value_name = "DIR")]
        out: Option<String>,
        /// Keep the state of the work in this file, and go on from it if it is there
        #[arg(long, value_name = "FILE")]
        checkpoint: Option<String>,
        /// Seconds from one state that is kept to the next
        #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = interval, requires = "checkpoint")]
        every: Duration,
        /// Do one of n equal shares of the work, i from 1 to n or from 0 to n − 1, and write it to the file --out
        #[arg(long, value_name = "i/n", requires = "out")]
        shard: Option<Share>,
        /// Give each number, cell and pixel so many samples, a multiple of 32, instead of what the tolerance asks for
        #[arg(long, value_name = "COUNT", value_parser = budget)]
        samples: Option<Budget>,
        /// Compute with these vector instructions and not with the best there are: baseline has the same bits on all processors
        #[arg(long, value_name = "NAME", value_parser = instructions)]
        isa: Option<Instructions>,
        /// Add the exposure behind each irradiance, and the fluence behind each fluence rate, over this time in J/m²
        #[arg(long, value_name = "SECONDS", value_parser = exposure, allow_negative_numbers = true)]
        exposure: Option<Exposure>,
        #[command(flatten)]
        solve: SolveArguments,
        #[command(flatten)]
        threads: ThreadArguments,
        /// One JSON object a line
        #[arg(long)]
        json: bool,
    },
    /// Put the parts of a simulation together that were written with --shard, to what one run gives
    ///
    /// The parts may be given in any order, and more than once. One that is missing, damaged or of other work is named, with
    /// the call that makes it. Exit status: 0 if all is there, 3 if it is and a number is less exact than was
    /// asked for, 2 if not.
    Merge {
        /// The files that `forms simulate --shard` has written
        #[arg(required = true, value_name = "PART")]
        parts: Vec<String>,
        /// Write results.csv, error.svg, and for each map an EXR and a PNG file into this folder
        #[arg(long, value_name = "DIR")]
        out: Option<String>,
        #[command(flatten)]
        threads: ThreadArguments,
        /// One JSON object a line
        #[arg(long)]
        json: bool,
    },
    /// Print the view factors between the surfaces of a scene as CSV
    ///
    /// A row holds the fractions of what one surface sends that arrive at each of the others, and their sum, which is 1 where
    /// nothing leaves the scene. A two-sided surface sends from both sides. Flat pieces stand for disks and spheres: what half
    /// as many edges round them would change is part of the errors.
    ViewFactors {
        /// A scene, in TOML or of Mitsuba 3 (.xml)
        scene: String,
        /// Work to this error, relative to each factor, whatever the scene says
        #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = Overrides::tolerance)]
        tolerance: Option<f64>,
        #[command(flatten)]
        threads: ThreadArguments,
        /// One JSON object a line, with the error of each factor
        #[arg(long)]
        json: bool,
    },
    /// List the kernels of the library with their arguments, units and formulas
    Kernels,
    /// Write the book as pages of HTML, each statement with its verdict and the steps that decide it
    ///
    /// The pages need no network and no scripts. With --preprocess, a book of mdBook is read from standard input and written
    /// with formulas and verdicts in place: see docs/book/book.toml.
    Book {
        /// The folder to write to
        #[arg(long, value_name = "DIR", default_value = "target/book")]
        out: String,
        /// Be a preprocessor of mdBook
        #[arg(long, conflicts_with = "out")]
        preprocess: bool,
        /// What mdBook asks before it sends a book: `supports html`
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
    /// Print what a shell needs to complete the commands and options of this program
    Completions {
        /// The shell
        #[arg(value_enum)]
        shell: clap_complete::Shell,
    },
    /// Show a page to play with, on this machine: an editor with verdicts, steps, plots and generated kernels
    ///
    /// Prints the address and runs until Ctrl-C. What is typed is decided by other processes of this program, each with
    /// bounded time and memory. No file but FILE is read, and none is written.
    Serve {
        /// A file of the forms language that the editor begins with
        file: Option<String>,
        /// The address to listen at; with another than that of this machine, others can use the page
        #[arg(long, default_value = "127.0.0.1", value_name = "ADDRESS")]
        bind: IpAddr,
        /// The port, or 0 for any that is free
        #[arg(long, default_value_t = forms_serve::USUAL_PORT, value_name = "PORT")]
        port: u16,
        /// The time that one request may take
        #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = interval)]
        time_limit: Duration,
    },
    /// Work for the page of `serve`: a request from standard input, JSON lines to standard output
    #[command(hide = true)]
    Work {
        /// What is asked for
        task: Task,
        /// The processor time that is granted
        #[arg(long, value_name = "SECONDS")]
        seconds: u64,
        /// The memory that is granted
        #[arg(long, value_name = "COUNT")]
        mebibytes: u64,
    },
}

/// How an object is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Notation {
    /// The forms language itself
    Text,
    /// LaTeX
    Latex,
    /// MathML
    Mathml,
}

/// What the page asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Task {
    /// Errors and verdicts
    Check,
    /// The steps that decide a statement
    Derive,
    /// A kernel as source
    Emit,
    /// A kernel as a picture
    Plot,
}

/// Which program of a kernel is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Tier {
    /// As it was written
    Plain,
    /// As it is generated
    Stable,
}

/// The time between two states that are kept.
fn interval(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.ok_or_else(|| "expected a number of seconds from 0 to 1e19".to_owned())
}

/// The most arguments in each regime that accuracy is measured at.
const MOST_ARGUMENTS: usize = 1_000_000;

/// A number of arguments in each regime.
fn sample_count(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|count| (1..=MOST_ARGUMENTS).contains(count))
        .ok_or_else(|| format!("expected a whole number from 1 to {MOST_ARGUMENTS}"))
}

/// A number of samples.
fn budget(text: &str) -> Result<Budget, String> {
    let samples: u64 = text.parse().map_err(|_| "expected a whole number".to_owned())?;
    Budget::new(samples).map_err(|error| error.to_string())
}

/// Vector instructions that this processor has.
fn instructions(text: &str) -> Result<Instructions, String> {
    let available = Instructions::available();
    let found = available.iter().find(|set| set.name().eq_ignore_ascii_case(text));
    found.copied().ok_or_else(|| {
        let names: Vec<String> = available.iter().map(|set| set.name().to_lowercase()).collect();
        format!("this processor has {}", names.join(", "))
    })
}

/// A time of exposure.
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
