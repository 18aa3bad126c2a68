"""Starts at which no tooth touches are named."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearwright.dynamics import Model, simulate
from gearwright.dynamics.equations import slow_position
from gearwright.dynamics.motion import slack_lines
from gearwright.dynamics.sharing import load_sharing, sharing_problem
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read


def two_gears():
    """One mesh with a backlash of 100 µm between two gears."""
    model = Model()
    for name, torque in (("one", 100.0), ("two", -100.0)):
        model.rotation(name, inertia=1e-2)
        model.load(name, constant=torque)
    model.mesh("mesh", {"one": 0.05, "two": -0.05}, stiffness=1e8, backlash=1e-4)
    return model.build()


@pytest.mark.parametrize(("turned", "slack"), [(-1e-3, ("mesh",)), (1e-4, ()), (-3e-3, ())])
def test_a_line_is_slack_only_between_its_flanks(turned, slack):
    """δ = r q = −50 µm lies in the gap, +5 µm on the front flank and −150 µm on the back flank."""
    assert slack_lines(two_gears(), np.array([turned, 0.0])) == slack


def test_a_simulation_from_the_gap_names_the_lines():
    start = (np.array([-1e-3, 0.0]), np.zeros(2))
    notes = simulate(two_gears(), 1e-3, start=start).notes
    assert "at the start no tooth touches: mesh stand between their flanks" in notes


def test_the_slow_start_of_loaded_teeth_touches():
    system = two_gears()
    assert slack_lines(system, slow_position(system)) == ()


@pytest.mark.parametrize("method", ["auto", "quasi-static", "dynamics"])
def test_sharing_of_no_load_is_refused_with_the_lines(method):
    problem = sharing_problem(size(read(shipped_design("face-gear-split-torque"))))
    arrays = problem.system.arrays
    idle = arrays.loads._replace(constant=np.zeros_like(arrays.loads.constant))
    system = replace(problem.system, arrays=arrays._replace(loads=idle))
    with pytest.raises(DesignError, match=r"second.left, second.right carry nothing at the start"):
        load_sharing(system, problem.lines, method=method)
