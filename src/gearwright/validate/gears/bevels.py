"""Printed ratings of bevel gears: annex E of AGMA 2003, Shigley's examples, and the hypoid sample of ISO/TR 10300-30.

AGMA and Shigley read I and J from charts. The factors around them are held with the printed I and J; annex C, which the
charts were drawn by, is held with the charts.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from gearwright.base import FOOT, HORSEPOWER, INCH, POUND_FORCE, RPM
from gearwright.parts.agma2003 import (
    CROWNED,
    ONE_STRADDLE,
    OVERHUNG,
    UNCROWNED,
    AgmaBevelDuty,
    AgmaBevelFactors,
    AgmaBevelMaking,
    AgmaBevelRating,
    BevelEdition,
    BevelSteel,
    bevel_factors,
    bevel_geometry,
    bevel_strength,
    rate_with_factors,
)
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, bevel_blank
from gearwright.parts.iso6336 import (
    GearSteel,
    LoadedTooth,
    RootSection,
    ToothProportions,
    Treatment,
    notch_sensitivity_factor,
    root_section,
    surface_factor,
)
from gearwright.validate.case import Case

_PSI = POUND_FORCE / INCH**2
_MINUTE = 60.0
_PRINTED_ELASTIC = 2290.0 * math.sqrt(_PSI)
_EDGE, _CLEARANCE = 0.12, 0.188
"""Edge radius of the tool and clearance of Gleason's teeth over the outer module [-], on which the charts rest."""


def tapered(pair: BevelPair, addendum: float, depth: float) -> BevelPair:
    """Return a pair with teeth whose depth falls towards the apex, as the charts of AGMA 2003 have them.

    Args:
        pair: Its teeth, module, width and angles.
        addendum: Of the wheel at the outer end, over the outer module [-].
        depth: Working depth there, over the outer module [-].

    Source: ISO 23509:2016, standard taper: roots point to the apex, tips are parallel to the mate's root.
    """
    heads, drop = (depth - addendum, addendum), 0.5 * pair.face_width / pair.outer_cone_distance
    feet = (addendum + _CLEARANCE, depth - addendum + _CLEARANCE)
    tips = [head - drop * foot for head, foot in zip(heads, reversed(feet), strict=True)]
    unit = pair.outer_module / pair.mean_module
    half, shift = 0.5 * unit * sum(tips), 0.5 * unit * (tips[0] - tips[1])
    edges = (_EDGE * unit, _EDGE * unit)
    return replace(pair, tooth=BevelTooth(half, 0.5 * unit * sum(feet) * (1.0 - drop), shift, edge_radii=edges))


_ANNEX_E = tapered(BevelPair((14, 39), INCH / 5.6, INCH, math.radians(35.0)), 0.46 + 0.39 * (14.0 / 39.0) ** 2, 1.7)
_CHARTED_E = replace(_ANNEX_E, tooth=replace(_ANNEX_E.tooth, thickness_shifts=(0.028, -0.028)))
"""The chart's tooth thickness is not told; so much makes J_P/J_G the chart's."""
_MITER = tapered(BevelPair((25, 25), INCH / 5.0, 1.1 * INCH), 1.0, 2.0)
_THREE = tapered(BevelPair((20, 60), INCH / 8.0, 1.25 * INCH), 0.54 + 0.46 / 9.0, 2.0)


def _charted(
    pair: BevelPair, factors: AgmaBevelFactors, making: AgmaBevelMaking, chart: Sequence[float]
) -> AgmaBevelRating:
    """Return the rating with I, J_P and J_G as the source read them."""
    known = bevel_geometry(pair)
    first, second = (replace(root, factor=value) for root, value in zip(known.bending, chart[1:], strict=True))
    geometry = known._replace(pitting=replace(known.pitting, factor=chart[0]), bending=(first, second))
    return rate_with_factors(pair, factors, geometry, making.strengths)


# --- ANSI/AGMA 2003-D19, annex E: 14/39, 1440 lbf in at 1750 rpm --------------------------------------------------
_E_CHART = (0.109, 0.222, 0.217)
_E_POWER = 1440.0 * POUND_FORCE * INCH * 1750.0 * RPM / HORSEPOWER


def _annex_e_making() -> AgmaBevelMaking:
    steel = bevel_strength(BevelSteel.CARBURISED, 1)
    return AgmaBevelMaking((steel, steel), mounting=ONE_STRADDLE, crowning=CROWNED, cutter_radius=114.3e-3)


@cache
def _annex_e() -> AgmaBevelFactors:
    life = 1e9 / 1750.0 * _MINUTE
    return bevel_factors(_ANNEX_E, AgmaBevelDuty(1440.0 * POUND_FORCE * INCH, 1750.0 * RPM, life), _annex_e_making())


