"""The power plant of a flight, with what it remembers from interval to interval: pack, windings, oil and gears.

Laws are in `machines`; `mission/supply` asks them in every interval.
"""

from gearwright.mission.plant.oil import DryRun, GearHeat, Warm, dry_run, oil_start, oil_step
from gearwright.mission.plant.pack import Pack, PackState, pack_of
from gearwright.mission.plant.refusals import faulty, less
from gearwright.mission.plant.windings import Warmth, Warmths, refuse_hot, started, warm_motor, warmed_motor

__all__ = [
    "DryRun",
    "GearHeat",
    "Pack",
    "PackState",
    "Warm",
    "Warmth",
    "Warmths",
    "dry_run",
    "faulty",
    "less",
    "oil_start",
    "oil_step",
    "pack_of",
    "refuse_hot",
    "started",
    "warm_motor",
    "warmed_motor",
]
