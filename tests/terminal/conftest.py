"""The forking parent, and how a test asks it for a command."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

from commands import JOURNAL, furnish  # noqa: E402


@dataclass(frozen=True)
class Ended:
    """What came of a command."""

    code: int
    out: str
    """Of a terminal: both streams."""
    err: str
    folder: Path

    @property
    def all(self) -> str:
        """Everything that was printed."""
        return self.out + self.err


@dataclass(frozen=True)
class Caller:
    """Runs commands in a folder of their own."""

    parent: subprocess.Popen[str]
    folder: Path

    def __call__(
        self, words: list[str], *, columns: int = 0, output: str = "", interrupt: int = 0, **environment: str
    ) -> Ended:
        """Run a command: on a terminal of so many columns, or with its output into a pipe or a named file."""
        asked = {"words": words, "folder": str(self.folder), "columns": columns, "output": output,
                 "interrupt": interrupt, "environment": environment}  # fmt: skip
        self.parent.stdin.write(json.dumps(asked) + "\n")
        self.parent.stdin.flush()
        return Ended(**json.loads(self.parent.stdout.readline()), folder=self.folder)


@pytest.fixture(scope="session")
def answers(tmp_path_factory) -> Path:
    """A folder for what was computed, which workers that run side by side share."""
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "answers"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture(scope="session")
def parent(answers) -> Iterator[subprocess.Popen[str]]:
    """One process that forks for all commands."""
    command = [sys.executable, str(HERE / "forks.py"), str(answers)]
    started = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    yield started
    started.stdin.close()
    started.wait()
    started.stdout.close()


@pytest.fixture(scope="session")
def furnished(parent, tmp_path_factory) -> Path:
    """A folder with everything that the commands read."""
    folder = tmp_path_factory.mktemp("furnished")
    furnish(folder)
    assert Caller(parent, folder)(JOURNAL).code == 0
    return folder


@pytest.fixture
def call(parent, furnished, tmp_path) -> Callable[..., Ended]:
    """Run a command in a fresh folder."""
    shutil.copytree(furnished, tmp_path, dirs_exist_ok=True)
    return Caller(parent, tmp_path)
