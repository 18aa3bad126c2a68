"""Published torsional systems."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from gearwright.dynamics import Model, modes
from gearwright.dynamics.model import Disc, Line, Rotor, Segment, add_rotor
from gearwright.validate.case import Case


def two_inertias() -> Sequence[float]:
    """Return the natural frequencies of two inertias on one shaft [Hz]."""
    model = Model()
    model.rotation("motor", inertia=211.4)
    model.rotation("wheel", inertia=8.3)
    model.shaft("shaft", "motor", "wheel", stiffness=9.775e6)
    return [float(value) for value in modes(model.build()).frequency]


def five_inertias() -> Sequence[float]:
    """Return the natural frequencies of five inertias in a chain [Hz]."""
    model = Model()
    for number, inertia in enumerate((0.0035, 0.0035, 0.0035, 0.15, 0.05)):
        model.rotation(f"disc {number}", inertia=inertia)
    for number, stiffness in enumerate((12e3, 12e3, 14e3, 10e3)):
        model.shaft(f"shaft {number}", f"disc {number}", f"disc {number + 1}", stiffness=stiffness)
    return [float(value) for value in modes(model.build()).frequency]


def geared_branch() -> Sequence[float]:
    """Return the first natural frequencies of a motor that drives two rotors through a gear pair [Hz]."""
    model = Model()
    for name, inertia in {"motor": 4e-4, "A": 7e-4, "B": 7e-4, "gear 1": 2.5e-5, "gear 2": 2.5e-5}.items():
        model.rotation(name, inertia=inertia)
    model.shaft("motor shaft", "motor", "gear 1", stiffness=1e4)
    model.shaft("shaft A", "gear 1", "A", stiffness=5e3)
    model.shaft("shaft B", "gear 2", "B", stiffness=5e3)
    model.mesh("gears", {"gear 1": 0.1, "gear 2": 0.1}, stiffness=1e12)
    return [float(value) for value in modes(model.build()).frequency[:4]]


def four_gears() -> Sequence[float]:
    """Return the natural frequencies of a shaft that drives two others through four gears in a row [Hz]."""
    model = Model()
    for name, inertia in {"driver": 3200.0, "first": 450.0, "second": 450.0, "1": 200.0, "2": 200.0}.items():
        model.rotation(name, inertia=inertia)
    for name in ("3", "4"):
        model.rotation(name, inertia=800.0)
    lengths = {"driver": (2.5, 0.2, "1"), "first": (3.5, 0.25, "3"), "second": (3.5, 0.25, "4")}
    for name, (length, diameter, gear) in lengths.items():
        stiffness = 68e9 * math.pi / 32.0 * diameter**4 / length
        model.shaft(f"shaft of {name}", name, gear, stiffness=stiffness)
    radii = {"1": 0.5, "2": 0.5, "3": 0.8, "4": 0.8}
    for one, other in (("1", "2"), ("1", "3"), ("2", "4")):
        model.mesh(f"{one}-{other}", {one: radii[one], other: radii[other]}, stiffness=1e12)
    return [float(value) for value in modes(model.build()).frequency[:4]]


def drill_string(count: int) -> Sequence[float]:
    """Return the natural frequencies of torsion of a drill string of equal elements [Hz].

    Args:
        count: Number of elements.
    """
    model = Model()
    part = Segment(800.0 / count, 0.78, bore=0.65, elasticity=195e9, poisson=0.3, density=8000.0)
    discs = {0: Disc(1.0, 1.0, 200.0), count: Disc(1.0, 1.0, 10.0)}
    string = add_rotor(model, "string", Rotor([part] * count, discs))
    for place, direction in ((0, "x"), (0, "y"), (count, "x"), (count, "y"), (0, "z")):
        motion = string.at(place)[direction]
        model.add(Line(f"{place} {direction}", motion, 1e12, kind="support"))
    system = model.build()
    solved = modes(system, len(system.labels.coordinates))
    twisting = [name for name in system.labels.coordinates if name in _twisting(count)]
    rows = [system.labels.coordinates.index(name) for name in twisting]
    share = np.sum(system.arrays.mass[rows, None] * solved.shapes[rows] ** 2, axis=0)
    return [float(value) for value in solved.frequency[share > 0.5][1:5]]


def _twisting(count: int) -> set[str]:
    return {"string", *(f"string torsion {number}" for number in range(1, count + 1))}


CASES = (
    Case(
        "four gears in a row on three shafts",
        "Friswell et al. 2010, example 9.6.3 (read in openTorsion's tests)",
        "Hz",
        (0.0, 10.304, 20.479, 24.423),
        four_gears,
        6e-4,
        "printed to 0.001 Hz; rigid gears there, 1e12 N/m here",
        is_relative=False,
    ),
    *(
        Case(
            f"drill string of {count} elements",
            "Friswell et al. 2010, problem 9.9 (read in openTorsion's tests)",
            "Hz",
            printed,
            partial(drill_string, count),
            6e-5,
            "printed to 0.0001 Hz",
            is_relative=False,
        )
        for count, printed in (
            (5, (1.9417, 4.0719, 6.5437, 9.1547)),
            (8, (1.9225, 3.9187, 6.0625, 8.4185)),
            (50, (1.9106, 3.8232, 5.7394, 7.6613)),
        )
    ),
    Case(
        "two inertias on one shaft",
        "openTorsion (Aalto University), test_shaft",
        "Hz",
        (0.0, 176.1),
        two_inertias,
        0.05,
        "printed to 0.1 Hz",
        is_relative=False,
    ),
    Case(
        "five inertias in a chain",
        "Friswell et al. 2010, Dynamics of Rotating Machines, example 9.7.1",
        "Hz",
        (0.0, 81.21, 141.21, 378.95, 536.36),
        five_inertias,
        0.006,
        "printed to 0.01 Hz",
        is_relative=False,
    ),
    Case(
        "motor and two rotors through a gear pair",
        "Friswell et al. 2010, geared branch",
        "Hz",
        (0.0, 425.4, 634.1, 3247.2),
        geared_branch,
        0.06,
        "printed to 0.1 Hz; rigid gears there, 1e12 N/m here, move it by under 1e-4 Hz",
        is_relative=False,
    ),
)
"""Published torsional systems."""
