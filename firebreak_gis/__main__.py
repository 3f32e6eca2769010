"""`python -m firebreak_gis` is the command line."""

from firebreak_gis.cli import main

main()
