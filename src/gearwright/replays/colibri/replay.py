"""The Colibri report compared number by number with its own computation, and its tables."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache
from itertools import groupby
from types import MappingProxyType

from rich.console import Group
from rich.text import Text

from gearwright.base import shown, text, unit
from gearwright.catalogue import Bearing, bearings, bearings as catalogue_bearings, gear_steel, key_for_shaft
from gearwright.parts.bearings import (
    ISO_R281_1962,
    BearingKind,
    LoadFactors,
    basic_life,
    deep_groove_factors,
    equivalent_load,
    life_time,
    system_life,
)
from gearwright.parts.bevel_geometry import WIDEST, WIDEST_MODULES, BevelForces, BevelPair, Hand, Rotation, bevel_forces
from gearwright.parts.gears import CylindricalGear
from gearwright.parts.iso6336 import LoadedTooth, ToothProportions, root_section
from gearwright.parts.iso10300 import BevelDuty, VirtualPair, bevel_bending, bevel_load_factors, bevel_pitting
from gearwright.parts.shaft_fatigue import SectionLoad, section_stress
from gearwright.parts.shafts import key_length, key_pressure
from gearwright.render.terminal import Grid
from gearwright.replays.colibri.formulas import Reading, ReportForces, ReportGear, pitting_module
from gearwright.replays.colibri.report import (
    Assumption,
    ColibriErratum,
    Known,
    PrintedNumber,
    Step,
    assumptions,
    axial_share,
    colibri_errata,
    executed,
    hanging_shaft,
    key_section,
    of_part,
    printed_numbers,
    radial_force,
    relative_axial,
    straight_shaft,
    thrust,
)

# ----------------------------------------------------------------------------------------------------------------------
# Correct values and design findings for the EC120B "Colibri" report, with reasons.
#
# The report's own numbers are in `report`.
# ----------------------------------------------------------------------------------------------------------------------


# ----------------------------------------------------------------------------------------------------------------------
# What the bevel pair of the Colibri report is when it is treated as a bevel pair: mean cone, forces, ISO 10300.
# ----------------------------------------------------------------------------------------------------------------------


CONTACT_SAFETY, ROOT_SAFETY = 1.2, 1.6
"""S_H and S_F that a gear of an aircraft is given here [-]."""
_PITCH_DEVIATION = 10e-6
"""f_pt of ground bevel gears of this size [m]; it moves the module by under 1 %."""
_HARDNESS = 700.0
_FINE = 1e-3


def bevel_pair(module: float | None = None) -> BevelPair:
    """Return the report's straight pair with the widest face that its cone allows.

    Args:
        module: Outer transverse module [m]; None: the report's.

    Source: ISO 23509:2016, annex B: b ≤ R_e/3 and b ≤ 10 m_et.
    """
    steps = executed()
    teeth = round(steps["bevel-pinion.teeth"].value), round(steps["bevel-wheel.teeth-whole"].value)
    outer = steps["bevel-pinion.module"].value if module is None else module
    narrow = BevelPair(teeth, outer, _FINE * outer)
    return replace(narrow, face_width=min(WIDEST * narrow.outer_cone_distance, WIDEST_MODULES * outer))


def mean_cone_forces() -> BevelForces:
    """Return the forces of the report's pair at its mean cone [N]; straight teeth push alike in both directions."""
    torque = executed()["bevel-pinion.torque"].value
    return bevel_forces(bevel_pair(), torque, hand=Hand.LEFT, rotation=Rotation.CLOCKWISE)


def form_factor(virtual_teeth: float) -> float:
    """Return the report's γ for any number of teeth, π cos α Y_Fa [-].

    Args:
        virtual_teeth: Of the equivalent spur gear [-].

    Source: H9 with Y_F of ISO 6336-3 under load at the tip, rack 1.25/0.38.

    >>> round(form_factor(60 / math.cos(math.radians(15.0)) ** 3), 2)
    6.68
    """
    alpha = math.radians(20.0)
    tooth = LoadedTooth(virtual_teeth, virtual_teeth + 2.0, alpha, ToothProportions())
    return math.pi * math.cos(alpha) * float(root_section(tooth).form)


