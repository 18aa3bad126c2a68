"""Sums of parts held against published gearboxes: printed, computed, by groups; the factor of a class, fitted last.

``python benchmarks/gearbox_masses.py`` prints the tables of docs/theory/gearbox-mass.md; with ``--figure FILE`` it
draws the figure, too, with ``--causes`` it builds the wind gearboxes otherwise, with ``--fit`` it fits the factor of
catalogues and leaves each gearbox out of it, and with ``--write`` it writes what was fitted where the package reads it
(catalogue/data/mass_classes.csv).
"""

from __future__ import annotations

import csv
import math
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

import gearwright
from gearwright.catalogue import PublishedGearbox, mass_classes, published_gearboxes
from gearwright.sizing import size
from gearwright.sizing.mass import GROUPS, weighed_wall
from gearwright.spec import Design, edited
from gearwright.validate.gearboxes import Held, design_of, fitted_factor, held, left_out, score

_FAMILIES = {
    "catalogue": "catalogues", "study": "WindPACT", "model": "SIMPACK", "press": "fan drive",
    "design": "propeller gear",
}  # fmt: skip
_SHARING = {3: 1.1, 4: 1.25, 5: 1.35}
"""Planets -> K_γ (IEC 61400-4) [-]."""


_CLASSES = Path(gearwright.__file__).parent / "catalogue" / "data" / "mass_classes.csv"
_PUBLISHED = {"housing with rings": 25801.6, "planets with bearings": 9095.2, "carriers": 10200.0, "sum": 49800.8}
"""Of the 5 MW model [kg]."""
_CURVE = (70.94, 0.759)
"""Of three-stage gearboxes, over the torque in kN m [kg]: NREL/TP-500-40566."""


def main() -> None:
    started = time.process_time()
    rows = held(published_gearboxes().values())
    print(f"{len(rows)} gearboxes sized in {time.process_time() - started:.0f} s of processor time")
    table(rows)
    for status, name in _FAMILIES.items():
        own = [row for row in rows if row.gearbox.status == status]
        told(name, own, [row.mass.total for row in own])
    groups(rows)
    curve(rows)
    if "--fit" in sys.argv:
        fit(rows, write="--write" in sys.argv)
    if "--causes" in sys.argv:
        causes()
    if "--figure" in sys.argv:
        figure(rows, sys.argv[sys.argv.index("--figure") + 1])


