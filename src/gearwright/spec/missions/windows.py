"""Windows of a mission file: seconds of flight in which propeller, governor and machines move the elastic train."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Literal

from pydantic import Field

from gearwright.errors import Problem, near
from gearwright.spec.record import Record
from gearwright.units import Angle, Power, Ratio, Speed, Time, Torque, Velocity


class GovernorRules(Record):
    """The propeller's governor; its defaults come to rest within seconds on shipped propellers."""

    gain_deg_s: float = Field(1.0, ge=0, le=1000, description="K_p: pitch for a speed error, deg/(rad/s)")
    integral_deg_rad: float = Field(0.5, ge=0, le=1000, description="K_i: pitch for its integral, deg/rad")
    time_constant: Time = Field(0.1, gt=0, le=100, description="Of the actuator; of second order 1/ω_0")
    damping: Ratio = Field(0.7, ge=0, le=10, description="ζ of an actuator of second order; 0: first order")
    rate_deg_s: float = Field(10.0, gt=0, le=1e6, description="Fastest pitch change, deg/s")
    lowest_pitch: Angle | None = Field(
        None, ge=-0.5, le=1.6, description="Fine stop; left out: the pitch that the phase holds, or the map's end"
    )
    highest_pitch: Angle | None = Field(None, ge=-0.5, le=1.6, description="Coarse stop; left out: the map's end")
    reference_pitch: Angle | None = Field(
        None, ge=-0.5, le=1.6, description="Pitch without a speed error; left out: that at the window's start"
    )


EVENTS: Mapping[str, tuple[str, ...]] = {
    "none": (),
    "motor-cut": (),
    "turbine-cut": (),
    "mode-change": ("mode",),
    "pitch-step": ("pitch_step",),
    "speed-step": ("speed_step",),
    "gust": ("gust",),
    "clutch-engagement": ("clutch", "slip"),
    "motor-short-circuit": ("back_emf_v", "inductance_mh", "pole_pairs"),
    "engine-out": ("lag",),
    "pitch-runaway": ("overspeed",),
    "power-slam": ("power",),
    "propeller-strike": ("lasts",),
    "sudden-stop": (),
}
"""Event -> what a window must say about it."""


SHORTEST_STOP = 0.01
"""Stop that is sudden for a train whose lowest torsional mode is some tens of Hz [s]."""


class WindowRules(Record):
    """One window; what the mission does goes on in it, and its event comes on top."""

    phase: str = Field(description="Phase in which it starts")
    at: Time = Field(0.0, ge=0, le=1e6, description="Its start, from the start of the phase")
    duration: Time = Field(10.0, gt=0, le=1e4, description="Its length")
    event: Literal[
        "none", "motor-cut", "turbine-cut", "mode-change", "pitch-step", "speed-step", "gust", "clutch-engagement",
        "motor-short-circuit", "engine-out", "pitch-runaway", "power-slam", "propeller-strike",
        "sudden-stop",
    ] = Field("none", description="What happens in it")  # fmt: skip
    event_at: Time = Field(1.0, ge=0, le=1e4, description="When, from the window's start")
    over: Time = Field(0.1, gt=0, le=1e3, description="Time that the change takes; a phase's change of power, too")
    mode: Literal["conventional", "hybrid", "electric"] | None = Field(
        None, description="Who drives after a mode change"
    )
    electric_share: Ratio | None = Field(None, ge=-0.9, le=1, description="Motors' part of the power after it")
    power: Power | None = Field(None, gt=0, le=1e9, description="Power of all machines after it; left out: as before")
    pitch_step: Angle | None = Field(None, ge=-0.5, le=0.5, description="Step of the governor's reference pitch")
    speed_step: Speed | None = Field(None, ge=-1e3, le=1e3, description="Step of the set speed of the propeller")
    gust: Velocity | None = Field(None, ge=-100, le=100, description="Gust along the axis: its top, or its step")
    gust_shape: Literal["1-cos", "step"] = Field("1-cos", description="1-cos lasts `over`; a step stays")
    clutch: str | None = Field(None, description="Clutch that engages")
    slip: Speed | None = Field(None, gt=0, le=1e4, description="By how much its driving shaft is slower at first")
    capacity: Torque | None = Field(
        None, gt=0, le=1e9, description="Torque at which a friction clutch slips once engaged"
    )
    machine: str | None = Field(
        None,
        description="Motor or turbine that fails, left out: the only one; or what a sudden stop holds: the propeller",
    )
    back_emf_v: float | None = Field(
        None, ge=0, le=1e5, description="E of the motor: rms voltage of a phase, without load at the rated speed, V"
    )
    inductance_mh: float | None = Field(
        None, ge=1e-6, le=1e6, description="L of the motor: synchronous, of a phase without saliency, mH"
    )
    resistance_ohm: float | None = Field(
        None, ge=0, le=1e3, description="R of a phase; left out: estimated from the motor's copper loss"
    )
    pole_pairs: int | None = Field(None, ge=1, le=200, description="p of the motor")
    lag: Time | None = Field(
        None,
        gt=0,
        le=100,
        description="Time constant of a turbine that fails or speeds up; left out in a slam: by engine.spool;"
        " in a sudden stop of all, left out: they go on",
    )
    overspeed: Ratio | None = Field(
        None, gt=1, le=2, description="Speed that the overspeed governor holds, over the set speed"
    )
    strike_torque: Torque | None = Field(None, gt=0, le=1e9, description="That stops the propeller when it strikes")
    brake_torque: Torque | None = Field(None, gt=0, le=1e9, description="That holds the shaft in a sudden stop")
    stop_time: Time | None = Field(
        None, gt=0, le=1e6, description="In place of one: in which such a torque would stop everything that turns"
    )
    lasts: Time | None = Field(None, gt=0, le=1e4, description="How long the propeller strikes")
    stiffness: Literal["constant", "varying"] | None = Field(
        None, description="Mesh stiffness; left out: as the design says"
    )
    turbine_slope: Ratio = Field(
        1.0, ge=0, le=5, description="κ of T = u (1 + κ (1 − ω/ω_r)) of turbines; 0: sources of torque"
    )
    losses: bool = Field(True, description="Mesh losses as torques on the shafts; false: a train without losses")
    governor: GovernorRules | None = Field(None, description="In place of the mission's governor")


