"""Make the sample landscape: a small fictional Mediterranean coast, relief, plant cover and vectors.

Run ``python sample_data/make_sample_data.py [--output DIR]``. The same seed gives the same pixel values
each time. Continuous fields are rounded before anything is decided on them, so that the last bits of a
floating point sum, which differ between processors, do not move a valley or a plant patch.
"""

from __future__ import annotations

import argparse
import heapq
from dataclasses import dataclass
from pathlib import Path

import geopandas as gpd
import numpy as np
import pyogrio
import rasterio
from rasterio.features import shapes
from rasterio.transform import Affine, from_origin
from rasterio.warp import transform, transform_bounds
from scipy import ndimage, sparse
from scipy.sparse import csgraph
from scipy.spatial import cKDTree
from shapely.geometry import LineString, Point, Polygon, shape

SEED = 20
CELL = 25.0
ROWS, COLS = 300, 380
# Cells of relief modelled around the study grid: the DEM reaches into them, and edge effects stay there.
MARGIN = 40
WEST, NORTH = 585_000.0, 4_010_500.0
UTM, DEGREES = "EPSG:32635", "EPSG:4326"
ARC_SECOND = 1.0 / 3600.0
DEM_MARGIN = 10
DEM_NODATA, CODE_NODATA = -9999.0, 255

NONE, AGRICULTURAL, SHRUBS, PINES = 0, 1, 2, 3
SPARSE, NORMAL, DENSE = 1, 2, 3
AGRICULTURAL_SHARE, PINES_SHARE = 0.20, 0.45
SPARSE_SHARE, DENSE_SHARE = 0.25, 0.30

VEGETATION_NAMES = {NONE: "none", AGRICULTURAL: "agricultural", SHRUBS: "shrubs", PINES: "pines"}
VEGETATION_COLOURS = {
    NONE: (214, 219, 223, 255),
    AGRICULTURAL: (233, 210, 122, 255),
    SHRUBS: (166, 178, 92, 255),
    PINES: (46, 104, 66, 255),
}
DENSITY_NAMES = {SPARSE: "sparse", NORMAL: "normal", DENSE: "dense"}
DENSITY_COLOURS = {SPARSE: (226, 232, 190, 255), NORMAL: (134, 178, 106, 255), DENSE: (24, 92, 54, 255)}

