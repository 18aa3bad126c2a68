"""Twelve architectures at 60 requirements, 100 kW to 30 MW and 3:1 to 40:1: ``python benchmarks/requirements.py``.

Each gets tooth numbers, numbers of planets and speeds of its motors for every requirement, as `compare` does it. Every
answer is checked first: speeds within their tolerance, power that adds up, planets that can be put in and pass each
other, no rating below what was asked. Then its mass stands in a table, or a mark for the reason, which is told below.
Processor time of one architecture at one requirement comes last. ``--csv FILE`` writes everything.
"""

from __future__ import annotations

import argparse
import csv
import math
import statistics
import time
from pathlib import Path

import gearwright as gw
from gearwright.errors import DesignError, GearwrightError
from gearwright.sizing import Sizing, size
from gearwright.spec import Design, read_study
from gearwright.study import for_requirement
from gearwright.units import RPM

POWERS = {100: 2500, 300: 2000, 1000: 1500, 3000: 1100, 10000: 800, 30000: 600}
"""Power of all machines [kW] -> speed of the propeller [rpm], from a light aircraft's to a ship's."""
RATIOS = (3.0, 4.0, 5.0, 7.0, 10.0, 16.5, 22.0, 26.0, 32.0, 40.0)
POINTS = [(power, ratio) for power in POWERS for ratio in RATIOS]
ARCHITECTURES = (*read_study(gw.shipped_study("architectures")).designs, "single-planetary", "star")
RESIDUAL = 1e-12
"""Of the power of a mesh against its machines [-]."""


def wrong(sizing: Sizing, design: Design) -> list[str]:
    """Return what an answer does not keep of what was asked."""
    faults, tolerance = [], design.teeth.speed_tolerance
    for case, flow in sizing.flows.items():
        faults += [
            f"{case}: {one.machine} {one.deviation:+.1%}" for one in flow.yielded if abs(one.deviation) > tolerance
        ]
        if flow.residual > RESIDUAL:
            faults.append(f"{case}: power residual {flow.residual:.1e}")
    rated = next(iter(sizing.flows.values()))
    turbine, propeller = (next(iter(some.values())) for some in (design.turbines, design.propellers))
    asked = turbine.speed / propeller.speed
    ratio = abs(rated.speeds[turbine.shaft] / rated.speeds[propeller.shaft])
    if abs(ratio / asked - 1.0) > tolerance:
        faults.append(f"ratio {ratio:.4g} for {asked:.4g}")
    for name, stage in sizing.design.planetaries.items():
        sun, planet, ring = (sizing.teeth[f"{name}.{member}"] for member in ("sun", "planet", "ring"))
        if ring != sun + 2 * planet or (sun + ring) % stage.planets:
            faults.append(f"{name}: {stage.planets} planets of {sun}, {planet}, {ring} teeth cannot be assembled")
        if (sun + planet) * math.sin(math.pi / stage.planets) <= planet + 2:
            faults.append(f"{name}: {stage.planets} planets of {sun}, {planet} teeth touch")
    for mesh in sizing.meshes:
        if min(mesh.bending_margin, mesh.contact_margin) < 1.0 - 1e-9:
            faults.append(f"{mesh.name}: rating margin {min(mesh.bending_margin, mesh.contact_margin):.4f}")
    return faults


def answer(name: str, power: float, ratio: float) -> tuple[float, str, float]:
    """Return the mass [kg], or why there is none, and the processor time [s]."""
    began, speed = time.process_time(), POWERS[power] * RPM
    try:
        design = for_requirement(
            gw.read(gw.shipped_design(name)), power=power * 1e3, engine_speed=ratio * speed, propeller_speed=speed
        )
        sizing = size(design)
    except GearwrightError as error:
        return math.nan, _reason(error), time.process_time() - began
    spent = time.process_time() - began
    faults = wrong(sizing, design)
    assert not faults, (name, power, ratio, faults)
    return sizing.mass, "", spent


def _reason(error: GearwrightError) -> str:
    problems = error.problems if isinstance(error, DesignError) else ()
    return "; ".join(str(problem) for problem in problems) or str(error)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--csv", type=Path, help="write every answer with its whole reason")
    file = parser.parse_args().csv
    answers = {(name, *point): answer(name, *point) for point in POINTS for name in ARCHITECTURES}
    print(f"| power [kW] | ratio | {' | '.join(ARCHITECTURES)} |\n|{' --- |' * (len(ARCHITECTURES) + 2)}")
    for power, ratio in POINTS:
        cells = (answers[name, power, ratio] for name in ARCHITECTURES)
        shown = (f"[{_marks(answers)[why]}]" if why else f"{mass:.4g}" for mass, why, _ in cells)
        print(f"| {power} | {ratio:g} | {' | '.join(shown)} |")
    print()
    for why, mark in _marks(answers).items():
        print(f"[{mark}] {why}\n")
    good = [spent for _, why, spent in answers.values() if not why]
    print(
        f"{len(good)} of {len(answers)} have an answer; median {statistics.median(good):.3f} s, most {max(good):.2f} s"
    )
    if file is not None:
        with file.open("w", newline="", encoding="utf-8") as stream:
            writer = csv.writer(stream)
            writer.writerow(["architecture", "power_kw", "ratio", "mass_kg", "reason", "time_s"])
            writer.writerows([*at, mass, why, spent] for at, (mass, why, spent) in answers.items())


def _marks(answers: dict[tuple[str, float, float], tuple[float, str, float]]) -> dict[str, int]:
    """Return reason -> number, in the order in which they appear."""
    reasons = dict.fromkeys(why for _, why, _ in answers.values() if why)
    return {why: number for number, why in enumerate(reasons, start=1)}


if __name__ == "__main__":
    main()
