"""Units of what files and people give: one table turns them into those of the program."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError

#: Words by which files say that they do not tell a unit.
NOT_TOLD = frozenset({"", "-", "?", "n/a", "na", "none", "unspecified", "undefined", "unknown", "not specified"})
_NUMBER = re.compile(r"^\s*(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(?P<unit>[^\d\s+-].*)?$", re.IGNORECASE)
#: A sign or code of a currency before a number; a blank between thousands; a point there would make 20.000 twenty.
_SIGNED = re.compile(r"^([^\d\s.+-]+)\s*(\d.*)$")
_BLANK = re.compile(r"(?<=\d)\s(?=\d{3}(?!\d))")
_THOUSANDS = re.compile(r"\d{1,3}\.\d{3}")
_IN_TEXT = re.compile(r"[\[(](?P<unit>[^\[\]()]+)[\])]\s*$")


@dataclass(frozen=True)
class Quantity:
    """What is measured, and the units in which it may be given.

    Parameters
    ----------
    name
        For messages.
    unit
        Unit of the program, for messages.
    units
        Factor to that unit by word, lower case without blanks; a function where no factor does it.
    """

    name: str
    unit: str
    units: Mapping[str, float | Callable[[Any], Any]]

    def knows(self, unit: str) -> bool:
        """Whether `unit` tells nothing or is one of the quantity's.

        Examples
        --------
        >>> SPEED.knows("km h-1"), SPEED.knows("hPa")
        (True, False)
        """
        return told(unit) == "" or _word(unit) in self.units

    def convert(self, values: Any, unit: str) -> Any:
        """Return values given in `unit` in that of the program; unchanged if `unit` tells nothing.

        Parameters
        ----------
        values
            A number or an array of any shape; an array in the unit of the program comes back itself.
        unit
            As files write it: "m s-1", "km/h", "[m/s]", "%".

        Raises
        ------
        KeyError
            If the quantity has no such unit; ask `knows` before.

        Examples
        --------
        >>> SPEED.convert(36.0, "km/h"), LENGTH.convert(10.0, "ft")
        (10.0, 3.048)
        """
        if not told(unit):
            return values
        how = self.units[_word(unit)]
        if callable(how):
            return how(values)
        if how == 1.0:
            return values
        kind = getattr(values, "dtype", None)
        # float32 stays float32
        return values * (kind.type(how) if kind is not None and kind.kind == "f" else how)


def _beaufort(force: Any) -> Any:
    """Metres per second of a Beaufort force, v = 0.836 B^1.5 (World Meteorological Organization, code 1100)."""
    return 0.836 * np.maximum(force, 0.0) ** 1.5


_FOOT, _US_FOOT, _MILE, _NAUTICAL_MILE, _ACRE = 0.3048, 1200 / 3937, 1609.344, 1852.0, 4046.8564224


def _per(these: Mapping[str, float], those: Mapping[str, float]) -> dict[str, float]:
    """Quotients, such as speeds of lengths and times."""
    return {f"{one}/{other}": x / y for one, x in these.items() for other, y in those.items()}


_METRE = dict.fromkeys(("m", "metre", "metres", "meter", "meters"), 1.0)
_KILOMETRE = dict.fromkeys(("km", "kilometre", "kilometres", "kilometer", "kilometers"), 1000.0)
_FEET = dict.fromkeys(("ft", "feet", "foot"), _FOOT)
_MILES = dict.fromkeys(("mi", "mile", "miles"), _MILE)
_SECOND = dict.fromkeys(("s", "sec", "second", "seconds"), 1.0)
_MINUTE = dict.fromkeys(("min", "minute", "minutes"), 60.0)
_HOUR = dict.fromkeys(("h", "hr", "hour", "hours"), 3600.0)

LENGTH = Quantity(
    "a length",
    "m",
    {
        **_METRE,
        **_KILOMETRE,
        "1": 1.0,
        "masl": 1.0,
        "mamsl": 1.0,
        "dm": 0.1,
        "cm": 0.01,
        "mm": 0.001,
        **_FEET,
        **dict.fromkeys(("internationalfoot", "internationalfeet"), _FOOT),
        **dict.fromkeys(
            ("us-ft", "ussurveyfoot", "ussurveyfeet", "ftus", "foot_us", "us_survey_foot", "ft-us"), _US_FOOT
        ),
    },
)
SPEED = Quantity(
    "a wind speed",
    "m/s",
    {
        **_per(_METRE, _SECOND | _MINUTE),
        **_per(_KILOMETRE, _HOUR),
        **_per({"cm": 0.01}, _SECOND),
        **_per(_FEET, _SECOND | _MINUTE),
        **_per(_MILES, _HOUR),
        "mps": 1.0,
        **dict.fromkeys(("kmh", "kph", "kmph"), 1 / 3.6),
        "mph": _MILE / 3600,
        **dict.fromkeys(("kn", "kt", "kts", "knot", "knots", "nmi/h"), _NAUTICAL_MILE / 3600),
        **dict.fromkeys(("bf", "bft", "beaufort"), _beaufort),
    },
)
SHARE = Quantity(
    "a share",
    "1",
    {
        **dict.fromkeys(("1", "fraction", "share", "ratio", "kg/kg", "g/g"), 1.0),
        **dict.fromkeys(("%", "percent", "pct", "percentage", "procent", "prozent"), 0.01),
        **dict.fromkeys(("g/kg", "permille", "‰"), 0.001),
    },
)
ANGLE = Quantity(
    "a direction",
    "degrees",
    {
        **dict.fromkeys(
            (
                "1",
                "degree",
                "degrees",
                "deg",
                "°",
                "degree_true",
                "degrees_true",
                "degreetrue",
                "degreestrue",
                "degtrue",
                "degreesclockwisefromnorth",
                "arcdegree",
                "arcdegrees",
                "arc_degree",
                "degreesfromnorth",
            ),
            1.0,
        ),
        **dict.fromkeys(("rad", "radian", "radians"), float(np.degrees(1.0))),
        **dict.fromkeys(("gon", "grad", "grads"), 0.9),
    },
)
TIME = Quantity(
    "a time",
    "s",
    {**_SECOND, **_MINUTE, **_HOUR, **dict.fromkeys(("d", "day", "days"), 86_400.0)},
)
_AREAS = {
    **dict.fromkeys(("ha", "hectare", "hectares"), 1.0),
    **dict.fromkeys(("m2", "m²", "m^2", "sqm"), 10_000.0),
    **dict.fromkeys(("km2", "km²", "km^2", "sqkm"), 0.01),
    **dict.fromkeys(("acre", "acres", "ac"), 10_000.0 / _ACRE),
}
AREA = Quantity("an area", "ha", {word: 1.0 / factor for word, factor in _AREAS.items()})
#: Codes of ISO 4217 that are in use, and what the same money is called in English.
_CURRENCIES = """
    aed afn all amd ang aoa ars aud awg azn bam bbd bdt bgn bhd bif bmd bnd bob brl bsd btn bwp byn bzd cad cdf chf clp
    cny cop crc cup cve czk djf dkk dop dzd egp ern etb eur fjd fkp gbp gel ghs gip gmd gnf gtq gyd hkd hnl htg huf idr
    ils inr iqd irr isk jmd jod jpy kes kgs khr kmf kpw krw kwd kyd kzt lak lbp lkr lrd lsl lyd mad mdl mga mkd mmk mnt
    mop mru mur mvr mwk mxn myr mzn nad ngn nio nok npr nzd omr pab pen pgk php pkr pln pyg qar ron rsd rub rwf sar sbd
    scr sdg sek sgd shp sle sos srd ssp stn svc syp szl thb tjs tmt tnd top try ttd twd tzs uah ugx usd uyu uzs ves vnd
    vuv wst xaf xcd xof xpf yer zar zmw zwg
    cost money euro euros dollar dollars pound pounds franc francs peso pesos real reais yen yuan rand lira rupee rupees
    krona kronor krone kroner zloty
    """
QUANTITIES = (LENGTH, SPEED, SHARE, ANGLE)


def is_money(unit: str) -> bool:
    """Tell whether a unit is a currency: its code, its sign, or its name; or the word "cost" or "money".

    Examples
    --------
    >>> is_money("EUR"), is_money("€"), is_money("US$"), is_money("sqm")
    (True, True, True, False)
    """
    word = _word(unit)
    letters = "".join(letter for letter in word if unicodedata.category(letter) != "Sc")
    return word in _CURRENCIES.split() or (letters != word and len(letters) <= 3)


def told(unit: str) -> str:
    """Return the unit without brackets; "" if it says that it is none.

    Examples
    --------
    >>> told(" [m/s] "), told("unspecified")
    ('m/s', '')
    """
    text = unit.strip().strip("[]()").strip()
    return "" if text.lower() in NOT_TOLD else text


def per_hectare(unit: str) -> float | None:
    """Return the factor that turns so much for an area into so much for a hectare; None if `unit` is not of an area.

    Examples
    --------
    >>> per_hectare("EUR/m2"), per_hectare("people ha-1"), per_hectare("EUR")
    (10000.0, 1.0, None)
    """
    _, slash, area = _word(unit).rpartition("/")
    return _AREAS.get(area) if slash else None


def unit_in(text: str) -> str:
    """Return the unit that stands in brackets at the end of a text, such as the name of a column; else "".

    Examples
    --------
    >>> unit_in("wind speed [km/h]"), unit_in("WS")
    ('km/h', '')
    """
    found = _IN_TEXT.search(text.strip())
    return told(found["unit"]) if found else ""


def read_number(text: Any, quantity: Quantity) -> float | None:
    """Return a number such as "20km/h" in the unit of the program; None if the text is no number.

    Parameters
    ----------
    text
        A number, or one as text with or without a unit of `quantity`.
    quantity
        What is measured.

    Raises
    ------
    ParameterError
        If a number is followed by something that is no unit of the quantity.

    Examples
    --------
    >>> read_number("20km/h", SPEED), read_number("8 %", SHARE), read_number("wind.tif", SPEED)
    (5.555555555555555, 0.08, None)
    """
    try:
        return float(text)
    except (TypeError, ValueError):
        found = _NUMBER.match(text) if isinstance(text, str) else None
    if found is None or found["unit"] is None:
        return None
    if not told(found["unit"]) or not quantity.knows(found["unit"]):
        raise ParameterError(
            f"{text!r} is no {quantity.name.partition(' ')[2]}: {found['unit']!r} is no unit of it; expected a number "
            f"in {quantity.unit}, or with one of: {_examples(quantity)}"
        )
    return float(quantity.convert(float(found["number"]), found["unit"]))


def read_amount(text: str) -> tuple[float, str] | None:
    """Return how much may be cut, and what it counts: "share", "ha", "cost" (money), or "" where no unit is told.

    Examples
    --------
    >>> read_amount("35%"), read_amount("2 km2"), read_amount("$20 000"), read_amount("0.1")
    ((0.35, 'share'), (200.0, 'ha'), (20000.0, 'cost'), (0.1, ''))
    >>> read_amount("20.000 EUR") is None  # twenty, or twenty thousand
    True
    """
    try:
        return float(text), ""
    except ValueError:
        found = _NUMBER.match(_SIGNED.sub(r"\2 \1", _BLANK.sub("", text.strip())))
    if found is None:
        return None
    number, unit = found["number"], (found["unit"] or "").strip()
    if not unit or is_money(unit):
        return None if unit and _THOUSANDS.fullmatch(number) else (float(number), "cost" if unit else "")
    for quantity, word in ((SHARE, "share"), (AREA, "ha")):
        if told(unit) and quantity.knows(unit):
            # In decimals, so that 35% is 0.35 and nothing beside it.
            factor = Decimal(repr(round(quantity.convert(1.0, unit), 12)))
            return float(Decimal(number) * factor), word
    return None


def require_known(unit: str, quantity: Quantity, where: str) -> None:
    """Refuse a unit in which the quantity is not measured.

    Raises
    ------
    InputError
        Saying which units are known.
    """
    if not quantity.knows(unit):
        raise InputError(
            f"{where} is in {unit!r}, expected {quantity.name} in one of: {_examples(quantity)}; convert it, or set "
            f"the true unit: gdal_edit.py -units {quantity.unit} FILE"
        )


def _examples(quantity: Quantity) -> str:
    """One word for each size of unit."""
    first: dict[Any, str] = {}
    for word, how in quantity.units.items():
        if word != "1" and (how not in first or (how == 1.0 and word == quantity.unit)):
            first[how] = word
    return ", ".join(first.values())


def _word(unit: str) -> str:
    """Return a unit as the tables write it: "m s**-1" and "metres per second" become "m/s" and "metres/second"."""
    word = re.sub(r"\s+per\s+", "/", told(unit).lower().replace("⁻¹", "-1").replace("⁻²", "-2"))
    word = re.sub(r"[\s.*·]+([a-z]+)\s*(?:\^|\*\*)?-1$", r"/\1", word)
    return re.sub(r"[\s.*·]*", "", re.sub(r"[\s.*·]+([a-z]+)\s*(?:\^|\*\*)?-2$", r"/\g<1>2", word))
