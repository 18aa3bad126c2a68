"""Published planetary sets: natural frequencies by family, and load sharing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import modes, statics
from gearwright.dynamics.model import Member, Model, PlanetarySet, PlanetError, System, add_planetary, rotational
from gearwright.dynamics.vibration import load_shares, mode_families
from gearwright.parts.planetary import even_positions
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.validate.case import Case

ANGLE = math.radians(24.6)
"""Pressure angle of Lin & Parker's set [rad]."""


def member(mass: float, inertia: float, diameter: float, *, support: float, torsion: float) -> Member:
    """Return a member from Lin & Parker's kind of data.

    Args:
        mass: [kg].
        inertia: I/r² [kg].
        diameter: 2 r [m].
        support: Radial stiffness [N/m].
        torsion: Torsional stiffness in u = r θ [N/m].
    """
    radius = 0.5 * diameter
    return Member(mass, inertia * radius**2, radius, support=support, torsion=torsion * radius**2)


def lin_parker(planets: int) -> PlanetarySet:
    """Return the set of Lin & Parker 1999, table 1 (a stage of the OH-58).

    Args:
        planets: Number of planets [-].
    """
    return PlanetarySet(
        sun=member(0.4, 0.39, 0.07742, support=1e8, torsion=0.0),
        ring=member(2.35, 3.0, 0.27503, support=1e8, torsion=1e9),
        carrier=member(5.43, 6.29, 0.1768, support=1e8, torsion=0.0),
        planet=member(0.66, 0.61, 0.10035, support=1e8, torsion=0.0),
        sun_mesh=StiffnessCurve(5e8),
        ring_mesh=StiffnessCurve(5e8),
        pressure_angles=(ANGLE, ANGLE),
        positions=even_positions(planets),
    )


def cooley_parker(planets: int) -> PlanetarySet:
    """Return the set of Cooley & Parker 2012, table 1.

    Args:
        planets: Number of planets [-].
    """
    return PlanetarySet(
        sun=member(3.0, 1.75, 0.05575, support=2e7, torsion=2e7),
        ring=member(7.64, 8.09, 0.1097, support=1e8, torsion=1e8),
        carrier=member(12.0, 6.8, 0.0886, support=5e7, torsion=1e8),
        planet=member(1.86, 1.25, 0.027, support=1e7, torsion=0.0),
        sun_mesh=StiffnessCurve(1e8),
        ring_mesh=StiffnessCurve(1e8),
        pressure_angles=(math.radians(20.0),) * 2,
        positions=even_positions(planets),
    )


def build(planetary: PlanetarySet) -> System:
    """Return one planetary set as a system at rest.

    Args:
        planetary: The set.
    """
    model = Model()
    add_planetary(model, planetary)
    return model.build()


def by_family(planetary: PlanetarySet) -> dict[str, list[float]]:
    """Return the natural frequencies of each family [Hz], each of a pair.

    Args:
        planetary: The set.
    """
    system = build(planetary)
    solved = modes(system)
    groups: dict[str, list[float]] = {}
    for family, frequency in zip(mode_families(system, solved, planetary.positions), solved.frequency, strict=True):
        groups.setdefault(family, []).append(float(frequency))
    return groups


def _family(planetary: PlanetarySet, family: str, scale: float = 1.0) -> Sequence[float]:
    """Return the distinct frequencies of a family: one of each pair of translational modes, of N − 3 planet modes."""
    frequencies = by_family(planetary)[family]
    alike = {"translational": 2, "planet": len(planetary.positions) - 3}.get(family, 1)
    return [value / scale for value in frequencies[::alike]]


KAHRAMAN = {"m_s": 2.0, "m_p": 3.0, "m_c": 4.0, "k_s": 7.0, "k_r": 11.0, "n": 3}
"""Data for the closed form: masses in u = r θ [kg], mesh stiffnesses [N/m], planets."""


