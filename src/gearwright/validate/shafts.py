"""Published shafts, rolling bearings and vibration: beams, DIN 743, ISO 281 and 76, rotors and geared drive lines."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from gearwright.base import INCH, POUND_FORCE, RPM
from gearwright.dynamics import Campbell, Model, Segment, System, bending_shaft, campbell, modes, statics
from gearwright.dynamics.model import Bearing, Disc, Line, Placed, Rotor, add_bearing, add_rotor
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


def shaft_whirl(part: Segment, length: float, speed: float) -> tuple[float, float]:
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
         shaft_whirl(_PART, BEAM_LENGTH, SPIN), _whirling, 3e-4, "the masses of 16 segments are lumped"),
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


# ----------------------------------------------------------------------------------------------------------------------
# Published torsional systems.
# ----------------------------------------------------------------------------------------------------------------------


def two_inertias() -> Sequence[float]:
    """Return the natural frequencies of two inertias on one shaft [Hz]."""
    model = Model()
    model.rotation("motor", inertia=211.4)
    model.rotation("wheel", inertia=8.3)
    model.shaft("shaft", "motor", "wheel", stiffness=9.775e6)
    return [float(value) for value in modes(model.build()).frequency]


def five_inertias() -> Sequence[float]:
    """Return the natural frequencies of five inertias in a chain [Hz]."""
    model = Model()
    for number, inertia in enumerate((0.0035, 0.0035, 0.0035, 0.15, 0.05)):
        model.rotation(f"disc {number}", inertia=inertia)
    for number, stiffness in enumerate((12e3, 12e3, 14e3, 10e3)):
        model.shaft(f"shaft {number}", f"disc {number}", f"disc {number + 1}", stiffness=stiffness)
    return [float(value) for value in modes(model.build()).frequency]


def geared_branch() -> Sequence[float]:
    """Return the first natural frequencies of a motor that drives two rotors through a gear pair [Hz]."""
    model = Model()
    for name, inertia in {"motor": 4e-4, "A": 7e-4, "B": 7e-4, "gear 1": 2.5e-5, "gear 2": 2.5e-5}.items():
        model.rotation(name, inertia=inertia)
    model.shaft("motor shaft", "motor", "gear 1", stiffness=1e4)
    model.shaft("shaft A", "gear 1", "A", stiffness=5e3)
    model.shaft("shaft B", "gear 2", "B", stiffness=5e3)
    model.mesh("gears", {"gear 1": 0.1, "gear 2": 0.1}, stiffness=1e12)
    return [float(value) for value in modes(model.build()).frequency[:4]]


def four_gears() -> Sequence[float]:
    """Return the natural frequencies of a shaft that drives two others through four gears in a row [Hz]."""
    model = Model()
    for name, inertia in {"driver": 3200.0, "first": 450.0, "second": 450.0, "1": 200.0, "2": 200.0}.items():
        model.rotation(name, inertia=inertia)
    for name in ("3", "4"):
        model.rotation(name, inertia=800.0)
    lengths = {"driver": (2.5, 0.2, "1"), "first": (3.5, 0.25, "3"), "second": (3.5, 0.25, "4")}
    for name, (length, diameter, gear) in lengths.items():
        stiffness = 68e9 * math.pi / 32.0 * diameter**4 / length
        model.shaft(f"shaft of {name}", name, gear, stiffness=stiffness)
    radii = {"1": 0.5, "2": 0.5, "3": 0.8, "4": 0.8}
    for one, other in (("1", "2"), ("1", "3"), ("2", "4")):
        model.mesh(f"{one}-{other}", {one: radii[one], other: radii[other]}, stiffness=1e12)
    return [float(value) for value in modes(model.build()).frequency[:4]]


def drill_string(count: int) -> Sequence[float]:
    """Return the natural frequencies of torsion of a drill string of equal elements [Hz].

    Args:
        count: Number of elements.
    """
    model = Model()
    part = Segment(800.0 / count, 0.78, bore=0.65, elasticity=195e9, poisson=0.3, density=8000.0)
    discs = {0: Disc(1.0, 1.0, 200.0), count: Disc(1.0, 1.0, 10.0)}
    string = add_rotor(model, "string", Rotor([part] * count, discs))
    for place, direction in ((0, "x"), (0, "y"), (count, "x"), (count, "y"), (0, "z")):
        motion = string.at(place)[direction]
        model.add(Line(f"{place} {direction}", motion, 1e12, kind="support"))
    system = model.build()
    solved = modes(system, len(system.labels.coordinates))
    twisting = [name for name in system.labels.coordinates if name in _twisting(count)]
    rows = [system.labels.coordinates.index(name) for name in twisting]
    share = np.sum(system.arrays.mass[rows, None] * solved.shapes[rows] ** 2, axis=0)
    return [float(value) for value in solved.frequency[share > 0.5][1:5]]


def _twisting(count: int) -> set[str]:
    return {"string", *(f"string torsion {number}" for number in range(1, count + 1))}


TORSIONAL_CASES = (
    Case(
        "four gears in a row on three shafts",
        "Friswell et al. 2010, example 9.6.3 (read in openTorsion's tests)",
        "Hz",
        (0.0, 10.304, 20.479, 24.423),
        four_gears,
        6e-4,
        "printed to 0.001 Hz; rigid gears there, 1e12 N/m here",
        is_relative=False,
    ),
    *(
        Case(
            f"drill string of {count} elements",
            "Friswell et al. 2010, problem 9.9 (read in openTorsion's tests)",
            "Hz",
            printed,
            partial(drill_string, count),
            6e-5,
            "printed to 0.0001 Hz",
            is_relative=False,
        )
        for count, printed in (
            (5, (1.9417, 4.0719, 6.5437, 9.1547)),
            (8, (1.9225, 3.9187, 6.0625, 8.4185)),
            (50, (1.9106, 3.8232, 5.7394, 7.6613)),
        )
    ),
    Case(
        "two inertias on one shaft",
        "openTorsion (Aalto University), test_shaft",
        "Hz",
        (0.0, 176.1),
        two_inertias,
        0.05,
        "printed to 0.1 Hz",
        is_relative=False,
    ),
    Case(
        "five inertias in a chain",
        "Friswell et al. 2010, Dynamics of Rotating Machines, example 9.7.1",
        "Hz",
        (0.0, 81.21, 141.21, 378.95, 536.36),
        five_inertias,
        0.006,
        "printed to 0.01 Hz",
        is_relative=False,
    ),
    Case(
        "motor and two rotors through a gear pair",
        "Friswell et al. 2010, geared branch",
        "Hz",
        (0.0, 425.4, 634.1, 3247.2),
        geared_branch,
        0.06,
        "printed to 0.1 Hz; rigid gears there, 1e12 N/m here, move it by under 1e-4 Hz",
        is_relative=False,
    ),
)
"""Published torsional systems."""


# ----------------------------------------------------------------------------------------------------------------------
# Printed whirl speeds of rotors in bearings: Friswell, Penny, Garvey & Lees, and lumped stations of another code.
# ----------------------------------------------------------------------------------------------------------------------


_BOOK = "Friswell, Penny, Garvey & Lees 2010, Dynamics of Rotating Machines, example {} (read in ROSS's tests)"
_STEEL = (211e9, 81.2e9, 7810.0)
"""E, G [Pa] and density [kg/m³] of the book's shafts."""
SMALL = Disc.of_steel(0.07, 0.28, bore=0.05, density=7810.0)
LARGE = Disc.of_steel(0.07, 0.35, bore=0.05, density=7810.0)
SPEED = 4000.0 * RPM
STATIONS = ((1.91697, 0.00059905, 0.010284), (3.83395, 0.0011981, 0.020568), (36.4237, 0.33076, 0.19866))
"""Mass, polar and diametral inertia of the first three stations of a transfer-matrix code [kg, kg m²]."""


