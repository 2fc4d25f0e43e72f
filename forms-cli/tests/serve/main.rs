//! The page of `forms serve`, as clients of all kinds meet it.

mod answers;
mod bounds;
mod browser;
mod page;
mod server;
