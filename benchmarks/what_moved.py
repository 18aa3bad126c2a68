"""Masses of every shipped design, as a record or beside an earlier one.

python benchmarks/what_moved.py record before.json [--designs FOLDER]    in a checkout of before, or of its files today
python benchmarks/what_moved.py table before.json code.json              beside today's
"""

import json
import sys
from pathlib import Path

import gearwright as gw
from gearwright.errors import GearwrightError
from gearwright.sizing.mass import complete_mass

ROW = "| `{}` | {:.1f} | {:.1f} | {:.1f} | {:+.1f} | {:+.1f} | {} |"


def masses(folder: Path | None) -> dict[str, tuple[float, float, str]]:
    """Return design -> train as sized, complete mass [kg] and the worst check of its review."""
    found = {}
    for name in gw.shipped_designs():
        path = gw.shipped_design(name) if folder is None else folder / f"{name}.toml"
        try:
            design = gw.read(path)
            sizing, worst = gw.size(design), gw.review(design).worst
            verdict = "" if worst is None else f"{worst.name} {worst.margin:.3f}"
            found[name] = (sizing.mass, complete_mass(sizing).total, verdict)
        except (GearwrightError, OSError) as error:
            print(f"{name}: {error}", file=sys.stderr)
    return found


def table(before: Path, code: Path) -> None:
    """Print complete masses before, of files of before with formulas of today, and today."""
    was, between, now = json.loads(before.read_text()), json.loads(code.read_text()), masses(None)
    print("| design | before | formulas of today | today | by formulas | closed anew | worst check today |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | --- |")
    for name, (_, mass, verdict) in now.items():
        old, same = was[name][1], between[name][1]
        print(ROW.format(name, old, same, mass, same - old, mass - same, verdict))


def main() -> None:
    """Record masses, or print them beside a record."""
    verb, path, *rest = sys.argv[1:]
    if verb == "record":
        folder = Path(rest[1]) if rest[:1] == ["--designs"] else None
        Path(path).write_text(json.dumps(masses(folder), indent=1) + "\n")
    else:
        table(Path(path), Path(rest[0]))


if __name__ == "__main__":
    main()
