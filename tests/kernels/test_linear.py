"""Products, Bonacich, eigenvalues and eigenvectors against dense matrices."""

from __future__ import annotations

import networkx as nx
import numpy as np
import pytest

from firebreak_gis.kernels.bands import Bands
from firebreak_gis.kernels.blocks import block_bounds, factorise, grid_matrix
from firebreak_gis.kernels.linear import Operator, degree, katz
from firebreak_gis.kernels.spectrum import perron_vector, spectral_radius
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.ranking import rank
from tests.twins import centrality as twin

CASES = [(seed, boundary) for seed in range(5) for boundary in ("open", "periodic")]


def landscape(seed: int, boundary: str = "open", shape: tuple[int, int] | None = None) -> SpreadNetwork:
    """Strongly varying probabilities, holes, zero edges, and a wall that cuts an island off an open map."""
    random = np.random.default_rng(seed)
    rows, cols = shape or (11 + seed, 16)
    probability = random.random((8, rows, cols)).astype(np.float32) ** 3
    probability[random.random(probability.shape) < 0.2] = 0
    burnable = random.random((rows, cols)) > 0.15
    burnable[:, 2 * cols // 3] = False
    return SpreadNetwork(probability, burnable=burnable, boundary=boundary)


def smooth_landscape(seed: int, shape: tuple[int, int], wind: bool = True) -> SpreadNetwork:
    """Fuel in patches of about ten cells, with noise."""
    random = np.random.default_rng(seed)
    fuel = random.standard_normal(shape)
    for _ in range(30):
        for axis in (0, 1):
            fuel = (np.roll(fuel, 1, axis) + 2 * fuel + np.roll(fuel, -1, axis)) / 4
    fuel = np.clip(0.45 + 0.2 * fuel / fuel.std() + 0.1 * random.random(shape), 0.02, 1)
    push = np.array([0.5, 0.9, 1.4, 0.9, 0.5, 0.3, 0.2, 0.3]) if wind else np.ones(8)
    return SpreadNetwork(np.minimum(1, push[:, None, None] * fuel).astype(np.float32))


def relative(got: np.ndarray, expected: np.ndarray) -> float:
    """Largest relative difference; both must vanish in the same cells."""
    assert ((got == 0) == (expected == 0)).all()
    some = expected != 0
    return float(np.max(np.abs(got[some] / expected[some] - 1), initial=0.0))


@pytest.mark.parametrize(("seed", "boundary"), CASES)
@pytest.mark.parametrize("transpose", [False, True])
def test_product_is_that_of_the_matrix(seed, boundary, transpose):
    network = landscape(seed, boundary)
    matrix = twin.adjacency(network)
    x = np.random.default_rng(1).random(network.shape)
    with Operator(network.probability, boundary=boundary, transpose=transpose) as operator:
        got = operator.apply(x, np.empty(network.shape), shift=2.0, scale=0.5)
    expected = 2 + 0.5 * (matrix.T if transpose else matrix) @ x.ravel()
    np.testing.assert_allclose(got.ravel(), expected, rtol=1e-14)


@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (6, 1), (2, 5), (5, 2)])
def test_product_on_narrow_maps(shape):
    network = SpreadNetwork(np.random.default_rng(0).random((8, *shape)).astype(np.float32))
    for transpose, matrix in ((False, twin.adjacency(network)), (True, twin.adjacency(network).T)):
        got = degree(network.probability, transpose=transpose)
        np.testing.assert_allclose(got.ravel(), matrix.sum(axis=1), rtol=1e-14)


def test_weights_scale_the_planes():
    network = landscape(1)
    weights = np.linspace(0.5, 2.0, 8)
    x = np.random.default_rng(1).random(network.shape)
    with Operator(network.probability, weights=weights) as operator:
        got = operator.apply(x, np.empty(network.shape))
    expected = grid_matrix(network.probability, "open", weights) @ x.ravel()
    np.testing.assert_allclose(got.ravel(), expected, rtol=1e-14)


@pytest.mark.parametrize("name", twin.SYMMETRIES)
def test_product_of_a_turned_map_is_turned_to_the_last_bit(name):
    symmetry = twin.SYMMETRIES[name]
    network = landscape(3)
    turned = twin.turn_network(network, symmetry)
    for transpose in (False, True):
        expected = katz(network.probability, 0.1, 0.5, transpose=transpose).values
        got = katz(turned.probability, 0.1, 0.5, transpose=transpose).values
        assert (got == twin.turn(expected, symmetry)).all()


@pytest.mark.parametrize(("seed", "boundary"), CASES)
@pytest.mark.parametrize("orientation", ["in", "out"])
def test_bonacich_is_the_dense_solve(seed, boundary, orientation):
    network = landscape(seed, boundary)
    for beta in (0.0, 0.5, 0.9, 0.97, 0.999):
        got = rank(network, "bonacich", beta=beta, orientation=orientation).values
        expected = twin.bonacich(network, beta, orientation)
        inside = network.burnable
        np.testing.assert_allclose(got[inside], expected[inside], rtol=1e-8)


