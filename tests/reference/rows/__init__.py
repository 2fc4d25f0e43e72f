"""Rows of reference values by topic."""
