"""Sums of parts held against published gearboxes: printed, computed, band; the fit of the housing's constant.

``python benchmarks/gearbox_masses.py`` prints the tables of docs/theory/gearbox-mass.md; with ``--figure FILE`` it
draws the figure, too, with ``--causes`` it builds the wind gearboxes otherwise, and with ``--fit`` it fits the constant
and leaves each gearbox out of its own fit.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gearwright.catalogue import PublishedGearbox, published_gearboxes
from gearwright.sizing import Sizing, size
from gearwright.sizing.housing_shell import shell_around
from gearwright.sizing.mass import CALIBRATED
from gearwright.spec import Design, edited
from gearwright.validate.gearboxes import Held, design_of, fitted, held, left_out, score

_FAMILIES = {
    "catalogue": "catalogues", "study": "WindPACT", "model": "SIMPACK", "press": "fan drive",
    "design": "propeller gear",
}  # fmt: skip
_SHARING = {3: 1.1, 4: 1.25, 5: 1.35}
"""Planets -> K_γ (IEC 61400-4) [-]."""


def main() -> None:
    started = time.process_time()
    rows = held(published_gearboxes().values())
    print(f"{len(rows)} gearboxes sized in {time.process_time() - started:.0f} s of processor time")
    table(rows)
    told("all, constants as shipped", rows, [row.mass().total for row in rows])
    for status, name in _FAMILIES.items():
        own = [row for row in rows if row.gearbox.status == status]
        told(name, own, [row.mass().total for row in own])
    if "--fit" in sys.argv:
        fit(rows)
    if "--causes" in sys.argv:
        causes()
    if "--figure" in sys.argv:
        figure(rows, sys.argv[sys.argv.index("--figure") + 1])


def table(rows: Sequence[Held]) -> None:
    print("| gearbox | kW | kN m | ratio | published, kg | computed, kg | 68 % | computed/published |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for row in rows:
        box, mass = row.gearbox, row.mass()
        low, high = mass.band
        print(
            f"| {box.name} | {box.power / 1e3:.0f} | {box.torque / 1e3:.4g} | {box.ratio:.4g} | {box.mass:.5g} |"
            f" {mass.total:.4g} | {low:.3g} to {high:.3g} | {mass.total / box.mass:.2f} |"
        )


def told(name: str, rows: Sequence[Held], computed: Sequence[float]) -> None:
    if len(rows) < 2:
        print(f"{name}: computed/published {computed[0] / rows[0].gearbox.mass:.3f}")
        return
    found = score(rows, computed)
    print(
        f"{name}: n = {found.count}, bias {100.0 * (found.bias - 1.0):+.1f} %, 1σ × {found.scatter:.3f},"
        f" mass ~ T^{found.exponents[0]:.3f} published, T^{found.exponents[1]:.3f} computed"
    )


def fit(rows: Sequence[Held]) -> None:
    print("fitted to all:", fitted(rows), "shipped:", CALIBRATED)
    masses, constants = left_out(rows)
    told("each left out of its own fit", rows, masses)
    errors = np.log([mass / row.gearbox.mass for mass, row in zip(masses, rows, strict=True)])
    print(f"root mean square of those errors: × {math.exp(float(np.sqrt(np.mean(errors**2)))):.3f}")
    shares = [found.stress_share for found in constants]
    print(f"stress share over the fits: {min(shares):.4f} to {max(shares):.4f}")
    for group in ("gears", "housing"):
        wind = [row for row in rows if row.gearbox.status in ("catalogue", "study")]
        slope = np.polyfit(
            np.log([row.gearbox.torque for row in wind]), np.log([row.mass().of(group) for row in wind]), 1
        )[0]
        print(f"{group} of wind gearboxes ~ T^{slope:.3f}")


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
    rows = held(wind)
    told_exponents("walls of 6 mm + 0.010 L", [Held(row.gearbox, _cast(row)) for row in rows])


def told_exponents(name: str, rows: Sequence[Held]) -> None:
    """Print how sums, gears and housings grow with the torque."""
    cells = []
    for status, groups in (("catalogue", ("", "gears", "housing")), ("study", ("",))):
        own = [row for row in rows if row.gearbox.status == status]
        torque, masses = np.log([row.gearbox.torque for row in own]), [row.mass() for row in own]
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


def _cast(row: Held) -> Sizing:
    shell = shell_around(row.sizing.arrangement.bodies)
    wall = 6.0 + 0.010 * 1e3 * max(shell.length, shell.girth / math.pi)
    return size(edited(design_of(row.gearbox), {"housing.wall_mm": wall}))


def figure(rows: Sequence[Held], path: str) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    mpl.rcParams["svg.hashsalt"] = "gearwright"
    import matplotlib.pyplot as plt

    drawn, axes = plt.subplots(figsize=(6.0, 5.2), layout="constrained")
    for status, name in _FAMILIES.items():
        own = [row for row in rows if row.gearbox.status == status]
        masses = [row.mass() for row in own]
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
