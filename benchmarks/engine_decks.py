"""A turboshaft by its components held against published engine decks, whose design point alone it is given.

    python benchmarks/engine_decks.py turboshaft_1120hp_no_tailpipe.csv turboshaft_4465hp.csv

Decks of NASA Aviary (aviary/models/engines): Mach number, altitude [ft], lever, corrected shaft power [hp], tailpipe
thrust where there is one, fuel flow [lb/h]. Fuel is read as corrected by δ_t √θ_t, as the power is said to be: taken as
it stands, the consumption would rise with altitude, to 1.9 lb/hp/h at 30 000 ft. Pressure ratios and efficiencies are
not printed; those here are assumptions.
"""

import sys
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np

from gearwright.air import air_at, stagnation_ratios
from gearwright.catalogue import DesignPoint
from gearwright.catalogue.turboshafts import highest_state, inlet_at, turboshaft_engine
from gearwright.machines.turboshaft import state_for, steady_state
from gearwright.units import FOOT, HORSEPOWER, POUND

RATIO = {1120.0: 9.0, 4465.2: 9.5}
"""Design power [hp] -> assumed pressure ratio [-]."""
POUND_PER_HOUR = POUND / 3600.0
PARTS = ((0.8, 1.01), (0.6, 0.8), (0.4, 0.6), (0.25, 0.4), (0.0, 0.25))
LINE = "{:24s} {:>12s} {:>8s} {:>8s} {:>8s} {:>8s} {:>8s}"


def rows_of(path):
    """Return corrected air flow of the design point [lb/s], and (altitude [ft], Mach, power [hp], fuel [lb/h])."""
    lines = Path(path).read_text(encoding="utf-8").splitlines()
    air = next(float(line.split(":")[1]) for line in lines if line.startswith("# sls_corrected_airflow"))
    numbers = [[float(cell) for cell in line.split(",")] for line in lines if line[:1] == " "]
    return air, sorted((row[1], row[0], row[3], row[-1]) for row in numbers)


def broken(points):
    """Tell whether powers or fuel of one place do not rise with the lever: a fault of the deck."""
    fuel = [point[3] for point in points]
    return any(b <= a for a, b in pairwise(fuel))


def held(path):
    """Print how far the components are from one deck."""
    air, rows = rows_of(path)
    top = max((row for row in rows if row[:2] == (0.0, 0.0)), key=lambda row: row[2])
    power, fuel = top[2] * HORSEPOWER, top[3] * POUND_PER_HOUR
    design = DesignPoint(power, fuel / power, air * POUND, RATIO[top[2]], 4500.0)
    engine = turboshaft_engine(design)
    hottest = steady_state(engine, inlet_at(0.0, 0.0), 4500.0).between
    errors, tops, left = {part: [] for part in PARTS}, [], []
    for (feet, mach), points in groupby(rows, key=lambda row: row[:2]):
        points = list(points)
        if broken(points):
            left.append((feet, mach))
            continue
        theta, delta = stagnation_ratios(air_at(feet * FOOT), mach)
        factor, inlet = delta * theta**0.5, inlet_at(feet * FOOT, mach)
        speed, state = highest_state(engine, inlet, hottest)
        highest = points[-1][2] * factor * HORSEPOWER
        tops.append((state.power / highest - 1.0, power * delta * theta**-0.5 / highest - 1.0))
        guess = (speed, state.turbine_inlet)
        for _, _, corrected, burnt in reversed(points):
            watts, flow = corrected * factor * HORSEPOWER, burnt * factor * POUND_PER_HOUR
            try:
                speed, state = state_for(engine, inlet, watts, guess)
            except ValueError:
                continue
            guess = (speed, state.turbine_inlet)
            willans = fuel * (0.2 * delta * theta**0.5 + 0.8 * watts / power)
            part = next(part for part in PARTS if part[0] <= corrected / points[-1][2] < part[1])
            errors[part].append((state.fuel_flow / flow - 1.0, willans / flow - 1.0))
    print(f"\n{Path(path).name}: {len(rows)} points; places left out, whose fuel falls with power: {left or 'none'}")
    print(LINE.format("error in %", "points", "median", "5 %", "95 %", "line med", "line 95"))
    tell("highest power", tops)
    for part, found in errors.items():
        tell(f"fuel, {part[0]:g} to {min(part[1], 1.0):g} of it", found)


def tell(name, found):
    ours, line = 100.0 * np.array(found).T
    numbers = (np.median(ours), *np.quantile(ours, (0.05, 0.95)), np.median(line), np.quantile(np.abs(line), 0.95))
    print(LINE.format(name, str(len(ours)), *(f"{number:+.1f}" for number in numbers)))


if __name__ == "__main__":
    for name in sys.argv[1:]:
        held(name)
