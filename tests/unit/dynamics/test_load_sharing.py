"""Closed-form load sharing: the force method against the displacement method, with teeth that part."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from gearwright.dynamics import DampingRatio, Model, Periodic, statics
from gearwright.dynamics.assembly import assemble, contacts_of
from gearwright.dynamics.equations import acceleration, errors_at, line_forces, redundancy, slow_position
from gearwright.dynamics.model import Member, PlanetarySet, PlanetError, add_planetary
from gearwright.dynamics.sharing import (
    allocate,
    drawn_set,
    error_sources,
    influences,
    load_sharing,
    mesh_load_factor,
    random_sets,
    share_coefficients,
    sharing_problem,
    tooth_cycle_shares,
    with_errors,
)
from gearwright.errors import DesignError, SolveError
from gearwright.parts.planetary import even_positions
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read
from gearwright.spec.design import PartErrors, Support


def paths(count, *, backlash=0.0, errors=(), torque=100.0):
    """A wheel driven by a pinion over `count` meshes side by side, of 1e8, 2e8, … N/m."""
    model = Model()
    pinion, wheel = model.rotation("pinion", inertia=1e-3, speed=100.0), model.rotation("wheel", inertia=1e-2)
    for k in range(count):
        error = (Periodic(constant=errors[k]),) if k < len(errors) else ()
        model.mesh(
            f"mesh-{k + 1}", {pinion: 0.05, wheel: -0.1}, stiffness=1e8 * (k + 1), backlash=backlash, errors=error,
            damping=DampingRatio(0.05),
        )  # fmt: skip
    model.load(pinion, constant=torque)
    model.load(wheel, constant=-2.0 * torque)
    return model.build()


@pytest.mark.parametrize("count", [1, 2, 5])
def test_each_further_path_is_one_redundancy(count):
    assert redundancy(paths(count)).count == count - 1


def test_parallel_paths_share_by_stiffness():
    """Springs side by side: f_j = F k_j/Σk."""
    assert redundancy(paths(3)).perfect == pytest.approx(2000.0 * np.array([1, 2, 3]) / 6.0)


def test_single_path_does_not_feel_errors():
    train = redundancy(paths(1))
    assert line_forces(train, np.array([1e-3])) == pytest.approx(train.perfect)


def balance(errors, backlash):
    """Forces of `paths(4)` from its one unknown, the pinion's way: Σ k g(s − e) = T/r_b, by bracketing."""
    stiffness = 1e8 * np.arange(1, 5)

    def force(way):
        stretch = way - errors
        return stiffness * (np.maximum(stretch, 0.0) + np.minimum(stretch + backlash, 0.0))

    return force(brentq(lambda way: np.sum(force(way)) - 2000.0, -1.0, 1.0, xtol=1e-16, rtol=1e-14))


@pytest.mark.parametrize("backlash", [1e-5, 3e-5, 1.0])
@pytest.mark.parametrize("seed", range(5))
def test_forces_are_right_where_teeth_touch_on_either_flank_or_part(seed, backlash):
    """Force method against the balance of forces; 1e-8 of the largest: rounds of contact stop at 1e-10."""
    errors = np.random.default_rng(seed).normal(0.0, 2e-5, 4)
    wanted = balance(errors, backlash)
    found = line_forces(redundancy(paths(4, backlash=backlash)), errors)
    assert found == pytest.approx(wanted, abs=1e-8 * np.max(np.abs(wanted)))


def test_forces_are_those_of_the_statics_while_teeth_touch():
    """The same potential by displacements; rounding."""
    errors = np.array([2e-6, -1e-6, 0.0, 1e-6])
    force = statics(paths(4, backlash=3e-5, errors=errors)).force
    assert line_forces(redundancy(paths(4, backlash=3e-5)), errors) == pytest.approx(force, rel=1e-9)


def test_many_sets_are_the_sets_one_by_one():
    """Parted sets must not disturb the others beside them."""
    train = redundancy(paths(4, backlash=3e-5))
    sets = np.random.default_rng(3).normal(0.0, 2e-5, (50, 4))
    together = line_forces(train, sets)
    assert np.any(np.abs(together) < 1e-6)
    assert together == pytest.approx(np.array([line_forces(train, each) for each in sets]), abs=2e-5)


def test_load_that_closes_no_line_is_refused():
    """Backlash without end and a torque backwards: nothing can carry."""
    train = redundancy(paths(2, backlash=math.inf, torque=-100.0))
    with pytest.raises(SolveError, match="closes no line"):
        line_forces(train, np.zeros(2))