# Slopes steeper than this slide down in the model (about 32 degrees).
STEEPEST = 0.62
# Square metres that gather water before a stream forms: larger means gentler hillsides.
HILLSIDE = 100_000.0
# Metres of relief drowned after the erosion: valley mouths become inlets.
DROWNED = 16.0
# Name, people, cells built on, preferred elevation in metres.
VILLAGES = (
    ("Kalavra", 1240, 190, 30.0),
    ("Porto Selino", 860, 140, 8.0),
    ("Ano Melia", 430, 90, 330.0),
    ("Vrysoula", 210, 60, 170.0),
)
VILLAGES_APART = 2600.0
# Name, vegetation, and the place whose nearest such cell is taken, as fractions (east, south).
IGNITIONS = (
    ("Upper pines", PINES, 0.47, 0.24),
    ("North wood", PINES, 0.66, 0.16),
    ("Mill valley", PINES, 0.36, 0.52),
    ("Terrace field", AGRICULTURAL, 0.24, 0.58),
    ("Cape scrub", SHRUBS, 0.66, 0.72),
)
# Fractions of the study grid, (east, south), clockwise from the north-west.
BOUNDARY = (
    (0.07, 0.10),
    (0.24, 0.05),
    (0.47, 0.07),
    (0.70, 0.04),
    (0.93, 0.09),
    (0.96, 0.33),
    (0.95, 0.62),
    (0.97, 0.88),
    (0.78, 0.95),
    (0.52, 0.93),
    (0.30, 0.96),
    (0.08, 0.91),
    (0.04, 0.64),
    (0.05, 0.36),
)
NEIGHBOURS = ((-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (-1, 1), (1, -1), (1, 1))


@dataclass(frozen=True)
class Drainage:
    """Where water goes: flat cell indices from the outlets upstream, and each cell's next cell down."""

    order: np.ndarray
    receiver: np.ndarray
    distance: np.ndarray


@dataclass(frozen=True)
class Terrain:
    """The study grid's relief and what follows from it."""

    height: np.ndarray
    sea: np.ndarray
    slope: np.ndarray
    northness: np.ndarray
    hollow: np.ndarray
    flow: np.ndarray
    receiver: np.ndarray


def fractal_noise(
    rng: np.random.Generator, shape_: tuple[int, int], coarsest: float, octaves: int, gain: float = 0.5
) -> np.ndarray:
    """Sum octaves of smooth lattice noise.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of the lattice values.
    shape_ : tuple of int
        Rows and columns.
    coarsest : float
        Lattice spacing of the first octave, in cells; each octave halves it.
    octaves : int
        How many octaves.
    gain : float
        Amplitude of an octave relative to the one before.

    Returns
    -------
    numpy.ndarray
        Noise with mean 0 and standard deviation 1.
    """
    total = np.zeros(shape_)
    for octave in range(octaves):
        spacing = max(coarsest / 2**octave, 1.0)
        lattice = rng.random((int(shape_[0] / spacing) + 4, int(shape_[1] / spacing) + 4)) - 0.5
        rows = 1.0 + np.arange(shape_[0]) / spacing
        cols = 1.0 + np.arange(shape_[1]) / spacing
        grid = np.meshgrid(rows, cols, indexing="ij")
        total += gain**octave * ndimage.map_coordinates(lattice, grid, order=3, mode="mirror")
    return np.round((total - total.mean()) / total.std(), 6)


def block_mean(field: np.ndarray, factor: int) -> np.ndarray:
    """Average square blocks of `factor` cells."""
    rows, cols = field.shape[0] // factor, field.shape[1] // factor
    return np.round(field.reshape(rows, factor, cols, factor).mean(axis=(1, 3)), 6)


def ranks(field: np.ndarray) -> np.ndarray:
    """Replace values by their ranks, 0 to 1; ties keep the order of the cells."""
    flat = np.round(field.ravel(), 6)
    place = np.empty(flat.size)
    place[np.argsort(flat, kind="stable")] = np.arange(flat.size) / max(flat.size - 1, 1)
    return place.reshape(field.shape)


def top_share(score: np.ndarray, where: np.ndarray, share: float) -> np.ndarray:
    """Mark the best `share` of the cells of `where` by their score."""
    cells = np.flatnonzero(where)
    worst_first = np.argsort(np.round(score.ravel()[cells], 6), kind="stable")
    chosen = np.zeros(where.shape, dtype=bool)
    chosen.ravel()[cells[worst_first[cells.size - round(share * cells.size) :]]] = True
    return chosen


def flood(height: np.ndarray, outlets: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Flood inland from the outlets, lowest shore first, so that no hollow keeps its water.

    Parameters
    ----------
    height : numpy.ndarray
        Elevations.
    outlets : numpy.ndarray
        True where water leaves the model.

    Returns
    -------
    tuple of numpy.ndarray
        Flat cell indices in the order reached, the cell each was reached from, and the filled elevations.
    """
    width = height.shape[1] + 2
    level = np.pad(height, 1).ravel().tolist()
    source = np.pad(np.full(height.shape, -1), 1, constant_values=-2).ravel().tolist()
    heap = [(level[cell], cell) for cell in np.flatnonzero(np.pad(outlets, 1)).tolist()]
    for _, cell in heap:
        source[cell] = cell
    heapq.heapify(heap)
    steps = [row * width + col for row, col in NEIGHBOURS]
    order = []
    while heap:
        reached, cell = heapq.heappop(heap)
        order.append(cell)
        for step in steps:
            near = cell + step
            if source[near] == -1:
                source[near] = cell
                if level[near] < reached:
                    level[near] = reached
                heapq.heappush(heap, (level[near], near))

    def unpadded(cells: np.ndarray) -> np.ndarray:
        return (cells // width - 1) * height.shape[1] + cells % width - 1

    inner = np.s_[1:-1, 1:-1]
    padded_shape = (height.shape[0] + 2, width)
    return (
        unpadded(np.array(order)),
        unpadded(np.array(source).reshape(padded_shape)[inner].ravel()),
        np.array(level).reshape(padded_shape)[inner],
    )


def drain(height: np.ndarray, outlets: np.ndarray, cell: float) -> Drainage:
    """Send every cell's water to its steepest lower neighbour, or out of its hollow."""
    order, receiver, filled = flood(height, outlets)
    index = np.arange(height.size).reshape(height.shape)
    ground = np.pad(filled, 1, constant_values=np.inf)
    best = np.zeros(height.shape)
    receiver = receiver.reshape(height.shape).copy()
    for row, col in NEIGHBOURS:
        beside = ground[1 + row : 1 + row + height.shape[0], 1 + col : 1 + col + height.shape[1]]
        fall = (filled - beside) / (cell * (row * row + col * col) ** 0.5)
        steeper = (fall > best) & ~outlets
        best[steeper] = fall[steeper]
        receiver[steeper] = index[steeper] + row * height.shape[1] + col
    receiver = receiver.ravel()
    apart = np.abs(receiver - index.ravel())
    diagonal = (apart != 1) & (apart != height.shape[1])
    return Drainage(order, receiver, np.where(diagonal, 2.0**0.5, 1.0) * cell)


def flow_area(drainage: Drainage, cell: float) -> np.ndarray:
    """Area that drains through each cell, in square metres (flat)."""
    area = [cell * cell] * drainage.order.size
    receiver = drainage.receiver.tolist()
    for here in drainage.order[::-1].tolist():
        if receiver[here] != here:
            area[receiver[here]] += area[here]
    return np.array(area)


def erode(
    height: np.ndarray,
    outlets: np.ndarray,
    uplift: np.ndarray,
    softness: np.ndarray,
    steepest: np.ndarray,
    cell: float,
) -> np.ndarray:
    """Raise the land by one step of uplift and let rivers cut it (stream power law, solved implicitly).

    Parameters
    ----------
    height, outlets, uplift, softness : numpy.ndarray
        Elevation, fixed cells, metres of uplift in the step, and erodibility per metre of sqrt(area).
    cell : float
        Cell size in metres.

    Returns
    -------
    numpy.ndarray
        New elevations, no steeper downstream than `STEEPEST`.
    """
    drainage = drain(height, outlets, cell)
    power = (softness.ravel() * np.sqrt(HILLSIDE + flow_area(drainage, cell)) / drainage.distance).tolist()
    raised = (height + uplift).ravel().tolist()
    limit = (steepest.ravel() * drainage.distance).tolist()
    receiver = drainage.receiver.tolist()
    ground = height.ravel().tolist()
    for here in drainage.order.tolist():
        below = receiver[here]
        if below != here:
            cut = (raised[here] + power[here] * ground[below]) / (1.0 + power[here])
            ground[here] = min(cut, ground[below] + limit[here])
    return np.array(ground).reshape(height.shape)


def soften(height: np.ndarray, fixed: np.ndarray, sigma: float) -> np.ndarray:
    """Round ridges and hillsides as creeping soil does; `fixed` cells stay."""
    return np.round(np.where(fixed, height, ndimage.gaussian_filter(height, sigma, mode="nearest")), 4)


def refine(height: np.ndarray, shape_: tuple[int, int]) -> np.ndarray:
    """Interpolate to a grid of half the cell size."""
    rows = (np.arange(shape_[0]) - 0.5) / 2.0
    cols = (np.arange(shape_[1]) - 0.5) / 2.0
    grid = np.meshgrid(rows, cols, indexing="ij")
    return np.round(ndimage.map_coordinates(height, grid, order=1, mode="nearest"), 4)


def model_relief(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Grow mountains behind a rugged coast, first in large cells, then in smaller ones.

    Returns
    -------
    tuple of numpy.ndarray
        Elevations with the sea at 0, and the outlets (sea and northern edge), margins included.
    """
    full = (ROWS + 2 * MARGIN, COLS + 2 * MARGIN)
    south = np.linspace(0.0, 1.0, full[0])[:, None]
    east = np.linspace(0.0, 1.0, full[1])[None, :]
    inland = 0.745 - south - 0.20 * (east - 0.5) + 0.06 * fractal_noise(rng, full, 100.0, 6, 0.55)
    uplift = np.clip(0.30 + 1.6 * inland, 0.25, 1.0) * (1.0 + 0.22 * fractal_noise(rng, full, 130.0, 3))
    uplift = 50.0 * np.clip(uplift, 0.2, 1.5)
    softness = 0.40 * np.clip(1.0 + 0.35 * fractal_noise(rng, full, 60.0, 6, 0.75), 0.3, 2.0)
    steepest = STEEPEST * np.clip(1.0 + 0.3 * fractal_noise(rng, full, 30.0, 5, 0.8), 0.5, 1.5)

    height = np.zeros((full[0] // 4, full[1] // 4))
    for factor, steps, roughness in ((4, 60, 12.0), (2, 10, 8.0), (1, 4, 3.0)):
        outlets = block_mean(inland, factor) < 0.0
        if factor < 4:
            height = refine(height, outlets.shape)
        fields = [block_mean(field, factor) for field in (uplift, softness, steepest)]
        height = height + roughness * rng.random(outlets.shape)
        height[outlets] = 0.0
        for _ in range(steps):
            height = erode(height, outlets, *fields, CELL * factor)
            height = soften(height, outlets, 0.35) + roughness * 0.3 * rng.random(outlets.shape) * ~outlets
    return drown(soften(height, outlets, 0.7))


def drown(height: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Let the sea rise into the valley mouths; keep one sea and no islet of a few cells."""
    height = height - DROWNED
    labels, _ = ndimage.label(height <= 0.0)
    sea = labels == np.argmax(np.bincount(labels.ravel())[1:]) + 1
    land, count = ndimage.label(~sea)
    sizes = np.bincount(land.ravel(), minlength=count + 1)
    sea |= sizes[land] < 40
    height = np.where(sea, 0.0, np.maximum(height, 0.5))
    return height, sea


def flatten_valleys(rng: np.random.Generator, height: np.ndarray, outlets: np.ndarray) -> np.ndarray:
    """Widen the floors of the larger valleys, as their rivers do by wandering."""
    area = flow_area(drain(height, outlets, CELL), CELL).reshape(height.shape)
    uneven = 1.0 + 0.3 * np.clip(fractal_noise(rng, height.shape, 40.0, 3), -2.0, 2.0)
    for least, bend in ((3.0e6, 220.0), (9.0e6, 600.0)):
        river = (area >= least) & ~outlets
        away, nearest = ndimage.distance_transform_edt(~river, sampling=CELL, return_indices=True)
        away = away * uneven
        level = height[tuple(nearest)]
        level = np.maximum(level, ndimage.gaussian_filter(level, 2.0))
        floor = level + 0.02 * away + away**2 / (2.0 * bend)
        height = np.where(outlets | river, height, np.minimum(height, np.maximum(floor, 1.0)))
    return np.round(height, 3)


def make_terrain(rng: np.random.Generator) -> tuple[np.ndarray, Terrain]:
    """Model the relief and describe the study grid.

    Returns
    -------
    tuple
        Elevations with the margins, and the `Terrain` of the study grid.
    """
    height, outlets = model_relief(rng)
    height = soften(flatten_valleys(rng, height, outlets), height == 0.0, 0.8)
    drainage = drain(height, outlets, CELL)
    flow = flow_area(drainage, CELL).reshape(height.shape)
    south, east = np.gradient(ndimage.gaussian_filter(height, 1.0), CELL)
    steep = np.sqrt(np.gradient(height, CELL)[0] ** 2 + np.gradient(height, CELL)[1] ** 2)
    hollow = ndimage.uniform_filter(height, 21) - height
    inner = np.s_[MARGIN:-MARGIN, MARGIN:-MARGIN]
    index = np.full(height.shape, -1)
    index[inner] = np.arange(ROWS * COLS).reshape(ROWS, COLS)
    receiver = index.ravel()[drainage.receiver].reshape(height.shape)
    fields = (
        height,
        height == 0.0,
        np.round(steep, 6),
        np.round(south / np.sqrt(south**2 + east**2 + 0.01), 6),
        np.round(hollow, 4),
        flow,
        receiver,
    )
    return height, Terrain(*(field[inner] for field in fields))


def trace_river(terrain: Terrain) -> np.ndarray:
    """Follow the largest river from its highest spring to the sea; two cells wide where it is large."""
    flow, sea = terrain.flow.ravel(), terrain.sea.ravel()
    index = np.arange(flow.size)
    receiver = np.where(terrain.receiver.ravel() < 0, index, terrain.receiver.ravel())
    mouths = np.flatnonzero(~sea & sea[receiver])
    mouth = mouths[np.argmax(flow[mouths])]
    downstream = np.where(sea[receiver], index, receiver)
    end = downstream
    while not np.array_equal(end, end[end]):
        end = end[end]
    springs = np.flatnonzero((end == mouth) & (flow >= 0.5e6))
    cell = springs[np.argmax(terrain.height.ravel()[springs])]
    river = np.zeros(flow.size, dtype=bool)
    river[cell] = True
    while cell != mouth:
        cell = receiver[cell]
        river[cell] = True
    river = river.reshape(terrain.sea.shape)
    wide = ndimage.binary_dilation(river & (terrain.flow >= 5.0e6), np.ones((2, 2)))
    return (river | wide) & ~terrain.sea


def travel_graph(terrain: Terrain, river: np.ndarray) -> sparse.csr_array:
    """Cost of going from land cell to land cell; steep climbs and bridges cost most."""
    # Older scipy routes only over 32 bit indices.
    index = np.arange(ROWS * COLS, dtype=np.int32).reshape(ROWS, COLS)
    starts, ends, costs = [], [], []
    for row, col in NEIGHBOURS:
        here = np.s_[max(-row, 0) : ROWS - max(row, 0), max(-col, 0) : COLS - max(col, 0)]
        there = np.s_[max(row, 0) : ROWS - max(-row, 0), max(col, 0) : COLS - max(-col, 0)]
        length = CELL * (row * row + col * col) ** 0.5
        grade = np.abs(terrain.height[there] - terrain.height[here]) / length
        # Ground that falls away sideways needs cuts and walls, so it costs too.
        side = 0.5 * (terrain.slope[there] + terrain.slope[here])
        cost = length * (1.0 + (grade / 0.08) ** 2 + (side / 0.25) ** 2 + 3.0 * (river[here] | river[there]))
        land = ~(terrain.sea[here] | terrain.sea[there])
        starts.append(index[here][land])
        ends.append(index[there][land])
        costs.append(np.round(cost[land], 3))
    entries = (np.concatenate(costs), (np.concatenate(starts), np.concatenate(ends)))
    return sparse.csr_array(entries, shape=(index.size, index.size))


def place_villages(terrain: Terrain, river: np.ndarray, graph: sparse.csr_array) -> tuple[np.ndarray, list[int]]:
    """Build villages on gentle ground near their preferred elevations, well apart.

    Returns
    -------
    tuple
        Village number per cell (0 outside), and the flat index of each village's first cell.
    """
    row, col = np.indices(terrain.sea.shape)
    inside = (np.minimum(row, ROWS - 1 - row) > 40) & (np.minimum(col, COLS - 1 - col) > 40)
    free = ~terrain.sea & ~river
    gentle = ndimage.uniform_filter(terrain.slope, 9)
    away = ndimage.distance_transform_edt(~river, sampling=CELL)
    number = np.zeros(terrain.sea.shape, dtype=np.uint8)
    sites: list[int] = []
    for name_number, (_, _, cells, preferred) in enumerate(VILLAGES, start=1):
        score = 6.0 * gentle + np.abs(terrain.height - preferred) / 60.0
        score += away / 4000.0 if not sites else 0.0
        for site in sites:
            near = np.hypot(row - site // COLS, col - site % COLS) * CELL < VILLAGES_APART
            score = np.where(near, np.inf, score)
        site = int(np.argmin(np.round(np.where(free & inside, score, np.inf), 6)))
        cost = csgraph.dijkstra(graph, indices=site, limit=30_000.0).reshape(number.shape)
        built = top_share(-cost, free & np.isfinite(cost), cells / np.count_nonzero(free & np.isfinite(cost)))
        # The river would cut off what lies beyond it.
        parts, _ = ndimage.label(built)
        number[parts == parts.ravel()[site]] = name_number
        sites.append(site)
    return number, sites


def bare_rock(rng: np.random.Generator, terrain: Terrain, land: np.ndarray) -> np.ndarray:
    """Bare rock on the sharpest high ground."""
    score = ranks(terrain.height) + 0.5 * ranks(-terrain.hollow) + 0.25 * ranks(terrain.slope)
    score += 0.04 * fractal_noise(rng, score.shape, 10.0, 3)
    return top_share(ndimage.gaussian_filter(score, 1.0), land, 0.012)


def grow_vegetation(rng: np.random.Generator, terrain: Terrain, river: np.ndarray, villages: np.ndarray) -> np.ndarray:
    """Lay fields on the valley floors and round the villages, pines high and north, shrubs elsewhere."""
    land = ~(terrain.sea | river | (villages > 0))
    land &= ~bare_rock(rng, terrain, land)
    to_village = ndimage.distance_transform_edt(villages == 0, sampling=CELL)
    to_stream = ndimage.distance_transform_edt(terrain.flow < 2.0e6, sampling=CELL)
    fields = (
        1.3 * (1.0 - ranks(ndimage.uniform_filter(terrain.slope, 3)))
        + 0.8 / (1.0 + terrain.height / 80.0)
        + 1.7 / (1.0 + (to_village / 350.0) ** 2)
        + 0.5 / (1.0 + (to_stream / 200.0) ** 2)
        + 0.15 * fractal_noise(rng, land.shape, 20.0, 5, 0.7)
    )
    agricultural = top_share(ndimage.gaussian_filter(fields, 0.6), land, AGRICULTURAL_SHARE)
    woods = (
        1.3 * ranks(terrain.height)
        + 0.45 * terrain.northness
        + 0.5 * ranks(terrain.slope)
        + 0.3 * ranks(terrain.hollow)
        + 0.36 * fractal_noise(rng, land.shape, 40.0, 6, 0.75)
    )
    wild = land & ~agricultural
    pines = top_share(ndimage.gaussian_filter(woods, 0.6), wild, PINES_SHARE / (1.0 - AGRICULTURAL_SHARE))
    vegetation = np.where(wild, SHRUBS, NONE)
    vegetation[agricultural] = AGRICULTURAL
    vegetation[pines] = PINES
    return vegetation.astype(np.uint8)


def parcels(rng: np.random.Generator) -> np.ndarray:
    """Random values shared by all the cells of a field."""
    spacing = 6.0
    count = round(ROWS * COLS / spacing**2)
    seeds = rng.random((count, 2)) * (ROWS, COLS)
    cells = np.indices((ROWS, COLS)).reshape(2, -1).T + 0.5
    _, nearest = cKDTree(seeds).query(cells)
    return rng.random(count)[nearest].reshape(ROWS, COLS)


def grow_density(rng: np.random.Generator, terrain: Terrain, vegetation: np.ndarray) -> np.ndarray:
    """Let plants stand denser where it is moist; in fields, each parcel has one density or nearly so."""
    moist = 0.8 * ranks(terrain.hollow) + 0.45 * terrain.northness
    wild = moist + 0.33 * fractal_noise(rng, moist.shape, 36.0, 6, 0.6)
    wild = ndimage.gaussian_filter(wild, 0.7)
    farmed = parcels(rng) + 0.25 * ndimage.uniform_filter(moist, 25)
    density = np.full(vegetation.shape, CODE_NODATA, dtype=np.uint8)
    for code, score in ((AGRICULTURAL, farmed), (SHRUBS, wild), (PINES, wild)):
        where = vegetation == code
        density[where] = NORMAL
        density[top_share(-score, where, SPARSE_SHARE)] = SPARSE
        density[top_share(score, where, DENSE_SHARE)] = DENSE
    return density


def cell_centre(cell: int) -> tuple[float, float]:
    """Easting and northing of the middle of a study cell, from its flat index."""
    return WEST + (cell % COLS + 0.5) * CELL, NORTH - (cell // COLS + 0.5) * CELL


def village_polygons(villages: np.ndarray) -> gpd.GeoDataFrame:
    """Outline the villages, with corners rounded a little."""
    outlines: dict[int, list[Polygon]] = {}
    for outline, number in shapes(villages, villages > 0, transform=from_origin(WEST, NORTH, CELL, CELL)):
        outlines.setdefault(int(number), []).append(shape(outline))
    polygons = []
    for number in sorted(outlines):
        largest = max(outlines[number], key=lambda outline: outline.area)
        rounded = Polygon(largest.exterior).buffer(20.0).buffer(-20.0).simplify(8.0)
        polygons.append(Polygon(np.round(rounded.exterior.coords, 1)))
    names, people = [row[0] for row in VILLAGES], [row[1] for row in VILLAGES]
    return gpd.GeoDataFrame({"name": names, "people": people}, geometry=polygons, crs=UTM)


def road_lines(graph: sparse.csr_array, sites: list[int]) -> gpd.GeoDataFrame:
    """Join each village to the cheapest one before it, and the first to the edge of the map."""
    cost, before = csgraph.dijkstra(graph, indices=sites, return_predecessors=True)
    edge = np.arange(ROWS) * COLS
    pairs = [(0, int(edge[np.argmin(cost[0, edge])]), f"{VILLAGES[0][0]} - inland")]
    for later in range(1, len(sites)):
        earlier = int(np.argmin(cost[:later, sites[later]]))
        pairs.append((earlier, sites[later], f"{VILLAGES[earlier][0]} - {VILLAGES[later][0]}"))
    lines = []
    for start, cell, _ in pairs:
        path = [cell]
        while path[-1] != sites[start]:
            path.append(int(before[start, path[-1]]))
        lines.append(smooth_line(np.array([cell_centre(cell) for cell in reversed(path)])))
    return gpd.GeoDataFrame({"name": [name for *_, name in pairs]}, geometry=lines, crs=UTM)


def smooth_line(points: np.ndarray) -> LineString:
    """Turn a path from cell to cell into a road: average over five cells, drop needless points."""
    smooth = ndimage.uniform_filter1d(points, 5, axis=0, mode="nearest")
    smooth[[0, -1]] = points[[0, -1]]
    return LineString(np.round(LineString(smooth).simplify(5.0).coords, 1))


def ignition_points(vegetation: np.ndarray, density: np.ndarray) -> gpd.GeoDataFrame:
    """Put each ignition on the nearest cell of its vegetation that is not sparse."""
    row, col = np.indices(vegetation.shape)
    points = []
    for _, code, east, south in IGNITIONS:
        apart = (row - south * ROWS) ** 2 + (col - east * COLS) ** 2
        fit = (vegetation == code) & (density != SPARSE)
        points.append(Point(cell_centre(int(np.argmin(np.where(fit, apart, np.inf))))))
    names = [row[0] for row in IGNITIONS]
    frame = gpd.GeoDataFrame({"name": names}, geometry=points, crs=UTM).to_crs(DEGREES)
    rounded = [Point(round(point.x, 6), round(point.y, 6)) for point in frame.geometry]
    return frame.set_geometry(gpd.GeoSeries(rounded, crs=DEGREES))


def boundary_polygon() -> gpd.GeoDataFrame:
    """Outline the study area."""
    corners = [(WEST + east * COLS * CELL, NORTH - south * ROWS * CELL) for east, south in BOUNDARY]
    return gpd.GeoDataFrame({"name": ["study area"]}, geometry=[Polygon(np.round(corners, 1))], crs=UTM)


def resample_dem(height: np.ndarray) -> tuple[np.ndarray, Affine]:
    """Sample the relief on a grid of one arc second that reaches beyond the study grid.

    Parameters
    ----------
    height : numpy.ndarray
        Elevations on the study grid with its margins.

    Returns
    -------
    tuple
        Elevations rounded to 0.1 m, and their transform in degrees.
    """
    south_edge, east_edge = NORTH - ROWS * CELL, WEST + COLS * CELL
    bounds = np.array(transform_bounds(UTM, DEGREES, WEST, south_edge, east_edge, NORTH)) * 3600.0
    west, south = np.floor(bounds[:2]) - DEM_MARGIN
    east, north = np.ceil(bounds[2:]) + DEM_MARGIN
    longitude = (west + 0.5 + np.arange(round(east - west))) * ARC_SECOND
    latitude = (north - 0.5 - np.arange(round(north - south))) * ARC_SECOND
    longitude, latitude = np.meshgrid(longitude, latitude)
    x, y = transform(DEGREES, UTM, longitude.ravel(), latitude.ravel())
    cols = (np.array(x) - WEST) / CELL - 0.5 + MARGIN
    rows = (NORTH - np.array(y)) / CELL - 0.5 + MARGIN
    dem = ndimage.map_coordinates(height, [rows, cols], order=1, mode="constant", cval=DEM_NODATA)
    dem = np.round(dem, 1).reshape(longitude.shape).astype(np.float32)
    return dem, from_origin(west * ARC_SECOND, north * ARC_SECOND, ARC_SECOND, ARC_SECOND)


def write_dem(path: Path, dem: np.ndarray, where: Affine) -> None:
    """Write the elevations."""
    profile = raster_profile(dem, where, DEGREES, DEM_NODATA) | {"predictor": 3}
    with rasterio.open(path, "w", **profile) as raster:
        raster.write(dem, 1)
        raster.set_band_description(1, "elevation")
        raster.set_band_unit(1, "metre")


def write_codes(
    path: Path, codes: np.ndarray, description: str, names: dict[int, str], colours: dict[int, tuple]
) -> None:
    """Write a raster of codes with its colours and the meaning of each code."""
    where = from_origin(WEST, NORTH, CELL, CELL)
    with rasterio.open(path, "w", **raster_profile(codes, where, UTM, CODE_NODATA)) as raster:
        raster.write(codes, 1)
        raster.write_colormap(1, colours)
        raster.set_band_description(1, description)
        raster.update_tags(1, **{f"code_{code}": name for code, name in names.items()})


def raster_profile(values: np.ndarray, where: Affine, crs: str, nodata: float) -> dict[str, object]:
    """Creation options that all the rasters share."""
    return {
        "driver": "GTiff",
        "height": values.shape[0],
        "width": values.shape[1],
        "count": 1,
        "dtype": values.dtype.name,
        "crs": crs,
        "transform": where,
        "nodata": nodata,
        "compress": "deflate",
        "zlevel": 9,
        "tiled": True,
        "blockxsize": 128,
        "blockysize": 128,
    }


def write_layer(path: Path, frame: gpd.GeoDataFrame) -> None:
    """Write a GeoPackage whose layer is named like the file."""
    path.unlink(missing_ok=True)
    # GeoPackages record when they were written; a fixed date keeps the bytes the same.
    pyogrio.set_gdal_config_options({"OGR_CURRENT_DATE": "2024-01-01T00:00:00.000Z"})
    pyogrio.write_dataframe(frame, path, layer=path.stem, driver="GPKG")
    pyogrio.set_gdal_config_options({"OGR_CURRENT_DATE": None})


def main(arguments: list[str] | None = None) -> None:
    """Write every sample file."""
    parser = argparse.ArgumentParser(description="Make the sample landscape.")
    parser.add_argument("--output", type=Path, default=Path(__file__).resolve().parent, help="target folder")
    output = parser.parse_args(arguments).output
    output.mkdir(parents=True, exist_ok=True)

    rng = np.random.default_rng(SEED)
    height, terrain = make_terrain(rng)
    river = trace_river(terrain)
    graph = travel_graph(terrain, river)
    villages, sites = place_villages(terrain, river, graph)
    vegetation = grow_vegetation(rng, terrain, river, villages)
    density = grow_density(rng, terrain, vegetation)

    write_dem(output / "dem.tif", *resample_dem(height))
    write_codes(output / "vegetation.tif", vegetation, "vegetation", VEGETATION_NAMES, VEGETATION_COLOURS)
    write_codes(output / "density.tif", density, "density", DENSITY_NAMES, DENSITY_COLOURS)
    write_layer(output / "ignitions.gpkg", ignition_points(vegetation, density))
    write_layer(output / "boundary.gpkg", boundary_polygon())
    write_layer(output / "villages.gpkg", village_polygons(villages))
    write_layer(output / "roads.gpkg", road_lines(graph, sites))
    print(f"Wrote the sample landscape to {output}")


if __name__ == "__main__":
    main()
