"""Whether what the Colibri report designs can be made and would last: each check with its value and its limit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from gearwright.catalogue import key_for_shaft
from gearwright.parts.bearings import BearingKind, basic_life, life_time, system_life
from gearwright.parts.gears import CylindricalGear
from gearwright.parts.joints import key_pressure
from gearwright.replays.colibri.report.bearings import key_section
from gearwright.replays.colibri.report.chain import executed
from gearwright.replays.colibri.report.steps import Known
from gearwright.replays.colibri.verdicts.bevel import CONTACT_SAFETY, ROOT_SAFETY, bevel_pair, bevel_safeties
from gearwright.replays.colibri.verdicts.correct import (
    KEY_PRESSURE,
    SHAFTS,
    bearings_of_size,
    true_load,
    twisted_diameter,
)

_NAMES = {"shaft-1": "shaft 1", "shaft-2": "shaft 2", "rotor-shaft": "rotor shaft"}
_SPEEDS = {"shaft-1": "helical-pinion", "shaft-2": "bevel-pinion", "rotor-shaft": "bevel-wheel"}
_SLENDER = 1.1
"""Greatest b/d_1 of hardened gears without lead correction [-] (usual practice)."""
_ROTOR_DIAMETER = 10.0
"""Of the EC120B's main rotor [m] (type data; the report does not state it)."""
_TIP_SPEED = 225.0
"""Usual for helicopters' main rotors: 200 to 225 m/s [m/s]."""
_LEAST_LIFE = 5000.0 * 3600.0
"""Asked of each bearing [s]."""


class Sense(StrEnum):
    """On which side of its limit a value is good."""

    MOST = "at most"
    LEAST = "at least"


@dataclass(frozen=True)
class Finding:
    """One check of the report's design."""

    what: str
    """Of which part, in words."""
    value: float
    """As the report designs it, in SI."""
    sense: Sense
    """On which side of the limit it may be."""
    limit: float
    """In SI."""
    dimension: str
    """Key of the shown units."""
    source: str
    """Where the limit comes from."""

    @property
    def holds(self) -> bool:
        """Whether the value is on the right side."""
        return self.value <= self.limit if self.sense is Sense.MOST else self.value >= self.limit


def findings() -> tuple[Finding, ...]:
    """Return every check, the geometry first."""
    return (*_bevel_geometry(), *_helical_geometry(), *_shafts(), *_bearings(), *_keys(), *_strength())


def bearing_life(part: str) -> float:
    """Return the basic rating life of the bearing that the report checks, under its true load [s].

    Args:
        part: Shaft.

    Source: ISO 281 with the report's C and the speed of the shaft.
    """
    steps = executed()
    rating = Known(steps, part)["dynamic-rating"]
    life = basic_life(rating, true_load(part), BearingKind.DEEP_GROOVE)
    return life_time(life, Known(steps, _SPEEDS[part])["speed"])


def flank_pressure(part: str) -> float:
    """Return the pressure on the whole flank of a key at its chosen length [Pa].

    Args:
        part: Shaft.
    """
    shaft = Known(executed(), part)
    length = shaft["key-length-chosen"]
    return key_pressure(shaft["torque"], shaft["key-shaft-diameter"], key_section(shaft), bearing_length=length)


def _bevel_geometry() -> tuple[Finding, ...]:
    pair, width = bevel_pair(), executed()["bevel-pinion.face-width"].value
    cone, widest, where = pair.outer_cone_distance, pair.face_width, "ISO 23509, annex B: R_e/3, 10 m_et"
    return (
        Finding(
            "bevel gears: face against the whole cone", width, Sense.MOST, cone, "length", "the apex ends the teeth"
        ),
        Finding("bevel gears: face that still bears", width, Sense.MOST, widest, "length", where),
    )


