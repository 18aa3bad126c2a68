"""Checks of what the loads of propellers and rotors are taken from: contradictions, cases that there are not."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.base import Problem, near
from gearwright.spec.design import AIRSCREW_LOADS, FLIGHTS, Design, Propeller, Rotor

_MOMENT, _ACROSS, _ALONG = "hub_moment", "in_plane_force", "thrust"
_TURNS = 20.0
"""Largest rate of pitch or yaw [rad/s]."""


def airscrew_problems(design: Design) -> Iterator[Problem]:
    """Find what propellers and rotors say of their loads that contradicts itself or has no effect.

    Args:
        design: As typed.
    """
    for name, propeller in design.propellers.items():
        yield from _propeller(design, f"propellers.{name}", propeller)
    for name, rotor in design.rotors.items():
        yield from _rotor(f"rotors.{name}", rotor)


def _propeller(design: Design, path: str, propeller: Propeller) -> Iterator[Problem]:
    loads, stated = propeller.loads, propeller.stated_loads
    at = f"{path}.loads"
    if len(stated) == len(AIRSCREW_LOADS):
        yield from _without_effect(at, sorted(loads.model_fields_set), stated)
        return
    if {_MOMENT, _ACROSS} <= stated and "excitation_factor" in loads.model_fields_set:
        yield from _without_effect(at, ["excitation_factor"], stated & {_MOMENT, _ACROSS})
    known = {**dict.fromkeys(FLIGHTS), **dict.fromkeys(design.cases)}
    for case, flown in loads.cases.items():
        if case not in known:
            yield Problem(f"{at}.cases.{case}", f"there is no case {case!r}; {near(case, known)}")
        elif case in design.cases and design.cases[case].static:
            yield Problem(f"{at}.cases.{case}", "has no effect on a static case, which is flown nowhere; leave it out")
        elif not flown.model_fields_set:
            yield Problem(f"{at}.cases.{case}", "says nothing; give incidence_deg or airspeed_m_s, or leave it out")
    if not isinstance(loads.gyroscopic, str):
        rates = loads.gyroscopic
        if len(rates) != 2 or not all(0.0 <= rate <= _TURNS for rate in rates):
            message = (
                f"{rates} given; give the rates of pitch and yaw in rad/s, two numbers from 0 to {_TURNS:g} such as"
                ' [0.3, 0.3], or "cs25" or "cs23"'
            )
            yield Problem(f"{at}.gyroscopic", message)
    if loads.mass is not None and loads.blade_mass is not None and loads.mass < propeller.blades * loads.blade_mass:
        blades = propeller.blades * loads.blade_mass
        message = (
            f"{loads.mass:g} kg given, but its {propeller.blades} blades of blade_mass_kg = {loads.blade_mass:g} weigh"
            f" {blades:g} kg; give the mass of the whole propeller, at least that, or leave one of both out"
        )
        yield Problem(f"{at}.mass_kg", message)


def _rotor(path: str, rotor: Rotor) -> Iterator[Problem]:
    loads, stated = rotor.loads, rotor.stated_loads
    reads = {"hub": _MOMENT, "h_force": _ACROSS, "load_factor": _ALONG}
    for key, load in reads.items():
        if key not in loads.model_fields_set or load not in stated:
            continue
        value = getattr(loads, key)
        given = f'"{value}"' if isinstance(value, str) else f"{value:g}"
        message = f"{given} given, but {load} states that load in every case; leave one of both out"
        yield Problem(f"{path}.loads.{key}", message)


def _without_effect(path: str, keys: list[str], stated: frozenset[str]) -> Iterator[Problem]:
    words = " and ".join(key for key in AIRSCREW_LOADS if key in stated)
    for key in keys:
        yield Problem(f"{path}.{key}", f"has no effect: {words} are stated, and hold in every case; leave it out")
