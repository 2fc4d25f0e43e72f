//! Value that is computed once, without the standard library: its address is published atomically.

use alloc::boxed::Box;
use core::ptr::null_mut;
use core::sync::atomic::{AtomicPtr, Ordering};

/// Part of `std::sync::OnceLock`, for statics. No thread waits for another: two threads can compute
/// the value at the same time, and one result is kept.
pub(crate) struct OnceLock<T: 'static>(AtomicPtr<T>);

impl<T: Send + Sync> OnceLock<T> {
    /// Creates a lock without a value.
    pub(crate) const fn new() -> Self {
        Self(AtomicPtr::new(null_mut()))
    }

    /// Returns the value, if it has been computed.
    pub(crate) fn get(&self) -> Option<&'static T> {
        // SAFETY: the pointer is null or the address of a box that is never freed or changed after
        // its publication.
        unsafe { self.0.load(Ordering::Acquire).as_ref() }
    }

    /// Returns the value, which is computed if there is none.
    pub(crate) fn get_or_init(&self, value: impl FnOnce() -> T) -> &'static T {
        self.get().unwrap_or_else(|| self.published(Box::into_raw(Box::new(value()))))
    }

    /// Publishes a value, unless another thread has published one; returns the published value.
    #[cfg(target_has_atomic = "ptr")]
    fn published(&self, value: *mut T) -> &'static T {
        match self.0.compare_exchange(null_mut(), value, Ordering::AcqRel, Ordering::Acquire) {
            // SAFETY: the box is never freed or changed from here on.
            Ok(_) => unsafe { &*value },
            Err(known) => {
                // SAFETY: no other thread has the address of this box; `known` is as in `get`, and
                // not null.
                unsafe {
                    drop(Box::from_raw(value));
                    &*known
                }
            }
        }
    }

    /// Publishes a value. These processors have no atomic exchange: a value that another thread
    /// publishes at the same time can be replaced, and remains valid.
    #[cfg(not(target_has_atomic = "ptr"))]
    fn published(&self, value: *mut T) -> &'static T {
        self.0.store(value, Ordering::Release);
        // SAFETY: the box is never freed or changed from here on.
        unsafe { &*value }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;

    #[test]
    fn threads_that_compute_a_value_at_the_same_time_get_the_same() {
        static VALUE: OnceLock<usize> = OnceLock::new();
        assert_eq!(VALUE.get(), None);
        let values = std::thread::scope(|scope| {
            let threads = [0, 1, 2, 3].map(|index| scope.spawn(move || *VALUE.get_or_init(|| index)));
            threads.map(|thread| thread.join().expect("no thread panics"))
        });
        assert!(values.iter().all(|value| VALUE.get() == Some(value)), "{values:?}");
    }
}
