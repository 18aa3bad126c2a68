"""Closed designs held against what could be lighter: ``benchmarks/closure.py grid|shrink|life|cost|eased [DESIGN …]``.

``grid`` tries every standard module and every number of teeth of a pair, each with the least whole width that serves,
and compares the lightest that meets everything with what ``close --free teeth`` finds. ``shrink`` makes every module,
width, pin, plate and shaft of designs 2 % less, one at a time, and reviews each. ``life`` closes designs for some lives
on continuous sizes, and prints how far the life of the stage that ends first lies from what was asked. ``cost`` closes
designs and prints the processor time and what was looked at; ``eased`` closes each for 20 000, 5000 and 1000 h and
prints by how much the complete mass changes where less is asked.
"""

from __future__ import annotations

import bisect
import sys
import time
from collections.abc import Iterator

import gearwright as gw
from gearwright.closure import Closed, Wishes, close
from gearwright.closure.loop import Factors, changes_of, confirmed
from gearwright.closure.requirements import LONGEST
from gearwright.dynamics.vibration import peak_checks, resonance_checks
from gearwright.errors import GearwrightError
from gearwright.sizing.mass import complete_mass
from gearwright.spec import Design, edited, parse

HOUR = 3600.0
CLOSED = ("in-line-star", "in-line-h1-star", "in-line-h2-star", "off-set-h1-free")
ARCHITECTURES = (
    "off-set", "off-set-h1", "off-set-h2", "off-set-h3", "in-line-star", "in-line-h1-star", "in-line-h2-star",
    "mixed", "mixed-h1", "mixed-h2",
)  # fmt: skip
LIVES = (300.0, 1000.0, 3000.0, 20000.0)
EASED = (20000.0, 5000.0, 1000.0)
"""That are asked [h]."""
PAIR = """\
schema = 1
name = "one pair"
shafts = ["fast", "slow"]

[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 6000

[propellers.propeller]
shaft = "slow"
speed_rpm = 2000
diameter_m = 2

[pairs.stage]
pinion = "fast"
wheel = "slow"
pinion_teeth = 25
wheel_teeth = 75

[gears]
rating = "iso6336"
"""
MODULES = (1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.5, 4.0, 4.5, 5.0)
TEETH = range(17, 91, 2)


def meets(design: Design) -> float | None:
    """Return the complete mass of a design that serves and that neither resonance nor a run speaks against [kg]."""
    sizing = gw.size(design)
    if not serves(design) or any(check.fails for check in (*resonance_checks(sizing), *peak_checks(sizing))):
        return None
    return complete_mass(sizing).total


def narrowest(design: Design, module: float, teeth: int, lightest: float) -> tuple[float, int] | None:
    """Return mass [kg] and width [mm] of the narrowest pair that meets everything, in whole millimetres.

    Strength grows with the width, so that the least one is found by halving; from there on each is tried in turn. What
    shakes teeth only adds to their load, and mass grows with the width: a pair whose least width without it weighs as
    much as the lightest that is known has nothing lighter, and is left out.
    """
    given = {"pairs.stage.module_mm": module, "pairs.stage.pinion_teeth": teeth, "pairs.stage.wheel_teeth": 3 * teeth}

    def at(width: int) -> Design:
        return edited(design, {**given, "pairs.stage.face_width_mm": width})

    widths = range(3, int(min(20.0 * module, 0.8 * module * teeth)) + 1)
    least = bisect.bisect_left(widths, 1, key=lambda width: int(bears(at(width))))
    if least == len(widths) or complete_mass(gw.size(at(widths[least]))).total >= lightest:
        return None
    place = bisect.bisect_left(widths, 1, lo=least, key=lambda width: int(serves(at(width))))
    return next(((mass, width) for width in widths[place : place + 6] if (mass := meets(at(width))) is not None), None)


def bears(design: Design) -> bool:
    """Tell whether a design can be sized and meets all that its sizing checks, without what shakes it."""
    try:
        return not any(check.fails for check in gw.size(design).checks)
    except GearwrightError:
        return False


def serves(design: Design) -> bool:
    """Tell whether a design can be sized and meets all that its sizing checks, shaken as its forced response says."""
    try:
        shaken = edited(design, changes_of(design, Factors(confirmed(gw.size(design)), {})))
        return not any(check.fails for check in gw.size(shaken).checks)
    except GearwrightError:
        return False


