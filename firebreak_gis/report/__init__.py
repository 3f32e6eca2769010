"""Figures and pages for people. Nothing here computes a result; it only shows one."""
