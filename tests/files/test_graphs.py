"""Networks as files of other tools: read back by those tools, entry for entry."""

from __future__ import annotations

import networkx as nx
import numpy as np
import pytest
import scipy.io
import scipy.sparse
from click.testing import CliRunner

from firebreak_gis import spread_network
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import ParameterError
from firebreak_gis.files import graphs
from firebreak_gis.files.graphs import write_graph
from firebreak_gis.lattice import COL_STEP, ROW_STEP


def dense(network):
    """Every edge by two loops."""
    rows, cols = network.shape
    matrix = np.zeros((rows * cols, rows * cols))
    for d in range(8):
        for row, col in np.argwhere(network.probability[d] > 0):
            matrix[row * cols + col, (row + ROW_STEP[d]) * cols + col + COL_STEP[d]] = network.probability[d, row, col]
    return matrix


@pytest.fixture
def network(make_landscape):
    return spread_network(make_landscape((9, 13), seed=4), wind_speed=5.0)


READERS = {
    "mtx": lambda path: scipy.io.mmread(path),
    "mat": lambda path: scipy.io.loadmat(path)["A"],
    "npz": scipy.sparse.load_npz,
}


@pytest.mark.parametrize("ending", READERS)
def test_matrices_come_back(network, tmp_path, ending):
    path = tmp_path / f"network.{ending}"
    write_graph(network, path)
    np.testing.assert_array_equal(READERS[ending](path).toarray(), dense(network))
    again = tmp_path / f"again.{ending}"
    write_graph(network, again)
    assert path.read_bytes() == again.read_bytes()


def test_what_lies_beside(network, tmp_path):
    write_graph(network, tmp_path / "network.mat")
    write_graph(network, tmp_path / "network.npz")
    told = scipy.io.loadmat(tmp_path / "network.mat")
    kept = np.load(tmp_path / "network.npz")
    for found in (told["burnable"], kept["grid_burnable"]):
        np.testing.assert_array_equal(found, network.burnable)
    assert told["shape"].ravel().tolist() == kept["grid_shape"].tolist() == list(network.shape)
    assert told["cell_size"].item() == kept["grid_cell_size"].item() == network.grid.cell_size


def test_graphml_comes_back(network, tmp_path):
    write_graph(network, tmp_path / "network.graphml")
    graph = nx.read_graphml(tmp_path / "network.graphml", node_type=int)
    matrix = dense(network)
    found = np.zeros_like(matrix)
    for source, target, told in graph.edges(data=True):
        found[source, target] = told["probability"]
        assert told["length"] == 1 / told["probability"]
    np.testing.assert_array_equal(found, matrix)
    assert set(graph.nodes) == set(np.flatnonzero(network.burnable).tolist())
    node, told = max(graph.nodes(data=True))
    assert (told["row"], told["col"]) == divmod(node, network.shape[1])
    assert (told["x"], told["y"]) == (network.grid.x[told["col"]], network.grid.y[told["row"]])


def test_refusals(network, tmp_path, monkeypatch):
    with pytest.raises(ParameterError, match=r"\.mtx, \.mat, \.npz, \.graphml"):
        write_graph(network, tmp_path / "network.xlsx")
    monkeypatch.setattr(graphs, "LARGEST_GRAPHML", 10)
    with pytest.raises(ParameterError, match="up to 10"):
        write_graph(network, tmp_path / "network.graphml")
    assert list(tmp_path.iterdir()) == []


def test_command(tmp_path):
    from firebreak_gis.spread.raster import read_network

    layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    land, out, export = (str(tmp_path / name) for name in ("land", "network.tif", "network.mtx"))
    assert CliRunner().invoke(firebreak, ["align", *layers, "--res", "400", "-o", land]).exit_code == 0
    words = ["network", land, "-o", out, "--export"]
    assert "--export" in CliRunner().invoke(firebreak, [*words, str(tmp_path / "network.doc")]).output
    assert not (tmp_path / "network.tif").exists()
    outcome = CliRunner().invoke(firebreak, [*words, export])
    assert outcome.exit_code == 0, outcome.output
    np.testing.assert_array_equal(scipy.io.mmread(export).toarray(), dense(read_network(out)))
    assert CliRunner().invoke(firebreak, [*words, export]).exit_code != 0  # exists