def _helical_geometry() -> tuple[Finding, ...]:
    gear, shaft = Known(executed(), "helical-pinion"), Known(executed(), "shaft-1")
    pinion = CylindricalGear(round(gear["teeth"]), gear["module"], gear["face-width"], gear["helix-angle"])
    room = shaft["length"] - shaft["bearing-width"]
    metal = 0.5 * (gear["root-diameter"] - shaft["shaft-diameter"]) - shaft["key-hub-depth"]
    height = 0.5 * (gear["tip-diameter"] - gear["root-diameter"])
    slender = gear["face-width"] / gear["pitch-diameter"]
    rim = "ISO 6336-3, clause 9: half the tooth height"
    return (
        Finding(
            "helical pinion: face over diameter", slender, Sense.MOST, _SLENDER, "ratio", "usual for hardened gears"
        ),
        Finding("helical pinion: face between its bearings", gear["face-width"], Sense.MOST, room, "length", "L − B"),
        Finding(
            "helical pinion: profile shift", 0.0, Sense.LEAST, pinion.undercut_shift, "ratio", "undercut, ISO 21771"
        ),
        Finding("helical pinion: metal over its keyway", metal, Sense.LEAST, 0.5 * height, "length", rim),
    )


def _shafts() -> tuple[Finding, ...]:
    steps, pair = executed(), bevel_pair()
    shaft, pitch = steps["shaft-2.shaft-diameter"].value, pair.outer_diameters[0]
    root = steps["bevel-pinion.root-diameter"].value
    through = (
        Finding("shaft 2 in the pitch circle of its pinion", shaft, Sense.MOST, pitch, "length", "the pinion's teeth"),
        Finding("shaft 2 in the root circle of its pinion", shaft, Sense.MOST, root, "length", "as printed"),
    )
    return through + tuple(
        Finding(
            f"{_NAMES[part]}: diameter under moment and torque",
            Known(steps, part)["shaft-diameter"],
            Sense.LEAST,
            twisted_diameter(part),
            "length",
            "von Mises, the report's loads and stress",
        )
        for part in SHAFTS
    )


def _bearings() -> tuple[Finding, ...]:
    shaft = Known(executed(), "shaft-2")
    made = bearings_of_size(shaft["bearing-outer"], shaft["bearing-width"])
    bore = max(bearing.bore for bearing in made)
    names = ", ".join(f"{bearing.designation} with {1e3 * bearing.bore:g} mm" for bearing in made)
    lives = tuple(
        Finding(f"{_NAMES[part]}: life of its bearing", bearing_life(part), Sense.LEAST, _LEAST_LIFE, "time", "ISO 281")
        for part in SHAFTS
    )
    together = system_life([life.value for life in lives])
    return (
        Finding("shaft 2: bore of a bearing of 120 × 29 mm", shaft["bearing-bore"], Sense.MOST, bore, "length", names),
        *lives,
        Finding("the three together", together, Sense.LEAST, _LEAST_LIFE, "time", "ISO 281, Weibull"),
    )


def _keys() -> tuple[Finding, ...]:
    findings = []
    for part in SHAFTS:
        shaft = Known(executed(), part)
        length, shortest = shaft["key-length-chosen"], key_for_shaft(shaft["key-shaft-diameter"]).shortest
        name = f"{_NAMES[part]}: its key"
        pressure = flank_pressure(part)
        findings.append(Finding(f"{name}, length", length, Sense.LEAST, shortest, "length", "DIN 6885-1, shortest"))
        findings.append(
            Finding(f"{name}, pressure", pressure, Sense.MOST, KEY_PRESSURE, "stress", "DIN 6892, method C")
        )
    return tuple(findings)


def _strength() -> tuple[Finding, ...]:
    contact, root = bevel_safeties()
    tip = 0.5 * _ROTOR_DIAMETER * executed()["requirement.rotor-speed"].value
    return (
        Finding("bevel gears: S_H, face R_e/3", contact, Sense.LEAST, CONTACT_SAFETY, "ratio", "ISO 10300, method B1"),
        Finding("bevel gears: S_F, face R_e/3", root, Sense.LEAST, ROOT_SAFETY, "ratio", "ISO 10300, method B1"),
        Finding(
            "rotor of 10 m: tip speed", tip, Sense.MOST, _TIP_SPEED, "velocity", "usual for helicopters: 200 to 225 m/s"
        ),
    )
