"""Results of a flown mission by name: ``fly.…``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from gearwright.mission import Flight, GearDamage, fly, gear_damage, phase_summaries, size_for_life
from gearwright.sizing import TEXT, Named, Sizing, size
from gearwright.spec import Design, Flown, Mission

HOUR = 3600.0
_LIFE = ("fly.life", "fly.flights", "fly.governing")
_LIFE_ENDING, _OF_FLIGHT = ".life", "fly."


def flown(design: Design, mission: Mission, asked: Flown) -> tuple[Sizing, Flight]:
    """Return the sizing of a design and its flight; its gears are strengthened where a life is asked for.

    Args:
        design: What is sized.
        mission: What is flown.
        asked: With the life.

    Raises:
        DesignError: If the design cannot be sized or the mission cannot be flown.
        SolveError: If the life is out of reach.
    """
    if asked.life is not None:
        lasting = size_for_life(design, mission, asked.life / HOUR)
        return lasting.sizing, lasting.flight
    sizing = size(design)
    return sizing, fly(sizing, mission)


def asks_lives(names: Iterable[str]) -> bool:
    """Tell whether results need the damage of the gears.

    Args:
        names: Of the results.
    """
    return any(name in _LIFE or (name.startswith(_OF_FLIGHT) and name.endswith(_LIFE_ENDING)) for name in names)


def flight_results(
    flight: Flight, names: Iterable[str], damages: tuple[GearDamage, ...] | None = None
) -> dict[str, Named]:
    """Return the results of a flight by name; lives, and results of phases, only if a name asks for one.

    Args:
        flight: As flown.
        names: That are asked for.
        damages: Of its gears, where they are known.

    Returns:
        Of one gearbox: ``fly.fuel``, ``fly.battery_energy`` (taken from the store), ``fly.electric_share`` (motors'
        part of the machines' work), ``fly.charge`` (at the end), ``fly.minimum_charge``, ``fly.duration``,
        ``fly.efficiency`` (propeller's work over that and the losses of meshes, bearings and windage),
        ``fly.gearbox_loss`` (those losses);
        ``fly.PHASE.fuel``, ``.battery_energy``, ``.efficiency``; ``fly.life`` and ``fly.flights`` of the gear that
        fails first, ``fly.governing`` (its name and how it fails) and ``fly.GEAR.life``.

    Raises:
        DesignError: If a life is asked for and ISO 6336 does not rate the gears.
    """
    names, results = list(names), _whole(flight)
    if asks_lives(names):
        results |= _lives(damages or gear_damage(flight))
    if any(name.startswith(_OF_FLIGHT) and name not in results for name in names):
        results |= dict(_phases(flight))
    return results


def _whole(flight: Flight) -> dict[str, Named]:
    balance, charge = flight.balance, flight.history.state_of_charge
    lost = balance.gearbox_loss
    work = {name: float((machine.power * flight.history.duration).sum()) for name, machine in flight.machines.items()}
    motors = sum(work[name] for name in flight.sizing.design.motors)
    return {
        "fly.fuel": Named(flight.fuel, "mass"),
        "fly.battery_energy": Named(balance.battery, "electric_energy"),
        "fly.electric_share": Named(motors / sum(work.values()), "ratio"),
        "fly.charge": Named(float(charge[-1]), "ratio"),
        "fly.minimum_charge": Named(float(charge.min()), "ratio"),
        "fly.duration": Named(flight.duration, "life"),
        "fly.efficiency": Named(balance.propeller / (balance.propeller + lost), "ratio"),
        "fly.gearbox_loss": Named(lost, "electric_energy"),
    }


def _phases(flight: Flight) -> Iterator[tuple[str, Named]]:
    for phase in phase_summaries(flight):
        yield f"fly.{phase.name}.fuel", Named(phase.fuel, "mass")
        yield f"fly.{phase.name}.battery_energy", Named(phase.battery, "electric_energy")
        yield f"fly.{phase.name}.efficiency", Named(phase.efficiency, "ratio")


def _lives(damages: tuple[GearDamage, ...]) -> dict[str, Named]:
    worst = damages[0]
    lives = {f"fly.{row.gear}.life": Named(row.life * HOUR, "life") for row in reversed(damages)}
    return {
        "fly.life": Named(worst.life * HOUR, "life"),
        "fly.flights": Named(worst.flights, "number"),
        "fly.governing": Named(f"{worst.gear}, {worst.mode}", TEXT),
        **lives,
    }
