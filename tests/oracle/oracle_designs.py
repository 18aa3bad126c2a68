"""Random designs of every kind of gearbox, from published seeds, written as a user writes them.

Design k of a kind comes from `numpy.random.default_rng([SEED, kind, k])`: its power, speeds, ratio, life, material,
cases and application factor, and what it leaves open. Face widths and modules are always open; teeth in half of the
designs, numbers of planets in most.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

from gearwright import DesignError, parse
from gearwright.spec import Design

SEED = 5454
"""First entry of every seed: the number of the standard on modules, twice."""
DATA = Path(__file__).parent / "data"
MATERIALS = (
    "carburised-9310", "AISI-9310", "Pyrowear-53", "18CrNiMo7-6", "16MnCr5", "nitriding-steel-785", "31CrMoV9",
    "32CDV13", "42CrMo4", "34CrNiMo6",
)  # fmt: skip
"""Of the catalogue, the strongest flanks first; those whose cores are known, so that shafts can be sized."""
HARD = 5
"""How many of them are carburised, as the rules of AGMA 2001 below say."""
TRIES = 200
"""Draws of teeth until a compound set can be put together."""


class Draw:
    """The random numbers of one design."""

    def __init__(self, kind: int, number: int) -> None:
        self.rng = np.random.default_rng([SEED, kind, number])

    def uniform(self, low: float, high: float) -> float:
        """Return a number between two others."""
        return float(self.rng.uniform(low, high))

    def log(self, low: float, high: float) -> float:
        """Return a number between two others whose logarithm is uniform."""
        return float(math.exp(self.rng.uniform(math.log(low), math.log(high))))

    def whole(self, low: int, high: int) -> int:
        """Return a whole number from one to another, both included."""
        return int(self.rng.integers(low, high + 1))

    def chance(self, part: float) -> bool:
        """Tell whether something is so that is so in a part of all draws."""
        return bool(self.rng.random() < part)

    def one_of(self, *values: float) -> float:
        """Return one of some numbers."""
        return float(values[self.whole(0, len(values) - 1)])


class Service(NamedTuple):
    """What every kind is asked for."""

    power: float
    """[kW]"""
    speed: float
    """Of the turbine [rpm]."""
    level: str
    teeth: bool
    """Whether teeth are given."""
    planets: bool
    """Whether numbers of planets are given."""


def service_of(draw: Draw) -> Service:
    """Return power, speed and freedoms; small turbines turn faster.

    Args:
        draw: Of the design.
    """
    power = draw.log(30.0, 5000.0)
    speed = min(20000.0 * (power / 1000.0) ** -0.35 * draw.uniform(0.4, 1.3), 30000.0)
    level = "preliminary" if draw.chance(0.4) else "concept"
    return Service(power, speed, level, teeth=draw.chance(0.5), planets=draw.chance(0.3))


def rules_of(draw: Draw, *, agma: float = 0.0, helix: float = 0.0) -> str:
    """Return the tables of gears, service and cases.

    Args:
        draw: Of the design.
        agma: Part of the designs that AGMA 2001 rates, which does not cover rings.
        helix: Angle of pairs [°].
    """
    by_agma = draw.chance(agma)
    material = MATERIALS[draw.whole(0, (HARD if by_agma else len(MATERIALS)) - 1)]
    life, factor = draw.log(500.0, 20000.0), draw.uniform(1.0, 1.75)
    method = "agma2001" if by_agma else "iso6336"
    lines = ["[gears]", f'material = "{material}"', f'rating = "{method}"']
    if helix:
        lines.append(f"helix_angle_deg = {helix:.1f}")
    if by_agma:
        lines += ["[gears.agma2001]", 'steel = "carburised"']
    lines += ["[service]", f"life_h = {life:.0f}", f"application_factor = {factor:.2f}"]
    if draw.chance(0.5):
        lines.append(f"bearing_life_h = {life:.0f}")
    return "\n".join(lines + cases_of(draw)) + "\n"


def cases_of(draw: Draw) -> list[str]:
    """Return up to three cases, the first of which is at the rated power.

    Args:
        draw: Of the design.
    """
    count = draw.whole(1, 3)
    if count == 1:
        return []
    shares = np.round(draw.rng.dirichlet([1.0, 2.0, 2.0][:count]), 3)
    shares[-1] = round(1.0 - float(shares[:-1].sum()), 3)
    ratings = [1.0] + [draw.uniform(0.3, 1.0) for _ in range(count - 1)]
    lines = list[str]()
    for name, share, rating in zip("abc", shares, ratings, strict=False):
        lines += [f"[cases.{name}]", f"share = {share:.3f}", f"eng.rating = {rating:.2f}"]
    return lines


def head(service: Service, shafts: str, *, output: float, propeller: str = "out") -> str:
    """Return what every design begins with: shafts, turbine and propeller.

    Args:
        service: What it is asked for.
        shafts: Their names, the turbine's first.
        output: Speed of the propeller [rpm].
        propeller: Its shaft.
    """
    names = ", ".join(f'"{name}"' for name in shafts.split())
    return (
        f'schema = 1\nname = "random"\nlevel = "{service.level}"\nshafts = [{names}]\n'
        f'[turbines.eng]\nshaft = "in"\npower_kw = {service.power:.2f}\nspeed_rpm = {service.speed:.1f}\n'
        f'[propellers.prop]\nshaft = "{propeller}"\nspeed_rpm = {output:.3f}\ndiameter_m = 3\n'
    )


# ----------------------------------------------------------------------------------------------------------------------
# Planetary sets.
# ----------------------------------------------------------------------------------------------------------------------


def set_teeth(draw: Draw, ratio: float, planets: int) -> tuple[int, int, int]:
    """Return teeth of sun, planets and ring that come near to z_r/z_s and let planets stand evenly.

    Args:
        draw: Of the design.
        ratio: z_r/z_s [-].
        planets: Their number [-].
    """
    while True:
        sun = draw.whole(19, 50)
        planet = round(sun * (ratio - 1.0) / 2.0) + draw.whole(-1, 1)
        apart = (sun + planet) * math.sin(math.pi / planets) > planet + 2.0
        if planet >= 14 and apart and (2 * sun + 2 * planet) % planets == 0:
            return sun, planet, sun + 2 * planet


def most_planets(ratio: float) -> int:
    """Return how many planets pass each other at z_r/z_s, five at most.

    Args:
        ratio: z_r/z_s [-].
    """
    planet = (ratio - 1.0) / 2.0
    return max(n for n in (3, 4, 5) if n == 3 or (1.0 + planet) * math.sin(math.pi / n) > 1.08 * planet + 0.1)


def set_table(name: str, members: str, draw: Draw, service: Service, *, ratio: float) -> tuple[str, float]:
    """Return the table of a planetary set, and its z_r/z_s as far as it is known.

    Args:
        name: Of the set.
        members: Shafts of sun, ring and carrier.
        draw: Of the design.
        service: What is given.
        ratio: z_r/z_s that is wanted [-].
    """
    sun, ring, carrier = members.split()
    lines = [f"[planetaries.{name}]", f'sun = "{sun}"', f'ring = "{ring}"', f'carrier = "{carrier}"']
    planets = draw.whole(3, most_planets(ratio))
    if service.teeth:
        teeth = set_teeth(draw, ratio, planets)
        ratio = teeth[2] / teeth[0]
        lines += [f"{role}_teeth = {z}" for role, z in zip(("sun", "planet", "ring"), teeth, strict=True)]
    if service.planets or service.teeth:
        lines.append(f"planets = {planets}")
    if service.level == "preliminary" and draw.chance(0.5):
        lines.append('planet_bearing = { kind = "plain" }')
    return "\n".join(lines) + "\n", ratio


def planetary(draw: Draw) -> str:
    """Return a set whose ring stands still."""
    service = service_of(draw)
    table, ratio = set_table("set", "in ground out", draw, service, ratio=draw.uniform(2.2, 8.0))
    return head(service, "in out", output=service.speed / (1.0 + ratio)) + table + rules_of(draw)


def star(draw: Draw) -> str:
    """Return a set whose carrier stands still."""
    service = service_of(draw)
    table, ratio = set_table("set", "in out ground", draw, service, ratio=draw.uniform(2.2, 8.0))
    return head(service, "in out", output=service.speed / ratio) + table + rules_of(draw)


def solar(draw: Draw) -> str:
    """Return a set whose sun stands still."""
    service = service_of(draw)
    table, ratio = set_table("set", "ground in out", draw, service, ratio=draw.uniform(2.0, 5.0))
    service = service._replace(speed=service.speed / 2.0)
    return head(service, "in out", output=service.speed / (1.0 + 1.0 / ratio)) + table + rules_of(draw)


def differential(draw: Draw) -> str:
    """Return a set of which a turbine turns the sun, a motor the ring and the carrier a propeller."""
    service = service_of(draw)
    table, ratio = set_table("set", "in ring out", draw, service, ratio=draw.uniform(2.2, 6.0))
    ring = service.speed * draw.uniform(0.03, 0.2)
    power = service.power * ratio * ring / service.speed
    output = (service.speed + ratio * ring) / (1.0 + ratio)
    asked = "" if service.teeth else f"ratio = {1.0 + ratio:.4f}\n"
    motor = f'[motors.em]\nshaft = "ring"\npower_kw = {1.1 * power:.2f}\nspeed_rpm = {ring:.2f}\nbalances = true\n'
    return head(service, "in ring out", output=output) + motor + table + asked + rules_of(draw)


# ----------------------------------------------------------------------------------------------------------------------
# Pairs: spur, helical, double-helical, bevel before a pair, two paths by face gears, a layshaft.
# ----------------------------------------------------------------------------------------------------------------------


def pair_table(name: str, sides: str, draw: Draw, *, teeth: bool, ratio: float, more: str = "") -> tuple[str, float]:
    """Return the table of a pair, and its ratio as far as it is known.

    Args:
        name: Of the pair.
        sides: Shafts of pinion and wheel.
        draw: Of the design.
        teeth: Whether they are given.
        ratio: That is wanted [-].
        more: Further lines.
    """
    pinion, wheel = sides.split()
    lines = [f"[pairs.{name}]", f'pinion = "{pinion}"', f'wheel = "{wheel}"', *more.splitlines()]
    if teeth:
        small = draw.whole(18, 36)
        large = round(small * ratio) + draw.whole(0, 1)
        ratio = large / small
        lines += [f"pinion_teeth = {small}", f"wheel_teeth = {large}"]
    return "\n".join(lines) + "\n", ratio


def _pair(draw: Draw, helix: float, more: str = "") -> str:
    service = service_of(draw)
    service = service._replace(speed=0.6 * service.speed)
    table, ratio = pair_table("pair", "in out", draw, teeth=service.teeth, ratio=draw.uniform(1.2, 6.0), more=more)
    return head(service, "in out", output=service.speed / ratio) + table + rules_of(draw, agma=0.2, helix=helix)


def spur(draw: Draw) -> str:
    """Return a pair with straight teeth."""
    return _pair(draw, 0.0)


def helical(draw: Draw) -> str:
    """Return a pair whose teeth lean."""
    return _pair(draw, draw.uniform(8.0, 25.0))


def double_helical(draw: Draw) -> str:
    """Return a pair of two halves."""
    return _pair(draw, draw.uniform(20.0, 35.0), "halves = 2\n")


def bevel(draw: Draw) -> str:
    """Return a bevel pair before one with straight teeth."""
    service = service_of(draw)
    service = service._replace(speed=service.speed / 2.0)
    spiral = draw.one_of(0.0, 25.0, 35.0)
    square = f'kind = "bevel"\naxis_angle_deg = 90\nspiral_angle_deg = {spiral:g}\n'
    ratios = draw.uniform(1.0, 3.0), draw.uniform(1.5, 5.0)
    if not service.teeth:
        square += f"ratio = {ratios[0]:.4f}\n"
    first, before = pair_table("bev", "in mid", draw, teeth=service.teeth, ratio=ratios[0], more=square)
    second, after = pair_table("cyl", "mid out", draw, teeth=service.teeth, ratio=ratios[1])
    output = service.speed / (before * after)
    return head(service, "in mid out", output=output) + first + second + rules_of(draw)


def face(draw: Draw) -> str:
    """Return one pinion between two face gears, whose paths join at one wheel."""
    service = service_of(draw)._replace(level="concept")
    ratios = draw.uniform(2.5, 5.0), draw.uniform(3.0, 6.5)
    crossed = 'kind = "face"\naxis_angle_deg = 90\n'
    if not service.teeth:
        crossed += f"ratio = {ratios[0]:.4f}\n"
    first, before = pair_table("first", "in SPLIT", draw, teeth=service.teeth, ratio=ratios[0], more=crossed)
    second, after = pair_table("second", "SPLIT out", draw, teeth=service.teeth, ratio=ratios[1])
    speed = service.speed / 2.0
    service = service._replace(speed=speed)
    tables = (first + '[pairs.first.gears]\nrating = "lewis-hertz"\n' + second).replace('"SPLIT"', '["left", "right"]')
    places = "[layout.left]\nangle_deg = -90\n[layout.right]\nangle_deg = 90\n[layout.out]\nangle_deg = 180\n"
    output = speed / (before * after)
    return head(service, "in left right out", output=output) + tables + rules_of(draw) + places


def layshaft(draw: Draw) -> str:
    """Return two pairs of one centre distance, so that the output turns in line with the input."""
    service = service_of(draw)
    first, before = pair_table("first", "in lay", draw, teeth=True, ratio=draw.uniform(1.3, 3.0))
    second, after = pair_table("second", "lay out", draw, teeth=True, ratio=draw.uniform(1.3, 3.0))
    service = service._replace(speed=0.6 * service.speed)
    output = service.speed / (before * after)
    tied = second + 'coaxial_with = "first"\n'
    return head(service, "in lay out", output=output) + first + tied + rules_of(draw, helix=draw.one_of(0.0, 15.0))


# ----------------------------------------------------------------------------------------------------------------------
# Compound sets, whose teeth are always given: stepped planets, Ravigneaux's, Wolfrom's.
# ----------------------------------------------------------------------------------------------------------------------


def _gear(table: str, teeth: int, **more: str) -> str:
    lines = "".join(f"{key} = {value}\n" for key, value in more.items())
    return f"[epicyclics.set.{table}]\nteeth = {teeth}\n{lines}"


def stepped(draw: Draw) -> str:
    """Return a set of stepped planets, of carrier or ring that turns."""
    service = service_of(draw)
    for _ in range(TRIES):
        sun, wide, narrow = draw.whole(22, 45), draw.whole(40, 75), draw.whole(20, 34)
        ring = round(narrow * draw.uniform(3.6, 4.6))
        steps = 3 * math.gcd(wide, narrow)
        if (sun * narrow + ring * wide) % steps == 0 and 1.1 < (sun + wide) / (ring - narrow) * 1.6 < 2.4:
            break
    ratio = wide * ring / (sun * narrow)
    star_ = draw.chance(0.4)
    carrier, turned, output = ("ground", "out", ratio) if star_ else ("out", "ground", 1.0 + ratio)
    tables = (
        f'[epicyclics.set]\ncarrier = "{carrier}"\nsets = 3\n'
        + _gear("suns.sun", sun, shaft='"in"')
        + _gear("rings.ring", ring, shaft=f'"{turned}"')
        + _gear("planets.wide", wide, meshes='["sun"]')
        + _gear("planets.narrow", narrow, meshes='["ring"]', in_one_piece_with='"wide"')
    )
    return head(service, "in out", output=service.speed / output) + tables + rules_of(draw)


RAVIGNEAUX = (
    (45, 54, 27, 27, 108),
    (30, 36, 18, 18, 72),
    (36, 45, 24, 24, 93),
    (45, 63, 27, 27, 117),
    (33, 39, 21, 21, 81),
)
"""Teeth of small and large sun, short and long planet, ring."""


def ravigneaux(draw: Draw) -> str:
    """Return Ravigneaux's set with its large sun held."""
    service = service_of(draw)
    small, large, short, long, ring = RAVIGNEAUX[draw.whole(0, len(RAVIGNEAUX) - 1)]
    cage = service.speed / (1.0 + large / small)  # Willis: (n_small - n_c)/(0 - n_c) = -z_large/z_small
    tables = (
        '[epicyclics.set]\ncarrier = "cage"\nsets = 3\n'
        + _gear("suns.small", small, shaft='"in"')
        + _gear("suns.large", large, shaft='"ground"')
        + _gear("rings.ring", ring, shaft='"out"')
        + _gear("planets.short", short, meshes='["small", "long"]')
        + _gear("planets.long", long, meshes='["large", "ring"]')
    )
    return head(service, "in cage out", output=cage * (1.0 + large / ring)) + tables + rules_of(draw)


