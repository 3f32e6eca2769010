"""The spread probability edge by edge, in scalar arithmetic, written from the formulas of the paper."""

from __future__ import annotations

import math
from typing import Any

#: Name, row step, column step and azimuth (degrees clockwise from north) of the eight neighbours.
NEIGHBOURS = (
    ("N", -1, 0, 0),
    ("NE", -1, 1, 45),
    ("E", 0, 1, 90),
    ("SE", 1, 1, 135),
    ("S", 1, 0, 180),
    ("SW", 1, -1, 225),
    ("W", 0, -1, 270),
    ("NW", -1, -1, 315),
)
TABLE_1 = {
    "p0": 0.58,
    "a": 0.078,
    "c1": 0.045,
    "c2": 0.131,
    "agricultural": -0.3,
    "shrubs": 0.0,
    "pines": 0.4,
    "sparse": -0.4,
    "normal": 0.0,
    "dense": 0.3,
}


def edge(
    *,
    rise: float,
    distance: float,
    vegetation: int,
    density: int,
    azimuth: float,
    wind_speed: float,
    wind_from: float,
    parameters: dict[str, float],
) -> float:
    """p(l -> k); `vegetation` and `density` are those of k, `rise` is z_k - z_l."""
    p = parameters
    type_effect = (p["agricultural"], p["shrubs"], p["pines"])[vegetation - 1]
    density_effect = (p["sparse"], p["normal"], p["dense"])[density - 1]
    slope = math.degrees(math.atan(rise / distance))
    phi = math.radians(azimuth - (wind_from + 180.0))
    wind = math.exp(wind_speed * (p["c1"] + p["c2"] * (math.cos(phi) - 1.0)))
    return min(1.0, p["p0"] * (1 + type_effect) * (1 + density_effect) * math.exp(p["a"] * slope) * wind)


def alexandridis(landscape: Any, wind_speed: Any = 0.0, wind_from: Any = 0.0, **changed: float) -> dict:
    """Probability by (row, col, direction name), for every edge that exists."""
    elevation, vegetation = landscape["elevation"].values.tolist(), landscape["vegetation"].values.tolist()
    density, fuel = landscape["density"].values.tolist(), landscape["burnable"].values.tolist()
    rows, cols = len(fuel), len(fuel[0])
    cell = float(landscape["x"][1] - landscape["x"][0])
    periodic = landscape.attrs["boundary"] == "periodic"
    found = {}
    for row in range(rows):
        for col in range(cols):
            for name, down, right, azimuth in NEIGHBOURS:
                to_row, to_col = row + down, col + right
                if periodic:
                    to_row, to_col = to_row % rows, to_col % cols
                if not (0 <= to_row < rows and 0 <= to_col < cols):
                    continue
                if fuel[row][col] and fuel[to_row][to_col]:
                    found[row, col, name] = edge(
                        rise=elevation[to_row][to_col] - elevation[row][col],
                        distance=cell * math.sqrt(2) if down and right else cell,
                        vegetation=vegetation[to_row][to_col],
                        density=density[to_row][to_col],
                        azimuth=azimuth,
                        wind_speed=float(wind_speed if not hasattr(wind_speed, "shape") else wind_speed[row, col]),
                        wind_from=float(wind_from if not hasattr(wind_from, "shape") else wind_from[row, col]),
                        parameters={**TABLE_1, **changed},
                    )
    return found


def artificial(landscape: Any) -> dict:
    """p(l -> k) = 1 - s_k by (row, col, direction name) on the torus."""
    emptiness = landscape["emptiness"].values.tolist()
    rows, cols = len(emptiness), len(emptiness[0])
    return {
        (row, col, name): 1.0 - emptiness[(row + down) % rows][(col + right) % cols]
        for row in range(rows)
        for col in range(cols)
        for name, down, right, _ in NEIGHBOURS
    }


