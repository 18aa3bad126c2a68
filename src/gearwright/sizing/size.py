"""The verb: a design becomes a sized transmission."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from gearwright.checks import BEYOND_SIZING, accepted, unknown_waivers
from gearwright.errors import DesignError, refuse
from gearwright.identity import Kind
from gearwright.sizing.answers import locking_checks, refuse_no_numbers
from gearwright.sizing.bearings import named_room, planet_lives
from gearwright.sizing.face_load import face_load_checks
from gearwright.sizing.limits import refuse_beyond
from gearwright.sizing.losses import dipping
from gearwright.sizing.machines import machine_checks, size_machines
from gearwright.sizing.mass import as_made
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
from gearwright.sizing.rating import Known, context_of, demands_of
from gearwright.sizing.result import PRELIMINARY, Sizing
from gearwright.sizing.shafts import built_checks, carrier_checks, shaft_checks
from gearwright.sizing.stages import compound_sizes, gear_checks, pass_checks, size_gears, size_meshes, stage_sizes
from gearwright.sizing.teeth import EQUAL, Chosen, choose_teeth, refuse_contradictions
from gearwright.spec import Design, edited
from gearwright.spec.design import Given, given_values
from gearwright.train import Train, Turning, build_train, power_flows
from gearwright.verbs import verb

LOCAL = (Kind.GEAR, Kind.MESH, Kind.STAGE)
"""Parts whose checks tooth numbers decide: roots, flanks, scuffing, contact ratio, undercut, tips, sliding, rims."""
LOOKED_AT = 6
"""Combinations of the lightest gears of which a preliminary sizing takes the first whose gears pass [-]."""


@verb
@np.errstate(all="ignore")  # what overflows or is no number does not pass the gate
def size(design: Design) -> Sizing:
    """Return the sized transmission: teeth, modules, widths, stresses, margins, shafts, carriers, masses.

    Of several choices of teeth that are sized in full the lightest is taken that passes its checks, if any does; at a
    preliminary level the first of the lightest whose gears pass theirs.

    Args:
        design: As `gearwright.read` gives it. Rated powers and every case of it are carried.

    Raises:
        DesignError: If speeds, teeth or torques cannot be had; with the path and what would do.
    """
    given = given_values(design)
    refuse(given.problems)
    best = dict[bool, Sizing]()
    masses: Mapping[bool, list[float]] = {True: [], False: []}
    refused, known = list[DesignError](), Known()
    train = build_train(design)
    lazily = design.level == PRELIMINARY and design.teeth.sized == 1
    for choice in choose_teeth(_looked_at(design) if lazily else design, train):
        try:
            sizing = sized_with(design, train, choice, given=given.values, known=known)
        except DesignError as error:
            refused.append(error)
            continue
        passes = _passes(sizing)
        masses[passes].append(sizing.mass)
        if passes not in best or sizing.mass < best[passes].mass * (1.0 - EQUAL):
            best[passes] = sizing
        if lazily and passes:
            break
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


def _looked_at(design: Design) -> Design:
    """Return a design of which as many combinations are sized as a preliminary sizing looks at."""
    return design.model_copy(update={"teeth": design.teeth.model_copy(update={"sized": LOOKED_AT})})


def _passes(sizing: Sizing) -> bool:
    """Tell whether teeth may be taken: nothing fails; at a preliminary level, nothing of the gears themselves."""
    local = sizing.level == PRELIMINARY
    return not any(check.fails and (not local or check.part.kind in LOCAL) for check in sizing.checks)


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
    teeth = choice.teeth
    if choice.planets:
        design = edited(design, {f"planetaries.{stage}.planets": count for stage, count in choice.planets.items()})
        train = build_train(design)
    efficiency = design.efficiencies
    flows = power_flows(design, Turning(design, train, teeth), efficiency=efficiency)
    refuse_contradictions(design, flows)
    refuse_beyond(design, flows)
    context = context_of(design, train, teeth, flows, given, known=known)
    demands = demands_of(context)
    sizes = stage_sizes(context, demands) | compound_sizes(context, demands)
    gears = fit_planets(context, size_gears(context, sizes))
    meshes = size_meshes(context, gears, demands)
    settled = settle(context, gears)
    arrangement, shafts, carriers = settled.arrangement, settled.shafts, settled.carriers
    checks = [
        *gear_checks(context, gears, meshes, sizes),
        *pass_checks(context),
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
        *locking_checks(design, train, teeth, flows),
        *machine_checks(context),
    ]
    refuse(unknown_waivers(checks, design.waivers, left=BEYOND_SIZING))
    sizing = Sizing(
        design=design,
        train=train,
        teeth=teeth,
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
        search=choice.search,
    )
    dipping(sizing, design.losses.dip, "losses.dip")
    return refuse_no_numbers(as_made(sizing))
