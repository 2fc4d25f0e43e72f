//! Front end, through its public interface: texts that parse, texts that do not, and the messages
//! about them.

mod accounted;
mod diagnostics;
mod files;
mod limits;
mod mutations;
mod print;
mod round_trip;
mod source;
