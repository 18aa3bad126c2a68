"""Parallel keys: pressure on their flanks by DIN 6892, and shear and bearing by Shigley."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.errors import DesignError, Problem
from gearwright.units import Length

TWO_KEYS_SHARE = 0.75
"""φ: what each of two keys bears, because they do not fit alike [-] (DIN 6892:2012, method C)."""
LONGEST_BEARING = 1.3
"""l_tr/d beyond which more length does not bear more [-] (DIN 6892:2012)."""


@dataclass(frozen=True)
class KeySection:
    """Section of a parallel key and of its keyways."""

    width: Length
    """b [m]."""
    height: Length
    """h [m]."""
    shaft_depth: Length
    """t_1, depth of the keyway in the shaft [m]."""
    hub_depth: Length
    """t_2, depth of the keyway in the hub [m]."""


def bearing_length(section: KeySection, length: float, hub_length: float) -> float:
    """Return the length of a key with round ends that bears on its flanks l_tr [m].

    Args:
        section: Of the key [m].
        length: l, with the round ends [m].
        hub_length: [m].

    Source: DIN 6892:2012, form A: l_tr = l − b.

    Raises:
        DesignError: If the key is longer than its hub, or all round ends.
    """
    if length > hub_length:
        message = f"{1e3 * length:g} mm is longer than its hub; allowed: up to {1e3 * hub_length:g} mm"
        raise DesignError([Problem("key.length", message)])
    if length <= section.width:
        message = f"{1e3 * length:g} mm leaves no flat flank; allowed: above {1e3 * section.width:g} mm"
        raise DesignError([Problem("key.length", message)])
    return length - section.width


def key_pressure(torque: float, diameter: float, section: KeySection, *, bearing_length: float, keys: int = 1) -> float:
    """Return the mean pressure on the flank of a key in the hub [Pa].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].
        bearing_length: l_tr [m].
        keys: One, or two opposite ones [-].

    Source: DIN 6892:2012, method C: p = 2 T / (d (h − t_1) l_tr i φ), φ = 1 for one key and 0.75 for two.

    Valid for: one or two keys.

    Raises:
        DesignError: If there are neither one nor two keys.

    >>> section = KeySection(14e-3, 9e-3, 5.5e-3, 3.8e-3)
    >>> round(key_pressure(500.0, 0.05, section, bearing_length=0.056) / 1e6, 2)
    102.04
    """
    return 2.0 * torque / (diameter * _bearing_height(section) * bearing_length * _effective(keys))


def key_length(torque: float, diameter: float, section: KeySection, *, allowable: float, keys: int = 1) -> float:
    """Return the bearing length l_tr that a torque asks for [m].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].
        allowable: Pressure that the weakest of shaft, hub and key bears, about 0.9 R_e over safety [Pa].
        keys: One, or two opposite ones [-].

    Source: DIN 6892:2012, method C solved for l_tr; useful up to 1.3 d.

    Raises:
        DesignError: If there are neither one nor two keys.
    """
    return 2.0 * torque / (diameter * _bearing_height(section) * allowable * _effective(keys))


def _bearing_height(section: KeySection) -> float:
    return section.height - section.shaft_depth


def _effective(keys: int) -> float:
    if keys not in (1, 2):
        raise DesignError([Problem("key.count", f"{keys} given; allowed: 1 or 2; use a spline for more torque")])
    return 1.0 if keys == 1 else 2.0 * TWO_KEYS_SHARE
