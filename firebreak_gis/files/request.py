"""Where the result of a command goes: one typed value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class OutputRequest:
    """What may be written, and how.

    Parameters
    ----------
    output
        The folder or file.
    overwrite
        Whether existing files may be replaced.
    creation_options
        More options of GDAL's COG driver, for rasters.
    """

    output: str
    overwrite: bool = False
    creation_options: Mapping[str, str] = field(default_factory=dict)
