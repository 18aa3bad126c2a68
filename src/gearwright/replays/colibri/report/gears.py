"""The gears of the Colibri report, number by number, from its stated inputs and by its own steps.

Every function computes one part and reads those before it. Wrong steps are made on purpose: `correct` has the
right ones.
"""

from __future__ import annotations

import math

from gearwright.replays.colibri.report.formulas import (
    Reading,
    ReportGear,
    form_factor_colibri,
    fracture_module,
    pitting_module,
    report_diameters,
    report_width,
    settled_dynamic_factor,
)
from gearwright.replays.colibri.report.shaft_formulas import report_torque
from gearwright.replays.colibri.report.steps import Known, Step, Steps, of_part, typed

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
