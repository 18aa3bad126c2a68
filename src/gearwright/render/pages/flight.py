"""A flight as one self-contained HTML page: what it took, how hot it ran, what fails first and after how long."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields

from gearwright.dynamics.vibration import DynamicLoad, ShaftLoad
from gearwright.errors import DesignError
from gearwright.mission import Durability, Flight, LifeSizing
from gearwright.mission.lives import LoadLife, load_lives
from gearwright.mission.windows import DynamicWindow
from gearwright.render.figures.flights.flight import heat_figure, power_figure, profile_figure, stores_figure
from gearwright.render.figures.flights.lives import life_figure, mass_of_life_figure, spectrum_figure
from gearwright.render.figures.flights.load_lives import SHOWN, load_life_figure
from gearwright.render.figures.flights.sankey import sankey_figure
from gearwright.render.figures.flights.window import window_figure
from gearwright.render.grid.table import Table, table
from gearwright.render.pages.appendices import inputs
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
    Section,
    Stamp,
    figure,
    judged,
    quantity,
    reserve,
    set_page,
)
from gearwright.render.tables.checks import review_tables
from gearwright.render.tables.flight import (
    asked_table,
    bearing_table,
    forces_table,
    life_table,
    loss_table,
    mode_table,
    phase_table,
)
from gearwright.render.words.flights.flight import count_text, life_text, verdict_text
from gearwright.render.words.flights.window import window_verdict
from gearwright.render.words.headline import energy_text
from gearwright.render.words.inputs import entries
from gearwright.reviews import Review
from gearwright.units import CELSIUS, KNOT, KWH

_LITRE_PER_MINUTE, _MILE, HOUR = 1e-3 / 60.0, 1852.0, 3600.0
BASIS = (
    ("Air", "standard atmosphere with offset; CAS, TAS and Mach by Saint-Venant", "ISO 2533:1975"),
    ("Propeller", "map J × β → C_P, C_T", "NASA CR-114399 (shipped maps), or a file of the user"),
    ("Need of thrust", "(D + m g sin γ + m dV/dt)/engines, C_D = C_D0 + k C_L²", "Newton along the path"),
    (
        "Turbine",
        "P ∝ δ_t θ_t^n and a Willans line, or the deck that [engine] names, whose power is of a standard day and"
        " otherwise goes with θ_t^n; n of engines by their components; flat rating, torque limit",
        "benchmarks/temperature_lapse.py; the deck's file",
    ),
    ("Motor", "k_c T² + k_i ω + k_w ω³ + C", "Larminie and Lowry 2012, eq. 7.23"),
    ("Battery", "V_oc(s) − R I, with limits of charge and C-rate", "first-order circuit"),
    ("Torques", "statics of the train with the losses of its meshes", "power flow with λ, the torque per tooth"),
    ("Oil", "Q = P/(ρ c ΔT) at the greatest heat; U A = P/(T_oil − T_air)", "heat balance"),
    ("Gears", "stresses of ISO 6336-2 and -3 in 40 load classes, Miner's sum", "ISO 6336-6:2019"),
    ("Bearings", "equivalent load of every interval, Miner's sum", "ISO 281:2007"),
)
"""Quantity, model, source."""


def flight_page(
    flight: Flight,
    parts: Durability,
    review: Review,
    *,
    life: LifeSizing | None = None,
    windows: Sequence[DynamicWindow] = (),
    stamp: Stamp = UNSTAMPED,
) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        flight: As flown.
        parts: Lives of its gears and bearings.
        review: Of the gearbox that flew.
        life: How the design was strengthened, if it was.
        windows: Of its mission, as flown dynamically.
        stamp: Date of the page, and lines of the mission file.
    """
    sections = [_verdict(flight, parts, review, life), *_way(flight), *_effects(flight, parts)]
    if life is not None:
        drawn = figure(mass_of_life_figure(life), "mass", "Round by round: the stage that fails first is strengthened.")
        sections.append(Section("What a life costs", figures=(drawn,), notes=(f"{life_text(life)}.",)))
    if flight.mission.windows:
        sections.append(_windows(flight, windows))
    written = [entry for entry in entries(flight.mission) if not entry.path.startswith("phases.")]
    given, default = inputs(written, of="mission", lines=stamp.lines)
    rows = [_Model(*row) for row in BASIS]
    models = Section("Models", tables=(table("", rows, ("of", "model", "source")),))
    design, mission = flight.sizing.design, flight.mission
    return set_page(
        Page("Flight", mission.name, f"Flown by {design.name}. {mission.description}", judged(review),
             tuple(_numbers(flight, parts, review)), tuple(sections), (models, given, default), design, stamp,
             footer=f"Steady flight in intervals of {mission.step:.0f} s at most; transients are not in it."
                    " Everything is that of one gearbox.")
    )  # fmt: skip


@dataclass(frozen=True)
class _Model:
    of: str
    model: str
    source: str


def _numbers(flight: Flight, parts: Durability, review: Review) -> Iterator[Number]:
    balance, first = flight.balance, next(iter(parts.parts), None)
    if first is not None and first.damage:
        scope = " of what is rated" if parts.is_partial else ""
        yield Number(f"first to fail{scope}: {first.name}", f"{count_text(first.flights)} flights")
    yield from reserve(review.worst)
    yield quantity("fuel", flight.fuel, "mass", digits=3)
    if flight.has_battery:
        yield quantity("charge", balance.battery, "electric_energy", digits=3)
    yield quantity("hottest oil", flight.hottest_oil - CELSIUS, "temperature", digits=3)
    yield quantity("gearbox efficiency", flight.efficiency(), "percent")
    yield quantity("flown", flight.duration, "life", digits=3)


