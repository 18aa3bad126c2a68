"""Published torsional systems come out."""

import pytest

from gearwright.dynamics import Model, modes


def test_two_inertias_on_one_shaft():
    """openTorsion (Aalto University), test_shaft: 211.4 and 8.3 kg m², 9.775 MN m/rad → 176.1 Hz, printed to 0.1 Hz."""
    model = Model()
    model.rotation("motor", inertia=211.4)
    model.rotation("wheel", inertia=8.3)
    model.shaft("shaft", "motor", "wheel", stiffness=9.775e6)
    assert modes(model.build()).frequency == pytest.approx([0.0, 176.1], abs=0.05)


def test_five_inertias_in_a_chain():
    """Friswell et al. 2010, Dynamics of Rotating Machines, example 9.7.1, printed to 0.01 Hz."""
    model = Model()
    for number, inertia in enumerate((0.0035, 0.0035, 0.0035, 0.15, 0.05)):
        model.rotation(f"disc {number}", inertia=inertia)
    for number, stiffness in enumerate((12e3, 12e3, 14e3, 10e3)):
        model.shaft(f"shaft {number}", f"disc {number}", f"disc {number + 1}", stiffness=stiffness)
    assert modes(model.build()).frequency == pytest.approx([0.0, 81.21, 141.21, 378.95, 536.36], abs=0.006)


def test_a_motor_that_drives_two_rotors_through_a_gear_pair():
    """Friswell et al. 2010, geared branch as in openTorsion's test_friswell_pagex, printed to 0.1 Hz.

    Their gears are rigid; a mesh of 1e12 N/m on 0.1 m adds one mode far above and moves the others by under 1e-4 Hz.
    """
    model = Model()
    for name, inertia in {"motor": 4e-4, "A": 7e-4, "B": 7e-4, "gear 1": 2.5e-5, "gear 2": 2.5e-5}.items():
        model.rotation(name, inertia=inertia)
    model.shaft("motor shaft", "motor", "gear 1", stiffness=1e4)
    model.shaft("shaft A", "gear 1", "A", stiffness=5e3)
    model.shaft("shaft B", "gear 2", "B", stiffness=5e3)
    model.mesh("gears", {"gear 1": 0.1, "gear 2": 0.1}, stiffness=1e12)
    assert modes(model.build()).frequency[:4] == pytest.approx([0.0, 425.4, 634.1, 3247.2], abs=0.06)
