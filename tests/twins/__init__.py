"""Slow, obvious versions of the fast routines, for comparison."""
