"""The right values of the numbers that are wrong in the Colibri report, by gearwright's own parts.

Each corrects the mistake of its own step and keeps what the report has before it, so that one error shows at a time.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

from gearwright.catalogue import Bearing, key_for_shaft
from gearwright.catalogue import bearings as catalogue_bearings
from gearwright.parts.bearings import ISO_R281_1962, BearingKind, LoadFactors, deep_groove_factors, equivalent_load
from gearwright.parts.joints import key_length
from gearwright.parts.shafts import SectionLoad, section_stress
from gearwright.replays.colibri.report.bearings import radial_force, relative_axial, thrust
from gearwright.replays.colibri.report.chain import executed
from gearwright.replays.colibri.report.shafts import hanging_shaft
from gearwright.replays.colibri.report.steps import Known, Step, of_part
from gearwright.replays.colibri.verdicts.bevel import bevel_pair, form_factor, mean_cone_forces, module_for

SHAFTS = ("shaft-1", "shaft-2", "rotor-shaft")
KEY_PRESSURE = 150e6
"""Pressure that a key of C45 in a hub of steel bears under a torque that swells [Pa] (DIN 6892, usual)."""
_CLEARANCE_DEDENDUM = 1.2
"""Dedendum of eq. 1.4 over the module [-]."""


@cache
def correct_values() -> Mapping[str, Step]:
    """Return the right value of every wrong number that has one, in SI."""
    values: dict[str, Step] = {}
    for part in (_gears, _cones, _forces, _rotor_moments, _shaft_diameters, _bearing_loads, _keys):
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


def _keys() -> dict[str, Step]:
    steps = {}
    for part in SHAFTS:
        shaft = Known(executed(), part)
        diameter = shaft["key-shaft-diameter"]
        flank = key_length(shaft["torque"], diameter, key_for_shaft(diameter).section, allowable=KEY_PRESSURE)
        steps[f"{part}.key-length"] = Step(flank, "DIN 6892 at 150 MPa")
    return steps
