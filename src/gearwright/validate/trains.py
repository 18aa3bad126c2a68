"""Published planetary stages and automatic transmissions: frequencies, ratios, losses and profile shifts."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.dynamics.equations import modes, statics
from gearwright.dynamics.model import Member, Model, PlanetarySet, PlanetError, System, add_planetary, rotational
from gearwright.dynamics.vibration import load_shares, mode_families
from gearwright.parts.gears import CylindricalGear, span_measurement
from gearwright.parts.planetary import even_positions
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.spec import GROUND, Design, parse
from gearwright.spec.design import CompoundShifts, compound_shifts
from gearwright.train import PowerFlow, build_train, power_flow, teeth_of
from gearwright.validate.case import Case

# ----------------------------------------------------------------------------------------------------------------------
# Published planetary sets: natural frequencies by family, and load sharing.
# ----------------------------------------------------------------------------------------------------------------------


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


PLANETARY_CASES = (
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


# ----------------------------------------------------------------------------------------------------------------------
# Automatic transmissions as trains: simple and Ravigneaux sets, what is joined for good, what each gear closes.
# ----------------------------------------------------------------------------------------------------------------------


POWER, SPEED = 100.0, 1000.0
"""Of the input [kW, rpm]; ratios do not depend on them."""


@dataclass(frozen=True)
class Ravigneaux:
    """Teeth of a Ravigneaux set: small sun - short planets - long planets - ring, and large sun - long planets."""

    small_sun: int
    large_sun: int
    ring: int
    short: int
    long: int


@dataclass(frozen=True)
class Automatic:
    """A transmission, and what its gears close."""

    name: str
    simple: Mapping[str, tuple[int, int]]
    """Set -> teeth of sun and ring; its members are S, R and C with the name, such as ``S1``."""
    joined: tuple[tuple[str, str], ...]
    """Members joined for good, among them ``input`` and ``output``."""
    elements: Mapping[str, tuple[str, str]]
    """Clutch or brake -> what it joins; a brake joins the ground."""
    gears: Mapping[str, str]
    """Gear -> letters of the elements that are closed."""
    ravigneaux: Mapping[str, Ravigneaux] = field(default_factory=dict)
    """Set -> its teeth; its members are s (small sun), S, R and C with the name."""

    def flow(self, gear: str, efficiencies: Mapping[str, float] | None = None) -> PowerFlow:
        """Return speeds and torques in one gear, the input at rated power.

        Args:
            gear: One of its gears.
            efficiencies: Mesh by its end, such as ``sun-planet`` -> efficiency [-]; left out: lossless.
        """
        design = self.design(gear)
        teeth = {name: value for stage in design.epicyclics for name, value in teeth_of(design, stage).items()}
        train = build_train(design)
        lost = {mesh.name: (efficiencies or {}).get(mesh.own, 1.0) for mesh in train.meshes}
        return power_flow(design, train, teeth, efficiency=lost)

    def ratio(self, gear: str) -> float:
        """Return speed of the input over that of the output [-]."""
        speeds, ends = self.flow(gear).speeds, self.nodes(gear)
        return speeds[ends["input"]] / speeds[ends["output"]]

    def torque_ratio(self, gear: str, efficiencies: Mapping[str, float]) -> float:
        """Return torque that the output gives over the input's, with losses [-].

        Args:
            gear: One of its gears.
            efficiencies: As of `flow`.
        """
        torques = self.flow(gear, efficiencies).machine_torques
        return -torques["load"] / torques["engine"]

    def nodes(self, gear: str) -> dict[str, str]:
        """Return member -> the shaft, or the ground, that it is in one gear.

        Args:
            gear: One of its gears.
        """
        members = [f"{kind}{name}" for name in self.simple for kind in "SRC"]
        members += [f"{kind}{name}" for name in self.ravigneaux for kind in "sSRC"]
        brakes = [ends for ends in self.closed(gear).values() if GROUND in ends]
        return _merged([GROUND, "input", "output", *members], [*self.joined, *brakes])

    def closed(self, gear: str) -> dict[str, tuple[str, str]]:
        """Return the clutches and brakes that are closed in a gear, and what each joins.

        Args:
            gear: One of its gears.
        """
        return {letter: self.elements[letter] for letter in self.gears[gear]}

    def design(self, gear: str) -> Design:
        """Return one gear as a design: a closed clutch holds, and what a brake holds is the ground.

        Args:
            gear: One of its gears.
        """
        node = self.nodes(gear)
        shafts = [f'"{name}"' for name in dict.fromkeys(node.values()) if name != GROUND]
        return parse("\n".join([
            "schema = 1", f'name = "{self.name}, gear {gear}"', f"shafts = [{', '.join(shafts)}]",
            f'turbines.engine = {{ shaft = "{node["input"]}", power_kw = {POWER}, speed_rpm = {SPEED} }}',
            f'propellers.load = {{ shaft = "{node["output"]}", speed_rpm = {SPEED}, diameter_m = 1 }}',
            *(line for name, ends in self.closed(gear).items() for line in _clutch(name, ends, node)),
            *(line for name, teeth in self.simple.items() for line in _simple(name, teeth, node)),
            *(line for name, teeth in self.ravigneaux.items() for line in _compound(name, teeth, node)),
        ]))  # fmt: skip


def _merged(names: Iterable[str], pairs: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Return name -> the first of all that are joined to it."""
    node = {name: name for name in names}
    for first, second in pairs:
        keep, drop = sorted((node[first], node[second]), key=list(node).index)
        node = {name: keep if value == drop else value for name, value in node.items()}
    return node