@cache
def bevel_safeties(module: float | None = None) -> tuple[float, float]:
    """Return the lesser S_H and S_F of the pair by ISO 10300, for unlimited life at the report's torque [-].

    Args:
        module: Outer transverse module [m]; None: the report's.

    Source: ISO 10300-1, -2, -3:2023, method B1; case-hardened steel MQ with a core of 30 HRC, K_A = 1.
    """
    virtual, steps = VirtualPair(bevel_pair(module)), executed()
    steel = gear_steel("case-hardened-core-30", "MQ", _HARDNESS)
    duty = BevelDuty(steps["bevel-pinion.torque"].value, steps["bevel-pinion.speed"].value, _PITCH_DEVIATION)
    loads, _ = bevel_load_factors(virtual, duty, (steel, steel))
    flanks = bevel_pitting(virtual, (steel, steel), duty, loads=loads, lives=(1.0, 1.0))
    roots = [bevel_bending(virtual, gear, steel, duty=duty, loads=loads, life=1.0).safety for gear in (0, 1)]
    return min(flanks.safeties), min(roots)


def module_for(safety: int) -> float:
    """Return the outer module at which the pair reaches its safety [m].

    Args:
        safety: 0 for S_H, 1 for S_F.
    """
    low, high = 4e-3, 20e-3
    asked = (CONTACT_SAFETY, ROOT_SAFETY)[safety]
    while high - low > 1e-7:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if bevel_safeties(middle)[safety] >= asked else (middle, high)
    return high


# ----------------------------------------------------------------------------------------------------------------------
# The right values of the numbers that are wrong in the Colibri report, by gearwright's own parts.
#
# Each corrects the mistake of its own step and keeps what the report has before it, so that one error shows at a time.
# ----------------------------------------------------------------------------------------------------------------------


SHAFTS = ("shaft-1", "shaft-2", "rotor-shaft")
KEY_PRESSURE = 150e6
"""Pressure that a key of C45 in a hub of steel bears under a torque that swells [Pa] (DIN 6892, usual)."""
_CLEARANCE_DEDENDUM = 1.2
"""Dedendum of eq. 1.4 over the module [-]."""


@cache
def correct_values() -> Mapping[str, Step]:
    """Return the right value of every wrong number that has one, in SI."""
    values: dict[str, Step] = {}
    for part in (_gears, _cones, _forces, _rotor_moments, _shaft_diameters, _bearing_loads, _right_keys):
        values |= part()
    return MappingProxyType(values)


def twisted_diameter(part: str) -> float:
    """Return the diameter of a shaft under the report's moments and its torque by von Mises [m].

    Args:
        part: Shaft.
    """
    shaft = Known(executed(), part)
    bending = math.hypot(shaft["moment-z-from-a"], shaft["moment-y-from-a"])
    load = SectionLoad(bending_amplitude=bending, torque_mean=shaft["torque"])
    return math.cbrt(section_stress(load, 1.0).greatest / shaft["bending-strength"])


def true_load(part: str) -> float:
    """Return the equivalent load of the bearing that the report checks [N].

    Args:
        part: Shaft.

    Source: ISO 281, X F_r + Y F_a, with the factors of ISO/R 281 that the report has.
    """
    steps = executed()
    return equivalent_load(radial_force(steps, part), thrust(steps, part), true_factors(part))


def true_factors(part: str) -> LoadFactors:
    """Return e, X and Y of that bearing, read at F_a/C_0 [-].

    Args:
        part: Shaft.
    """
    return deep_groove_factors(relative_axial(executed(), part), ISO_R281_1962)


def bearings_of_size(outer: float, width: float) -> tuple[Bearing, ...]:
    """Return the deep groove bearings of ISO 15 with an outer diameter and a width.

    Args:
        outer: D [m].
        width: B [m].
    """
    return tuple(
        bearing
        for bearing in catalogue_bearings().values()
        if bearing.kind is BearingKind.DEEP_GROOVE
        and math.isclose(bearing.outer_diameter, outer)
        and math.isclose(bearing.width, width)
    )


