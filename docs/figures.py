"""Draws every figure of the documentation with gearwright itself, from the shipped designs: python docs/figures.py."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from choice import choice_figure

import gearwright as gw
from gearwright.dynamics.vibration import critical_speeds
from gearwright.mission import fly
from gearwright.particulars import particulars
from gearwright.render.diagrams import DIAGRAMS
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.writers import sheet_svg
from gearwright.render.figures.dynamics import campbell_figure
from gearwright.render.figures.flights import profile_figure, sankey_figure
from gearwright.render.figures.masses import margin_figure, mass_figure, treemap_figure
from gearwright.render.figures.study import study_figure
from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.render.style import to_svg
from gearwright.shipped import shipped_mission, shipped_study
from gearwright.sizing import Sizing
from gearwright.sizing.mass import complete_mass
from gearwright.spec import read_mission, read_study
from gearwright.study import run

FOLDER = Path(__file__).parent / "figures"


def _sized(name: str) -> Sizing:
    return gw.size(gw.read(gw.shipped_design(name)))


def _study(name: str) -> Any:
    study = read_study(shipped_study(name))
    return study_figure(run(study, {each: gw.read(gw.shipped_design(each)) for each in study.designs}))


FIGURES: Mapping[str, Callable[[], Any]] = {
    "hybrid-turboprop-schematic": lambda: power_flow_figure(_sized("hybrid-turboprop"), "rated"),
    "in-line-h2-schematic": lambda: power_flow_figure(_sized("in-line-h2"), "rated"),
    "off-set-schematic": lambda: schematic_figure(_sized("off-set")),
    "off-set-h2-power": lambda: power_flow_figure(_sized("off-set-h2"), "rated"),
    "differential-hybrid-power": lambda: power_flow_figure(_sized("differential-hybrid"), "rated"),
    "in-line-h2-margins": lambda: margin_figure(_sized("in-line-h2")),
    "in-line-h2-mass": lambda: mass_figure(particulars(_sized("in-line-h2"))),
    "choice": choice_figure,
    "motor-speed": lambda: _study("motor-speed"),
    "architectures": lambda: _study("architectures"),
    "in-line-h2-campbell": lambda: campbell_figure(_sized("in-line-h2"), critical_speeds(_sized("in-line-h2"))[0]),
    "in-line-h2-kilograms": lambda: treemap_figure(complete_mass(_sized("in-line-h2")), None, None),
    "flight-profile": lambda: profile_figure(fly(_sized("in-line-h2"), read_mission(shipped_mission("thesis")))),
    "flight-energy": lambda: sankey_figure(fly(_sized("in-line-h2"), read_mission(shipped_mission("thesis")))),
}
"""Name of the file -> what draws it."""
SHEETS: Mapping[str, str] = {
    "drawing-arrangement": "arrangement",
    "drawing-shaft": "shaft-input",
    "drawing-gear": "gear-bevel.wheel",
}
"""Name of the file -> sheet of the EC120B gearbox."""


INPUTS: Mapping[str, Callable[[], str]] = {diagram.name: diagram.svg for diagram in DIAGRAMS}
"""Name of the file -> what draws the diagram of keys of the design file."""


def svg(name: str) -> str:
    """Return one figure, sheet or diagram as it is kept."""
    if name in INPUTS:
        return INPUTS[name]()
    if name in SHEETS:
        return sheet_svg(*sheets(_sized("ec120b"), [SHEETS[name]]))
    return to_svg(FIGURES[name]()).rstrip("\n") + "\n"


def main() -> None:
    """Write all figures."""
    FOLDER.mkdir(exist_ok=True)
    for name in (*FIGURES, *SHEETS, *INPUTS):
        (FOLDER / f"{name}.svg").write_text(svg(name), encoding="utf-8")


if __name__ == "__main__":
    main()
