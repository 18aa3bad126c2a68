"""Pages of a flight, of a life of several missions and of a dynamic window."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields

from gearwright.base import (
    CELSIUS,
    KNOT,
    KWH,
    DesignError,
    Origin,
    digits_apart,
    largest,
    margin_text,
    shown,
    smallest,
    smallest_first,
    unit,
    written,
)
from gearwright.dynamics.motion import Error
from gearwright.dynamics.vibration import DynamicLoad, ShaftLoad
from gearwright.mission import Durability, Flight, FlownMix, LifeSizing
from gearwright.mission.lives import LoadLife, load_lives
from gearwright.mission.windows import DynamicWindow
from gearwright.render.figures.flights import (
    SHOWN,
    eaten_figure,
    heat_figure,
    life_figure,
    load_life_figure,
    mass_of_life_figure,
    power_figure,
    profile_figure,
    sankey_figure,
    spectrum_figure,
    stores_figure,
    window_figure,
)
from gearwright.render.grid import Table, table
from gearwright.render.pages.page import (
    UNSTAMPED,
    Number,
    Page,
    PageFigure,
    Section,
    Stamp,
    Tone,
    Verdict,
    figure,
    inputs,
    judged,
    quantity,
    reserve,
    set_page,
)
from gearwright.render.tables.checks import review_tables
from gearwright.render.tables.flights import (
    asked_table,
    bearing_table,
    forces_table,
    life_table,
    loss_table,
    mission_table,
    mode_table,
    part_table,
    phase_table,
)
from gearwright.render.words.design_file import entries
from gearwright.render.words.flights import (
    count_text,
    life_text,
    mix_notes as notes,
    ranges,
    totals,
    verdict,
    verdict_text,
    window_verdict,
)
from gearwright.render.words.sizing import energy_text
from gearwright.reviews import Review
from gearwright.sizing import Sizing

# ----------------------------------------------------------------------------------------------------------------------
# A flight as one self-contained HTML page: what it took, how hot it ran, what fails first and after how long.
# ----------------------------------------------------------------------------------------------------------------------


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


def _borne(flight: Flight) -> Iterator[PageFigure]:
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


# ----------------------------------------------------------------------------------------------------------------------
# A life of several missions as one self-contained HTML page, in the style of a flight's.
# ----------------------------------------------------------------------------------------------------------------------


def mix_page(flown: FlownMix, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        flown: As flown.
        stamp: Date of the page.
    """
    sections = (_life(flown), *(_mission(flown, name) for name in flown.flights))
    title = f"{flown.mix.name}: {flown.sizing.design.name}"
    return set_page(
        Page("Life of several missions", title, flown.mix.description, _mix_verdict(flown), tuple(_mix_numbers(flown)),
             sections, design=flown.sizing.design, stamp=stamp)
    )  # fmt: skip


def _mix_verdict(flown: FlownMix) -> Verdict:
    """Return whether it lives all flights; what is not rated leaves it open."""
    if flown.damage >= 1.0:
        return Verdict(Tone.BAD, "Does not live", verdict(flown))
    partial = bool(flown.life.unrated) or any(lived.is_partial for lived in flown.lives.values())
    tone, word = (Tone.OPEN, "Lives as far as rated") if partial else (Tone.GOOD, "Lives all flights")
    return Verdict(tone, word, verdict(flown))


def _mix_numbers(flown: FlownMix) -> Iterator[Number]:
    if flown.life.parts and flown.life.parts[0].damage:
        first = flown.life.parts[0]
        yield Number(f"first to fail: {first.name}", f"{count_text(first.flights)} flights")
        miner = Origin("D = Σ n_i/N_i", "Palmgren 1924, Miner 1945")
        yield Number(
            "Miner's sum", written(flown.damage, digits_apart(flown.damage, 1.0, 3)), value=flown.damage, origin=miner
        )
    yield Number("flights", f"{flown.mix.flights}")
    yield quantity("flight time", flown.duration, "life")
    yield quantity("fuel of one gearbox", flown.fuel, "mass")
    if any(flight.has_battery for flight in flown.flights.values()):
        yield quantity("from the battery", flown.battery, "electric_energy")


def _life(flown: FlownMix) -> Section:
    """Return what the whole life comes to."""
    tables = tuple(table for table in (mission_table(flown), part_table(flown)) if table.rows)
    drawn = figure(eaten_figure(flown), "eaten", "Which mission eats the life of a part, by Palmgren and Miner.")
    words = (f"{totals(flown)}.", *(f"{note}." for note in notes(flown)))
    return Section("The whole life", tables=tables, figures=(drawn,), notes=words)


