"""Automatic transmissions as trains: simple and Ravigneaux sets, what is joined for good, what each gear closes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from gearwright.spec import GROUND, Design, parse
from gearwright.train import PowerFlow, build_train, power_flow, teeth_of

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
