"""Published shafts and rolling bearings: Timoshenko beams, DIN 743, ISO 281 and ISO 76."""

import math
from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from gearwright.base import INCH, POUND_FORCE, RPM
from gearwright.dynamics import Model, Segment, System, bending_shaft, campbell, modes, statics
from gearwright.parts.bearings import (
    BearingGeometry,
    BearingKind,
    RingLoad,
    ball_dynamic_factor,
    ball_static_factor,
    basic_life,
    basic_reference_life,
    life_time,
    load_distribution,
    roller_dynamic_factor,
)
from gearwright.parts.shaft_fatigue import (
    Overload,
    SectionLoad,
    ShaftSection,
    ShaftSteel,
    SteelGroup,
    blank_factor,
    din743_safety,
    keyway_factor,
)
from gearwright.parts.shafts import PointLoads, diagram, supported
from gearwright.validate.case import Case

# ----------------------------------------------------------------------------------------------------------------------
# Shafts in bending against the closed forms of Timoshenko's beam.
# ----------------------------------------------------------------------------------------------------------------------


BEAM_LENGTH = 0.25
"""[m]; five diameters."""
DIAMETER = 0.05
"""[m]."""
COUNT = 40
"""Segments of the shaft at rest."""
SPUN = 16
"""Segments of the spinning one: its modes cost the cube of their number."""
SPIN = 20000.0
"""[rad/s], far above any shaft, so that the gyroscopic effect is large."""
TIP = 1000.0
"""Force on the cantilever [N]."""
_ARM = Segment(0.1, 0.03, bore=0.01)
_PART = Segment(BEAM_LENGTH / COUNT, DIAMETER)


def simply_supported(count: int, part: Segment, speed: float = 0.0) -> System:
    """Return a shaft of equal segments that is held across at both ends, and along and in twist at one.

    Args:
        count: Number of segments [-].
        part: One of them.
        speed: Rotational speed [rad/s].
    """
    model = Model()
    stations = bending_shaft(model, "shaft", [part] * count, speed=speed)
    for station in (stations[0], stations[-1]):
        for direction in ("x", "y"):
            model.support(f"{station} {direction} bearing", f"{station} {direction}", stiffness=1e13)
    model.support("thrust", f"{stations[0]} z", stiffness=1e10)
    if not speed:
        model.support("anchor", f"{stations[0]} twist", stiffness=1e8)
    return model.build()


def timoshenko_frequency(part: Segment, length: float, number: int) -> float:
    """Return a natural frequency of a simply supported Timoshenko beam [Hz]: the lower root of its exact quartic.

    Args:
        part: Section and material.
        length: [m].
        number: Half waves [-].

    Source: Timoshenko 1921, Phil. Mag. 41, 744: with rotary inertia and shear, sin nπx/L satisfies all conditions.
    """
    wave = number * math.pi / length
    bending, section = part.elasticity * part.second_moment, part.density * part.area
    shear = part.shear_coefficient * part.area * part.shear_modulus
    rotary = part.density * part.second_moment
    a = section * rotary / shear
    b = -(section + wave**2 * (rotary + section * bending / shear))
    return math.sqrt((-b - math.sqrt(b * b - 4.0 * a * bending * wave**4)) / (2.0 * a)) / (2.0 * math.pi)


def whirl(part: Segment, length: float, speed: float) -> tuple[float, float]:
    """Return backward and forward whirl of the first bending mode [Hz], from the two-variable problem of one wave.

    With w = W sin kx e^(iωt) and tilt Ψ cos kx e^(iωt), both complex across the planes, the equations give
    (κGA k² − ρA ω²)(κGA + E I k² − ρI ω² + 2 ρI Ω ω) = (κGA k)².

    Args:
        part: Section and material.
        length: [m].
        speed: Ω [rad/s].

    Source: Timoshenko 1921 with the gyroscopic term.
    """
    wave = math.pi / length
    shear = part.shear_coefficient * part.area * part.shear_modulus
    section, rotary = part.density * part.area, part.density * part.second_moment
    bending = part.elasticity * part.second_moment
    first = np.poly1d([-section, 0.0, shear * wave**2])
    second = np.poly1d([-rotary, 2.0 * rotary * speed, shear + bending * wave**2])
    roots = np.sort(np.abs((first * second - shear**2 * wave**2).roots.real)) / (2.0 * math.pi)
    return float(roots[0]), float(roots[1])


