"""Recirculating power is found, measured and named; ordinary trains have none."""

from __future__ import annotations

import pytest

from gearwright.shipped import shipped_design, shipped_designs
from gearwright.spec import parse, read
from gearwright.train import build_train, power_flow, recirculation

LOOP = """
schema = 1
name = "Planetary set whose ring is driven from its own carrier"
level = "concept"
shafts = ["in", "out", "idler", "ring"]
[turbines.turbine]
shaft = "in"
power_kw = 100
speed_rpm = 6000
[propellers.propeller]
shaft = "out"
speed_rpm = 1000
diameter_m = 2
[planetaries.set]
sun = "in"
ring = "ring"
carrier = "out"
planets = 3
[pairs.up]
pinion = "out"
wheel = "idler"
[pairs.down]
pinion = "idler"
wheel = "ring"
"""
TEETH = {"set.sun": 24, "set.planet": 24, "set.ring": 72, "up.pinion": 30, "up.wheel": 30, "down.pinion": 30}


def test_a_ring_driven_from_the_carrier_circulates_power() -> None:
    """Willis, ω_ring = ω_out/2 and T_ring = 3 T_sun: ω_in = (4 − 3/2) ω_out, so the ring takes 1.5/2.5 of the power."""
    design = parse(LOOP)
    train = build_train(design)
    flow = power_flow(design, train, TEETH | {"down.wheel": 60})
    (loop,) = recirculation(train, flow)
    assert loop.power == pytest.approx(100e3 * 1.5 / 2.5, rel=1e-12)
    start = loop.path.index("stage set")
    around = (*loop.path[start:], *loop.path[:start])
    assert around == ("stage set", "out", "stage up", "idler", "stage down", "ring")


@pytest.mark.parametrize("name", shipped_designs())
def test_shipped_designs_circulate_no_power(name: str) -> None:
    from gearwright.sizing import size

    sizing = size(read(shipped_design(name)))
    assert all(recirculation(sizing.train, flow) == () for flow in sizing.flows.values())
