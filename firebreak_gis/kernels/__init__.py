"""Loops over arrays, compiled by numba, and keys for rows of numbers. No xarray, no files, no errors raised here."""