def table(rows: Sequence[Held]) -> None:
    """Print every gearbox, and those of catalogues with the factor of their class, too."""
    factor = mass_classes()["wind"].factor
    print("| gearbox | kW | kN m | ratio | published, kg | wall, mm | sum of parts, kg | sum/published | with factor |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for row in rows:
        box, total = row.gearbox, row.mass.total
        wall = f"{1e3 * weighed_wall(row.sizing).thickness:.0f}" if row.sizing.design.housing.own else ""
        scaled = f"{factor * total / box.mass:.2f}" if box.status == "catalogue" else ""
        print(
            f"| {box.name} | {box.power / 1e3:.0f} | {box.torque / 1e3:.4g} | {box.ratio:.4g} | {box.mass:.5g} |"
            f" {wall} | {total:.4g} | {total / box.mass:.2f} | {scaled} |"
        )


def told(name: str, rows: Sequence[Held], computed: Sequence[float]) -> None:
    if len(rows) < 2:
        print(f"{name}: sum/published {computed[0] / rows[0].gearbox.mass:.3f}")
        return
    found = score(rows, computed)
    print(
        f"{name}: n = {found.count}, bias {100.0 * (found.bias - 1.0):+.1f} %, 1σ × {found.scatter:.3f},"
        f" mass ~ T^{found.exponents[0]:.3f} published, T^{found.exponents[1]:.3f} computed"
    )


def groups(rows: Sequence[Held]) -> None:
    """Print sums by group, and the 5 MW model's beside what is published of it."""
    print(f"| gearbox | {' | '.join(GROUPS)} |")
    print(f"| --- |{' --- |' * len(GROUPS)}")
    for row in rows:
        print(f"| {row.gearbox.name} | {' | '.join(f'{row.mass.of(group):.4g}' for group in GROUPS)} |")
    model = next(row for row in rows if row.gearbox.status == "model")
    for part, mass in model_groups(model).items():
        print(f"5 MW model, {part}: {mass:.0f} of {_PUBLISHED[part]:.0f} kg, {mass / _PUBLISHED[part] - 1.0:+.1%}")


def model_groups(row: Held) -> dict[str, float]:
    """Return the groups in which the 5 MW model is published [kg]: what holds its torque is with the housing."""
    parts = {(item.part, item.group): item.total for item in row.mass.parts}
    sets = ("first", "middle")
    planets = sum(parts[f"{name}.planet", group] for name in sets for group in ("gears", "bearings"))
    rings = sum(parts[f"{name}.ring", "gears"] for name in sets)
    housing = row.mass.of("housing") + row.mass.of("reaction") + rings
    return {
        "housing with rings": housing, "planets with bearings": planets, "carriers": row.mass.of("carriers"),
        "sum": row.mass.total,
    }  # fmt: skip


def curve(rows: Sequence[Held]) -> None:
    """Print how far the study's masses stand from the one curve of torque that they are."""
    for row in rows:
        if row.gearbox.status == "study":
            mass = _CURVE[0] * (row.gearbox.torque / 1e3) ** _CURVE[1]
            print(f"{row.gearbox.name}: {row.gearbox.mass:.0f} kg, the curve {mass:.0f} kg")


def fit(rows: Sequence[Held], *, write: bool) -> None:
    """Fit the factor of catalogues to them alone, and leave each out of it."""
    own = [row for row in rows if row.gearbox.status == "catalogue"]
    factor, masses = fitted_factor(own), left_out(own)
    told("catalogues, each left out of its own fit", own, masses)
    errors = np.log([mass / row.gearbox.mass for mass, row in zip(masses, own, strict=True)])
    scatter = math.exp(float(np.sqrt(np.mean(errors**2))))
    print(f"factor {factor:.3f}, root mean square with each left out × {scatter:.3f}")
    for maker in ("Bosch Rexroth", "Eickhoff", "GE"):
        others = [row for row in own if not row.gearbox.name.startswith(maker)]
        print(f"factor without {maker}: {fitted_factor(others):.3f}")
    torque = np.log([row.gearbox.torque for row in own])
    for group in ("gears", "housing"):
        slope = np.polyfit(torque, np.log([row.mass.of(group) for row in own]), 1)[0]
        print(f"{group} of catalogues ~ T^{slope:.3f}")
    published = np.log([row.gearbox.mass for row in own])
    line, spread = np.polyfit(torque, published, 1, cov=True)
    left = (published - np.polyval(line, torque)).std(ddof=2)
    print(f"published ~ T^{line[0]:.3f} ± {math.sqrt(spread[0, 0]):.3f}, about it × {math.exp(left):.3f}")
    if write:
        written(factor, scatter, len(own))


def written(factor: float, scatter: float, count: int) -> None:
    """Write what was fitted into the row of its class."""
    with _CLASSES.open(newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        if row["name"] == "wind":
            row |= {"factor": f"{factor:.3f}", "scatter": f"{scatter:.3f}", "gearboxes": str(count)}
    with _CLASSES.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def causes() -> None:
    """Print the exponents of wind gearboxes that are built otherwise, all alike or with their torque."""
    wind = [box for box in published_gearboxes().values() if box.status in ("catalogue", "study")]
    print("| built | catalogues | of it gears | of it housing | WindPACT |")
    print("| --- | --- | --- | --- | --- |")
    for name, made in {
        "as above": design_of,
        "3, 4 and 5 planets below 1, 2.9 MW and above": _more_planets,
        "two sets and a pair, all": _two_sets,
        "S_H ~ T^-0.15, S_F ~ T^-0.2": _bolder,
        "ratio 88, all": _one_ratio,
        "2.5e8 turns of the rotor, all": _one_count,
    }.items():
        told_exponents(name, [Held(box, size(made(box))) for box in wind])


def told_exponents(name: str, rows: Sequence[Held]) -> None:
    """Print how sums, gears and housings grow with the torque."""
    cells = []
    for status, groups in (("catalogue", ("", "gears", "housing")), ("study", ("",))):
        own = [row for row in rows if row.gearbox.status == status]
        torque, masses = np.log([row.gearbox.torque for row in own]), [row.mass for row in own]
        for group in groups:
            weighed = [mass.of(group) if group else mass.total for mass in masses]
            cells.append(f"T^{np.polyfit(torque, np.log(weighed), 1)[0]:.2f}")
    print(f"| {name} | {' | '.join(cells)} |")


def _more_planets(box: PublishedGearbox) -> Design:
    planets = 3 if box.power < 1e6 else 4 if box.power < 2.9e6 else 5
    changes = {"planetaries.first.planets": planets, "planetaries.first.gears.mesh_load_factor": _SHARING[planets]}
    return edited(design_of(box), changes)


def _two_sets(box: PublishedGearbox) -> Design:
    return design_of(replace(box, kind="wind-large"))


def _bolder(box: PublishedGearbox) -> Design:
    torque = box.torque / 1e6
    safeties = {"pitting_safety": max(1.25 * torque**-0.15, 1.0), "bending_safety": max(1.56 * torque**-0.2, 1.0)}
    return edited(design_of(box), {f"gears.iso6336.{name}": value for name, value in safeties.items()})


def _one_ratio(box: PublishedGearbox) -> Design:
    return design_of(replace(box, ratio=88.0))


def _one_count(box: PublishedGearbox) -> Design:
    """As many load cycles for each: a slow rotor has fewer in the same hours."""
    turns = box.power / box.torque / (2.0 * math.pi) * 3600.0
    return edited(design_of(box), {"service.life_h": 2.5e8 / turns})


def figure(rows: Sequence[Held], path: str) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    mpl.rcParams["svg.hashsalt"] = "gearwright"
    import matplotlib.pyplot as plt

    drawn, axes = plt.subplots(figsize=(6.0, 5.2), layout="constrained")
    for status, name in _FAMILIES.items():
        own = [row for row in rows if row.gearbox.status == status]
        masses = [row.mass for row in own]
        low, high = ([abs(mass.total - mass.band[side]) for mass in masses] for side in (0, 1))
        axes.errorbar(
            [row.gearbox.mass for row in own], [mass.total for mass in masses], (low, high),
            fmt="o", markersize=4, linewidth=0.8, label=name,
        )  # fmt: skip
    ends = np.array([60.0, 90e3])
    axes.plot(ends, ends, color="black", linewidth=1.0)
    axes.plot(ends, 1.35 * ends, ends, ends / 1.35, color="grey", linewidth=0.7, linestyle="--")
    axes.set(xscale="log", yscale="log", xlabel="published mass [kg]", ylabel="sum of parts [kg], 68 %")
    axes.legend(frameon=False)
    drawn.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    main()
