"""Mesh phases of compound sets: those of a simple set of the same teeth, and those that teeth on pins demand."""

import math

import pytest

from gearwright.dynamics.assembly.meshes import compound_phases, gear_pairs
from gearwright.parts.planetary import planet_phases
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read


def apart(one, other):
    """Return the difference of two phases, less whole cycles."""
    return abs((one - other + 0.5) % 1.0 - 0.5)


@pytest.mark.parametrize(
    "name, stage, rows",
    [
        ("geared-turbofan-star", "star", ("star.sun-star", "star.star-ring")),
        ("contra-rotating-propellers", "differential", ("differential.sun-planet", "differential.planet-ring")),
    ],
)
def test_a_compound_set_of_one_planet_has_the_phases_of_parker_and_lin(name, stage, rows):
    """Within its carrier the sun drives; planets are counted in its sense. 1e-9 cycles: rounding."""
    sizing = size(read(shipped_design(name)))
    flow, epicyclic = sizing.reference, sizing.design.epicyclics[stage]
    found, pairs = compound_phases(sizing, flow, stage), gear_pairs(sizing)
    places = [2.0 * math.pi * number / epicyclic.sets for number in range(epicyclic.sets)]
    wanted = planet_phases(*(pairs[row] for row in rows), places)
    sun = next(iter(epicyclic.suns.values()))
    sense = 1.0 if flow.speeds[sun.shaft] >= flow.speeds[epicyclic.carrier] else -1.0
    for row, phases in zip(rows, (wanted.sun, wanted.ring), strict=True):
        order = [round(sense * number) % epicyclic.sets for number in range(epicyclic.sets)]
        for number, place in enumerate(order):
            assert apart(found[row][number], phases[place]) < 1e-9


def test_meshes_of_a_ravigneaux_set_step_by_the_teeth_that_pass_from_set_to_set():
    """From set to set every central gear has z/3 teeth: whole ones of 45, 54 and 108, so that all sets are alike."""
    sizing = size(read(shipped_design("ravigneaux-automatic")))
    for flow in sizing.flows.values():
        for phases in compound_phases(sizing, flow, "gear").values():
            assert all(apart(phase, phases[0]) < 1e-9 for phase in phases)