def tip_deflection(part: Segment, length: float, force: float) -> float:
    """Return the deflection of a cantilever under a force at its tip, w = F L³/(3 E I) + F L/(κ G A) [m].

    Args:
        part: Section and material.
        length: [m].
        force: [N].

    Source: Timoshenko 1921.
    """
    bending = force * length**3 / (3.0 * part.elasticity * part.second_moment)
    return bending + force * length / (part.shear_coefficient * part.area * part.shear_modulus)


def _bending() -> Sequence[float]:
    beam = modes(simply_supported(COUNT, _PART))
    return [frequency for frequency, many in beam.groups() if many == 2][:3]


def _cantilever() -> Sequence[float]:
    model = Model()
    stations = bending_shaft(model, "arm", [_ARM] * 3)
    for direction in ("x", "y", "z", "tilt x", "tilt y", "twist"):
        model.support(f"wall {direction}", f"{stations[0]} {direction}", stiffness=1e16)
    model.load(f"{stations[-1]} y", constant=TIP)
    system = model.build()
    return [float(statics(system).position[system.labels.coordinates.index(f"{stations[-1]} y")])]


def _whirling() -> Sequence[float]:
    system = simply_supported(SPUN, Segment(BEAM_LENGTH / SPUN, DIAMETER), SPIN)
    diagram = campbell(system, [float(factor) for factor in np.linspace(0.0, 1.0, 6)])
    first = np.argsort(diagram.frequency[0])[:2]
    return sorted(diagram.frequency[-1, first].tolist())


BEAM_CASES = (
    Case("simply supported shaft, bending", "Timoshenko 1921, closed form", "Hz",
         tuple(timoshenko_frequency(_PART, BEAM_LENGTH, number) for number in (1, 2, 3)), _bending, 2e-3,
         "the masses of 40 segments are lumped"),
    Case("cantilever, tip force", "Timoshenko 1921, closed form", "m", (tip_deflection(_ARM, 0.3, TIP),), _cantilever,
         1e-8, "a wall of 1e16 N m/rad gives way by 3e-14 rad"),
    Case("spinning shaft, backward and forward whirl", "Timoshenko 1921 with gyroscopic term", "Hz",
         whirl(_PART, BEAM_LENGTH, SPIN), _whirling, 3e-4, "the masses of 16 segments are lumped"),
)  # fmt: skip
"""Closed forms of bending shafts."""


# ----------------------------------------------------------------------------------------------------------------------
# Published shafts: the countershaft of Shigley's Mechanical Engineering Design, a keyed shaft by DIN 743.
# ----------------------------------------------------------------------------------------------------------------------


POUND_INCH = POUND_FORCE * INCH
BEARINGS = (0.75 * INCH, 10.75 * INCH)
LENGTH = 11.5 * INCH
_SOURCE = "Budynas & Nisbett, Shigley's Mechanical Engineering Design, example 7-2"


def countershaft() -> PointLoads:
    """Return the loads of gears 3 and 4: W_23 = (197, 540) lbf, W_54 = (885, 2431) lbf, torque 3240 lbf in."""
    force = np.array([[-197.0, -885.0], [540.0, -2431.0]]) * POUND_FORCE
    torque = np.array([3240.0, -3240.0]) * POUND_INCH
    return PointLoads(np.array([2.75, 8.50]) * INCH, force, np.zeros((2, 2)), torque)


def reactions() -> Sequence[float]:
    """Return both bearings' forces along y, then along z [lbf]."""
    forces = supported(countershaft(), BEARINGS, length=LENGTH).force[:, 2:] / POUND_FORCE
    return [float(value) for value in forces.ravel()]


def moments() -> Sequence[float]:
    """Return the resulting bending moment at gear 3, at the shoulder and at gear 4 [lbf in]."""
    drawn = diagram(supported(countershaft(), BEARINGS, length=LENGTH))
    places = np.array([2.75, 7.50, 8.50]) * INCH
    y, z = (np.interp(places, drawn.position, plane) / POUND_INCH for plane in drawn.bending)
    return [float(value) for value in np.hypot(y, z)]


