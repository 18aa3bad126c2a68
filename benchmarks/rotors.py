"""Rotors beside ROSS and openTorsion on the same models: python benchmarks/rotors.py

The peers are optional and stay out of the package's dependencies: pip install ross-rotordynamics "plotly<6"
opentorsion. A peer that is not installed is left out, and said so.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec

import numpy as np

from gearwright.dynamics import Model, campbell, modes
from gearwright.dynamics.model import (
    Bearing,
    Disc,
    GearContact,
    Rotor,
    Segment,
    add_bearing,
    add_gear_contact,
    add_rotor,
)

E, G, DENSITY = 211e9, 81.2e9, 7810.0
SPEED = 4000.0 * math.pi / 30.0
Case = tuple[str, Sequence[float], Sequence[float]]


def segments(lengths: Sequence[float], diameters: Sequence[float]) -> list[Segment]:
    """Return a stepped shaft of the peers' steel."""
    return [
        Segment(length, diameter, elasticity=E, poisson=E / (2.0 * G) - 1.0, density=DENSITY)
        for length, diameter in zip(lengths, diameters, strict=True)
    ]


def ours(
    rotors: Sequence[Rotor],
    bearings: Sequence[dict[int, Bearing]],
    *,
    speeds: Sequence[float],
    mesh: tuple[GearContact, float, tuple[int, int]] | None = None,
) -> list[float]:
    """Return natural frequencies |λ| of rotors in bearings [rad/s]."""
    model = Model()
    placed = [add_rotor(model, f"rotor {n}", rotor, speed=speeds[n]) for n, rotor in enumerate(rotors)]
    for shaft, seats in zip(placed, bearings, strict=True):
        for station, bearing in seats.items():
            add_bearing(model, f"{shaft.name} bearing {station}", shaft.at(station), bearing)
    if mesh is not None:
        contact, stiffness, stations = mesh
        gears = (placed[0].at(stations[0]), placed[1].at(stations[1]))
        add_gear_contact(model, "mesh", gears, contact, stiffness=stiffness)
    diagram = campbell(model.build(), [0.999, 1.0])
    found = 2.0 * np.pi * diagram.frequency[-1] / np.sqrt(1.0 - diagram.damping[-1] ** 2)
    return [float(value) for value in np.sort(found)]


def theirs(
    rs: object,
    lengths: Sequence[float],
    diameters: Sequence[float],
    discs: dict[int, Disc],
    bearings: dict[int, Bearing],
    gear: object = None,
) -> object:
    """Return the same rotor in ROSS."""
    steel = rs.Material(name="steel", rho=DENSITY, E=E, G_s=G)
    shaft = [
        rs.ShaftElement(L=length, idl=0.0, odl=diameter, material=steel)
        for length, diameter in zip(lengths, diameters, strict=True)
    ]
    rows = [rs.DiskElement(n=n, m=disc.mass, Id=disc.diametral, Ip=disc.polar) for n, disc in discs.items()]
    seats = [
        rs.BearingElement(
            n=n,
            kxx=b.stiffness[0],
            kyy=b.stiffness[1],
            kxy=b.cross_stiffness[0],
            kyx=b.cross_stiffness[1],
            cxx=b.damping[0],
            cyy=b.damping[1],
        )
        for n, b in bearings.items()
    ]
    return rs.Rotor(shaft, [*rows, *([gear] if gear is not None else [])], seats)


def whirls(rs: object) -> Iterator[Case]:
    """Yield rotors of Friswell et al. at 4000 rpm, with six elements on both sides."""
    lengths, diameters = [0.25] * 6, [0.05] * 6
    small, large = (Disc.of_steel(0.07, width, bore=0.05, density=DENSITY) for width in (0.28, 0.35))
    cases = {
        "isotropic bearings": ({2: small, 4: large}, (0, 6), Bearing((1e6, 1e6))),
        "unequal bearings": ({2: small, 4: large}, (0, 6), Bearing((1e6, 0.8e6))),
        "damped bearings": ({2: small, 4: large}, (0, 6), Bearing((1e6, 1e6), damping=(3e3, 3e3))),
        "equal cross terms": ({2: small, 4: large}, (0, 6), Bearing((1e6, 1e6), (5e5, 5e5))),
        "one cross term": ({2: small, 4: large}, (0, 6), Bearing((1e6, 1e6), (5e5, 0.0))),
        "following cross terms": ({2: small, 4: large}, (0, 6), Bearing((1e6, 1e6), (2e5, -2e5), (1e3, 1e3))),
        "overhung disc": ({6: large}, (0, 4), Bearing((1e7, 1e7))),
    }
    for name, (discs, stations, bearing) in cases.items():
        seats = dict.fromkeys(stations, bearing)
        peer = theirs(rs, lengths, diameters, discs, seats)
        found = ours([Rotor(segments(lengths, diameters), discs)], [seats], speeds=[SPEED])
        yield f"{name}, 4000 rpm", found, np.sort(peer.run_modal(SPEED, num_modes=40).wn)


