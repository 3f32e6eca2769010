"""Every odd raster as each of the three layers: a landscape, or a refusal in words; never a crash or a hang."""

import faulthandler

import pytest

from firebreak_gis.errors import FirebreakError
from firebreak_gis.landscape import read_landscape
from tests.places import SHARED, real

FOLDER = SHARED / "odd_tiffs"
NAMES = sorted(p.name for p in FOLDER.glob("*")) if FOLDER.is_dir() else ["absent"]


@real
@pytest.mark.parametrize("name", NAMES)
def test_an_odd_file_is_refused_in_words(name, sample_paths):
    if name == "absent":
        pytest.skip("the odd files are not here")
    layers = {"dem": sample_paths["dem"], "vegetation": sample_paths["vegetation"], "density": "normal"}
    faulthandler.dump_traceback_later(60, exit=True)
    try:
        for layer in ("dem", "vegetation", "density"):
            with pytest.raises(FirebreakError) as caught:
                read_landscape(**{**layers, layer: str(FOLDER / name)}, max_memory=2 << 30)
            # None of them lies where the sample does: each is refused, by name or with both extents.
            assert caught.value.exit_code in (3, 5), caught.value
            assert len(str(caught.value)) > 30
    finally:
        faulthandler.cancel_dump_traceback_later()
