"""The claims of Pulvirenti (2023) held against what gearwright computes: printed, computed, verdict, reason.

Every number comes from the shipped designs and studies. Where a claim hangs on how one counts (the motor's mass law,
the phase of flight) both ways are computed, and the verdict is that of the numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.replays.pulvirenti.errata import PrintedClaim, printed_claims
from gearwright.replays.pulvirenti.masses import MASS_CLAIMS
from gearwright.replays.pulvirenti.runs import Computed
from gearwright.replays.pulvirenti.torques import TORQUE_CLAIMS
from gearwright.replays.verdict import Verdict

_NUMBERS = {**MASS_CLAIMS, **TORQUE_CLAIMS}


@dataclass(frozen=True)
class Claim:
    """A printed claim and what the equations give."""

    printed: PrintedClaim
    value: float
    """As the claim counts, in the unit in which its dimension is shown."""
    other: float | None
    """By the second way to count; None where there is none."""
    why: str
    """Reason, with numbers."""

    @property
    def verdict(self) -> Verdict:
        """`HOLDS` if the wording covers the number by every way of counting, `CONDITION` if only by one."""
        ways = [self.printed.covers(value) for value in (self.value, self.other) if value is not None]
        if all(ways):
            return Verdict.HOLDS
        return Verdict.CONDITION if any(ways) else Verdict.FAILS


def claims() -> tuple[Claim, ...]:
    """Return every claim with its numbers; takes some two hundred sizings, about a second."""
    return tuple(_claim(printed, _NUMBERS[printed.key]()) for printed in printed_claims())


def _claim(printed: PrintedClaim, computed: Computed) -> Claim:
    return Claim(printed, computed.value, computed.other, printed.why.format(**computed.numbers))
