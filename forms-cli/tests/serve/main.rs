//! The page of `forms serve`, tested with clients of all kinds.

mod answers;
mod bounds;
mod browser;
mod page;
mod server;
