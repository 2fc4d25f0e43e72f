//! Tables of text and numbers in HTML.

use super::print_content;
use std::fmt::Write;

/// A table with a header; a notebook shows it in HTML.
///
/// ```
/// let squares = (1..=3).map(|n| [n.to_string(), (n * n).to_string()]);
/// let table = forms_core::notebook::Table::new(["n", "n²"], squares);
/// assert!(table.html().contains("<td>3</td><td>9</td>"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Creates a table from its cells, row by row; a row can be shorter than the header.
    pub fn new<H, R, C>(head: H, rows: R) -> Self
    where
        H: IntoIterator<Item: Into<String>>,
        R: IntoIterator<Item = C>,
        C: IntoIterator<Item: Into<String>>,
    {
        let row = |cells: C| cells.into_iter().map(Into::into).collect();
        Table { head: head.into_iter().map(Into::into).collect(), rows: rows.into_iter().map(row).collect() }
    }

    /// Returns the table as an HTML `<table>`.
    pub fn html(&self) -> String {
        let mut html = String::from("<table>\n<thead><tr>");
        for cell in &self.head {
            let _ = write!(html, "<th>{}</th>", escaped(cell));
        }
        html.push_str("</tr></thead>\n<tbody>\n");
        for row in &self.rows {
            let cells: String = row.iter().map(|cell| format!("<td>{}</td>", escaped(cell))).collect();
            let _ = writeln!(html, "<tr>{cells}</tr>");
        }
        html + "</tbody>\n</table>"
    }

    /// Shows the table in a cell of a notebook.
    pub fn evcxr_display(&self) {
        print_content("text/html", &self.html());
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