def planets(count, *, floating, error=1e-5, force=4e4):
    """The set of the published closed form: rigid ring, carrier and pins; the first pin lags."""
    angle = math.radians(24.6)
    carrier = Member(5.0, 0.05, 0.08 / math.cos(angle))
    planetary = PlanetarySet(
        sun=Member(0.4, 1e-3, 0.035, support=0.0 if floating else math.inf),
        ring=Member(2.0, 0.1, 0.125, torsion=math.inf),
        carrier=carrier,
        planet=Member(0.66, 1e-3, 0.045),
        sun_mesh=StiffnessCurve(5e8),
        ring_mesh=StiffnessCurve(5e8),
        pressure_angles=(angle, angle),
        positions=even_positions(count),
        errors={1: PlanetError(tangential=-error)},
    )
    model = Model()
    add_planetary(model, planetary)
    model.load("carrier", constant=-force * carrier.radius)
    model.load("sun", constant=force * 0.035 / (2.0 * math.cos(angle)))
    return model.build()


@pytest.mark.parametrize("count", [3, 4, 5, 6])
@pytest.mark.parametrize("floating", [True, False])
def test_planets_share_as_the_published_closed_form_says(count, floating):
    """Ligata, Kahraman & Singh 2009 for every N: L_1 = 1/N + c K e/F, c = (N − 3)/N floating, (N − 1)/N not; K =
    4 cos² α/(1/k_s + 1/k_r). 1e-9: rounding.
    """
    system = planets(count, floating=floating)
    train = redundancy(system)
    force = line_forces(train, errors_at(system, np.zeros(1)))[0]
    suns = [k for k, name in enumerate(system.labels.lines) if name.startswith("sun-planet")]
    share = share_coefficients(force[suns]) / count
    part = (count - 3 if floating else count - 1) / count
    stiffness = 4.0 * math.cos(math.radians(24.6)) ** 2 / (2.0 / 5e8)
    assert share[0] == pytest.approx(1.0 / count + part * stiffness * 1e-5 / 4e4, abs=1e-9)
    assert mesh_load_factor(force[suns]) == pytest.approx(count * np.max(share))


def test_free_sun_takes_two_redundancies_out():
    """N planets on a fixed sun have N − 1 loops; a sun that floats in two directions leaves N − 3."""
    assert redundancy(planets(5, floating=False)).count == 4
    assert redundancy(planets(5, floating=True)).count == 2


def single_planetary(errors, *, support=None):
    design = read(shipped_design("single-planetary"))
    stage = next(iter(design.planetaries.values()))
    supports = {stage.sun: Support(radial=support)} if support else {}
    return size(design.model_copy(update={"errors": errors, "supports": supports}))


def test_designs_planets_feel_pin_errors():
    """A pin that lags presses its planet's flanks, through both meshes alike, and a free sun shares it out."""
    planet = "first.planet-1" if "first" in read(shipped_design("single-planetary")).planetaries else None
    name = planet or f"{next(iter(read(shipped_design('single-planetary')).planetaries))}.planet-1"
    shares = []
    for support in (None, 1000.0):
        sizing = single_planetary({name: PartErrors(pin_tangential=-20e-6)}, support=support)
        system = assemble(sizing, stiffness="constant")
        meshes = [line for line in system.labels.lines if ".sun-planet-" in line]
        train = redundancy(system)
        lines = [system.labels.lines.index(mesh) for mesh in meshes]
        shares.append(share_coefficients(line_forces(train, errors_at(system, np.zeros(1)))[0, lines]))
    assert abs(shares[0][0] - 1.0) > 0.01
    assert np.ptp(shares[1]) < (1e-4 if len(shares[1]) == 3 else np.ptp(shares[0]))


def test_error_of_a_part_that_is_not_there_is_refused():
    with pytest.raises(DesignError, match="no such gear, shaft or planet"):
        assemble(single_planetary({"sunn": PartErrors(eccentricity=1e-5)}))


def split(errors):
    design = read(shipped_design("face-gear-split-torque"))
    sizing = size(design.model_copy(update={"errors": errors}))
    system = assemble(sizing)
    return system, contacts_of(sizing, sizing.flows["rated"]), sizing.design.errors


def test_sources_add_up_to_the_errors_of_the_system():
    """Rounding only: the same projections, taken apart and put together."""
    errors = {
        "first.pinion": PartErrors(eccentricity=1e-5, phase=0.7, tooth_thickness=4e-6),
        "left": PartErrors(radial=2e-5, radial_angle=-1.1, axial=3e-6, eccentricity=1e-5, phase=0.4),
        "second.pinion.left": PartErrors(clocking=2e-4),
    }
    system, contacts, parts = split(errors)
    time = np.linspace(0.0, 0.05, 40)
    (alike,) = with_errors(system, drawn_set(error_sources(system, contacts, parts)))
    assert errors_at(alike, time) == pytest.approx(errors_at(system, time), abs=1e-18)


def test_clocking_beyond_the_backlash_is_refused():
    """150 µm on a base radius of 31.7 mm are 0.271°."""
    with pytest.raises(DesignError, match=r"do not go together; give at most 0\.271 deg"):
        split({"second.pinion.left": PartErrors(clocking=0.01)})


