"""Computation of the EC120B "Colibri" term project step by step, with its errors, and its printed numbers.

What would have been right is in `verdicts`.
"""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from gearwright.base import RPM
from gearwright.parts.bearings import ISO_R281_1962, LoadFactors, deep_groove_factors
from gearwright.parts.shafts import KeySection, PointLoads, bearing_reactions, diagram, shaft_diameter, supported
from gearwright.replays.colibri.formulas import (
    Reading,
    ReportForces,
    ReportGear,
    bevel_forces_colibri,
    form_factor_colibri,
    fracture_module,
    helical_forces_colibri,
    pitting_module,
    report_bearing_load,
    report_diameters,
    report_key_length,
    report_torque,
    report_width,
    settled_dynamic_factor,
)

# ----------------------------------------------------------------------------------------------------------------------
# What the EC120B "Colibri" term project prints: 236 numbers, what they silently assume, and what is wrong with them.
#
# The numbers are facts of the source, digit for digit; `gearwright.replays.colibri.replay` computes every one again.
# The errata say which numbers are wrong and why; the correct values are computed, too.
# ----------------------------------------------------------------------------------------------------------------------


SOURCE = "Uyar, Kılıç, Koşar & Bölükbaş, Transmission System Design for Colibri, Istanbul Technical University"
_UNITS = {
    "": 1.0, "mm": 1e-3, "mm/s": 1e-3, "N": 1.0, "N mm": 1e-3, "N/mm²": 1e6, "rpm": RPM, "°": math.pi / 180.0,
}  # fmt: skip
"""Unit of the report -> SI."""


@dataclass(frozen=True)
class PrintedNumber:
    """One number of the report."""

    key: str
    """Part and quantity, such as ``shaft-1.torque``."""
    place: str
    """Where it stands, by the report's own headings."""
    symbol: str
    """As the report writes it."""
    unit: str
    """Unit in which it is printed."""
    printed: str
    """Its digits, with a point for the comma."""
    is_stated: bool
    """Whether the report gives it without computing it."""

    @property
    def part(self) -> str:
        """First half of the key."""
        return self.key.partition(".")[0]

    @property
    def scale(self) -> float:
        """Its unit in SI."""
        return _UNITS[self.unit]

    @property
    def value(self) -> float:
        """As printed, in SI."""
        return float(self.printed) * self.scale


@dataclass(frozen=True)
class Assumption:
    """What the report does not say, and what its digits show."""

    key: str
    """H1 to H9."""
    text: str
    """What has to be assumed."""
    evidence: str
    """Why it is taken to be so."""


@dataclass(frozen=True)
class ColibriErratum:
    """One mistake of the report, and the numbers that carry it."""

    key: str
    """E1 and so on."""
    title: str
    """In few words."""
    rows: tuple[str, ...]
    """Keys of the numbers that are wrong by it; empty where it concerns no single number."""
    why: str
    """Reason; numbers in braces are filled in from the computation."""


@cache
def printed_numbers() -> tuple[PrintedNumber, ...]:
    """Return every number of the report in its order."""
    rows = csv.DictReader(_text("numbers.csv").splitlines())
    return tuple(
        PrintedNumber(row["key"], row["place"], row["symbol"], row["unit"], row["printed"], row["stated"] == "yes")
        for row in rows
    )


@cache
def assumptions() -> Mapping[str, Assumption]:
    """Return what the report silently assumes, by key."""
    return MappingProxyType({row["key"]: Assumption(**row) for row in _notes()["assumptions"]})


@cache
def colibri_errata() -> tuple[ColibriErratum, ...]:
    """Return the report's mistakes in its order."""
    return tuple(ColibriErratum(row["key"], row["title"], tuple(row["rows"]), row["why"]) for row in _notes()["errata"])


def _notes() -> dict[str, Any]:
    return tomllib.loads(_text("notes.toml"))


def _text(name: str) -> str:
    return files("gearwright.replays.colibri").joinpath(f"data/{name}").read_text(encoding="utf-8")


# ----------------------------------------------------------------------------------------------------------------------
# One computed number of the Colibri report, and how a part of the chain reads those before it.
# ----------------------------------------------------------------------------------------------------------------------


