"""Every command of the README's table with words that keep it short, and what it needs in its folder."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from designs import HYBRID, PAIR


@dataclass(frozen=True)
class Command:
    """One command as a user would give it."""

    line: str
    """Without the word gearwright."""
    narrow: bool = False
    """Whether a narrow terminal shows fewer columns by intention."""
    machine: bool = False
    """Whether it prints JSON, or commands to copy, which nothing folds."""

    @property
    def words(self) -> list[str]:
        """The arguments."""
        return self.line.split()


SERVING = {"app"}
"""Commands that run until they are ended; `tests/browser` has them."""
COMMANDS = (
    Command("new"),
    Command("new star --force"),
    Command("check pair.toml"),
    Command("size hybrid.toml"),
    Command("size rated.toml --factors"),
    Command("size pair.toml --json", machine=True),
    Command("engines --series PW100 --jsonl", machine=True),
    Command("new --json", machine=True),
    Command("modes hybrid.toml"),
    Command("simulate hybrid.toml --duration 0.001 --stiffness constant"),
    Command("run pair.toml --duration 0.001 --stiffness constant"),
    Command("review ec120b"),
    Command("report pair.toml"),
    Command("draw pair.toml --what arrangement --format svg"),
    Command("export pair.toml --to glb"),
    Command("export pair.toml --to fmu"),
    Command("export pair.toml --to html --out turning.html --detail coarse"),
    Command("export pair.toml --to rexs"),
    Command("export pair.toml --to csv"),
    Command("export pair.toml --to csv --table gears --out gears.csv"),
    Command("export pair.toml --to netcdf"),
    Command("import sew.rexs --out sew.toml --force"),
    Command("schema", machine=True),
    Command("campbell pair.toml"),
    Command("response hybrid.toml"),
    Command("runup pair.toml --speeds 2"),
    Command("sharing face-gear-split-torque"),
    Command("fly"),
    Command("mix in-line-h2"),
    Command("duty bench.csv --classes 5"),
    Command("duty bench.csv --cycles half-cycles"),
    Command("propeller --ratios 0:2:0.5 --angles-deg 0:40:10"),
    Command(
        "turboshaft --power-kw 835 --fuel-kg-kwh 0.35 --air-flow-kg-s 3.6 --pressure-ratio 9 --n1-rpm 43000"
        " --altitudes-m 0:3000:3000 --machs 0:0.3:0.3",
    ),
    Command("rotor --mass-kg 1600 --diameter-m 10 --rpm 406 --solidity 0.057", narrow=True),
    Command("fly in-line-h2"),
    Command("window in-line-h2"),
    Command("compare in-line star"),
    Command("architectures pair.toml --stages 1 --close 0 --workers 0"),
    Command("optimise hybrid.toml --free carriers.fill=0.4..0.8 --screened 0 --evaluations 24 --workers 0"),
    Command("close pair.toml --life-h 1000 --as-sized"),
    Command("arrange pair.toml --out arranged.toml"),
    Command("study"),
    Command("study small.toml --workers 0"),
    Command("status journal"),
    Command("resume journal --workers 0"),
    Command("merge journal --into whole"),
    Command("cluster", machine=True),
    Command("mass --power-kw 2051 --engine-rpm 20204 --propeller-rpm 1212", narrow=True),
    Command("engines --series PW100", narrow=True),
    Command("validate Timoshenko"),
    Command("thesis --errata"),
    Command("colibri --part shaft-1"),
    Command("replay pulvirenti"),
    Command("replay wang"),
)
RATED = PAIR + '\n[gears]\nrating = "iso6336"\n'
STUDY = """\
schema = 1
name = "fills of a carrier, and what they weigh"
designs = ["hybrid.toml"]
results = ["mass"]
[axes]
"carriers.fill" = {from = 0.4, to = 0.8}
[sampling]
method = "sobol"
count = 4
[objectives]
mass = "minimum"
"""
BENCH = "time_s,torque_nm,speed_rpm,temperature_c\n" + "".join(
    f"{10 * k},{50 * (k % 9)},{600 + 30 * k},{40 + k}\n" for k in range(40)
)
SEW = Path(__file__).parents[1] / "rexs" / "examples" / "sew_3stage_1.0.rexs"
FILES = {
    "bench.csv": BENCH,
    "sew.rexs": SEW.read_text(encoding="utf-8-sig"),
    "pair.toml": PAIR,
    "hybrid.toml": HYBRID,
    "rated.toml": RATED,
    "small.toml": STUDY,
}
JOURNAL = ["study", "small.toml", "--workers", "0", "--journal", "journal"]
"""What makes the journal of `status` and `resume`."""


def furnish(folder: Path) -> None:
    """Write the files that the commands read."""
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
