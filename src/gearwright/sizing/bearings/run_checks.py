"""Checks of how a bearing lives with its oil, what it bears at least and how fast it turns."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.catalogue import Bearing, ModifiedLife
from gearwright.checks import Check
from gearwright.identity import PartId
from gearwright.parts.bearings import life_exponent
from gearwright.sizing.mounted import Running
from gearwright.spec import Design
from gearwright.units import Life


def life_check(
    part: PartId, fitted: Bearing, basic: Life, oiled: ModifiedLife | None, wanted: Life, design: Design
) -> Check:
    """Return the check of a bearing's life, basic or modified as the design asks.

    Args:
        part: The bearing.
        fitted: Which one.
        basic: L_10h [s].
        oiled: With its oil; None where nothing loads it.
        wanted: What is asked [s].
        design: With its rules for bearings.
    """
    if design.bearing_rules.life == "basic" or oiled is None:
        exponent = life_exponent(fitted.kind)
        return Check(
            part, "life", "ISO 281:2007", basic, wanted, "life",
            exponent=exponent, symbol="L_10h", place=fitted.designation,
        )  # fmt: skip
    return Check(
        part, "life", "ISO 281:2007, 9.3", oiled.life, wanted, "life",
        exponent=None, symbol="L_nmh", place=fitted.designation,
    )  # fmt: skip


def limit_checks(part: PartId, fitted: Bearing, running: Running, design: Design) -> Iterator[Check]:
    """Yield whether a bearing bears enough not to skid, and does not turn too fast.

    Args:
        part: The bearing.
        fitted: Which one.
        running: What it bears at least, and its speeds.
        design: With its rules for bearings.
    """
    place = fitted.designation
    if running.lightest_load:
        yield Check(
            part, "least load", "SKF, minimum load", running.lightest_load, running.least_load, "force",
            exponent=None, symbol="P", place=place,
        )  # fmt: skip
    yield Check(
        part, "thermal reference speed", "ISO 15312:2003", running.highest_speed, running.reference_speed, "speed",
        at_most=True, exponent=None, symbol="n", place=place,
    )  # fmt: skip
    yield Check(
        part, "speed factor", "n d_m in mm/min", running.speed_factor, design.bearing_rules.speed_factor, "number",
        at_most=True, exponent=None, symbol="n d_m", place=place,
    )  # fmt: skip