def wolfrom(draw: Draw) -> str:
    """Return Wolfrom's set, which makes much of little power."""
    service = service_of(draw)
    power = draw.log(1.0, 30.0)
    shift = draw.whole(0, 2)
    sun, wide, narrow, held, turned = 18 + 3 * shift, 36, 33, 90 + 3 * shift, 87 + 3 * shift
    service = service._replace(power=power, speed=draw.uniform(3000.0, 9000.0), level="concept")
    output = service.speed * (1.0 - held * narrow / (wide * turned)) / (1.0 + held / sun)
    tables = (
        '[epicyclics.set]\ncarrier = "cage"\nsets = 3\n'
        + _gear("suns.sun", sun, shaft='"in"')
        + _gear("rings.held", held, shaft='"ground"')
        + _gear("rings.turned", turned, shaft='"out"')
        + _gear("planets.wide", wide, meshes='["sun", "held"]')
        + _gear("planets.narrow", narrow, meshes='["turned"]', in_one_piece_with='"wide"')
    )
    return head(service, "in out cage", output=abs(output)) + tables + rules_of(draw)


# ----------------------------------------------------------------------------------------------------------------------
# Two stages one after the other.
# ----------------------------------------------------------------------------------------------------------------------


def pair_and_set(draw: Draw) -> str:
    """Return a pair before a planetary set."""
    service = service_of(draw)
    asked = draw.uniform(1.5, 3.5)
    more = "" if service.teeth else f"ratio = {asked:.4f}\n"
    first, before = pair_table("first", "in mid", draw, teeth=service.teeth, ratio=asked, more=more)
    second, after = set_table("second", "mid ground out", draw, service, ratio=draw.uniform(2.2, 6.0))
    output = service.speed / (before * (1.0 + after))
    return head(service, "in mid out", output=output) + first + second + rules_of(draw, helix=draw.one_of(0.0, 15.0))


