"""Cut off and flipped bytes: a landscape or a refusal in words, in a process of its own with bounded memory."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from firebreak_gis.errors import InputError
from firebreak_gis.vectors import read_features
from tests.places import three

ROOT = Path(__file__).parents[1]

CHILD = """
import collections, faulthandler, json, random, resource, sys, traceback, warnings
from pathlib import Path
from firebreak_gis.errors import FirebreakError
from firebreak_gis.landscape import read_landscape
warnings.simplefilter("ignore")
folder = Path(sys.argv[1])
paths = {name: folder / f"{name}.tif" for name in ("dem", "vegetation", "density")}
good = {name: path.read_bytes() for name, path in paths.items()}
broken, chance, codes, wrong = folder / "broken.tif", random.Random(1), collections.Counter(), []
read_landscape(**paths)
resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
for turn in range(900):
    name = chance.choice(list(good))
    data = bytearray(good[name])
    if turn % 3 == 0:
        data = data[: chance.randrange(len(data))]
    else:
        for _ in range(chance.randint(1, 4)):
            data[chance.randrange(min(len(data), 600) if turn % 3 == 1 else len(data))] ^= 1 << chance.randrange(8)
    broken.write_bytes(data)
    faulthandler.dump_traceback_later(20, exit=True)
    try:
        read_landscape(**{**paths, name: broken})
        codes[0] += 1
    except FirebreakError as error:
        codes[error.exit_code] += 1
    except Exception:
        wrong.append(f"turn {turn}, {name}: {traceback.format_exc()[-600:]}")
print(json.dumps({"codes": codes, "wrong": wrong}))
"""


def test_broken_bytes_are_refused_in_words(tmp_path):
    three(tmp_path)
    done = subprocess.run(
        [sys.executable, "-c", CHILD, tmp_path], cwd=ROOT, capture_output=True, text=True, timeout=200
    )
    assert done.returncode == 0, done.stderr[-2000:]
    found = json.loads(done.stdout)
    assert found["wrong"] == []
    assert set(found["codes"]) <= {"0", "3", "5"}
    assert found["codes"]["3"] > 300


@pytest.mark.filterwarnings("ignore:Non closed ring:RuntimeWarning")
def test_a_ring_that_does_not_close_is_refused_in_words(tmp_path):
    ring = [[27.8, 36.1], [27.9, 36.1], [27.9, 36.2], [27.7, 36.0]]
    feature = {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    path = tmp_path / "open.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    with pytest.raises(InputError, match=r"open\.geojson cannot be read"):
        read_features(path, "EPSG:32635")
