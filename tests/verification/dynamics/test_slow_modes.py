"""Slow modes beside stiff lines: whatever the stiffest thing of a model is, no motion is lost beside it."""

import math

import numpy as np
import pytest

from gearwright.dynamics import Model, campbell, modes
from gearwright.dynamics.equations import damped_modes, line_forces, redundancy
from gearwright.errors import DesignError

SOFT, STIFF = 1e4, 1e18
"""Stiffnesses 14 decades apart [N m/rad]."""
INERTIAS = (2.0, 3.0, 5.0)
"""[kg m²]"""


def chain(delay=0.0):
    """Three discs on two shafts, each with so many seconds of its stiffness as damping."""
    model = Model()
    for name, inertia in zip("abc", INERTIAS, strict=True):
        model.rotation(name, inertia=inertia, speed=100.0)
    model.shaft("soft", "a", "b", stiffness=SOFT, damping=delay * SOFT)
    model.shaft("stiff", "b", "c", stiffness=STIFF, damping=delay * STIFF)
    return model.build()


def rates():
    """Roots of λ² − b λ + c in a form without cancellation [rad/s], as Timoshenko, Vibration Problems, has it."""
    first, second, third = INERTIAS
    b = SOFT * (1.0 / first + 1.0 / second) + STIFF * (1.0 / second + 1.0 / third)
    c = SOFT * STIFF * (first + second + third) / (first * second * third)
    fast = 0.5 * (b + math.sqrt(b * b - 4.0 * c))
    return [math.sqrt(c / fast), math.sqrt(fast)]


def test_a_chain_whose_stiffnesses_span_14_decades_has_both_its_modes():
    found = modes(chain())
    assert found.rigid == 1
    assert 2.0 * math.pi * found.frequency[1:] == pytest.approx(rates(), rel=1e-8)
    assert found.line_energy[:, 1] == pytest.approx([1.0, 0.0], abs=1e-8)
    assert damped_modes(chain().arrays).rate.imag == pytest.approx(rates(), rel=1e-8)


def test_damping_in_proportion_to_stiffness_leaves_both_modes_where_one_mass_has_them():
    """λ = −β ω²/2 ± i ω √(1 − (β ω/2)²): the fast mode is damped by 5 %, the slow one by next to nothing."""
    delay = 0.1 / rates()[1]
    found = damped_modes(chain(delay).arrays).rate
    wanted = [complex(-0.5 * delay * w**2, w * math.sqrt(1.0 - (0.5 * delay * w) ** 2)) for w in rates()]
    assert found == pytest.approx(wanted, rel=1e-8)


def test_a_campbell_diagram_shows_a_slow_mode_beside_one_ten_million_times_faster():
    diagram = campbell(chain(), [0.5, 1.0, 1.5])
    assert 2.0 * math.pi * diagram.frequency == pytest.approx(np.tile(rates(), (3, 1)), rel=1e-8)
    turning = next(crossing for crossing in diagram.crossings if crossing.mode == 0)
    assert turning.factor == pytest.approx(rates()[0] / 100.0, rel=1e-8)


def test_what_turns_holds_a_motion_that_no_line_holds():
    """A mass in a plane that turns with its frame: ẍ − 2 Ω ẏ − Ω² x = 0 has the double rate Ω; a soft spring parts it.

    Source: x + i y = e^(−i Ω t) of a mass at rest, and e^(−i (Ω ± ω) t) of one on springs of ω.
    """
    model = Model()
    model.rotation("disc", inertia=1.0, speed=0.0)
    model.rotation("wall", inertia=1.0)
    model.shaft("stiff", "disc", "wall", stiffness=STIFF)
    for axis in "xy":
        model.translation(axis, mass=4.0)
        model.support(f"spring {axis}", axis, stiffness=4.0 * 30.0**2)
    model.rotating_frame("x", "y", speed=100.0)
    found = damped_modes(model.build().arrays).rate.imag
    assert found[:2] == pytest.approx([70.0, 130.0], rel=1e-6)


def test_what_follows_makes_a_motion_swing_that_no_line_holds():
    """m ẍ = −k y, m ÿ = k x: λ² = ± i k/m, so that both motions have |λ| = √(k/m) and Im λ = √(k/2m)."""
    model = Model()
    model.rotation("disc", inertia=1.0, speed=0.0)
    model.rotation("wall", inertia=1.0)
    model.shaft("stiff", "disc", "wall", stiffness=STIFF)
    for axis in "xy":
        model.translation(axis, mass=4.0)
    model.following({"x": 1.0}, {"y": 1.0}, stiffness=4.0 * 50.0**2, damping=0.0)
    found = damped_modes(model.build().arrays).rate
    assert found[:2].imag == pytest.approx([50.0 / math.sqrt(2.0)] * 2, rel=1e-6)
    assert sorted(found[:2].real) == pytest.approx([-50.0 / math.sqrt(2.0), 50.0 / math.sqrt(2.0)], rel=1e-6)


def test_teeth_of_a_soft_pair_part_beside_a_pair_that_is_14_decades_stiffer():
    """Two meshes in parallel carry 10 N; one has an error of 1 m at 100 N/m: it parts, and the other carries all."""
    model = Model()
    for name in "abcd":
        model.rotation(name, inertia=1.0)
    for pair, stiffness, load in (("ab", 1e16, 1.0), ("cd", 100.0, 10.0)):
        for side in ("left", "right"):
            weights = {pair[0]: 1.0, pair[1]: -1.0}
            model.mesh(f"{pair} {side}", weights, stiffness=stiffness, backlash=math.inf)
        model.load(pair[0], constant=load)
        model.load(pair[1], constant=-load)
    train = redundancy(model.build())
    force = line_forces(train, np.array([0.0, 0.0, 1.0, 0.0]))
    assert force == pytest.approx([0.5, 0.5, 0.0, 10.0], abs=1e-6)


def test_a_slow_line_that_would_stretch_is_told_beside_a_fast_one():
    """A wheel of 1 rad/s given as 1.1 beside a rotor of a million rad/s: one part in ten of its own speed."""
    model = Model()
    model.rotation("rotor", inertia=1.0, speed=1e6)
    model.rotation("turbine", inertia=1.0, speed=1e6)
    model.shaft("fast", "rotor", "turbine", stiffness=1e6)
    model.rotation("wheel", inertia=1.0, speed=1.0)
    model.rotation("hub", inertia=1.0, speed=1.1)
    model.shaft("slow", "wheel", "hub", stiffness=1e6)
    with pytest.raises(DesignError, match=r"lines\.slow: it would stretch steadily"):
        model.build()
