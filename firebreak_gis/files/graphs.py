"""Spread networks as files of other tools: sparse matrices (Matrix Market, MATLAB, NumPy) and GraphML.

Entry (l, k) of the matrix is the probability that fire spreads from cell l to cell k. Cells are numbered row by row
from the upper left, those without fuel included, so that number n lies in row n // columns and
column n % columns (from 0; Matrix Market and MATLAB count from 1).
"""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.files import write_bytes

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork

#: GraphML holds some 250 bytes an edge, and those who read it need more.
LARGEST_GRAPHML = 20_000


def write_graph(network: SpreadNetwork, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
    """Write the probabilities of a network for other tools, in the format that the name tells.

    Parameters
    ----------
    network
        The network.
    path
        `.mtx` is Matrix Market; `.mat` MATLAB 5, with `A`, `shape`, `cell_size` and `burnable`; `.npz` as
        `scipy.sparse.load_npz` reads it, with the same beside; `.graphml` has the cells with fuel as nodes, with `row`,
        `col`, `x` and `y`, and edges with `probability` and `length`, 1 / p.
    overwrite
        Whether an existing file may be replaced.

    Raises
    ------
    ParameterError
        If the name has another ending, or a network is too large for GraphML.
    OutputError
        If the file exists, or cannot be written.
    """
    write_bytes(path, _FORMATS[require_format(path)](network), overwrite=overwrite)


def require_format(path: str | os.PathLike[str]) -> str:
    """Return the ending of a name if it is one of a known format.

    Raises
    ------
    ParameterError
        Otherwise.
    """
    ending = Path(path).suffix.lower()
    if ending not in _FORMATS:
        raise ParameterError(f"--export is {os.fspath(path)!r}, expected a name that ends in {', '.join(_FORMATS)}")
    return ending


def _matrix_market(network: SpreadNetwork) -> bytes:
    from scipy.io import mmwrite

    rows, cols = network.shape
    comment = (
        f" Spread probabilities from the cell of the row to that of the column; {rows} x {cols} cells, row by row from "
        "the upper left"
    )
    out = io.BytesIO()
    mmwrite(out, network.to_csr().tocoo(), comment=comment, precision=17, symmetry="general")
    return out.getvalue()


def _matlab(network: SpreadNetwork) -> bytes:
    from scipy.io import savemat

    out = io.BytesIO()
    savemat(out, {"A": network.to_csr().tocsc(), **_beside(network)}, do_compression=True)
    # The first 116 bytes are free text, in which scipy tells the time of day: equal networks shall be equal files.
    return b"MATLAB 5.0 MAT-file, spread probabilities".ljust(116) + out.getvalue()[116:]


def _numpy(network: SpreadNetwork) -> bytes:
    matrix = network.to_csr()
    out = io.BytesIO()
    parts: dict[str, Any] = {"indices": matrix.indices, "indptr": matrix.indptr, "data": matrix.data}
    beside: dict[str, Any] = {f"grid_{name}": value for name, value in _beside(network).items()}
    np.savez_compressed(
        out, format=np.array(b"csr"), shape=np.array(matrix.shape), _is_array=np.array(True), **parts, **beside
    )
    return out.getvalue()


def _beside(network: SpreadNetwork) -> dict[str, np.ndarray]:
    return {
        "shape": np.array(network.shape),
        "cell_size": np.array(network.grid.cell_size),
        "burnable": network.burnable.astype(np.uint8),
    }


def _graphml(network: SpreadNetwork) -> bytes:
    if network.n_burnable > LARGEST_GRAPHML:
        raise ParameterError(
            f"the network has {network.n_burnable} cells with fuel, GraphML is for up to {LARGEST_GRAPHML}; export it "
            "as .mtx, .mat or .npz"
        )
    graph = network.to_networkx()
    import networkx as nx

    for (row, col), told in graph.nodes(data=True):
        told.update(row=row, col=col, x=float(network.grid.x[col]), y=float(network.grid.y[row]))
    cols = network.shape[1]
    out = io.BytesIO()
    nx.write_graphml_xml(nx.relabel_nodes(graph, lambda cell: cell[0] * cols + cell[1]), out)
    return out.getvalue()


_FORMATS: Mapping[str, Callable[[SpreadNetwork], bytes]] = {
    ".mtx": _matrix_market,
    ".mat": _matlab,
    ".npz": _numpy,
    ".graphml": _graphml,
}
