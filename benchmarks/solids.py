"""Solids of shipped designs: what they weigh, how deep teeth and bodies stand in each other, how large files are.

Run: python benchmarks/solids.py masses, teeth, bodies, files or step [--designs a,b]; `masses` about half a minute of
processor time, `teeth` two minutes; `step` needs Open CASCADE. `docs/how-to/see-it-turn.md` has what it prints.
"""

import argparse
import statistics
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np

import gearwright as gw
from gearwright.exchange.step import to_step
from gearwright.identity import HOUSING
from gearwright.parts.gears import least_backlash
from gearwright.shape import Scene, casing_masses, glb, kind_of, sized_mesh, solid_masses
from gearwright.shape.scene import CORNERS
from gearwright.shape.stands import triangles_of
from gearwright.sizing import Sizing
from gearwright.sizing.mass import bevel_cones

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from overlaps import crossed_depths, deepest, overlaps, planar_contacts

MOMENTS = np.linspace(0.0, 0.3, 50)
"""Instants at which teeth are looked at: hundreds of turns [s]."""
REPEATS = 9
"""How often a file is made for the median of its time [-]."""


def masses(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield, by kind of part and level, how far solids are from what sizing weighs."""
    yield ("level", "parts", "number", "solid against weight")
    for level in ("as shipped", "preliminary"):
        gaps: dict[str, list[float]] = {}
        for name in names:
            sizing = _at(name, level)
            if sizing is None:
                continue
            scene = gw.scene(sizing, detail="smooth")
            for row in solid_masses(sizing, scene):
                weight = row.sized if level == "preliminary" and str(row.part.kind) == "gear" else row.weighed
                if weight and f"{row.part}.mass" not in sizing.given:
                    kind = "shells of housings" if row.part == HOUSING else f"{row.part.kind}s"
                    gaps.setdefault(kind, []).append(row.solid / weight - 1.0)
            for part, (solid, weight) in casing_masses(sizing, scene).items():
                gaps.setdefault(part, []).append(solid / weight - 1.0)
            for gap in _bells(sizing, scene):
                gaps.setdefault("bells of rings", []).append(gap)
        for kind, found in gaps.items():
            yield (level, kind, str(len(found)), f"{100 * min(found):+.2f} to {100 * max(found):+.2f} %")


def _bells(sizing: Sizing, scene: Scene) -> Iterator[float]:
    """Yield by which part of it each bell of a turning ring weighs more as a solid than in the complete mass."""
    weights = {item.part: item.each for item in gw.complete_mass(sizing).parts}
    density = sizing.design.shaft_material.density
    for node in scene.nodes:
        if node.look == "bell" and node.name in weights:
            yield density * triangles_of(scene.solids[node.surface], CORNERS).volume / weights[node.name] - 1.0


def _at(name: str, level: str) -> Sizing | None:
    """Return a shipped design sized at a level; None where it has bearings or asks for what that level cannot know."""
    design = gw.read(name)
    if level == "as shipped":
        return gw.size(design)
    if design.bearings:
        return None
    try:
        return gw.size(gw.at_level(design, "preliminary"))
    except gw.DesignError:
        return None


def teeth(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield how deep teeth stand in each other at the worst of all instants, beside their backlash."""
    yield ("design", "mesh", "teeth", "deepest, µm", "backlash, µm")
    for name in names:
        sizing = gw.size(gw.read(name))
        worst: dict[str, tuple[float, str]] = {}
        for mesh, kind, depth in _depths(sizing):
            if mesh not in worst or depth > worst[mesh][0]:
                worst[mesh] = (depth, kind)
        for mesh, (depth, kind) in worst.items():
            if depth > 2e-6:  # what rounding leaves
                yield (name, mesh, kind, f"{1e6 * depth:.3g}", f"{1e6 * _backlash(sizing, mesh):.3g}")


def _depths(sizing: Sizing) -> Iterator[tuple[str, str, float]]:
    """Yield row of the train, kind of teeth and depth of every mesh."""
    planar = planar_contacts(sizing)
    seen: set[str] = set()
    for contact in planar.contacts:
        if (
            contact.mesh.name not in seen
            and f"{contact.first.name} and {contact.second.name}" not in planar.phases.missed
        ):
            seen.add(contact.mesh.name)
            kind = "internal" if contact.mesh.sign > 0 else "external"
            yield contact.mesh.name, kind, deepest(sizing, contact, planar, MOMENTS)
    rows = {mesh.stage: mesh.name for mesh in sizing.train.meshes}
    for pair, depth in crossed_depths(sizing, gw.scene(sizing, detail="coarse"), MOMENTS).items():
        stage = pair.partition(".")[0]
        yield rows[stage], kind_of(sizing, stage), depth


def _backlash(sizing: Sizing, name: str) -> float:
    """Return the least backlash that drawings ask for; of bevel gears by their mean cone distance [m]."""
    row = next(mesh for mesh in sizing.train.meshes if mesh.name == name)
    module = next(gear.module for gear in sizing.gears if gear.name == row.gears[0])
    if kind_of(sizing, row.stage) == "bevel":
        return least_backlash(bevel_cones(sizing, row.stage).mean_cone_distance, module)
    return least_backlash(sized_mesh(sizing, row).centre_distance, module)


def bodies(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield which bodies that turn against each other stand into each other."""
    yield ("design", "bodies", "deep, mm")
    for name in names:
        sizing = gw.size(gw.read(name))
        for overlap in overlaps(sizing, gw.scene(sizing, detail="coarse")):
            yield (name, f"{overlap.one} and {overlap.other}", f"{1e3 * overlap.depth:.3g}")


def files(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield how large GLB files are, and the median processor time of scene and file."""
    yield ("design", "bodies", "triangles", "GLB, MB", "ms")
    for name in names:
        sizing, times = gw.size(gw.read(name)), []
        for _ in range(REPEATS):
            start = time.process_time()
            scene = gw.scene(sizing)
            data = glb(scene)
            times.append(time.process_time() - start)
        count = sum(len(scene.surfaces[node.surface].triangles) for node in scene.nodes if node.surface)
        yield (
            name,
            str(len(scene.nodes)),
            str(count),
            f"{1e-6 * len(data):.3f}",
            f"{1e3 * statistics.median(times):.0f}",
        )


def step(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield how large STEP files are, and the processor time of scene and file, the less of two."""
    yield ("design", "solids, bodies", "STEP, MB", "s")
    for name in names:
        sizing, times = gw.size(gw.read(name)), []
        for _ in range(2):  # the first one also loads Open CASCADE
            start = time.process_time()
            file = to_step(sizing)
            times.append(time.process_time() - start)
        yield (name, f"{file.solids}, {file.bodies}", f"{1e-6 * len(file.content):.1f}", f"{min(times):.1f}")


def printed(rows: Iterable[Sequence[str]]) -> None:
    """Print rows as a table of Markdown."""
    for k, row in enumerate(rows):
        print("| " + " | ".join(row) + " |", flush=True)
        if k == 0:
            print("|" + " --- |" * len(row))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    what = {"masses": masses, "teeth": teeth, "bodies": bodies, "files": files, "step": step}
    parser.add_argument("what", choices=what)
    parser.add_argument("--designs", default=",".join(gw.shipped_designs()))
    asked = parser.parse_args()
    printed(what[asked.what](asked.designs.split(",")))


if __name__ == "__main__":
    main()