class Step(NamedTuple):
    """A number as the report's own steps give it."""

    value: float
    """In SI."""
    how: str
    """Formula or origin, in the report's symbols."""
    assumptions: tuple[str, ...] = ()
    """What the report does not say and the step needs: H1 to H9."""

    def again(self, where: str) -> Step:
        """Return the same number where the report prints it once more.

        Args:
            where: It was before.
        """
        return self._replace(how=f"as {where}")


Steps: TypeAlias = Mapping[str, Step]
"""Key of a number -> the number."""


class Known:
    """The numbers of one part that are known so far, by the second half of their keys."""

    def __init__(self, steps: Steps, part: str) -> None:
        self._steps, self._part = steps, part

    def __getitem__(self, name: str) -> float:
        return self.step(name).value

    def step(self, name: str) -> Step:
        """Return a number with its origin.

        Args:
            name: Second half of the key.
        """
        return self._steps[f"{self._part}.{name}"]


def stated_steps() -> dict[str, Step]:
    """Return the numbers that the report states."""
    return {number.key: Step(number.value, "stated") for number in printed_numbers() if number.is_stated}


def of_part(part: str, steps: Steps) -> dict[str, Step]:
    """Return the numbers of a part under their whole keys.

    Args:
        part: First half of the keys.
        steps: By the second half.
    """
    return {f"{part}.{name}": step for name, step in steps.items()}


def typed(value: float, decimals: int, unit: float = 1.0) -> float:
    """Return a number as it is after it was printed with some decimals and typed in again, in SI.

    Args:
        value: In SI.
        decimals: After the point.
        unit: In which it was printed, in SI.
    """
    return round(value / unit, decimals) * unit


# ----------------------------------------------------------------------------------------------------------------------
# The gears of the Colibri report, number by number, from its stated inputs and by its own steps.
#
# Every function computes one part and reads those before it. Wrong steps are made on purpose: `correct` has the
# right ones.
# ----------------------------------------------------------------------------------------------------------------------


POWER = 322e3
"""Power of the engine [W]: the report does not state it (H1)."""
_NEWTON_MILLIMETRE = 1e-3


def requirement(steps: Steps) -> dict[str, Step]:
    """Return section A: the ratio, whole and split.

    Args:
        steps: Known so far.
    """
    stated = Known(steps, "requirement")
    split = Known(steps, "helical-pinion")["ratio"] * Known(steps, "bevel-pinion")["ratio"]
    return of_part(
        "requirement",
        {
            "ratio": Step(stated["input-speed"] / stated["rotor-speed"], "n_1/n_R"),
            "ratio-product": Step(split, "4 · 2.5"),
        },
    )


def helical_pinion(steps: Steps) -> dict[str, Step]:
    """Return table 1.1, the modules and the dimensions of the helical pinion.

    Args:
        steps: Known so far.
    """
    pinion = Known(steps, "helical-pinion")
    torque, helix = report_torque(POWER, pinion["speed"]), pinion["helix-angle"]
    virtual = typed(pinion["teeth"] / math.cos(helix) ** 3, 2)
    gear = _gear(pinion, torque, form_factor_colibri(virtual))
    factor = settled_dynamic_factor(gear, speed=pinion["speed"], allowable=pinion["bending-strength"])
    mates = pinion["teeth"] * (1.0 + pinion["ratio"])
    computed = {
        "torque": Step(torque, "9550 P/n_p with P = 322 kW", ("H1",)),
        "form-factor": Step(gear.form_factor, "table 2 at N_1/cos³ β = 16.64", ("H4",)),
        "cos-helix": Step(math.cos(helix), "cos 15°"),
        "dynamic-factor": Step(factor, "1 + (V/35.9 m/s)², V at eq. 1.1's module", ("H3",)),
        "centre-distance": Step(pinion["module"] * mates / (2.0 * math.cos(helix)), "m_n (N_1 + i N_1)/(2 cos β)"),
    }
    return of_part(
        "helical-pinion",
        {**computed, **_modules(steps, pinion, gear, factor), **_dimensions(pinion, pinion["module"], pinion)},
    )


