//! Tables in a linked list that only grows: without the standard library there are no locks.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::any::{Any, TypeId};

use crate::once_lock::OnceLock;

/// Number type with the purpose of the table, and index.
type Key = (TypeId, usize);
type Table = dyn Any + Send + Sync;

struct Entry {
    key: Key,
    table: &'static Table,
    next: OnceLock<Entry>,
}

static FIRST: OnceLock<Entry> = OnceLock::new();

/// Returns table `Kind` with this `index` and entries of type `T`; `compute` is called at the first
/// request.
pub(crate) fn table<Kind: 'static, T: Send + Sync + 'static>(
    index: usize,
    compute: impl FnOnce() -> Vec<T>,
) -> &'static [T] {
    let key = (TypeId::of::<(Kind, T)>(), index);
    let table = known(key).unwrap_or_else(|| append(key, Box::leak(Box::new(compute()))));
    table.downcast_ref::<Vec<T>>().map_or(&[], Vec::as_slice)
}

/// Returns the table with this key, if the list contains it.
fn known(key: Key) -> Option<&'static Table> {
    let mut place = &FIRST;
    while let Some(entry) = place.get() {
        if entry.key == key {
            return Some(entry.table);
        }
        place = &entry.next;
    }
    None
}

/// Appends a table, unless another thread has appended one with this key; returns the table in the
/// list.
fn append(key: Key, table: &'static Table) -> &'static Table {
    let mut place = &FIRST;
    loop {
        let entry = place.get_or_init(|| Entry { key, table, next: OnceLock::new() });
        if entry.key == key {
            return entry.table;
        }
        place = &entry.next;
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use alloc::vec;

    struct Inner;
    struct Outer;

    /// A table that requests another one.
    fn outer(index: usize) -> &'static [usize] {
        table::<Outer, usize>(index, || vec![table::<Inner, usize>(index, || vec![index, 1])[0], 2])
    }

    #[test]
    fn tables_are_kept_by_kind_type_and_index() {
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| (0..100).for_each(|index| assert_eq!(outer(index), [index, 2])));
            }
        });
        assert!(core::ptr::eq(outer(7), outer(7)));
        assert_eq!(table::<Inner, usize>(7, || panic!("the table is known")), [7, 1]);
        assert_eq!(table::<Inner, u8>(7, || vec![3]), [3]);
    }
}
