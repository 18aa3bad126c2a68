"""Fits the law of motors' masses to the catalogue's public electric machines and holds other laws against them.

``python benchmarks/motor_masses.py`` prints the law with its band, what it is with each choice of rows, NDARC's law on
the same machines, and every row.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from gearwright.catalogue.electric_machines import (
    ANY_TIME,
    FOR_AIRCRAFT,
    NOT_READ,
    WITHOUT,
    PublicMachine,
    bias_and_band,
    fitted_law,
    public_machines,
)  # fmt: skip
from gearwright.machines import motor_mass, motor_mass_ndarc
from gearwright.units import RPM

SPEEDS = (20000, 10000, 4500, 1212)
"""At which 1005 kW are weighed [rpm]."""
MEGAWATT = 1005e3


def main() -> None:
    machines = public_machines()
    fitted = [machine for machine in machines if machine.is_fitted]
    print(f"{len(machines)} machines, {sum(one.read != NOT_READ for one in machines)} read, {len(fitted)} in the fit")
    print("| rows | number | a | b | c | 1σ | each left out | 1005 kW at 20 000, 10 000, 4500, 1212 rpm, kg |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for words, rows in choices(machines).items():
        told(words, rows)
    for words, law in (("fitted", motor_mass), ("NDARC's", lambda torque, _: motor_mass_ndarc(torque))):
        held(words, fitted, law)
    for machine in sorted(machines, key=lambda one: one.torque or 0.0):
        row(machine)


def choices(machines: Sequence[PublicMachine]) -> dict[str, list[PublicMachine]]:
    """Return the rows of the fit and of others that could be taken."""
    known = [one for one in machines if one.speed is not None and one.rating == ANY_TIME]
    alone = [one for one in known if one.inverter == WITHOUT]
    fitted = [one for one in alone if one.is_fitted]
    return {
        "the fit": fitted,
        "without its densest, Evolito D250": [one for one in fitted if one.name != "Evolito D250"],
        "of 30 kW and more": [one for one in fitted if one.power >= 30e3],
        "with the racing car's": [one for one in alone if one.read != NOT_READ],
        "with those from memory": [one for one in alone if one.use == FOR_AIRCRAFT],
        "with those of which nobody says whether an inverter is in": [
            one
            for one in known
            if one.inverter in (WITHOUT, "unknown") and one.read != NOT_READ and one.use == FOR_AIRCRAFT
        ],
    }


def told(words: str, rows: Sequence[PublicMachine]) -> None:
    fit = fitted_law(rows)
    a, b, c = fit.law
    kg = ", ".join(f"{a * (MEGAWATT / (rpm * RPM)) ** b * rpm**c:.0f}" for rpm in SPEEDS)
    print(
        f"| {words} | {len(rows)} | {a:.4f} | {b:.4f} | {c:.4f} | × {fit.band:.2f} | {100 * fit.left_out_bias:+.1f} %,"
        f" × {fit.left_out_band:.2f} | {kg} |"
    )


def held(words: str, rows: Sequence[PublicMachine], law: Callable[[float, float], float]) -> None:
    fast = [one for one in rows if (one.speed or 0.0) > 6000 * RPM]
    slow = [one for one in rows if (one.speed or 0.0) <= 3000 * RPM]
    parts = [(len(some), *bias_and_band(some, law)) for some in (rows, slow, fast)]
    said = "; ".join(f"{count}: {100 * bias:+.0f} %, × {band:.2f}" for count, bias, band in parts)
    print(f"{words} law on all, to 3000 rpm, above 6000 rpm: {said}")


def row(machine: PublicMachine) -> None:
    torque, speed = machine.torque, machine.speed
    if torque is None or speed is None:
        print(f"{machine.name}: {machine.power / machine.mass / 1e3:.1f} kW/kg, speed not stated")
        return
    print(
        f"{machine.name}: {machine.power / 1e3:.0f} kW, {speed / RPM:.0f} rpm, {torque:.0f} N m, {machine.mass:.1f} kg,"
        f" {machine.power / machine.mass / 1e3:.1f} kW/kg, law/mass {motor_mass(torque, speed) / machine.mass:.2f},"
        f" NDARC/mass {motor_mass_ndarc(torque) / machine.mass:.2f}{'' if machine.is_fitted else ' (not in the fit)'}"
    )


if __name__ == "__main__":
    main()
