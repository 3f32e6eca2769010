"""Read one kind of file again and again with broken bytes: `python -m tests.faults.broken_bytes KIND FOLDER TURNS`.

The child process of test_fuzz_bytes.py: bounded memory, no turn longer than 20 s. Prints as JSON the exit codes
with their counts, how many cut files gave an answer, and what went wrong.
"""

import collections
import faulthandler
import json
import random
import resource
import sys
import traceback
import warnings
from pathlib import Path

import numpy as np

from firebreak_gis.errors import FirebreakError
from firebreak_gis.landscape import read_landscape
from firebreak_gis.vectors import read_features, read_points

MEMORY = 4 << 30
LIMIT_S = 20
LAYERS = ("dem", "vegetation", "density")
UTM = "EPSG:32635"


def layers(folder, suffix):
    """{file: (name while broken, reader)} for the rasters of a landscape."""
    good = {name: folder / f"{name}{suffix}" for name in LAYERS}

    def reader(name):
        return lambda path: [known(values) for values in read_landscape(**{**good, name: path}).values()]

    def known(values):
        """Nothing tells that the last number of a text lost its last digits."""
        return values.to_numpy().ravel()[: -1 if suffix == ".asc" else None]

    return {path: (folder / f"broken{suffix}", reader(name)) for name, path in good.items()}


def ascii_grids(folder):
    (folder / "broken.prj").write_bytes((folder / "dem.prj").read_bytes())
    return layers(folder, ".asc")


def projection(folder):
    """The .prj beside an ASCII grid: the grid is right, its CRS is broken."""
    _, reader = ascii_grids(folder)[folder / "dem.asc"]
    (folder / "broken.asc").write_bytes((folder / "dem.asc").read_bytes())
    return {folder / "dem.prj": (folder / "broken.prj", lambda _: reader(folder / "broken.asc"))}


def features(folder, suffix):
    """Polygons and points, as single-layer files."""

    def reader(read):
        return lambda path: [read(path, UTM).geometry.bounds.to_numpy()]

    readers = {"areas": read_features, "places": read_points}
    return {folder / f"{name}{suffix}": (folder / f"broken{suffix}", reader(read)) for name, read in readers.items()}


KINDS = {
    "tif": lambda folder: layers(folder, ".tif"),
    "asc": ascii_grids,
    "prj": projection,
    "gpkg": lambda folder: features(folder, ".gpkg"),
    "geojson": lambda folder: features(folder, ".geojson"),
    "fgb": lambda folder: features(folder, ".fgb"),
}


def broken(data, turn, chance):
    """Every third turn cuts the file, the others flip one to four bits: near its beginning, or anywhere."""
    data = bytearray(data)
    if turn % 3 == 0:
        return data[: chance.randrange(len(data))]
    for _ in range(chance.randint(1, 4)):
        data[chance.randrange(min(len(data), 600) if turn % 3 == 1 else len(data))] ^= 1 << chance.randrange(8)
    return data


def same(one, other):
    return len(one) == len(other) and all(map(lambda a, b: np.array_equal(a, b, equal_nan=True), one, other))


def main(kind, folder, turns):
    warnings.simplefilter("ignore")
    targets = KINDS[kind](Path(folder))
    good = {path: path.read_bytes() for path in targets}
    answers = {}
    for path, (place, read) in targets.items():
        place.write_bytes(good[path])
        answers[path] = read(place)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    chance, codes, wrong, cut = random.Random(1), collections.Counter(), [], 0
    for turn in range(int(turns)):
        path = chance.choice(list(targets))
        place, read = targets[path]
        data = broken(good[path], turn, chance)
        place.write_bytes(data)
        faulthandler.dump_traceback_later(LIMIT_S, exit=True)
        try:
            answer = read(place)
        except FirebreakError as error:
            codes[error.exit_code] += 1
        except Exception:
            wrong.append(f"turn {turn}, {path.name}: {traceback.format_exc()[-600:]}")
        else:
            codes[0] += 1
            if len(data) < len(good[path]):
                cut += 1
                if not same(answer, answers[path]):
                    wrong.append(
                        f"turn {turn}, {path.name}: {len(data)} of {len(good[path])} bytes gave another answer"
                    )
    print(json.dumps({"codes": codes, "cut": cut, "wrong": wrong}))


if __name__ == "__main__":
    main(*sys.argv[1:])
