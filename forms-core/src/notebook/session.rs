//! A theory in a notebook: its text, its declarations, and its errors.

use super::{escaped, print_content, print_markdown};
use crate::check::{decide_all, read_file};
use crate::compile::{compile_kernel, kernel_faults};
use crate::decide::Verdict;
use crate::derivation::{Derivation, derive};
use crate::diagnostic::{Diagnostic, counted};
use crate::generation::{Fault, Generated};
use crate::notation::{latex_as_written, latex_of_condition, latex_of_name, latex_of_named, text_of_named};
use crate::syntax::Source;
use crate::syntax::ast::{Claim, Condition, Expr, File, ItemKind};
use crate::theory::Theory;

/// A parsed and resolved text of the language. A notebook shows how much it declares, or its
/// errors.
///
/// ```
/// use forms_core::notebook::Session;
/// let mut session = Session::read("chart R2(x, y); form w = x*dy; prove area: d(w) == dx^dy;");
/// assert_eq!(session.show("w").text, "w = x*dy");
/// assert_eq!(session.show("area").latex, r"\mathrm{d}w = \mathrm{d}x\wedge \mathrm{d}y");
/// assert!(session.decide().are_as_claimed());
/// ```
#[derive(Clone, Debug)]
pub struct Session {
    source: Source,
    file: File,
    theory: Theory,
    errors: Vec<Diagnostic>,
}

/// A formula in the language's notation and in LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The formula in the language's notation.
    pub text: String,
    /// The formula in LaTeX.
    pub latex: String,
}

/// Every claim of a session with its verdict.
#[derive(Clone, Debug)]
pub struct Decided {
    claims: Vec<DecidedClaim>,
    /// Claims of kernels about themselves that were not proved.
    faults: Vec<Fault>,
}

#[derive(Clone, Debug)]
struct DecidedClaim {
    name: String,
    claim: Claim,
    formula: Shown,
    verdict: Verdict,
}

impl Session {
    /// Reads a text. Its errors are shown, and the declarations that do not depend on them can be
    /// used.
    pub fn read(text: &str) -> Self {
        let (file, theory, errors) = read_file(text);
        Session { source: Source::new("cell", text), file, theory, errors }
    }

    /// Returns the theory that the text declares.
    pub fn theory(&self) -> &Theory {
        &self.theory
    }

    /// Compiles a kernel of the text in its numerically stable form.
    ///
    /// ```
    /// use forms_core::notebook::Session;
    /// let mut session = Session::read("kernel growth(x) = exp(x) - 1;");
    /// assert_eq!(session.kernel("growth").unwrap().values(&[1e-17]), [1e-17]);
    /// ```
    ///
    /// # Errors
    /// If there is no kernel of that name, or the kernel has errors.
    pub fn kernel(&mut self, name: &str) -> Result<Generated, String> {
        let Some(kernel) = self.theory.kernels.iter().find(|kernel| kernel.name == name).cloned() else {
            return Err(format!("no kernel is named `{name}`"));
        };
        compile_kernel(&mut self.theory.pool, &kernel)
            .map_err(|errors| errors.iter().map(|error| self.source.render(error)).collect())
    }

    /// Shows the object with this name: for a form, its expression as written and, if different,
    /// simplified; for a claim, its equation.
    pub fn show(&mut self, name: &str) -> Shown {
        if let Some(equation) = self.equation(name) {
            return equation;
        }
        let values = text_of_named(&mut self.theory, name).zip(latex_of_named(&mut self.theory, name));
        let Some((text, latex)) = values else {
            let message = format!("nothing is named `{name}`");
            let name = name.replace('_', "\\_");
            return Shown { latex: format!("\\text{{nothing is named }}\\texttt{{{name}}}"), text: message };
        };
        let mut shown = Shown { text: name.to_owned(), latex: latex_of_name(name) };
        // the text of charts, unknown functions and variables already begins with their name
        if text.split('(').next() == Some(name) {
            return Shown { text, latex };
        }
        if let Some(written) = self.written(name).filter(|written| written.latex != latex) {
            shown = shown.joined("=", &written);
        }
        shown.joined("=", &Shown { text, latex })
    }

    /// Decides every claim, in order, and the claims of kernels about themselves.
    pub fn decide(&mut self) -> Decided {
        let verdicts = decide_all(&mut self.theory);
        let statements = self.theory.statements.clone();
        let claims = statements.into_iter().zip(verdicts).map(|(statement, verdict)| DecidedClaim {
            formula: self.show(&statement.name),
            name: statement.name,
            claim: statement.claim,
            verdict,
        });
        let claims = claims.collect();
        Decided { claims, faults: kernel_faults(&mut self.theory) }
    }

    /// Returns the steps that decide one claim.
    ///
    /// # Errors
    /// If no claim has that name, or the text has errors.
    pub fn derive(&self, name: &str) -> Result<Derivation, String> {
        if !self.errors.is_empty() {
            return Err(self.mistakes());
        }
        let known: Vec<&str> =
            self.theory.statements.iter().map(|statement| statement.name.as_str()).collect();
        derive(&self.source, name)
            .ok_or_else(|| format!("no claim is named `{name}`; the claims are: {}", known.join(", ")))
    }