def _clutch(name: str, ends: tuple[str, str], node: Mapping[str, str]) -> list[str]:
    driving, driven = (node[end] for end in ends)
    brake = GROUND in (driving, driven)
    return [] if brake else [f'clutches.{name} = {{ driving = "{driving}", driven = "{driven}", kind = "engaged" }}']


def _simple(name: str, teeth: tuple[int, int], node: Mapping[str, str]) -> list[str]:
    sun, ring = teeth
    return [
        f'[epicyclics.set{name}]\ncarrier = "{node[f"C{name}"]}"\nsets = 1',
        f'[epicyclics.set{name}.suns]\nsun = {{ shaft = "{node[f"S{name}"]}", teeth = {sun} }}',
        f'[epicyclics.set{name}.rings]\nring = {{ shaft = "{node[f"R{name}"]}", teeth = {ring} }}',
        f'[epicyclics.set{name}.planets]\nplanet = {{ teeth = {(ring - sun) // 2}, meshes = ["sun", "ring"] }}',
    ]


def _compound(name: str, teeth: Ravigneaux, node: Mapping[str, str]) -> list[str]:
    return [
        f'[epicyclics.set{name}]\ncarrier = "{node[f"C{name}"]}"\nsets = 1',
        f'[epicyclics.set{name}.suns]\nsmall = {{ shaft = "{node[f"s{name}"]}", teeth = {teeth.small_sun} }}',
        f'large = {{ shaft = "{node[f"S{name}"]}", teeth = {teeth.large_sun} }}',
        f'[epicyclics.set{name}.rings]\nring = {{ shaft = "{node[f"R{name}"]}", teeth = {teeth.ring} }}',
        f'[epicyclics.set{name}.planets]\nshort = {{ teeth = {teeth.short}, meshes = ["small", "long"] }}',
        f'long = {{ teeth = {teeth.long}, meshes = ["large", "ring"] }}',
    ]


def _eight_speeds(name: str, *teeth: tuple[int, int]) -> Automatic:
    """Return an eight-speed transmission of the ZF 8HP's scheme, from the teeth of its four sets."""
    return Automatic(
        name,
        {str(number): sun_ring for number, sun_ring in enumerate(teeth, start=1)},
        (("S1", "S2"), ("C1", "R4"), ("R2", "S3"), ("R3", "S4"), ("input", "C2"), ("output", "C4")),
        {"A": ("S1", GROUND), "B": ("R1", GROUND), "C": ("input", "S4"), "D": ("C3", "C4"), "E": ("S3", "R3")},
        {"1": "ABC", "2": "ABE", "3": "BCE", "4": "BDE", "5": "BCD", "6": "CDE", "7": "ACD", "8": "ADE", "R": "ABD"},
    )


