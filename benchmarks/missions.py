"""How long the shipped missions take to fly: python benchmarks/missions.py

Energies are checked first: fuel + battery = propeller + losses + stored. The time is the median of five flights after
one that compiles nothing but fills caches, by one process; reading and sizing are not in it.
"""

import statistics
import time

import gearwright as gw
from gearwright.mission import durability, fly
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.spec.mission import read_mission

FLIGHTS = {"thesis": "in-line-h2", "regional-250nm": "in-line", "rotor-schedule": "face-gear-split-torque"}
"""Mission -> design."""
CLOSURE = 1e-6
"""What must be missing of the energy at most, as a part [-]."""


def median(work, times=5):
    """Return the median duration of some work [s], after one try."""
    work()
    spent = []
    for _ in range(times):
        start = time.perf_counter()
        work()
        spent.append(time.perf_counter() - start)
    return statistics.median(spent)


def row(name, design):
    """Return the cells of a mission."""
    sizing, mission = gw.size(gw.read(shipped_design(design))), read_mission(shipped_mission(name))
    flight = fly(sizing, mission)
    if flight.balance.residual > CLOSURE:
        raise SystemExit(f"{name}: {flight.balance.residual:.1e} of the energy is missing")
    return (
        f"{name}, {design}",
        f"{flight.duration / 3600.0:.2f} h",
        f"{len(flight.phase)}",
        f"{flight.balance.residual:.0e}",
        f"{median(lambda: fly(sizing, mission)):.2f} s",
        f"{median(lambda: durability(flight)):.2f} s",
    )


def main():
    """Print one row for each mission."""
    print("| mission | flown | intervals | energy missing | fly | lives of all parts |")
    print("| --- | --- | --- | --- | --- | --- |")
    for name, design in FLIGHTS.items():
        print(f"| {' | '.join(row(name, design))} |")


if __name__ == "__main__":
    main()
