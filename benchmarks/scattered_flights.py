"""What a flight costs alone and among many: python benchmarks/scattered_flights.py [COUNT]

COUNT flights of the shipped study `scattered-flights` (left out: 1000), with and without the life of the gears, by this
process and by two workers. Processor time is that of this process, which other work on the machine spoils less; bits of
both ways are held against each other first.
"""

import sys
import time

import gearwright as gw
from gearwright.study.running import run_study

FLIGHT = ("fly.fuel", "fly.battery_energy", "fly.minimum_charge", "fly.duration")


ALONE = {"thesis": "in-line-h2", "strategies": "in-line-h2", "regional-aircraft": "in-line"}
"""Mission by power, by strategies and by an aircraft -> design that flies it."""


def alone(design, mission, times=6):
    """Return the least processor time of a mission [s]."""
    sizing, mission = gw.size(gw.read(design)), gw.read_mission(mission)
    spent = []
    for _ in range(times):
        start = time.process_time()
        flight = gw.fly(sizing, mission)
        spent.append(time.process_time() - start)
        if flight.balance.residual > 1e-9:
            raise SystemExit(f"{mission.name}: energies do not close")
    return min(spent[1:])


def main(count):
    """Print one row for each way."""
    study = gw.read_study("scattered-flights")
    designs = {name: gw.read(name) for name in study.designs}
    sampling = study.sampling.model_copy(update={"count": count})
    for mission, design in ALONE.items():
        print(f"{mission}, {design}, alone: {alone(design, mission):.4f} s of processor time")
    print("| results | flights | one process, processor time | each | two workers, elapsed |")
    print("| --- | --- | --- | --- | --- |")
    for results in (FLIGHT, (*FLIGHT, "fly.life")):
        asked = study.model_copy(update={"sampling": sampling, "results": list(results)})
        start = time.process_time()
        one = run_study(asked, designs)
        spent, begun = time.process_time() - start, time.perf_counter()
        two = run_study(asked, designs, workers=2)
        elapsed = time.perf_counter() - begun
        if one != two:
            raise SystemExit("two workers give other bits than one process")
        name = "with the life of the gears" if "fly.life" in results else "fuel, charge, duration"
        print(f"| {name} | {count} | {spent:.1f} s | {1e3 * spent / count:.1f} ms | {elapsed:.1f} s |")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)
