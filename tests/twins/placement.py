"""Gains of single cells by burning again, cuts by networkx, walls by drawing squares."""

from __future__ import annotations

from collections import deque

import networkx as nx
import numpy as np
from scipy import ndimage

from firebreak_gis.kernels.draws import open_edges
from firebreak_gis.kernels.flow import UNCUTTABLE
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.dissection import Cut, along
from firebreak_gis.placement.fires import Fires
from firebreak_gis.placement.patches import COARSE_FROM, Patches
from firebreak_gis.placement.widening import walls
from firebreak_gis.stakes import Stakes


def open_graph(network: SpreadNetwork, fires: Fires, run: int) -> nx.DiGraph:
    """Graph of the edges that are open in one run, over all cells; `leak`: open even into a cut cell."""
    rows, cols = network.shape
    graph = nx.DiGraph(leaky=fires.leaks.top.size > 0)
    graph.add_nodes_from(range(rows * cols))
    for cell in range(rows * cols):
        row, col = divmod(cell, cols)
        edges = int(open_edges(fires.keys[run], np.uint64(cell), fires.limits.top[cell], fires.limits.rest))
        strong = 0
        if graph.graph["leaky"]:
            strong = int(open_edges(fires.keys[run], np.uint64(cell), fires.leaks.top[cell], fires.leaks.rest))
        for d in range(8):
            if edges >> (8 * d + 7) & 1:
                to = (row + ROW_STEP[d]) % rows * cols + (col + COL_STEP[d]) % cols
                graph.add_edge(cell, to, direction=d, leak=bool(strong >> (8 * d + 7) & 1))
    return graph


def burnt(graph: nx.DiGraph, start: int, alive: np.ndarray) -> list[int]:
    """Cells that burn, in the order in which fires of equal step time reach them; also who lit whom."""
    return list(lit_by(graph, start, alive))


def lit_by(graph: nx.DiGraph, start: int, alive: np.ndarray) -> dict[int, int]:
    if not alive[start] and not graph.graph["leaky"]:
        return {}
    parents = {start: start}
    queue = deque([start])
    while queue:
        cell = queue.popleft()
        for target in sorted(graph[cell], key=lambda t: graph[cell][t]["direction"]):
            if target not in parents and (alive[target] or graph[cell][target]["leak"]):
                parents[target] = cell
                queue.append(target)
    return parents


