"""Rows of whole numbers as single numbers, which are sorted many times as fast as rows."""

from __future__ import annotations

import numpy as np


def keyed(*columns: np.ndarray) -> tuple[np.ndarray, tuple[int, ...]]:
    """Number the rows of some columns so that numbers are sorted as the rows are.

    Parameters
    ----------
    columns
        (n,) each, whole numbers of at least 0.

    Returns
    -------
    tuple
        (n,) int64; and the sizes with which `numpy.unravel_index` gives the columns back.

    Examples
    --------
    >>> key, sizes = keyed(np.array([1, 0, 1]), np.array([0, 2, 0]))
    >>> [column.tolist() for column in np.unravel_index(np.unique(key), sizes)]
    [[0, 1], [2, 0]]
    """
    sizes = tuple(int(column.max(initial=0)) + 1 for column in columns)
    return np.ravel_multi_index(columns, sizes), sizes


def distinct(values: np.ndarray) -> np.ndarray:
    """Sorted values without repetitions, of any shape, none of them NaN.

    As `numpy.unique`, whose table of hashes (numpy 2.4) takes 5 to 30 times as long on whole numbers as sorting.

    Examples
    --------
    >>> distinct(np.array([[3, 1], [1, 2]])).tolist()
    [1, 2, 3]
    """
    rising = np.sort(values, axis=None)
    first = np.ones(rising.size, bool)
    np.not_equal(rising[1:], rising[:-1], out=first[1:])
    return rising[first]
