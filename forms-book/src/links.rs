//! Links between files: each leads to a file that exists and to a heading in it.

use crate::check::{Problem, Report};
use crate::page::{Link, Page};
use std::path::Path;

/// Checks the relative links and pictures of a page, below the root of the repository.
pub fn check_links(page: &Page, root: &Path) -> Report {
    let mut report = Report::default();
    for link in page.links().iter().filter(|link| is_relative(&link.target)) {
        report.counted.links += 1;
        report.problems.extend(follow(page, link, root).err());
    }
    report
}

/// Whether a target is a file of the repository or a heading of the page itself.
pub(crate) fn is_relative(target: &str) -> bool {
    !target.contains("://") && !target.starts_with("mailto:")
}

fn follow(page: &Page, link: &Link, root: &Path) -> Result<(), Problem> {
    let broken = |message: String| page.problem(link.line, message);
    let (path, anchor) = resolved(&page.path, &link.target)
        .ok_or_else(|| broken(format!("the link {} leads out of the repository", link.target)))?;
    if path != page.path && !root.join(&path).exists() {
        return Err(broken(format!("the link {} leads to {path}, which does not exist", link.target)));
    }
    let Some(anchor) = anchor else { return Ok(()) };
    if !path.ends_with(".md") {
        let message = format!("the link {} names a heading of a file that is not a page", link.target);
        return Err(broken(message));
    }
    let other = if path == page.path {
        page.clone()
    } else {
        let text = std::fs::read_to_string(root.join(&path));
        Page::new(&path, text.map_err(|error| broken(format!("cannot read {path}: {error}")))?)
    };
    if other.anchors().contains(&anchor) {
        return Ok(());
    }
    Err(broken(format!("the link {} names a heading that {path} does not have", link.target)))
}

/// Resolves a link on a page to a path below the root and a heading there.
pub(crate) fn resolved(page: &str, target: &str) -> Option<(String, Option<String>)> {
    let (file, anchor) = match target.split_once('#') {
        Some((file, anchor)) => (file, Some(anchor.to_owned())),
        None => (target, None),
    };
    if file.is_empty() {
        return Some((page.to_owned(), anchor));
    }
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in file.split('/') {
        match part {
            "." | "" => {}
            ".." => {
                parts.pop()?;
            }
            part => parts.push(part),
        }
    }
    Some((parts.join("/"), anchor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_resolved_from_the_folder_of_their_page() {
        let cases = [
            ("b.md", Some(("docs/book/b.md", None))),
            ("../a.md#x", Some(("docs/a.md", Some("x")))),
            ("#x", Some(("docs/book/a.md", Some("x")))),
            ("../../../a.md", None),
        ];
        for (target, expected) in cases {
            let found = resolved("docs/book/a.md", target);
            let found = found.as_ref().map(|(path, anchor)| (path.as_str(), anchor.as_deref()));
            assert_eq!(found, expected, "{target}");
        }
    }
}