def window_problems(windows: Mapping[str, WindowRules], phases: Collection[str], *, spools: bool) -> Iterator[Problem]:
    """Yield what does not fit together in the windows of a mission.

    Args:
        windows: By name.
        phases: Names of the mission's phases.
        spools: Whether its turbines have a gas generator.
    """
    for name, window in windows.items():
        at = f"windows.{name}"
        if window.phase not in phases:
            yield Problem(f"{at}.phase", f"no such phase: {window.phase}; {near(window.phase, phases)}")
        for field in EVENTS[window.event]:
            if getattr(window, field) is None:
                yield Problem(at, f"{window.event} without {field}; give one")
        if window.event == "power-slam" and window.lag is None and not spools:
            yield Problem(at, "power-slam without lag; give one, or [engine.spool]")
        if window.mode == "hybrid" and window.electric_share is None:
            yield Problem(at, "hybrid without electric_share; give the motors' part of the power, such as 0.3")
        if window.event == "propeller-strike":
            yield from _strike(at, window)
        if window.event == "sudden-stop":
            yield from _stop(at, window)
        if window.event != "none" and window.event_at >= window.duration:
            yield Problem(
                f"{at}.event_at", f"{window.event_at:g} s, but the window ends at {window.duration:g} s; start earlier"
            )


def _strike(at: str, window: WindowRules) -> Iterator[Problem]:
    """Yield what is wrong with a propeller that strikes."""
    if (window.strike_torque is None) == (window.stop_time is None):
        yield Problem(at, "propeller-strike takes either strike_torque or stop_time; give one of them")
    if window.stop_time is not None and window.lasts is not None and window.lasts >= window.stop_time:
        yield Problem(
            f"{at}.lasts",
            f"{window.lasts:g} s, but everything stands still after stop_time, {window.stop_time:g} s; give less, or"
            ' event = "sudden-stop"',
        )


def _stop(at: str, window: WindowRules) -> Iterator[Problem]:
    """Yield what is wrong with a stop to rest."""
    if (window.brake_torque is None) == (window.stop_time is None):
        yield Problem(at, "sudden-stop takes either brake_torque or stop_time; give one of them")
    if window.stop_time is not None and window.stop_time < SHORTEST_STOP:
        yield Problem(
            f"{at}.stop_time",
            f"{window.stop_time:g} s is less than {SHORTEST_STOP:g} s, in which shafts hardly begin to twist: what is"
            " shorter loads them no more; give that",
        )
