"""Published shifted teeth of epicyclic sets, written as compound sets: where they close, what is measured of them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

from gearwright.parts.gears import CylindricalGear, span_measurement
from gearwright.spec import parse
from gearwright.spec.design import CompoundShifts, compound_shifts
from gearwright.validate.case import Case

_KOS = "L. Kos, LECAD, University of Ljubljana, Planetary Transmissions, printed test run"
_TURBINE = "Nejad et al. 2016, Wind Energy 19, 1089-1106, KISSsoft report of its stages"
_TEXT = """\
schema = 1
name = "published"
shafts = ["fast", "slow"]
motors.motor = {{ shaft = "fast", power_kw = 1, speed_rpm = {speed}, balances = false }}
loads.drum = {{ shaft = "slow", speed_rpm = 100 }}
[epicyclics.set]
carrier = "slow"
suns.sun = {{ shaft = "fast", teeth = {sun}, module_mm = {module}, shift = {shift} }}
rings.ring = {{ shaft = "ground", teeth = {ring} }}
planets.planet = {{ teeth = {planet}, meshes = ["sun", "ring"], {key} }}
"""


class PublishedSet(NamedTuple):
    """A set as it is printed."""

    teeth: tuple[int, int, int]
    """Of sun, planet and ring [-]."""
    module: float
    """m [mm]."""
    shift: float
    """x of the sun [-]."""
    key: str
    """What else is given, as a key of the planet."""

    @property
    def shifts(self) -> CompoundShifts:
        """What gearwright makes of it."""
        sun, planet, ring = self.teeth
        text = _TEXT.format(speed=100.0 * (1.0 + ring / sun), sun=sun, planet=planet, ring=ring,
                            module=self.module, shift=self.shift, key=self.key)  # fmt: skip
        return compound_shifts(parse(text), "set")

    def gear(self, name: str) -> CylindricalGear:
        """Return its sun or its planet, in millimetres.

        Args:
            name: Sun or planet.
        """
        shift = self.shifts.gears[name]
        teeth = self.teeth[0] if name == "sun" else self.teeth[1]
        return CylindricalGear(
            teeth, self.module, 38.0, profile_shift=shift.profile_shift, tip_alteration=shift.tip_alteration
        )


FIRST = PublishedSet((19, 17, 56), 45.0, 0.617, "shift = 0.802")
SECOND = PublishedSet((18, 36, 93), 21.0, 0.389, "shift = 0.504")
PRINTED_RUN = PublishedSet((21, 43, 108), 1.75, 0.438, "centre_distance_mm = 56.8")


def _centres(*sets: PublishedSet) -> Sequence[float]:
    return [own.module * (own.shifts.meshes["sun-planet"].centre or 0.0) for own in sets]


def _tips_and_spans() -> Sequence[float]:
    sun, planet = PRINTED_RUN.gear("sun"), PRINTED_RUN.gear("planet")
    return [2.0 * sun.tip_radius, 2.0 * planet.tip_radius, span_measurement(sun, 3), span_measurement(planet, 5)]


CASES = (
    Case("5 MW reference gearbox as compound sets, centre distance of both", _TURBINE, "mm", (862.996, 584.002),
         partial(_centres, FIRST, SECOND), 6e-4, "printed to a micrometre", is_relative=False),
    Case("5 MW reference gearbox as compound sets, shift of both rings", _TURBINE, "-", (-0.501, 0.117),
         lambda: [own.shifts.gears["ring"].profile_shift for own in (FIRST, SECOND)], 6e-4,
         "three decimals of the printed shifts", is_relative=False),
    Case("planetary set 21/43/108 on 56.8 mm, shift of the planet", _KOS, "-", (0.0426,),
         lambda: [PRINTED_RUN.shifts.gears["planet"].profile_shift], 6e-5, "four decimals", is_relative=False),
    Case("planetary set 21/43/108 on 56.8 mm, tips and spans of sun and planet", _KOS, "mm",
         (41.7008, 78.8170, 13.9546, 24.3530), _tips_and_spans, 2e-4, "four decimals of the shift: 0.2 µm",
         is_relative=False),
)  # fmt: skip
