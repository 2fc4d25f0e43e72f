//! The macros of Forms: tokens in, core, tokens out.
