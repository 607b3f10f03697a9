# SPDX-License-Identifier: MIT
"""Particles as Matplotlib draws them, which is imported with the first plot."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

# A solid of the outlines, whose last corner is joined to the first (docs/snapshots.md).
_SOLID = 2


def new_axes() -> Axes:
    """Axes of a figure of their own. Errors: ImportError where Matplotlib is missing."""
    try:
        import matplotlib.pyplot
    except ImportError as error:
        raise ImportError("plot() needs Matplotlib, which is not installed: `pip install matplotlib`, on Debian "
                          "`apt install python3-matplotlib`") from error
    return matplotlib.pyplot.subplots(layout="constrained")[1]


def add_particles(axes: Axes, x: NDArray[Any], y: NDArray[Any], diameter: float, values: Optional[NDArray[Any]],
                  label: Optional[str], limits: Optional[List[float]], options: Any) -> None:
    """Adds discs of a diameter in the units of the axes, and a colour bar where there are values."""
    from matplotlib.collections import EllipseCollection
    discs = EllipseCollection([diameter], [diameter], [0], units="xy", offsets=np.column_stack([x, y]),
                              offset_transform=axes.transData, array=values, **options)
    if limits and "clim" not in options and "norm" not in options:
        discs.set_clim(*limits)
    axes.add_collection(discs)
    if values is not None:
        axes.figure.colorbar(discs, ax=axes, label=label or "")


def add_outlines(axes: Axes, x: NDArray[Any], y: NDArray[Any], line: NDArray[Any], sides: NDArray[Any]) -> None:
    """Adds the outlines of walls and bodies: corners, the number of the line of each, and its kind."""
    from matplotlib.collections import LineCollection
    corners, lines = np.column_stack([x, y]), []
    for piece in np.split(np.arange(len(line)), np.flatnonzero(np.diff(line.astype(np.int64))) + 1):
        if len(piece) > 0:
            lines.append(corners[np.append(piece, piece[:1]) if sides[piece[0]] == _SOLID else piece])
    axes.add_collection(LineCollection(lines, colors="black", linewidths=1.5))
