"""A governed propeller, two machines and a clutch on an elastic train, for tests."""

import math

import numpy as np

from gearwright.catalogue import propeller_map
from gearwright.dynamics import DampingRatio, Model, Periodic, System
from gearwright.dynamics.model import ClutchDrive, MachineDrive, PropellerDrive
from gearwright.machines import Governor, GovernorState

PITCH, SPEED, RATIO = math.radians(42.3), 126.9, 4.0


def governor(gain_deg: float = 1.0, lowest_deg: float = 39.0) -> Governor:
    """Return a governor of second order with integral action."""
    gain = math.radians(gain_deg)
    return Governor(PITCH, gain, 0.2 * gain, 0.1, 0.7, math.radians(lowest_deg), math.radians(55.0), math.radians(10.0))


def propeller(body: str = "propeller", gain_deg: float = 1.0, **changes) -> PropellerDrive:
    """Return a six-blade propeller in cruise."""
    start = GovernorState(PITCH, 0.0, 0.0)
    drive = PropellerDrive(
        "propeller", body, propeller_map("6-blades-af115"), 3.93, governor(gain_deg), start, 0.549, 161.0, SPEED
    )
    return drive._replace(**changes)


def driven_train(*, one_way: bool = False, command: float = 2900.0) -> System:
    """Return turbine and starter, a pair of gears with varying stiffness, and the propeller."""
    model = Model(profile=((0.0, 1.0), (0.1, 1.0), (0.3, 0.99)))
    model.rotation("turbine", inertia=0.5, speed=RATIO * SPEED)
    model.rotation("gear", inertia=0.3)
    model.rotation("wheel", inertia=5.0)
    model.rotation("propeller", inertia=100.0)
    model.rotation("second", inertia=0.4, speed=480.0)
    model.shaft("input", "turbine", "gear", stiffness=1e5, damping=DampingRatio(0.03))
    model.mesh(
        "mesh", {"gear": 0.05, "wheel": -0.05 * RATIO}, stiffness=1e8, damping=DampingRatio(0.05),
        variation=Periodic({"gear": 20}, (0.2, 0.1), (0.1,)),
    )  # fmt: skip
    model.shaft("output", "wheel", "propeller", stiffness=1e6, damping=DampingRatio(0.03))
    model.drive(propeller(airspeed=((0.0, 161.0), (0.2, 161.0), (0.3, 161.5))))
    cut = ((0.0, command), (0.05, command), (0.06, 0.9 * command))
    model.drive(MachineDrive("turbine", "turbine", cut, RATIO * SPEED, 0.8, 4000.0, 2e6))
    model.drive(MachineDrive("starter", "second", 50.0, RATIO * SPEED, 1.0))
    model.drive(ClutchDrive("clutch", "second", "gear", 5e4, 20.0, 400.0, one_way))
    return model.build()


def driven_state(system: System, seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return position, velocity and states of the drives near the cruise."""
    rng = np.random.default_rng(seed)
    size = len(system.arrays.mass)
    states = system.arrays.drives.start + rng.normal(0.0, 1e-2, len(system.arrays.drives.start))
    return rng.normal(0.0, 1e-3, size), rng.normal(0.0, 1.0, size), states
