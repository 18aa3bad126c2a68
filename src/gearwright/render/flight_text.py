"""A flight in words: phases, energies, heat and the gear that dies first; and its histories as CSV and JSON."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence

from gearwright.mission import Flight, GearDamage, PhaseSummary, phase_summaries

_KELVIN = 273.15
_LITRE_PER_MINUTE = 1e-3 / 60.0
_KWH = 3.6e6
_MOST_LIFE = 1e6
"""Lives above this many hours are shown as such."""


def flight_text(flight: Flight, damages: Sequence[GearDamage]) -> str:
    """Return what a flight took and did, of one gearbox, as lines of text.

    Args:
        flight: As flown.
        damages: Of its gears, the worst first.
    """
    lines = [f"{flight.mission.name}, flown by {flight.sizing.design.name}", "", _heading()]
    lines += [_phase(row) for row in phase_summaries(flight)]
    lines += ["", *_totals(flight), "", *_damage(damages)]
    return "\n".join(lines)


def _heading() -> str:
    return f"{'phase':14} {'min':>6} {'fuel kg':>8} {'battery kWh':>12} {'propeller kWh':>14} {'efficiency %':>13}"


def _phase(row: PhaseSummary) -> str:
    return (
        f"{row.name:14} {row.duration / 60.0:6.1f} {row.fuel:8.1f} {row.battery / _KWH:12.1f}"
        f" {row.propeller / _KWH:14.1f} {100.0 * row.efficiency:13.2f}"
    )


def _totals(flight: Flight) -> list[str]:
    balance, history = flight.balance, flight.history
    hottest = float(history["oil_outlet"].max())
    lines = [
        f"Fuel {flight.fuel:.1f} kg and {balance.battery / _KWH:.1f} kWh of charge in {flight.duration / 3600.0:.2f} h",
        f"Lost in meshes {balance.mesh_loss / _KWH:.2f} kWh, in bearings and windage"
        f" {balance.drag_loss / _KWH:.2f} kWh, in motors {balance.motor_loss / _KWH:.2f} kWh,"
        f" in the battery {balance.battery_loss / _KWH:.2f} kWh",
        f"Oil: {flight.oil_flow / _LITRE_PER_MINUTE:.1f} l/min, at most {hottest - _KELVIN:.0f} °C behind the gearbox;"
        f" a cooler of {flight.cooler_conductance:.0f} W/K",
        f"Energies close within {balance.residual:.1e}",
    ]
    if flight.mission.battery is not None:
        lines.insert(1, f"State of charge at the end {history['state_of_charge'][-1]:.3f}")
    return lines


def _damage(damages: Sequence[GearDamage]) -> list[str]:
    lines = [f"{'gear':20} {'mode':8} {'damage a flight':>16} {'life h':>10}"]
    for row in damages[:6]:
        life = f"{row.life:.0f}" if row.life < _MOST_LIFE else f"> {_MOST_LIFE:.0e}"
        lines.append(f"{row.gear:20} {row.mode:8} {row.damage:16.2e} {life:>10}")
    if damages and damages[0].damage > 0.0:
        lines.append(f"First to fail: {damages[0].gear}, {damages[0].mode}, after {damages[0].flights:.0f} flights")
    return lines


def flight_csv(flight: Flight) -> str:
    """Return the histories as CSV, one row per interval, in SI.

    Args:
        flight: As flown.
    """
    columns = {
        **flight.history,
        **{f"speed.{name}": values for name, values in flight.speeds.items()},
        **{f"torque.{name}": values for name, values in flight.shaft_torques.items()},
        **{f"power.{name}": values for name, values in flight.machine_powers.items()},
        **{f"force.{name}": values for name, values in flight.mesh_forces.items()},
    }
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["phase", *columns])
    writer.writerows(
        [phase, *(float(values[k]) for values in columns.values())] for k, phase in enumerate(flight.phase)
    )
    return out.getvalue()


def flight_json(flight: Flight, damages: Sequence[GearDamage]) -> str:
    """Return the flight's sums as JSON, in SI.

    Args:
        flight: As flown.
        damages: Of its gears.
    """
    return json.dumps(
        {
            "mission": flight.mission.name,
            "design": flight.sizing.design.name,
            "duration": flight.duration,
            "fuel": flight.fuel,
            "balance": {**vars(flight.balance), "residual": flight.balance.residual},
            "oil_flow": flight.oil_flow,
            "phases": [vars(row) for row in phase_summaries(flight)],
            "damage": [{"gear": row.gear, "mode": row.mode, "damage": row.damage} for row in damages],
        },
        indent=2,
    )