@cache
def _annex_e_rated() -> AgmaBevelRating:
    """With the rounded factors with which annex E goes on."""
    printed = replace(
        _annex_e(),
        size_bending=0.5248,
        dynamic=1.081,
        elastic=_PRINTED_ELASTIC,
        contact_cycles=(1.0, 1.06),
        bending_cycles=(0.94, 0.95),
    )
    return _charted(_ANNEX_E, printed, _annex_e_making(), _E_CHART)


def _annex_e_factors() -> Sequence[float]:
    mesh = _annex_e()
    sizes = (mesh.size_contact, mesh.size_bending, mesh.distribution, mesh.crowning, mesh.curvature)
    return [mesh.dynamic, *sizes, mesh.elastic / math.sqrt(_PSI)]


def _annex_e_cycles() -> Sequence[float]:
    return [*_annex_e().contact_cycles, *_annex_e().bending_cycles]


def _annex_e_stresses() -> Sequence[float]:
    first, second = _annex_e_rated().gears
    return [value / _PSI for value in (first.contact_stress, first.bending_stress, second.bending_stress)]


def _annex_e_limits() -> Sequence[float]:
    gears = _annex_e_rated().gears
    return [limit / _PSI for limit in (*(g.contact_limit for g in gears), *(g.bending_limit for g in gears))]


def _annex_e_powers() -> Sequence[float]:
    """The power at which each limit is reached: contact grows with the root of the load."""
    gears = _annex_e_rated().gears
    return [_E_POWER * share for share in (*(g.contact_safety**2 for g in gears), *(g.bending_safety for g in gears))]


# --- Shigley, example 15-1: straight 25/25, 600 rpm, 180 HB -------------------------------------------------------
_MITER_CHART = (0.065, 0.216, 0.216)


def _miter_making(reliability: float) -> AgmaBevelMaking:
    steel = bevel_strength(BevelSteel.THROUGH_HARDENED, 1, 180.0)
    return AgmaBevelMaking(
        (steel, steel), quality=7, mounting=OVERHUNG, crowning=UNCROWNED, reliability=reliability, is_critical=True,
        edition=BevelEdition.B97,
    )  # fmt: skip


def _miter(cycles: float, reliability: float) -> AgmaBevelFactors:
    duty = AgmaBevelDuty(100.0, 600.0 * RPM, cycles / 600.0 * _MINUTE)
    return bevel_factors(_MITER, duty, _miter_making(reliability))


def _miter_factors() -> Sequence[float]:
    short, long = _miter(1e7, 0.99), _miter(1e9, 0.995)
    speed = short.speed / FOOT * _MINUTE
    return [
        speed, short.dynamic, short.size_bending, short.distribution, short.size_contact, short.contact_cycles[0],
        short.bending_cycles[0], long.bending_cycles[0], long.reliability_bending, long.reliability_contact,
    ]  # fmt: skip


def _rounded(factors: AgmaBevelFactors) -> AgmaBevelFactors:
    """Return factors with the digits with which Shigley goes on."""
    first, second = (float(f"{value:.4g}") for value in factors.bending_cycles)
    return replace(
        factors,
        elastic=_PRINTED_ELASTIC,
        dynamic=round(factors.dynamic, 3),
        distribution=round(factors.distribution, 3),
        size_bending=round(factors.size_bending, 3),
        contact_cycles=(round(factors.contact_cycles[0], 2), round(factors.contact_cycles[1], 3)),
        bending_cycles=(first, second),
        reliability_bending=round(factors.reliability_bending, 3),
        reliability_contact=round(factors.reliability_contact, 3),
    )


def _miter_loads() -> Sequence[float]:
    """W_t that each of the asked lives and safeties allows, bending and contact."""
    found = []
    for cycles, reliability, safety in ((1e7, 0.99, 1.0), (1e9, 0.995, 1.5)):
        making, factors = _miter_making(reliability), _miter(cycles, reliability)
        gear = _charted(_MITER, _rounded(factors), making, _MITER_CHART).gears[0]
        force = factors.tangential_force / POUND_FORCE
        found += [gear.bending_safety / safety * force, (gear.contact_safety / safety) ** 2 * force]
    return found


# --- Shigley, example 15-2: straight 20/60, 6.85 hp at 900 rpm, 300 °F --------------------------------------------
_THREE_CHART = (0.0825, 0.248, 0.202)


