//! Tables that are computed once for each number type.

#[cfg(not(feature = "std"))]
mod list;
#[cfg(feature = "std")]
mod map;

#[cfg(not(feature = "std"))]
pub(crate) use list::table;
#[cfg(feature = "std")]
pub(crate) use map::table;
