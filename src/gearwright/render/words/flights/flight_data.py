"""A flight for machines: its histories as CSV; its sums, damages and duty spectra as JSON."""

from __future__ import annotations

from gearwright.mission import (
    Flight,
    flight_series,
)
from gearwright.mission.lives import seat_duties
from gearwright.render.grid.csv_text import csv_text


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