def as_dict(network: Any) -> dict:
    """The non-zero probabilities of a network, keyed as above."""
    rows, cols = network.shape
    return {
        (row, col, name): float(network.probability[d, row, col])
        for d, (name, *_) in enumerate(NEIGHBOURS)
        for row in range(rows)
        for col in range(cols)
        if network.probability[d, row, col] > 0
    }


#: Constants of the rate of spread and of the heat, as published; rates in m/h, moisture in percent.
RATE = {
    "rate": (120.0, 140.0, 200.0),
    "wind": 0.1783,
    "slope": 3.533,
    "power": 1.2,
    "moisture": 0.014,
    "factors": (0.01, 10.0),
    "rates": (0.01, 100.0),  # m/min
    "scale": 1.0,
}
FUEL = ((0.5, 0.0, 17_000.0, 60.0), (1.0, 3.0, 21_000.0, 45.0), (1.0, 4.0, 21_000.0, 55.0))


def _within(value: float, ends: tuple[float, float]) -> float:
    return min(max(value, ends[0]), ends[1])


def metres_per_minute(
    *, base: float, rise: float, distance: float, angle: float, wind_speed: float, percent: float, constants: dict
) -> float:
    """Rate of spread; `base` in m/h, `angle` in degrees between the wind and the way that fire goes."""
    c = constants
    wind = _within(math.exp(c["wind"] * wind_speed * math.cos(math.radians(angle))), c["factors"])
    steep = c["slope"] * math.pow(abs(rise / distance), c["power"])
    slope = _within(math.exp(math.copysign(steep, rise)), c["factors"])
    return _within(c["scale"] * base / 60.0 * wind * slope * math.exp(-c["moisture"] * percent), c["rates"])


def seconds(landscape: Any, wind_speed: Any = 0.0, wind_from: Any = 0.0, percent: Any = 0.0, **changed: Any) -> dict:
    """Travel time by (row, col, direction name), not rounded, for every pair of neighbours with fuel."""
    constants = {**RATE, **changed}
    elevation, vegetation = landscape["elevation"].values.tolist(), landscape["vegetation"].values.tolist()
    given = landscape["rate"].values.tolist() if "rate" in landscape else None
    rows, cols = len(elevation), len(elevation[0])
    cell = float(landscape["x"][1] - landscape["x"][0])

    def at(value: Any, row: int, col: int) -> float:
        return float(value[row, col] if hasattr(value, "shape") else value)

    found = {}
    for row, col, name in alexandridis(landscape):
        _, down, right, azimuth = next(n for n in NEIGHBOURS if n[0] == name)
        rise = elevation[(row + down) % rows][(col + right) % cols] - elevation[row][col]
        distance = cell * math.sqrt(2) if down and right else cell
        base = constants["rate"][vegetation[row][col] - 1]
        if given is not None and not math.isnan(given[row][col]):
            base = given[row][col]
        speed = metres_per_minute(
            base=base,
            rise=rise,
            distance=distance,
            angle=azimuth - (at(wind_from, row, col) + 180.0),
            wind_speed=at(wind_speed, row, col),
            percent=at(percent, row, col),
            constants=constants,
        )
        found[row, col, name] = 60.0 * math.sqrt(distance**2 + rise**2) / speed
    return found


def heat(vegetation: int, percent: float) -> float:
    """kJ/m2 that a class releases when its dead fuel holds `percent` of water."""
    dead, live, content, wet = FUEL[vegetation - 1]

    def low(percent: float) -> float:
        return content * (1 - percent / 100) - 2442 * percent / 100

    return dead * low(percent) + live * low(wet)


def times_as_dict(network: Any) -> dict:
    """The travel times of a network where there is an edge, keyed as above."""
    return {key: int(network.travel_time[_number(key[2]), key[0], key[1]]) for key in as_dict(network)}


def _number(name: str) -> int:
    return [n[0] for n in NEIGHBOURS].index(name)
