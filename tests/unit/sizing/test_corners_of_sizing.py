"""Corners that no shipped design reaches: loads in one sense only, curves by treatment, clutches that nothing opens."""

import math

import pytest

from gearwright.dynamics.model import Disc
from gearwright.parts.iso6336 import Treatment, bending_life_curve
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating.context import bends_both_ways
from gearwright.spec import read
from gearwright.train.graph import Joint


@pytest.mark.parametrize(
    ("torques", "both"), [([3.0], False), ([3.0, 0.0], False), ([3.0, -1e-12], False), ([3.0, -0.1], True)]
)
def test_teeth_bend_both_ways_where_two_cases_load_both_flanks(torques, both):
    """A case without load, and what rounding leaves of it, load no flank."""
    sizing = size(read(shipped_design("off-set")))
    mesh = next(iter(sizing.train.meshes))
    loads = {row.name: [0.0] for row in sizing.train.meshes} | {mesh.name: torques}
    for gear in mesh.gears:
        if all(gear not in row.gears for row in sizing.train.meshes if row is not mesh):
            assert bends_both_ways(sizing.train, gear, loads) is both


@pytest.mark.parametrize("treatment", Treatment)
def test_roots_bear_their_static_load_up_to_the_printed_cycles(treatment):
    """ISO 6336-3, table 1: 10⁴ cycles of steels as they are and of irons with pearlite, 10³ of hardened steels and
    other irons; the knee is at 3·10⁶."""
    pearlitic = (Treatment.MALLEABLE_IRON, Treatment.NODULAR_IRON)
    soft = treatment in (Treatment.STRUCTURAL, Treatment.THROUGH_HARDENED, *pearlitic)
    curve = bending_life_curve(treatment)
    assert list(curve.cycles) == [1e4 if soft else 1e3, 3e6, 1e10]
    nitrided = (Treatment.NITRIDED, Treatment.NITRIDED_THROUGH_HARDENED, Treatment.FERRITIC_NODULAR_IRON)
    weaker = dict.fromkeys((*nitrided, Treatment.GREY_IRON), 1.6) | {Treatment.NITROCARBURISED: 1.1}
    assert curve.factors[0] == weaker.get(treatment, 2.5)


def test_a_round_disc_of_steel_has_its_mass_and_inertias():
    """Of a cylinder about its axis m r²/2, across it m (3 r² + h²)/12."""
    disc = Disc.of_steel(0.02, 0.3)
    mass = 7850.0 * math.pi * 0.15**2 * 0.02
    assert disc.mass == pytest.approx(mass)
    assert disc.polar == pytest.approx(mass * 0.15**2 / 2.0)
    assert disc.diametral == pytest.approx(mass * (3.0 * 0.15**2 + 0.02**2) / 12.0)


def test_a_clutch_holds_in_every_case_unless_it_is_said_to_be_open():
    assert Joint("c", "a", "b", overrunning=False).is_open is False