GM_8L_90 = _eight_speeds("GM 8L 90", (37, 73), (46, 86), (41, 79), (25, 89))
"""Four simple sets, in the numbers of the ZF 8HP; sets 1 and 3 have changed places in the GM's case."""

ZF_8HP_70 = _eight_speeds("ZF 8HP 70", (48, 96), (48, 96), (69, 111), (23, 85))
"""Four simple sets."""

FORD_6R_80 = Automatic(
    "Ford 6R 80",
    {"1": (37, 71)},
    (("S1", GROUND), ("R1", "input"), ("R2", "output")),
    {"A": ("C1", "s2"), "B": ("C1", "S2"), "C": ("S2", GROUND), "D": ("C2", GROUND), "E": ("input", "C2")},
    {"1": "AD", "2": "AC", "3": "AB", "4": "AE", "5": "BE", "6": "CE", "R": "BD"},
    {"2": Ravigneaux(31, 38, 85, 23, 23)},
)
"""Lepelletier's train, also the ZF 6HP 26: a simple set in front of a Ravigneaux set."""

FORD_AOD = Automatic(
    "Ford AOD",
    {},
    (("R1", "output"),),
    {"A": ("input", "s1"), "B": ("S1", GROUND), "C": ("input", "C1"), "D": ("C1", GROUND), "E": ("input", "S1")},
    {"1": "AD", "2": "AB", "3": "AC", "4": "BC", "R": "DE"},
    {"1": Ravigneaux(30, 36, 72, 18, 18)},
)
"""One Ravigneaux set."""

THM_440_T4 = Automatic(
    "GM THM 440-T4",
    {"1": (26, 62), "2": (42, 74)},
    (("R1", "C2"), ("C1", "R2"), ("C2", "output")),
    {"A": ("input", "S1"), "B": ("S2", GROUND), "D": ("input", "C1"), "E": ("S1", GROUND)},
    {"1": "AB", "2": "DB", "3": "DA", "4": "DE"},
)
"""Two simple sets whose rings and carriers are joined crosswise."""


# ----------------------------------------------------------------------------------------------------------------------
# Published automatic transmissions, gear by gear, and a Wolfrom train: ratios, and torque ratios with losses.
# ----------------------------------------------------------------------------------------------------------------------


EACH = {"sun-planet": math.sqrt(0.98), "planet-ring": math.sqrt(0.98)}
"""Efficiencies of meshes with which a set with its carrier held has 0.98 from sun to ring [-]."""
_WIKIPEDIA = "Wikipedia (read as mirrored by Wikiwand)"

WOLFROM = """\
schema = 1
name = "Wolfrom"
shafts = ["fast", "slow", "cage"]
turbines.driver = {{ shaft = "{driver}", power_kw = 1, speed_rpm = 100 }}
propellers.load = {{ shaft = "{load}", speed_rpm = 100, diameter_m = 1 }}
gears.mesh_efficiency = 0.99
[epicyclics.wolfrom]
carrier = "cage"
suns.sun = {{ shaft = "fast", teeth = 12 }}
rings.held = {{ shaft = "ground", teeth = 84 }}
rings.turned = {{ shaft = "slow", teeth = 81 }}
planets.wide = {{ teeth = 36, meshes = ["sun", "held"] }}
planets.narrow = {{ teeth = 33, meshes = ["turned"], in_one_piece_with = "wide" }}
"""
"""A stepped planet between a sun, a ring that is held and a ring that turns; the carrier is free."""


