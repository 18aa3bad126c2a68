"""A study that tests of faults run in processes of their own, to be killed, and what it must come to."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from gearwright.shipped import shipped_design
from gearwright.spec import Study, parse_study, read
from gearwright.study import Table, run
from gearwright.study.journal import rows_of, status
from gearwright.study.running import resume
from sessions import members, until

NAME = "in-line-h2"
DESIGNS = {NAME: read(shipped_design(NAME))}
TEXT = f"""
schema = 1
name = "faults"
designs = ["{NAME}"]
results = ["mass", "gears.first.sun.module"]
[axes]
"motors.electric.speed_rpm" = {{from = 2000, to = 5500}}
"planetaries.second.planets" = {{values = [4, 5, 9]}}
[sampling]
method = "sobol"
count = COUNT
seed = 7
"""


def study_of(count: int) -> Study:
    return parse_study(TEXT.replace("COUNT", str(count)))


def undisturbed(count: int) -> Table:
    return run(study_of(count), DESIGNS)


def started(folder: Path, count: int, *options: str, limit: int | None = None) -> subprocess.Popen[str]:
    """Start the study's command in a session of its own; a limit bounds every file that it writes [bytes]."""
    (folder / "study.toml").write_text(TEXT.replace("COUNT", str(count)), encoding="utf-8")
    return command(folder, "study", "study.toml", "--journal", "j", *options, limit=limit)


def command(folder: Path, *arguments: str, limit: int | None = None) -> subprocess.Popen[str]:
    """Start a command of gearwright in a session of its own."""

    def bounded() -> None:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # what runs tests in the background may have it ignored
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    # Modules compiled under the limit would be cut off, and kept for the next who imports them.
    environment = os.environ if limit is None else os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.Popen(
        [sys.executable, "-c", "from gearwright.cli import main; main()", *arguments],
        cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=bounded,
        start_new_session=True, env=environment,
    )  # fmt: skip


@contextmanager
def ended(process: subprocess.Popen[str]) -> Iterator[None]:
    """Kill a process at the end, whatever came of it, and see that it leaves no worker behind."""
    try:
        yield
    finally:
        process.kill()
        process.communicate()
        until(lambda: not members(process.pid), "its workers end")


def command_line(process: int) -> str:
    return Path(f"/proc/{process}/cmdline").read_text(encoding="utf-8")


def blocks(process: int, number: signal.Signals) -> bool:
    """Tell whether a process does not hear a signal."""
    lines = Path(f"/proc/{process}/status").read_text(encoding="utf-8").splitlines()
    mask = next(int(line.split()[1], 16) for line in lines if line.startswith("SigBlk"))
    return bool(mask >> (number - 1) & 1)


def done(journal: Path) -> int:
    """Return how many cases a journal has, none where its study is not written yet."""
    try:
        return status(journal).done
    except Exception:  # it is being written
        return 0


def assert_whole(journal: Path, expected: Table) -> None:
    """Assert that a study comes to what it comes to undisturbed: every case once, all kept rows as they were."""
    before = rows_of(journal)
    table = resume(journal, designs=DESIGNS)
    assert table == expected
    assert rows_of(journal) == list(expected.rows)
    assert [row for row in table.rows if row in before] == before, "what was kept stays as it was"


def kill(process: int) -> None:
    with suppress(ProcessLookupError):  # it may have ended since it was listed
        os.kill(process, signal.SIGKILL)
