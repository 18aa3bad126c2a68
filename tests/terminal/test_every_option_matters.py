"""Every option of every command changes what comes, or is refused with the reason: none is passed over in silence."""

from __future__ import annotations

import shlex
import shutil

import pytest
import typer.main
from commands import JOURNAL, RATED, furnish

from designs import HYBRID
from gearwright.cli import app, main

UNMOVED = {
    "browser": "printed by a browser, which there need not be",
    "long": "asks for minutes of closing, which `tests/unit/closure` and `tests/unit/enumeration` have smaller",
    "pace": "says how it is computed; the numbers are the same",
    "serves": "a server that runs until it is ended",
    "page": "the whole page, which `tests/golden` and minutes of flying ask for",
}
"""Why options have no case here."""
SAME = {
    "serves": ("app --port", "app --browser", "app --folder"),
    "browser": ("review --pdf", "report --pdf"),
    "long": ("close --crossings", "architectures --close", "architectures --beside", "architectures --out",
             "architectures --restarts"),
    "pace": (
        "architectures --workers", "optimise --workers", "study --workers", "study --cluster", "resume --workers",
        "resume --cluster",
    ),
    "page": ("thesis --chapter-4", "replay pulvirenti --chapter-4"),
}  # fmt: skip
"""Reason -> the options that have it."""
TURBOSHAFT = (
    "--power-kw 835 --fuel-kg-kwh 0.35 --air-flow-kg-s 3.6 --pressure-ratio 9 --n1-rpm 43000 --altitudes-m 0:3000:3000"
    " --machs 0:0.3:0.3"
)
SLAM, START = "--slam-kw 300:800 --slam-s 2", "--starter-nm 60"
HELD = f"{SLAM} --rotor-inertia-kg-m2 1.5 --n2-rpm 6000"
ROTOR = "--mass-kg 1600 --diameter-m 10 --rpm 406 --solidity 0.057"
TAIL = "--tail-diameter-m 1.9 --tail-rpm 2000 --tail-arm-m 6 --tail-solidity 0.2"
POINT = "--rpm 1212 --tas-m-s 140 --power-kw 1600"
OPTIMISE = "--free carriers.fill=0.4..0.8 --screened 0 --evaluations 4 --workers 0 --seed 1"
ARCHITECTURES = "--stages 1 --close 0 --workers 0"
COMPARE = "pair.toml"
CHANGED = "@changed"
"""Stands in a line for which a design has changed since."""
WITHOUT_REFUSED = {
    "new --force", "import --force", "propeller --rpm", "propeller --power-kw", "propeller --blade-angle-deg",
    "rotor --tail-diameter-m", "rotor --tail-rpm", "rotor --tail-arm-m", "rotor --tail-solidity",
    "turboshaft --rotor-inertia-kg-m2", "turboshaft --n2-rpm", "mass --origin",
}  # fmt: skip
"""Options without which the same line is refused."""
CASES = {
    "new": ("", {"--force": "star pair.toml | --force", "--json": "--json"}),
    "run": (
        "pair.toml --duration 0.001",
        {
            "--case": "--case no-such",
            "--duration": "--duration 0.002",
            "--stiffness": "--stiffness constant",
            "--out": "--out results",
            "--date": "--date 2020-01-01",
            "--full": "--full",
            "--json": "--json",
        },
    ),
    "check": ("pair.toml", {"--json": "--json"}),
    "size": (
        "rated.toml",
        {
            "--json": "--json",
            "--factors": "--factors",
            "--methods": "--methods",
            "--wish": "--wish 1.5",
            "--level": "--level preliminary",
            "--life-h": "--life-h 90000",
        },
    ),
    "close": (
        "rated.toml",
        {
            "--life-h": "--life-h 100",
            "--mission": "--mission no-such",
            "--continuous": "--continuous",
            "--as-sized": "--as-sized",
            "--free": "--free rims",
            "--rounds": "--rounds",
            "--variants": "=stuck.toml | --variants",
            "--why": "=stuck.toml | --why",
            "--out": "--out closed.toml",
            "--start": "--start rated.toml",
            "--journal": "--journal closing.journal",
            "--json": "--json",
        },
    ),
    "arrange": (
        "pair.toml",
        {
            "--life-h": "--life-h 100",
            "--free": "--free all",
            "--as-sized": "--as-sized",
            "--level": "--level concept",
            "--out": "--out arranged.toml",
            "--json": "--json",
        },
    ),
    "review": (
        "pair.toml",
        {"--report": "--report r.html", "--date": "--report r.html | --date 2020-01-01", "--json": "--json"},
    ),
    "report": ("pair.toml", {"--out": "--out r.html", "--results": "--results none.nc", "--date": "--date 2020-01-01"}),
    "draw": (
        "pair.toml --what arrangement --format svg",
        {
            "--out": "--out sheets",
            "--what": "--what shaft",
            "--format": "--format dxf",
            "--report": "--report r.html",
            "--date": "--report r.html | --date 2020-01-01",
        },
    ),
    "export": (
        "pair.toml --to csv",
        {
            "--to": "--to json",
            "--out": "--out all.csv",
            "--detail": "--to glb | --detail coarse",
            "--case": "--case rated",
            "--step": "--step 1e-6",
            "--mission": "--mission thesis",
            "--window": "--window cut",
            "--table": "--table gears",
        },
    ),
    "import": ("sew.rexs --out sew.toml", {"--out": "--out other.toml", "--force": "--out pair.toml | --force"}),
    "schema": ("", {"--of": "--of mission", "--answer": "--answer size"}),
    "modes": ("hybrid.toml", {"--case": "--case no-such", "--json": "--json"}),
    "simulate": (
        "pair.toml --duration 0.001",
        {
            "--case": "--case no-such",
            "--duration": "--duration 0.002",
            "--stiffness": "--stiffness constant",
            "--output": "--output run.nc",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "campbell": ("hybrid.toml", {"--case": "--case cruise", "--figure": "--figure c.svg", "--json": "--json"}),
    "response": (
        "hybrid.toml",
        {
            "--case": "--case no-such",
            "--mesh": "--mesh second.sun-planet",
            "--error-um": "--error-um 2",
            "--top-khz": "--top-khz 2",
            "--figure": "--figure f.svg",
            "--json": "--json",
        },
    ),
    "runup": (
        "pair.toml --speeds 2",
        {
            "--case": "--case no-such",
            "--line": "--line no-such",
            "--lowest": "--lowest 0.5",
            "--highest": "--highest 1",
            "--speeds": "--speeds 3",
            "--figure": "--figure f.svg",
            "--json": "--json",
        },
    ),
    "sharing": (
        "face-gear-split-torque",
        {
            "--stage": "--stage no-such",
            "--case": "--case no-such",
            "--method": "--method quasi-static",
            "--target": "--target 52/48",
            "--percent": "--target 52/48 | --percent 80",
            "--seed": "--target 52/48 | --seed 9",
            "--figure": "--figure f.svg",
            "--report": "--report r.html",
            "--json": "--json",
        },
    ),
    "fly": (
        "in-line-h2 thesis",
        {
            "--life-h": "--life-h 90000",
            "--report": "--report r.html",
            "--window": "--window no-such",
            "--date": "--report r.html | --date 2020-01-01",
            "--csv": "--csv f.csv",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "window": (
        "in-line-h2 thesis taxi-to-hybrid",
        {
            "--stiffness": "--stiffness constant",
            "--output": "--output run.nc",
            "--figure": "--figure f.svg",
            "--report": "--report r.html",
            "--date": "--report r.html | --date 2020-01-01",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "mix": ("in-line-h2", {"--report": "--report r.html", "--json": "--json"}),
    "duty": (
        "bench.csv --classes 5",
        {
            "--classes": "--classes 6",
            "--machine": "--machine turbine",
            "--name": "--name bench",
            "--out": "--out duty.toml",
            "--cycles": "--cycles repeated",
            "--json": "--json",
        },
    ),
    "propeller": (
        "--ratios 0:2:0.5 --angles-deg 0:40:10",
        {
            "--blades": "--blades 3",
            "--activity-factor": "--activity-factor 140",
            "--design-lift": "--design-lift 0.4",
            "--by": f"{POINT} | --by charts",
            "--ratios": "--ratios 0:3:0.5",
            "--angles-deg": "--angles-deg 0:50:10",
            "--tip-mach": "--tip-mach 0.6",
            "--rpm": "--power-kw 1600 --tas-m-s 140 | --rpm 1212",
            "--diameter-m": f"{POINT} | --diameter-m 4.2",
            "--tas-m-s": "--rpm 1212 --power-kw 1600 | --tas-m-s 120",
            "--altitude-m": f"{POINT} | --altitude-m 3000",
            "--power-kw": "--rpm 1212 --tas-m-s 140 | --power-kw 1500",
            "--blade-angle-deg": "--rpm 1212 --tas-m-s 140 | --blade-angle-deg 35",
            "--incidence-deg": f"{POINT} | --incidence-deg 3",
            "--out": "--out map.csv",
            "--figure": "--figure f.svg",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "rotor": (
        ROTOR,
        {
            "--mass-kg": "--mass-kg 1700",
            "--diameter-m": "--diameter-m 11",
            "--rpm": "--rpm 420",
            "--solidity": "--solidity 0.07",
            "--flat-plate-area-m2": "--flat-plate-area-m2 0.5",
            "--speeds-m-s": "--speeds-m-s 0:40:10",
            "--altitude-m": "--altitude-m 2000",
            "--isa-offset-k": "--isa-offset-k 20",
            "--rate-of-climb-m-s": "--rate-of-climb-m-s 2",
            "--profile-drag": "--profile-drag 0.012",
            "--induced-factor": "--induced-factor 1.2",
            "--download": "--download 0.05",
            "--tail-diameter-m": "--tail-rpm 2000 --tail-arm-m 6 --tail-solidity 0.2 | --tail-diameter-m 1.9",
            "--tail-rpm": "--tail-diameter-m 1.9 --tail-arm-m 6 --tail-solidity 0.2 | --tail-rpm 2000",
            "--tail-arm-m": "--tail-diameter-m 1.9 --tail-rpm 2000 --tail-solidity 0.2 | --tail-arm-m 6",
            "--tail-solidity": "--tail-diameter-m 1.9 --tail-rpm 2000 --tail-arm-m 6 | --tail-solidity 0.2",
            "--tail-induced-factor": f"{TAIL} | --tail-induced-factor 0.9",
            "--json": "--json",
        },
    ),
    "turboshaft": (
        TURBOSHAFT,
        {
            "--power-kw": "--power-kw 900",
            "--fuel-kg-kwh": "--fuel-kg-kwh 0.37",
            "--air-flow-kg-s": "--air-flow-kg-s 3.9",
            "--pressure-ratio": "--pressure-ratio 10",
            "--n1-rpm": f"{SLAM} | --n1-rpm 44000",
            "--inertia-kg-m2": f"{SLAM} | --inertia-kg-m2 0.08",
            "--compressor": "--compressor 0.8",
            "--turbine": "--turbine 0.85",
            "--altitudes-m": "--altitudes-m 0:6000:3000",
            "--machs": "--machs 0:0.6:0.3",
            "--slam-kw": "--slam-kw 300:800",
            "--slam-altitude-m": f"{SLAM} | --slam-altitude-m 1000",
            "--slam-mach": f"{SLAM} | --slam-mach 0.2",
            "--isa-offset-k": f"{SLAM} | --isa-offset-k 10",
            "--slam-s": f"{SLAM} | --slam-s 3",
            "--acceleration": f"{SLAM} | --acceleration 0.9",
            "--rotor-inertia-kg-m2": f"{SLAM} --n2-rpm 6000 | --rotor-inertia-kg-m2 1.5",
            "--n2-rpm": f"{SLAM} --rotor-inertia-kg-m2 1.5 | --n2-rpm 6000",
            "--n2-gain": f"{HELD} | --n2-gain 2",
            "--n2-integral": f"{HELD} | --n2-integral 1",
            "--n2-limit": "--slam-kw 800:100 --slam-s 4 --rotor-inertia-kg-m2 0.5 --n2-rpm 6000 | --n2-limit 1.01",
            "--starter-nm": START,
            "--starter-cut": f"{START} | --starter-cut 0.4",
            "--hottest-k": f"{START} | --hottest-k 900",
            "--out": "--out deck.csv",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "compare": (
        COMPARE,
        {
            "--power-kw": "--power-kw 900",
            "--engine-rpm": "--engine-rpm 25000",
            "--propeller-rpm": "--propeller-rpm 1300",
            "--set": "--set gears.contact_safety=2",
            "--life-h": "--life-h 300",
            "--free": "--free teeth",
            "--out": "--out closed",
            "--csv": "--csv t.csv",
            "--figure": "--figure f.svg",
            "--report": "--report r.html",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "architectures": (
        f"pair.toml {ARCHITECTURES}",
        {
            "--life-h": "--life-h 100",
            "--stages": "--stages 2",
            "--motor-rpm": "--motor-rpm 5000",
            "--journal": "--journal found",
            "--csv": "--csv t.csv",
            "--report": "--report r.html",
            "--json": "--json",
        },
    ),
    "optimise": (
        f"hybrid.toml {OPTIMISE}",
        {
            "--free": "--free carriers.fill=0.5..0.7",
            "--minimise": "--minimise mass",
            "--maximise": "--maximise efficiency",
            "--keep": "--keep mass<=45",
            "--screened": "--screened 4",
            "--evaluations": "--evaluations 6",
            "--restarts": "--restarts 2",
            "--seed": "--seed 2",
            "--journal": "--journal found",
            "--anyway": "--anyway",
            "--out": "--out best",
            "--csv": "--csv t.csv",
            "--report": "--report r.html",
            "--json": "--json",
        },
    ),
    "study": (
        "small.toml --workers 0",
        {
            "--set": "--set carriers.fill=0.5",
            "--journal": "--journal kept",
            "--shard": "--shard 1/2",
            "--tls": "--tls a b c",
            "--csv": "--csv t.csv",
            "--export": "--export t.nc",
            "--figure": "--figure f.svg",
            "--report": "--report r.html",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "status": ("journal", {"--verify": "--verify", "--json": "--json"}),
    "resume": (
        "journal --workers 0",
        {
            "--tls": "--tls a b c",
            "--shard": "--shard 2/0",
            "--anyway": "@changed | --anyway",
            "--csv": "--csv t.csv",
            "--export": "--export t.nc",
            "--report": "--report r.html",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "merge": ("journal --into whole", {"--into": "--into other", "--export": "--export t.nc"}),
    "cluster": (
        "",
        {
            "--host": "--host 10.0.0.1",
            "--processes": "--processes 77",
            "--tls": "--tls a b c",
            "--slurm": "--slurm 4",
            "--study": "--slurm 4 | --study small.toml",
        },
    ),
    "mass": (
        "--power-kw 2051 --engine-rpm 20204 --propeller-rpm 1212",
        {
            "--power-kw": "--power-kw 1800",
            "--engine-rpm": "--engine-rpm 18000",
            "--propeller-rpm": "--propeller-rpm 1300",
            "--design": "--design pair.toml",
            "--mass-kg": "--mass-kg 150",
            "--origin": "--mass-kg 150 | --origin scales",
            "--report": "--report r.html",
            "--json": "--json",
        },
    ),
    "engines": (
        "",
        {
            "--series": "--series CT7",
            "--manufacturer": "--manufacturer Pratt",
            "--kind": "--kind turboshaft",
            "--model": "--model PW127",
            "--min-power-kw": "--min-power-kw 1800",
            "--max-power-kw": "--max-power-kw 1800",
            "--sort": "--sort power",
            "--csv": "--csv t.csv",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "validate": (
        "Timoshenko",
        {
            "--report": "--report r.html",
            "--date": "--report r.html | --date 2020-01-01",
            "--json": "--json",
            "--jsonl": "--jsonl",
        },
    ),
    "thesis": ("", {"--out": "--out t.md", "--errata": "--errata", "--figures": "--figures f"}),
    "colibri": ("", {"--part": "--part shaft-1", "--wrong": "--wrong", "--out": "--out c.md", "--json": "--json"}),
    "replay pulvirenti": ("", {"--out": "--out t.md", "--errata": "--errata", "--figures": "--figures f"}),
    "replay colibri": (
        "",
        {"--part": "--part shaft-1", "--wrong": "--wrong", "--out": "--out c.md", "--json": "--json"},
    ),
    "replay wang": ("", {"--out": "--out w.html"}),
}
"""Command -> what is given in every call, and option -> what gives it; before a bar what is given with and without."""


def options(command, path=()):
    """Yield every option of the tool by its command: ``fly --csv``."""
    if hasattr(command, "commands"):
        for name, inner in command.commands.items():
            yield from options(inner, (*path, name))
        return
    for parameter in command.params:
        if parameter.opts[0].startswith("--"):
            yield " ".join((*path, parameter.opts[0]))


ALL = tuple(options(typer.main.get_command(app)))
EXCUSED = {name for names in SAME.values() for name in names}


def test_every_option_has_a_case():
    """A new option needs one, or its reason among those that have none."""
    cased = {f"{command} {option}" for command, (_, given) in CASES.items() for option in given}
    assert cased | EXCUSED == set(ALL)
    assert not cased & EXCUSED
    assert set(SAME) == set(UNMOVED)


STUCK = RATED.replace("[pairs.stage]", "[pairs.stage]\nmodule_mm = 1.0\nface_width_mm = 8.0")
"""A pair whose given sizes are too small."""


@pytest.fixture(scope="module")
def furnished(tmp_path_factory):
    """A folder with the files that commands read."""
    folder = tmp_path_factory.mktemp("furnished")
    furnish(folder)
    (folder / "stuck.toml").write_text(STUCK, encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setattr("sys.argv", ["gearwright", *JOURNAL])
        with pytest.raises(SystemExit) as end:
            main()
    assert end.value.code == 0
    return folder


@pytest.fixture(scope="module")
def known():
    """What calls gave: several options of a command are held against the same one."""
    return {}


def split(command, option):
    """Return the words of a command without and with an option."""
    base, given = CASES[command]
    context, bar, changed = given[option].rpartition("|")
    base = f"{base} {context}" if not context.strip().startswith("=") else context.strip()[1:]
    del bar
    words = shlex.split(f"{command} {base}")
    return words, [*words, *shlex.split(changed)]


@pytest.mark.parametrize("name", [name for name in ALL if name not in EXCUSED])
def test_an_option_changes_what_comes_or_is_refused_by_its_name(name, furnished, known, tmp_path, monkeypatch, capsys):
    command, _, option = name.rpartition(" ")

    def come(words):
        """Return exit code, what is printed and what is written."""
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        shutil.copytree(furnished, folder)
        if CHANGED in words:
            (folder / "hybrid.toml").write_text(HYBRID.replace("1046", "1040"), encoding="utf-8")
        before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        monkeypatch.chdir(folder)
        monkeypatch.setattr("sys.argv", ["gearwright", *(word for word in words if word != CHANGED)])
        with pytest.raises(SystemExit) as end:
            main()
        told = capsys.readouterr()
        files = {
            path.relative_to(folder): path.read_bytes()
            for path in folder.rglob("*")
            if path.is_file() and path.read_bytes() != before.get(path)
        }
        return end.value.code, told.out + told.err, files

    without, given = split(command, option)
    if tuple(without) not in known:
        known[tuple(without)] = come(without)
    plain = known[tuple(without)]
    changed = come(given)
    assert plain[0] in (0, 1) or (plain[0] == 2 and (name in WITHOUT_REFUSED or CHANGED in without)), plain[1]
    assert changed != plain
    if changed[0] == 2:
        assert any(word in changed[1] for word in (*option.strip("-").split("-"), *given[-1:])), changed[1]
