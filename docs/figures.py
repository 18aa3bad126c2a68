"""Draws every figure of the documentation with gearwright itself, from the shipped designs: python docs/figures.py."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import gearwright as gw
from gearwright.catalogue.electric_machines import NOT_READ, PublicMachine, public_machines
from gearwright.dynamics.vibration import critical_speeds
from gearwright.machines import motor_mass, motor_mass_ndarc
from gearwright.machines.electric import PUBLIC_BAND
from gearwright.mission import fly
from gearwright.particulars import particulars
from gearwright.render import style as theme
from gearwright.render.diagrams import DIAGRAMS
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.writers import sheet_svg
from gearwright.render.figures.dynamics import campbell_figure
from gearwright.render.figures.flights import profile_figure, sankey_figure
from gearwright.render.figures.masses import margin_figure, mass_figure, treemap_figure
from gearwright.render.figures.study import study_figure
from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.render.style import to_svg
from gearwright.render.vector.figure import Figure
from gearwright.shipped import shipped_mission, shipped_study
from gearwright.sizing import Sizing
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.spec import Design, edited, parse, read_mission, read_study
from gearwright.study import run
from gearwright.units import RPM

FOLDER = Path(__file__).parent / "figures"


def _sized(name: str) -> Sizing:
    return gw.size(gw.read(gw.shipped_design(name)))


def _arranged(name: str) -> Sizing:
    return gw.arrange(gw.at_level(gw.read(gw.shipped_design(name)), "preliminary")).sizing


def _study(name: str) -> Any:
    study = read_study(shipped_study(name))
    return study_figure(run(study, {each: gw.read(gw.shipped_design(each)) for each in study.designs}))


# ----------------------------------------------------------------------------------------------------------------------
# What the gearboxes of six designs weigh with every standard module, beside the one that is chosen.
# ----------------------------------------------------------------------------------------------------------------------


HEAD = """schema = 1
name = "choice"
level = "preliminary"
shafts = ["a", "b"]
[turbines.engine]
shaft = "a"
power_kw = {power}
speed_rpm = {speed}
[propellers.propeller]
shaft = "b"
speed_rpm = {slow}
diameter_m = 3
[gears]
material = "carburised-9310"
helix_angle_deg = {helix}
"""
PAIR = '[pairs.stage]\npinion = "a"\nwheel = "b"\npinion_teeth = {}\nwheel_teeth = {}\n'
SET = (
    '[planetaries.stage]\nsun = "a"\nring = "{}"\ncarrier = "{}"\nplanets = {}\nsun_teeth = {}\nplanet_teeth = {}\n'
    "ring_teeth = {}\n"
)
STEPPED = """[epicyclics.stage]
carrier = "b"
sets = 3
[epicyclics.stage.suns.sun]
shaft = "a"
teeth = 34
[epicyclics.stage.rings.ring]
shaft = "ground"
teeth = 136
[epicyclics.stage.planets.wide]
teeth = 70
meshes = ["sun"]
[epicyclics.stage.planets.narrow]
teeth = 32
meshes = ["ring"]
in_one_piece_with = "wide"
"""
BESIDE = (0.55, 1.75)
"""Modules that are drawn, over the chosen one [-]."""


class Case(NamedTuple):
    """A design of which one module is varied."""

    title: str
    text: str
    path: str
    """Of the module [mm]."""


def _of(title: str, stage: str, path: str, *, power: float, speed: float, slow: float, helix: float = 0.0) -> Case:
    head = HEAD.format(power=power, speed=speed, slow=f"{slow:.6f}", helix=helix)
    return Case(title, head + stage, path)


CASES = (
    _of("spur pair, 300 kW", PAIR.format(25, 88), "pairs.stage.module_mm", power=300, speed=6000,
        slow=6000 * 25 / 88),
    _of("helical pair, 1 MW", PAIR.format(27, 82), "pairs.stage.module_mm", power=1000, speed=12000,
        slow=12000 * 27 / 82, helix=15.0),
    _of("planetary set, 400 kW", SET.format("ground", "b", 3, 30, 36, 102), "planetaries.stage.module_mm", power=400,
        speed=6000, slow=6000 / 4.4),
    _of("planetary set, 1.5 MW", SET.format("ground", "b", 4, 40, 38, 116), "planetaries.stage.module_mm", power=1500,
        speed=4000, slow=4000 / 3.9),
    _of("star, 800 kW", SET.format("b", "ground", 5, 40, 35, 110), "planetaries.stage.module_mm", power=800,
        speed=9000, slow=9000 * 40 / 110),
    _of("stepped set, 1.9 MW", STEPPED, "epicyclics.stage.suns.sun.module_mm", power=1874, speed=12112,
        slow=12112 / (1 + 70 * 136 / (34 * 32))),
)  # fmt: skip


class Point(NamedTuple):
    """A gearbox with a module that is given."""

    module: float
    """[mm]"""
    mass: float
    """[kg]"""
    passes: bool


def curve(case: Case) -> tuple[list[Point], Point]:
    """Return the gearboxes with the standard modules around the chosen one, and the chosen one.

    Args:
        case: The design.
    """
    design = parse(case.text)
    chosen = gw.size(design)
    own = 1e3 * chosen.gears[0].module
    near = [module for module in STANDARD_MODULES if BESIDE[0] * own <= module <= BESIDE[1] * own]
    points = [point for module in near for point in _points(edited(design, {case.path: module}), module)]
    return points, Point(own, gw.complete_mass(chosen).total, not any(check.fails for check in chosen.checks))


def _points(design: Design, module: float) -> Iterator[Point]:
    """Yield the gearbox with a module; nothing where its planets have no room for a bearing."""
    try:
        sizing = gw.size(design)
    except gw.DesignError:
        return
    yield Point(module, gw.complete_mass(sizing).total, not any(check.fails for check in sizing.checks))


def choice_figure() -> Figure:
    """Return mass over module of six designs, filled where all checks pass, with the chosen point."""
    figure, panels = theme.tiles(len(CASES), 3, frame=14.0, row=52.0)
    for place, case in enumerate(CASES):
        axes = panels[divmod(place, 3)]
        points, chosen = curve(case)
        axes.plot([p.module for p in points], [p.mass for p in points], "-", color=theme.INK, lw=0.8)
        for passes, face in ((True, theme.INK), (False, theme.PAPER)):
            own = [p for p in points if p.passes is passes]
            if own:
                axes.scatter(
                    [p.module for p in own], [p.mass for p in own], 18.0, color=face, edgecolors=theme.INK, lw=0.8
                )
        axes.scatter([chosen.module], [chosen.mass], 60.0, color=theme.ORANGE, zorder=1.0)
        axes.set_title(case.title)
        axes.set_xlabel("module [mm]")
        axes.set_ylabel("complete mass [kg]")
    return figure


# ----------------------------------------------------------------------------------------------------------------------
# What public electric machines weigh, beside the law of torque and speed and NDARC's of torque.
# ----------------------------------------------------------------------------------------------------------------------


def motors_figure() -> Figure:
    """Return mass over torque of public machines with two laws, and mass over the law's with its band."""
    figure, panels = theme.tiles(2, 2, frame=14.0, row=92.0)
    groups = (
        ("in the fit", [one for one in public_machines() if one.torque and one.is_fitted], theme.INK, theme.INK),
        ("read, not in it", [one for one in public_machines() if _is_aside(one)], theme.PAPER, theme.INK),
    )
    torques = [10.0**power for power in (0.9, 3.6)]
    left, right = panels[0, 0], panels[0, 1]
    for rpm, colour in ((2000, theme.GREEN), (20000, theme.ORANGE)):
        masses = [motor_mass(torque, rpm * RPM) for torque in torques]
        left.plot(torques, masses, "-", color=colour, lw=1.0, label=f"law, {rpm} rpm")
    left.plot(torques, [motor_mass_ndarc(torque) for torque in torques], "--", color=theme.BLUE, lw=1.0, label="NDARC")
    for factor in (1.0 / PUBLIC_BAND, 1.0, PUBLIC_BAND):
        right.plot([1e3, 3e4], [factor, factor], "-" if factor == 1.0 else "--", color=theme.MUTED, lw=0.8)
    for words, machines, face, edge in groups:
        left.scatter(
            [one.torque for one in machines], [one.mass for one in machines], 18.0, color=face, edgecolors=edge, lw=0.8,
            label=words,
        )  # fmt: skip
        speeds = [one.speed / RPM for one in machines]
        ratios = [one.mass / motor_mass(one.torque, one.speed) for one in machines]
        right.scatter(speeds, ratios, 18.0, color=face, edgecolors=edge, lw=0.8)
    for axes, words in ((left, ("torque [N m]", "mass [kg]")), (right, ("speed [rpm]", "mass over the law's [-]"))):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(words[0])
        axes.set_ylabel(words[1])
    left.legend("upper left")
    return figure