    /// Shows in a cell of a notebook how much was declared, or the errors.
    pub fn evcxr_display(&self) {
        if !self.errors.is_empty() {
            print_content("text/plain", &self.mistakes());
            return;
        }
        let theory = &self.theory;
        let numbers = [
            (theory.charts.len(), "chart"),
            (theory.maps.len(), "map"),
            (theory.objects.len(), "named value"),
            (theory.kernels.len(), "kernel"),
            (theory.statements.len(), "claim"),
        ];
        let some = numbers.into_iter().filter(|(number, _)| *number > 0);
        let parts: Vec<String> = some.map(|(number, noun)| counted(number, noun)).collect();
        print_content("text/plain", &parts.join(", "));
    }

    fn mistakes(&self) -> String {
        self.errors.iter().map(|error| self.source.render(error)).collect()
    }

    /// Returns the equation of a claim as its author wrote it.
    fn equation(&self, wanted: &str) -> Option<Shown> {
        self.file.items.iter().find_map(|item| match &item.kind {
            ItemKind::Statement { name, left, right, conditions, .. } if name.text == wanted => {
                let sides = self.expression(left).joined("==", &self.expression(right));
                Some(sides.under(self, conditions))
            }
            _ => None,
        })
    }

    /// Returns the expression of a named value as its author wrote it.
    fn written(&self, wanted: &str) -> Option<Shown> {
        self.file.items.iter().find_map(|item| match &item.kind {
            ItemKind::Let { name, value, .. }
            | ItemKind::Form { name, value, .. }
            | ItemKind::Field { name, value, .. }
                if name.text == wanted =>
            {
                Some(self.expression(value))
            }
            _ => None,
        })
    }

    fn expression(&self, expression: &Expr) -> Shown {
        let text = self.quoted(expression.span.start, expression.span.end);
        Shown { text, latex: latex_as_written(&self.theory, expression) }
    }

    /// Returns a part of the text on one line.
    fn quoted(&self, start: u32, end: u32) -> String {
        let text = self.source.text.get(start as usize..end as usize).unwrap_or_default();
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

impl Shown {
    /// Shows the formula in a cell of a notebook.
    pub fn evcxr_display(&self) {
        print_content("text/latex", &format!("$\\displaystyle {}$", self.latex));
        print_content("text/plain", &self.text);
    }

    /// Returns the equation of two expressions; `sign` joins them in the text.
    fn joined(&self, sign: &str, right: &Shown) -> Shown {
        Shown {
            text: format!("{} {sign} {}", self.text, right.text),
            latex: format!("{} = {}", self.latex, right.latex),
        }
    }

    fn under(self, session: &Session, conditions: &[Condition]) -> Shown {
        if conditions.is_empty() {
            return self;
        }
        let texts =
            conditions.iter().map(|condition| session.quoted(condition.span.start, condition.span.end));
        let latex = conditions.iter().map(|condition| latex_of_condition(&session.theory, condition));
        let [texts, latex] =
            [texts.collect::<Vec<_>>(), latex.collect::<Vec<_>>()].map(|parts| parts.join(", "));
        Shown {
            text: format!("{} where {texts}", self.text),
            latex: format!("{} \\quad\\text{{where}}\\quad {latex}", self.latex),
        }
    }
}

impl Decided {
    /// Returns the verdicts in the order of the claims.
    pub fn verdicts(&self) -> impl Iterator<Item = &Verdict> {
        self.claims.iter().map(|decided| &decided.verdict)
    }

    /// Returns the verdict on the claim with this name.
    pub fn verdict(&self, name: &str) -> Option<&Verdict> {
        self.claims.iter().find(|decided| decided.name == name).map(|decided| &decided.verdict)
    }

    /// Whether every claim has the verdict that its author claims, and no kernel has a fault.
    pub fn are_as_claimed(&self) -> bool {
        self.claims.iter().all(DecidedClaim::is_as_claimed) && self.faults.is_empty()
    }

    /// Returns each claim in Markdown: its name and verdict, and its equation in LaTeX.
    pub fn markdown(&self) -> String {
        let each = |decided: &DecidedClaim| {
            let DecidedClaim { name, formula, verdict, .. } = decided;
            let surprise = if decided.is_as_claimed() { "" } else { ", **not as claimed**" };
            let verdict = verdict.markdown();
            format!(
                "{} {} is {verdict}{surprise}\n\n$${}$$\n\n",
                decided.mark(),
                escaped(name),
                formula.latex
            )
        };
        let of_kernel = |fault: &Fault| {
            let (kernel, claim) = (escaped(&fault.kernel), fault.claim.name());
            format!("✗ {kernel}, `{claim}`, is {}, **not as claimed**\n\n", fault.verdict.markdown())
        };
        self.claims.iter().map(each).chain(self.faults.iter().map(of_kernel)).collect()
    }

    /// Shows the claims with their verdicts in a cell of a notebook.
    pub fn evcxr_display(&self) {
        let each = |decided: &DecidedClaim| {
            format!("{} {}: {}\n", decided.mark(), decided.name, decided.verdict.name())
        };
        let of_kernel =
            |fault: &Fault| format!("✗ {}, {}: {}\n", fault.kernel, fault.claim.name(), fault.verdict.name());
        let lines = self.claims.iter().map(each).chain(self.faults.iter().map(of_kernel));
        print_markdown(&self.markdown(), &lines.collect::<String>());
    }
}

impl DecidedClaim {
    fn is_as_claimed(&self) -> bool {
        self.verdict.bears_out(self.claim)
    }

    fn mark(&self) -> &'static str {
        if self.is_as_claimed() { "✓" } else { "✗" }
    }
}
