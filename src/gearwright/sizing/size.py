"""Sizing of a transmission from its design, with the torque, mass and inertia of its machines."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from gearwright.base import (
    BEYOND_SIZING,
    Check,
    DesignError,
    Kind,
    PartId,
    accepted,
    largest,
    refuse,
    unknown_waivers,
    verb,
)
from gearwright.machines import (
    LENGTH_RATIO,
    motor_diameter,
    motor_mass_ndarc,
    motor_mass_power_law,
    propeller_inertia,
    rotor_inertia,
    turbine_diameter,
    turbine_inertia,
)
from gearwright.sizing.answers import locking_checks
from gearwright.sizing.bearing_seats import named_room
from gearwright.sizing.bearings import planet_lives
from gearwright.sizing.losses import dipping
from gearwright.sizing.mass import as_made, refuse_dishes
from gearwright.sizing.places import (
    beside_checks,
    coaxial_checks,
    hollow_checks,
    keep_out_checks,
    order_checks,
    pin_checks,
    room_checks,
    settle,
)
from gearwright.sizing.planets import film_checks, fit_planets
from gearwright.sizing.rating import MESHES, Context, Known
from gearwright.sizing.result import PRELIMINARY, MachineSizing, Sizing, refuse_no_numbers
from gearwright.sizing.shafts import built_checks, carrier_checks, shaft_checks
from gearwright.sizing.shafts.bending import face_load_checks
from gearwright.sizing.stages import Geared, geared
from gearwright.sizing.teeth import CONSIDERED, EQUAL, Chosen, Trying, choose_teeth, stage_teeth
from gearwright.spec import Airscrew, Design, ElectricMachine, Machine, Turbine
from gearwright.spec.design import Given, Rotor, given_values
from gearwright.train import Train, build_train

# ----------------------------------------------------------------------------------------------------------------------
# Machines as the gearbox needs them: torque, mass of motors, inertia of what turns; how fast tips of rotors are.
# ----------------------------------------------------------------------------------------------------------------------


FASTEST_TIP = 250.0
"""Tip speed of a rotor that leaves the advancing blade some forward speed [m/s]: Mach 0.73 at sea level. The UH-1H with
14.63 m at 324 rpm has 248 m/s, faster than helicopters since; 200 to 225 m/s are usual."""
_MASS_LAWS = {"ndarc": motor_mass_ndarc, "thesis": motor_mass_power_law}


def size_machines(context: Context) -> tuple[MachineSizing, ...]:
    """Return every machine.

    Args:
        context: What sizing reads.
    """
    return tuple(_machine(context, name, machine) for name, machine in context.design.machines.items())


def machine_checks(context: Context) -> Iterator[Check]:
    """Yield the tip speed of every rotor in the case that turns it the fastest.

    Args:
        context: What sizing reads.
    """
    for name, machine in context.design.machines.items():
        if isinstance(machine, Rotor):
            case, speed = largest(
                ((case, abs(flow.speeds[machine.shaft])) for case, flow in context.flows.items()),
                lambda turning: turning[1],
            )
            yield Check(
                PartId(Kind.MACHINE, name), "tip speed", "UH-1H: 248 m/s, Mach 0.73", speed * machine.diameter / 2.0,
                FASTEST_TIP, "velocity", at_most=True, exponent=None, case=case,
            )  # fmt: skip


def _machine(context: Context, name: str, machine: Machine) -> MachineSizing:
    if machine.rating is not None and machine.asked_speed is not None:
        torque = machine.rating / machine.asked_speed
    else:
        torque = max(abs(flow.machine_torques[name]) for flow in context.flows.values())
    mass = _mass(context, name, machine, torque)
    given: float | None = getattr(machine, "inertia", None)
    return MachineSizing(
        name=name,
        kind=type(machine).__name__.lower(),
        shaft=machine.shaft,
        torque=torque,
        mass=mass,
        inertia=_inertia(machine, mass) if given is None else given,
        inertia_is_given=given is not None,
    )


def _mass(context: Context, name: str, machine: Machine, torque: float) -> float | None:
    if not isinstance(machine, ElectricMachine):
        return context.given.get(f"{name}.mass")
    return context.given.get(f"{name}.mass", _MASS_LAWS[machine.mass_law](torque))


def _inertia(machine: Machine, mass: float | None) -> float:
    """Return the estimated inertia; none of what is too various to estimate [kg m²]."""
    match machine:
        case Turbine():
            return turbine_inertia(machine.diameter or turbine_diameter(machine.speed))
        case ElectricMachine():
            return rotor_inertia(mass or 0.0, motor_diameter(mass or 0.0, LENGTH_RATIO[machine.flux]))
        case Airscrew():
            return propeller_inertia(machine.diameter, machine.blades)
        case _:
            return 0.0


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a design becomes a sized transmission.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def size(design: Design) -> Sizing:
    """Return the sized transmission: teeth, modules, widths, stresses, margins, shafts, carriers, masses.

    Of several choices of teeth that are sized in full the lightest is taken that passes its checks, if any does; at a
    preliminary level that with the lightest gears that pass theirs, or come nearest to it.

    Args:
        design: As `gearwright.read` gives it. Rated powers and every case of it are carried.

    Raises:
        DesignError: If speeds, teeth or torques cannot be had; with the path and what would do.
    """
    return _sized(design)


def size_unturned(design: Design) -> Sizing:
    """Return a sizing whose open axes stand where they stand first: masses to compare, no room to rely on.

    Args:
        design: As `size` takes it.

    Raises:
        DesignError: As `size`.
    """
    return _sized(design, still=True)


@np.errstate(all="ignore")  # what overflows or is no number does not pass the gate
def _sized(design: Design, *, still: bool = False) -> Sizing:
    """Return the transmission of the teeth that are taken at the level of a design."""
    given = given_values(design)
    refuse(given.problems)
    of = _of_nearest_gears if design.level == PRELIMINARY and design.teeth.sized == 1 else _lightest
    return of(design, build_train(design), given.values, still=still)


def _lightest(design: Design, train: Train, given: Mapping[str, Given], *, still: bool = False) -> Sizing:
    """Return of all choices of teeth that are sized in full the lightest that passes, or the lightest of all."""
    best = dict[bool, Sizing]()
    masses: Mapping[bool, list[float]] = {True: [], False: []}
    refused, known = list[DesignError](), MESHES.now()
    for choice in choose_teeth(design, train):
        try:
            sizing = completed(geared(design, train, choice, given=given, known=known), given, still=still)
        except DesignError as error:
            refused.append(error)
            continue
        passes = _passes(sizing)
        masses[passes].append(sizing.mass)
        if passes not in best or sizing.mass < best[passes].mass * (1.0 - EQUAL):
            best[passes] = sizing
    if not best:
        raise refused[0]
    taken, alike = best.get(True) or best[False], masses[True] or masses[False]
    sized = len(masses[True]) + len(masses[False])
    if taken.search is None or sized + len(refused) == 1:
        return taken
    search = replace(
        taken.search,
        sized=sized,
        failing=len(masses[False]),
        refused=len(refused),
        next_sized_mass=sorted(alike)[1] if len(alike) > 1 else math.inf,
    )
    return replace(taken, search=search)


def _passes(sizing: Sizing) -> bool:
    """Tell whether nothing fails."""
    return not any(check.fails for check in sizing.checks)


def _of_nearest_gears(design: Design, train: Train, given: Mapping[str, Given], *, still: bool = False) -> Sizing:
    """Return the transmission of the teeth whose gears come nearest to meeting everything, the lightest of equals."""
    choices = choose_teeth(considering(design), train)
    trying = Trying(lambda place: stage_teeth(train, choices[place]), [choice.gear_mass for choice in choices])
    known, refused, found = MESHES.now(), list[DesignError](), dict[int, Geared]()
    while (place := trying.next()) is not None:
        try:
            gears = geared(design, train, choices[place], given=given, known=known)
        except DesignError as error:
            refused.append(error)
            continue
        found[place] = gears
        trying.note(place, gears.nearness, gears.heaviness, mass=gears.mass)
    for tried in trying.ranked():
        try:
            sizing = completed(found[tried.place], given, still=still)
        except DesignError as error:
            refused.append(error)
            continue
        if sizing.search is None:
            return sizing
        failing = sum(one.nearness < 1.0 for one in trying.tried)
        search = replace(sizing.search, sized=len(found), failing=failing, refused=len(refused))
        return replace(sizing, search=search)
    raise refused[0]


def considering(design: Design) -> Design:
    """Return a design of which the search tells as many combinations as a preliminary sizing considers.

    Args:
        design: As read.
    """
    return design.model_copy(update={"teeth": design.teeth.model_copy(update={"sized": CONSIDERED})})


def sized_with(
    design: Design, train: Train, choice: Chosen, *, given: Mapping[str, Given], known: Known | None = None
) -> Sizing:
    """Return the transmission with chosen teeth and numbers of planets.

    Args:
        design: As read.
        train: Its graph.
        choice: Teeth, and numbers of planets that the design leaves open.
        given: Path -> value that the user gives instead of the computed one.
        known: What meshes have given with other teeth of the design, and are to give.
    """
    return completed(geared(design, train, choice, given=given, known=known), given)


def completed(found: Geared, given: Mapping[str, Given], *, still: bool = False) -> Sizing:
    """Return the transmission of sized gears: what planets turn on, what carries gears, and where all stands.

    Args:
        found: Gears and meshes.
        given: Path -> value that the user gives instead of the computed one.
        still: Whether open axes stay where they stand first, room or not.
    """
    context, meshes = found.context, found.meshes
    design, train, flows = context.design, context.train, context.flows
    gears = fit_planets(context, found.gears)
    settled = settle(context, gears, still=still)
    arrangement, shafts, carriers = settled.arrangement, settled.shafts, settled.carriers
    checks = [
        *found.checks,
        *(check for shaft in shafts for check in shaft_checks(shaft)),
        *(check for carrier in carriers for check in carrier_checks(carrier)),
        *(check for shaft in settled.built for check in built_checks(shaft, design)),
        *face_load_checks(context, gears, meshes, settled.built_shafts),
        *named_room(design, gears),
        *planet_lives(context, gears, carriers),
        *film_checks(context, gears, carriers),
        *pin_checks(design, {gear.name: gear for gear in gears}, carriers),
        *room_checks(arrangement, settled.rules),
        *coaxial_checks(arrangement, settled.rules.sets, settled.rules.built),
        *hollow_checks(context, gears, arrangement),
        *order_checks(context, arrangement),
        *beside_checks(context, arrangement),
        *keep_out_checks(design, arrangement.bodies),
        *locking_checks(design, train, context.teeth, flows),
        *machine_checks(context),
    ]
    refuse(unknown_waivers(checks, design.waivers, left=BEYOND_SIZING))
    sizing = Sizing(
        design=design,
        train=train,
        teeth=context.teeth,
        flows=flows,
        gears=gears,
        meshes=meshes,
        arrangement=arrangement,
        shafts=shafts,
        carriers=carriers,
        machines=size_machines(context),
        built_shafts=settled.built_shafts,
        bearings=settled.bearings,
        joints=settled.joints,
        checks=accepted(checks, design.waivers),
        given=given,
        search=found.choice.search,
    )
    dipping(sizing, design.losses.dip, "losses.dip")
    refuse_dishes(sizing)
    return refuse_no_numbers(as_made(sizing))
