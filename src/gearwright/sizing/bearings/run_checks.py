"""Checks of how a bearing lives with its oil, what it bears at least and how fast it turns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.catalogue import Bearing, ModifiedLife
from gearwright.checks import Check
from gearwright.identity import PartId
from gearwright.parts.bearings import BearingKind, Lubrication, life_exponent, speed_limit
from gearwright.sizing.mounted import Running
from gearwright.spec import Design
from gearwright.units import Life

_LIGHT = "its rolling elements may skid; a lighter series, a ball bearing in its place or a preload would help"
_WARM = (
    "warmer than 70 °C in an oil bath; oil jets that carry off what it loses, a lighter series or a smaller"
    " bore would help"
)
_BETTER: Mapping[Lubrication, Lubrication | None] = {"grease": "jet", "jet": "under-race", "under-race": None}
_HOW = {"grease": "with grease", "jet": "with oil jets", "under-race": "with oil under its races"}


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


def speed_factor_check(part: PartId, fitted: Bearing, speed_factor: float, design: Design) -> Check:
    """Return the check of the n d_m of a bearing, with what would cure it where it is more than usual.

    Args:
        part: The bearing.
        fitted: Which one.
        speed_factor: n d_m [mm/min].
        design: With its rules for bearings.
    """
    rules = design.bearing_rules
    usual, careful = speed_limit(fitted.kind, rules.lubrication)
    limit, why = rules.speed_factor or careful, ""
    if speed_factor > limit:
        why = f"{_HOW[rules.lubrication]} it bears {limit:.2g}; {_cure(fitted.kind, design)}"
    elif rules.speed_factor is None and speed_factor > usual:
        why = (
            f"above {usual:.2g}, which is usual {_HOW[rules.lubrication]}: guided cage, accurate parts, cool clean oil"
        )
    return Check(
        part, "speed factor", "n d_m in mm/min", speed_factor, limit, "number",
        at_most=True, exponent=None, symbol="n d_m", place=fitted.designation, why=why,
    )  # fmt: skip


def highest_speed_factor(kind: BearingKind, design: Design) -> float:
    """Return the n d_m above which a bearing fails [mm/min].

    Args:
        kind: Of bearing.
        design: With its rules for bearings.
    """
    return design.bearing_rules.speed_factor or speed_limit(kind, design.bearing_rules.lubrication).careful


def _cure(kind: BearingKind, design: Design) -> str:
    """Return which arrangement would let a bearing turn so fast."""
    rules, cures = design.bearing_rules, ["a smaller bore or a lighter series", "two rows that share the load"]
    if rules.speed_factor is None and (better := _BETTER[rules.lubrication]) is not None:
        cures.append(f'bearing_rules.lubrication = "{better}" (to {speed_limit(kind, better).careful:.2g})')
    if kind is BearingKind.TAPER:
        cures.append("an angular contact ball pair beside a cylindrical roller bearing in place of taper rollers")
    return f"what helps: {', or '.join(cures)}"


def limit_checks(part: PartId, fitted: Bearing, running: Running, design: Design) -> Iterator[Check]:
    """Yield whether a bearing turns too fast and, where the design asks, bears enough not to skid and stays cool.

    Args:
        part: The bearing.
        fitted: Which one.
        running: What it bears at least, and its speeds.
        design: With its rules for bearings.
    """
    place = fitted.designation
    yield speed_factor_check(part, fitted, running.speed_factor, design)
    if not design.bearing_rules.limits:
        return
    if running.lightest_load:
        yield Check(
            part, "least load", "SKF, minimum load", running.lightest_load, running.least_load, "force",
            exponent=None, symbol="P", place=place,
            why=_LIGHT if running.lightest_load < running.least_load else "",
        )  # fmt: skip
    yield Check(
        part, "thermal reference speed", "ISO 15312:2003", running.highest_speed, running.reference_speed, "speed",
        at_most=True, exponent=None, symbol="n", place=place,
        why=_WARM if running.highest_speed > running.reference_speed else "",
    )  # fmt: skip
