"""Sized designs and a short run that the tests of this folder share."""

from __future__ import annotations

import pytest
from drawn_designs import MIXED, OFF_SET, STAR, TWIN, sized

from gearwright.dynamics import DampingRatio, Model, Modes, Outputs, System, Trace, modes, simulate
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.spec import read


@pytest.fixture(scope="session")
def in_line_h2() -> Sizing:
    return size(read(shipped_design("in-line-h2")))


@pytest.fixture(scope="session")
def designs(in_line_h2: Sizing) -> dict[str, Sizing]:
    texts = {"off-set": OFF_SET, "mixed": MIXED, "twin": TWIN, "star": STAR}
    return {"in-line-h2": in_line_h2, **{name: sized(text) for name, text in texts.items()}}


@pytest.fixture(scope="session")
def system() -> System:
    """A turbine that drives a propeller over one mesh; its mesh force is torque over base radius."""
    model = Model()
    turbine = model.rotation("turbine", inertia=0.17, speed=2000.0)
    pinion = model.rotation("pinion", inertia=0.002)
    propeller = model.rotation("propeller", inertia=90.0)
    model.shaft("input", turbine, pinion, stiffness=24e3, damping=DampingRatio(0.05))
    model.mesh("first.mesh", {pinion: 0.05, propeller: -0.5}, stiffness=3e8, damping=DampingRatio(0.05))
    model.load(turbine, constant=500.0)
    model.load(propeller, constant=-5000.0)
    return model.build()


@pytest.fixture(scope="session")
def modal(system: System) -> Modes:
    return modes(system)


@pytest.fixture(scope="session")
def run(system: System) -> Trace:
    return simulate(system, 0.05, outputs=Outputs(samples=50, start=0.01, windows=((0.03, 0.04),)))
