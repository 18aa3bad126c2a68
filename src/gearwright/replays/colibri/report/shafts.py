"""The shafts of the Colibri report, number by number: forces, reactions, moments, diameters.

Signs are the report's: on shafts 1 and 2 the gear stands in the middle between the bearings A and B; on the rotor
shaft it hangs beyond B, at the end of the whole length. Wrong steps are made on purpose: `correct` has the
right ones.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.parts.shafts import PointLoads, bearing_reactions, diagram, shaft_diameter, supported
from gearwright.replays.colibri.report.formulas import ReportForces, bevel_forces_colibri, helical_forces_colibri
from gearwright.replays.colibri.report.steps import Known, Step, Steps, of_part, typed

STRAIGHT = ("shaft-1", "shaft-2")
"""Shafts whose gear stands between the bearings."""
_MILLI = 1e-3
_SLIP = 0.001 * _MILLI
"""What T_3 grew by when it was typed again, …7454 to …7464 [N m] (H5)."""

_BETWEEN = (
    "F_r/2 − F_a d/(2 L)", "F_t/2", "0: bearing A bears the thrust", "F_a", "F_r/2 + F_a d/(2 L)", "F_t/2",
)  # fmt: skip
_HANGING = (
    "(W_r L − W_a d_g/2)/l", "W_t L/l", "W_a", "0: bearing B bears the thrust", "W_r − B_y", "W_t − B_z",
)  # fmt: skip
_MIDDLE = ("A_y L/2", "B_y L/2", "A_z L/2", "B_z L/2")
_AT_BEARING = (*2 * ("A_y l: at bearing B",), *2 * ("A_z l: at bearing B",))


@dataclass(frozen=True)
class GearShaft:
    """A shaft on two bearings that carries one gear."""

    forces: ReportForces
    """On the gear [N]."""
    radius: float
    """Lever of the axial force [m]."""
    gear: float
    """Place of the gear from bearing A [m]."""
    span: float
    """From bearing A to bearing B [m]."""

    @property
    def load(self) -> PointLoads:
        """Radial and tangential force, in the planes y and z [N, N m]."""
        force = np.array([[-self.forces.radial], [-self.forces.tangential]])
        couple = np.array([[self.forces.axial * self.radius], [0.0]])
        return PointLoads(np.array([self.gear]), force, couple, np.zeros((2, 1)))

    def reactions(self) -> tuple[float, float, float, float]:
        """Return the bearings' forces A_y, B_y, A_z, B_z [N]."""
        a_y, b_y, a_z, b_z = bearing_reactions(self.load, [0.0, self.span]).ravel()
        return float(a_y), float(b_y), float(a_z), float(b_z)

    def moments_at(self, place: float) -> tuple[float, float, float, float]:
        """Return the bending moments M_z before and after a place, and M_y before and after it [N m].

        Args:
            place: Of the gear or a bearing, from bearing A [m].
        """
        bent = diagram(supported(self.load, [0.0, self.span], length=max(self.gear, self.span)))
        (here,) = np.nonzero(np.isclose(bent.position, place, rtol=0.0, atol=1e-12))
        z_before, z_after, y_before, y_after = bent.bending[:, here[[0, -1]]].ravel()
        return float(z_before), float(z_after), float(y_before), float(y_after)


def straight_shafts(steps: Steps) -> dict[str, Step]:
    """Return torque, diameter, angles and tooth forces of shafts 1 and 2.

    Args:
        steps: Known so far.
    """
    helical, bevel = Known(steps, "helical-pinion"), Known(steps, "bevel-pinion")
    first = {
        "torque": Step(typed(helical["torque"], 4, _MILLI), "as table 1.1, of four decimals", ("H1", "H5")),
        "diameter": Step(
            typed(helical["pitch-diameter"], 3, _MILLI), "d_p of the helical pinion, of three decimals", ("H5",)
        ),
    }
    second = {
        "torque": bevel.step("torque").again("for the bevel pinion"),
        "diameter": Step(bevel["pitch-diameter"], "outer d_p of the bevel pinion alone"),
    }
    parts = (first | _helical(steps, "shaft-1", first), second | _helical(steps, "shaft-2", second))
    return {key: step for part, of in zip(STRAIGHT, parts, strict=True) for key, step in of_part(part, of).items()}


def rotor_shaft(steps: Steps) -> dict[str, Step]:
    """Return torque, cone angles and tooth forces of the rotor shaft.

    Args:
        steps: Known so far.
    """
    shaft, alpha = Known(steps, "rotor-shaft"), Known(steps, "shaft-1")["pressure-angle"]
    torque = typed(Known(steps, "bevel-wheel")["torque"], 4, _MILLI) + _SLIP
    wheel = math.atan(shaft["ratio"])
    pinion = 0.5 * math.pi - wheel
    forces = bevel_forces_colibri(torque, shaft["wheel-diameter"], pressure_angle=alpha, pitch_angle=wheel)
    computed = {
        "torque": Step(torque, "T_3 with …7454 typed as …7464", ("H5",)),
        "tan-pressure": Step(math.tan(alpha), "tan 20°"),
        "wheel-angle": Step(wheel, "arctan i"),
        "pinion-angle": Step(pinion, "90° − Γ"),
        "sin-pinion": Step(math.sin(pinion), "sin γ"),
        "cos-pinion": Step(math.cos(pinion), "cos γ"),
        "sin-wheel": Step(math.sin(wheel), "sin Γ"),
        "cos-wheel": Step(math.cos(wheel), "cos Γ"),
        "tangential": Step(forces.tangential, "2 T/d_g"),
        "radial": Step(forces.radial, "W_t tan Φ cos Γ"),
        "axial": Step(forces.axial, "W_t tan Φ sin Γ"),
    }
    return of_part("rotor-shaft", computed)


