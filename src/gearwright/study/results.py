"""Results of a study by name: flight, modes, simulation and review."""

import math
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from gearwright.dynamics import Outputs, modes, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import critical_speeds
from gearwright.mission import Flight, GearDamage, durability, fly, gear_damage, phase_summaries, size_for_life
from gearwright.reviews import Review, review_of
from gearwright.sizing import TEXT, Named, Sizing, size
from gearwright.spec import Design, Flown, Mission, Simulated

# ----------------------------------------------------------------------------------------------------------------------
# Results of a flown mission by name: ``fly.…``.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Results of the verbs beside size, by name: ``modes.…`` and ``simulate.…``.
# ----------------------------------------------------------------------------------------------------------------------


LISTED = 6
"""Natural frequencies that have a name."""
START = 0.25
"""Share of a simulated time that is left to the start [-]."""


def modal_results(sizing: Sizing) -> dict[str, Named]:
    """Return natural frequencies and critical speeds by name.

    Args:
        sizing: What was sized.

    Returns:
        ``modes.frequency_1`` … the lowest natural frequencies of the governing load case [Hz];
        ``modes.lowest_critical_speed``, of the first machine's shaft, of all load cases [rad/s];
        ``modes.critical_margin``: least separation margin of all that a review judges, |n/n_crit − 1| [-].
        Infinite where nothing is excited in the range that is looked at.
    """
    elastic = [frequency for frequency in modes(assemble(sizing)).frequency if frequency > 0.0]
    results = {
        f"modes.frequency_{k}": Named(float(frequency), "frequency")
        for k, frequency in enumerate(elastic[:LISTED], start=1)
    }
    cases = critical_speeds(sizing)
    excited = [crossing for case in cases for crossing in case.critical if crossing.excited]
    lowest = min((crossing.speed for crossing in excited), default=math.inf)
    judged = [crossing for case in cases for crossing in case.nearest]
    nearest = min((abs(crossing.separation_margin) for crossing in judged), default=math.inf)
    return {
        **results,
        "modes.lowest_critical_speed": Named(lowest, "speed"),
        "modes.critical_margin": Named(nearest, "ratio"),
    }


def simulated_results(sizing: Sizing, asked: Simulated) -> dict[str, Named]:
    """Return the forces of a simulated load case by name.

    Args:
        sizing: What was sized.
        asked: Load case and time.

    Returns:
        ``simulate.LINE.largest`` and ``.mean`` of every line's force or torque, and ``simulate.LINE.factor``, the
        largest over the mean [-]; ``simulate.largest_factor`` of all lines that carry a mean force. Of a pair with
        parallel meshes ``simulate.PAIR.share``, the largest share of the mean load that one of them carries, and
        ``simulate.PAIR.factor``, the largest force of one of them over an equal share [-].
    """
    system = assemble(sizing, asked.case)
    trace = simulate(system, asked.duration, outputs=Outputs(start=START * asked.duration)).whole()
    force, results, factors = trace.force, dict[str, Named](), [1.0]
    for k, line in enumerate(force.names):
        kind = "torque" if trace.labels.line_units[k] == "rad" else "force"
        largest = float(np.max(np.abs([force.minimum[:, k], force.maximum[:, k]])))
        mean = float(abs(np.mean(force.mean[:, k])))
        results[f"simulate.{line}.largest"] = Named(largest, kind)
        results[f"simulate.{line}.mean"] = Named(mean, kind)
        if mean > 1e-9 * largest:
            factors.append(largest / mean)
            results[f"simulate.{line}.factor"] = Named(factors[-1], "ratio")
    return {**results, "simulate.largest_factor": Named(max(factors), "ratio"), **dict(_shared(sizing, results))}


def _shared(sizing: Sizing, results: Mapping[str, Named]) -> Iterator[tuple[str, Named]]:
    """Yield how the parallel meshes of a pair share its load."""
    for stage in sizing.design.pairs:
        lines = [f"simulate.{mesh.name}" for mesh in sizing.train.meshes if mesh.stage == stage]
        means = [float(results[f"{line}.mean"].value) for line in lines]
        if len(lines) > 1 and sum(means) > 0.0:
            largest = max(float(results[f"{line}.largest"].value) for line in lines)
            yield f"simulate.{stage}.share", Named(max(means) / sum(means), "ratio")
            yield f"simulate.{stage}.factor", Named(largest * len(lines) / sum(means), "ratio")


# ----------------------------------------------------------------------------------------------------------------------
# Results of a review by name: ``review.…``.
# ----------------------------------------------------------------------------------------------------------------------


def review_results(sizing: Sizing, flight: Flight | None = None, *, life: float | None = None) -> dict[str, Named]:
    """Return what a review says, by name.

    Args:
        sizing: As sized.
        flight: Of it, where the study flies.
        life: Of gears that the study asks for [s].

    Returns:
        ``review.verdict`` and ``review.worst`` (the worst check) as texts, ``review.margin`` (its margin) and
        ``review.failing`` (checks that fail and are not waived).
    """
    lives = durability(flight) if flight is not None else None
    return named_review(review_of(sizing, flight, lives, life=life))


def named_review(reviewed: Review) -> dict[str, Named]:
    """Return a review by the names of its results.

    Args:
        reviewed: Of a design.
    """
    first = reviewed.worst
    margin = math.inf if first is None or first.margin is None else first.margin
    return {
        "review.verdict": Named(str(reviewed.verdict), TEXT),
        "review.worst": Named("" if first is None else first.name, TEXT),
        "review.margin": Named(margin, "ratio"),
        "review.failing": Named(float(len(reviewed.failing)), "number"),
    }
