//! Rendering of a derivation as text and as a LaTeX document.

use super::{Derivation, Line};

/// Indentation of a formula in text.
const INDENT: &str = "    ";

impl Derivation {
    /// Returns the derivation as text: numbered steps with indented formulas.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.name);
        for (number, step) in self.steps.iter().enumerate() {
            text.push_str(&format!("\n{}. {}\n", number + 1, step.title));
            for line in &step.lines {
                match line {
                    Line::Words(words) => text.push_str(&format!("   {words}\n")),
                    Line::Formula(formula) => text.push_str(&format!("{INDENT}  {}\n", formula.text)),
                }
            }
        }
        text
    }

    /// Returns the derivation as a complete LaTeX document; it needs `amsmath`, `amssymb`,
    /// `graphicx` and `geometry`.
    pub fn latex(&self) -> String {
        let mut latex = String::from(
            "\\documentclass{article}\n\\usepackage{amsmath,amssymb,graphicx}\n\
             \\usepackage[margin=2cm]{geometry}\n\
             % A formula wider than the page is scaled down to fit.\n\
             \\newcommand{\\fitted}[1]{\\sbox0{$\\displaystyle #1$}%\n\
             \\ifdim\\wd0>\\linewidth\\resizebox{\\linewidth}{!}{\\usebox0}\\else\\usebox0\\fi}\n\
             \\begin{document}\n",
        );
        latex.push_str(&format!("\\section*{{{}}}\n", escaped(&self.name)));
        for (number, step) in self.steps.iter().enumerate() {
            latex.push_str(&format!("\\subsection*{{{}. {}}}\n", number + 1, escaped(&step.title)));
            for line in &step.lines {
                match line {
                    Line::Words(words) => latex.push_str(&format!("\\noindent {}\\par\n", escaped(words))),
                    Line::Formula(formula) => {
                        latex.push_str(&format!("\\[ \\fitted{{{}}} \\]\n", formula.latex));
                    }
                }
            }
        }
        latex.push_str("\\end{document}\n");
        latex
    }
}

/// Escapes the characters that have a meaning in LaTeX.
fn escaped(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        match c {
            '\\' => text.push_str("\\textbackslash{}"),
            '^' => text.push_str("\\textasciicircum{}"),
            '~' => text.push_str("\\textasciitilde{}"),
            '<' => text.push_str("\\textless{}"),
            '>' => text.push_str("\\textgreater{}"),
            '|' => text.push_str("\\textbar{}"),
            '…' => text.push_str("\\dots{}"),
            '_' | '%' | '&' | '#' | '$' | '{' | '}' => text.extend(['\\', c]),
            _ => text.push(c),
        }
    }
    text
}
