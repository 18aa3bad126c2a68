"""Sets in the gears that brakes and clutches choose: what holds them in motion is what equilibrium asks."""

import numpy as np
import pytest

from designs import BRAKED
from gearwright.dynamics import simulate
from gearwright.dynamics.assembly import assemble
from gearwright.sizing import size
from gearwright.spec import parse

SIZING = size(
    parse(
        BRAKED
        + """\
[cases.low]
engaged = ["brake"]
m.rating = 1
[cases.high]
engaged = ["lock"]
m.rating = 1
"""
    )
)
TORQUE = 100e3 / (4000 * np.pi / 30)
"""Of the motor [N m]."""


@pytest.mark.parametrize(
    ("case", "line", "torque"),
    [("low", "brake clutch", TORQUE * 69 / 33), ("high", "lock clutch", TORQUE * 69 / (33 + 69))],
)
def test_what_holds_a_set_bears_the_torque_of_the_ring(case, line, torque):
    """Braked ring: T_s z_r/z_s. Locked set: of the motor's torque on the carrier the ring has z_r/(z_s + z_r).

    Means of a run that starts in equilibrium; 1e-5, as meshes vibrate and it ends within a cycle.
    """
    trace = simulate(assemble(SIZING, case), 0.05)
    assert abs(np.mean(trace.force.of(line)["mean"])) == pytest.approx(torque, rel=1e-5)


def test_another_brake_is_another_ratio():
    """With the brake released and the lock engaged the set turns as one: 1 instead of 1 + z_r/z_s = 3.09."""
    low, high = (SIZING.flows[case].speeds for case in ("low", "high"))
    assert low["in"] / low["out"] == pytest.approx(1 + 69 / 33, rel=1e-12)
    assert high["in"] / high["out"] == pytest.approx(1.0, rel=1e-12)
    assert low["ring"] == 0.0
    assert not any(line.startswith("brake") for line in assemble(SIZING, "high").labels.lines)
