"""No file, however wrong, gets anything but a sound result or a refusal that can be read; and this is looked for.

Counts are set so that all stages together take some 20 s; `run.py` feeds millions of other files by hand.
"""

import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import fuzz_stages
import pytest
from fuzz_files import Case, case, corpus
from fuzz_oracles import mute, unsound
from fuzz_runner import shortened
from fuzz_stages import Finding, Stage, fed, made

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.sizing import size
from gearwright.spec import parse

SEED = 2026
COUNTS = {"read": 2500, "size": 300, "modes": 150, "simulate": 30, "fly": 30}
"""Files of each stage; those of `check` are the first ones of `size`, which does the same and more."""


@pytest.mark.parametrize("stage", COUNTS)
def test_no_file_breaks_a_verb(stage):
    answers = [fed(stage, made(stage, SEED, number)) for number in range(COUNTS[stage])]
    findings = {number: answer for number, answer in enumerate(answers) if isinstance(answer, Finding)}
    assert not findings, f"see: python tests/fuzz/run.py --stage {stage} --seed {SEED} --show {min(findings)}"
    assert {"answered", "refused"} <= set(answers)


def test_the_same_seed_and_number_give_the_same_file():
    files = [case(5, number) for number in range(200)]
    assert files == [case(5, number) for number in range(200)]
    assert len({each.text for each in files}) > 190
    assert files != [case(6, number) for number in range(200)]


def test_what_is_no_number_in_a_result_is_found():
    sizing = size(parse(corpus("design")["in-line"]))
    assert not list(unsound(sizing))
    gear = sizing.gears[0]
    for wrong, told in ((math.nan, "gears[].mass is nan"), (math.inf, "mass is inf"), (0.0, "mass is not positive")):
        broken = replace(gear, mass=wrong)
        places = list(unsound(replace(sizing, gears=(broken,))))
        assert any(told in place for place in places), wrong


def test_a_refusal_that_says_nothing_or_too_much_is_found():
    assert mute(DesignError([Problem("a", "is wrong; give another")])) is None
    assert mute(DesignError([]))
    assert mute(DesignError([Problem("a", " ")]))
    assert mute(SolveError("is wrong " * 400))
    assert mute(SolveError("\x1b[31m is wrong"))


def planted(monkeypatch, verb):
    """Put a verb of one's own into a stage."""
    monkeypatch.setattr(fuzz_stages, "STAGES", {"planted": Stage(verb)})


def test_an_exception_a_warning_and_a_hang_are_found(monkeypatch):
    def divide(fuzzed):
        return 1 / 0

    def overflow(fuzzed):
        import numpy as np

        return np.float64(1e308) * 10

    def turn(fuzzed):
        try:
            while True:
                pass
        except Exception:
            return

    monkeypatch.setattr(fuzz_stages, "LONGEST", 0.05)
    for verb, told in ((divide, "ZeroDivisionError"), (overflow, "RuntimeWarning"), (turn, "Hang")):
        planted(monkeypatch, verb)
        assert told in fed("planted", Case("design", "in-line", "")).signature


def test_a_file_that_fails_is_shortened_to_what_it_needs(monkeypatch):
    def fragile(fuzzed):
        if "[propellers.propeller]" in fuzzed.text and "blades = 6" in fuzzed.text:
            raise KeyError("blades")

    planted(monkeypatch, fragile)
    fuzzed = Case("design", "in-line", corpus("design")["in-line"])
    short = shortened("planted", fuzzed, fed("planted", fuzzed), lambda: None)
    assert short.text.splitlines() == ["[propellers.propeller]", "blades = 6"]


def test_a_run_by_hand_goes_on_where_it_stopped(tmp_path):
    command = [sys.executable, str(Path(__file__).with_name("run.py")), "--stage", "read", "--seed", "3"]
    command += ["--out", str(tmp_path)]
    for count in ("20", "20"):
        ran = subprocess.run([*command, "--count", count], capture_output=True, text=True, check=False)
        assert ran.returncode == 0, ran.stdout + ran.stderr
        assert "read, seed 3: 20 of 20 files" in ran.stdout
    kept = json.loads((tmp_path / "read-3.json").read_text(encoding="utf-8"))
    assert sum(kept["outcomes"].values()) == 20
