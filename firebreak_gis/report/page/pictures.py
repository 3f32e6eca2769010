"""Rasters and outlines as a page can show them: small PNGs in the colours of the schema, GeoJSON in metres."""

from __future__ import annotations

import base64
import io
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.kernels.keys import distinct
from firebreak_gis.report.figures import hillshade, ramp, thin, thinning
from firebreak_gis.report.page.content import Picture
from firebreak_gis.schema import VARIABLES

if TYPE_CHECKING:
    from collections.abc import Callable

    import geopandas as gpd

_STEPS = 6


def of_classes(
    name: str, values: np.ndarray, *, key: str, label: str, shown: bool = False, base: bool = False
) -> Picture:
    """Picture of a variable with classes, in the colours of the schema.

    Parameters
    ----------
    name
        Variable of the schema.
    values
        (rows, cols) codes.
    key, label, shown, base
        See `Picture`.
    """
    variable = VARIABLES[name]
    table = np.zeros((256, 4), np.uint8)
    for code, colour in variable.colours.items():
        table[int(code)] = _rgba(colour)
    codes = np.clip(thin(np.asarray(values)), 0, 255).astype(np.uint8)
    legend = tuple((variable.colours[c], text) for c, text in variable.classes.items() if _rgba(variable.colours[c])[3])
    return Picture(key, label, png(table[codes]), legend, shown, base)


def of_numbers(
    name: str,
    values: np.ndarray,
    *,
    key: str,
    label: str,
    low: float | None = None,
    high: float | None = None,
    shown: bool = False,
    base: bool = False,
    form: Callable[[float], str] = "{:g}".format,
) -> Picture:
    """Picture of a continuous variable, in its ramp from `low` to `high`; NaN is transparent.

    Parameters
    ----------
    name
        Variable of the schema, for the colours.
    values
        (rows, cols) floats.
    low, high
        Ends of the ramp; by default the least and the largest value.
    form
        Text of a number of the legend.
    """
    numbers = thin(np.asarray(values)).astype(np.float64)
    known = numbers[np.isfinite(numbers)]
    low = float(known.min()) if low is None and known.size else (low or 0.0)
    high = float(known.max()) if high is None and known.size else (1.0 if high is None else high)
    high = high if high > low else low + 1.0
    colours = ramp(name)
    scaled = np.clip((numbers - low) / (high - low), 0.0, 1.0)
    # 64 colours are told apart as well as 256, and compress better.
    image = (255 * colours(np.round(np.nan_to_num(scaled) * 63) / 63)).round().astype(np.uint8)
    image[~np.isfinite(numbers), 3] = 0
    steps = [k / (_STEPS - 1) for k in range(_STEPS)]
    legend = tuple((_hex(colours(step)), form(low + step * (high - low))) for step in steps)
    return Picture(key, label, png(image), legend, shown, base)


def of_terrain(elevation: np.ndarray, cell_size: float, water: np.ndarray | None = None) -> Picture:
    """Shaded terrain in grey, the ground of every map; cells of `water` are transparent."""
    shade = hillshade(thin(elevation).astype(np.float64), cell_size * thinning(elevation.shape))
    grey = np.round(np.clip(np.nan_to_num(shade, nan=0.6), 0.0, 1.0) * 47) / 47
    level = (96 + 150 * grey).astype(np.uint8)
    image = np.stack([level, level, level, np.full_like(level, 255)], axis=-1)
    if water is not None:
        image[thin(water)] = 0
    return Picture("terrain", "Terrain shade", png(image), (), True, True)


def png(image: np.ndarray) -> str:
    """Data address of a PNG of (rows, cols, 4) uint8; the same image gives the same text."""
    from PIL import Image

    drawn = io.BytesIO()
    points = np.ascontiguousarray(image).view(np.uint32)[..., 0]
    colours = distinct(points)
    if colours.size <= 256:  # nothing is lost by a palette
        picture = Image.fromarray(np.searchsorted(colours, points).astype(np.uint8), "P")
        palette = colours.view(np.uint8).reshape(-1, 4)
        picture.putpalette(palette[:, :3].tobytes(), "RGB")
        picture.save(drawn, format="PNG", transparency=palette[:, 3].tobytes())
    else:
        Image.fromarray(image, "RGBA").save(drawn, format="PNG")
    return "data:image/png;base64," + base64.b64encode(drawn.getvalue()).decode("ascii")


def outlines(frame: gpd.GeoDataFrame, origin: tuple[float, float], cards: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """GeoJSON features of a frame, in metres from `origin`, to a tenth of a metre.

    Parameters
    ----------
    frame
        Geometries in the CRS of the map.
    origin
        Easting and northing of the lower left corner.
    cards
        Properties of each feature.
    """
    import shapely

    moved = shapely.transform(frame.geometry.to_numpy(), lambda xy: np.round(xy - np.asarray(origin), 1))
    return [
        {"type": "Feature", "geometry": shapely.geometry.mapping(shape), "properties": card}
        for shape, card in zip(moved, cards, strict=True)
    ]


def _rgba(colour: str) -> tuple[int, int, int, int]:
    digits = colour.lstrip("#").ljust(8, "f")
    red, green, blue, opacity = (int(digits[k : k + 2], 16) for k in (0, 2, 4, 6))
    return red, green, blue, opacity


def _hex(colour: Any) -> str:
    red, green, blue = (round(255 * float(part)) for part in colour[:3])
    return f"#{red:02x}{green:02x}{blue:02x}"
