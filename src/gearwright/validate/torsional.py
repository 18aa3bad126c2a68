"""Published torsional systems."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.dynamics import Model, modes
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


CASES = (
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
