"""The look of figures that matplotlib still draws, and these as SVG or PNG, the same each time.

Fonts are those that matplotlib ships, and letters become outlines. What moves to `vector` leaves this module.
"""

from __future__ import annotations

import functools
import io
import re
from collections.abc import Callable
from typing import Any, ParamSpec

import matplotlib as mpl
from cycler import cycler
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gearwright.render.vector.palette import CYCLE, HAIR, INK, MUTED, PAPER
from gearwright.verbs import verb

WIDTH = 180.0
"""Of a figure on an A4 page [mm]."""
INCH = 25.4
"""[mm]; figures are sized in mm of paper."""

_STYLE: dict[Any, Any] = {
    "font.family": ["DejaVu Sans"],
    "font.size": 8.0,
    "axes.titlesize": 9.0,
    "axes.titlelocation": "left",
    "axes.titleweight": "bold",
    "axes.labelsize": 8.0,
    "axes.labelcolor": INK,
    "axes.edgecolor": MUTED,
    "axes.linewidth": 0.6,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": cycler(color=list(CYCLE)),
    "grid.color": HAIR,
    "grid.linewidth": 0.5,
    "text.color": INK,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "lines.linewidth": 1.1,
    "legend.frameon": False,
    "legend.fontsize": 7.5,
    "figure.facecolor": PAPER,
    "hatch.linewidth": 0.6,
    "xtick.minor.visible": False,
    "ytick.minor.visible": False,
    "svg.fonttype": "path",
    "svg.hashsalt": "gearwright",
    "path.simplify": True,
    # What a user wrote is never read as mathematics; a text of ours that is one says so itself.
    "text.parse_math": False,
}
_FINISH: dict[Any, Any] = {**_STYLE, "text.parse_math": True}
"""For what matplotlib itself adds when it lays a figure out: labels of logarithmic axes are powers."""

_Inputs = ParamSpec("_Inputs")


def styled(draw: Callable[_Inputs, Figure]) -> Callable[_Inputs, Figure]:
    """Return a drawing function whose figure has the look of this module and leaves matplotlib's settings alone.

    Args:
        draw: Builds the figure; it refuses what is not of its types, as every public verb.
    """
    built = verb(draw)

    @functools.wraps(draw)
    def drawn(*args: _Inputs.args, **kwargs: _Inputs.kwargs) -> Figure:
        with mpl.rc_context(_STYLE):
            figure = built(*args, **kwargs)
            _allow_powers(figure)
        with mpl.rc_context(_FINISH):
            # Solved anew at every saving, the layout would drift in the last digits.
            engine = figure.get_layout_engine()
            if engine is not None:
                engine.execute(figure)
                figure.set_layout_engine("none")
        return figure

    return drawn


def _allow_powers(figure: Figure) -> None:
    """Let those labels of logarithmic axes that are there already be powers, as later ones are."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if axis.get_scale() in ("log", "symlog"):
                for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                    tick.label1.set_parse_math(True)
                    tick.label2.set_parse_math(True)


def sheet(width: float, height: float) -> Figure:
    """Return an empty figure.

    Args:
        width: Of the paper [mm].
        height: Of the paper [mm].
    """
    return Figure(figsize=(width / INCH, height / INCH), layout="constrained")


def tiles(
    count: int, columns: int, *, frame: float, row: float, sharex: bool = False, sharey: bool = False
) -> tuple[Figure, NDArray[Any]]:
    """Return a figure as wide as a page and its panels in rows; those that are left over stay empty.

    Args:
        count: Of panels that are drawn.
        columns: Panels side by side.
        frame: Height of all that stands outside the rows [mm].
        row: Height of a row [mm].
        sharex: One scale along x for all.
        sharey: One scale along y for all.
    """
    rows = max(1, -(-count // columns))
    figure = sheet(WIDTH, frame + row * rows)
    grid = figure.subplots(rows, columns, squeeze=False, sharex=sharex, sharey=sharey)
    for axes in grid.flat[count:]:
        axes.set_axis_off()
    return figure, grid


def only_grid(axes: Axes, axis: str) -> None:
    """Keep the grid lines of one axis, as bars need.

    Args:
        axes: To change.
        axis: ``"x"`` or ``"y"``.
    """
    other = axes.yaxis if axis == "x" else axes.xaxis
    other.grid(visible=False)
    other.set_tick_params(length=0)


def to_svg(figure: Figure, prefix: str = "") -> str:
    """Return a figure as an SVG element that stands alone or inside a page.

    Args:
        figure: As drawn.
        prefix: Goes before every id, so that several figures can share a page.
    """
    buffer = io.StringIO()
    with mpl.rc_context(_FINISH):
        # Straight to its canvas: `savefig` draws everything twice, the first time for a layout that is solved already.
        resolution = figure.dpi
        nothing = {"Date": None, "Creator": None, "Format": None, "Type": None}
        FigureCanvasSVG(figure).print_svg(buffer, metadata=nothing)  # type: ignore[no-untyped-call]
        figure.dpi = resolution
    text = buffer.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>\s*", "", text, flags=re.DOTALL)
    numbers: dict[str, int] = {}
    # matplotlib names clips and markers by a digest of coordinates, whose last bits differ between processors.
    text = re.sub(r"(?<=[\"#][a-z])[0-9a-f]{10}\b", lambda found: str(numbers.setdefault(found[0], len(numbers))), text)
    if prefix:
        text = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{prefix}-", text)
    return re.sub(r"[ \t]+\n", "\n", text)


def to_png(figure: Figure, resolution: float) -> bytes:
    """Return a figure as a PNG image.

    Args:
        figure: As drawn.
        resolution: [dots per inch].
    """
    buffer = io.BytesIO()
    with mpl.rc_context(_FINISH):
        figure.savefig(buffer, format="png", dpi=resolution, metadata={"Software": None})
    return buffer.getvalue()
