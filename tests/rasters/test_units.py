"""Units of rasters and numbers: every way of writing one gives the same SI value; what is none is refused."""

import numpy as np
import pytest

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.rasters.units import (
    ANGLE,
    LENGTH,
    NOT_TOLD,
    SHARE,
    SPEED,
    per_hectare,
    read_number,
    require_known,
    told,
    unit_in,
)

SAME_SPEED = {
    5.0: ["m/s", "m s-1", "m s**-1", "m s^-1", "m.s-1", "m·s⁻¹", "[m/s]", "metres per second", "meter/second", "mps"],
    5.0 / 3.6: ["km/h", "km h-1", "kmh", "KM/H", "kph", "kilometers per hour"],
    5.0 * 1852 / 3600: ["kn", "kt", "kts", "Knots", "knot"],
    5.0 * 1609.344 / 3600: ["mph", "mi/h", "miles/hour", "miles per hour"],
    5.0 * 0.3048 / 60: ["ft/min", "feet per minute"],
    0.836 * 5.0**1.5: ["bf", "Bft", "Beaufort"],
}


@pytest.mark.parametrize(("unit", "expected"), [(unit, speed) for speed, units in SAME_SPEED.items() for unit in units])
def test_a_speed_is_the_same_however_its_unit_is_written(unit, expected):
    assert SPEED.knows(unit)
    assert SPEED.convert(5.0, unit) == pytest.approx(expected, rel=1e-12)
    np.testing.assert_allclose(SPEED.convert(np.full((2, 3), 5.0), unit), expected)
    if not unit.startswith("["):
        assert read_number(f"5{unit}", SPEED) == read_number(f" 5.0 {unit} ", SPEED) == pytest.approx(expected)


def test_beaufort_forces_lie_in_the_middle_of_their_classes():
    """Limits of the classes in m/s as meteorologists round them; force 12 has no upper end."""
    upper = [0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7]
    for force, limit in enumerate(upper):
        assert SPEED.convert(float(force), "bf") < limit
        assert SPEED.convert(force + 1.0, "bf") > limit


@pytest.mark.parametrize(
    ("quantity", "unit", "factor"),
    [
        (LENGTH, "ft", 0.3048),
        (LENGTH, "US survey foot", 1200 / 3937),
        (LENGTH, "metre", 1.0),
        (SHARE, "%", 0.01),
        (SHARE, "kg kg-1", 1.0),
        (SHARE, "g/kg", 0.001),
        (ANGLE, "radians", 180 / np.pi),
        (ANGLE, "degrees true", 1.0),
    ],
)
def test_factors(quantity, unit, factor):
    assert quantity.convert(2.0, unit) == pytest.approx(2.0 * factor, rel=1e-12)


@pytest.mark.parametrize("word", [*sorted(NOT_TOLD), "Unspecified", " [unknown] "])
def test_words_for_no_unit_leave_values_alone(word):
    values = np.arange(3.0)
    assert told(word) == ""
    assert LENGTH.knows(word)
    assert LENGTH.convert(values, word) is values


def test_float32_stays_float32():
    assert SPEED.convert(np.ones(3, np.float32), "km/h").dtype == np.float32


@pytest.mark.parametrize(("quantity", "unit"), [(SPEED, "hPa"), (SHARE, "m3 m-3"), (LENGTH, "K"), (ANGLE, "m")])
def test_units_of_other_quantities_are_refused(quantity, unit):
    with pytest.raises(InputError, match=r"w\.tif is in .* expected"):
        require_known(unit, quantity, "w.tif")


@pytest.mark.parametrize("text", ["20 hPa", "5 m", "3%"])
def test_numbers_with_a_strange_unit_are_refused(text):
    with pytest.raises(ParameterError, match="no unit of it; expected a number in m/s"):
        read_number(text, SPEED)


@pytest.mark.parametrize("text", ["wind.tif", "north", "", None, [1, 2]])
def test_what_is_no_number_is_left_to_the_caller(text):
    assert read_number(text, SPEED) is None


def test_units_in_the_names_of_columns():
    assert unit_in("wind speed (km/h)") == "km/h"
    assert unit_in("RH [%]") == "%"
    assert unit_in("WS") == unit_in("speed [unknown]") == ""


@pytest.mark.parametrize(
    ("unit", "factor"),
    [
        ("EUR/ha", 1.0),
        ("€ ha-1", 1.0),
        ("USD per acre", 2.4710538146717),
        ("$/m2", 10_000.0),
        ("PLN/km²", 0.01),
        ("people km-2", 0.01),
        ("1/ha", 1.0),
        ("people m**-2", 10_000.0),
    ],
)
def test_so_much_for_an_area(unit, factor):
    assert per_hectare(unit) == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize("unit", ["EUR", "", "ha", "km/h", "people"])
def test_what_is_not_for_an_area(unit):
    assert per_hectare(unit) is None