def _windows(flight: Flight, flown: Sequence[DynamicWindow]) -> Section:
    """Return the dynamic windows: those that were flown as figures, and all of the mission by name."""
    figures = tuple(
        figure(window_figure(window), f"window{k}", f"Window {window.name}: {window_verdict(window)}.")
        for k, window in enumerate(flown)
    )
    named = ", ".join(f"{name} ({rules.phase}, {rules.event})" for name, rules in flight.mission.windows.items())
    note = f"Windows of the mission: {named}. Those that were flown with the page are drawn here."
    return Section("Dynamic windows", figures=figures, tables=tuple(_peaks(flown)), notes=(note,))


def _peaks(flown: Sequence[DynamicWindow]) -> Iterator[Table]:
    """Yield what every mesh row and shaft of each window carried at most, beside what it is sized for."""
    for window in flown:
        meshes = tuple(field.name for field in fields(DynamicLoad))
        yield table(f"Window {window.name}: peaks of meshes beside rated loads", window.meshes, meshes)
        shafts = tuple(field.name for field in fields(ShaftLoad))
        yield table(f"Window {window.name}: peaks of shafts beside rated torques", window.shafts, shafts)


def _verdict(flight: Flight, parts: Durability, review: Review, life: LifeSizing | None) -> Section:
    gear = next((row for row in parts.parts if not row.is_bearing and row.damage), None)
    notes = [f"{verdict_text(parts)}."]
    if gear is not None and gear is not parts.parts[0]:
        words = f"First gear to fail: {gear.name}, {gear.mode}, after {count_text(gear.flights)} flights"
        notes.append(f"{words} or {count_text(gear.life)} h.")
    notes += [*_took(flight), *([f"{life_text(life)}."] if life is not None else [])]
    tables = tuple(table for table in review_tables(review.checks) if table.rows)
    return Section("Verdict", tables=tables, notes=tuple(notes))


def _took(flight: Flight) -> Iterator[str]:
    """Yield what the flight took and how it was cooled, of one gearbox."""
    balance, history = flight.balance, flight.history
    words = f"One gearbox burns {flight.fuel:.1f} kg of fuel over {flight.distance / _MILE:.0f} NM"
    if flight.has_battery:
        words += (
            f" and takes {balance.battery / KWH:.1f} kWh from its battery, which ends at a state of charge of"
            f" {float(history.state_of_charge[-1]):.1%}"
        )
    fastest = float(history.true_airspeed.max()) / KNOT
    yield f"{words}; fastest {fastest:.0f} kt TAS, Mach {float(history.mach.max()):.3f}."
    yield (
        f"{flight.oil_flow / _LITRE_PER_MINUTE:.1f} l/min of oil carry the heat away; it leaves the gearbox with"
        f" {flight.hottest_oil - CELSIUS:.0f} °C at most, and the cooler needs"
        f" {flight.cooler_conductance:.0f} W/K."
    )
    yield f"Energies close {energy_text(balance.residual)}: fuel + battery = propeller + losses + stored."


def _way(flight: Flight) -> Iterator[Section]:
    """Yield what the flight did, over its time."""
    profile = figure(profile_figure(flight), "profile", "The mission: phases and who drives in them.")
    forces = forces_table(flight)
    yield Section("Mission", tables=(asked_table(flight), *([forces] if forces else ())), figures=(profile,))
    powers = figure(power_figure(flight), "power", "Powers of the machines, stacked, and torques of the shafts.")
    yield Section("Powers and torques", figures=(powers,))
    stores = figure(stores_figure(flight), "stores", "Fuel and battery of one gearbox.")
    yield Section("Fuel and charge", tables=(phase_table(flight), mode_table(flight)), figures=(stores,))
    flow = figure(sankey_figure(flight), "sankey", "Energy of the whole flight; bands are as wide as the energy.")
    yield Section("Energy", tables=(loss_table(flight),), figures=(flow,))
    heat = figure(heat_figure(flight), "heat", "Heat by kind, efficiency, and the oil.")
    yield Section("Heat and oil", figures=(heat,))


def _effects(flight: Flight, parts: Durability) -> Iterator[Section]:
    """Yield what the flight did to the parts."""
    spectrum = figure(spectrum_figure(flight), "spectrum", "Duty of one flight: turns at which a load is reached.")
    yield Section("Duty spectrum", figures=(spectrum,))
    lives = [figure(life_figure(parts), "lives", "Flights that each part lives.")] if parts.failing else []
    lives += _borne(flight)
    tables = tuple(table for table in (life_table(flight, parts), bearing_table(parts)) if table.rows)
    yield Section(
        "Damage and life", tables=tables, figures=tuple(lives), notes=tuple(f"{note}." for note in parts.notes)
    )


def _borne(flight: Flight) -> Iterator[Figure]:
    """Yield S-N curves with the spectrum of the asked life, where the teeth can be rated."""
    try:
        rows: tuple[LoadLife, ...] = load_lives(flight)
    except DesignError:  # the notes of the chapter say why
        return
    if not rows:
        return
    life = flight.sizing.design.service.life
    flights = life / flight.duration
    words = f"Loads that teeth bear, and get in the asked life of {life / HOUR:,.0f} h, {flights:,.0f} flights"
    left = len(rows) - SHOWN
    more = f"; {left} less damaged ones are not drawn" if left > 0 else ""
    yield figure(load_life_figure(rows, flights), "borne", f"{words}; D: Miner's sum{more}.")