def kahraman_closed_form() -> tuple[float, ...]:
    """Return ω² = (k_s + k_r)/m_p, N − 1 times, and the roots of Λ² − bΛ + c, as frequencies [Hz].

    Source: Kahraman 1994, J. Sound Vib. 173, 125-130.
    """
    m_s, m_p, m_c, k_s, k_r, n = (KAHRAMAN[name] for name in ("m_s", "m_p", "m_c", "k_s", "k_r", "n"))
    b = k_r / m_p + k_r * n / m_c + k_s * n / m_s + k_s / m_p + k_s * n / m_c
    c = k_r * k_s * n * (m_c + m_p * n + 4.0 * m_s) / (m_c * m_p * m_s)
    squares = [0.0, *[(k_s + k_r) / m_p] * (int(n) - 1), *np.roots([1.0, -b, c])]
    return tuple(float(value) for value in np.sqrt(np.sort(squares)) / (2.0 * math.pi))


def kahraman() -> PlanetarySet:
    """Return a purely rotational set with the data of the closed form."""
    k, planet_mass, radius = KAHRAMAN, 0.1, 0.5
    angle = math.radians(20.0)
    carrier = k["m_c"] * (radius * math.cos(angle)) ** 2 - k["n"] * planet_mass * radius**2
    return rotational(
        PlanetarySet(
            sun=Member(1.0, k["m_s"] * 0.2**2, 0.2),
            ring=Member(1.0, 1.0, 0.7, torsion=math.inf),
            carrier=Member(1.0, carrier, radius, 1e9),
            planet=Member(planet_mass, k["m_p"] * 0.25**2, 0.25, 1e9),
            sun_mesh=StiffnessCurve(k["k_s"]),
            ring_mesh=StiffnessCurve(k["k_r"]),
            pressure_angles=(angle, angle),
            positions=even_positions(int(k["n"])),
        )
    )


def sharing(planets: int, *, sun_support: float, error: float = 1e-5, force: float = 4e4) -> Floats:
    """Return the shares of a set with rigid ring, carrier and pins whose first pin lags [-], shape (planets,).

    Args:
        planets: Number of planets [-].
        sun_support: Radial stiffness of the sun's bearing [N/m]; 0 floats.
        error: By which the first pin lags [m].
        force: Of the carrier at the pins [N].
    """
    sun, carrier = Member(0.4, 1e-3, 0.035), Member(5.0, 0.05, 0.08 / math.cos(ANGLE))
    planetary = PlanetarySet(
        sun=replace(sun, support=sun_support),
        ring=Member(2.0, 0.1, 0.125, torsion=math.inf),
        carrier=carrier,
        planet=Member(0.66, 1e-3, 0.045),
        sun_mesh=StiffnessCurve(5e8),
        ring_mesh=StiffnessCurve(5e8),
        pressure_angles=(ANGLE, ANGLE),
        positions=even_positions(planets),
        errors={1: PlanetError(tangential=-error)},
    )
    model = Model()
    add_planetary(model, planetary)
    model.load("carrier", constant=-force * carrier.radius)
    # In the rigid motion u_s = 2 η cos α, so the torques balance at T_s = F r_s / (2 cos α).
    model.load("sun", constant=force * sun.radius / (2.0 * math.cos(ANGLE)))
    system = model.build()
    return load_shares(statics(system).force, system.labels)


def largest_share(planets: int, *, sun_support: float) -> float:
    """Return the share of the planet whose pin lags by 10 µm at 40 kN, L_1 = 1/N + c K e/F [-].

    Args:
        planets: Number of planets N [-].
        sun_support: As for `sharing`.

    Source: Ligata, Kahraman & Singh 2009, J. Mech. Des. 131, for N = 4; by projection for every N:
        K = 4 cos² α/(1/k_s + 1/k_r), c = (N − 3)/N with a floating sun and (N − 1)/N without.
    """
    stiffness = 4.0 * math.cos(ANGLE) ** 2 / (1.0 / 5e8 + 1.0 / 5e8)
    part = (planets - 1 if math.isinf(sun_support) else planets - 3) / planets
    return 1.0 / planets + part * stiffness * 1e-5 / 4e4


