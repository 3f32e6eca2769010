"""Work that is no fire, made by parts by workers, kept, and gone on with: always what one machine makes in one go."""

import pickle
import time
from pathlib import Path

import numpy as np
import pytest
import rasterio
from click.testing import CliRunner

import firebreak_gis as fb
from firebreak_gis.cli.group import firebreak
from firebreak_gis.errors import FirebreakError, InputError, ParameterError
from firebreak_gis.landscape import survey
from firebreak_gis.landscape.sources import Found, Sources
from firebreak_gis.landscape.strips import read_by_parts
from firebreak_gis.placement.dissection import by_regions, dissect
from firebreak_gis.progress import silent
from firebreak_gis.simulation import engine
from firebreak_gis.simulation import workers as clusters
from tests.landscape.test_strips import CASES, asked, layers, spoiled
from tests.placement.test_dissection import noise
from tests.simulation.test_workers import _StopError, stopping


@pytest.fixture(scope="module")
def workers():
    with fb.cluster(2) as made, engine.using(None):
        yield made


def laid(request, folder, progress=None):
    """The landscape by parts; or what is refused."""
    try:
        return read_by_parts(request, survey(request), folder, cells=700, spread=engine.spread, progress=progress)
    except FirebreakError as error:
        return type(error), str(error)


def require_equal(one, other):
    assert sorted(one.data_vars) == sorted(other.data_vars)
    assert all(one[name].values.tobytes() == other[name].values.tobytes() for name in one.data_vars)
    assert one.attrs == other.attrs


@pytest.mark.parametrize("case", ["coarser", "turned", "undeclared", "feet", "cover", "word", "continuity"])
def test_workers_lay_what_one_machine_lays(case, workers, tmp_path):
    made, wishes = CASES[case]
    request = asked(layers(tmp_path, **made), **wishes)
    with engine.using(workers):
        found = laid(request, tmp_path)
    require_equal(found, laid(request, tmp_path))


def damaged(folder):
    """Codes of two parts are no whole numbers, other ones in each."""
    files = layers(folder)
    with rasterio.open(files[1]) as source:
        values, profile = source.read(1).astype(np.float32), source.profile
    values[3, 4], values[50, 60] = 1.25, 2.5
    with rasterio.open(files[1], "w", **{**profile, "dtype": "float32"}) as target:
        target.write(values, 1)
    return files


@pytest.mark.parametrize("case", ["codes", "empty", "strict", "damaged"])
def test_workers_refuse_what_one_machine_refuses(case, workers, tmp_path, monkeypatch):
    """In the same words: the first part that fails tells, with the names that were given."""
    files = damaged(tmp_path) if case == "damaged" else spoiled(case, tmp_path)
    monkeypatch.chdir(tmp_path)
    request = asked([Path(file).name for file in files], strict=case == "strict", resolution=30.0)
    with engine.using(workers):
        found = laid(request, tmp_path)
    assert found == laid(request, tmp_path)
    assert issubclass(found[0], InputError)


@pytest.mark.parametrize("count", [None, 2])
def test_a_landscape_that_was_stopped_goes_on(count, workers, tmp_path):
    keep = tmp_path / "parts"
    files = layers(tmp_path)
    request = asked(files)
    with pytest.raises(_StopError), fb.cluster(keep=keep):
        laid(request, tmp_path, stopping(0.6))
    kept = len(list(keep.iterdir()))
    assert kept >= 2
    with fb.cluster(keep=keep) as made:
        made.cluster = workers.cluster if count else None
        found = laid(request, tmp_path)
    assert made.kept.found == kept
    assert made.kept.made >= 2
    require_equal(found, laid(request, tmp_path))
    # Another file under the same name is another layer.
    with pytest.raises(_StopError), fb.cluster(keep=keep):
        laid(request, tmp_path, stopping(0.6))
    with rasterio.open(files[2], "r+") as target:
        target.write(np.maximum(target.read(1), 2), 1)
    with fb.cluster(keep=keep) as made:
        laid(request, tmp_path)
    assert made.kept.found == 0


def test_sources_are_found_from_everywhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    files = [Path(file).name for file in damaged(tmp_path)]
    found = survey(asked(files, resolution=30.0))
    sources = Sources(found.grid, found.layers, found.legend, found.density_legend, None, strict=False)
    sent = pickle.dumps(sources)
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    again = pickle.loads(pickle.dumps(pickle.loads(sent)))
    elevation, there = again.lay((20, 0, 5, 9), Found())["elevation"], again.headers["elevation"].path
    monkeypatch.chdir(tmp_path)
    assert elevation.tobytes() == sources.lay((20, 0, 5, 9), Found())["elevation"].tobytes()
    assert there == str(tmp_path / "dem.tif")
    assert again.told(f"{there} is so") == "dem.tif is so"
    Path(files[0]).unlink()
    with pytest.raises(InputError, match="lie where all workers reach them"):
        pickle.loads(sent)


def test_what_was_found_is_told_by_parts():
    found = Found()
    for codes in ({77.5: 1}, {77.5: 2, -1.0: 1}):
        one = Found()
        one.lacks.unknown["vegetation"] = codes
        found.join(Found.unpacked(one.packed()))
    assert found.lacks.unknown == {"vegetation": {77.5: 3, -1.0: 1}}