def _mission(flown: FlownMix, name: str) -> Section:
    """Return one flight of a mission: what it does, what it loads, what it wears."""
    flight, lived, count = flown.flights[name], flown.lives[name], flown.mix.count(name)
    figures = [
        figure(profile_figure(flight), f"{name}-profile", f"{name}: phases and who drives in them."),
        figure(power_figure(flight), f"{name}-power", f"{name}: powers of the machines and torques of the shafts."),
        figure(spectrum_figure(flight), f"{name}-spectrum", f"{name}: turns at which a load is reached, one flight."),
    ]
    if lived.failing:
        figures.append(figure(life_figure(lived), f"{name}-lives", f"{name}: flights that parts live, flown alone."))
    forces = forces_table(flight)
    words = f"{flight.mission.name}, {count:g} of {flown.mix.flights} flights. {flight.mission.description}"
    return Section(
        name, tables=(phase_table(flight), *([forces] if forces else ())), figures=tuple(figures), notes=(words,)
    )


# ----------------------------------------------------------------------------------------------------------------------
# A dynamic window as one self-contained HTML page: what every speed, torque and force did, beside what is sized.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Span:
    """What one quantity did, in the units of the screen."""

    quantity: str
    start: float
    minimum: float
    maximum: float
    end: float
    unit: str


def window_page(window: DynamicWindow, sizing: Sizing, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        window: As flown.
        sizing: That flew.
        stamp: Date of the page.
    """
    caption = f"Window {window.name}: speeds, pitch, bands from least to greatest, and its end at every step."
    seen = figure(window_figure(window), "window", caption)
    drawn = Section("What happened", figures=(seen,), tables=(_spans(window),))
    peaks = Section("Peaks beside what is sized for", tables=tuple(_window_peaks(window)))
    steps = Section("How it was computed", notes=tuple(_steps(window)))
    rules = window.rules
    event = "nothing but the mission" if rules.event == "none" else f"{rules.event} after {rules.event_at:g} s"
    told = f"{window.trace.duration:.4g} s of {rules.phase} from {window.start:.0f} s of the mission; {event}."
    return set_page(
        Page("Dynamic window", f"{window.name}: {sizing.design.name}", told, _window_verdict(window),
        tuple(_window_numbers(window)),
             (drawn, peaks, steps), design=sizing.design, stamp=stamp)
    )  # fmt: skip


def _margins(window: DynamicWindow) -> dict[str, float]:
    """Return part -> the least margin that its peak leaves."""
    meshes = {load.mesh: min(load.bending_margin, load.contact_margin) for load in window.meshes}
    return meshes | {f"{load.shaft} shaft": load.margin for load in window.shafts}


def _window_verdict(window: DynamicWindow) -> Verdict:
    margins = _margins(window)
    broken = smallest_first(
        sorted((margin, part) for part, margin in margins.items() if margin < 1.0), lambda pair: pair[0]
    )
    said = f"{window_verdict(window)}."
    if broken:
        words = f"{len(broken)} of {len(margins)} meshes and shafts break a margin, most of all {broken[0][1]}."
        return Verdict(Tone.BAD, "Fails", f"{words} {said}")
    if window.limit_cycle is not None or (window.rules.event == "sudden-stop" and window.rest is None):
        return Verdict(Tone.OPEN, "Holds, but does not settle", said)
    return Verdict(Tone.GOOD, "Holds", said)


def _window_numbers(window: DynamicWindow) -> Iterator[Number]:
    margins = _margins(window)
    if margins:
        part = smallest(margins, lambda name: margins[name])
        yield Number(f"least margin: {part}", margin_text(margins[part]), "", margins[part])
    if window.meshes:
        load = largest(window.meshes, lambda mesh: mesh.peak_over_mean)
        yield Number(f"peak over mean: {load.mesh}", written(load.peak_over_mean, 3), "", load.peak_over_mean)
        force = largest(window.meshes, lambda mesh: mesh.peak_force)
        yield quantity(f"largest tangential force: {force.mesh}", force.peak_force, "force")
    if window.shafts:
        shaft = largest(window.shafts, lambda row: row.peak_torque)
        yield quantity(f"largest torque: {shaft.shaft}", shaft.peak_torque, "torque")
    yield quantity("flown", window.trace.duration, "time")


def _spans(window: DynamicWindow) -> Table:
    rows = [
        _Span(
            row.name,
            shown(row.start, row.dimension),
            shown(row.minimum, row.dimension),
            shown(row.maximum, row.dimension),
            shown(row.end, row.dimension),
            unit(row.dimension),
        )
        for row in ranges(window)
    ]
    return table("Start, least, greatest and end", rows, tuple(field.name for field in fields(_Span)))


def _window_peaks(window: DynamicWindow) -> Iterator[Table]:
    yield table("Meshes", window.meshes, tuple(field.name for field in fields(DynamicLoad)))
    yield table("Shafts", window.shafts, tuple(field.name for field in fields(ShaftLoad)))


def _steps(window: DynamicWindow) -> Iterator[str]:
    trace = window.trace
    yield (
        f"Steps of {trace.step * 1e6:.3g} µs, {trace.method}; {Error(trace.error, trace.rms_error).words()}; energies"
        f" close {energy_text(trace.work.imbalance)}."
    )
    yield from trace.notes