def shaft(*, weightless: bool = False, parts: int = 1) -> list[Segment]:
    """Return the book's shaft: 1.5 m of 50 mm in six lengths.

    Args:
        weightless: True: its mass is left to its stations.
        parts: Segments of each length.
    """
    elasticity, shear, density = _STEEL
    poisson = elasticity / (2.0 * shear) - 1.0
    part = Segment(0.25 / parts, 0.05, elasticity=elasticity, poisson=poisson, density=density)
    if weightless:
        part = Segment(0.25 / parts, 0.05, elasticity=elasticity, poisson=poisson, density=1e-6 * density)
    return [part] * (6 * parts)


def in_bearings(rotor: Rotor, bearings: Mapping[int, Bearing], speed: float) -> tuple[Model, Placed]:
    """Return a rotor in bearings, held along its axis at one of them.

    Args:
        rotor: Shaft and discs.
        bearings: Station -> what sits there.
        speed: [rad/s].
    """
    model = Model()
    placed = add_rotor(model, "rotor", rotor, speed=speed)
    for station, bearing in bearings.items():
        add_bearing(model, f"bearing {station}", placed.at(station), bearing)
    return model, placed


def bending(rotor: Rotor, bearings: Mapping[int, Bearing], speed: float) -> tuple[Campbell, np.ndarray]:
    """Return a diagram that ends at a speed, and which of its modes bend the shaft, by frequency.

    Args:
        rotor: Shaft and discs.
        bearings: Station -> what sits there.
        speed: [rad/s]; 0 means next to none.
    """
    model, _ = in_bearings(rotor, bearings, speed or 1e-6)
    diagram = campbell(model.build(), [0.999, 1.0])
    twisting = _torsional(rotor)
    order = np.argsort(diagram.frequency[-1])
    far = [min(abs(diagram.frequency[-1, place] / other - 1.0) for other in twisting) > 1e-6 for place in order]
    return diagram, order[np.array(far)]


