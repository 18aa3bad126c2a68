"""Printed vibration of the 5 MW wind turbine's second and third stage: masses, stiffness, resonance and K_V.

Both stages are designs with their printed teeth, shifts, bores, relief and load factors, sized as any other.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from gearwright.parts.iso6336 import MeshDeviations, MeshGeometry, dynamic_factor, mesh_springs
from gearwright.parts.iso6336.loads import DynamicFactor
from gearwright.parts.iso6336.rating import PairRating
from gearwright.sizing import size
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.spec import parse
from gearwright.units import RPM
from gearwright.validate.case import Case
from gearwright.validate.gears.wind_reports import HELICAL, PLANET_RING, SUN_PLANET

_SECOND = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 2 (report in the repository gfsReboucas/Drivetrain)"
_THIRD = _SECOND.replace("stage 2", "stage 3")
_HEAD = """schema = 1
name = "{name}"
level = "concept"
shafts = ["slow", "fast"]
[motors.motor]
shaft = "slow"
power_kw = 5000
speed_rpm = {speed!r}
[loads.load]
shaft = "fast"
[cases.rated]
motor.power_kw = 5000
[service]
life_h = 175200
application_factor = 1.25
[gears]
material = "18CrNiMo7-6"
rating = "iso6336"
helix_angle_deg = {helix}
mesh_load_factor = {sharing}
[gears.iso6336]
tolerance_class = 6
tip_relief_um = 2
blank_factor = {blank}
"""
SET = (
    _HEAD.format(name="second stage", speed=47.8, helix=0, sharing=1.1, blank=0.862)
    + """[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
sun_teeth = 18
planet_teeth = 36
ring_teeth = 93
module_mm = 21
face_width_mm = 550
centre_distance_mm = 584
sun_shift = 0.3890
planet_shift = 0.5039
ring_shift = 0.1171
sun_bore_mm = 194.32
planet_bore_mm = 576.96
"""
)
"""The second stage as a design, with a held ring."""
PAIR = (
    _HEAD.format(name="third stage", speed=1165.9 * 24 / 95, helix=10, sharing=1.0, blank=0.898)
    + """[pairs.pair]
pinion = "fast"
wheel = "slow"
pinion_teeth = 24
wheel_teeth = 95
module_mm = 14
face_width_mm = 360
centre_distance_mm = 861
pinion_shift = 0.48
wheel_shift = 0.6691
pinion_bore_mm = 179.10
wheel_bore_mm = 1193.32
"""
)
"""The third stage as a design."""
_DEVIATIONS = MeshDeviations(14.7e-6, 20.4e-6)
"""Printed f_pb and f_fα of the helical wheel by ISO 1328:1995, 15.9 and 22 µm, less what running in takes, 1.2 and 1.6
[m]."""


class Vibrating(NamedTuple):
    """One mesh of the report, as gearwright rates it."""

    mesh: MeshGeometry
    rated: PairRating
    dynamic: DynamicFactor

    @property
    def resonance(self) -> float:
        """Speed of its first gear against the carrier at the main resonance n_E1, ω/N [rad/s]."""
        speed = 2.0 * float(self.rated.speed / self.mesh.pitch_diameters[0])
        return speed / float(self.dynamic.resonance_ratio)

    @property
    def stiffness(self) -> float:
        """c_γα = m_red (ω_E1 z_1)² [N/m²]."""
        return float(self.dynamic.reduced_mass * (self.resonance * self.mesh.teeth[0]) ** 2)


@cache
def sized_meshes() -> tuple[Vibrating, ...]:
    """Return sun and planet, planet and ring, and the helical pair."""
    ratings = [mesh.rating for text in (SET, PAIR) for mesh in size(parse(text)).meshes]
    rated = [rating.factors for rating in ratings if isinstance(rating, Iso6336Rating)]
    return tuple(
        Vibrating(mesh, one, one.dynamic)
        for mesh, one in zip((SUN_PLANET, PLANET_RING, HELICAL), rated, strict=True)
        if isinstance(one.dynamic, DynamicFactor)
    )


def _masses() -> list[float]:
    return [float(mesh.dynamic.reduced_mass) / 1e3 for mesh in sized_meshes()]


def _stiffness() -> list[float]:
    """Return c′ and c_γα of each mesh [N/(mm µm)]."""
    single = [float(mesh.rated.relief.stiffness) / 1e9 for mesh in sized_meshes()]
    return [*single, *(mesh.stiffness / 1e9 for mesh in sized_meshes())]


def _resonances() -> list[float]:
    return [mesh.resonance / RPM for mesh in sized_meshes()]


def _ratios() -> list[float]:
    return [float(mesh.dynamic.resonance_ratio) for mesh in sized_meshes()]


def _factors() -> list[float]:
    """Return K_V of both meshes of the second stage, and the larger that counts for the planet."""
    sun, ring = (float(mesh.dynamic.factor) for mesh in sized_meshes()[:2])
    return [sun, ring, max(sun, ring)]


def _of_pair() -> list[float]:
    return [float(sized_meshes()[2].dynamic.factor)]


def _of_printed_deviations() -> list[float]:
    pair = sized_meshes()[2]
    load = float(pair.rated.tangential_force / pair.mesh.face_width) * 1.25
    found = dynamic_factor(
        pair.mesh, mesh_springs(pair.mesh, load, blank=0.898), _DEVIATIONS, specific_load=load,
        pinion_speed=1165.9 * RPM, masses=(pair.dynamic.reduced_mass,),
    )  # fmt: skip
    return [float(found.factor)]


CASES = (
    Case("m_red of sun and 3 planets, planet and held ring, bored helical pair", f"{_SECOND}; stage 3", "kg/mm",
         (0.1534, 1.4684, 0.36503), _masses, 2e-4, "half a printed digit"),
    Case("c′, then c_γα, of sun and planet, planet and ring, helical pair; C_R as printed", f"{_SECOND}; stage 3",
         "N/(mm µm)", (12.240, 14.053, 13.832, 15.640, 20.563, 18.632), _stiffness, 6e-4, "C_R has three digits"),
    Case("n_E1 of sun and planet, planet and held ring, helical pair", f"{_SECOND}; stage 3", "1/min",
         (5357.0, 993.0, 2843.0), _resonances, 8e-4, "three digits of C_R and of 993"),
    Case("N of sun and planet, planet and held ring, helical pair", f"{_SECOND}; stage 3", "–",
         (0.046, 0.124, 0.410), _ratios, 5e-4, "half a printed digit", is_relative=False),
    Case("K_V of sun and planet, of planet and held ring, of the set", _SECOND, "–", (1.02, 1.06, 1.06), _factors, 5e-3,
         "half a printed digit", is_relative=False),
    Case("K_V of the bored helical pair, class 6", _THIRD, "–", (1.092,), _of_pair, 6e-3,
         "f_fα of class 6 is 18 µm by ISO 1328-1:2013, 22 µm by the edition of 1995"),
    Case("K_V of the bored helical pair with its printed deviations", _THIRD, "–", (1.092,), _of_printed_deviations,
         1e-3, "deviations are printed to 0.1 µm", is_relative=False),
)  # fmt: skip
"""Printed vibration of teeth."""
