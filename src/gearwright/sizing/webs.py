"""Checks of the webs of wheels: waves that stand in space, resonance with the mesh, bending by helical teeth."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from gearwright.base import Check, Kind, PartId, Role, not_assessed, smallest, text
from gearwright.parts import Material
from gearwright.parts.shaft_fatigue import endurance_limit
from gearwright.parts.webs import MOST_DIAMETERS, Web, tilting_stress, web_frequency
from gearwright.sizing.mass.bodies import Seats, gear_blank, gear_volume, kind_of, shaft_diameters
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec.design import CONCEPT

# ----------------------------------------------------------------------------------------------------------------------
# Thin wheels: what their webs must be stiff and strong enough for.
#
# A mode of n diameters that runs round the wheel backwards as fast as the wheel turns stands still in space, and any
# fixed force drives it: f_n = n · n_rot. A tooth force passes z teeth a turn; each of its harmonics may meet a mode.
# ----------------------------------------------------------------------------------------------------------------------


STANDING = range(1, 7)
"""Nodal diameters of waves that may stand in space [-]."""
MESHING = range(MOST_DIAMETERS + 1)
"""Nodal diameters of modes that the mesh may meet [-]."""
ABOVE = 1.3
"""Frequency of a mode over that at which its wave stands in space, at least [-]."""
HARMONICS = (1, 2)
"""Harmonics of the mesh that are looked at [-]."""
APART = 0.10
"""Least distance of a mode from them over the harmonic [-]."""
THIN = 0.1
"""Web over its height from hub to rim up to which the theory of thin plates tells at which frequencies it may meet the
mesh [-]; thicker ones are softer than it says, by shear, and where their modes lie is not known so well."""
NOTCH = 1.5
"""K_f of the fillet between web and hub, an estimate [-]."""
THINNEST, THICKEST = 2.79e-3, 254e-3
"""Sizes for which the endurance limit is known [m]."""
_STANDS = "Leissa 1969, NASA SP-160; 1.3 n n_rot"
_MESHES = "Leissa 1969, NASA SP-160; mesh and twice it"
_BENDS = "annular plate, tilted rim; Shigley ch. 6"
_CURE = "what helps: a thicker web (web_thickness_ratio), a dished one (web_dish), a larger hub or a lighter rim"


class Wheel(NamedTuple):
    """A gear with a web."""

    gear: GearSizing
    web: Web
    material: Material


def webbed_wheels(sizing: Sizing) -> Iterator[Wheel]:
    """Yield every cylindrical gear of a pair whose body has a web between rim and hub.

    Args:
        sizing: With shafts.
    """
    seats = Seats({}, shaft_diameters(sizing))
    for gear in sizing.gears:
        external = gear.role in (Role.PINION, Role.WHEEL) and not gear.rim
        if external and gear.stage in sizing.design.pairs and kind_of(sizing, gear) == "cylindrical":
            web = _web(sizing, gear, seats)
            if web is not None:
                yield Wheel(gear, web, sizing.design.gear_material(gear.stage))


def _web(sizing: Sizing, gear: GearSizing, seats: Seats) -> Web | None:
    """Return the web of a gear with the mass of what is outside it; None of one without."""
    blank = gear_blank(sizing, gear, seats)
    if not blank.web_width < blank.width or not blank.hub_radius < blank.rim_radius:
        return None
    density = sizing.design.gear_material(gear.stage).density
    inside = math.pi * (
        (blank.rim_radius**2 - blank.hub_radius**2 - blank.holes * blank.hole_radius**2) * blank.web_width
        + (blank.hub_radius**2 - blank.bore_radius**2) * blank.width
    )
    rim = density * max(gear_volume(sizing, gear, seats) - inside, 0.0)
    return Web(blank.rim_radius, blank.hub_radius, blank.web_width, rim)


def web_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the checks of every web, of what is above level concept.

    Args:
        sizing: With shafts.

    Source: Leissa, Vibration of Plates, NASA SP-160 (1969); without the stiffness of the rim, a lower bound from two
        diameters on.
    """
    if sizing.design.level == CONCEPT:
        return
    for wheel in webbed_wheels(sizing):
        turns = _turns(sizing, wheel.gear)
        if turns:
            modes = {n: web_frequency(wheel.web, n, wheel.material) for n in STANDING}
            yield _standing(wheel, modes, max(turns))
            if wheel.web.thickness <= THIN * (wheel.web.outer_radius - wheel.web.hub_radius):
                modes |= {n: web_frequency(wheel.web, n, wheel.material) for n in MESHING if n not in modes}
                yield _as_drawn(sizing, wheel, _meshing(wheel, modes, (min(turns), max(turns))))
        for check in _bending(sizing, wheel):
            yield _as_drawn(sizing, wheel, check)


