"""Potential operational delineations: compartments that tile the land, bounded where a line can be held."""

from __future__ import annotations

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st
from pyproj import CRS
from scipy import ndimage

from firebreak_gis.cli import firebreak
from firebreak_gis.cli.parsing import hectares
from firebreak_gis.construction.delineations import delineate, square_suitability
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.schema import COLUMNS
from tests.places import three

SIDE = 25.0
AREA = SIDE * SIDE / 1e4


def network(fuel):
    transform = Affine(SIDE, 0.0, 500_000.0, 0.0, -SIDE, 4_000_000.0)
    return SpreadNetwork(
        np.full((8, *fuel.shape), 0.8, np.float32), burnable=fuel, transform=transform, crs=CRS.from_epsg(32633)
    )


def along_ridges(seed, shape=(36, 50)):
    """Suitability 1 on two ridges across the map, little elsewhere; and the ridges."""
    rng = np.random.default_rng(seed)
    good = 0.2 * rng.random(shape)
    ridge = np.zeros(shape, bool)
    at = (shape[1] // 2 + 4 * np.sin(np.arange(shape[0]) / 5)).astype(int)
    for r in range(shape[0]):
        ridge[r, at[r] : at[r] + 2] = True
    ridge[shape[0] // 2] = True
    return np.where(ridge, 1.0, good), ridge


def test_borders_run_along_the_ridges():
    fuel = np.ones((36, 50), bool)
    good, ridge = along_ridges(0)
    found = delineate(network(fuel), good, size_ha=450 * AREA, factors={"ridge": ridge.astype(float)})
    assert len(found.pods) == 4
    assert found.borders["on_ridge"].min() > 0.8
    mean = np.average(found.borders["suitability"], weights=found.borders["length_m"])
    assert mean > 0.85 > 0.4 > square_suitability(good, fuel, 450)
    short = delineate(network(fuel), good, size_ha=450 * AREA, strength=1.0)
    assert short.borders["length_m"].sum() < found.borders["length_m"].sum()
    assert np.average(short.borders["suitability"], weights=short.borders["length_m"]) < mean


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10_000), holes=st.floats(0.0, 0.25), size=st.integers(60, 400))
def test_compartments_tile_the_land_and_their_borders_bound_them(seed, holes, size):
    rng = np.random.default_rng(seed)
    fuel = rng.random((30, 41)) >= holes
    good = ndimage.gaussian_filter(rng.random(fuel.shape), 1.5)
    value, starts = rng.random(fuel.shape), rng.random(fuel.shape)
    found = delineate(
        network(fuel),
        good,
        size_ha=size * AREA,
        value=value,
        ignition=starts,
        burn_frequency=np.where(fuel, 0.25, np.nan),
    )
    labels = found.labels.to_numpy()
    pods, borders = found.pods, found.borders
    assert (labels[fuel] > 0).all()
    assert pods["pod"].tolist() == list(range(1, labels.max() + 1))
    for k, area, held in zip(pods["pod"], pods["area_ha"], pods.geometry, strict=True):
        assert held.area / 1e4 == pytest.approx(area) == pytest.approx(AREA * (labels == k).sum())
    assert pods["fuel_ha"].sum() == pytest.approx(AREA * fuel.sum())
    assert pods["value"].sum() == pytest.approx(value[fuel].sum())
    assert pods["ignition_share"].sum() == pytest.approx(1.0)
    assert pods["burnt_ha"].sum() == pytest.approx(0.25 * AREA * fuel.sum())
    # A slow count of the sides between every two, which the drawn lines must be.
    sides = {}
    for r in range(labels.shape[0]):
        for c in range(labels.shape[1]):
            for rr, cc in ((r, c + 1), (r + 1, c)):
                if rr < labels.shape[0] and cc < labels.shape[1]:
                    a, b = sorted((labels[r, c], labels[rr, cc]))
                    if 0 < a < b:
                        sides.setdefault((a, b), []).append(max(good[r, c], good[rr, cc]))
    assert [(a, b) for a, b in zip(borders["pod_a"], borders["pod_b"], strict=True)] == sorted(sides)
    for row in borders.itertuples():
        own = sides[row.pod_a, row.pod_b]
        assert row.suitability == pytest.approx(np.mean(own))
        assert row.geometry.length == pytest.approx(SIDE * len(own))
        for k in (row.pod_a, row.pod_b):
            assert pods.geometry[k - 1].boundary.buffer(0.01).covers(row.geometry)
    # Two neighbours hold more than is asked together, or they would be one.
    cells = pods["fuel_ha"].to_numpy() / AREA
    for a, b in sides:
        assert cells[a - 1] + cells[b - 1] > size


