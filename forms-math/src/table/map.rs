//! Tables in a map behind a lock.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{OnceLock, RwLock};

type Tables = RwLock<HashMap<(TypeId, usize), &'static (dyn Any + Send + Sync)>>;

/// Returns table `Kind` with this `index` and entries of type `T`; `compute` is called at the first
/// request.
pub(crate) fn table<Kind: 'static, T: Send + Sync + 'static>(
    index: usize,
    compute: impl FnOnce() -> Vec<T>,
) -> &'static [T] {
    static TABLES: OnceLock<Tables> = OnceLock::new();
    let tables = TABLES.get_or_init(Tables::default);
    let key = (TypeId::of::<(Kind, T)>(), index);
    let known = tables.read().ok().and_then(|tables| tables.get(&key).copied());
    if let Some(known) = known.and_then(|known| known.downcast_ref::<Vec<T>>()) {
        return known;
    }
    // Computed outside the lock, since a table can request another. Two threads can compute it
    // simultaneously; one result is kept.
    let computed = compute();
    let Ok(mut tables) = tables.write() else { return Box::leak(computed.into_boxed_slice()) };
    let kept = tables.entry(key).or_insert_with(|| Box::leak(Box::new(computed)));
    kept.downcast_ref::<Vec<T>>().map_or(&[], Vec::as_slice)
}
