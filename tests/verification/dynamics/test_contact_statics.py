"""Statics with teeth that part: every load that the teeth can carry is carried, any other refused with its motion."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.dynamics import Model, Periodic, System, simulate, statics
from gearwright.dynamics.equations import errors_at, line_forces, redundancy
from gearwright.dynamics.model import line_matrix
from gearwright.errors import SolveError

RADII = (0.03, 0.06, 0.04, 0.1)
"""Of the driving gear, the first and the second of each path, and the driven gear [m]."""


def parallel_train(paths: int, *, torque: float = 100.0, shafts: int = 3) -> System:
    """Return paths side by side, each of two meshes, some with a shaft that twists between them."""
    model = Model()
    model.rotation("in", inertia=1e-3, speed=0.0)
    model.rotation("out", inertia=1e-2, speed=0.0)
    driving, first, second, driven = RADII
    for path in range(paths):
        gear = pinion = model.rotation(f"gear {path}", inertia=1e-4, speed=0.0)
        if path < shafts:
            pinion = model.rotation(f"pinion {path}", inertia=1e-4, speed=0.0)
            model.shaft(f"shaft {path}", gear, pinion, stiffness=1e5)
        play = {"stiffness": 1e8, "backlash": 1e-4, "errors": [Periodic(constant=1e-6)]}
        model.mesh(f"first {path}", {"in": driving, gear: first}, **play)
        model.mesh(f"second {path}", {pinion: -second, "out": -driven}, **play)
    model.load("in", constant=torque)
    model.load("out", constant=-torque * first / driving * driven / second)
    return model.build()


def random_trains(system: System, rng: np.random.Generator, count: int, *, one_sided: bool):
    """Yield trains of one structure with random stiffness, backlash, errors and load."""
    arrays = system.arrays
    lines, meshes = len(arrays.stiffness), arrays.backlash > 0.0
    for _ in range(count):
        backlash = np.where(meshes, np.inf if one_sided else 10.0 ** rng.uniform(-5.0, -3.0, lines), 0.0)
        terms = rng.normal(size=len(arrays.error.cosine)) * 10.0 ** rng.uniform(-6.0, -4.0, len(arrays.error.cosine))
        load = 10.0 ** rng.uniform(-2.0, 1.0) * (1.0 if one_sided else rng.choice([-1.0, 1.0]))
        yield replace(system, arrays=arrays._replace(
            stiffness=arrays.stiffness * 10.0 ** rng.uniform(-0.7, 0.7, lines), backlash=backlash,
            error=arrays.error._replace(cosine=terms),
            loads=arrays.loads._replace(constant=arrays.loads.constant * load),
        ))  # fmt: skip


@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("paths", [3, 4, 5, 6, 3])
def test_loads_that_balance_are_carried_whatever_backlash_and_errors(paths: int, one_sided: bool) -> None:
    """1500 trains; what the lines leave over on each body is below 1e-9 of what acts on it.

    Every twentieth beside the force method with contact by Gauss–Seidel (`redundancy`), which settles to 1e-10.
    """
    rng = np.random.default_rng(100 * paths + one_sided)
    system = parallel_train(paths, shafts=int(rng.integers(0, paths + 1)))
    for number, train in enumerate(random_trains(system, rng, 150, one_sided=one_sided)):
        force, matrix = statics(train).force, line_matrix(train.arrays)
        left = train.arrays.loads.constant - matrix.T @ force
        assert np.all(np.abs(left) < 1e-9 * np.max(np.abs(matrix.T) @ np.abs(force)))
        assert not one_sided or np.min(force[train.arrays.backlash > 0.0]) >= 0.0
        if number % 20 == 0:
            wanted = line_forces(redundancy(train), errors_at(train, np.zeros(1))[0])
            assert force == pytest.approx(wanted, abs=1e-6 * np.max(np.abs(wanted)))


@pytest.mark.parametrize("deflections", [0.5, 1.8, 50.0, -3.0])
@pytest.mark.parametrize("backlash", [1e-3, 1e3, math.inf])
def test_one_mesh_carries_its_load_whatever_its_error(deflections: float, backlash: float) -> None:
    """δ = F/k whatever e; an error of more than 1.7 static deflections made the old rounds go in circles."""
    system = one_mesh(deflections * 1e-5, backlash=backlash)
    assert statics(system).force == pytest.approx([1000.0], rel=1e-9)
    assert simulate(system, 1e-4).method == "runge-kutta"


def one_mesh(error: float, *, backlash: float, torque: float = 50.0) -> System:
    """Return two gears whose mesh deflects by 10 µm under 1000 N."""
    model = Model()
    for name in ("one", "two"):
        model.rotation(name, inertia=1e-2, speed=0.0)
        model.load(name, constant=torque)
    model.mesh("mesh", {"one": 0.05, "two": 0.05}, stiffness=1e8, backlash=backlash, errors=[Periodic(constant=error)])
    return model.build()


def test_loads_that_open_teeth_which_never_touch_behind_are_refused_with_the_motion() -> None:
    """Pulled apart, both gears run from each other: no force that only presses balances it (Farkas' lemma)."""
    with pytest.raises(SolveError, match=r"push the motion \(one 1, two 1\) away from every line that could hold it"):
        statics(one_mesh(0.0, backlash=math.inf, torque=-50.0))
    assert statics(one_mesh(0.0, backlash=1e-3, torque=-50.0)).force == pytest.approx([-1000.0])


def test_a_gear_that_idles_between_open_flanks_feels_nothing() -> None:
    """Its place is free and its forces are zero, while the loaded mesh carries on."""
    model = Model()
    for name, torque in (("one", 50.0), ("two", 50.0), ("idle", 0.0)):
        model.rotation(name, inertia=1e-2, speed=0.0)
        model.load(name, constant=torque)
    shake = [Periodic(constant=1e-4)]
    model.mesh("loaded", {"one": 0.05, "two": 0.05}, stiffness=1e8, backlash=1e-3)
    model.mesh("open", {"two": -0.05, "idle": 0.05}, stiffness=1e8, backlash=1e-3, errors=shake)
    assert statics(model.build()).force == pytest.approx([1000.0, 0.0], abs=1e-6)


def test_a_torque_near_the_largest_number_is_no_riddle() -> None:
    """1e300 N m is carried or refused with the part, and no NaN goes on."""
    force = statics(one_mesh(1e-5, backlash=1e-4, torque=1e300)).force
    assert force == pytest.approx([2e301], rel=1e-9)