def _gears() -> dict[str, Step]:
    wheel, pair = Known(executed(), "helical-wheel"), bevel_pair()
    helical = form_factor(wheel["teeth"] / math.cos(wheel["helix-angle"]) ** 3)
    virtual = pair.teeth[1] / math.cos(pair.pitch_angles[1])
    flank, root = (
        Step(module_for(safety), f"ISO 10300, {name}") for safety, name in enumerate(("S_H = 1.2", "S_F = 1.6"))
    )
    return {
        "helical-wheel.form-factor": Step(helical, "π cos α Y_Fa at 66.6 teeth"),
        "bevel-wheel.form-factor": Step(form_factor(virtual), "π cos α Y_Fa at 117 teeth"),
        **{f"{part}.pitting-module": flank for part in ("bevel-pinion", "bevel-wheel")},
        **{f"{part}.fracture-module": root for part in ("bevel-pinion", "bevel-wheel")},
    }


def _cones() -> dict[str, Step]:
    pair = bevel_pair()
    width = Step(pair.face_width, "min(R_e/3, 10 m_et)")
    steps = {"bevel-pinion.centre-distance": Step(pair.outer_cone_distance, "cone distance R_e")}
    for gear, part in enumerate(("bevel-pinion", "bevel-wheel")):
        pitch, radial = pair.outer_diameters[gear], 2.0 * pair.outer_module * math.cos(pair.pitch_angles[gear])
        steps |= of_part(
            part,
            {
                "tip-diameter": Step(pitch + radial, "d_e + 2 m cos δ"),
                "root-diameter": Step(pitch - _CLEARANCE_DEDENDUM * radial, "d_e − 2.4 m cos δ"),
                "face-width": width,
            },
        )
    return steps


def _forces() -> dict[str, Step]:
    pair, forces = bevel_pair(), mean_cone_forces()
    second = {
        "diameter": Step(pair.mean_diameters[0], "d_m1 at b = R_e/3"),
        "tangential": Step(forces.tangential, "2 T_2/d_m1"),
        "normal": Step(forces.tangential / math.cos(pair.pressure_angle), "F_t/cos α"),
        "radial": Step(forces.radial[0], "F_t tan α cos δ_1"),
        "axial": Step(forces.axial[0], "F_t tan α sin δ_1"),
    }
    rotor = {
        "pinion-diameter": Step(pair.outer_diameters[0], "17 teeth of 4 mm"),
        "wheel-diameter": Step(pair.outer_diameters[1], "43 teeth of 4 mm"),
        "wheel-angle": Step(pair.pitch_angles[1], "arctan 43/17"),
        "pinion-angle": Step(pair.pitch_angles[0], "arctan 17/43"),
        "tangential": Step(forces.tangential, "2 T_3/d_m2"),
        "radial": Step(forces.radial[1], "W_t tan α cos δ_2"),
        "axial": Step(forces.axial[1], "W_t tan α sin δ_2"),
    }
    return of_part("shaft-2", second) | of_part("rotor-shaft", rotor)


def _rotor_moments() -> dict[str, Step]:
    held = hanging_shaft(executed())
    z, _, y, _ = held.moments_at(held.gear)
    free = abs(round(y, 6))
    names = {"z": Step(z, "at the gear: W_a d_g/2"), "y": Step(free, "at the gear: the shaft's free end")}
    return {f"rotor-shaft.moment-{axis}-from-{end}": step for axis, step in names.items() for end in "ab"}


def _shaft_diameters() -> dict[str, Step]:
    return {f"{part}.minimum-diameter": Step(twisted_diameter(part), "von Mises, M and T") for part in SHAFTS}


