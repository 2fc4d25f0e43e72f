//! Colours for a terminal.

use anstyle::{AnsiColor, Effects, Style};
use std::io::IsTerminal;

/// Colours of the output; plain text if the output is not a terminal or the user disabled colours.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Palette {
    coloured: bool,
}

impl Palette {
    /// Returns the palette of standard output: colours on a terminal, unless `NO_COLOR` is set.
    pub(crate) fn of_output() -> Self {
        let forbidden = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let dumb = std::env::var_os("TERM").is_none_or(|terminal| terminal == "dumb");
        Palette { coloured: std::io::stdout().is_terminal() && !forbidden && !dumb }
    }

    fn paint(self, style: Style, text: &str) -> String {
        if self.coloured { format!("{style}{text}{style:#}") } else { text.to_string() }
    }

    /// Marks a success.
    pub(crate) fn good(self, text: &str) -> String {
        self.paint(AnsiColor::Green.on_default(), text)
    }

    /// Marks a failure.
    pub(crate) fn bad(self, text: &str) -> String {
        self.paint(AnsiColor::Red.on_default(), text)
    }

    /// Marks a notable result.
    pub(crate) fn notable(self, text: &str) -> String {
        self.paint(AnsiColor::Yellow.on_default(), text)
    }

    /// Dims secondary text.
    pub(crate) fn quiet(self, text: &str) -> String {
        self.paint(Style::new().effects(Effects::DIMMED), text)
    }

    /// Marks a heading.
    pub(crate) fn heading(self, text: &str) -> String {
        self.paint(Style::new().effects(Effects::BOLD), text)
    }
}