def test_large_connected_land_is_split_to_the_size():
    good, _ = along_ridges(3, (60, 80))
    found = delineate(network(np.ones((60, 80), bool)), good, size_ha=300 * AREA)
    cells = found.pods["fuel_ha"].to_numpy() / AREA
    assert cells.max() <= 1.5 * 300 * 1.1  # walls, one cell wide, are shared out afterwards
    assert np.median(cells) > 0.5 * 300


def test_a_river_bounds_for_nothing():
    fuel = np.ones((24, 40), bool)
    fuel[:, 19:21] = False
    found = delineate(network(fuel), np.full(fuel.shape, 0.5), size_ha=24 * 19 * AREA)
    assert len(found.pods) == 2
    assert sorted(
        np.unique(found.labels.to_numpy()[:, 0]).tolist() + np.unique(found.labels.to_numpy()[:, -1]).tolist()
    ) == [1, 2]
    assert found.pods["area_ha"].sum() == pytest.approx(fuel.size * AREA)  # the river is shared out


def test_what_cannot_be_is_refused():
    good = np.full((20, 20), 0.5)
    with pytest.raises(ParameterError, match="at least 16 cells"):
        delineate(network(np.ones((20, 20), bool)), good, size_ha=0.1)
    with pytest.raises(ParameterError, match="from 1"):
        delineate(network(np.ones((20, 20), bool)), good, size_ha=10, strength=0.0)
    with pytest.raises(InputError, match="known on all fuel"):
        delineate(network(np.ones((20, 20), bool)), np.full((20, 20), np.nan), size_ha=10)
    assert [hectares(word, "--size") for word in ("500ha", "5 km2", 20)] == [500.0, 500.0, 20.0]
    for wrong in ("0ha", "-3", "much", "inf"):
        with pytest.raises(ParameterError, match="--size is"):
            hectares(wrong, "--size")


def test_the_command_writes_what_a_stranger_reads(tmp_path):
    three(tmp_path, 30, 40)
    layers = [str(tmp_path / f"{name}.tif") for name in ("dem", "vegetation", "density")]
    for words in (
        ["align", *layers, "-o", tmp_path / "land"],
        ["delineate", tmp_path / "land", "--size", "20ha", "--runs", 5, "-o", tmp_path / "out"],
    ):
        done = CliRunner().invoke(firebreak, [str(w) for w in words])
        assert done.exit_code == 0, done.output
    pods = gpd.read_file(tmp_path / "out" / "pods.gpkg", layer="pods")
    borders = gpd.read_file(tmp_path / "out" / "pods.gpkg", layer="borders")
    assert set(pods.columns) - {"geometry"} <= set(COLUMNS)
    assert set(borders.columns) - {"geometry"} <= set(COLUMNS)
    assert {"pod", "fuel_ha", "shrubs", "burnt_ha", "suitability"} <= set(pods)
    assert shapely.union_all(pods.geometry).area == pytest.approx(pods.geometry.area.sum())
    assert set(borders["pod_a"]) | set(borders["pod_b"]) <= set(pods["pod"])
    assert "along a square grid" in done.output