def _bearing_loads() -> dict[str, Step]:
    steps = executed()
    shaft, radial = Known(steps, "shaft-2"), radial_force(steps, "rotor-shaft")
    fitting = min(bearings_of_size(shaft["bearing-outer"], shaft["bearing-width"]), key=lambda bearing: bearing.bore)
    return {
        "shaft-1.axial-factor": Step(true_factors("shaft-1").axial, "ISO/R 281 at F_a/C_0"),
        "shaft-1.equivalent-load": Step(true_load("shaft-1"), "X F_r + Y F_a"),
        "shaft-2.equivalent-load": Step(true_load("shaft-2"), "X F_r + Y F_a"),
        "shaft-2.bearing-bore": Step(fitting.bore, f"ISO 15, {fitting.designation}, a 64 as the others"),
        "rotor-shaft.bearing-radial": Step(radial, "√(B_y² + B_z²)"),
        "rotor-shaft.axial-share": Step(thrust(steps, "rotor-shaft") / radial, "B_x/F_r"),
        "rotor-shaft.equivalent-load": Step(true_load("rotor-shaft"), "F_r, as F_a/F_r < e"),
    }


def _right_keys() -> dict[str, Step]:
    steps = {}
    for part in SHAFTS:
        shaft = Known(executed(), part)
        diameter = shaft["key-shaft-diameter"]
        flank = key_length(shaft["torque"], diameter, key_for_shaft(diameter).section, allowable=KEY_PRESSURE)
        steps[f"{part}.key-length"] = Step(flank, "DIN 6892 at 150 MPa")
    return steps


# ----------------------------------------------------------------------------------------------------------------------
# Whether what the Colibri report designs can be made and would last: each check with its value and its limit.
# ----------------------------------------------------------------------------------------------------------------------


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
    return (*_bevel_geometry(), *_helical_geometry(), *_shafts(), *_bearings(), *_key_findings(), *_strength())


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


def _key_findings() -> tuple[Finding, ...]:
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


# ----------------------------------------------------------------------------------------------------------------------
# Numbers that the reasons of the Colibri replay quote, each computed, in the units that the reasons write.
# ----------------------------------------------------------------------------------------------------------------------


_HOUR = 3600.0


def colibri_facts() -> Mapping[str, float | str]:
    """Return name -> number or words for the braces in the report's notes."""
    return {**_gear_facts(), **_force_facts(), **_bearing_facts(), **_key_facts(), **_shaft_facts()}


def _mm(value: float) -> float:
    return shown(value, "length")


def _gear_facts() -> dict[str, float | str]:
    pair, steps = bevel_pair(), executed()
    contact, root = bevel_safeties()
    return {
        "pitting_helical": _mm(_as_printed("helical-pinion")),
        "pitting_bevel": _mm(_as_printed("bevel-pinion")),
        "virtual_pinion": pair.teeth[0] / math.cos(pair.pitch_angles[0]),
        "face_limit": _mm(pair.face_width),
        "face": _mm(steps["bevel-pinion.face-width"].value),
        "cone": _mm(pair.outer_cone_distance),
        "bevel_contact": contact,
        "bevel_root": root,
        "module_contact": _mm(module_for(0)),
        "module_root": _mm(module_for(1)),
        "wheel_diameter": _mm(steps["helical-wheel.pitch-diameter"].value),
    }


def _as_printed(part: str) -> float:
    """Return the module of eq. 1.2 as it is printed [m]."""
    stated = Known(executed(), part)
    gear = ReportGear(
        stated["torque"],
        round(stated["teeth"]),
        stated["ratio"],
        stated["form-factor"],
        stated["contact-ratio"],
        stated["helix-angle"],
    )
    return pitting_module(
        gear,
        Reading.PRINTED,
        dynamic_factor=round(stated["dynamic-factor"], 4),
        allowable=stated["contact-strength"],
        elastic_modulus=executed()["material.elastic-modulus"].value,
    )