def helical_wheel(steps: Steps) -> dict[str, Step]:
    """Return table 1.2 and the dimensions of the helical wheel.

    Args:
        steps: Known so far.
    """
    wheel, pinion = Known(steps, "helical-wheel"), Known(steps, "helical-pinion")
    teeth = wheel["ratio"] * pinion["teeth"]
    speed = pinion["speed"] / wheel["ratio"]
    torque = wheel["ratio"] * typed(pinion["torque"], 4, _NEWTON_MILLIMETRE)
    computed = {
        "dynamic-factor": pinion.step("dynamic-factor").again("table 1.1"),
        "speed": Step(speed, "n_p/i"),
        "torque": Step(torque, "i T_1, T_1 of four decimals", ("H5",)),
        "form-factor": pinion.step("form-factor").again("table 1.1: that of the pinion"),
        "cos-helix": Step(math.cos(wheel["helix-angle"]), "cos 15°"),
        "teeth": Step(teeth, "i N_1"),
        "teeth-exact": Step(teeth, "i N_1"),
        "teeth-whole": Step(float(round(teeth)), "N_2 to a whole number"),
        "ratio-new": Step(round(teeth) / pinion["teeth"], "N_2/N_1"),
    }
    turning = {"teeth": computed["teeth-whole"], "speed": computed["speed"]}
    known = Known({**steps, **of_part("helical-wheel", turning)}, "helical-wheel")
    return of_part("helical-wheel", {**computed, **_dimensions(known, pinion["module"], wheel)})


def bevel_pinion(steps: Steps) -> dict[str, Step]:
    """Return the data, modules and dimensions of the bevel pinion.

    Args:
        steps: Known so far.
    """
    pinion, wheel, mate = Known(steps, "bevel-pinion"), Known(steps, "helical-wheel"), Known(steps, "bevel-wheel")
    gear = _gear(pinion, wheel["torque"], form_factor_colibri(pinion["teeth"]))
    factor = settled_dynamic_factor(gear, speed=wheel["speed"], allowable=pinion["bending-strength"])
    computed = {
        "speed": wheel.step("speed").again("table 1.2"),
        "torque": wheel.step("torque").again("table 1.2"),
        "form-factor": Step(gear.form_factor, "table 2 at N_1 = 17", ("H4",)),
        "cos-helix": Step(math.cos(pinion["helix-angle"]), "cos 0°"),
        "dynamic-factor": Step(factor, "1 + (V/35.9 m/s)², V at eq. 1.1's module", ("H3",)),
        "centre-distance": Step(0.5 * pinion["module"] * (pinion["teeth"] + mate["teeth"]), "m_n (N_1 + N_2)/2"),
    }
    known = Known({**steps, **of_part("bevel-pinion", computed)}, "bevel-pinion")
    return of_part(
        "bevel-pinion",
        {**computed, **_modules(steps, pinion, gear, factor), **_dimensions(known, pinion["module"], pinion)},
    )


def bevel_wheel(steps: Steps) -> dict[str, Step]:
    """Return the data, modules and dimensions of the bevel wheel.

    Args:
        steps: Known so far.
    """
    wheel, pinion = Known(steps, "bevel-wheel"), Known(steps, "bevel-pinion")
    ratio = wheel["teeth-whole"] / pinion["teeth"]
    gear = _gear(wheel, pinion["torque"] * ratio, pinion["form-factor"])
    computed = {
        "dynamic-factor": pinion.step("dynamic-factor").again("for the pinion"),
        "speed": Step(pinion["speed"] / ratio, "n_p N_1/N_2"),
        "torque": Step(gear.torque, "T_2 N_2/N_1: 43/17, where i = 2.5 stands beside it", ("H5",)),
        "form-factor": pinion.step("form-factor").again("for the pinion"),
        "cos-helix": Step(math.cos(wheel["helix-angle"]), "cos 0°"),
        "teeth-exact": Step(wheel["ratio"] * pinion["teeth"], "i N_1"),
        "ratio-new": Step(ratio, "N_2/N_1"),
    }
    known = Known({**steps, **of_part("bevel-wheel", computed)}, "bevel-wheel")
    sized = _modules(steps, wheel, gear, pinion["dynamic-factor"])
    return of_part("bevel-wheel", {**computed, **sized, **_dimensions(known, pinion["module"], wheel)})