def two_sets(draw: Draw) -> str:
    """Return two sets in line, in half of the designs with a motor between them."""
    service = service_of(draw)
    star_ = draw.chance(0.5)
    members, add = ("in mid ground", 0.0) if star_ else ("in ground mid", 1.0)
    first, before = set_table("first", members, draw, service, ratio=draw.uniform(2.2, 6.0))
    second, after = set_table("second", "mid ground out", draw, service, ratio=draw.uniform(2.2, 5.0))
    middle = service.speed / (before + add)
    motor = ""
    if draw.chance(0.5):
        power = service.power * draw.uniform(0.2, 1.0)
        motor = f'[motors.em]\nshaft = "mid"\npower_kw = {power:.2f}\nspeed_rpm = {middle:.3f}\n'
    elif not service.teeth:
        first += f"ratio = {1.0 + before:.4f}\n"
    return head(service, "in mid out", output=middle / (1.0 + after)) + motor + first + second + rules_of(draw)


# ----------------------------------------------------------------------------------------------------------------------
# All of them, and designs from files.
# ----------------------------------------------------------------------------------------------------------------------


class KindOf(NamedTuple):
    """A kind of gearbox."""

    number: int
    """Second entry of its seeds."""
    made: Callable[[Draw], str]
    designs: int
    """How many of it are asked about."""