def wolfrom(driver: str, load: str) -> tuple[float, float]:
    """Return ratio of the sun to the ring that turns, and efficiency, of a Wolfrom train [-].

    Args:
        driver: Shaft that drives, fast or slow.
        load: Shaft that is driven.
    """
    design = parse(WOLFROM.format(driver=driver, load=load))
    flow = power_flow(design, build_train(design), teeth_of(design, "wolfrom"), efficiency=design.efficiencies)
    return flow.speeds["fast"] / flow.speeds["slow"], -flow.machine_powers["load"] / flow.machine_powers["driver"]


def _ratios(automatic: Automatic) -> Sequence[float]:
    return [automatic.ratio(gear) for gear in automatic.gears]


def _torque_ratios(automatic: Automatic, gears: str) -> Sequence[float]:
    return [automatic.torque_ratio(gear, EACH) for gear in gears]


def _printed(automatic: Automatic, source: str, ratios: tuple[float, ...], digit: float) -> Case:
    return Case(
        f"{automatic.name}, ratios of gears {', '.join(automatic.gears)}", source, "-", ratios,
        partial(_ratios, automatic), 0.51 * digit, "what the source rounds", is_relative=False,
    )  # fmt: skip


COMPOUND_CASES = (
    _printed(GM_8L_90, f"{_WIKIPEDIA}, GM 8L transmission, table with assessment",
             (4.56, 2.9709, 2.0751, 1.6876, 1.27, 1.0, 0.8455, 0.6515, -3.8176), 1e-4),
    Case("GM 8L 90, torque ratios of gears 1, 2, 4, 6, 7, 8, R", f"{_WIKIPEDIA}, GM 8L transmission, specific torque",
         "-", (4.4888, 2.9039, 1.665, 1.0, 0.8411, 0.6469, -3.6149),
         partial(_torque_ratios, GM_8L_90, "124678R"), 5.1e-5, "what the source rounds", is_relative=False),
    _printed(ZF_8HP_70, f"{_WIKIPEDIA}, ZF 8HP transmission, table with assessment",
             (4.6957, 3.1304, 2.1039, 1.6667, 1.2845, 1.0, 0.8392, 0.6667, -3.2968), 1e-4),
    Case("ZF 8HP 70, torque ratios of gears 1, 2, 4, 6, 7, 8, R", f"{_WIKIPEDIA}, ZF 8HP transmission, specific torque",
         "-", (4.6217, 3.0603, 1.6446, 1.0, 0.8347, 0.6622, -3.1186),
         partial(_torque_ratios, ZF_8HP_70, "124678R"), 5.1e-5, "what the source rounds", is_relative=False),
    _printed(FORD_6R_80, "Ford 2010, Explorer Sport Trac service description, 6R80 gear ratios",
             (4.17, 2.34, 1.52, 1.14, 0.87, 0.69, -3.4), 1e-2),
    Case("Ford AOD, ratios of gears 1, 2, 3", "Yugo 1991, service bulletins for automatic transmissions, Ravigneaux",
         "-", (2.4, 1.47, 1.0), lambda: _ratios(FORD_AOD)[:3], 5.1e-3, "what the source rounds", is_relative=False),
    Case("GM THM 440-T4, ratios of gears 1, 2, 3", "Yugo 1991, service bulletins for automatic transmissions, Simpson",
         "-", (2.92, 1.57, 1.0), lambda: _ratios(THM_440_T4)[:3], 5.1e-3, "what the source rounds", is_relative=False),
    Case("Wolfrom train, ratio and efficiency forwards", "Müller 1998, Die Umlaufgetriebe: tooth power in the carrier",
         "-", (162.0, 0.710437), lambda: wolfrom("fast", "slow"), 1e-6, "six digits, by an independent program"),
    Case("Wolfrom train, efficiency backwards", "Müller 1998, Die Umlaufgetriebe: tooth power in the carrier",
         "-", (0.598514,), lambda: wolfrom("slow", "fast")[1:], 1e-6, "six digits, by an independent program"),
)  # fmt: skip
"""Print and equilibrium disagree in gear 3 of both eight-speed boxes, and in gear 5: see the page on compound sets."""