@pytest.mark.parametrize(("seed", "boundary"), CASES)
def test_degree_is_networkx_strength_and_bonacich_without_beta(seed, boundary):
    network = landscape(seed, boundary)
    graph = network.to_networkx()
    for orientation, degrees in (("in", graph.in_degree), ("out", graph.out_degree)):
        got = rank(network, "degree", orientation=orientation).values
        for cell, strength in degrees(weight="probability"):
            assert got[cell] == pytest.approx(strength, rel=1e-13)
        assert (got == rank(network, "bonacich", beta=0, orientation=orientation).values).all()


@pytest.mark.parametrize("attenuated", [0.3, 0.9, 0.99])
def test_residual_bounds_the_error(attenuated):
    network = landscape(2)
    matrix = twin.adjacency(network)
    c = attenuated / np.abs(np.linalg.eigvals(matrix)).max()
    exact = np.linalg.solve(np.eye(len(matrix)) - c * matrix, matrix.sum(axis=1)).reshape(network.shape)
    for tolerance in (1e-2, 1e-5):
        solution = katz(network.probability, c, attenuated, tolerance=tolerance)
        assert solution.error <= tolerance
        assert relative(solution.values, exact) <= solution.error + 1e-12


def test_krylov_needs_fewer_products():
    network = smooth_landscape(0, (60, 70), wind=False)
    radius = spectral_radius(network.probability).upper
    solution = katz(network.probability, 0.999 / radius, 0.999)
    assert solution.error <= 1e-10
    assert solution.products < 23 / -np.log(0.999) / 10


def test_extrapolation_needs_a_third_of_the_products():
    network = smooth_landscape(2, (24, 30), wind=False)
    largest = float(np.linalg.eigvals(twin.adjacency(network)).real.max())
    found = katz(network.probability, 0.9 / largest, 0.9, transpose=True)
    assert found.error <= 1e-10
    assert found.products < np.log(1e-10) / np.log(0.9) / 3


@pytest.mark.parametrize("directions", [(0, 2, 3), (1, 4, 6), (0, 1, 2, 3, 4, 5, 6, 7)])
@pytest.mark.parametrize("beta", [0.4, 0.9])
def test_spread_that_goes_round_or_one_way_is_solved_too(directions, beta):
    """Eigenvalues far from real: extrapolation fails, the series still ends right."""
    probability = np.zeros((8, 9, 14), np.float32)
    probability[list(directions)] = np.random.default_rng(0).uniform(0.2, 1.0, (len(directions), 9, 14))
    network = SpreadNetwork(probability, boundary="periodic")
    matrix = twin.adjacency(network)
    attenuation = beta / float(np.abs(np.linalg.eigvals(matrix)).max())
    dense = np.linalg.solve(np.eye(matrix.shape[0]) - attenuation * matrix, matrix.sum(axis=1))
    found = katz(network.probability, attenuation, beta, boundary="periodic")
    assert relative(found.values.ravel(), dense) < 1e-9


@pytest.mark.parametrize(("seed", "boundary"), CASES)
def test_bounds_enclose_the_dense_eigenvalue(seed, boundary):
    network = landscape(seed, boundary)
    radius = np.abs(np.linalg.eigvals(twin.adjacency(network))).max()
    bounds = spectral_radius(network.probability, boundary=boundary)
    assert bounds.lower <= radius * (1 + 1e-13)
    assert radius <= bounds.upper * (1 + 1e-13)
    assert bounds.width < 1e-11


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("wind", [False, True])
def test_windows_certify_what_the_whole_map_gives(seed, wind):
    network = smooth_landscape(seed, (120, 150), wind)
    whole = block_bounds(grid_matrix(network.probability, "open"), 1e-12)
    bounds = spectral_radius(network.probability, direct_cells=0)
    assert bounds.lower <= whole.upper
    assert whole.lower <= bounds.upper
    assert bounds.width <= 1.1e-9


@pytest.mark.parametrize(("seed", "boundary"), CASES)
def test_windows_hold_on_rough_maps(seed, boundary):
    network = landscape(seed, boundary, (40, 61))
    radius = spectral_radius(network.probability, boundary=boundary)
    bounds = spectral_radius(network.probability, boundary=boundary, direct_cells=0)
    assert bounds.lower <= radius.upper
    assert radius.lower <= bounds.upper
    assert bounds.width < 1e-6