KINDS = {
    "planetary": KindOf(1, planetary, 36),
    "star": KindOf(2, star, 28),
    "solar": KindOf(3, solar, 16),
    "differential": KindOf(4, differential, 16),
    "spur pair": KindOf(5, spur, 28),
    "helical pair": KindOf(6, helical, 28),
    "double-helical pair": KindOf(7, double_helical, 18),
    "bevel + pair": KindOf(8, bevel, 22),
    "face-gear split": KindOf(9, face, 12),
    "stepped": KindOf(10, stepped, 24),
    "Ravigneaux": KindOf(11, ravigneaux, 10),
    "Wolfrom": KindOf(12, wolfrom, 8),
    "pair + planetary": KindOf(13, pair_and_set, 18),
    "planetary + planetary": KindOf(14, two_sets, 18),
    "layshaft": KindOf(15, layshaft, 18),
}
"""Name -> kind; 300 designs."""
OF_FILES = "file"
"""Kind of the designs in `DATA`."""


def text_of(kind: str, number: int | str) -> str:
    """Return a design as TOML.

    Args:
        kind: One of `KINDS`, or `OF_FILES`.
        number: k of its seed, or the name of a file.
    """
    if kind == OF_FILES:
        return (DATA / f"{number}.toml").read_text()
    found = KINDS[kind]
    return found.made(Draw(found.number, int(number)))


def design_of(kind: str, number: int | str) -> Design:
    """Return a design, as the public reader gives it.

    Args:
        kind: One of `KINDS`, or `OF_FILES`.
        number: k of its seed, or the name of a file.
    """
    return parse(text_of(kind, number))


def all_designs() -> list[tuple[str, int | str]]:
    """Return kind and number of every design that leaves sizes open, files first and then one of each kind in turn."""
    names = [path.stem for path in sorted(DATA.glob("*.toml")) if "module_mm" not in path.read_text()]
    found: list[tuple[str, int | str]] = [(OF_FILES, name) for name in names]
    most = max(kind.designs for kind in KINDS.values())
    return found + [(name, k) for k in range(most) for name, kind in KINDS.items() if k < kind.designs]


__all__ = ["DATA", "KINDS", "OF_FILES", "DesignError", "all_designs", "design_of", "text_of"]
