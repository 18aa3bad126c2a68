"""Verdicts follow from numbers alone."""

import math

import pytest

from gearwright.replays.pulvirenti.claims import MASS_CLAIMS, TORQUE_CLAIMS, Claim, PrintedClaim, printed_claims
from gearwright.replays.replay import Verdict

PRINTED = PrintedClaim("key", "p. 1", "twice", "ratio", "the other way", "ratio", 1.8, 2.2, "")


@pytest.mark.parametrize(
    ("value", "other", "verdict"),
    [
        (2.0, None, Verdict.HOLDS),
        (2.0, 1.9, Verdict.HOLDS),
        (2.0, 3.0, Verdict.CONDITION),
        (3.0, 2.0, Verdict.CONDITION),
        (3.0, 1.0, Verdict.FAILS),
        (math.nan, None, Verdict.FAILS),
    ],
)
def test_the_verdict_is_that_of_the_numbers(value, other, verdict):
    assert Claim(PRINTED, value, other, "").verdict is verdict


def test_every_printed_claim_is_computed_and_no_other():
    assert {one.key for one in printed_claims()} == {*MASS_CLAIMS, *TORQUE_CLAIMS}