def _force_facts() -> dict[str, float | str]:
    steps, right = executed(), mean_cone_forces()
    held = straight_shaft(steps, "shaft-2")
    forces = ReportForces(right.tangential, right.radial[0], right.axial[0], math.nan)
    second = replace(held, forces=forces, radius=0.5 * bevel_pair().mean_diameters[0])
    hanging = hanging_shaft(steps)
    mirrored = replace(hanging, forces=replace(hanging.forces, axial=-hanging.forces.axial))
    return {
        "wheel_force": steps["shaft-1.tangential"].value,
        "second_az": second.reactions()[2],
        "second_my": second.moments_at(second.gear)[2] / 1e-3,
        "force_ratio": right.tangential / steps["rotor-shaft.tangential"].value,
        "other_apex": mirrored.reactions()[1],
    }


def _bearing_facts() -> dict[str, float | str]:
    steps = executed()
    shaft = Known(steps, "shaft-2")
    fitting = bearings_of_size(shaft["bearing-outer"], shaft["bearing-width"])
    balls = (bearing for bearing in bearings().values() if bearing.kind is BearingKind.DEEP_GROOVE)
    bored = [ball for ball in balls if math.isclose(ball.bore, shaft["bearing-bore"])]
    facts: dict[str, float | str] = {
        "relative_1": relative_axial(steps, "shaft-1"),
        "share_1": axial_share(steps, "shaft-1"),
        "fitting": " and the ".join(f"{bearing.designation} (bore {_mm(bearing.bore):g} mm)" for bearing in fitting),
        "of_bore": ", ".join(
            f"{_mm(bearing.outer_diameter):g} × {_mm(bearing.width):g} ({bearing.designation})" for bearing in bored
        ),
    }
    for number, part in enumerate(SHAFTS, 1):
        factor = Known(steps, part)["axial-factor"]
        facts[f"life_{number}"] = bearing_life(part) / _HOUR
        facts[f"axial_term_{number}"] = factor * relative_axial(steps, part)
        facts[f"axial_force_{number}"] = true_factors(part).axial * thrust(steps, part)
    return facts


def _key_facts() -> dict[str, float | str]:
    facts: dict[str, float | str] = {}
    for number, part in enumerate(SHAFTS, 1):
        section = key_for_shaft(Known(executed(), part)["key-shaft-diameter"]).section
        facts[f"pressure_{number}"] = flank_pressure(part) / 1e9
        facts[f"depth_{number}"] = _mm(section.shaft_depth + section.hub_depth)
    return facts


def _shaft_facts() -> dict[str, float | str]:
    return {f"twisted_{number}": _mm(twisted_diameter(part)) for number, part in enumerate(SHAFTS, 1)}


# ----------------------------------------------------------------------------------------------------------------------
# The Colibri report held against its own computation: 236 numbers, each with verdict, right value and reason.
# ----------------------------------------------------------------------------------------------------------------------


class Outcome(StrEnum):
    """What becomes of a printed number."""

    INPUT = "input"
    REPRODUCED = "reproduced"
    HIDDEN = "reproduced with a hidden assumption"
    WRONG = "wrong in source"


@dataclass(frozen=True)
class Replayed:
    """One number of the report, printed and computed."""

    printed: PrintedNumber
    """As it stands there."""
    computed: Step
    """By the report's own steps, mistakes included."""
    correct: Step | None
    """What is right, where that differs and can be said."""
    erratum: ColibriErratum | None
    """The mistake of its own step, if there is one."""

    @property
    def relative(self) -> float:
        """(computed − printed)/printed; the difference itself where 0 is printed [-]."""
        difference = self.computed.value - self.printed.value
        return difference / self.printed.value if self.printed.value else difference

    @property
    def outcome(self) -> Outcome:
        """A mistake outweighs an assumption, and an assumption a mere computation."""
        if self.erratum is not None:
            return Outcome.WRONG
        if self.printed.is_stated:
            return Outcome.INPUT
        return Outcome.HIDDEN if self.computed.assumptions else Outcome.REPRODUCED