def test_align_writes_the_same_with_workers(tmp_path, monkeypatch):
    files = layers(tmp_path)
    monkeypatch.setattr("firebreak_gis.landscape.surveying.BLOCK_CELLS", 900)
    monkeypatch.setitem(read_by_parts.__kwdefaults__, "cells", 900)
    told = []
    for name, more in (("alone", []), ("shared", ["--workers", "2", "--resume"])):
        done = CliRunner().invoke(firebreak, ["align", *files, "-o", str(tmp_path / name), *more])
        assert done.exit_code == 0, done.output
        written = {path.name: path.read_bytes() for path in (tmp_path / name).iterdir() if path.name != "run.json"}
        told.append((written, done.stdout.replace(name, "")))
    assert told[0] == told[1]
    assert "elevation.tif" in told[0][0]


def dissected(progress=silent, seed=1):
    """Walls of a map in regions, and the sizes of its compartments."""
    network, stakes = noise(seed)
    sizes = np.zeros(network.burnable.size, np.int32)
    cuts = dissect(network, stakes, regions_from=2500, sizes=sizes, progress=progress)
    return [[part.tolist() if isinstance(part, np.ndarray) else part for part in parts(cut)] for cut in cuts], sizes


def parts(cut):
    return cut.cells, cut.cost, cut.saved, cut.parent, cut.size


@pytest.mark.parametrize("seed", [1, 2])
def test_workers_dissect_regions_as_one_machine_does(seed, workers):
    told = []
    with engine.using(workers):
        cuts, sizes = dissected(lambda share, message: told.append(message), seed)
    alone = dissected(seed=seed)
    assert cuts == alone[0]
    assert (sizes == alone[1]).all()
    assert "walls in regions" in told
    assert "burning" not in told


@pytest.mark.parametrize("count", [None, 2])
def test_a_dissection_that_was_stopped_goes_on(count, workers, tmp_path):
    keep = tmp_path / "parts"
    with pytest.raises(_StopError), fb.cluster(keep=keep):
        dissected(stopping(0.5))
    kept = len(list(keep.iterdir()))
    assert kept >= 2
    with fb.cluster(keep=keep) as made:
        made.cluster = workers.cluster if count else None
        cuts, sizes = dissected()
    alone = dissected()
    assert cuts == alone[0]
    assert (sizes == alone[1]).all()
    assert made.kept.found == kept
    assert made.kept.made >= 2


def test_rank_writes_the_same_with_workers(tmp_path, monkeypatch):
    pieces = []
    run = clusters.Cluster.run
    monkeypatch.setattr(clusters.Cluster, "run", lambda *given: pieces.append(len(given[2])) or run(*given))
    monkeypatch.setitem(dissect.__kwdefaults__, "regions_from", 2500)
    monkeypatch.setattr(by_regions, "__defaults__", (2500,))
    network = str(tmp_path / "network.tif")
    fb.write_raster(network, noise(3)[0].to_raster())
    for name, more in (("alone", []), ("shared", ["--workers", "2"])):
        words = ["rank", network, "-o", str(tmp_path / f"{name}.tif"), "--method", "dissection", *more]
        done = CliRunner().invoke(firebreak, words)
        assert done.exit_code == 0, done.output
    assert pieces
    assert pieces[0] > 4
    assert (tmp_path / "alone.tif").read_bytes() == (tmp_path / "shared.tif").read_bytes()


def failing(piece, *, threads, progress):
    if piece == 3:
        time.sleep(0.5)  # the other one has failed by then
    if piece in (3, 5):
        raise ParameterError(f"{piece} is no part")
    return {"piece": np.array([piece])}


def test_the_first_part_that_fails_tells(workers):
    for pieces in ([5, 4, 3, 2], [1, 3, 5, 2] * 3):
        errors = []
        for who in (None, workers):
            with engine.using(who), pytest.raises(ParameterError) as error:
                engine.spread(failing, pieces, {}, take=lambda *_: None, threads=None, progress=None)
            errors.append(str(error.value))
        assert errors[0] == errors[1]


class Made:
    """Large pieces, made when they are asked for."""

    def __init__(self, count):
        self.count, self.asked = count, []

    def __len__(self):
        return self.count

    def __getitem__(self, i):
        self.asked.append(i)
        return {"values": np.full(50_000, i)}


def doubled(piece, *, threads, progress):
    return {"sum": 2 * piece["values"][:1]}


def test_large_pieces_are_made_as_they_are_handed_out(workers, monkeypatch):
    monkeypatch.setattr("firebreak_gis.simulation.workers._OUT", 500_000)
    pieces, found, ahead = Made(12), {}, []

    def take(i, result):
        found[i] = int(result["sum"][0])
        ahead.append(len(pieces.asked) - len(found))

    with engine.using(workers):
        engine.spread(doubled, pieces, {}, take=take, threads=None, progress=None)
    assert found == {i: 2 * i for i in range(12)}
    assert pieces.asked == list(range(12))
    assert max(ahead) < 4


def slow(piece, *, threads, progress):
    time.sleep(0.2)
    return doubled(piece, threads=threads, progress=progress)


def test_large_pieces_that_a_lost_worker_held_are_sent_again():
    found, killed, waited = {}, [], []

    def disturb(share, message):
        waited.append(message)
        if not killed and share > 0.2:
            killed.append(next(iter(made.cluster._client.cluster.workers.values())))
            killed[0].process.process._process.kill()

    def take(i, result):
        found[i] = int(result["sum"][0])

    with fb.cluster(1) as made:
        engine.spread(slow, Made(10), {}, take=take, threads=None, progress=disturb, message="at work")
    assert killed
    assert found == {i: 2 * i for i in range(10)}
    assert set(waited) <= {"at work", "waiting for workers"}
