"""A map book for crews: a PDF with an overview, a list of the segments, and a page for each of them."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from firebreak_gis import __version__
from firebreak_gis.files import write_bytes
from firebreak_gis.progress import Progress, part
from firebreak_gis.report.figures import own_looks
from firebreak_gis.report.mapbook import pages
from firebreak_gis.report.mapbook.atlas import Atlas

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Pages of segments, where nobody says how many.
PAGES = 100
#: Dots per inch of what is not lines and letters.
_DPI = 150


def write_book(
    path: str | os.PathLike[str],
    atlas: Atlas,
    *,
    paper: str = "a4",
    portrait: bool = False,
    most: int = PAGES,
    shortest: float = 0.0,
    overwrite: bool = False,
    progress: Progress | None = None,
) -> int:
    """Write a map book as a PDF, whole or not at all; equal plans give equal bytes.

    Parameters
    ----------
    path
        Target, .pdf.
    atlas
        What it shows.
    paper
        Of `pages.PAPERS`.
    portrait
        Whether the paper stands upright.
    most
        Segments with a page of their own, the first in order; all are in the list.
    shortest
        Shorter segments [m] have no page of their own; their neighbours' pages show them.
    overwrite
        Whether an existing file may be replaced.
    progress
        Callback (share done, message); what it raises stops the work, and nothing is left.

    Returns
    -------
    int
        Number of pages of segments.

    Notes
    -----
    One page is drawn at a time. The finished pages are held in memory until all are there, about 0.1 MB each.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> made = fb.plan(fb.read_landscape(**fb.sample_layers(), resolution=250.0), method="compartments", n_runs=5)
    >>> files = fb.write_plan(made, "out")
    >>> fb.write_book("book.pdf", fb.read_atlas("out"), most=2)
    2
    """
    own = [k for k, length in enumerate(atlas.lines["length_m"]) if length >= shortest][:most]
    content = _drawn(atlas, pages.sheet(paper, portrait=portrait), own, progress)
    write_bytes(Path(path), content, overwrite=overwrite)
    return len(own)


@own_looks
def _drawn(atlas: Atlas, paper: pages.Sheet, own: list[int], progress: Progress | None) -> memoryview:
    """The bytes of the book."""
    import matplotlib as mpl
    from matplotlib.backends.backend_pdf import PdfPages

    report = part(progress, 0.0, 1.0)
    memory = io.BytesIO()
    metadata = {"Title": atlas.title, "Creator": f"firebreak_gis {__version__}", "CreationDate": None}
    # Fonts as outlines, of which a reader can copy texts in any script that they hold.
    with mpl.rc_context({"pdf.fonttype": 42}), PdfPages(memory, metadata=metadata) as book:
        for k, (figure, total) in enumerate(_pages(atlas, paper, own), 1):
            report(min((k - 1) / total, 1.0), f"page {k} of {total}")
            book.savefig(figure, dpi=_DPI)
    return memory.getbuffer()


def _pages(atlas: Atlas, paper: pages.Sheet, own: list[int]) -> Iterator[tuple[Figure, int]]:
    """Every page, and how many there are in all."""
    footer = f"{atlas.title}   \N{MIDDLE DOT}   {atlas.sources[0]}" if atlas.sources else atlas.title
    note = _note(atlas, own)
    about = pages.about(atlas, paper, footer, note, 2)
    before = 1 + len(about)
    listed = pages.pages_of_list(atlas, paper)
    total = before + listed + len(own)
    page_of = {k: before + listed + 1 + n for n, k in enumerate(own)}
    yield pages.overview(atlas, paper, footer, note), total
    for figure in about:
        yield figure, total
    for figure in pages.contents(atlas, paper, footer, page_of, before + 1):
        yield figure, total
    for k, number in page_of.items():
        yield pages.segment(atlas, paper, footer, k, number), total


def _note(atlas: Atlas, own: list[int]) -> str:
    count = len(atlas.lines)
    which = (
        "Every segment has a page."
        if len(own) == count
        else f"{len(own)} of the {count} segments have a page; the list names all."
    )
    return (
        f"{which} Build in that order; segments of one stage work only together. What each saves is its share of what "
        "all save one by one: of the expected loss (how likely fires start, times what could burn), or of what burns "
        "in simulated fires, where the lines were improved by these. Lines run in the middle of the pale red strips, "
        "which are what to treat. Scales hold when printed at 100 %."
    )