# ----------------------------------------------------------------------------------------------------------------------
# Published shifted teeth of epicyclic sets, written as compound sets: where they close, what is measured of them.
# ----------------------------------------------------------------------------------------------------------------------


_KOS = "L. Kos, LECAD, University of Ljubljana, Planetary Transmissions, printed test run"
_TURBINE = "Nejad et al. 2016, Wind Energy 19, 1089-1106, KISSsoft report of its stages"
_TEXT = """\
schema = 1
name = "published"
shafts = ["fast", "slow"]
motors.motor = {{ shaft = "fast", power_kw = 1, speed_rpm = {speed}, balances = false }}
loads.drum = {{ shaft = "slow", speed_rpm = 100 }}
[epicyclics.set]
carrier = "slow"
suns.sun = {{ shaft = "fast", teeth = {sun}, module_mm = {module}, shift = {shift} }}
rings.ring = {{ shaft = "ground", teeth = {ring} }}
planets.planet = {{ teeth = {planet}, meshes = ["sun", "ring"], {key} }}
"""


class PublishedSet(NamedTuple):
    """A set as it is printed."""

    teeth: tuple[int, int, int]
    """Of sun, planet and ring [-]."""
    module: float
    """m [mm]."""
    shift: float
    """x of the sun [-]."""
    key: str
    """What else is given, as a key of the planet."""

    @property
    def shifts(self) -> CompoundShifts:
        """What gearwright makes of it."""
        sun, planet, ring = self.teeth
        text = _TEXT.format(speed=100.0 * (1.0 + ring / sun), sun=sun, planet=planet, ring=ring,
                            module=self.module, shift=self.shift, key=self.key)  # fmt: skip
        return compound_shifts(parse(text), "set")

    def gear(self, name: str) -> CylindricalGear:
        """Return its sun or its planet, in millimetres.

        Args:
            name: Sun or planet.
        """
        shift = self.shifts.gears[name]
        teeth = self.teeth[0] if name == "sun" else self.teeth[1]
        return CylindricalGear(
            teeth, self.module, 38.0, profile_shift=shift.profile_shift, tip_alteration=shift.tip_alteration
        )


FIRST = PublishedSet((19, 17, 56), 45.0, 0.617, "shift = 0.802")
SECOND = PublishedSet((18, 36, 93), 21.0, 0.389, "shift = 0.504")
PRINTED_RUN = PublishedSet((21, 43, 108), 1.75, 0.438, "centre_distance_mm = 56.8")


def _centres(*sets: PublishedSet) -> Sequence[float]:
    return [own.module * (own.shifts.meshes["sun-planet"].centre or 0.0) for own in sets]


def _tips_and_spans() -> Sequence[float]:
    sun, planet = PRINTED_RUN.gear("sun"), PRINTED_RUN.gear("planet")
    return [2.0 * sun.tip_radius, 2.0 * planet.tip_radius, span_measurement(sun, 3), span_measurement(planet, 5)]


SHIFT_CASES = (
    Case("5 MW reference gearbox as compound sets, centre distance of both", _TURBINE, "mm", (862.996, 584.002),
         partial(_centres, FIRST, SECOND), 6e-4, "printed to a micrometre", is_relative=False),
    Case("5 MW reference gearbox as compound sets, shift of both rings", _TURBINE, "-", (-0.501, 0.117),
         lambda: [own.shifts.gears["ring"].profile_shift for own in (FIRST, SECOND)], 6e-4,
         "three decimals of the printed shifts", is_relative=False),
    Case("planetary set 21/43/108 on 56.8 mm, shift of the planet", _KOS, "-", (0.0426,),
         lambda: [PRINTED_RUN.shifts.gears["planet"].profile_shift], 6e-5, "four decimals", is_relative=False),
    Case("planetary set 21/43/108 on 56.8 mm, tips and spans of sun and planet", _KOS, "mm",
         (41.7008, 78.8170, 13.9546, 24.3530), _tips_and_spans, 2e-4, "four decimals of the shift: 0.2 µm",
         is_relative=False),
)  # fmt: skip