def _gear(stated: Known, torque: float, form_factor: float) -> ReportGear:
    """Return what eqs 1.1 and 1.2 take."""
    return ReportGear(
        torque,
        round(stated["teeth"]),
        stated["ratio"],
        form_factor,
        stated["contact-ratio"],
        stated["helix-angle"],
        stated["width-ratio"],
        stated["application-factor"],
    )


def _modules(steps: Steps, stated: Known, gear: ReportGear, factor: float) -> dict[str, Step]:
    """Return the modules of eqs 1.1 and 1.2, with K_v as it is printed."""
    printed, modulus = typed(factor, 4), Known(steps, "material")["elastic-modulus"]
    pitting = pitting_module(
        gear, Reading.EXECUTED, dynamic_factor=printed, allowable=stated["contact-strength"], elastic_modulus=modulus
    )
    fracture = fracture_module(gear, dynamic_factor=printed, allowable=stated["bending-strength"])
    return {
        "pitting-module": Step(pitting, "eq. 1.2 with ε_α below the line", ("H2", "H5")),
        "fracture-module": Step(fracture, "eq. 1.1", ("H5",)),
    }


def _dimensions(turning: Known, module: float, stated: Known) -> dict[str, Step]:
    """Return diameters, width and pitch-line velocity."""
    tip, root, pitch = report_diameters(module, round(turning["teeth"]), stated["helix-angle"])
    return {
        "tip-diameter": Step(tip, "eq. 1.3: m_n (N/cos β + 2)"),
        "root-diameter": Step(root, "eq. 1.4: m_n (N/cos β − 2.4)"),
        "pitch-diameter": Step(pitch, "eq. 1.5: m_n N/cos β"),
        "face-width": Step(report_width(module, stated["width-ratio"]), "eq. 1.6: ψ π m_n"),
        "velocity": Step(0.5 * turning["speed"] * pitch, "π d n/60"),
    }


# ----------------------------------------------------------------------------------------------------------------------
# The shafts of the Colibri report, number by number: forces, reactions, moments, diameters.
#
# Signs are the report's: on shafts 1 and 2 the gear stands in the middle between the bearings A and B; on the rotor
# shaft it hangs beyond B, at the end of the whole length. Wrong steps are made on purpose: `correct` has the
# right ones.
# ----------------------------------------------------------------------------------------------------------------------


STRAIGHT = ("shaft-1", "shaft-2")
"""Shafts whose gear stands between the bearings."""
_MILLI = 1e-3
_SLIP = 0.001 * _MILLI
"""What T_3 grew by when it was typed again, …7454 to …7464 [N m] (H5)."""

_BETWEEN = (
    "F_r/2 − F_a d/(2 L)", "F_t/2", "0: bearing A bears the thrust", "F_a", "F_r/2 + F_a d/(2 L)", "F_t/2",
)  # fmt: skip
_HANGING = (
    "(W_r L − W_a d_g/2)/l", "W_t L/l", "W_a", "0: bearing B bears the thrust", "W_r − B_y", "W_t − B_z",
)  # fmt: skip
_MIDDLE = ("A_y L/2", "B_y L/2", "A_z L/2", "B_z L/2")
_AT_BEARING = (*2 * ("A_y l: at bearing B",), *2 * ("A_z l: at bearing B",))


@dataclass(frozen=True)
class GearShaft:
    """A shaft on two bearings that carries one gear."""

    forces: ReportForces
    """On the gear [N]."""
    radius: float
    """Lever of the axial force [m]."""
    gear: float
    """Place of the gear from bearing A [m]."""
    span: float
    """From bearing A to bearing B [m]."""

    @property
    def load(self) -> PointLoads:
        """Radial and tangential force, in the planes y and z [N, N m]."""
        force = np.array([[-self.forces.radial], [-self.forces.tangential]])
        couple = np.array([[self.forces.axial * self.radius], [0.0]])
        return PointLoads(np.array([self.gear]), force, couple, np.zeros((2, 1)))

    def reactions(self) -> tuple[float, float, float, float]:
        """Return the bearings' forces A_y, B_y, A_z, B_z [N]."""
        a_y, b_y, a_z, b_z = bearing_reactions(self.load, [0.0, self.span]).ravel()
        return float(a_y), float(b_y), float(a_z), float(b_z)

    def moments_at(self, place: float) -> tuple[float, float, float, float]:
        """Return the bending moments M_z before and after a place, and M_y before and after it [N m].

        Args:
            place: Of the gear or a bearing, from bearing A [m].
        """
        bent = diagram(supported(self.load, [0.0, self.span], length=max(self.gear, self.span)))
        (here,) = np.nonzero(np.isclose(bent.position, place, rtol=0.0, atol=1e-12))
        z_before, z_after, y_before, y_after = bent.bending[:, here[[0, -1]]].ravel()
        return float(z_before), float(z_after), float(y_before), float(y_after)


