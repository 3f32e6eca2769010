"""Variables, errors and progress: what every stage relies on."""

from __future__ import annotations

import math

import numpy as np
import pytest

from firebreak_gis import errors
from firebreak_gis.errors import FirebreakError, InputError
from firebreak_gis.progress import part, silent
from firebreak_gis.schema import COLUMNS, DENSITY, VARIABLES, VEGETATION, annotate, validate


@pytest.mark.parametrize("name", VARIABLES)
def test_every_variable_is_whole(name):
    variable = VARIABLES[name]
    assert variable.name == name
    assert variable.text
    assert variable.units
    kind = np.dtype(variable.dtype)
    if variable.minimum is not None and variable.maximum is not None:
        assert variable.minimum < variable.maximum
    if variable.nodata is not None:
        assert np.array(variable.nodata).astype(kind) == variable.nodata
        outside = (variable.minimum is not None and variable.nodata < variable.minimum) or (
            variable.maximum is not None and variable.nodata > variable.maximum
        )
        assert outside or name in ("priority", "burn_count", "value_lost", "grey_level")  # 0 is no fuel there
    if variable.classes:
        assert set(variable.classes) == set(variable.colours)
        assert variable.nodata not in variable.classes
    for colour in variable.colours.values():
        assert colour.startswith("#")
        assert len(colour) in (7, 9)
        int(colour[1:], 16)


def test_columns_are_told_as_people_read_them():
    assert COLUMNS["length_m"].told(12345.6) == "12,346 m"
    assert COLUMNS["year"].told(2027) == "2027"
    assert COLUMNS["cost"].told(1234.5) == "1,234.50"
    assert COLUMNS["treatment"].told("clearing") == "clearing"
    assert COLUMNS["mean_slope_deg"].told(math.nan) == COLUMNS["stage"].told(None) == "–"
    assert COLUMNS["area_ha"].alias == "Area [ha]"
    assert COLUMNS["stage"].alias == "Stage of construction"
    assert COLUMNS["year"].told(0) == "not within the years"
    assert COLUMNS["year"].alias == "Year of construction (0: not within the years)"
    assert COLUMNS["cost"].told(0) == "0.00"


def test_classes_are_those_of_the_paper():
    assert list(VEGETATION.values()) == ["none", "agricultural", "shrubs", "pines"]
    assert list(DENSITY.values()) == ["none", "sparse", "normal", "dense"]
    with pytest.raises(TypeError):
        VEGETATION[4] = "oaks"


def test_annotate_writes_cf_attributes(make_landscape):
    landscape = make_landscape()
    vegetation = annotate(landscape["vegetation"].drop_attrs())
    assert vegetation.attrs["flag_values"].tolist() == [0, 1, 2, 3]
    assert vegetation.attrs["flag_meanings"] == "none agricultural shrubs pines"
    assert annotate(landscape["elevation"].drop_attrs()).attrs["units"] == "m"
    with pytest.raises(KeyError):
        annotate(landscape["elevation"].rename("height"))


def test_validate_names_every_problem(make_landscape):
    landscape = make_landscape()
    names = ("elevation", "vegetation", "density", "burnable")
    validate(landscape, names)
    validate(landscape.assign(elevation=landscape["elevation"].where(landscape["burnable"])), names)
    wrong = landscape.assign(
        elevation=landscape["elevation"] + 20_000,
        vegetation=landscape["vegetation"].T,
        density=landscape["density"].astype(float),
    ).drop_vars("burnable")
    with pytest.raises(InputError) as caught:
        validate(wrong, names)
    text = str(caught.value)
    for problem in ("elevation goes up to", "vegetation has dims", "density has dtype", "burnable is missing"):
        assert problem in text


def error_classes():
    found = [errors.FirebreakError]
    for cls in found:
        found += [c for c in cls.__subclasses__() if c.__module__ == errors.__name__]
    return found[1:]


def test_errors_stand_under_a_builtin_and_have_the_documented_codes():
    codes = {c.__name__: c.exit_code for c in error_classes()}
    assert codes == {
        "ParameterError": 2,
        "InputError": 3,
        "CRSError": 3,
        "GridError": 3,
        "LegendError": 3,
        "OutputError": 4,
        "ResourceError": 5,
        "MissingComponentError": 6,
        "VerificationError": 7,
        "Cancelled": 130,
    }
    builtin = {
        errors.ParameterError: ValueError,
        errors.InputError: ValueError,
        errors.OutputError: OSError,
        errors.ResourceError: MemoryError,
        errors.MissingComponentError: ImportError,
        errors.VerificationError: RuntimeError,
        errors.Cancelled: RuntimeError,
    }
    for cls, base in builtin.items():
        assert issubclass(cls, base)
        assert issubclass(cls, FirebreakError)
    kinds = [c.kind for c in error_classes()]
    assert len(set(kinds)) == len(kinds)
    assert str(errors.OutputError("said in words")) == "said in words"


def test_part_maps_a_step_into_the_whole():
    heard = []
    step = part(lambda fraction, message: heard.append((fraction, message)), 0.2, 0.6, "rank: ")
    for fraction in (-1.0, 0.0, 0.5, 1.0, 7.0):
        step(fraction, "x")
    assert [f for f, _ in heard] == pytest.approx([0.2, 0.2, 0.4, 0.6, 0.6])
    assert {m for _, m in heard} == {"rank: x"}
    nested = part(step, 0.5, 1.0, "a: ")
    nested(1.0, "y")
    assert math.isclose(heard[-1][0], 0.6)
    assert heard[-1][1] == "rank: a: y"
    assert part(None, 0, 1) is silent
