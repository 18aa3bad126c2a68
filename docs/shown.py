"""Writes the output that pages show anew: python docs/shown.py [PAGE …] [--quick] [--check].

Everything that a page shows is run as a reader would, in a folder of its own: blocks titled with a file name are
written, lines after ``$`` in blocks of kind ``console`` and ``text`` are commands, ``>>>`` are examples in Python, and
`NUMBERS` are those in sentences. What comes takes the place of what stood there; ``…`` stays for lines that are left
out, and each line that is shown becomes the one that came in its place. A line for which none came is left, and told.
"""

from __future__ import annotations

import contextlib
import doctest
import importlib.util
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

import gearwright as gw
from gearwright.cli import main as command_line
from gearwright.sizing.mass import complete_mass
from gearwright.units import RPM

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
COLUMNS = "100"
"""Width of the terminal on pages."""
LEFT_OUT = "…"
FENCE = re.compile(r"^```(?P<kind>[^\n]*)\n(?P<text>.*?)^```$", re.DOTALL | re.MULTILINE)
TITLE = re.compile(r'^\w+ title="(?P<file>[^"]+)"$')
LONG = re.compile(r"\d+\.\d{9,}(?:e[-+]\d+)?")
"""Numbers to the last bit, in which processors differ."""
FILES: Mapping[str, Sequence[Path]] = {
    "how-to/other-tools.md": [ROOT / "tests" / "rexs" / "examples" / "fva_2stage_1.4.rexs"]
}
"""Page -> files that it says a reader finds in a clone."""
NEEDS = {"speed_control.py": "fmpy", "optimise_motor.py": "openmdao", "how-to/openmdao.md": "openmdao"}
"""Script, or page with examples in Python -> the module of an extra without which it does not run."""
ELSEWHERE = frozenset({"fmuCheck"})
"""Programs that are shown and are no part of gearwright, nor of its extras: their output is not made anew."""
SLOW = frozenset(
    {"gearwright close mixed --life-h 20000", "gearwright close mixed --life-h 20000 --free rims,webs --why"}
)
"""Commands that take half a minute: they are run here, and by no test."""
ALIKE = 0.55
"""Part of a line that another one shares at least to stand in its place [-]."""
SAME, FOLLOWS = 0.2, 0.05
"""What the same words add, numbers with them, and that a line follows the one before as it does on the page [-]."""


@dataclass(frozen=True)
class Step:
    """A command of a page, and the lines that are shown after it."""

    command: str
    shown: tuple[str, ...]

    @property
    def program(self) -> str:
        """What is started."""
        return self.command.split()[0]

    @property
    def script(self) -> str:
        """The script that Python is given; nothing for other programs."""
        return self.command.split()[1] if self.program == "python" else ""

    @property
    def missing(self) -> str:
        """The module that its script needs and that is not there."""
        needed = NEEDS.get(Path(self.script).name, "")
        return needed if needed and importlib.util.find_spec(needed) is None else ""


def pages() -> list[str]:
    """Return the pages that are written by hand, by their paths below the documentation."""
    return sorted(str(path.relative_to(DOCS)) for path in DOCS.rglob("*.md"))


def steps(text: str) -> list[Step]:
    """Return every command of a block with the lines that are shown after it; none of a block that shows no prompt.

    Args:
        text: Of the block.
    """
    parts = re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]
    return [Step(command, tuple(lines)) for command, *lines in (part.splitlines() for part in parts)]


def has_steps(fence: re.Match[str]) -> bool:
    """Tell whether a fence shows commands after a prompt.

    Args:
        fence: Of a page.
    """
    return fence["kind"] in ("console", "text") and fence["text"].startswith("$ ")


def called(step: Step, folder: Path) -> list[str]:
    """Return what a command writes to both streams, by lines.

    Args:
        step: The command.
        folder: In which it runs.

    Raises:
        RuntimeError: It ends as none does that says what is wrong.
    """
    with _in(folder):
        if step.script:
            arguments = [sys.executable, str(ROOT / step.script), *shlex.split(step.command)[2:]]
            done = subprocess.run(arguments, capture_output=True, text=True, encoding="utf-8", check=False)
            code, text = done.returncode, done.stdout + (done.stderr if done.returncode else "")
        else:
            code, text = _in_process(shlex.split(step.command))
    if code not in (0, 1, 2):
        raise RuntimeError(f"{step.command}: {code}\n{text}")
    return [line.rstrip() for line in text.splitlines()]


