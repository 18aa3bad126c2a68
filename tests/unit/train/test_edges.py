"""Speed ratios of stages by the member that stands still, and powers of what sits on a shaft."""

import pytest

from gearwright.identity import Kind, Role
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read
from gearwright.train import branches
from gearwright.train.kinematics import Edge


@pytest.mark.parametrize(("grounded", "ratio"), [(Role.RING, 4.6), (Role.SUN, 1.0 + 1.0 / 3.6), (None, 3.6)])
def test_willis_gives_the_speed_ratio_of_teeth_and_back(grounded, ratio):
    edge = Edge("first", ("a",), ("b",), grounded)
    assert edge.ratio(3.6) == pytest.approx(ratio)
    assert edge.tooth_ratio(ratio) == pytest.approx(3.6)


def test_a_star_turns_by_its_teeth_alone():
    edge = Edge("first", ("a",), ("b",), Kind.CARRIER)
    assert (edge.ratio(3.6), edge.tooth_ratio(3.6)) == (3.6, 3.6)


@pytest.mark.parametrize("name", ["in-line-h2", "off-set-h2", "twin-engine-sprag"])
def test_powers_and_torques_on_every_shaft_add_up_to_nothing(name):
    sizing = size(read(shipped_design(name)))
    for flow in sizing.flows.values():
        parts = branches(sizing.train, flow)
        largest = max(abs(part.power) for part in parts)
        for shaft in sizing.design.shafts:
            own = [part for part in parts if part.shaft == shaft]
            assert sum(part.power for part in own) == pytest.approx(0.0, abs=1e-9 * largest)
            assert all(part.power == part.torque * flow.speeds[shaft] for part in own)
        machines = {part.part.name: part.power for part in parts if part.part.kind is Kind.MACHINE}
        assert machines == pytest.approx(dict(flow.machine_powers), abs=1e-9 * largest)
