"""After `firebreak warmup` nothing is left to compile: no plan asks for a kernel, or kind of array, that it did not."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from tests.compiled import LAYERS
from tests.places import ROOT

#: Runs commands in one process and prints after each which kernels, with their kinds of arrays, are new.
WATCH = """
import json, sys
from numba.core.dispatcher import Dispatcher

made, start = [], Dispatcher.__init__
def noted(self, *given, **named):
    start(self, *given, **named)
    made.append(self)
Dispatcher.__init__ = noted

from firebreak_gis.cli import main

known = set()
for words in json.loads(sys.argv[1]):
    sys.argv = ["firebreak", *words]
    try:
        main()
    except SystemExit as end:
        assert not end.code, words
    found = {
        f"{each.py_func.__module__}.{each.py_func.__name__}{kinds}"
        for each in made
        if each.py_func.__module__.startswith("firebreak_gis")
        for kinds in each.signatures
    }
    print(json.dumps(sorted(found - known)))
    known |= found
"""

#: Plans that differ in what burns, fails and is laid.
PLANS = (
    ["--embers", "on", "--years", "3", "--budget", "5%", "--wind-speed", "5", "--wind-from", "315"],
    ["--residual", "0.1"],
    ["--timeless"],
    ["--line-width", "cells", "--refine"],
    ["--line-width", "auto", "--hold", "flame"],
    ["--method", "influence", "--weather", "rose:N=4x.5,E=3x.5"],
)


#: Kernels that only large networks, or many fires, need.
LARGE = (
    *("certificate._relax", "coarse.band", "flow.cut_between", "lanes.burn_block", "squares.number_blocks"),
    *("linear._rows_in", "linear._rows_out", "linear._rows_combine", "linear._rows_dot", "linear._rows_change"),
    *("paths.betweenness_batch", "paths.distance_batch", "percolation.burn_runs", "percolation.burn_curve"),
)


@pytest.fixture(scope="module")
def said(tmp_path_factory):
    """What the warm-up says, then the kernels that each command adds: it, and each plan."""
    folder = tmp_path_factory.mktemp("plans")
    plans = [
        ["plan", *LAYERS, "--res", "120", "--runs", "4", *more, "-q", "-o", f"{folder}/{i}"]
        for i, more in enumerate(PLANS)
    ]
    words = [["warmup", "--json"], *plans]
    done = subprocess.run([sys.executable, "-c", WATCH, json.dumps(words)], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@pytest.fixture(scope="module")
def compiled(said):
    return said[1:]


def test_it_says_how_long_it_took(said):
    assert said[0]["result"]["seconds"] > 0


def test_no_plan_compiles_what_warmup_did_not(compiled):
    assert compiled[1:] == [[] for _ in PLANS]


def test_kernels_of_large_networks_and_many_fires_are_among_them(compiled):
    warm = {each.split("(")[0].removeprefix("firebreak_gis.kernels.") for each in compiled[0]}
    assert set(LARGE) <= warm
