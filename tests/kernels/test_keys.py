"""Rows of numbers as one number, and numbers without repetitions."""

import numpy as np
import pytest

from firebreak_gis.kernels.keys import distinct, keyed


@pytest.mark.parametrize("dtype", [bool, np.uint8, np.int32, np.int64, np.float64])
@pytest.mark.parametrize("shape", [(0,), (1,), (50,), (7, 9), (300, 400)])
def test_distinct_values_are_those_of_numpy(dtype, shape):
    values = (np.random.default_rng(1).integers(0, 200, shape) - 100 * (dtype not in (bool, np.uint8))).astype(dtype)
    before = values.copy()
    found = distinct(values)
    np.testing.assert_array_equal(found, np.unique(values))
    assert found.dtype == dtype
    np.testing.assert_array_equal(values, before)


def test_infinite_values_are_values():
    assert distinct(np.array([np.inf, 1.0, -np.inf, np.inf])).tolist() == [-np.inf, 1.0, np.inf]


def test_keys_are_sorted_as_their_rows_are_and_give_them_back():
    columns = np.random.default_rng(2).integers(0, 5, (3, 400))
    key, sizes = keyed(*columns)
    np.testing.assert_array_equal(np.unravel_index(key, sizes), columns)
    np.testing.assert_array_equal(np.argsort(key, kind="stable"), np.lexsort(columns[::-1]))