@contextlib.contextmanager
def _in(folder: Path) -> Iterator[None]:
    """Work in a folder, before a terminal as wide as pages are."""
    known = os.environ.get("COLUMNS")
    os.environ["COLUMNS"] = COLUMNS
    try:
        with contextlib.chdir(folder):
            yield
    finally:
        os.environ.pop("COLUMNS")
        if known is not None:
            os.environ["COLUMNS"] = known


def _in_process(words: list[str]) -> tuple[Any, str]:
    """Return how a command of gearwright ends, and what it writes to both streams, that of errors last."""
    out, errors = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="") for _ in range(2))
    known, sys.argv, code = sys.argv, words, 0
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            command_line()
    except SystemExit as end:
        code = end.code or 0
    finally:
        sys.argv = known
    return code, "".join(_written(stream) for stream in (out, errors))


def _written(stream: io.TextIOWrapper) -> str:
    stream.flush()
    assert isinstance(stream.buffer, io.BytesIO)
    return stream.buffer.getvalue().decode("utf-8")


def missing(shown: Iterable[str], written: Iterable[str]) -> str | None:
    """Return the first line that is shown and does not come in its turn.

    Args:
        shown: On a page.
        written: By the command.
    """
    rest = iter(rounded(line.rstrip()) for line in written)
    lines = (line.rstrip() for line in shown if line.strip() != LEFT_OUT)
    return next((line for line in lines if not any(rounded(line) == given for given in rest)), None)


def rounded(line: str) -> str:
    """Return a line without what a processor may round otherwise.

    Args:
        line: Of an output.
    """
    return LONG.sub(lambda number: f"{float(number[0]):.9g}", line)