LIN_PARKER: dict[int, dict[str, tuple[float, ...]]] = {
    3: {
        "rotational": (1475.7, 1930.3, 2658.3, 7462.8, 11775.3),
        "translational": (743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9),
    },
    4: {
        "rotational": (1536.6, 1970.6, 2625.7, 7773.6, 13071.1),
        "translational": (727.0, 1091.0, 1892.8, 2342.5, 7189.9, 10437.6),
        "planet": (1808.2, 5963.8, 6981.7),
    },
    5: {
        "rotational": (1567.4, 2006.1, 2614.8, 8065.4, 14253.1),
        "translational": (710.0, 1072.0, 1888.1, 2425.3, 7382.4, 11172.3),
        "planet": (1808.2, 5963.8, 6981.7),
    },
}
"""Planets -> family -> natural frequencies as printed [Hz]."""
COOLEY_PARKER: dict[int, dict[str, tuple[float, ...]]] = {
    3: {
        "rotational": (0.9296, 1.09, 1.358, 1.931, 5.566, 7.741),
        "translational": (0.7432, 1.018, 1.265, 1.487, 4.976, 6.282),
    },
    4: {
        "rotational": (0.9077, 1.046, 1.317, 2.013, 5.809, 8.383),
        "translational": (0.7199, 1.001, 1.317, 1.481, 5.153, 6.488),
        "planet": (0.9617, 4.320, 5.672),
    },
    5: {
        "rotational": (0.8802, 1.019, 1.281, 2.090, 6.030, 8.986),
        "translational": (0.6992, 0.9863, 1.344, 1.496, 5.317, 6.693),
        "planet": (0.9617, 4.320, 5.672),
    },
}
"""Planets -> family -> natural frequencies over √(k_p/m_p) as printed [-]."""
_SCALE = math.sqrt(1e7 / 1.86) / (2.0 * math.pi)


def _lin_parker_cases() -> list[Case]:
    source, reason = "Lin & Parker 1999, J. Vib. Acoust. 121, table 2", "printed to 0.1 Hz; four to 1 Hz"
    return [
        Case(f"planetary set, N = {planets}, {family} modes", source, "Hz", expected,
             partial(_family, lin_parker(planets), family), 5e-4, reason)
        for planets, families in LIN_PARKER.items()
        for family, expected in families.items()
    ]  # fmt: skip


def _cooley_parker_cases() -> list[Case]:
    source = "Cooley & Parker 2012, table 2, at rest (read in the tests of Rebouças' Drivetrain)"
    return [
        Case(f"planetary set, N = {planets}, {family} modes", source, "√(k_p/m_p)", expected,
             partial(_family, cooley_parker(planets), family, _SCALE), 5e-4, "four digits printed")
        for planets, families in COOLEY_PARKER.items()
        for family, expected in families.items()
    ]  # fmt: skip


def _sharing_cases() -> list[Case]:
    source = "Ligata, Kahraman & Singh 2009, J. Mech. Des. 131; by projection for every N"
    return [
        Case(f"largest share, N = {planets}, {name} sun", source, "", (largest_share(planets, sun_support=support),),
             partial(_largest, planets, support), 1e-9, "rounding")
        for name, support in (("floating", 0.0), ("fixed", math.inf))
        for planets in (3, 4, 5, 6, 7)
    ]  # fmt: skip


def _largest(planets: int, support: float) -> Sequence[float]:
    return [float(sharing(planets, sun_support=support)[0])]


def _four_shares() -> Sequence[float]:
    return [float(value) for value in sharing(4, sun_support=0.0)]


def _kahraman() -> Sequence[float]:
    return [float(value) for value in modes(build(kahraman())).frequency]


CASES = (
    *_lin_parker_cases(),
    *_cooley_parker_cases(),
    Case("purely rotational set, N = 3", "Kahraman 1994, J. Sound Vib. 173, closed form", "Hz", kahraman_closed_form(),
         _kahraman, 1e-9, "rounding"),
    *_sharing_cases(),
    Case("shares of four planets on a floating sun", "Ligata, Kahraman & Singh 2009, J. Mech. Des. 131", "",
         (0.301669, 0.198331, 0.301669, 0.198331), _four_shares, 6e-7, "six digits",
         is_relative=False),
)  # fmt: skip
"""Published planetary sets."""