_KEYED = ShaftSteel(750e6, 520e6, 375e6, 225e6, SteelGroup.TEMPERED)
"""C50 with σ_bW = 0.5 σ_B and τ_tW = 0.3 σ_B."""


def keyed_shaft() -> Sequence[float]:
    """Return β_σ, S_D and S_F of a hard shaft of 60 mm with one key, load growing at constant σ_m/σ_a."""
    notch = keyway_factor(0.060, blank_factor(0.080, _KEYED.group, yielding=False) * _KEYED.ultimate)
    safety = din743_safety(
        SectionLoad(bending_amplitude=1402.294, torque_mean=1336.902),
        ShaftSection(0.060, 0.080, notch, 25e-6, hard_surface=True),
        _KEYED,
        greatest=SectionLoad(bending_amplitude=2524.1292, torque_mean=2406.4236),
        overload=Overload.CONSTANT_RATIO,
    )
    return [notch.bending, safety.fatigue, safety.yielding]


SHAFT_CASES = (
    Case(
        "bearing reactions of a countershaft",
        _SOURCE,
        "lbf",
        (356.7, 725.3, 115.0, 1776.0),
        reactions,
        0.1,
        "printed to 0.1 lbf",
        is_relative=False,
    ),
    Case(
        "bending moments of a countershaft",
        _SOURCE,
        "lbf in",
        (749.0, 3651.0, 4316.0),
        moments,
        1.0,
        "printed to 1 lbf in",
        is_relative=False,
    ),
    Case(
        "β_σ, S_D and S_F of a hard shaft with a key, DIN 743, case 2",
        "Exam MEL1 2024W, problem 2 (repository hanslhansl/din743, tests/test_1.py)",
        "",
        (2.5203, 1.472, 2.568),
        keyed_shaft,
        6e-4,
        "printed to three decimals",
        is_relative=False,
    ),
)
"""Published shafts."""


# ----------------------------------------------------------------------------------------------------------------------
# Published rolling bearings: rating factors of ISO 281 and ISO 76, lives of a catalogue and of a program.
# ----------------------------------------------------------------------------------------------------------------------


BALL_FACTORS = (
    29.1, 35.8, 40.3, 43.8, 46.7, 49.1, 51.1, 52.8, 54.3, 55.5, 56.6, 57.5, 58.2, 58.8, 59.3, 59.6, 59.8, 59.9, 60.0,
    59.9, 59.8, 59.6, 59.3, 59.0, 58.6, 58.2, 57.7, 57.1, 56.6, 56.0, 55.3, 54.6, 53.9, 53.2, 52.4, 51.7, 50.9, 50.0,
    49.2, 48.4,
)  # fmt: skip
"""f_c of ISO 281:2007, table 2, single row radial contact, at D_w cos α/D_pw = 0.01, 0.02 ... 0.40."""
ROLLER_FACTORS: Mapping[float, float] = {
    0.01: 52.1, 0.02: 60.8, 0.03: 66.5, 0.04: 70.7, 0.05: 74.1, 0.06: 76.9, 0.07: 79.2, 0.08: 81.2, 0.09: 82.8,
    0.10: 84.2, 0.12: 86.4, 0.14: 87.7, 0.16: 88.5, 0.18: 88.8, 0.20: 88.7, 0.22: 88.2, 0.24: 87.5, 0.26: 86.4,
    0.28: 85.2, 0.30: 83.8,
}  # fmt: skip
"""D_w cos α/D_pw -> f_c of ISO 281:2007, table 7."""
STATIC_FACTORS = (
    14.9, 15.1, 15.3, 15.5, 15.7, 15.9, 16.1, 16.3, 16.5, 16.4, 16.1, 15.9, 15.6, 15.4, 15.2, 14.9, 14.7, 14.4, 14.2,
    14.0, 13.7, 13.5, 13.2, 13.0, 12.8, 12.5, 12.3, 12.1, 11.8, 11.6,
)  # fmt: skip
"""f_0 of ISO 76:2006, table 1, radial contact, at D_w cos α/D_pw = 0.01, 0.02 ... 0.30."""
REFERENCE = BearingGeometry(BearingKind.DEEP_GROOVE, 7, 11.5e-3, 43.5e-3)
"""Z = 7, D_w = 11.5, D_pw = 43.5 mm."""
REFERENCE_RATING = 23.4e3
"""C [N]."""
REFERENCE_LIVES: Mapping[str, tuple[float, RingLoad, float]] = {
    "radial, no clearance": (0.0, RingLoad(x=1000.0), 13163.019),
    "axial, no clearance": (0.0, RingLoad(axial=1000.0), 2222.7318),
    "radial": (10e-6, RingLoad(x=1000.0), 10795.7948),
    "axial": (10e-6, RingLoad(axial=1000.0), 3115.8781),
    "both": (10e-6, RingLoad(x=1000.0, axial=1000.0), 1630.5367),
    "couple, no clearance": (0.0, RingLoad(moment_y=1.0), 785144.7521),
    "all": (10e-6, RingLoad(x=1000.0, axial=1000.0, moment_y=1.0), 1627.7479),
}
"""Load -> radial clearance [m], load, basic reference life [10⁶ turns]."""


