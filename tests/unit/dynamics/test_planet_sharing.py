"""Load sharing against the number of planets, and the contacts of planets in their carrier's frame."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gearwright.dynamics import Model
from gearwright.dynamics.assembly import contacts_of
from gearwright.dynamics.model import (
    Member,
    PlanetarySet,
    PlanetError,
    add_planetary,
    contact_errors,
    crossing_axis,
    face_push_direction,
    push_direction,
    shift_weights,
)
from gearwright.dynamics.sharing import PlanetTolerances, planet_sharing
from gearwright.parts.planetary import even_positions, pin_error_share
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read
from gearwright.spec.design import PartErrors

ANGLE = math.radians(24.6)


def planetary(sun_support, *, count=3, errors=None):
    return PlanetarySet(
        sun=Member(0.4, 1e-3, 0.035, support=sun_support),
        ring=Member(2.0, 0.1, 0.125, torsion=math.inf),
        carrier=Member(5.0, 0.05, 0.08 / math.cos(ANGLE)),
        planet=Member(0.66, 1e-3, 0.045),
        sun_mesh=StiffnessCurve(5e8),
        ring_mesh=StiffnessCurve(5e8),
        pressure_angles=(ANGLE, ANGLE),
        positions=even_positions(count),
        errors=errors or {},
    )


def test_three_planets_on_a_floating_sun_need_no_tolerance():
    """Statically determinate: K_γ = 1 whatever the errors."""
    found = planet_sharing(planetary(0.0), PlanetTolerances(1e-5, 1e-5, 1e-5), force=4e4, planets=(3,), count=200)
    assert found.load_factor == pytest.approx(np.ones((1, 200)), abs=1e-9)


@pytest.mark.parametrize("support", [0.0, math.inf])
def test_load_factor_grows_with_planets_and_falls_with_floating(support):
    found = planet_sharing(planetary(support), PlanetTolerances(tangential=1e-5), force=4e4, count=1000)
    medians = list(found.percentile(50).values())
    assert medians == sorted(medians)
    rigid = planet_sharing(planetary(math.inf), PlanetTolerances(tangential=1e-5), force=4e4, count=1000)
    assert all(one <= other + 1e-12 for one, other in zip(medians, rigid.percentile(50).values(), strict=True))


@pytest.mark.parametrize("support", [0.0, math.inf])
@pytest.mark.parametrize("count", [4, 5, 6])
def test_small_errors_stay_within_the_closed_form(count, support):
    """Uniform errors of all pins: together at most N times what one pin does alone, and the worst of 4000 sets is
    worse than one pin alone.
    """
    error = 1e-6
    found = planet_sharing(
        planetary(support), PlanetTolerances(tangential=error), force=4e4, planets=(count,), count=4000
    )
    alone = (
        count * pin_error_share(count, error, 4e4, stiffness=(5e8, 5e8), pressure_angle=ANGLE, floating=support == 0.0)
        - 1.0
    )
    assert np.max(found.load_factor) - 1.0 <= alone * count
    assert np.max(found.load_factor) - 1.0 >= alone


def test_same_seed_gives_the_same_sets():
    one, other, third = (
        planet_sharing(planetary(0.0), PlanetTolerances(tangential=1e-5), force=4e4, planets=(4,), count=50, seed=seed)
        for seed in (3, 3, 4)
    )
    assert np.array_equal(one.load_factor, other.load_factor)
    assert not np.array_equal(one.load_factor, third.load_factor)


@pytest.mark.parametrize("name", ["single-planetary", "star"])
def test_contacts_of_a_design_stand_as_in_the_textbook_set(name):
    """Directions and pin errors against the lines of Lin & Parker's set, on the loaded flanks; rounding."""
    sizing = size(read(shipped_design(name)))
    stage, given = next(iter(sizing.design.planetaries.items()))
    angle = sizing.design.rules(stage).pressure_angle
    flow = sizing.flows["rated"]
    mesh = next(each for each in sizing.train.meshes if each.name == f"{stage}.sun-planet")
    flank = -1 if flow.meshes[mesh.name].torques[0] > 0.0 else 1
    member = Member(1.0, 1.0, 1.0, support=1.0)
    curve, places = StiffnessCurve(1.0), even_positions(given.planets)
    error = {1: PlanetError(radial=3e-6, tangential=5e-6)}
    model = Model()
    textbook = PlanetarySet(member, member, member, member, curve, curve, (angle, angle), places, flank=flank)
    rigid_pins = PlanetarySet(
        member, member, Member(1.0, 1.0, 1.0), Member(1.0, 1.0, 1.0), curve, curve, (angle, angle), places, flank=flank,
        errors=error,
    )  # fmt: skip
    add_planetary(model, textbook)
    with_errors = Model()
    add_planetary(with_errors, rigid_pins)
    lines = {line.name: line for line in model.lines}
    constants = {line.name: sum(each.constant for each in line.errors) for line in with_errors.lines}
    parts = {f"{stage}.planet-1": PartErrors(pin_radial=3e-6, pin_tangential=5e-6)}
    for contact in contacts_of(sizing, flow):
        if not contact.line.startswith(f"{stage}."):
            continue
        own = contact.line.removeprefix(f"{stage}.")
        central = "sun" if "sun-planet" in contact.line else "ring"
        side = contact.sides[0 if central == "sun" else 1]
        sign = 1.0 if central == "sun" else -1.0
        want = [lines[own].weights[f"{central}.{axis}"] for axis in "xy"]
        assert [sign * contact.direction[axis] for axis in (1, 2)] == pytest.approx(want, abs=1e-12)
        assert side.shaft == getattr(given, central)
        found = sum(each.constant for each in contact_errors(contact, parts))
        assert found == pytest.approx(constants[own], abs=1e-18)


def test_push_parts_external_gears_and_turns_with_the_sense():
    """Along the common tangent by cos α, away from the driver by sin α."""
    angle = math.radians(20.0)
    assert push_direction(1.0 + 0j, angle, sense=1) == pytest.approx((0.0, math.sin(angle), math.cos(angle)))
    assert push_direction(2.0 + 0j, angle, sense=-1) == pytest.approx((0.0, math.sin(angle), -math.cos(angle)))


def test_pinion_pushes_opposite_face_gears_opposite_ways():
    """A pinion between two face gears feels no force across itself from equal loads."""
    one, other = (face_push_direction(place, math.radians(20.0), sense=1) for place in (0.1j, -0.1j))
    assert np.add(one, other) == pytest.approx(np.zeros(3), abs=1e-15)
    assert np.linalg.norm(one) == pytest.approx(1.0)


@pytest.mark.parametrize(("place", "axis"), [(1j, "z"), (-2.0, "y"), (1.0 + 1.0j, None)])
def test_pinion_of_a_face_gear_lies_along_an_axis(place, axis):
    assert crossing_axis(complex(place)) == axis


def test_shaft_that_moves_as_a_whole_does_not_stretch_its_own_planets():
    """Sun, ring and carrier shifted together stretch no mesh of the set."""
    sizing = size(read(shipped_design("single-planetary")))
    for contact in contacts_of(sizing, sizing.flows["rated"]):
        weights = shift_weights(contact)
        for axis in "yz":
            assert sum(value for name, value in weights.items() if name.endswith(axis)) == pytest.approx(0.0, abs=1e-12)
