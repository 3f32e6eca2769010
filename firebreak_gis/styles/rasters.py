"""QGIS styles (.qml) for the variables of the schema; valid for QGIS 3.22 and later, 4 included."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

from firebreak_gis.schema import Variable


def qml(variable: Variable, *, minimum: float | None = None, maximum: float | None = None) -> str:
    """Return the style of a variable as the text of a .qml file.

    Classes get one colour each; other variables a linear ramp.

    Parameters
    ----------
    variable
        From the schema.
    minimum, maximum
        Ends of the ramp; by default the range of the schema, else 0 and 1.

    Raises
    ------
    ValueError
        If the variable has no colours.
    """
    if not variable.colours:
        raise ValueError(f"{variable.name} has no colours in the schema")
    if variable.classes:
        renderer = _paletted(variable)
    else:
        low = _first(minimum, variable.minimum, 0.0)
        high = _first(maximum, variable.maximum, 1.0)
        renderer = _ramp(variable, low, high if high > low else low + 1.0)
    return (
        "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
        '<qgis version="3.22.0" styleCategories="Symbology">\n'
        " <pipe>\n"
        "  <provider>\n"
        '   <resampling enabled="false" maxOversampling="2" zoomedInResamplingMethod="nearestNeighbour" '
        'zoomedOutResamplingMethod="nearestNeighbour"/>\n'
        "  </provider>\n"
        f"{renderer}"
        '  <brightnesscontrast brightness="0" contrast="0" gamma="1"/>\n'
        '  <huesaturation saturation="0" grayscaleMode="0" colorizeOn="0" colorizeStrength="100" '
        'colorizeRed="255" colorizeGreen="128" colorizeBlue="128" invertColors="0"/>\n'
        '  <rasterresampler maxOversampling="2"/>\n'
        "  <resamplingStage>resamplingFilter</resamplingStage>\n"
        " </pipe>\n"
        " <blendMode>0</blendMode>\n"
        "</qgis>\n"
    )


def rgba(colour: str) -> tuple[int, int, int, int]:
    """Return red, green, blue, alpha (0 to 255) of "#rrggbb" or "#rrggbbaa"."""
    digits = colour.removeprefix("#")
    parts = [int(digits[i : i + 2], 16) for i in range(0, len(digits), 2)]
    red, green, blue = parts[:3]
    return red, green, blue, parts[3] if len(parts) == 4 else 255


def _first(*values: float | None) -> float:
    return float(next(value for value in values if value is not None))


def _entry(tag: str, value: str, colour: str, label: str) -> str:
    parts = {"value": value, "color": colour[:7], "alpha": str(rgba(colour)[3]), "label": label}
    return f"     <{tag} {' '.join(f'{key}={quoteattr(text)}' for key, text in parts.items())}/>\n"


def _paletted(variable: Variable) -> str:
    entries = "".join(
        _entry("paletteEntry", str(code), variable.colours[code], label) for code, label in variable.classes.items()
    )
    return (
        '  <rasterrenderer type="paletted" band="1" opacity="1" alphaBand="-1" nodataColor="">\n'
        "   <rasterTransparency/>\n"
        f"   <colorPalette>\n{entries}   </colorPalette>\n"
        "  </rasterrenderer>\n"
    )


def _ramp(variable: Variable, low: float, high: float) -> str:
    colours = [variable.colours[key] for key in sorted(variable.colours)]
    last = len(colours) - 1
    values = [low + (high - low) * i / last for i in range(last + 1)]
    items = "".join(
        _entry("item", f"{value:.9g}", colour, f"{value:.4g}") for value, colour in zip(values, colours, strict=True)
    )
    return (
        '  <rasterrenderer type="singlebandpseudocolor" band="1" opacity="1" alphaBand="-1" nodataColor="" '
        f'classificationMin="{low:.9g}" classificationMax="{high:.9g}">\n'
        "   <rasterTransparency/>\n"
        "   <minMaxOrigin>\n    <limits>None</limits>\n    <extent>WholeRaster</extent>\n"
        "    <statAccuracy>Exact</statAccuracy>\n   </minMaxOrigin>\n"
        "   <rastershader>\n"
        '    <colorrampshader colorRampType="INTERPOLATED" classificationMode="1" clip="0" '
        f'minimumValue="{low:.9g}" maximumValue="{high:.9g}" labelPrecision="4">\n'
        f"{items}"
        "    </colorrampshader>\n"
        "   </rastershader>\n"
        "  </rasterrenderer>\n"
    )
