//! The front end, through its public door: what parses, what does not and what is said about it.

mod accounted;
mod diagnostics;
mod files;
mod limits;
mod mutations;
mod print;
mod round_trip;
mod source;