@cache
def _three() -> AgmaBevelRating:
    steel = bevel_strength(BevelSteel.CARBURISED, 1)
    making = AgmaBevelMaking(
        (steel, steel), quality=6, mounting=OVERHUNG, crowning=CROWNED, reliability=0.995, is_critical=True,
        temperature=(300.0 - 32.0) / 1.8, edition=BevelEdition.B97,
    )  # fmt: skip
    speed = 900.0 * RPM
    duty = AgmaBevelDuty(6.85 * HORSEPOWER / speed, speed, 1e9 / 900.0 * _MINUTE)
    return _charted(_THREE, bevel_factors(_THREE, duty, making), making, _THREE_CHART)


def _three_factors() -> Sequence[float]:
    mesh = _three().mesh
    return [
        mesh.tangential_force / POUND_FORCE, mesh.dynamic, mesh.size_bending, mesh.distribution, mesh.size_contact,
        mesh.temperature, *mesh.contact_cycles, *mesh.bending_cycles,
    ]  # fmt: skip


def _three_stresses() -> Sequence[float]:
    first, second = _three().gears
    roots = [first.bending_stress, second.bending_stress, first.bending_limit / 2.0, second.bending_limit / 2.0]
    flanks = [limit / math.sqrt(2.0) for limit in (first.contact_limit, second.contact_limit)]
    return [value / _PSI for value in (*roots, first.contact_stress, *flanks)]


def _charts() -> Sequence[float]:
    pairs = [bevel_geometry(pair) for pair in (_MITER, _THREE, _CHARTED_E)]
    return [
        value
        for pair in pairs
        for value in (pair.pitting.factor, pair.bending[0].factor, pair.bending[1].factor)
    ]  # fmt: skip


# --- ISO/TR 10300-30, sample 2: hypoid 13/42, offset 15 mm, tooth forms of the virtual gears ----------------------
_EFFECTIVE, _NORMAL = math.radians(20.0), math.radians(17.748)
"""Effective and normal pressure angle of the drive side: the section is by the first, Y_Fa over cos of the second."""
_HYPOID = GearSteel("sample", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 480e6)


@cache
def _hypoid() -> tuple[RootSection, RootSection]:
    first, second = (
        root_section(
            LoadedTooth(
                teeth, teeth + 2.0 * (1.0 + shift), _EFFECTIVE, ToothProportions(1.25, edge / 2.64, shift),
                thickness_shift=wider,
            )
        )
        for teeth, edge, shift, wider in ((38.131, 0.8, 0.3, 0.038), (255.605, 1.2, -0.3, -0.062))
    )  # fmt: skip
    return first, second


def _hypoid_section() -> Sequence[float]:
    pinion = _hypoid()[0]
    angles = [math.degrees(value) for value in (float(pinion.tangent_angle), float(pinion.load_angle))]
    return [*angles, *(2.64 * float(value) for value in (pinion.chord, pinion.fillet_radius, pinion.lever))]


def _hypoid_factors() -> Sequence[float]:
    roots, lean = _hypoid(), math.cos(_EFFECTIVE) / math.cos(_NORMAL)
    forms = [float(root.form) * lean for root in roots]
    return [*forms, *(float(root.stress_correction) for root in roots), *(float(root.notch) for root in roots)]


def _hypoid_strength() -> Sequence[float]:
    rough = float(surface_factor(16e-6, _HYPOID.treatment))
    notches = [float(notch_sensitivity_factor(root.notch, _HYPOID)) for root in _hypoid()]
    return [rough, *notches, *(480.0 * 2.0 * rough * notch for notch in notches)]


# --- ISO 23509, annex F.2: the blanks of 14/39, cut duplex with r_c0 = 114.3 mm -----------------------------------
_BLANKED = BevelPair(
    (14, 39), 176.893e-3 / 39.0, INCH, math.radians(35.0),
    tooth=BevelTooth(1.0, 1.25, 2.0 * (0.5 - 0.24737), (0.037, -0.055)),
)  # fmt: skip


def _blank_angles() -> Sequence[float]:
    blank = bevel_blank(_BLANKED, 114.3e-3)
    ends = (blank.outer_spiral_angle, blank.inner_spiral_angle)
    return [math.degrees(a) for a in (*blank.root_angle_below, *blank.tip_angle, *blank.root_angle, *ends)]


def _blank_lengths() -> Sequence[float]:
    blank = bevel_blank(_BLANKED, 114.3e-3)
    depths = (*blank.outer_addendum, *blank.outer_dedendum)
    return [1e3 * x for x in (*depths, *blank.outer_tip_diameter, *blank.inner_tip_diameter, *blank.thickness)]


