"""What planets of the shipped turboprop sets can turn on: every size of rollers and films that has room.

``python benchmarks/planet_bearings.py [design ...]`` goes over numbers of planets, face widths, rims, pins and rollers
of each set and prints the longest basic life L_10h (ISO 281) that rollers reach anywhere, and how thick films are under
limits of pressure and temperature. No size is left out for being impractical; what it takes is shown beside it.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.catalogue import check_bearing
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.bearings import planet_duty
from gearwright.sizing.planets import Task, design_oil, film_margin, integral, judged, on_film, on_rollers, tasks
from gearwright.sizing.rating import context_of
from gearwright.spec import Design, edited, read
from gearwright.units import CELSIUS, RPM

DESIGNS = ("in-line-h2", "in-line", "mixed", "mixed-h2")
PLANETS = (3, 4, 5, 6)
WIDTHS = (1.0, 1.5, 2.0, 3.0, 4.0)
"""Of the width that sizing takes by itself [-]."""
MODULES = (0.6, 0.7, 0.8, 0.9, 1.0, 1.2)
"""Of the module that sizing takes by itself [-]; what its teeth do not bear is left out."""
RIMS = (3.95, 2.6)
"""Wall from the pitch circle to the bore over the module: a backup ratio of 1.2, and half of that [-]."""
ROLES = ("sun", "planet", "ring")
PINS = np.linspace(0.25, 0.97, 25)
"""Over the room [-]."""
ROLLERS = (0.04, 0.06, 0.08, 0.1, 0.14, 0.2, 0.28, 0.4)
"""Over the pin [-]."""
CLEARANCES = (1e-3, 1.5e-3, 2e-3, 3e-3)


class Best(NamedTuple):
    """The best of a grid."""

    value: float
    words: str


def variants(design: Design, stage: str) -> Iterator[tuple[str, float, Design]]:
    """Yield numbers of planets, modules and widths of a set for each wall of its rims."""
    for planets in PLANETS:
        own = {f"planetaries.{stage}.planets": planets}
        try:
            first = size(edited(design, own))
        except DesignError:
            continue
        planet = next(gear for gear in first.gears if gear.name == f"{stage}.planet")
        teeth = {role: next(gear.teeth for gear in first.gears if gear.name == f"{stage}.{role}") for role in ROLES}
        own |= {f"planetaries.{stage}.{role}_teeth": count for role, count in teeth.items()}
        for finer, more, wall in product(MODULES, WIDTHS, RIMS):
            module, width = 1e3 * finer * planet.module, 1e3 * more * planet.face_width
            sizes = {"module_mm": module, "face_width_mm": width, "gears.rim_thickness_ratio": wall}
            keys = own | {f"planetaries.{stage}.{key}": value for key, value in sizes.items()}
            yield f"{planets} planets, m {module:.3g}, b {width:.3g} mm", wall, edited(design, keys)


def task_of(design: Design, stage: str, kind: str) -> Task | None:
    """Return the planet of a set whose bearing is asked for, with its gears as sized; None where teeth do not bear."""
    sizing = size(design)
    if any(
        check.fails and check.mode in ("bending", "contact") and check.part.name == stage for check in sizing.checks
    ):
        return None
    asked = edited(sizing.design, {f"planetaries.{stage}.planet_bearing.kind": kind})
    context = context_of(asked, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    return next(iter(tasks(context, sizing.gears)))


def longest_life(task: Task, kind: str) -> tuple[Best, int]:
    """Return the longest life of rollers of a kind that have room, and how many sizes there were."""
    best, count = Best(0.0, ""), 0
    for pin, ratio in product(PINS * task.room, ROLLERS):
        made = integral(kind, pin, ratio * pin, width=task.width)
        if made is None or made.outer_diameter > task.room:
            continue
        load, count = task.load(on_rollers(kind, made, 1)), count + 1
        life = check_bearing(made, planet_duty(task.context, task.seat, made, load)).life / 3600.0
        if life > best.value:
            fast = max(load.speeds) / RPM * 1e3 * made.geometry.pitch_diameter
            words = f"pin {1e3 * pin:.3g}, rollers {made.geometry.elements} x {1e3 * ratio * pin:.3g} mm"
            forces = f"C {made.dynamic_rating / 1e3:.3g} kN, P {max(load.radial) / 1e3:.3g} kN"
            best = Best(life, f"{words}, {forces}, n d_m {fast / 1e6:.2g}e6")
    return best, count


def films(task: Task) -> dict[str, Best]:
    """Return the thickest laminar film below 7 MPa and 125 °C, and the one of least loss that is thick enough."""
    thick, thrifty = Best(0.0, ""), Best(-np.inf, "")
    oil, count = design_oil(task.context.design, task.asked), task.context.design.planetaries[task.planet.stage].planets
    for pin, clearance in product(PINS * task.room, CLEARANCES):
        asked = task.asked.model_copy(update={"clearance": clearance})
        film = on_film(asked, pin, task.width)
        found = list(judged(film.journal, task.load(film), asked, oil))
        margins = [film_margin(one._replace(least_film=one.state.film), film.journal, asked, oil) for one in found]
        if min(margins) < 1.0 or film.outer_diameter > task.room:
            continue
        thin = min(found, key=lambda one: one.state.film / one.least_film)
        state = max((one.state for one in found), key=lambda state: state.power)
        size_ = f"pin {1e3 * pin:.3g} mm, ψ {1e3 * clearance:g}e-3, p {1e-6 * state.pressure:.3g} MPa"
        words = f"{size_}, u {state.sliding_speed:.3g} m/s, {1e-3 * count * state.power:.3g} kW of {count}"
        words += (
            f", h {1e6 * thin.state.film:.3g} of {1e6 * thin.least_film:.3g} µm, exit {state.exit - CELSIUS:.0f} °C"
        )
        if thin.state.film > thick.value:
            thick = Best(thin.state.film, words)
        if thin.state.film >= thin.least_film and -count * state.power > thrifty.value:
            thrifty = Best(-count * state.power, words)
    return {"thickest film": thick, "least loss": thrifty}


def main(names: tuple[str, ...]) -> None:
    """Print what each set of some designs reaches."""
    for name in names or DESIGNS:
        design = read(shipped_design(name))
        for stage in design.planetaries:
            report(design, name, stage)


def report(design: Design, name: str, stage: str) -> None:
    """Print what rollers and films of a set reach."""
    best: dict[str, tuple[Best, str]] = {}
    count, sets, swing = 0, 0, 0.0
    for words, wall, variant in variants(design, stage):
        try:
            task = task_of(variant, stage, "needle")
        except DesignError:
            continue
        if task is None:
            continue
        sets += 1
        swing = abs(next(iter(task.context.flows.values())).speeds[task.seat.carrier]) / RPM
        for kind in ("needle", "ceramic"):
            longest, tried = longest_life(task, kind)
            count += tried
            keep(best, f"{kind}, wall {wall:g} m", longest, words)
        plain = replace(task, asked=task.asked.model_copy(update={"kind": "plain"}))
        for which, film in films(plain).items():
            keep(best, f"plain, {which}, wall {wall:g} m", film, words)
    print(f"{name} {stage}: carrier {swing:.0f} rpm, {sets} sets, {count} sizes of rollers")
    for which, (found, words) in sorted(best.items()):
        print(f"  {which}: {found.value:.4g}; {words}; {found.words}", flush=True)


def keep(best: dict[str, tuple[Best, str]], which: str, found: Best, words: str) -> None:
    """Keep the best of a row."""
    if found.words and (which not in best or found.value > best[which][0].value):
        best[which] = (found, words)


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
