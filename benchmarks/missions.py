"""How long the shipped missions and the windows of the thesis's take to fly: python benchmarks/missions.py

Energies are checked first: fuel + battery = propeller + losses + stored, and in windows the work of all loads. The time
is the median of five flights after one that fills caches (of a window: that compiles, told apart), by one process;
reading and sizing are not in it. Missions tell processor time, windows both: other work on the machine spoils it less.
"""

import statistics
import time

import gearwright as gw
from gearwright.mission import durability, fly
from gearwright.mission.windows import fly_window
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.spec import read_mission

FLIGHTS = {"thesis": "in-line-h2", "regional-250nm": "in-line", "ec120b-sortie": "ec120b"}
"""Mission -> design."""
CLOSURE = 1e-6
"""What must be missing of the energy at most, as a part [-]."""
WINDOW_CLOSURE = 1e-5
"""The same for a window, whose steps are its error [-]."""


def median(work, times=5, clock=time.perf_counter):
    """Return the median duration of some work by a clock [s], after one try."""
    work()
    spent = []
    for _ in range(times):
        start = clock()
        work()
        spent.append(clock() - start)
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
        f"{median(lambda: fly(sizing, mission), clock=time.process_time):.2f} s",
        f"{median(lambda: durability(flight), clock=time.process_time):.2f} s",
    )


def window_rows(name, design):
    """Yield the cells of each window of a mission, with varying stiffness."""
    flight = fly(gw.size(gw.read(shipped_design(design))), read_mission(shipped_mission(name)))
    for window, rules in flight.mission.windows.items():
        varying = rules.model_copy(update={"stiffness": "varying"})
        start = time.perf_counter()
        trace = fly_window(flight, window, varying).trace
        first = time.perf_counter() - start
        if trace.work.imbalance > WINDOW_CLOSURE:
            raise SystemExit(f"{window}: {trace.work.imbalance:.1e} of the energy is missing")
        used = time.process_time()
        spent = median(lambda varying=varying, window=window: fly_window(flight, window, varying), times=3)
        used = (time.process_time() - used) / 4
        cells = (f"{trace.duration:g} s", f"{trace.duration / trace.step / 1e6:.2f} million", f"{trace.error:.0e}")
        yield (window, *cells, f"{trace.work.imbalance:.0e}", f"{first:.2f} s", f"{spent:.2f} s", f"{used:.2f} s")


def main():
    """Print one row for each mission, and one for each window of the first."""
    print("| mission | flown | intervals | energy missing | fly | lives of all parts |")
    print("| --- | --- | --- | --- | --- | --- |")
    for name, design in FLIGHTS.items():
        print(f"| {' | '.join(row(name, design))} |")
    print()
    print("| window, varying stiffness | flown | steps | error | energy missing | first | again | processor |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for cells in window_rows(*next(iter(FLIGHTS.items()))):
        print(f"| {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