def test_equal_thickness_errors_cancel():
    """The pinion is in both paths, and both face gears alike."""
    errors = {f"first.{gear}": PartErrors(tooth_thickness=2e-5) for gear in ("pinion", "wheel.left", "wheel.right")}
    system, contacts, parts = split(errors)
    train = redundancy(system)
    found = influences(train, error_sources(system, contacts, parts), np.array([2, 3]))
    assert found[-1].effect == pytest.approx(0.0, abs=1e-12)
    force = line_forces(train, errors_at(system, np.zeros(1)))[0]
    assert force == pytest.approx(train.perfect, abs=1e-8)


def test_random_sets_keep_the_sizes_and_change_with_the_seed():
    system, contacts, parts = split({"left": PartErrors(eccentricity=2e-5, axial=1e-5)})
    sources = error_sources(system, contacts, parts)
    one, other = (random_sets(sources, 100, seed=seed) for seed in (1, 2))
    full = np.max(np.abs(drawn_set(sources).turning), axis=(0, 1))
    assert np.abs(one.turning[0]) == pytest.approx(np.tile(full, (100, 1)))
    assert not np.array_equal(one.turning, other.turning)


def test_allocation_reaches_the_target_and_spares_what_matters_least():
    system, contacts, parts = split({
        "left": PartErrors(eccentricity=5e-5), "first.wheel.left": PartErrors(eccentricity=5e-5),
    })  # fmt: skip
    train, lines = redundancy(system), np.array([2, 3])
    found = allocate(train, error_sources(system, contacts, parts), lines, target=0.51)
    assert found.reached == pytest.approx(0.51, abs=1e-6)
    cut = {row.error: row.allowed / row.given for row in found.sizes}
    assert cut["left eccentricity"] < cut["first.wheel.left eccentricity"]
    loose = allocate(train, error_sources(system, contacts, parts), lines, target=0.6)
    assert loose.cost == 0.0


def test_target_below_the_bias_is_refused():
    system, contacts, parts = split({"left": PartErrors(eccentricity=5e-5)})
    with pytest.raises(DesignError, match=r"without any error the most loaded path has 0\.502"):
        allocate(redundancy(system), error_sources(system, contacts, parts), np.array([2, 3]), target=0.501)


def test_tooth_cycle_takes_a_ripple_out():
    """A whole number of instants in a period: the mean of a sine over its period is nothing."""
    time = np.arange(400) * 1e-5
    ripple = 100.0 * np.sin(2.0 * np.pi * 1000.0 * time)
    force = np.column_stack([500.0 + ripple, 500.0 - ripple])
    assert tooth_cycle_shares(time, force, 1e-3) == pytest.approx(np.ones((301, 2)), abs=1e-12)
    with pytest.raises(DesignError, match="mesh period"):
        tooth_cycle_shares(time, force, 1.0)


def test_unknown_method_and_line_are_refused():
    with pytest.raises(DesignError, match="'exact' is none of auto"):
        load_sharing(paths(2), ["mesh-1", "mesh-2"], method="exact")
    with pytest.raises(DesignError, match="no such line; did you mean mesh-1"):
        load_sharing(paths(2), ["mesh-11"])


def test_planets_that_errors_pull_off_carry_nothing_and_the_others_all():
    """Tolerances far too wide: no share below nothing, and together one."""
    design = read(shipped_design("in-line"))
    errors = {f"second.planet-{k}": PartErrors(pin_tangential=2e-4 * (-1) ** k) for k in range(1, 6)}
    problem = sharing_problem(size(design.model_copy(update={"errors": errors})), "second")
    force = line_forces(problem.train, errors_at(problem.system, np.zeros(1)))[0, problem.places]
    total = np.sum(problem.train.perfect[problem.places])
    assert np.min(force) == pytest.approx(0.0, abs=1e-6 * total)
    assert np.sum(force) == pytest.approx(total, rel=1e-6)
    assert np.count_nonzero(force < 1e-6 * total) >= 2


def test_shaft_with_gears_of_two_frames_cannot_float():
    """The intermediate shaft carries one set's carrier and the next one's sun."""
    design = read(shipped_design("in-line"))
    sizing = size(design.model_copy(update={"supports": {"intermediate": Support(radial=1e7)}}))
    with pytest.raises(DesignError, match="gears of a planetary set and of another frame"):
        assemble(sizing)


@pytest.mark.parametrize("errors", [(2e-6, -1e-6, 0.0, 1e-6), (4e-5, -1e-5, 3e-5, -2e-5)])
def test_slow_position_balances_the_loads(errors):
    """Line forces at that place, from the plain right-hand side, carry the torque; also where teeth part."""
    system = paths(4, backlash=1e-3, errors=errors)
    rest = np.zeros(2)
    assert acceleration(system.arrays, 0.0, slow_position(system), rest) * system.arrays.mass == pytest.approx(
        rest, abs=1e-6
    )


def test_errors_that_turn_as_nothing_in_the_system_does_are_refused():
    with_sources = error_sources(*split({"left": PartErrors(eccentricity=1e-5)}))
    without, _, _ = split({})
    with pytest.raises(SolveError, match=r"no tone of the system turns at 216\.196 rad/s"):
        with_errors(without, drawn_set(with_sources))
