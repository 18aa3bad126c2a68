"""What becomes of the claims of Pulvirenti (2023); numbers pinned so that a change of the sizing is seen here.

Numbers of masses may move by 1 % with the model of shafts and carriers, differences of masses by one per cent point.
"""

import pytest

from gearwright.replays.pulvirenti.claims import claims
from gearwright.replays.replay import Verdict

PINNED = [
    ("in-line-lightest", 1.86, None, 0.04),
    ("off-set-h3-heaviest", 1.17, None, 0.02),
    ("conventional-density", 11.1, None, 0.1),
    ("hybrid-density", 30.3, 14.4, 0.3),
    ("in-line-h2-best", 1.06, 0.59, 0.02),
    ("optimum-speed", 4200.0, 5500.0, 100.0),
    ("fast-heavier", 6.0, -7.1, 1.0),
    ("slow-heavier", 5.2, 17.8, 1.0),
    ("optimum-gain", -0.1, -5.3, 1.0),
    ("motor-mass-flat", 0.861, 0.678, 0.001),
    ("motor-share", 34.8, 69.4, 0.5),
    ("off-set-h2-slow-heavier", -5.8, 10.9, 1.0),
    ("off-set-slow-heavier", -6.9, 5.9, 1.0),
    ("off-set-faster-lighter", 1.06, 0.90, 0.01),
    ("off-set-h1-best", 0.93, 1.08, 0.01),
    ("torque-motor-turbine", 2.000, None, 0.001),
    ("torque-carrier-turbine", 6.444, None, 0.001),
    ("torque-carrier-motor", 3.222, None, 0.001),
    ("torque-propeller-turbine", 23.74, None, 0.01),
    ("mesh-force-ratio", 2.06, 2.78, 0.02),
    ("pt6t-densest", 0.608, None, 0.001),
]
"""Claim, number, by the other way of counting, tolerance."""


@pytest.fixture(scope="module")
def found():
    return {one.printed.key: one for one in claims()}


@pytest.mark.parametrize(("key", "value", "other", "within"), PINNED)
def test_the_number_of_a_claim(found, key, value, other, within):
    """Steps of 100 rpm for the optimum; torques by teeth alone, so that only the chosen teeth could move them."""
    claim = found[key]
    assert claim.value == pytest.approx(value, abs=within)
    assert claim.other == (None if other is None else pytest.approx(other, abs=within))


def test_every_claim_is_pinned(found):
    assert {key for key, *_ in PINNED} == set(found)


def test_how_many_claims_hold():
    """7 hold, 6 by one way of counting only, 8 do not."""
    verdicts = [one.verdict for one in claims()]
    assert [verdicts.count(each) for each in Verdict] == [7, 6, 8]


def test_the_slow_off_set_h2_is_the_lighter_gearbox():
    """160.9 kg at 5000 rpm, 176.7 kg at 10 000 rpm: the thesis says the reverse; only a heavy motor turns it."""
    reason = next(one.why for one in claims() if one.printed.key == "off-set-h2-slow-heavier")
    assert "-8.9 %: 160.9 against 176.7 kg" in reason
