//! Imports between modules, and cycles of them on one level.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::algo::tarjan_scc;
use petgraph::graphmap::DiGraphMap;

use crate::modules::{ModulePath, Modules};

/// Import of an item.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Module that mentions the item.
    pub from: ModulePath,
    /// Module that defines it, or that re-exports it from another crate.
    pub to: ModulePath,
    /// The path as mentioned.
    pub mention: String,
}

/// Returns the imports between modules of a crate.
pub fn edges(modules: &Modules) -> Vec<Edge> {
    let edges_of = |(from, mentions): (&ModulePath, Vec<&Vec<String>>)| {
        let edge = |path: &Vec<String>| {
            let to = modules.resolve(from, path)?;
            Some(Edge { from: from.clone(), to, mention: path.join("::") })
        };
        mentions.into_iter().filter_map(edge).collect::<Vec<_>>()
    };
    let all = modules.0.iter().map(|(path, module)| {
        let reexports = module.reexports.iter().map(|import| &import.path);
        (path, module.mentions.iter().chain(reexports).collect())
    });
    all.flat_map(edges_of).collect()
}

/// Returns the cycles of imports between the children of a module: groups of children in which each
/// imports, directly or through others, every other. The parent itself does not count: it is the
/// facade of its children.
pub fn cycles_below(edges: &[Edge], parent: &[String]) -> Vec<String> {
    let child = |path: &ModulePath| path.strip_prefix(parent)?.first().cloned();
    let mut imports: BTreeMap<(String, String), BTreeSet<String>> = BTreeMap::new();
    for edge in edges {
        if let (Some(from), Some(to)) = (child(&edge.from), child(&edge.to))
            && from != to
        {
            let mention = format!("{} mentions {}", edge.from.join("::"), edge.mention);
            imports.entry((from, to)).or_default().insert(mention);
        }
    }
    let graph: DiGraphMap<&str, ()> = imports.keys().map(|(from, to)| (from.as_str(), to.as_str())).collect();
    let cycles = tarjan_scc(&graph).into_iter().filter(|group| group.len() > 1);
    let shown = |group: Vec<&str>| {
        let is_inside =
            |(from, to): &(String, String)| group.contains(&from.as_str()) && group.contains(&to.as_str());
        let reasons = imports.iter().filter(|(pair, _)| is_inside(pair));
        let reasons: Vec<&str> =
            reasons.filter_map(|(_, mentions)| mentions.first()).map(String::as_str).collect();
        format!("{}: {}", group.join(", "), reasons.join("; "))
    };
    cycles.map(shown).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycles(sources: &[(&str, &str)]) -> Vec<String> {
        let mut modules = Modules::default();
        for (path, source) in sources {
            let path = path.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect();
            modules.add(path, source.parse().expect("tokens"));
        }
        cycles_below(&edges(&modules), &[])
    }

    #[test]
    fn modules_that_import_each_other_through_a_third_are_a_cycle() {
        let found = cycles(&[
            ("", "mod a; mod b; mod c; mod d;"),
            ("a", "use crate::b::B; pub struct A;"),
            ("b", "pub struct B; fn f() { crate::c::g() }"),
            ("c", "pub fn g() -> crate::a::A { crate::a::A }"),
            ("d", "use crate::a::A;"),
        ]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            ["a", "b", "c"].iter().all(|name| found[0].contains(name)) && !found[0].contains("d mentions")
        );
    }

    #[test]
    fn a_re_export_is_an_import() {
        let found = cycles(&[
            ("", "mod a; mod b;"),
            ("a", "pub(crate) use crate::b as other; pub struct A;"),
            ("b", "use crate::a::A;"),
        ]);
        assert_eq!(found.len(), 1, "{found:?}");
    }

    #[test]
    fn a_child_that_uses_an_item_of_its_parent_is_no_cycle() {
        let found = cycles(&[
            ("", "mod a;"),
            ("a", "mod inner; pub use inner::Inner; pub struct Outer;"),
            ("a::inner", "use super::Outer; pub struct Inner;"),
        ]);
        assert_eq!(found, Vec::<String>::new());
    }
}