def downstream(graph: nx.DiGraph, start: int, alive: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Value of every cell and of those below it in the tree of who lit whom, by climbing from each cell."""
    gain = np.zeros(value.size)
    parents = lit_by(graph, start, alive)
    for cell in parents:
        above = cell
        gain[above] += value[cell]
        while parents[above] != above:
            above = parents[above]
            gain[above] += value[cell]
    return gain


def loss(graph: nx.DiGraph, start: int, alive: np.ndarray, value: np.ndarray) -> float:
    return float(value[burnt(graph, start, alive)].sum())


def gain_by_deleting(graph: nx.DiGraph, start: int, alive: np.ndarray, value: np.ndarray) -> np.ndarray:
    """What is saved when each cell in turn is cut."""
    before = loss(graph, start, alive, value)
    gain = np.zeros(value.size)
    for cell in np.flatnonzero(alive):
        without = alive.copy()
        without[cell] = False
        gain[cell] = before - loss(graph, start, without, value)
    return gain


def gain_by_dominators(graph: nx.DiGraph, start: int, alive: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Value of the dominator subtree of every cell, by networkx."""
    gain = np.zeros(value.size)
    if not alive[start]:
        return gain
    above = nx.immediate_dominators(graph.subgraph(np.flatnonzero(alive).tolist()), start)
    for cell in {*above, start}:  # some versions of networkx leave the start out
        step = cell
        gain[step] += value[cell]
        while step != start:
            step = above[step]
            gain[step] += value[cell]
    return gain


def separates(network: SpreadNetwork, cut: np.ndarray) -> int:
    """Number of pieces of fuel that fire cannot pass between in either direction, once `cut` is removed."""
    graph = network.to_networkx().to_undirected()
    graph.remove_nodes_from([(int(r), int(c)) for r, c in np.argwhere(cut)])
    return nx.number_connected_components(graph)


def minimum_cut(network: SpreadNetwork, source: np.ndarray, sink: np.ndarray, cost: np.ndarray) -> float:
    """Cost of the cheapest set of cells outside both ends that separates them; inf if there is none."""
    graph = nx.DiGraph()
    for a, b in network.to_networkx().edges:
        graph.add_edge((a, "out"), (b, "in"))
        graph.add_edge((b, "out"), (a, "in"))
    for cell in map(tuple, np.argwhere(network.burnable).tolist()):
        ends = bool(source[cell] or sink[cell])
        if ends:
            graph.add_edge((cell, "in"), (cell, "out"))
        else:
            graph.add_edge((cell, "in"), (cell, "out"), capacity=float(cost[cell]))
        if source[cell]:
            graph.add_edge("source", (cell, "in"))
        if sink[cell]:
            graph.add_edge((cell, "out"), "sink")
    try:
        return float(nx.minimum_cut_value(graph, "source", "sink"))
    except nx.NetworkXUnbounded:
        return float("inf")


def cheapest_chain(
    row: np.ndarray,
    col: np.ndarray,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    toward: np.ndarray,
    share: float,
) -> tuple[float, np.ndarray] | None:
    """What the chain of `chains.best_chain` in one direction counts, and what each cell does; None if there is none."""
    top, left, high, wide = row.min() - 1, col.min() - 1, np.ptp(row) + 3, np.ptp(col) + 3
    places = [(r, c) for r in range(high) for c in range(wide)]
    along = np.array([toward[0] * r + toward[1] * c for r, c in places])
    part = np.floor(2 * (along - min(0.0, toward[0] * (high - 1)) - min(0.0, toward[1] * (wide - 1))) + 1e-6)
    part_of = dict(zip(places, part.astype(int).tolist(), strict=True))
    cells = [(int(r - top), int(c - left)) for r, c in zip(row, col, strict=True)]
    parts = np.array([part_of[cell] for cell in cells])
    mass = 0.5 * (ignition / ignition.sum() + value / value.sum())
    before = np.array([mass[parts < k].sum() for k in range(part_of[(high - 1, wide - 1)] + max(parts) + 3)])
    held = sorted(set(parts.tolist()))
    first = max([k for k in range(held[0], held[-1] + 1) if before[k + 1] <= share], default=held[0])
    last = min([k for k in range(held[0], held[-1] + 1) if before[k] >= 1.0 - share], default=held[-1])
    middle = 0.5 * (before[parts] + before[parts + 1])
    counts = np.rint(256 * capacity / (4.0 * middle * (1.0 - middle)))
    closed = {cell for cell, each in zip(cells, capacity, strict=True) if each >= UNCUTTABLE}
    band = [place for place in places if first < part_of[place] < last and place not in closed]
    price = dict(zip(cells, counts.tolist(), strict=True))
    graph = nx.grid_2d_graph(high, wide).to_directed().subgraph(band).copy()
    for _, b, edge in graph.edges(data=True):
        edge["price"] = price.get(b, 0)
    rim = [place for place in band if place[0] in (0, high - 1) or place[1] in (0, wide - 1)]
    ends = list(nx.connected_components(nx.Graph(graph.subgraph(rim).to_undirected())))
    if len(ends) != 2:
        return None
    found = nx.multi_source_dijkstra_path_length(graph, ends[0], weight="price")
    cheapest = min((found[place] for place in ends[1] if place in found), default=None)
    return None if cheapest is None else (cheapest, counts)


def dissected(
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    smallest: int = 16,
    coarse_from: int = COARSE_FROM,
    leaky: bool = False,
    sizes: np.ndarray | None = None,
) -> list[Cut]:
    """Walls of `dissect`, each compartment split by itself, one level of the tree after another."""
    shares = (0.2, 0.25, 0.3, 0.35, 0.4, 0.45)
    patches = Patches.of(network, stakes, width=1, leaky=leaky, directions=8, shares=shares, coarse_from=coarse_from)
    waiting = [(cells, -1) for cells in patches.connected(np.flatnonzero(network.burnable.ravel()))]
    cuts: list[Cut] = []
    while waiting:
        children = []
        for cells, parent in waiting:
            split = patches.split(cells) if cells.size >= smallest else None
            if split is not None:
                wall = along(split.wall, network.shape)
                if sizes is not None:
                    sizes[cells] = cells.size
                saved = patches.loss(cells) - sum(patches.loss(piece) for piece in split.pieces)
                children += [(piece, len(cuts)) for piece in split.pieces]
                cuts.append(Cut(wall, float(patches.cost[wall].sum()), saved, parent, cells.size))
        waiting = children
    return cuts


def parts_of(lines, network, stakes, *, width, stretch):
    """Parts of walls, wall by wall: a cell where walls meet goes with the one before it."""
    drawn = np.zeros(network.shape, bool)
    drawn.ravel()[np.concatenate(lines)] = True
    label = np.pad(ndimage.label(network.burnable & ~drawn, np.ones((3, 3)))[0], 1)
    taken: set[int] = set()
    pieces: list[list[int]] = []
    for line in lines:
        own = [cell for cell in line.tolist() if cell not in taken]
        taken.update(own)
        sides = []
        for cell in own:
            row, col = divmod(cell, network.shape[1])
            beside = set(label[row : row + 3, col : col + 3].ravel().tolist()) - {0}
            # The cell itself is drawn, so it has no label.
            sides.append((min(beside), max(beside)) if len(beside) > 1 else None)
        known = [each for each in sides if each is not None]
        last = known[0] if known else None
        found: dict[object, list[int]] = {}
        for cell, each in zip(own, sides, strict=True):
            last = each or last
            by = last if last is not None else "none"
            found.setdefault((by, int(stretch.ravel()[cell])), []).append(cell)
        pieces += list(found.values())
    return [each for each in walls([np.array(piece) for piece in pieces], network, stakes, width)[0] if each.size]
