"""What holds in every train, whatever its stages, machines and directions."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from random_trains import COMPOUND, KINDS, design_of, shuffled, tables

from gearwright.errors import SolveError
from gearwright.spec import GROUND
from gearwright.train import build_train, power_flow

CLOSURE = 1e-12
"""Of the largest power: what rounding leaves after at most five stages."""

IDLE = 1e-9
"""Part of the case's power below which the direction of a mesh is rounding."""
LEAST_EFFICIENCY = 0.95
"""Below those that the random trains draw."""


def shaft_torques(train, flow):
    """Return the sum of all torques on every shaft, and the largest single one."""
    acting = {node: [] for node in train.nodes}
    for name, torque in flow.machine_torques.items():
        acting[train.machines[name]].append(torque)
    for mesh in train.meshes:
        for node, torque in zip(mesh.nodes, flow.meshes[mesh.name].torques, strict=True):
            if node != GROUND:
                acting[node].append(torque)
    return {node: sum(each) for node, each in acting.items()}, max(abs(t) for each in acting.values() for t in each)


def largest_power(flow):
    """Return the largest power of a machine or through teeth [W]."""
    return max(
        *(abs(power) for power in flow.machine_powers.values()), *(abs(m.tooth_power) for m in flow.meshes.values())
    )


@settings(max_examples=150)
@given(drawn=tables(), lossy=st.booleans())
def test_power_closes_and_every_shaft_is_in_balance(drawn, lossy):
    table, teeth, efficiency = drawn
    design = design_of(table)
    train = build_train(design)
    flow = power_flow(design, train, teeth, "case", efficiency=efficiency if lossy else None)
    powers = np.array([*flow.machine_powers.values(), -flow.loss])
    assert abs(powers.sum()) <= CLOSURE * max(np.abs(powers).max(), 1e-300)
    left_over, largest = shaft_torques(train, flow)
    assert max(abs(torque) for torque in left_over.values()) <= CLOSURE * max(largest, 1e-300)
    for mesh in flow.meshes.values():
        assert mesh.loss >= -IDLE * (1.0 - LEAST_EFFICIENCY) * largest_power(flow)
        assert sum(mesh.torques) == pytest.approx(0.0, abs=CLOSURE * max(largest, 1e-300))
    for name, shaft in train.machines.items():
        assert flow.machine_powers[name] == flow.machine_torques[name] * flow.speeds[shaft]


@settings(max_examples=60, deadline=None)
@given(drawn=tables((*KINDS, *COMPOUND), least=0.8))
def test_trains_of_compound_sets_and_poor_meshes_close_or_say_what_locks(drawn):
    """Wolfrom's and stepped sets reach ratios at which 0.8 a mesh locks them: that is said by name, or power closes."""
    table, teeth, efficiency = drawn
    design = design_of(table)
    train = build_train(design)
    try:
        flow = power_flow(design, train, teeth, "case", efficiency=efficiency)
    except SolveError as error:
        assert "is self-locking" in str(error) or "in a circle" in str(error)
        return
    powers = np.array([*flow.machine_powers.values(), -flow.loss])
    assert abs(powers.sum()) <= CLOSURE * max(largest_power(flow), 1e-300)
    for mesh in flow.meshes.values():
        assert mesh.loss >= -IDLE * largest_power(flow)


@settings(max_examples=60)
@given(drawn=tables())
def test_losses_are_what_the_efficiency_says_of_the_driving_side(drawn):
    """Tooth power loses 1 − η of what the driving gear gives, in either direction."""
    table, teeth, efficiency = drawn
    design = design_of(table)
    train = build_train(design)
    flow = power_flow(design, train, teeth, "case", efficiency=efficiency)
    scale = largest_power(flow)
    for mesh in train.meshes:
        found, eta = flow.meshes[mesh.name], efficiency[mesh.stage]
        inward, outward = found.tooth_power, found.tooth_power - found.loss
        driving, driven = (inward, outward) if inward > 0 else (-outward, -inward)
        assert driven == pytest.approx(eta * driving, rel=1e-9, abs=1e-9 * max(scale, 1e-300))


@settings(max_examples=60)
@given(data=st.data())
def test_the_order_of_the_file_does_not_matter(data):
    """1e-9: the same equations in another order, solved by singular values."""
    table, teeth, efficiency = data.draw(tables())
    table["speeds"] = {"keep": [name for name in table["cases"]["case"] if "speed" in table["cases"]["case"][name]]}
    other = shuffled(data.draw, table)
    one, two = (
        power_flow(design, build_train(design), teeth, "case", efficiency=efficiency)
        for design in (design_of(table), design_of(other))
    )
    speed = max(abs(each) for each in one.speeds.values())
    at_teeth = [each for mesh in one.meshes.values() for each in mesh.torques]
    torque = max(abs(each) for each in [*at_teeth, *one.machine_torques.values()])
    for node, value in one.speeds.items():
        assert two.speeds[node] == pytest.approx(value, abs=1e-9 * speed)
    for name, mesh in one.meshes.items():
        assert two.meshes[name].torques == pytest.approx(mesh.torques, abs=1e-9 * max(torque, 1e-300))
    for name, value in one.machine_torques.items():
        assert two.machine_torques[name] == pytest.approx(value, abs=1e-9 * max(torque, 1e-300))
