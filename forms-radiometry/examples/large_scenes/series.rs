//! Series of measurements: kinds of scenes of increasing size, with one thread and with two, and
//! their tables and figures.

use super::measured::{self, Measured};
use super::{points, room};
use forms_figures::{Axis, Colour, Mark, Numbers, Plot, Series as Line};
use forms_testing::page::{self, processor};
use std::fmt::Write;
use std::io;
use std::path::PathBuf;

const THREADS: [usize; 2] = [1, 2];

/// Kind of scene: its name on the command line and in prose, and its text for a number.
struct Kind {
    argument: &'static str,
    words: &'static str,
    text: fn(usize) -> String,
    /// Largest number that does not take too long.
    most: usize,
}

/// Kinds of scenes in which the number of one thing increases.
pub(crate) struct Series {
    /// Thing whose number increases.
    pub(crate) name: &'static str,
    pub(crate) numbers: &'static [usize],
    caption: &'static str,
    kinds: &'static [Kind],
    /// Whether memory has a figure too, next to its column of the table.
    draws_memory: bool,
}

const SURFACES: Series = Series {
    name: "surfaces",
    numbers: &[10, 100, 1_000, 10_000, 100_000],
    caption: "ten receivers within 1%",
    kinds: &[Kind { argument: "boxes", words: "room of boxes", text: room::asked, most: usize::MAX }],
    draws_memory: false,
};

const RECEIVERS: Series = Series {
    name: "receivers",
    numbers: &[100, 1_000, 10_000, 100_000, 1_000_000],
    caption: "lamps to rounding, the cube within 10%",
    kinds: &[
        Kind { argument: "lamp", words: "free lamp", text: points::under_a_lamp, most: usize::MAX },
        Kind {
            argument: "plate",
            words: "lamp behind a plate",
            text: points::under_a_plate,
            most: usize::MAX,
        },
        Kind { argument: "cube", words: "closed cube", text: points::in_a_cube, most: 100_000 },
    ],
    draws_memory: true,
};

/// Returns all series.
pub(crate) fn all() -> [Series; 2] {
    [SURFACES, RECEIVERS]
}

/// Returns the text of a scene of the kind with this name.
pub(crate) fn text(argument: &str, number: usize) -> Option<String> {
    let all = all();
    let kind = all.iter().flat_map(|series| series.kinds).find(|kind| kind.argument == argument)?;
    Some((kind.text)(number))
}

/// Measurements of one scene with this number of threads.
pub(crate) struct Row {
    kind: &'static Kind,
    threads: usize,
    found: Measured,
}

impl Series {
    /// Measures scenes of every kind in these numbers, and prints the table as it grows.
    pub(crate) fn measured(&self, numbers: &[usize]) -> io::Result<Vec<Row>> {
        let mut rows = Vec::new();
        print!("{}", self.head());
        for kind in self.kinds {
            for &number in numbers.iter().filter(|&&number| number <= kind.most) {
                for threads in THREADS {
                    let found = measured::elsewhere(kind.argument, number, threads)?;
                    let row = Row { kind, threads, found };
                    println!("{}", self.line(&row));
                    rows.push(row);
                }
            }
        }
        Ok(rows)
    }

    /// Writes the table and the figures.
    pub(crate) fn write(&self, rows: &[Row]) -> io::Result<()> {
        let documents = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs");
        let mut table = format!("Processor: {}.\n\n{}", processor(), self.head());
        for row in rows {
            writeln!(table, "{}", self.line(row)).expect("a String takes all text");
        }
        let path = documents.join("benchmarks.md");
        let page = page::replaced(&std::fs::read_to_string(&path)?, &format!("many {}", self.name), &table);
        std::fs::write(path, page)?;
        let figure = |ending: &str| documents.join(format!("figures/many_{}{ending}.svg", self.name));
        std::fs::write(figure(""), self.times(rows).svg())?;
        if self.draws_memory { std::fs::write(figure("_memory"), self.memory(rows).svg()) } else { Ok(()) }
    }

    /// Whether there are several kinds of scenes to distinguish.
    fn has_kinds(&self) -> bool {
        self.kinds.len() > 1
    }

