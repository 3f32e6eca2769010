"""Loops over arrays, compiled by numba. No xarray, no files, no errors raised here."""