def test_bounds_hold_where_nothing_is_localised():
    """A uniform map: p times the product of two path spectra."""
    rows, cols, p = 90, 301, np.float32(0.5)
    network = SpreadNetwork(np.full((8, rows, cols), p))
    u, v = (2 * np.cos(np.pi / (n + 1)) for n in (rows, cols))
    radius = float(p) * ((1 + u) * (1 + v) - 1)
    bounds = spectral_radius(network.probability, direct_cells=0)
    assert bounds.lower <= radius <= bounds.upper
    assert bounds.width < 1e-2
    torus = spectral_radius(network.probability * 0 + p, boundary="periodic", direct_cells=0)
    assert torus.lower <= 4.0 <= torus.upper <= 4.0 * (1 + 1e-12)


@pytest.mark.parametrize("direct_cells", [0, 10_000])
def test_networks_without_cycles_have_radius_zero(direct_cells):
    downhill = np.zeros((8, 9, 12), np.float32)
    downhill[3] = 0.7  # south-east only
    for probability in (np.zeros((8, 9, 12), np.float32), SpreadNetwork(downhill).probability):
        bounds = spectral_radius(probability, direct_cells=direct_cells)
        assert bounds.lower == 0.0
        assert bounds.upper < 1.0
    network = SpreadNetwork(downhill)
    assert spectral_radius(network.probability).upper == 0.0
    assert (rank(network, "bonacich", beta=0.9).values == rank(network, "degree").values).all()
    assert (rank(network, "eigenvector").values[network.burnable] == 0).all()


def test_one_way_islands_take_the_strongest_part():
    """Two cells that light each other light a chain that does not light back."""
    probability = np.zeros((8, 1, 6), np.float32)
    probability[2, 0, 0], probability[6, 0, 1] = 0.5, 0.125
    probability[2, 0, 1:5] = 0.75
    bounds = spectral_radius(probability)
    assert bounds.lower == pytest.approx(0.25, rel=1e-12)
    assert bounds.upper == pytest.approx(0.25, rel=1e-12)
    assert (perron_vector(probability) > 0).tolist() == [[True, True, False, False, False, False]]
    # The chain is lit from the pair: x_k = p x_(k-1) / lambda.
    got = perron_vector(probability, transpose=True)[0]
    np.testing.assert_allclose(got[2:] / got[1:-1], 0.75 / 0.25, rtol=1e-7)


@pytest.mark.parametrize(("seed", "boundary"), CASES)
@pytest.mark.parametrize("orientation", ["in", "out"])
def test_eigenvector_is_the_dense_one(seed, boundary, orientation):
    network = landscape(seed, boundary)
    got = rank(network, "eigenvector", orientation=orientation).values
    expected = twin.eigenvector(network, orientation)
    large = network.burnable & (expected > 1e-8)  # the dense solver rounds relative to the largest entry
    np.testing.assert_allclose(got[large], expected[large], rtol=1e-6)
    assert (got[network.burnable & ~large] < 1e-7).all()


def test_eigenvector_is_that_of_networkx():
    network = smooth_landscape(4, (9, 13))
    expected = nx.eigenvector_centrality_numpy(network.to_networkx(), weight="probability")
    got = rank(network, "eigenvector", orientation="in").values
    largest = max(expected.values())
    for cell, value in expected.items():
        assert got[cell] == pytest.approx(value / largest, rel=1e-7)


def test_eigenvector_of_a_large_map_is_that_of_the_whole():
    network = smooth_landscape(1, (70, 90))
    for transpose in (False, True):
        expected = perron_vector(network.probability, transpose=transpose)
        got = perron_vector(network.probability, transpose=transpose, direct_cells=0)
        np.testing.assert_allclose(got, expected, rtol=1e-5, atol=1e-6)


def test_threads_do_not_change_a_bit():
    network = smooth_landscape(2, (161, 83))
    results = []
    for threads in (1, 2, 3, 7):
        bounds = spectral_radius(network.probability, direct_cells=0, threads=threads)
        parts = [np.array([bounds.lower, bounds.upper])]
        parts += [
            katz(network.probability, beta / bounds.upper, beta, threads=threads).values.ravel() for beta in (0.8, 0.99)
        ]
        results.append(np.concatenate(parts))
    assert all((result == results[0]).all() for result in results[1:])


def test_bands_cover_every_row_once():
    for rows in (1, 2, 5):
        with Bands((rows, 4), threads=3) as bands:
            seen: list[int] = []
            bands.run(lambda first, stop: seen.extend(range(first, stop)))  # noqa: B023
        assert sorted(seen) == list(range(rows))


@pytest.mark.parametrize(
    ("said", "error"),
    [("Factor is exactly singular", np.linalg.LinAlgError), ("SUPERLU_MALLOC fails for buf", MemoryError)],
)
def test_want_of_memory_is_not_taken_for_the_radius(monkeypatch, said, error):
    def splu(*_, **__):
        raise RuntimeError(said)

    monkeypatch.setattr("firebreak_gis.kernels.blocks.splu", splu)
    with pytest.raises(error):
        factorise(grid_matrix(np.ones((8, 3, 4), np.float32), "open"), 9.0)
