"""Numbers that the reasons of the Colibri replay quote, each computed, in the units that the reasons write."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from gearwright.catalogue import bearings, key_for_shaft
from gearwright.parts.bearings import BearingKind
from gearwright.replays.colibri.report.bearings import axial_share, relative_axial, thrust
from gearwright.replays.colibri.report.chain import executed
from gearwright.replays.colibri.report.formulas import Reading, ReportForces, ReportGear, pitting_module
from gearwright.replays.colibri.report.shafts import hanging_shaft, straight_shaft
from gearwright.replays.colibri.report.steps import Known
from gearwright.replays.colibri.verdicts.bevel import bevel_pair, bevel_safeties, mean_cone_forces, module_for
from gearwright.replays.colibri.verdicts.correct import SHAFTS, bearings_of_size, true_factors, twisted_diameter
from gearwright.replays.colibri.verdicts.findings import bearing_life, flank_pressure
from gearwright.units import shown

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