def geared(rs: object) -> Iterator[Case]:
    """Yield the two shafts of ROSS's example of a spur gear pair, after Rao, Shiau & Chang 1998, at rest."""
    lengths, diameters = ([0.1, 4.24, 1.16, 0.3], [0.3, 5.0, 0.1]), ([0.3, 0.3, 0.22, 0.22], [0.15] * 3)
    discs = ({1: Disc(525.7, 16.1, 32.2), 2: Disc(116.04, 3.115, 6.23)}, {2: Disc(7.45, 0.0745, 0.149)})
    gears = ((4, Disc(726.4, 56.95, 113.9), 328, 0.5086), (0, Disc(5.0, 0.002, 0.004), 23, 0.03567))
    seats = (
        dict.fromkeys((0, 3), Bearing((183.9e6, 200.4e6))),
        dict.fromkeys((1, 3), Bearing((10.1e6, 41.6e6))),
    )
    angle, stiffness = math.radians(22.5), 1e8
    sides = []
    for number, (station, gear, teeth, base) in enumerate(gears):
        toothed = rs.GearElement(
            n=station,
            m=gear.mass,
            Id=gear.diametral,
            Ip=gear.polar,
            n_teeth=teeth,
            base_diameter=2.0 * base,
            pr_angle=angle,
        )
        sides.append(theirs(rs, lengths[number], diameters[number], discs[number], seats[number], toothed))
    peer = rs.MultiRotor(*sides, coupled_nodes=(4, 0), gear_mesh_stiffness=stiffness, orientation_angle=0.0)
    rotors = [
        Rotor(segments(lengths[n], diameters[n]), {**discs[n], station: gear})
        for n, (station, gear, _, _) in enumerate(gears)
    ]
    radii = tuple(base / math.cos(angle) for *_, base in gears)
    contact = GearContact(radii, angle)
    slow = [1e-6, -1e-6 * radii[0] / radii[1]]
    found = ours(rotors, seats, speeds=slow, mesh=(contact, stiffness, (4, 0)))
    yield "geared rotors at rest", found, np.sort(peer.run_modal(0.0, num_modes=60).wn)


def torsion() -> Iterator[Case]:
    """Yield torsional systems of openTorsion: lumped masses and shafts with inertia."""
    import opentorsion as ot

    inertias, stiffnesses = (1e7, 5770.0, 97030.0), (3.67e8, 5.496e9)
    model = Model()
    for number, inertia in enumerate(inertias):
        model.rotation(f"{number}", inertia=inertia)
    for number, stiffness in enumerate(stiffnesses):
        model.shaft(f"shaft {number}", f"{number}", f"{number + 1}", stiffness=stiffness)
    shafts = [ot.Shaft(n, n + 1, None, None, k=stiffness, I=0.0) for n, stiffness in enumerate(stiffnesses)]
    peer = ot.Assembly(shafts, disk_elements=[ot.Disk(n, inertia) for n, inertia in enumerate(inertias)])
    yield "three inertias", _rad(model)[1:], _peer(peer)
    parts = segments([0.5] * 8, [0.08] * 8)
    model = Model()
    add_rotor(model, "rod", Rotor(parts, {0: Disc(1.0, 1.0, 0.2), 8: Disc(1.0, 1.0, 0.05)}))
    names = model.build().labels.coordinates
    twisting = [n for n, name in enumerate(names) if name.startswith("rod torsion")]
    arrays = model.build().arrays
    lines = model.build().labels.lines
    found = [math.sqrt(arrays.stiffness[lines.index(f"{names[n]} elastic")] / arrays.mass[n]) for n in twisting]
    shafts = [ot.Shaft(n, n + 1, 500.0, 80.0, idl=0.0, G=G, E=E, rho=DENSITY) for n in range(8)]
    peer = ot.Assembly(shafts, disk_elements=[ot.Disk(0, 0.2), ot.Disk(8, 0.05)])
    yield "shaft of eight elements", found, _peer(peer)


def _rad(model: Model) -> list[float]:
    return [2.0 * math.pi * float(value) for value in modes(model.build()).frequency]


def _peer(assembly: object) -> list[float]:
    """Return the frequencies above the rigid turning of an assembly of openTorsion [rad/s]."""
    found = np.sqrt(np.sort(np.abs(assembly.undamped_modal_analysis()[0])))
    return [float(value) for value in found if value > 1.0]


def row(peer: str, name: str, found: Sequence[float], other: Sequence[float]) -> str:
    """Return a line of the table: the peer's frequencies, each beside the nearest of ours."""
    ours_, peers = np.array(found), np.array([value for value in other if value > 1.0])[:12]
    ours_ = ours_[ours_ > 1.0]
    ratio = np.array([ours_[np.argmin(np.abs(ours_ - value))] / value for value in peers])
    worst = ratio[np.argmax(np.abs(ratio - 1.0))]
    first = f"{peers[0]:.6g} | {peers[0] * ratio[0]:.6g}"
    return f"| {name} | {peer} | {len(ratio)} | {first} | {worst:.9f} | {worst - 1.0:+.1e} |"


def main() -> None:
    """Print the table."""
    print("| model | peer | frequencies | first, peer [rad/s] | first, gearwright | ratio that differs most | less 1 |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    sources: list[tuple[str, Callable[[], Iterator[Case]]]] = []
    if find_spec("ross"):
        import ross as rs

        sources += [(f"ROSS {rs.__version__}", lambda: whirls(rs)), (f"ROSS {rs.__version__}", lambda: geared(rs))]
    else:
        print("ROSS is not installed: pip install ross-rotordynamics 'plotly<6'")
    if find_spec("opentorsion"):
        sources.append(("openTorsion", torsion))
    else:
        print("openTorsion is not installed: pip install opentorsion")
    for peer, cases in sources:
        for name, found, other in cases():
            print(row(peer, name, found, other))


if __name__ == "__main__":
    main()
