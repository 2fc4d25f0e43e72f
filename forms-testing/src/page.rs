//! Helpers for a page of measurements: the processor's name, and the replacement of a table in the
//! page.

/// Returns the name of the processor, if the system reports it.
pub fn processor() -> String {
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = information.lines().find_map(|line| line.strip_prefix("model name"));
    name.map_or("unknown", |name| name.trim_start_matches(['\t', ' ', ':'])).to_string()
}

/// Replaces the text between `<!-- measured: PART -->` and the next `<!-- end -->` by these rows;
/// returns the page unchanged if it has no such marks.
pub fn replaced(page: &str, part: &str, rows: &str) -> String {
    let begin = format!("<!-- measured: {part} -->\n");
    let end = "<!-- end -->";
    let parts = page.split_once(&begin).and_then(|(head, rest)| Some((head, rest.split_once(end)?.1)));
    parts.map_or_else(|| page.to_string(), |(head, tail)| format!("{head}{begin}{rows}{end}{tail}"))
}
