"""Random systems for tests: trees and loops of rotations and translations with every feature of the record."""

import numpy as np

from gearwright.dynamics import DampingRatio, Line, Model, Periodic, System


def random_system(seed: int, bodies: int = 6, lines: int = 9, *, coarse: bool = False) -> System:
    """Return a system whose lines join any coordinates, with every feature of the record; coarse weights recur."""
    rng = np.random.default_rng(seed)
    model = Model(profile=((0.0, 1.0), (0.4, 1.3), (0.7, 0.8)))
    names = [model.rotation(f"r{i}", inertia=rng.uniform(0.1, 2.0), speed=0.0) for i in range(bodies - 2)]
    spinning = model.rotation("spinning", inertia=1.0, speed=37.0)
    mass = rng.uniform(0.5, 2.0)
    x, y = model.translation("x", mass=mass), model.translation("y", mass=mass)
    model.rotating_frame(x, y, speed=rng.uniform(-3.0, 3.0))
    model.gyroscopic(names[0], names[1], moment=rng.uniform(-1.0, 1.0))
    names += [x, y]
    for number in range(lines):
        chosen = rng.choice(names, size=rng.integers(1, 5), replace=False)
        weights = {str(name): rng.choice([-1.0, -0.5, 0.5, 1.0]) if coarse else rng.uniform(-1, 1) for name in chosen}
        model.add(random_line(f"line {number}", weights, spinning, rng))
    for name in (*names, spinning):
        model.load(name, constant=rng.normal(), damping=rng.uniform(), quadratic=rng.uniform(0.0, 0.1))
    model.load(names[0], schedule=((0.1, 0.0), (0.5, 2.0), (0.9, -1.0)))
    return model.build()


def random_line(name: str, weights: dict[str, float], spinning: str, rng: np.random.Generator) -> Line:
    """Return a line with a random choice of damping, backlash, variation and errors."""
    return Line(
        name,
        weights,
        stiffness=rng.uniform(10.0, 1000.0),
        damping=DampingRatio(rng.uniform(0.0, 0.2)) if rng.random() < 0.5 else rng.uniform(),
        backlash=float(rng.choice([0.0, 0.05, np.inf])),
        variation=Periodic({spinning: 3}, rng.uniform(-0.2, 0.2, 3), rng.uniform(-0.2, 0.2, 2), rng.uniform(0, 6)),
        errors=(Periodic({spinning: 1}, (0.01,), (0.02,)), Periodic({spinning: 2}, (0.03,)), Periodic(constant=0.01)),
    )