@dataclass(frozen=True)
class ColibriReplay:
    """The whole report, computed."""

    numbers: tuple[Replayed, ...]
    """In its order."""
    findings: tuple[Finding, ...]
    """Whether what it designs can be made and would last."""
    errata: tuple[ColibriErratum, ...]
    """Its mistakes, with numbers filled in."""
    assumptions: Mapping[str, Assumption]
    """What it does not say, with numbers filled in."""

    def count(self, outcome: Outcome) -> int:
        """Return how many numbers have an outcome.

        Args:
            outcome: Which.
        """
        return sum(number.outcome is outcome for number in self.numbers)


@cache
def replay() -> ColibriReplay:
    """Return the report computed from its stated inputs; takes some hundredths of a second."""
    facts, steps, right = colibri_facts(), executed(), correct_values()
    errata = tuple(replace(one, why=one.why.format(**facts)) for one in colibri_errata())
    wrong = {row: one for one in errata for row in one.rows}
    numbers = tuple(
        Replayed(number, steps[number.key], right.get(number.key), wrong.get(number.key))
        for number in printed_numbers()
    )
    hidden = {
        key: replace(assumption, evidence=assumption.evidence.format(**facts))
        for key, assumption in assumptions().items()
    }
    return ColibriReplay(numbers, findings(), errata, hidden)


# ----------------------------------------------------------------------------------------------------------------------
# The Colibri replay in words: how its numbers are written, and tables for the terminal.
# ----------------------------------------------------------------------------------------------------------------------


PARTS = {
    "requirement": "Requirement", "material": "Material", "helical-pinion": "Helical pinion",
    "helical-wheel": "Helical wheel", "bevel-pinion": "Bevel pinion", "bevel-wheel": "Bevel wheel",
    "shaft-1": "Shaft 1, the engine's", "shaft-2": "Shaft 2, between the stages", "rotor-shaft": "Rotor shaft",
}  # fmt: skip
"""First half of the keys -> title, in the report's order."""
_STYLES = {Outcome.INPUT: "dim", Outcome.REPRODUCED: "", Outcome.HIDDEN: "yellow", Outcome.WRONG: "red"}
_SHORT = {Outcome.HIDDEN: "reproduced", Outcome.WRONG: "wrong"}
_DIGITS, _CORRECT_DIGITS = 10, 5
_EXACT = 5e-13
"""Relative difference below which only floating-point rounding is left [-]."""


def chosen(replayed: ColibriReplay, *, part: str = "", wrong: bool = False) -> tuple[Replayed, ...]:
    """Return the numbers of one part, or of all, and all or only the wrong ones.

    Args:
        replayed: Of `replay`.
        part: A key of `PARTS`; empty for all.
        wrong: Whether to leave out the others.
    """
    return tuple(
        number
        for number in replayed.numbers
        if (not part or number.printed.part == part) and (not wrong or number.outcome is Outcome.WRONG)
    )


def replay_tables(numbers: Sequence[Replayed], replayed: ColibriReplay) -> Group:
    """Return numbers for the terminal, a table for each part, then the reasons that they name.

    Args:
        numbers: Which to show.
        replayed: Of `replay`.
    """
    tables = [_table(part, list(rows)) for part, rows in groupby(numbers, lambda number: number.printed.part)]
    return Group(*tables, _reasons(numbers, replayed))


def findings_table(findings: Sequence[Finding]) -> Grid:
    """Return for the terminal what of the design cannot be made or would not last.

    Args:
        findings: Of `replay`.
    """
    table = Grid("Can it be made, and would it last?", spaced=True)
    for header in ("", "designed", "must be", "limit from"):
        table.add_column(header)
    for finding in findings:
        table.add_row(*map(Text, finding_cells(finding)), style="" if finding.holds else "red")
    return table


def finding_cells(finding: Finding) -> tuple[str, str, str, str]:
    """Return a finding as it is read: what, value, limit, source.

    Args:
        finding: With its numbers.
    """
    return (
        finding.what,
        _quantity(finding.value, finding),
        f"{finding.sense.value} {_quantity(finding.limit, finding)}",
        finding.source,
    )