def renewed(shown: Sequence[str], written: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return what is to be shown, and the lines in whose place nothing came.

    Lines that are shown are laid beside those that came, in order, so that they share as much as can be: words count,
    of numbers only that there is one. Lines that follow each other on the page would rather do so in the output.

    Args:
        shown: On the page, ``…`` for lines that are left out.
        written: By the command.
    """
    if missing(shown, written) is None:
        return list(shown), []
    places = [k for k, line in enumerate(shown) if line.strip() != LEFT_OUT]
    joined = [False, *(after == before + 1 for before, after in pairwise(places))]
    beside = _beside([shown[k] for k in places], joined, written)
    found, lost = list(shown), []
    for k, at in zip(places, beside, strict=True):
        if at is None:
            lost.append(shown[k])
        else:
            found[k] = written[at]
    return found, lost


def _beside(shown: Sequence[str], joined: Sequence[bool], written: Sequence[str]) -> list[int | None]:
    """Return the place of the line that came for each that is shown, rising; none where no line is like it."""
    alike = np.array([[_alike(line, other) for other in written] for line in shown]).reshape(len(shown), len(written))
    alike[1:, 1:] += FOLLOWS * (
        (alike[1:, 1:] >= ALIKE) & (alike[:-1, :-1] >= ALIKE) & np.array(joined[1:], dtype=bool)[:, None]
    )
    best = np.zeros((len(shown) + 1, len(written) + 1))
    for i, row in enumerate(alike.tolist()):
        for j, share in enumerate(row):
            taken = best[i, j] + share if share >= ALIKE else 0.0
            best[i + 1, j + 1] = max(taken, best[i, j + 1], best[i + 1, j])
    places, end = list[int | None](), len(written)
    for i in reversed(range(len(shown))):
        while end > 0 and best[i + 1, end] == best[i + 1, end - 1]:
            end -= 1
        is_taken = best[i + 1, end] > best[i, end]
        end -= int(is_taken)
        places.append(end if is_taken else None)
    return places[::-1]


def _alike(one: str, other: str) -> float:
    """Return which part two lines share, 1 of equal ones; of numbers only that they are there, but a little more if
    they are the same [-]."""
    if one == other:
        return 1.0 + SAME
    first, second = _words(one), _words(other)
    if not first or not second:
        return float(first == second)
    matcher = SequenceMatcher(None, first, second, autojunk=False)
    if matcher.quick_ratio() < ALIKE:
        return 0.0
    same = len(set(one.split()) & set(other.split())) / max(len(set(one.split())), 1)
    return matcher.ratio() + SAME * same


def _words(line: str) -> list[str]:
    return [re.sub(r"\d+(?:[.,]\d+)*", "0", word) for word in re.findall(r"[^\s]+", re.sub(r"[−-](?=\d)", "", line))]


class _Anew(doctest.DocTestRunner):
    """Runs the examples of a page, and keeps what comes where something else stands."""

    def __init__(self) -> None:
        super().__init__(verbose=False)
        self.came: dict[int, tuple[doctest.Example, str]] = {}

    def report_failure(self, out: Any, test: doctest.DocTest, example: doctest.Example, got: str) -> None:
        """Keep what came."""
        self.came[example.lineno] = example, got

    def report_unexpected_exception(
        self, out: Any, test: doctest.DocTest, example: doctest.Example, exc_info: Any
    ) -> None:
        """Nothing is written over an example that fails."""
        raise RuntimeError(f"{test.name}: {example.source}") from exc_info[1]


def with_examples(page: str, text: str, folder: Path) -> str:
    """Return a page with what its examples in Python give.

    Args:
        page: Its path below the documentation.
        text: What stands there.
        folder: In which they run.
    """
    if ">>> " not in text or (page in NEEDS and importlib.util.find_spec(NEEDS[page]) is None):
        return text
    test = doctest.DocTestParser().get_doctest(text, {"__name__": "__main__"}, page, page, 0)
    runner = _Anew()
    with _in(folder):
        runner.run(test, out=lambda _: None)
    lines = text.splitlines(keepends=True)
    for lineno, (example, got) in sorted(runner.came.items(), reverse=True):
        start = lineno + example.source.count("\n")
        indent = " " * example.indent
        came = [f"{indent}{line or '<BLANKLINE>'}\n" for line in got.splitlines()]
        lines[start : start + example.want.count("\n")] = came
    return "".join(lines)


@cache
def _total_mass(speed: float) -> float:
    """Return what In-Line H2 and its motor weigh, which asks for a speed [kg]."""
    design = gw.edited(gw.read("in-line-h2"), {"motors.electric.speed_rpm": speed})
    return float(gw.named_results(gw.size(design))["total_mass"].value)


@cache
def _lightest_speed() -> float:
    """Return the speed of the motor at which In-Line H2 and its motor weigh least, on a grid of 25 rpm [rpm]."""
    speeds = np.arange(5000.0, 6200.0, 25.0).tolist()
    sizings = gw.size_many(gw.read("in-line-h2"), {"motors.electric.speed_rpm": speeds}, results=["total_mass"])
    return float(speeds[int(np.nanargmin(sizings.columns["total_mass"]))])


def _teeth_give() -> float:
    """Return the speed that the teeth give the motor there [rpm]."""
    design = gw.edited(gw.read("in-line-h2"), {"motors.electric.speed_rpm": _lightest_speed()})
    return abs(float(gw.named_results(gw.size(design))["cases.rated.intermediate.speed"].value)) / RPM


def _propeller_speed() -> float:
    """Return the speed that the teeth of the hybrid turboprop give its propeller [rpm]."""
    sizing = gw.size(gw.read("hybrid-turboprop"))
    return abs(sizing.reference.speeds[sizing.train.machines["propeller"]]) / RPM


@cache
def _complete(name: str, bearing: str = "") -> float:
    """Return what a shipped design weighs in full, with another kind of bearing in the first planets if named [kg]."""
    design = gw.read(name)
    design = gw.edited(design, {"planetaries.first.planet_bearing.kind": bearing}) if bearing else design
    return complete_mass(gw.size(design)).total


@cache
def _masses_by_rule() -> dict[str, list[float]]:
    """Return what each hybrid weighs under the rules of the shipped study, in its order [kg]."""
    masses: dict[str, list[float]] = {}
    for row in gw.study(gw.read_study("hybrid-rules"), workers=0).rows:
        masses.setdefault(row.design, []).append(float(row.results["mass"].value))
    return masses


def _by_rule(name: str) -> Callable[[], list[float]]:
    return lambda: _masses_by_rule()[name]


def _heavier_alone() -> list[float]:
    """Return how much heavier gearboxes are for a turbine that takes off alone, and how much lighter two are [%]."""
    heavier = {name: 100.0 * (alone / both - 1.0) for name, (both, alone, *_) in _masses_by_rule().items()}
    more = [heavier[name] for name in ("off-set-h1", "in-line-h2", "mixed-h1", "mixed-h2")]
    return [*more, -heavier["in-line-h1"], -heavier["off-set-h3"]]


_MIXED = r"^\$ gearwright close mixed --life-h 20000{}\n(?:(?!\$ ).*\n)*? complete mass +([\d.]+) kg"
_SOLID, _FREE = _MIXED.format(""), _MIXED.format(" --free rims,webs --why")

NUMBERS: Mapping[str, Sequence[tuple[str, str | Callable[[], float | Sequence[float]]]]] = {
    "index.md": [("teeth give {:.0f})", _propeller_speed)],
    "tutorial.md": [
        ("Whole teeth give {} instead of 1700 rpm", r"^ rated +propeller +1700 +(\d+) "),
        ("The {:.3g} kg are gears, shafts and carriers", r"^([\d.]+) kg \(gears [\d.]+ kg, shafts"),
        ("they are the {} kg of the sum", r"^Sum .*gears, shafts and carriers ([\d.]+) kg;"),
        ("The sum of {} kg has", r"^Sum ([\d.]+) kg"),
    ],
    "how-to/close.md": [
        ("ends on {} kg with everything", _FREE),
        ("everything, {} kg without `--free`", _SOLID),
        ("rims and webs among them (Mixed {} → ", _SOLID),
        (" → {} kg) | helix", _FREE),
        ("teeth are free ({:.1f} kg;", lambda: _complete("off-set-h1-free")),
    ],
    "how-to/hybrid-rules.md": [
        *((f"| `{name}` | {{:#.4g}} | {{:#.4g}} | {{:#.4g}} | {{:#.4g}} |", _by_rule(name))
          for name in ("off-set-h1", "off-set-h2", "off-set-h3", "in-line-h1", "in-line-h2", "mixed-h1", "mixed-h2")),
        ("{:.0f} % heavier in `off-set-h1`, {:.0f} % in `in-line-h2`, {:.0f} and {:.0f} % in `mixed-h1` and `mixed-h2`;"
         " it is {:.0f} % lighter in\n`in-line-h1` and {:.0f} % in `off-set-h3`", _heavier_alone),
    ],
    "how-to/openmdao.md": [
        ("has its least value on a grid of 25 rpm at {:.0f} rpm", _lightest_speed),
        ("rpm, {:.2f} kg, where the teeth give", lambda: _total_mass(_lightest_speed())),
        ("where the teeth give the motor {:.0f} rpm", _teeth_give),
        ("it ran at the {:.0f} rpm that it asks for", _lightest_speed),
        ("asks for, {:.1f} % faster", lambda: 100.0 * (_lightest_speed() / _teeth_give() - 1.0)),
        ("No optimiser beats {:.2f} kg honestly", lambda: _total_mass(_lightest_speed())),
    ],
    "how-to/other-tools.md": [
        ("\n{:.1f} kg for ", r"^ train as sized +([\d.]+) kg"),
        (" kg for {:.1f} kg, and `back.toml`", r"^as sized ([\d.]+) kg"),
    ],
    "how-to/question-to-page.md": [
        ("that is the {} %.", r"^(\d+) %\. It wins"),
        ("{} % more mass is a lot", r"worse in train as sized (\d+) % more"),
    ],
    "how-to/strategies.md": [("of {} kg at the same charge", r"^Fuel ([\d.]+) kg")],
    "how-to/workbench.md": [
        ("it passes, at {:.1f} kg. Click", lambda: _complete("in-line-h2-star")),
        ("again: it passes at {:.1f} kg, and", lambda: _complete("in-line-h2-star", "plain")),
    ],
}  # fmt: skip
"""Page -> words around numbers, each of which stands as a field of a format, and what finds them in what the page
shows, commands and their output, or what computes them."""
FIELD, NUMBER = re.compile(r"\{[^}]*\}"), r"[-−]?[\d.]*\d"


def with_numbers(page: str, text: str, came: Iterable[str]) -> str:
    """Return a page with the numbers of its sentences.

    Args:
        page: Its path below the documentation.
        text: What stands there.
        came: Commands after a prompt, and the lines that they write.

    Raises:
        ValueError: A sentence, or what is to stand in it, is not there.
    """
    lines = "\n".join([*came, *(fence["text"] for fence in FENCE.finditer(text))])
    for words, known in NUMBERS.get(page, ()):
        if isinstance(known, str):
            found = re.search(known, lines, re.MULTILINE)
            if found is None:
                raise ValueError(f"{page}: nothing that it shows has {known!r}")
            values: Sequence[Any] = found.groups()
        else:
            values = np.atleast_1d(known()).tolist()
        fields = FIELD.findall(words)
        numbers = (
            field.format(value if field == "{}" else float(value)) for field, value in zip(fields, values, strict=True)
        )
        sentence = FIELD.sub(lambda _, numbers=numbers: next(numbers), words)
        text, count = re.subn(
            NUMBER.join(map(re.escape, FIELD.split(words))), lambda _, sentence=sentence: sentence, text
        )
        if count != 1:
            raise ValueError(f"{page}: the words {words!r} are there {count} times; write them as they are, once")
    return text


def made(page: str, *, quick: bool = False) -> tuple[str, list[str]]:
    """Return a page with everything that it shows as it comes, and the lines for which nothing came.

    Args:
        page: Its path below the documentation.
        quick: Leave commands that take half a minute as they are, as those are that need an extra that is not there.
    """
    text, lost, came = (DOCS / page).read_text(encoding="utf-8"), list[str](), list[str]()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for example in FILES.get(page, []):
            shutil.copy(example, folder)

        def anew(fence: re.Match[str]) -> str:
            title = TITLE.match(fence["kind"])
            if title:
                (folder / title["file"]).write_text(fence["text"], encoding="utf-8")
            if not has_steps(fence):
                return fence[0]
            body = ""
            for step in steps(fence["text"]):
                shown = list(step.shown)
                if _is_run(step, quick=quick):
                    written = called(step, folder)
                    shown, left = renewed(shown, written)
                    came.extend([f"$ {step.command}", *written])
                    lost.extend(f"{step.command}: {line}" for line in left)
                body += "".join(f"{line}\n" for line in (f"$ {step.command}", *shown))
            return f"```{fence['kind']}\n{body}```"

        text = FENCE.sub(anew, text)
        text = with_examples(page, text, folder)
    return with_numbers(page, text, came), lost


def _is_run(step: Step, *, quick: bool) -> bool:
    """Tell whether a command is run here."""
    return step.program not in ELSEWHERE and not step.missing and not (quick and step.command in SLOW)


def main() -> None:
    """Write pages anew, all of them or those that are named.

    ``--quick`` leaves commands that take half a minute; ``--check`` only says which pages would change.
    """
    named = [word for word in sys.argv[1:] if not word.startswith("-")]
    wrong = False
    for page in named or pages():
        before = (DOCS / page).read_text(encoding="utf-8")
        after, lost = made(page, quick="--quick" in sys.argv)
        if after != before:
            print(f"{page}: anew")
            if "--check" not in sys.argv:
                (DOCS / page).write_text(after, encoding="utf-8")
        for line in lost:
            print(f"{page}: nothing came in the place of a line, write it by hand: {line}")
        wrong |= bool(lost)
    raise SystemExit(int(wrong))


if __name__ == "__main__":
    main()