def straight_shafts(steps: Steps) -> dict[str, Step]:
    """Return torque, diameter, angles and tooth forces of shafts 1 and 2.

    Args:
        steps: Known so far.
    """
    helical, bevel = Known(steps, "helical-pinion"), Known(steps, "bevel-pinion")
    first = {
        "torque": Step(typed(helical["torque"], 4, _MILLI), "as table 1.1, of four decimals", ("H1", "H5")),
        "diameter": Step(
            typed(helical["pitch-diameter"], 3, _MILLI), "d_p of the helical pinion, of three decimals", ("H5",)
        ),
    }
    second = {
        "torque": bevel.step("torque").again("for the bevel pinion"),
        "diameter": Step(bevel["pitch-diameter"], "outer d_p of the bevel pinion alone"),
    }
    parts = (first | _helical(steps, "shaft-1", first), second | _helical(steps, "shaft-2", second))
    return {key: step for part, of in zip(STRAIGHT, parts, strict=True) for key, step in of_part(part, of).items()}


def rotor_shaft(steps: Steps) -> dict[str, Step]:
    """Return torque, cone angles and tooth forces of the rotor shaft.

    Args:
        steps: Known so far.
    """
    shaft, alpha = Known(steps, "rotor-shaft"), Known(steps, "shaft-1")["pressure-angle"]
    torque = typed(Known(steps, "bevel-wheel")["torque"], 4, _MILLI) + _SLIP
    wheel = math.atan(shaft["ratio"])
    pinion = 0.5 * math.pi - wheel
    forces = bevel_forces_colibri(torque, shaft["wheel-diameter"], pressure_angle=alpha, pitch_angle=wheel)
    computed = {
        "torque": Step(torque, "T_3 with …7454 typed as …7464", ("H5",)),
        "tan-pressure": Step(math.tan(alpha), "tan 20°"),
        "wheel-angle": Step(wheel, "arctan i"),
        "pinion-angle": Step(pinion, "90° − Γ"),
        "sin-pinion": Step(math.sin(pinion), "sin γ"),
        "cos-pinion": Step(math.cos(pinion), "cos γ"),
        "sin-wheel": Step(math.sin(wheel), "sin Γ"),
        "cos-wheel": Step(math.cos(wheel), "cos Γ"),
        "tangential": Step(forces.tangential, "2 T/d_g"),
        "radial": Step(forces.radial, "W_t tan Φ cos Γ"),
        "axial": Step(forces.axial, "W_t tan Φ sin Γ"),
    }
    return of_part("rotor-shaft", computed)


def reactions(steps: Steps) -> dict[str, Step]:
    """Return what the bearings give, and the moments, of all three shafts.

    Args:
        steps: Known so far.
    """
    computed: dict[str, Step] = {}
    for part in STRAIGHT:
        held = straight_shaft(steps, part)
        held_up = _held(held, (held.forces.axial, 0.0), _BETWEEN)
        computed |= of_part(part, held_up | _moments(held, held.gear, _MIDDLE))
    held = hanging_shaft(steps)
    held_up = _held(held, (0.0, held.forces.axial), _HANGING, "H8")
    return computed | of_part("rotor-shaft", held_up | _moments(held, held.span, _AT_BEARING))


