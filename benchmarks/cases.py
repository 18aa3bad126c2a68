"""The two systems on which integrators are compared.

Case 1: a two-stage planetary gearbox with a second motor between the stages, rotations only (architecture of Pulvirenti
2023, chapter 3; dimensions chosen here). Case 2: a face-gear split torque gearbox with a floating pinion; masses,
stiffnesses and backlash are chosen here.
"""

import math

import numpy as np

from gearwright.dynamics import DampingRatio, Line, Model, Periodic, System

COSINE = math.cos(math.radians(20.0))
SQUARE_WAVE = tuple(0.25 / number if number % 2 else 0.0 for number in range(1, 6))
"""A square wave of ±π/16 of the mean about it, cut at the fifth harmonic."""


def two_stage() -> System:
    """Return case 1: 15 rotations, 20 lines, mesh stiffness with three harmonics."""
    model = Model()
    model.rotation("turbine", inertia=0.05, speed=20000 * math.pi / 30)
    first = stage(model, "1", teeth=(28, 34), planets=3, module=1.5e-3)
    model.rotation("motor", inertia=0.3)
    second = stage(model, "2", teeth=(27, 36), planets=5, module=3.5e-3)
    model.rotation("propeller", inertia=20.0)
    shafts = {("turbine", "sun 1"): 1e5, ("motor", "carrier 1"): 2e5, ("carrier 1", "sun 2"): 5e6}
    for (one, other), stiffness in {**shafts, ("carrier 2", "propeller"): 3e6}.items():
        model.shaft(f"{one} - {other}", one, other, stiffness=stiffness, damping=DampingRatio(0.03))
    model.load("turbine", constant=499.4)
    model.load("motor", constant=2132.7)
    model.load("propeller", constant=-(499.4 * first + 2132.7) * second)
    return model.build()


def stage(model: Model, tag: str, *, teeth: tuple[int, int], planets: int, module: float) -> float:
    """Add a planetary stage with a fixed ring; return its ratio."""
    ring = teeth[0] + 2 * teeth[1]
    sun, planet, outer = (0.5 * module * COSINE * number for number in (*teeth, ring))
    model.rotation(f"sun {tag}", inertia=disc(sun))
    model.rotation(f"carrier {tag}", inertia=0.3 * disc(outer))
    phase = {f"sun {tag}": teeth[0], f"carrier {tag}": -teeth[0]}
    for number in range(planets):
        name = f"planet {tag}.{number + 1}"
        model.rotation(name, inertia=disc(planet))
        turn = 2.0 * math.pi * number / planets
        lines = {
            f"sun - {name}": ({f"sun {tag}": sun, name: planet, f"carrier {tag}": -(sun + planet)}, 4.0e8, teeth[0]),
            f"{name} - ring": ({name: -planet, f"carrier {tag}": -(outer - planet)}, 4.8e8, ring),
        }
        for line, (weights, stiffness, count) in lines.items():
            wave = Periodic(phase, sine=SQUARE_WAVE, offset=count * turn)
            model.mesh(line, weights, stiffness=stiffness, damping=DampingRatio(0.07), variation=wave)
    return 1.0 + ring / teeth[0]


def disc(radius: float) -> float:
    """Return the inertia of a steel disc 50 mm wide [kg m²]."""
    return 0.5 * math.pi * 7800.0 * 0.05 * radius**4


def split_torque(pinion_support: float = 1e7) -> System:
    """Return case 2: 16 coordinates, 16 lines, backlash on four meshes, eccentric gears."""
    model = Model()
    radius = {1: 25.6e-3 * COSINE, 2: 99.2e-3 * COSINE, 4: 33.75e-3 * COSINE, 6: 220e-3 * COSINE}
    radius[3], radius[5] = radius[2], radius[4]
    mass = {1: 1.5, 2: 9.5, 3: 9.5, 4: 45.0}
    support = {"x1": pinion_support, "z1": pinion_support, "x4": 2e10, "y4": 2e10}
    support |= {f"{axis}{shaft}": 5e8 if axis == "z" else 2e9 for shaft in (2, 3) for axis in "xyz"}
    for name, stiffness in sorted(support.items()):
        body = mass[int(name[1])]
        model.translation(name, mass=body)
        model.support(f"bearing {name}", name, stiffness=stiffness, damping=0.1 * math.sqrt(stiffness * body))
    inertia = {1: 5e-4, 2: 0.033, 3: 0.033, 4: 1.7e-3, 5: 1.7e-3, 6: 1.10}
    for number, value in inertia.items():
        model.rotation(f"gear {number}", inertia=value, speed=2.0 * math.pi * 400.0 / 3.0 if number == 1 else None)
    for one, other in ((2, 4), (3, 5)):
        model.shaft(f"shaft {one}", f"gear {one}", f"gear {other}", stiffness=1.3e6, damping=DampingRatio(0.03))
    for line in split_meshes(radius, inertia):
        model.add(line)
    torque = 786.5
    model.load("gear 1", constant=torque)
    model.load("gear 6", constant=-torque * radius[2] / radius[1] * radius[6] / radius[4])
    return model.build()


def split_meshes(radius: dict[int, float], inertia: dict[int, float]) -> list[Line]:
    """Return the four meshes of the split torque gearbox."""
    n = math.cos(math.radians(20.0)), math.sin(math.radians(20.0))
    (c1, s1), (c2, s2) = ((math.cos(math.radians(a)), math.sin(math.radians(a))) for a in (-3.0127, 43.0128))
    weights = {
        (1, 2): {"x1": n[0], "z1": n[1], "x2": -n[0], "z2": -n[1]},
        (1, 3): {"x1": -n[0], "z1": -n[1], "x3": n[0], "z3": n[1]},
        (4, 6): {"x2": -s1, "y2": c1, "x4": s1, "y4": -c1},
        (5, 6): {"x3": -s2, "y3": c2, "x4": s2, "y4": -c2},
    }
    lines = []
    for (one, other), across in weights.items():
        first = one == 1
        effective = 1.0 / (radius[one] ** 2 / inertia[one] + radius[other] ** 2 / inertia[other])
        stiffness = 4e8 if first else 1.2e9
        wave = Periodic({f"gear {one}": 32 if first else 27}, (0.18,), offset=2 * math.pi * 0.5014 * (one == 5))
        lines.append(
            Line(
                f"mesh {one}-{other}",
                {**across, f"gear {one}": radius[one], f"gear {other}": -radius[other]},
                stiffness,
                damping=0.14 * math.sqrt(stiffness * effective),
                backlash=100e-6 if first else 150e-6,
                variation=wave,
                errors=(Periodic({f"gear {one}": 1}, (25e-6,), offset=float(other)),),
                kind="mesh",
            )
        )
    return lines


CASES = {"two-stage planetary": two_stage, "split torque": split_torque}


def mesh_columns(system: System) -> np.ndarray:
    """Return which lines are meshes."""
    return np.array([kind == "mesh" for kind in system.labels.line_kinds])
