"""Public REXS files as designs: python benchmarks/rexs_files.py CLONE [FILE].

CLONE is one of github.com/fva-net/rexs-diff: every REXS file of its whole history is read and sized. FILE is one that
states safeties by DIN 3990 (left out: that of the clone): S_F as it states them, beside ours, and ours with its load
factors, limits and lives.
"""

from __future__ import annotations

import math
import re
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path
from time import process_time

import gearwright as gw
from gearwright.catalogue import rated_steel
from gearwright.exchange.rexs.files import Document, opened

STEM = re.compile(r"[-_. ]*(rexsj?[-_])?(1[-_]\d|bearinx[-_]1|mod|export|neu|results|edit|geom).*$", re.IGNORECASE)
"""What of a name tells versions, exports and modifications of one gearbox."""
REASONS = {
    "no cylindrical, bevel": "worms, or no gears",
    "hypoid": "hypoid",
    "cross": "crossed axes",
    "undercuts": "undercut teeth",
    "no load case loads": "an unloaded shaft",
    "torque": "no torque or speed",
    "speeds": "no torque or speed",
}
"""What stands in a problem -> why a file becomes no design."""
ENDURANCE, LONG, AT_LONG = 3e6, 1e10, 0.85
"""Y_NT falls from 1 at the first to the third at the second number of cycles (ISO 6336-3:2019, figure 18)."""


def files_of(clone: Path) -> Iterator[tuple[str, bytes]]:
    """Yield name and content of every REXS file that a clone has ever had, each content once."""
    git = ["git", "-C", str(clone)]
    listed = subprocess.run(
        [*git, "rev-list", "--all", "--objects"], capture_output=True, text=True, check=False
    ).stdout
    named = dict(line.split(" ", 1) for line in listed.splitlines() if re.search(r"\.rexs[jz]?$", line))
    for blob, path in sorted(named.items(), key=lambda item: item[1]):
        content = subprocess.run([*git, "cat-file", "blob", blob], capture_output=True, check=False).stdout
        if content:
            yield Path(path).name, content


def outcome(path: Path) -> str:
    """Return what became of a file: sized, or the kind of its first problem."""
    try:
        gw.size(gw.from_rexs(path).design)
    except (gw.DesignError, gw.SolveError) as error:
        text = str(error)
        return next((said for words, said in REASONS.items() if words in text), "teeth or places that do not close")
    return "sized"


def stated(path: Path) -> None:
    """Print S_F by DIN 3990 of a file beside ours, and ours with its K factors, σ_Flim and lives."""
    read, document = gw.from_rexs(path), opened(path)
    sizing = gw.size(gw.edited(read.design, {"gears.rating": "din3990"}))
    print(f"{'gear':32}{'stated':>8}{'ours':>8}{'their K, σ_Flim, Y_NT':>24}")
    for mesh in sizing.meshes:
        rating = mesh.rating
        loads = rating.factors.loads
        ours = loads.application * loads.dynamic * loads.face_bending * loads.transverse_bending
        exponent = math.log(loads.face_bending) / math.log(loads.face_contact)
        theirs = load_factors(document, mesh.name, exponent)
        for side, gear in enumerate(mesh.gears):
            (said,) = [one for one in read.stated if one.gear == gear]
            limit = limit_of(document, read.design, gear)
            life = (cycles_of(document, said.line) / ENDURANCE) ** (math.log(AT_LONG) / math.log(LONG / ENDURANCE))
            safety = float(rating.bending[side])
            like = safety * ours / theirs * limit * life
            print(f"{gear:32}{said.value:8.3f}{safety:8.3f}{like:14.3f} ({100.0 * (like / said.value - 1.0):+.1f} %)")


def load_factors(document: Document, mesh: str, exponent: float) -> float:
    """Return K_A K_V K_Fβ K_Fα of a stage by DIN 3990, as its file states them; K_A is 1 there."""
    stages = document.of_kind("cylindrical_stage")
    (stage,) = [one for one in stages if mesh.endswith("-" + re.findall(r"[0-9]+", one.name)[-1])]

    def said(name: str) -> float:
        return float(stage.attributes[name].text)

    face = said("face_load_factor_flank_din_3990_1987") ** exponent
    return said("dynamic_factor_din_3990_1987") * face * said("transverse_load_factor_flank_din_3990_1987")


def limit_of(document: Document, design: gw.Design, gear: str) -> float:
    """Return the file's σ_Flim over that of the catalogue's steel of the same name."""
    name = design.gears.material
    said = next(one for one in document.of_kind("material") if one.attributes["material_designation"].text == name)
    ours = rated_steel(design.material(name)).bending_strength
    return float(said.attributes["endurance_limit_root"].text) / (1e-6 * ours)


def cycles_of(document: Document, line: int) -> float:
    """Return the load cycles of the gear whose safety stands in a line."""
    data = [one for one in document.of_kind("cylindrical_stage_gear_data")
            if any(said.line == line for said in one.attributes.values())]  # fmt: skip
    return float(data[0].attributes["number_of_load_cycles"].text)


def main() -> None:
    """Print what became of every file, gearbox by gearbox, and the safeties."""
    clone, became = Path(sys.argv[1]), defaultdict(Counter)
    with tempfile.TemporaryDirectory() as folder:
        results, begun = None, process_time()
        for place, (name, content) in enumerate(files_of(clone)):
            path = Path(folder) / f"{place}-{name}"
            path.write_bytes(content)
            became[STEM.sub("", Path(name).stem).lower()][outcome(path)] += 1
            if "1-4_results" in name:
                results = path
        for gearbox, counts in sorted(became.items()):
            print(f"{gearbox:45}" + ", ".join(f"{count} {said}" for said, count in counts.most_common()))
        whole = sum(became.values(), Counter())
        print(f"{whole.total()} files of {len(became)} names: {whole['sized']} sized; {process_time() - begun:.1f} s")
        stated(Path(sys.argv[2]) if len(sys.argv) > 2 else results)


if __name__ == "__main__":
    main()
