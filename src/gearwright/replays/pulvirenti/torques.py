"""The numbers behind the thesis's claims on torques and forces of In-Line H2, from the power flow of its cases."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from gearwright.identity import Role, Row, gear_part, mesh_part
from gearwright.replays.pulvirenti.runs import Computed, sized
from gearwright.spec import RATED

CRUISE = "cruise"
_DESIGN = "in-line-h2"
_PRINTED_RATIO = 2.5
"""Force of a mesh of stage two over one of stage one, as the thesis says for cruise and take-off."""


@dataclass(frozen=True)
class _Torques:
    """In-Line H2 in one case [N m]."""

    turbine: float
    motor: float
    carrier: float
    """On the shaft from the first carrier to the second sun."""
    propeller: float


def _torques(case: str) -> _Torques:
    flow = sized(_DESIGN).flows[case]
    turbine, motor, propeller = (abs(flow.machine_torques[name]) for name in ("gas-turbine", "electric", "propeller"))
    return _Torques(turbine, motor, turbine * _stage_ratio("first") + motor, propeller)


def _stage_ratio(stage: str) -> float:
    sun, ring = (sized(_DESIGN).teeth[str(gear_part(stage, role))] for role in (Role.SUN, Role.RING))
    return 1.0 + ring / sun


def _motor_over_turbine() -> Computed:
    cruise, rated = _torques(CRUISE), _torques(RATED)
    return Computed(cruise.motor / cruise.turbine, numbers={"rated": rated.motor / rated.turbine})


def _carrier_over_turbine() -> Computed:
    cruise = _torques(CRUISE)
    return Computed(cruise.carrier / cruise.turbine, numbers={"tau": _stage_ratio("first")})


def _carrier_over_motor() -> Computed:
    cruise = _torques(CRUISE)
    return Computed(cruise.carrier / cruise.motor)


def _propeller_over_turbine() -> Computed:
    cruise = _torques(CRUISE)
    return Computed(cruise.propeller / cruise.turbine, numbers={"tau": _stage_ratio("second")})


def _force(stage: str, case: str) -> float:
    """Return the tangential force of one sun-planet mesh [N]."""
    sizing = sized(_DESIGN)
    row = next(mesh for mesh in sizing.train.meshes if mesh.part == mesh_part(stage, Row.SUN_PLANET))
    module = next(gear.module for gear in sizing.gears if gear.part == gear_part(stage, Role.SUN))
    return 2.0 * abs(sizing.flows[case].meshes[row.name].multiplier) / (module * row.count)


def _mesh_forces() -> Computed:
    """Return the ratio of forces, and the motor's share of the power that would give the printed one.

    The ratio is (1 + p) times what the turbine alone gives, p the motor's power over the turbine's. A torque τ times as
    large asks for a radius ∛τ times as large, so that the force grows with τ^(2/3).
    """
    cruise, rated = (_force("second", case) / _force("first", case) for case in (CRUISE, RATED))
    sun = {gear.name: gear.pitch_diameter for gear in sized(_DESIGN).gears}
    powers = sized(_DESIGN).flows[CRUISE].machine_powers
    turbine_alone = cruise / (1.0 + powers["electric"] / powers["gas-turbine"])
    numbers = {
        "radii": sun["second.sun"] / sun["first.sun"],
        "cruise": cruise,
        "rated": rated,
        "share": 100.0 * (1.0 - turbine_alone / _PRINTED_RATIO),
        "printed": cruise * _stage_ratio("second") ** (2.0 / 3.0),
    }
    return Computed(cruise, rated, numbers)


TORQUE_CLAIMS: Mapping[str, Callable[[], Computed]] = MappingProxyType({
    "torque-motor-turbine": _motor_over_turbine,
    "torque-carrier-turbine": _carrier_over_turbine,
    "torque-carrier-motor": _carrier_over_motor,
    "torque-propeller-turbine": _propeller_over_turbine,
    "mesh-force-ratio": _mesh_forces,
})  # fmt: skip
"""Key of a claim -> what computes it."""