def _torsional(rotor: Rotor) -> list[float]:
    """Return the frequencies of torsion and of axial motion, which bearings do not hold [Hz]."""
    model = Model()
    add_rotor(model, "rotor", rotor)
    found = model.build()
    count = len(rotor.segments)
    names = [f"rotor torsion {number}" for number in range(1, count + 1)]
    names += [f"rotor axial {number}" for number in range(2, count + 2)]
    mass = dict(zip(found.labels.coordinates, found.arrays.mass.tolist(), strict=True))
    stiffness = dict(zip(found.labels.lines, found.arrays.stiffness.tolist(), strict=True))
    return [math.sqrt(stiffness[f"{name} elastic"] / mass[name]) / (2.0 * math.pi) for name in names]


def whirl(bearing: Bearing, speed: float, count: int, *, overhung: bool = False, unit: float = 1.0) -> Sequence[float]:
    """Return natural frequencies |λ| of the book's rotor in two equal bearings [rad/s], or in another unit.

    Args:
        bearing: Both.
        speed: [rad/s].
        count: How many.
        overhung: True: one large disc at the end, the second bearing at two thirds.
        unit: [rad/s].
    """
    rotor = Rotor(shaft(), {6: LARGE} if overhung else {2: SMALL, 4: LARGE})
    diagram, order = bending(rotor, {0: bearing, 4 if overhung else 6: bearing}, speed)
    chosen = order[:count]
    damped = 2.0 * math.pi * diagram.frequency[-1, chosen] / np.sqrt(1.0 - diagram.damping[-1, chosen] ** 2)
    return [float(value) / unit for value in np.sort(damped)]


def lumped(count: int) -> Sequence[float]:
    """Return whirl speeds of the stations of a transfer-matrix code at 500 rpm [Hz].

    Args:
        count: How many.
    """
    first, second, loaded = (Disc(mass, across, polar) for mass, polar, across in STATIONS)
    stations = {0: first, 1: second, 2: loaded, 3: second, 4: loaded, 5: second, 6: first}
    rotor, bearing = Rotor(shaft(weightless=True), stations), Bearing((1e6, 0.8e6))
    diagram, order = bending(rotor, {0: bearing, 6: bearing}, 500.0 * RPM)
    return [float(value) for value in diagram.frequency[-1, order[:count]]]


_ISOTROPIC, _STIFF = Bearing((1e6, 1e6)), Bearing((10e6, 10e6))
_OBLONG, _FLAT = Bearing((1e6, 0.8e6)), Bearing((1e6, 0.2e6))
_DAMPED = Bearing((1e6, 1e6), damping=(3e3, 3e3))
_HERTZ = 2.0 * math.pi


def _case(
    name: str, example: str, printed: tuple[float, ...], bearing: Bearing, speed: float, *, overhung: bool = False,
    unit: float = 1.0,
) -> Case:  # fmt: skip
    compute = partial(whirl, bearing, speed, len(printed), overhung=overhung, unit=unit)
    words = "rad/s" if unit == 1.0 else "Hz"
    return Case(f"rotor, {name}", _BOOK.format(example), words, printed, compute, 6e-4, "two decimals; six elements")


ROTOR_CASES = (
    _case("isotropic bearings at rest", "5.9.1", (86.66, 86.66, 274.31, 274.31, 716.78, 716.78), _ISOTROPIC, 0.0),
    _case("isotropic bearings at 4000 rpm", "5.9.1", (85.39, 87.80, 251.78, 294.71, 600.18), _ISOTROPIC, SPEED),
    _case("bearings of unequal stiffness at rest", "5.9.2", (82.65, 86.66, 254.52, 274.31, 679.49), _OBLONG, 0.0),
    _case("bearings of unequal stiffness at 4000 rpm", "5.9.2", (82.33, 86.86, 239.64, 287.25, 583.49), _OBLONG, SPEED),
    _case("mixed modes at 4000 rpm", "5.9.3", (8.545, 13.77, 22.35, 44.06, 78.76), _FLAT, SPEED, unit=_HERTZ),
    _case("damped bearings at rest", "5.9.5", (13.91, 13.91, 48.18, 48.18, 137.06, 137.06), _DAMPED, 0.0, unit=_HERTZ),
    _case("damped bearings at 4000 rpm", "5.9.5", (13.70, 14.09, 43.61, 52.18), _DAMPED, SPEED, unit=_HERTZ),
    _case("overhung disc at rest", "5.9.9", (90.14, 90.14, 630.73, 630.73, 830.43, 830.43), _STIFF, 0.0, overhung=True),
    _case("overhung disc at 4000 rpm", "5.9.9", (76.19, 103.91, 565.99, 634.23), _STIFF, SPEED, overhung=True),
    Case("rotor of lumped stations at 500 rpm", "RAPPID, output printed in ROSS's page on validation", "Hz",
         (14.6152, 15.3284, 43.3459, 46.9251, 105.902, 112.760, 150.907, 155.810), partial(lumped, 8), 1e-3,
         "another transfer-matrix step; 0.08 % at the fourth pair"),
)  # fmt: skip
"""Published rotors."""


