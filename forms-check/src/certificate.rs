//! Certificates: files, and for each statement a proof, a refutation or the reason why there is
//! neither.

use crate::line::{Line, Offered};
use crate::proof::{self, Subject};
use crate::theory::Theory;
use crate::{Checked, Claim, Outcome, Stop, integral, malformed, witness};

/// First line of every certificate.
const HEADER: &str = "forms certificate 1";

/// Computes the FNV-1a hash. It only detects a changed file; the soundness of a check does not
/// depend on it.
fn hash(text: &str) -> String {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    format!("{:016x}", text.bytes().fold(0xcbf2_9ce4_8422_2325, step))
}

fn lines(text: &str) -> Result<Vec<Line>, Stop> {
    let mut rows = text.lines().map(str::trim).filter(|row| !row.is_empty());
    if rows.next() != Some(HEADER) {
        return Err(malformed(format!(
            "the first line is not `{HEADER}`; `forms prove` decides the statements of a theory"
        )));
    }
    let split = |row: &str| match row.split_once(' ') {
        Some((keyword, rest)) => (keyword.to_string(), rest.trim().to_string()),
        None => (row.to_string(), String::new()),
    };
    Ok(rows.map(split).collect())
}

/// Checks every entry; `read` returns the text of a file by its name in the certificate.
pub(crate) fn check(
    text: &str,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
) -> Result<Vec<Checked>, Stop> {
    let lines = lines(text)?;
    let mut checked: Vec<Checked> = Vec::new();
    let mut sections = lines.split(|line| line.0 == "file");
    if sections.next().is_some_and(|before| !before.is_empty()) {
        return Err(malformed("there are lines before the first `file`"));
    }
    if !lines.iter().any(|line| line.0 == "file") {
        return Err(malformed("it names no file"));
    }
    let names = lines.iter().filter(|line| line.0 == "file").map(|line| &line.1);
    for (file, section) in names.zip(sections) {
        let source = read(file).map_err(malformed)?;
        check_file((file, &source), section, &mut checked)?;
    }
    Ok(checked)
}

/// Checks the entries of one file with this source.
fn check_file(
    (file, source): (&str, &str),
    section: &[Line],
    checked: &mut Vec<Checked>,
) -> Result<(), Stop> {
    let Some(((keyword, listed), entries)) = section.split_first() else {
        return Err(malformed("a file without its hash"));
    };
    if keyword != "hash" || *listed != hash(source) {
        return Err(malformed(format!("{file} is not the file that was certified: its hash differs")));
    }
    let (claims, offered) = claims_and_integrals(entries)?;
    let mut theory = Theory::read(source, offered).map_err(|stop| {
        malformed(format!("the statements of {file} cannot be decided: {}", stop.into_text()))
    })?;
    let is_known = |checked: &[Checked], name: &str| {
        checked.iter().any(|known| known.file == file && known.name == name)
    };
    for (head, body) in claims {
        let name = head.1.split(' ').next().unwrap_or_default().to_string();
        if is_known(checked, &name) {
            return Err(malformed(format!("`{name}` has two entries")));
        }
        let outcome = entry(&mut theory, head, &name, body)?;
        let shown = match head.0.as_str() {
            "proved" => Some(Claim::Prove),
            "refuted" => Some(Claim::Refute),
            _ => None,
        };
        let shown = shown.filter(|_| outcome == Outcome::Accepted);
        let claim = theory.claim(&name).unwrap_or(Claim::Prove);
        checked.push(Checked { file: file.to_string(), name, claim, shown, outcome });
    }
    for name in theory.statement_names() {
        if !is_known(checked, &name) {
            let outcome = Outcome::NotCovered("the certificate has no entry".into());
            let claim = theory.claim(&name).unwrap_or(Claim::Prove);
            checked.push(Checked { file: file.to_string(), name, claim, shown: None, outcome });
        }
    }
    Ok(())
}

/// First line of an entry for a statement, and the lines after it.
type Entry<'l> = (&'l Line, &'l [Line]);

/// Divides the entries of a file into those for statements, and the offered antiderivatives.
fn claims_and_integrals(entries: &[Line]) -> Result<(Vec<Entry<'_>>, Offered), Stop> {
    let is_start = |line: &Line| ["integral", "proved", "refuted", "uncovered"].contains(&line.0.as_str());
    let (mut rest, mut claims, mut offered) = (entries, Vec::new(), Offered::new());
    while let Some((head, after)) = rest.split_first() {
        let length = after.iter().position(is_start).unwrap_or(after.len());
        let (body, next) = after.split_at(length);
        rest = next;
        if head.0 == "integral" {
            integral::offer(&mut offered, &head.1, body)?;
        } else {
            claims.push((head, body));
        }
    }
    Ok((claims, offered))
}

fn entry(theory: &mut Theory, head: &Line, name: &str, body: &[Line]) -> Result<Outcome, Stop> {
    if head.0 == "uncovered" {
        let why = head.1.split_once(' ').map_or("", |(_, why)| why);
        return Ok(Outcome::NotCovered(why.to_string()));
    }
    // the prover has read the source, so a source that the checker cannot read is not covered
    // rather than malformed
    let statement = match theory.statement(name) {
        Err(Stop::Malformed(what)) => return Ok(Outcome::NotCovered(what)),
        other => other,
    };
    let statement = match statement {
        Ok(statement) => statement,
        Err(Stop::Uncovered(what)) => return Ok(Outcome::NotCovered(what)),
        Err(stop) => return Ok(Outcome::Rejected(stop.into_text())),
    };
    let result = match head.0.as_str() {
        "proved" => {
            let (at, proof) = body.split_at(body.iter().take_while(|line| line.0 == "at").count());
            proof::check(theory, &statement, proof, Subject::Statement)
                .and_then(|()| witness::check_inhabited(theory, &statement, at))
        }
        "refuted" => witness::check(theory, &statement, body),
        other => Err(malformed(format!("unknown keyword `{other}` at the start of an entry"))),
    };
    match result {
        // when the pool was full, one node stood for others
        _ if theory.pool.is_full() => Ok(Outcome::NotCovered("expressions with too many nodes".into())),
        Ok(()) => Ok(Outcome::Accepted),
        Err(Stop::Malformed(why)) => Err(malformed(format!("{name}: {why}"))),
        // a proof that needs more than the checker covers proves nothing
        Err(Stop::Uncovered(why) | Stop::Rejected(why)) => Ok(Outcome::Rejected(why)),
        Err(Stop::Undefined) => Ok(Outcome::Rejected("it divides by zero".into())),
    }
}
