"""Tests try designs out on a twentieth of the fires: most ask what a plan is, not how good it is.

A test of how good plans are has all fires: `@pytest.mark.all_fires`. Programs that tests start have them as well.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from firebreak_gis.placement import choosing, exchanging

#: Where each number stands, and what it is in tests.
_FEWER = (
    (choosing, "_WORK", 1.0e5),
    (exchanging, "_WORK", 1.0e5),
    (exchanging, "_SHORT_WORK", 5.0e4),
    (exchanging, "_OTHERS", 50),
)


@pytest.fixture(scope="session", autouse=True)
def fewer_fires() -> Iterator[pytest.MonkeyPatch]:
    """From the first test on, and for what several tests share."""
    with pytest.MonkeyPatch.context() as patch:
        for module, name, number in _FEWER:
            patch.setattr(module, name, number)
        yield patch


@pytest.fixture(autouse=True)
def all_fires_where_marked(request: pytest.FixtureRequest, fewer_fires: pytest.MonkeyPatch) -> Iterator[None]:
    """As users have them, in a test that is marked."""
    if request.node.get_closest_marker("all_fires") is None:
        yield
        return
    fewer_fires.undo()
    yield
    for module, name, number in _FEWER:
        fewer_fires.setattr(module, name, number)