    fn head(&self) -> String {
        let [kind, rule] = if self.has_kinds() { ["| scene ", "|---"] } else { ["", ""] };
        format!(
            "{kind}| {} | threads | reading | plan | answers | memory | largest error |\n\
             {rule}|---|---|---|---|---|---|---|\n",
            self.name
        )
    }

    fn line(&self, Row { kind, threads, found }: &Row) -> String {
        let Measured { count, reading, planning, answering, memory, error } = found;
        let mebibytes = memory / 1024.0;
        let kind = if self.has_kinds() { format!("| {} ", kind.words) } else { String::new() };
        format!(
            "{kind}| {count} | {threads} | {reading:.3} s | {planning:.3} s | {answering:.3} s | {mebibytes:.0} MiB | {error:.1e} |"
        )
    }

    fn plot(&self, what: &str, numbers: Numbers, series: Vec<Line>) -> Plot {
        Plot {
            title: format!("{what} against the number of {}", self.name),
            description: format!("{what} grows with the number of {}; both axes are logarithmic.", self.name),
            note: format!("{}, {}", processor(), self.caption),
            x: Axis::logarithmic(format!("number of {}", self.name)).with_numbers(Numbers::Thousands),
            y: Axis::logarithmic(what.to_lowercase()).with_numbers(numbers),
            series,
            ..Plot::default()
        }
    }

    fn times(&self, rows: &[Row]) -> Plot {
        let name = |kind: &Kind, threads: usize| {
            let what = if self.has_kinds() { kind.words } else { "plan and answers" };
            format!("{what}, {threads} thread{}", if threads == 1 { "" } else { "s" })
        };
        let time = |found: &Measured| found.planning + found.answering;
        let mut lines = Vec::new();
        // the two lines of a kind have one colour
        for (kind, colour) in self.kinds.iter().zip(Colour::DATA) {
            for (threads, mark) in THREADS.into_iter().zip([Mark::Dot, Mark::Ring]) {
                let points = points_of(rows, kind, threads, time);
                lines.push(Line::line(name(kind, threads), points).coloured(colour).marked(mark));
            }
        }
        let points = points_of(rows, &self.kinds[0], 1, |found| found.reading);
        let reading = Line::line("reading the file", points).marked(Mark::Square);
        lines.push(reading.coloured(Colour::DATA[self.kinds.len()]));
        self.plot("Time", Numbers::Seconds, lines)
    }

    fn memory(&self, rows: &[Row]) -> Plot {
        let line = |(kind, mark): (&Kind, Mark)| {
            Line::line(kind.words, points_of(rows, kind, 1, |found| 1024.0 * found.memory)).marked(mark)
        };
        self.plot("Memory", Numbers::Bytes, self.kinds.iter().zip(Mark::ALL).map(line).collect())
    }
}

/// Returns a figure of every scene of a kind, measured with this number of threads.
fn points_of(rows: &[Row], kind: &Kind, threads: usize, figure: fn(&Measured) -> f64) -> Vec<[f64; 2]> {
    let is_meant = |row: &&Row| row.kind.argument == kind.argument && row.threads == threads;
    rows.iter().filter(is_meant).map(|row| [row.found.count as f64, figure(&row.found)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_lines_of_a_kind_have_one_colour_and_marks_of_their_own() {
        let mut rows = Vec::new();
        for kind in RECEIVERS.kinds {
            for (threads, count) in [(1, 100), (1, 1000), (2, 100), (2, 1000)] {
                let seconds = count as f64 * 1e-4 / threads as f64;
                let found = Measured {
                    count,
                    reading: 1e-3,
                    planning: seconds,
                    answering: seconds,
                    memory: 4096.0,
                    error: 1e-9,
                };
                rows.push(Row { kind, threads, found });
            }
        }
        let times = RECEIVERS.times(&rows);
        let looks: Vec<_> = times.series.iter().map(|line| (line.colour, line.mark)).collect();
        assert_eq!(looks.len(), 2 * RECEIVERS.kinds.len() + 1);
        assert!(
            looks[0].0 == looks[1].0 && looks[0].1 != looks[1].1 && looks[1].0 != looks[2].0,
            "{looks:?}"
        );
        assert!(times.svg().contains(">closed cube, 2 threads</text>"));
        assert!(RECEIVERS.memory(&rows).svg().contains(">10 MB</text>"));
    }
}