def _is_aside(machine: PublicMachine) -> bool:
    return machine.speed is not None and not machine.is_fitted and machine.read != NOT_READ


FIGURES: Mapping[str, Callable[[], Any]] = {
    "hybrid-turboprop-schematic": lambda: power_flow_figure(_sized("hybrid-turboprop"), "rated"),
    "in-line-h2-schematic": lambda: power_flow_figure(_sized("in-line-h2"), "rated"),
    "off-set-schematic": lambda: schematic_figure(_sized("off-set")),
    "off-set-h2-power": lambda: power_flow_figure(_sized("off-set-h2"), "rated"),
    "differential-hybrid-power": lambda: power_flow_figure(_sized("differential-hybrid"), "rated"),
    "in-line-h2-margins": lambda: margin_figure(_sized("in-line-h2")),
    "in-line-h2-mass": lambda: mass_figure(particulars(_sized("in-line-h2"))),
    "choice": choice_figure,
    "motor-masses": motors_figure,
    "motor-speed": lambda: _study("motor-speed"),
    "architectures": lambda: _study("architectures"),
    "in-line-h2-campbell": lambda: campbell_figure(_sized("in-line-h2"), critical_speeds(_sized("in-line-h2"))[0]),
    "in-line-h2-kilograms": lambda: treemap_figure(complete_mass(_sized("in-line-h2")), None, None),
    "flight-profile": lambda: profile_figure(fly(_sized("in-line-h2"), read_mission(shipped_mission("thesis")))),
    "flight-energy": lambda: sankey_figure(fly(_sized("in-line-h2"), read_mission(shipped_mission("thesis")))),
}
"""Name of the file -> what draws it."""
SHEETS: Mapping[str, tuple[str, Callable[[], Sizing]]] = {
    "drawing-arrangement": ("arrangement", lambda: _sized("ec120b")),
    "drawing-shaft": ("shaft-input", lambda: _sized("ec120b")),
    "drawing-gear": ("gear-bevel.wheel", lambda: _sized("ec120b")),
    "drawing-arranged": ("arrangement", lambda: _arranged("in-line-h2")),
}
"""Name of the file -> sheet, and of what."""


INPUTS: Mapping[str, Callable[[], str]] = {diagram.name: diagram.svg for diagram in DIAGRAMS}
"""Name of the file -> what draws the diagram of keys of the design file."""


def svg(name: str) -> str:
    """Return one figure, sheet or diagram as it is kept."""
    if name in INPUTS:
        return INPUTS[name]()
    if name in SHEETS:
        sheet, sized = SHEETS[name]
        return sheet_svg(*sheets(sized(), [sheet]))
    return to_svg(FIGURES[name]()).rstrip("\n") + "\n"


def main() -> None:
    """Write all figures."""
    FOLDER.mkdir(exist_ok=True)
    for name in (*FIGURES, *SHEETS, *INPUTS):
        (FOLDER / f"{name}.svg").write_text(svg(name), encoding="utf-8")


if __name__ == "__main__":
    main()