def inside(kind: BearingKind, ratio: float) -> BearingGeometry:
    """Return rolling elements of a given D_w/D_pw.

    Args:
        kind: Of bearing.
        ratio: D_w/D_pw [-].
    """
    return BearingGeometry(kind, 8, 0.1 * ratio, 0.1, roller_length=0.01)


def _balls() -> Sequence[float]:
    steps = range(1, len(BALL_FACTORS) + 1)
    return [ball_dynamic_factor(inside(BearingKind.DEEP_GROOVE, step / 100)) for step in steps]


def _rollers() -> Sequence[float]:
    return [roller_dynamic_factor(inside(BearingKind.CYLINDRICAL, ratio)) for ratio in ROLLER_FACTORS]


def _static() -> Sequence[float]:
    steps = range(1, len(STATIC_FACTORS) + 1)
    return [ball_static_factor(inside(BearingKind.DEEP_GROOVE, step / 100)) for step in steps]


def _reference_life(clearance: float, load: RingLoad) -> Sequence[float]:
    distribution = load_distribution(REFERENCE, load, clearance=clearance)
    return [basic_reference_life(REFERENCE, REFERENCE_RATING, distribution.force)]


def _catalogue_life() -> Sequence[float]:
    return [basic_life(55.3e3, 10e3, BearingKind.DEEP_GROOVE)]


def _catalogue_hours() -> Sequence[float]:
    return [life_time(_catalogue_life()[0], 3000.0 * RPM) / 3600.0]


BEARING_CASES = (
    Case("dynamic factor f_c of balls", "ISO 281:2007, table 2", "", BALL_FACTORS, _balls, 0.05,
         "printed to 0.1", is_relative=False),
    Case("dynamic factor f_c of rollers", "ISO 281:2007, table 7", "", tuple(ROLLER_FACTORS.values()), _rollers, 0.05,
         "printed to 0.1", is_relative=False),
    Case("static factor f_0 of balls", "ISO 76:2006, table 1", "", STATIC_FACTORS, _static, 0.054,
         "printed to 0.1; one value is 0.003 beyond half a digit", is_relative=False),
    *(
        Case(f"reference life, {name}", "MASTA, in minzhun/ISO16281; ISO/TS 16281", "10⁶", (life,),
             partial(_reference_life, clearance, load), 2e-3, "another arm of the tilt, 1.05 % shorter")
        for name, (clearance, load, life) in REFERENCE_LIVES.items()
    ),
    Case("basic life of a 6309, C = 55.3 kN, P = 10 kN", "SKF, Rolling bearings", "10⁶", (169.0,), _catalogue_life, 0.5,
         "three digits", is_relative=False),
    Case("the same at 3000 rpm", "SKF, Rolling bearings", "h", (940.0,), _catalogue_hours, 1.0, "three digits",
         is_relative=False),
)  # fmt: skip
"""Published bearings."""
