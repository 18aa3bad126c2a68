"""The bearings and keys of the Colibri report, number by number, by its own steps, the wrong ones on purpose."""

from __future__ import annotations

import math

from gearwright.parts.bearings import ISO_R281_1962, LoadFactors, deep_groove_factors
from gearwright.parts.joints import KeySection
from gearwright.replays.colibri.report.shaft_formulas import report_bearing_load, report_key_length
from gearwright.replays.colibri.report.steps import Known, Step, Steps, of_part, typed

_SHAFTS = ("shaft-1", "shaft-2", "rotor-shaft")
_TABLE = "ISO/R 281 at F_a/C_0"


def bearings(steps: Steps) -> dict[str, Step]:
    """Return the three bearings' factors and loads.

    Args:
        steps: Known so far.
    """
    by_share = typed(axial_share(steps, "shaft-1"), 4)
    by_rating = typed(relative_axial(steps, "shaft-2"), 3)
    return {
        **_pushed(steps, "shaft-1", by_share, "ISO/R 281, read at F_a/F_total = 0.4812"),
        **_pushed(steps, "shaft-2", by_rating, f"{_TABLE} = 0.355"),
        **_hanging(steps),
    }


def keys(steps: Steps) -> dict[str, Step]:
    """Return the three keys' lengths.

    Args:
        steps: Known so far.
    """
    lengths: dict[str, Step] = {}
    for part in _SHAFTS:
        shaft = Known(steps, part)
        length = report_key_length(shaft["torque"], shaft["key-shaft-diameter"], key_section(shaft))
        chosen = math.ceil(1e3 * length) / 1e3
        lengths |= of_part(
            part,
            {
                "key-length": Step(length, "T/(d_mil (t_1 + t_2) 450 N/mm²)", ("H7",)),
                "key-length-chosen": Step(chosen, "rounded up"),
            },
        )
    return lengths


def key_section(shaft: Known) -> KeySection:
    """Return a key of the report.

    Args:
        shaft: Numbers of its shaft.
    """
    return KeySection(shaft["key-width"], shaft["key-height"], shaft["key-shaft-depth"], shaft["key-hub-depth"])


def thrust(steps: Steps, part: str) -> float:
    """Return the axial force on the bearing that is checked [N].

    Args:
        steps: Known so far.
        part: Shaft.
    """
    return Known(steps, part)["reaction-bx" if part == "rotor-shaft" else "reaction-ax"]


def radial_force(steps: Steps, part: str) -> float:
    """Return the radial force on the bearing that is checked: A of shafts 1 and 2, B of the rotor shaft [N].

    Args:
        steps: Known so far.
        part: Shaft.
    """
    shaft, end = Known(steps, part), "b" if part == "rotor-shaft" else "a"
    return math.hypot(shaft[f"reaction-{end}y"], shaft[f"reaction-{end}z"])


def relative_axial(steps: Steps, part: str) -> float:
    """Return F_a/C_0 of the bearing that is checked [-].

    Args:
        steps: Known so far.
        part: Shaft.
    """
    return thrust(steps, part) / Known(steps, part)["static-rating"]


def axial_share(steps: Steps, part: str) -> float:
    """Return F_a/F_r of the bearing that is checked [-].

    Args:
        steps: Known so far.
        part: Shaft.
    """
    return thrust(steps, part) / radial_force(steps, part)


def _pushed(steps: Steps, part: str, at: float, where: str) -> dict[str, Step]:
    """Return the bearing of shaft 1 or 2, with Y read at some argument."""
    shaft, radial = Known(steps, part), radial_force(steps, part)
    read = deep_groove_factors(at, ISO_R281_1962)
    load = report_bearing_load(radial, thrust(steps, part), shaft["static-rating"], read)
    checked = {
        "bearing-radial": Step(radial, "√(A_y² + A_z²)"),
        "axial-share": Step(axial_share(steps, part), "A_x/F_total"),
        "radial-factor": Step(read.radial, "0.56, as F_a/F_total > e"),
        "axial-factor": Step(read.axial, where, ("H5", "H6")),
        "equivalent-load": Step(load, "X F_total + Y F_a/C_0"),
    }
    return of_part(part, _limit(steps, part) | checked)


def _hanging(steps: Steps) -> dict[str, Step]:
    """Return bearing B of the rotor shaft, whose radial force is made of B_x and B_z."""
    shaft, part = Known(steps, "rotor-shaft"), "rotor-shaft"
    mixed = math.hypot(shaft["reaction-bx"], shaft["reaction-bz"])
    share = shaft["reaction-bx"] / mixed
    limit = deep_groove_factors(relative_axial(steps, part), ISO_R281_1962)
    low = share <= limit.limit
    read = LoadFactors(limit.limit, 1.0, 0.0) if low else limit
    where = "F_a/F_r < e" if low else "F_a/F_r > e"
    load = report_bearing_load(mixed, shaft["reaction-bx"], shaft["static-rating"], read)
    checked = {
        "bearing-radial": Step(mixed, "√(B_z² + B_x²)"),
        "axial-share": Step(share, "B_x/F_r"),
        "radial-factor": Step(read.radial, where),
        "axial-factor": Step(read.axial, where),
        "equivalent-load": Step(load, "X F_r + Y F_a/C_0"),
    }
    return of_part(part, _limit(steps, part) | checked)


def _limit(steps: Steps, part: str) -> dict[str, Step]:
    relative = relative_axial(steps, part)
    limit = deep_groove_factors(relative, ISO_R281_1962).limit
    return {"relative-axial": Step(relative, "F_a/C_0"), "axial-limit": Step(limit, _TABLE, ("H6",))}
