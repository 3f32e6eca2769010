"""Texts on a page of a map book, from the top of a box downwards."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GREY = "#555555"

#: Left, bottom, width and height, in inches from the lower left corner of a page.
Box = tuple[float, float, float, float]


def put(figure: Figure, x: float, y: float, text: str, **look: Any) -> None:
    """Text at a place in inches; a dollar is a dollar, and readers of the text come to it before the map's numbers."""
    width, height = figure.get_size_inches()
    figure.text(x / width, y / height, text, parse_math=False, zorder=-1, **look)


def wrapped(text: str, room: float, size: float, weight: str = "normal") -> list[str]:
    """Lines of a paragraph that are no wider than the room [points]; a word that is wider alone is broken.

    Examples
    --------
    >>> wrapped("as long as a day in May", 50.0, 7.5)
    ['as long as a', 'day in May']
    """
    if _wide(text, size, weight) <= room:
        return [text]
    lines, line, used = [], "", 0.0
    gap = _wide("a b", size, weight) - _wide("ab", size, weight)
    for word in re.split("[ \n\t]+", text.strip()):  # and not at spaces that hold numbers together
        for piece in _broken(word, room, size, weight):
            wide = _wide(piece, size, weight)
            if line and used + gap + wide > room:
                lines.append(line)
                line, used = piece, wide
            else:
                line, used = (f"{line} {piece}", used + gap + wide) if line else (piece, wide)
    return [*lines, line] if line else lines


def fitting(text: str, room: float, size: float) -> float:
    """The size at which a text is no wider than the room [points], at most the given one."""
    return size * min(1.0, room / max(_wide(text, size, "normal"), 1e-9))


def _broken(word: str, room: float, size: float, weight: str) -> list[str]:
    """Pieces of a word that are no wider than the room."""
    pieces = []
    while len(word) > 1 and _wide(word, size, weight) > room:
        fits = max((n for n in range(1, len(word)) if _wide(word[:n], size, weight) <= room), default=1)
        pieces.append(word[:fits])
        word = word[fits:]
    return [*pieces, word]


@lru_cache(maxsize=4096)
def _wide(text: str, size: float, weight: str) -> float:
    """Width of a text [points]."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import text_to_path

    font = FontProperties(size=size, weight=weight)
    return float(text_to_path.get_text_width_height_descent(text, font, ismath=False)[0])


class Column:
    """Texts in a box.

    Parameters
    ----------
    figure
        The page; None to find out only how far they reach.
    box
        Where they go. They are written beyond it if there is no room, see `fits`.
    """

    def __init__(self, figure: Figure | None, box: Box) -> None:
        self._figure = figure
        self._begin(box)

    def _begin(self, box: Box) -> None:
        self._left, self._bottom, self._width = box[:3]
        self.y = box[1] + box[3]

    @property
    def fits(self) -> bool:
        """Whether all that was written lies in the box."""
        return self.y >= self._bottom

    def say(self, text: str, *, size: float = 7.5, bold: bool = False, colour: str = "black") -> None:
        """A paragraph."""
        weight = "bold" if bold else "normal"
        for line in wrapped(text, 72 * self._width, size, weight):
            self._need(size / 72)
            self._put(self._left, self.y, line, fontsize=size, va="top", color=colour, fontweight=weight)
            self.y -= size * 1.28 / 72
        self.y -= 0.04

    def head(self, text: str) -> None:
        """A heading."""
        self._need(0.5)
        self.y -= 0.06
        self.say(text, size=9, bold=True)

    def pair(self, name: str, value: str) -> None:
        """A name and a value beside it."""
        indent, size = (0.22, 9.0) if len(name) < 3 else (1.3, 10.5)
        self._put(self._left, self.y, name, fontsize=9, va="top", color=GREY)
        for line in wrapped(value, 72 * (self._width - indent), size):
            self._put(self._left + indent, self.y, line, fontsize=size, va="top")
            self.y -= size * 1.45 / 72

    def key(self, entries: Sequence[tuple[str, str]], *, patch: bool) -> None:
        """Colours and what they mean, two in a row."""
        for k, (text, colour) in enumerate(entries):
            x, y = self._left + (k % 2) * self._width / 2, self.y - 0.06
            self._swatch(x, y, colour, patch=patch)
            self._put(x + 0.29, y, text, fontsize=7, va="center")
            if k % 2 or k == len(entries) - 1:
                self.y -= 0.155

    def gap(self) -> None:
        """Some room."""
        self.y -= 0.06

    def _need(self, height: float) -> None:
        """Told before so much is written."""

    def _put(self, x: float, y: float, text: str, **look: Any) -> None:
        if self._figure is not None:
            put(self._figure, x, y, text, **look)

    def _swatch(self, x: float, y: float, colour: str, *, patch: bool) -> None:
        from matplotlib.lines import Line2D

        if self._figure is None:
            return
        width, height = self._figure.get_size_inches()
        ends = [x / width, (x + 0.22) / width]
        look: dict[str, Any] = {"color": colour, "lw": 7 if patch else 2.2, "solid_capstyle": "butt"}
        self._figure.add_artist(Line2D(ends, [y / height] * 2, **look))


class Flow(Column):
    """Texts that go on in the next box, and on the next page.

    Parameters
    ----------
    turn
        Makes a page, and tells its boxes.

    Attributes
    ----------
    figures
        The pages so far.
    """

    def __init__(self, turn: Callable[[], tuple[Figure, list[Box]]]) -> None:
        self.figures: list[Figure] = []
        self._turn, self._boxes = turn, list[Box]()
        box = self._next()
        super().__init__(self.figures[-1], box)

    def _next(self) -> Box:
        if not self._boxes:
            self._figure, self._boxes = self._turn()
            self.figures.append(self._figure)
        return self._boxes.pop(0)

    def _need(self, height: float) -> None:
        if self.y - height < self._bottom:
            self._begin(self._next())