_F2 = "ISO 23509:2016, annex F.2, as tabulated in the self-test of afuentesaz/AGMAStandards"
_E = "ANSI/AGMA 2003-D19, annex E, as tabulated in the self-test of afuentesaz/AGMAStandards"
_S1 = "Shigley, example 15-1 (ANSI/AGMA 2003-B97), as tabulated in the tests of r3kste/pydome"
_S2 = "Shigley, example 15-2 (ANSI/AGMA 2003-B97), as tabulated in the tests of r3kste/pydome"
_H = "ISO/TR 10300-30:2024, sample 2, as tabulated in the self-test of afuentesaz/AGMAStandards"
CASES = (
    Case("bevel 14/39: K_v, C_s, K_s, K_m, C_xc, K_x, C_p", _E, "√psi for C_p",
         (1.081, 0.5625, 0.5248, 1.1036, 1.5, 1.0, 2290.0), _annex_e_factors, 7e-4, "four digits; C_p rounded to 2290"),
    Case("bevel 14/39: C_L and K_L of both", _E, "", (1.0, 1.06, 0.94, 0.95), _annex_e_cycles, 5.01e-3,
         "two decimals", is_relative=False),
    Case("bevel 14/39: s_c, s_t of both", _E, "psi", (149384.0, 18194.0, 18613.0), _annex_e_stresses, 3e-5,
         "from the printed factors"),
    Case("bevel 14/39: s_wc, s_wt of both", _E, "psi", (200e3, 212e3, 28.2e3, 28.5e3), _annex_e_limits, 1e-6,
         "from the printed cycle factors"),
    Case("bevel 14/39: P_ac, P_at of both", _E, "hp", (71.67, 80.53, 62.0, 61.2), _annex_e_powers, 6e-4,
         "three to four digits"),
    Case("miter 25/25: V, K_v, K_s, K_m, C_s, C_L, K_L; then K_L, K_R, C_R of 1e9 cycles at 0.995", _S1, "ft/min for V",
         (785.4, 1.299, 0.529, 1.254, 0.575, 1.32, 1.0, 0.8618, 1.075, 1.037), _miter_factors, 7e-4,
         "three to four digits"),
    Case("miter 25/25: W_t by bending and contact, at 1e7 cycles, then at 1e9 with S = 1.5", _S1, "lbf",
         (552.6, 458.1, 295.4, 108.6), _miter_loads, 7e-4, "from factors of three or four digits"),
    Case("straight 20/60: W_t, K_v, K_s, K_m, C_s, K_T, C_L and K_L of both", _S2, "lbf for W_t",
         (383.8, 1.325, 0.5134, 1.256, 0.5937, 1.070, 1.0, 1.068, 0.8618, 0.8929), _three_factors, 6e-4,
         "three to four digits"),
    Case("straight 20/60: s_t of both, s_wt of both, s_c, s_wc of both", _S2, "psi",
         (8463.0, 10390.0, 11240.0, 11640.0, 107560.0, 127450.0, 136120.0), _three_stresses, 1e-3,
         "four digits, C_p rounded to 2290"),
    Case("I, J_P, J_G by annex C of 25/25, 20/60 and spiral 14/39, against charts", "Shigley, examples 15-1 and 15-2; "
         "ANSI/AGMA 2003-D19, annex E", "", (*_MITER_CHART, *_THREE_CHART, *_E_CHART), _charts, 0.045,
         "read from charts, whose teeth are told only by their proportions"),
    Case("blanks of bevel 14/39: θ_f, δ_a, δ_f of both, β_e, β_i", _F2, "°",
         (2.134, 6.493, 26.240, 72.387, 17.613, 63.760, 36.846, 33.946), _blank_angles, 2e-4, "four to five digits"),
    Case("blanks of bevel 14/39: h_ae, h_fe, d_ae, d_ai, s_mn of both", _F2, "mm",
         (6.281, 2.064, 2.867, 7.085, 75.324, 178.288, 52.719, 129.835, 6.465, 3.511), _blank_lengths, 6e-4,
         "h_am and x_sm are printed with three decimals"),
    Case("hypoid 13/42, pinion: θ, α_Fan, s_Fn, ρ_F, h_Fa", _H, "°, mm", (52.945, 27.315, 6.065, 1.042, 5.098),
         _hypoid_section, 1e-3, "m_mn is printed with three digits"),
    Case("hypoid 13/42: Y_Fa, Y_Sa, q_s of both", _H, "", (2.047, 2.403, 1.903, 1.690, 2.910, 2.073), _hypoid_factors,
         8e-4, "s_Fn by α_eD, Y_Fa over cos α_nD"),
    Case("hypoid 13/42: Y_R,relT, Y_δrelT of both, σ_FP of both", _H, "MPa",
         (0.972, 1.004, 0.996, 936.4, 929.0), _hypoid_strength, 8e-4, "three decimals"),
)  # fmt: skip
"""Published ratings of bevel gears."""
