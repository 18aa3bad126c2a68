"""Published gearbox masses compared with the computed sums of parts, and statistics of gearbox mass.

What they weigh part by part is `sizing.mass`'s; statistics over β are `weights`'s.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from gearwright.base import RPM
from gearwright.catalogue import PublishedGearbox
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import CompleteMass, complete_mass
from gearwright.spec import Design, parse
from gearwright.validate.case import Case
from gearwright.weights import laws as willis, mass_afdd00, refit, scores

# ----------------------------------------------------------------------------------------------------------------------
# Published gearboxes as designs: their power, torque, ratio and kind of stages; what is not published is assumed.
#
# All wind gearboxes: ISO 6336 with 18CrNiMo7-6, S_H = 1.25 and S_F = 1.56 (IEC 61400-4), 200 000 h at 1.1 times the
# rated load (WindPACT). Which stages a catalogue's gearbox has is not published: below 1 MW one planetary set and two
# helical pairs, as the 750 kW gearbox of the Gearbox Reliability Collaborative; above two sets and a pair, as the 5
# MW reference gearbox. WindPACT's have one set and two pairs. Planets turn on two rows of rollers on their pins. Faces
# are 20 modules at least: of the one whose teeth are published, SIMPACK's, they are 17.5 to 21.7. Masses are dry: no
# oil is in them. All are sized at level preliminary, where carriers keep planets straight.
#
# The fan drive's planets turn on films of 5 µm at least. What is published of such bearings is their eccentricity E at
# take-off with oil of T °C: 0.69 + 0.0015 T < E < 0.94 + 0.00033 T, better above 0.84 + 0.00083 T (claims of "Gearboxes
# for aircraft gas turbine engines", by their words Rolls-Royce's of April 2020, in an examiner's amendment of 21 March
# 2022). With 90 °C and the clearance of 0.19 mm here films are 2.9 to 17 µm thick, better below 8; the 12 µm of ISO
# 7902-3 are for shafts of R_z up to 4 µm. Assumptions: superfinished flanks (R_z 1.2 µm), and a torque frame that takes
# hold of the bridges of its carrier in their middle.
#
# The propeller gear of a piston engine has its published teeth; its life of 2000 h and K_A = 1.25 behind a flexible
# coupling are assumed.
# ----------------------------------------------------------------------------------------------------------------------


_HEAD = """schema = 1
name = "{name}"
level = "{level}"
"""
_WIND = """shafts = ["main", "second", "third", "fast"]
[rotors.blades]
shaft = "main"
speed_rpm = {slow!r}
diameter_m = 80
blades = 3
[generators.generator]
shaft = "fast"
power_kw = {power!r}
speed_rpm = {fast!r}
[cases.rated]
blades = {{ power_kw = {power!r}, drives = true }}
{stages}
[gears]
material = "18CrNiMo7-6"
rating = "iso6336"
mesh_load_factor = 1.1
[gears.iso6336]
pitting_safety = 1.25
bending_safety = 1.56
tolerance_class = 6
oil_viscosity = 320
oil_temperature = 70
narrowest_modules = 20
widest_modules = 25
widest_diameters = 1.2
standard_modules = false
[teeth]
split = "optimal"
[shafting]
bore_ratio = 0.4
end_length_mm = {end!r}
middle_length_mm = {middle!r}
bearing_length_mm = {bearing!r}
[service]
life_h = 200000
bearing_life_h = 200000
mean_load = 0.7
application_factor = 1.1
[housing]
material = "cast-iron"
rings = "bolted"
reaction = "torque-arms"
oil_system = "shared"
[layout]
{places}"""
_SET = """
[planetaries.{name}]
sun = "{sun}"
ring = "ground"
carrier = "{carrier}"
planets = {planets}
planet_bearing = {{ kind = "integral", side_by_side = 2 }}
{own}"""
_PAIR = """
[pairs.{name}]
pinion = "{pinion}"
wheel = "{wheel}"
{own}
[pairs.{name}.gears]
helix_angle_deg = 10
{rules}"""
_FIRST = _SET.format(name="first", sun="second", carrier="main", planets=3, own="")
_LAST = _PAIR.format(name="last", pinion="fast", wheel="third", own="", rules="")
_SMALL = _FIRST + _PAIR.format(name="middle", pinion="third", wheel="second", own="", rules="") + _LAST
_LARGE = _FIRST + _SET.format(name="middle", sun="third", carrier="second", planets=3, own="") + _LAST
_TEETH = "sun_teeth = {}\nplanet_teeth = {}\nring_teeth = {}\nmodule_mm = {}\nface_width_mm = {}\n{}"
_SIMPACK = (
    # Shifts and centre distances are not published: rings of 93 and 97 teeth close half-way between both references.
    _SET.format(name="first", sun="second", carrier="main", planets=4, own=_TEETH.format(
        23, 34, 93, 25, 520, "centre_distance_mm = 725\n[planetaries.first.gears]\nrim_thickness_ratio = 7.1"))
    + _SET.format(name="middle", sun="third", carrier="second", planets=3, own=_TEETH.format(
        20, 37, 97, 18, 390, "centre_distance_mm = 526\n[planetaries.middle.gears]\nrim_thickness_ratio = 6.9"))
    + _PAIR.format(name="last", pinion="fast", wheel="third",
        own="pinion_teeth = 19\nwheel_teeth = 63\nmodule_mm = 16\nface_width_mm = 280\n", rules="")
)  # fmt: skip
_FAN = """shafts = ["low-pressure", "fan"]
[turbines.turbine]
shaft = "low-pressure"
power_kw = {power!r}
speed_rpm = {fast!r}
[loads.rotor]
shaft = "fan"
speed_rpm = {slow!r}
[planetaries.star]
sun = "low-pressure"
ring = "fan"
carrier = "ground"
planets = 5
[planetaries.star.planet_bearing]
kind = "plain"
largest_pressure_mpa = 14
least_film_um = 5
[carriers]
torque_at = "middle"
[teeth]
sized = 3
[gears]
material = "Pyrowear-53"
rating = "iso6336"
mesh_load_factor = 1.1
[gears.iso6336]
pitting_safety = 1.0
bending_safety = 1.2
tolerance_class = 4
flank_roughness_um = 1.2
standard_modules = false
[shafting]
bore_ratio = 0.8
[service]
life_h = 10000
application_factor = 1.0
[housing]
own = false
oil_system = "shared"
"""
_PROPELLER = """shafts = ["fast", "slow"]
[turbines.engine]
shaft = "fast"
power_kw = {power!r}
speed_rpm = {fast!r}
[loads.propeller]
shaft = "slow"
speed_rpm = {slow!r}
[pairs.only]
pinion = "fast"
wheel = "slow"
pinion_teeth = 29
wheel_teeth = 66
module_mm = 4.2333333333
[gears]
material = "AISI-9310"
rating = "iso6336"
[gears.iso6336]
pitting_safety = 1.0
bending_safety = 1.2
tolerance_class = 5
standard_modules = false
[shafting]
bore_ratio = 0.5
[service]
life_h = 2000
application_factor = 1.25
[housing]
material = "aluminium"
oil_system = "shared"
"""


_BETWEEN = {
    "wind-large": {"main.length": 544.0, "second.length": 734.0, "third.length": 595.0},
    "wind-small": {
        "main.length": 544.0,
        "second.length": 640.0,
        "third.length": 480.0,
        'third.places."last.wheel".position': 80.0,
        'third.places."middle.pinion".position': 350.0,
    },
}
"""Lengths and places along shafts [mm] over the cube root of the torque [MN m]. Of two sets and a pair they are those
of SIMPACK's model, whose flange and stages stand at -0.86, 0, 1.16 and 2.10 m; of a set and two pairs the wheel stands
as far behind the set, and the last pair, an assumption, beyond it."""


def design_of(gearbox: PublishedGearbox) -> Design:
    """Return a published gearbox as a design.

    Args:
        gearbox: Its requirement.
    """
    slow = gearbox.power / gearbox.torque / RPM
    size = math.cbrt(gearbox.torque / 1e6)  # lengths of a gearbox grow as the cube root of its torque
    form, stages = _FAN, ""
    if gearbox.kind == "propeller-pair":
        form = _PROPELLER
    elif gearbox.kind != "geared-fan":
        form, stages = _WIND, {"wind-small": _SMALL, "wind-large": _LARGE, "simpack-5mw": _SIMPACK}[gearbox.kind]
    return parse(
        (_HEAD + form).format(
            name=gearbox.name, power=gearbox.power / 1e3, slow=slow, fast=slow * gearbox.ratio, stages=stages,
            end=600.0 * size, middle=250.0 * size, bearing=90.0 * size,
            level="concept" if gearbox.kind == "propeller-pair" else "preliminary",
            places="".join(
                f"{place}_mm = {length * size!r}\n"
                for place, length in _BETWEEN["wind-small" if gearbox.kind == "wind-small" else "wind-large"].items()
            ),
        )
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Sums of parts held against published masses: bias, scatter, exponent, and the factor of a class.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Held:
    """A published gearbox and its sum of parts."""

    gearbox: PublishedGearbox
    sizing: Sizing

    @cached_property
    def mass(self) -> CompleteMass:
        """Its sum of parts."""
        return complete_mass(self.sizing)


@dataclass(frozen=True)
class Score:
    """How computed masses stand to published ones."""

    count: int
    bias: float
    """Geometric mean of computed over published [-]."""
    scatter: float
    """Factor of one standard deviation about it [-]."""
    exponents: tuple[float, float]
    """Slopes of log mass over log torque, published and computed [-]."""


def held(gearboxes: Iterable[PublishedGearbox]) -> tuple[Held, ...]:
    """Return every gearbox sized from its requirement.

    Args:
        gearboxes: Published ones.
    """
    return tuple(Held(gearbox, size(design_of(gearbox))) for gearbox in gearboxes)


def score(rows: Sequence[Held], computed: Sequence[float]) -> Score:
    """Return bias, scatter and exponents of computed masses.

    Args:
        rows: Published gearboxes.
        computed: Their masses [kg].
    """
    published = np.log([row.gearbox.mass for row in rows])
    errors, torque = np.log(computed) - published, np.log([row.gearbox.torque for row in rows])
    slopes = [float(np.polyfit(torque, masses, 1)[0]) for masses in (published, np.log(computed))]
    return Score(
        len(rows), math.exp(errors.mean()), math.exp(errors.std(ddof=min(1, len(rows) - 1))), (slopes[0], slopes[1])
    )


def fitted_factor(rows: Sequence[Held]) -> float:
    """Return the factor of a class: the geometric mean of published masses over sums of parts [-].

    Args:
        rows: Published gearboxes of one class.
    """
    return 1.0 / score(rows, [row.mass.total for row in rows]).bias


def left_out(rows: Sequence[Held]) -> tuple[float, ...]:
    """Return the mass of every gearbox with the factor that the others of its class ask for [kg].

    Args:
        rows: Published gearboxes of one class, two at least.
    """
    errors = np.log([row.gearbox.mass / row.mass.total for row in rows])
    others = (errors.sum() - errors) / (len(rows) - 1)
    return tuple(row.mass.total * math.exp(error) for row, error in zip(rows, others, strict=True))


# ----------------------------------------------------------------------------------------------------------------------
# Published statistics of gearbox mass.
# ----------------------------------------------------------------------------------------------------------------------


INCH_POUND = 0.112984829
"""[N m]"""
PSI = 6894.757293
"""[Pa]"""


def _afdd00() -> Sequence[float]:
    return [mass_afdd00(1e3, RPM, RPM)]


def _willis() -> Sequence[float]:
    return [willis.mass_willis(INCH_POUND, 1.0, k_factor=PSI)]


def _refit() -> Sequence[float]:
    line = refit()
    return [line.slope, line.intercept]


def _line() -> Sequence[float]:
    score = next(score for score in scores() if score.method.key == "tm215680")
    return [value for value in (score.bias, score.scatter) if value is not None]


CASES = (
    Case("AFDD00 at 1 kW and 1 rpm", "Pulvirenti 2023, eq. 1.1", "kg", (54.6311,), _afdd00, 4e-6, "six digits printed"),
    Case("Willis in kilograms", "Pulvirenti 2023, eq. 1.6", "kg psi/(lb in)", (0.2268,), _willis, 5e-5,
         "four digits printed", is_relative=False),
    Case("refit of real gearboxes: slope and intercept", "AeroSandbox, studies/GearboxMassFits", "",
         (1.0445171124733774, 2.0083615496306910), _refit, 1e-12, "the same points, all digits"),
    Case("line of the report on its own weights: bias and scatter", "NASA/TM-2009-215680", "", (0.952, 1.251), _line,
         1e-3, "three digits are given", is_relative=False),
)  # fmt: skip
"""Published statistics."""