def counts_text(replayed: ColibriReplay) -> str:
    """Return how many numbers are what, in one sentence.

    Args:
        replayed: Of `replay`.
    """
    parts = ", ".join(f"{replayed.count(outcome)} {outcome.value}" for outcome in Outcome)
    return f"{len(replayed.numbers)} printed numbers: {parts}."


def computed_text(number: Replayed) -> str:
    """Return what was computed, with the unit's digits.

    Args:
        number: Number.
    """
    return _signed(f"{number.computed.value / number.printed.scale:.{_DIGITS}g}")


def difference_text(number: Replayed) -> str:
    """Return the relative difference between computed and printed.

    Args:
        number: Number.
    """
    return "0" if abs(number.relative) < _EXACT else _signed(f"{number.relative:.1e}")


def correct_text(number: Replayed) -> str:
    """Return what is right in place of a wrong number; empty where nothing is wrong, a dash where it stays open.

    Args:
        number: Number.
    """
    if number.correct is None:
        return "–" if number.outcome is Outcome.WRONG else ""
    value = number.correct.value / number.printed.scale
    return _signed(f"{value:.0f}" if abs(value) >= 10.0 ** (_CORRECT_DIGITS - 1) else f"{value:.{_CORRECT_DIGITS}g}")


def reason_keys(number: Replayed) -> tuple[str, ...]:
    """Return the keys of the mistake and of the assumptions behind a number.

    Args:
        number: Number.
    """
    return (*([number.erratum.key] if number.erratum else []), *number.computed.assumptions)


def finding_in_unit(finding: Finding) -> tuple[str, float, str, float, str, str, bool]:
    """Return what a finding says: what, value, sense, limit, the unit of both, source, and whether it holds.

    Args:
        finding: With its numbers.
    """
    value, name = _in_unit(finding.value, finding)
    limit, _ = _in_unit(finding.limit, finding)
    return finding.what, value, finding.sense.value, limit, name, finding.source, finding.holds


def _table(part: str, rows: Sequence[Replayed]) -> Grid:
    table = Grid(PARTS[part])
    table.add_column("", no_wrap=True)
    table.add_column("unit")
    for header in ("printed", "computed", "difference"):
        table.add_column(header, justify="right")
    table.add_column("verdict")
    table.add_column("correct", justify="right")
    for place, numbers in groupby(rows, lambda number: number.printed.place):
        table.add_section()
        table.add_row(Text(place.rpartition(", ")[2], style="bold"))
        for number in numbers:
            table.add_row(*map(Text, _cells(number)), style=_STYLES[number.outcome])
    return table


def _cells(number: Replayed) -> Iterator[str]:
    verdict = _SHORT.get(number.outcome, number.outcome.value)
    yield from (number.printed.symbol, number.printed.unit, _signed(number.printed.printed), computed_text(number))
    yield from (difference_text(number), " ".join((verdict, *reason_keys(number))), correct_text(number))


def _reasons(numbers: Sequence[Replayed], replayed: ColibriReplay) -> Grid:
    named = {key for number in numbers for key in reason_keys(number)}
    table = Grid("Reasons", show_header=False, spaced=True)
    table.add_column("")
    table.add_column("")
    for mistake in replayed.errata:
        if mistake.key in named:
            table.add_row(Text(mistake.key, style="red"), Text(f"{mistake.title}. {mistake.why}"))
    for assumption in replayed.assumptions.values():
        if assumption.key in named:
            table.add_row(Text(assumption.key, style="yellow"), Text(f"{assumption.text} {assumption.evidence}"))
    return table


def _quantity(value: float, finding: Finding) -> str:
    if finding.dimension == "time":
        number, name = _in_unit(value, finding)
        return f"{number:.0f} {name}"
    return text(value, finding.dimension)


def _in_unit(value: float, finding: Finding) -> tuple[float, str]:
    """Return a value and its unit; lives are in hours."""
    if finding.dimension == "time":
        return value / _HOUR, "h"
    return shown(value, finding.dimension), unit(finding.dimension)


def _signed(number: str) -> str:
    return number.replace("-", "−")
