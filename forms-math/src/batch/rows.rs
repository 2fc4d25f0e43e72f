//! Batches over the rows of a matrix.