def reactions(steps: Steps) -> dict[str, Step]:
    """Return what the bearings give, and the moments, of all three shafts.

    Args:
        steps: Known so far.
    """
    computed: dict[str, Step] = {}
    for part in STRAIGHT:
        held = straight_shaft(steps, part)
        held_up = _held(held, (held.forces.axial, 0.0), _BETWEEN)
        computed |= of_part(part, held_up | _moments(held, held.gear, _MIDDLE))
    held = hanging_shaft(steps)
    held_up = _held(held, (0.0, held.forces.axial), _HANGING, "H8")
    return computed | of_part("rotor-shaft", held_up | _moments(held, held.span, _AT_BEARING))


def diameters(steps: Steps) -> dict[str, Step]:
    """Return the diameters that bending alone asks for.

    Args:
        steps: Known so far.
    """
    computed: dict[str, Step] = {}
    for part in (*STRAIGHT, "rotor-shaft"):
        shaft = Known(steps, part)
        bending = math.hypot(shaft["moment-z-from-a"], shaft["moment-y-from-a"])
        smallest = shaft_diameter(bending, 0.0, shaft["bending-strength"])
        how = "∛(32 √(M_z² + M_y²)/(π σ_eg)), without torque"
        computed |= of_part(
            part, {"stress": Step(shaft["bending-strength"], "set to σ_em"), "minimum-diameter": Step(smallest, how)}
        )
    return computed


def straight_shaft(steps: Steps, part: str) -> GearShaft:
    """Return shaft 1 or 2 as the report holds it.

    Args:
        steps: Known so far.
        part: ``shaft-1`` or ``shaft-2``.
    """
    shaft = Known(steps, part)
    forces = ReportForces(shaft["tangential"], shaft["radial"], shaft["axial"], shaft["normal"])
    return GearShaft(forces, 0.5 * shaft["diameter"], 0.5 * shaft["length"], shaft["length"])


def hanging_shaft(steps: Steps) -> GearShaft:
    """Return the rotor shaft as the report holds it (H8).

    Args:
        steps: Known so far.
    """
    shaft = Known(steps, "rotor-shaft")
    forces = ReportForces(shaft["tangential"], shaft["radial"], shaft["axial"], math.nan)
    return GearShaft(forces, 0.5 * shaft["wheel-diameter"], shaft["length"], shaft["span"])


def _helical(steps: Steps, part: str, settled: Steps) -> dict[str, Step]:
    """Return sines, cosines and tooth forces by the formulas of helical gears."""
    shaft = Known(steps, part)
    alpha, beta = shaft["pressure-angle"], shaft["helix-angle"]
    torque, diameter = settled["torque"].value, settled["diameter"].value
    forces = helical_forces_colibri(torque, diameter, pressure_angle=alpha, helix_angle=beta)
    return {
        "cos-helix": Step(math.cos(beta), "cos β"),
        "sin-helix": Step(math.sin(beta), "sin β"),
        "sin-pressure": Step(math.sin(alpha), "sin α"),
        "cos-pressure": Step(math.cos(alpha), "cos α"),
        "tangential": Step(forces.tangential, "2 M_d/d"),
        "normal": Step(forces.normal, "F_t/(cos α cos β)"),
        "radial": Step(forces.radial, "F_t sin α/(cos α cos β)"),
        "axial": Step(forces.axial, "F_t cos α sin β/(cos α cos β)"),
    }


def _held(held: GearShaft, thrust: tuple[float, float], how: Sequence[str], *assumed: str) -> dict[str, Step]:
    """Return the six reactions; `thrust` is what A and B bear of the axial force."""
    a_y, b_y, a_z, b_z = held.reactions()
    names = ("by", "bz", "bx", "ax", "ay", "az")
    values = (b_y, b_z, thrust[1], thrust[0], a_y, a_z)
    return {f"reaction-{name}": Step(value, by, assumed) for name, value, by in zip(names, values, how, strict=True)}


def _moments(held: GearShaft, place: float, how: tuple[str, str, str, str]) -> dict[str, Step]:
    """Return the four moments that the report has for a shaft."""
    names = ("moment-z-from-a", "moment-z-from-b", "moment-y-from-a", "moment-y-from-b")
    return {name: Step(value, by) for name, value, by in zip(names, held.moments_at(place), how, strict=True)}