def grid() -> None:
    """Print the lightest of all modules and teeth, and what the closure finds."""
    began, design = time.process_time(), parse(PAIR)
    found = close(design, wishes=Wishes(free=("teeth",)))
    gear, spent = found.sizing.gears[0], time.process_time() - began
    size = f"z {gear.teeth}, m_n {1e3 * gear.module:g} mm, b {1e3 * gear.face_width:g} mm"
    print(f"closed: {found.whole.total:.3f} kg, {size}, {found.outcome}; {spent:.1f} s of processor time")
    rows, pairs = [], [(module, teeth) for module in MODULES for teeth in TEETH]
    for module, teeth in pairs:
        if row := narrowest(design, module, teeth, 1.02 * found.whole.total):
            rows.append((*row, module, teeth))
    for mass, width, module, teeth in sorted(rows)[:5]:
        print(f"grid: {mass:.3f} kg, z {teeth}, m_n {module:g} mm, b {width} mm")
    spent = time.process_time() - began
    print(
        f"of {len(pairs)} pairs {len(rows)} meet everything and are not ruled out by their mass; {spent:.0f} s in all"
    )


def sizes(design: Design) -> Iterator[tuple[str, float]]:
    """Yield path and value of every size that a closed design states [mm]."""
    for name, stage in design.simple_stages.items():
        for key in ("module", "face_width", "pin_diameter", "plate_thickness"):
            if (value := getattr(stage, key, None)) is not None:
                yield f"{design.table(name)}.{key}_mm", 1e3 * value
    for name, shaft in design.layout.items():
        if shaft.diameter is not None:
            yield f"layout.{name}.diameter_mm", 1e3 * shaft.diameter


def shrink(names: tuple[str, ...]) -> None:
    """Print what fails where one size is 2 % less, or the next whole millimetre of a width."""
    for name in names:
        design = gw.read(name)
        for path, value in sizes(design):
            less = [0.98 * value, *([value - 1.0] if path.endswith("face_width_mm") else [])]
            reviews = [gw.review(edited(design, {path: other})).failing for other in less]
            told = next((f"{row[0].name} {row[0].margin:.4f}" for row in reviews if row), "NOTHING FAILS")
            print(f"{name:16} {path:36} {'2 % less' if reviews[0] else '1 mm less'}: {told}", flush=True)


def life(names: tuple[str, ...]) -> None:
    """Print the shortest life of the gears of designs that are closed on continuous sizes over what was asked."""
    for name in names:
        for hours in LIVES:
            found = close(free_of_sizes(gw.read(name)), wishes=Wishes(hours * HOUR, rounded=False, lighten=False))
            print(f"{name:16} {hours:6g} h: {shortest(found, hours)}", flush=True)


def cost(names: tuple[str, ...]) -> None:
    """Print what it takes to close designs: processor time, sizings, changes."""
    for name in names:
        begun = time.process_time()
        found = close(gw.read(name))
        spent, effort = time.process_time() - begun, found.effort
        looked = f"{effort.sizings} sizings, {effort.looked_at} changes looked at"
        print(f"{name:16} {found.whole.total:8.2f} kg, {len(found.unmet)} unmet, {spent:6.1f} s, {looked}", flush=True)


def eased(names: tuple[str, ...]) -> None:
    """Print by how much the complete mass of designs changes where less life is asked."""
    for name in names:
        before = None
        for hours in EASED:
            found = close(gw.read(name), wishes=Wishes(hours * HOUR))
            mass = found.whole.total
            told = "" if before is None else f", {mass / before - 1.0:+.2%}"
            print(f"{name:16} {hours:6g} h: {mass:8.2f} kg, {len(found.unmet)} unmet{told}", flush=True)
            before = mass


def free_of_sizes(design: Design) -> Design:
    """Return a design without the sizes that a closure wrote into it."""
    stages = [path for path, _ in sizes(design) if not path.startswith("layout")]
    return edited(design, dict.fromkeys(stages))


def shortest(found: Closed, hours: float) -> str:
    """Return by how much the shortest life of the gears differs from what was asked, and whose it is."""
    first = found.lives[0]
    said = "endless" if first.life >= LONGEST else f"{first.life / HOUR / hours - 1.0:+.2%}"
    return f"{said}, {first.governs}; {found.outcome}"


if __name__ == "__main__":
    what, chosen = sys.argv[1], tuple(sys.argv[2:])
    if what == "grid":
        grid()
    elif what == "shrink":
        shrink(chosen or CLOSED)
    elif what == "cost":
        cost(chosen or ARCHITECTURES)
    elif what == "eased":
        eased(chosen or ARCHITECTURES)
    else:
        life(chosen or ARCHITECTURES)