# ----------------------------------------------------------------------------------------------------------------------
# Published geared drive lines: a ship's steam turbines through two reductions, a wind turbine's gearbox.
# ----------------------------------------------------------------------------------------------------------------------


PRINTED_POUND_INCH = 0.11298
"""Of the publication's inertias [lb in s²] and stiffnesses [lb in/rad] -> [kg m²], [N m/rad]."""
MARINE_INERTIAS = {
    "propeller": 2.454e6,
    "bull gear": 0.826e6,
    "low pressure gear": 1.283e4,
    "low pressure turbine": 1.509e4,
    "high pressure gear": 2.723e4,
    "high pressure turbine": 2.612e2,
}
"""[lb in s²], each at its own speed."""
MARINE_SHAFTS = (
    ("propeller", 1.0, "bull gear", 826e6),
    ("bull gear", 9.4094, "low pressure gear", 203.94e6),
    ("bull gear", 9.4094, "high pressure gear", 24.17e6),
    ("low pressure gear", 40.0424 / 9.4094, "low pressure turbine", 30.51e6),
    ("high pressure gear", 78.2365 / 9.4094, "high pressure turbine", 14.26e6),
)
"""From a gear by a pinion of so many times its speed, without inertia, to what turns with it [lb in/rad]."""


def geared_shaft(model: Model, first: str, ratio: float, second: str, stiffness: float) -> None:
    """Add a shaft that a gear turns through rigid teeth.

    Args:
        model: To which.
        first: The gear.
        ratio: Speed of the shaft over the gear's [-].
        second: What turns with the shaft.
        stiffness: [N m/rad].
    """
    model.add(Line(f"{first}-{second}", {first: ratio, second: -1.0}, stiffness, kind="shaft"))


def marine_turbines() -> Sequence[float]:
    """Return the first natural frequencies of a propeller that two turbines drive by two reductions each [1/min]."""
    model = Model()
    for name, inertia in MARINE_INERTIAS.items():
        model.rotation(name, inertia=inertia * PRINTED_POUND_INCH)
    for first, ratio, second, stiffness in MARINE_SHAFTS:
        geared_shaft(model, first, ratio, second, stiffness * PRINTED_POUND_INCH)
    return [60.0 * float(value) for value in modes(model.build()).frequency[1:4]]


SHAFT, GENERATOR, RATIO = 2317025352.0, 1500.5, 50.0
"""Shaft of a wind turbine of 10 MW [N m/rad], its generator's inertia [kg m²] and its gearbox's ratio [-]."""


def wind_turbine() -> Sequence[float]:
    """Return the free drive line's frequency [Hz]; the rotor's inertia is by that with the generator held."""
    model = Model()
    model.rotation("rotor", inertia=SHAFT / (2.0 * math.pi * 0.612) ** 2)
    model.rotation("generator", inertia=GENERATOR)
    geared_shaft(model, "generator", 1.0 / RATIO, "rotor", SHAFT)
    return [float(modes(model.build()).frequency[1])]


GEARED_CASES = (
    Case("marine steam turbines with two reductions each, rigid teeth",
         "Gunter & Chen 2001, Introduction to dynamics of rotor-bearing systems, example 8.1 (read in openTorsion)",
         "1/min", (177.7, 220.2, 1282.6), marine_turbines, 0.06, "printed to 0.1", is_relative=False),
    Case("wind turbine of 10 MW, free drive line",
         "Bak et al. 2013, DTU 10 MW reference wind turbine, tables 6.2 and 6.3 (read in Rebouças' Drivetrain)",
         "Hz", (4.003,), wind_turbine, 2e-3, "the 0.612 Hz that give the rotor's inertia are printed to 0.08 %"),
)  # fmt: skip
"""Published geared drive lines."""
