"""A flight for machines: its histories as CSV; its sums, damages and duty spectra as JSON."""

from __future__ import annotations

import json
import math

from gearwright.mission import (
    Durability,
    Flight,
    LifeSizing,
    Series,
    bearing_spectra,
    flight_series,
    mesh_spectrum,
    phase_summaries,
    shaft_spectrum,
)
from gearwright.mission.lives import seat_duties
from gearwright.render.tables.csv_text import csv_text
from gearwright.units import si_unit


def flight_csv(flight: Flight) -> str:
    """Return the histories as CSV, one row per interval, in SI.

    Args:
        flight: As flown.
    """
    columns = {
        **{series.name: series.values for series in flight_series(flight)},
        **{f"bearing.{seat.name}": duty.radial for seat, duty in seat_duties(flight)},
    }
    rows = ([phase, *(float(values[k]) for values in columns.values())] for k, phase in enumerate(flight.phase))
    return csv_text(["phase", *columns], rows)


def flight_json(flight: Flight, parts: Durability, life: LifeSizing | None = None) -> str:
    """Return the flight's sums as JSON, in SI.

    Args:
        flight: As flown.
        parts: Lives of its gears and bearings.
        life: How the design was strengthened, if it was.
    """
    told = {
        "mission": flight.mission.name,
        "design": flight.sizing.design.name,
        "duration": flight.duration,
        "fuel": flight.fuel,
        "balance": {**vars(flight.balance), "residual": flight.balance.residual},
        "oil_flow": flight.oil_flow,
        "oil_hottest": flight.hottest_oil,
        "phases": [vars(row) for row in phase_summaries(flight)],
        "damage": [
            {"part": row.name, "mode": row.mode, "damage": _finite(row.damage), "flights": _finite(row.flights)}
            for row in parts.parts
        ],
        "bearings": [
            {"seat": row.seat, "designation": row.bearing.designation, "count": row.count, "mean_load": row.mean_load}
            for row in parts.bearings.rows
        ],
        "not_rated": parts.notes,
        "columns": {series.name: _marked(series) for series in flight_series(flight)},
        "spectrum": _spectrum(flight),
    }
    if life is not None:
        told["life"] = {"hours": life.hours, "mass": life.sizing.mass, "mass_before": life.mass_before}
    return json.dumps(told, indent=2, allow_nan=False)


def _marked(series: Series) -> dict[str, str]:
    """Return unit, equation and source of a column of the CSV."""
    origin = series.marks.origin
    made = {"equation": origin.equation, "source": origin.source} if origin else {}
    return {"unit": si_unit(series.marks.dimension), **made}


def _spectrum(flight: Flight) -> dict[str, dict[str, list[dict[str, float]]]]:
    """Return the duty of one flight by classes: torques of meshes and shafts [N m], radial forces of bearings [N]."""
    spectra_by_kind = {
        "meshes": {mesh.name: mesh_spectrum(flight, mesh.name) for mesh in flight.sizing.train.meshes},
        "shafts": {shaft: shaft_spectrum(flight, shaft) for shaft in flight.sizing.design.shafts},
        "bearings": bearing_spectra(flight),
    }
    return {
        kind: {name: [vars(bin_) for bin_ in bins] for name, bins in spectra.items()}
        for kind, spectra in spectra_by_kind.items()
    }


def _finite(number: float) -> float | None:
    """Return a number, or None for ∞, which JSON does not have."""
    return number if math.isfinite(number) else None