def diameters(steps: Steps) -> dict[str, Step]:
    """Return the diameters that bending alone asks for.

    Args:
        steps: Known so far.
    """
    computed: dict[str, Step] = {}
    for part in (*STRAIGHT, "rotor-shaft"):
        shaft = Known(steps, part)
        bending = math.hypot(shaft["moment-z-from-a"], shaft["moment-y-from-a"])
        smallest = shaft_diameter(bending, 0.0, shaft["bending-strength"])
        how = "∛(32 √(M_z² + M_y²)/(π σ_eg)), without torque"
        computed |= of_part(
            part, {"stress": Step(shaft["bending-strength"], "set to σ_em"), "minimum-diameter": Step(smallest, how)}
        )
    return computed


def straight_shaft(steps: Steps, part: str) -> GearShaft:
    """Return shaft 1 or 2 as the report holds it.

    Args:
        steps: Known so far.
        part: ``shaft-1`` or ``shaft-2``.
    """
    shaft = Known(steps, part)
    forces = ReportForces(shaft["tangential"], shaft["radial"], shaft["axial"], shaft["normal"])
    return GearShaft(forces, 0.5 * shaft["diameter"], 0.5 * shaft["length"], shaft["length"])


def hanging_shaft(steps: Steps) -> GearShaft:
    """Return the rotor shaft as the report holds it (H8).

    Args:
        steps: Known so far.
    """
    shaft = Known(steps, "rotor-shaft")
    forces = ReportForces(shaft["tangential"], shaft["radial"], shaft["axial"], math.nan)
    return GearShaft(forces, 0.5 * shaft["wheel-diameter"], shaft["length"], shaft["span"])


def _helical(steps: Steps, part: str, settled: Steps) -> dict[str, Step]:
    """Return sines, cosines and tooth forces by the formulas of helical gears."""
    shaft = Known(steps, part)
    alpha, beta = shaft["pressure-angle"], shaft["helix-angle"]
    torque, diameter = settled["torque"].value, settled["diameter"].value
    forces = helical_forces_colibri(torque, diameter, pressure_angle=alpha, helix_angle=beta)
    return {
        "cos-helix": Step(math.cos(beta), "cos β"),
        "sin-helix": Step(math.sin(beta), "sin β"),
        "sin-pressure": Step(math.sin(alpha), "sin α"),
        "cos-pressure": Step(math.cos(alpha), "cos α"),
        "tangential": Step(forces.tangential, "2 M_d/d"),
        "normal": Step(forces.normal, "F_t/(cos α cos β)"),
        "radial": Step(forces.radial, "F_t sin α/(cos α cos β)"),
        "axial": Step(forces.axial, "F_t cos α sin β/(cos α cos β)"),
    }


def _held(held: GearShaft, thrust: tuple[float, float], how: Sequence[str], *assumed: str) -> dict[str, Step]:
    """Return the six reactions; `thrust` is what A and B bear of the axial force."""
    a_y, b_y, a_z, b_z = held.reactions()
    names = ("by", "bz", "bx", "ax", "ay", "az")
    values = (b_y, b_z, thrust[1], thrust[0], a_y, a_z)
    return {f"reaction-{name}": Step(value, by, assumed) for name, value, by in zip(names, values, how, strict=True)}


def _moments(held: GearShaft, place: float, how: tuple[str, str, str, str]) -> dict[str, Step]:
    """Return the four moments that the report has for a shaft."""
    names = ("moment-z-from-a", "moment-z-from-b", "moment-y-from-a", "moment-y-from-b")
    return {name: Step(value, by) for name, value, by in zip(names, held.moments_at(place), how, strict=True)}


# ----------------------------------------------------------------------------------------------------------------------
# The bearings and keys of the Colibri report, number by number, by its own steps, the wrong ones on purpose.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The whole Colibri report computed: its stated inputs, then part after part, each reading what came before.
# ----------------------------------------------------------------------------------------------------------------------


_PARTS: tuple[Callable[[Steps], Mapping[str, Step]], ...] = (
    requirement, helical_pinion, helical_wheel, bevel_pinion, bevel_wheel, straight_shafts, rotor_shaft, reactions,
    diameters, bearings, keys,
)  # fmt: skip


@cache
def executed() -> Steps:
    """Return every number of the report as its own steps give it, in SI."""
    steps = stated_steps()
    for part in _PARTS:
        steps |= part(MappingProxyType(steps))
    return MappingProxyType(steps)