def _as_drawn(sizing: Sizing, wheel: Wheel, check: Check) -> Check:
    """Return a check of a web that the design gives; one of the usual web that fails is left to what draws it.

    A web as wide as 0.3 of its gear is what masses reckon with; that of a drawing tapers from its hub, is dished, or
    stands on a larger hub, which weighs less than a web that is as thick all over.
    """
    if not check.fails or "web_thickness_ratio" in sizing.design.rules(wheel.gear.stage).model_fields_set:
        return check
    value, limit = (text(number, check.dimension) for number in (check.value, check.limit) if number is not None)
    why = f"a flat web of {text(wheel.web.thickness, 'length')} has {value}, {limit} is allowed: {_CURE}"
    return not_assessed(check.part, check.mode, check.clause, why)


def _turns(sizing: Sizing, gear: GearSizing) -> list[float]:
    """Return how fast a gear turns in the cases that last [1/s]."""
    cases = sizing.design.cases
    speeds = [
        abs(flow.speeds[shaft]) / (2.0 * math.pi)
        for case, flow in sizing.flows.items()
        if case not in cases or not cases[case].static
        for shaft in gear.shafts
    ]
    return [speed for speed in speeds if speed > 0.0]


def _standing(wheel: Wheel, modes: Mapping[int, float], turns: float) -> Check:
    """Return the check of the mode that comes nearest to standing in space."""
    worst = smallest(STANDING, lambda n: modes[n] / n)
    limit = ABOVE * worst * turns
    return Check(
        _part(wheel), "standing wave of the web", _STANDS, modes[worst], limit, "frequency",
        exponent=None, symbol=f"f_{worst}", place=_diameters(worst), why=_CURE if modes[worst] < limit else "",
    )  # fmt: skip


def _meshing(wheel: Wheel, modes: Mapping[int, float], turns: tuple[float, float]) -> Check:
    """Return the check of the mode that comes nearest to a harmonic of the mesh, over the range of speeds."""
    apart = {
        (n, k): _distance(modes[n], tuple(k * wheel.gear.teeth * turn for turn in turns))
        for n in MESHING
        for k in HARMONICS
    }
    n, k = smallest(apart, lambda key: apart[key])
    order = "mesh" if k == 1 else f"{k} x mesh"
    return Check(
        _part(wheel), "resonance of the web", _MESHES, apart[n, k], APART, "ratio",
        exponent=None, symbol=f"|f_{n}/f − 1|", place=f"{_diameters(n)}, {order}",
        why=_CURE if apart[n, k] < APART else "",
    )  # fmt: skip


def _distance(mode: float, excited: Sequence[float]) -> float:
    """Return how far a mode is from a range of frequencies, over its nearer end [-]; 0 inside."""
    low, high = min(excited), max(excited)
    return max(1.0 - mode / low, mode / high - 1.0, 0.0)


def _bending(sizing: Sizing, wheel: Wheel) -> Iterator[Check]:
    """Yield the check of a web against what an axial force at single helical teeth bends it by, once a turn."""
    service, shafting, gear = sizing.design.service, sizing.design.shafting, wheel.gear
    forces = [mesh.axial_force for mesh in sizing.meshes if gear.name in mesh.gears and mesh.count == 1]
    force, ultimate = max(map(abs, forces), default=0.0), wheel.material.ultimate_strength
    if not force or ultimate is None:
        return
    moment = service.application_factor * force * gear.pitch_diameter / 2.0
    stress = NOTCH * tilting_stress(wheel.web, moment)
    size = min(max(2.0 * wheel.web.thickness, THINNEST), THICKEST)
    limit = endurance_limit(ultimate, size, surface=shafting.surface, reliability=shafting.reliability)
    yield Check(
        _part(wheel), "bending of the web", _BENDS, stress, limit / service.shaft_fatigue_safety, "stress",
        at_most=True, symbol="σ", why=_CURE if stress * service.shaft_fatigue_safety > limit else "",
    )  # fmt: skip


def _part(wheel: Wheel) -> PartId:
    return PartId(Kind.GEAR, wheel.gear.name)


def _diameters(count: int) -> str:
    return f"{count} diameter" if count == 1 else f"{count} diameters"
