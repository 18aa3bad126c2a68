"""Files are written whole or not at all, whatever the disk does, and the message tells what happened."""

import os
import resource
import stat
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest

from gearwright.errors import DesignError, SolveError
from gearwright.files import make_folder, write_bytes, write_text

LIMIT = 1000
"""Size beyond which no file can grow in these tests [bytes]."""


@contextmanager
def full_disk():
    """Let no file grow past the limit: writing fails there as it does where no block is left.

    Modules that are imported meanwhile leave no compiled files, which would be cut off.
    """
    (soft, hard), compiles = resource.getrlimit(resource.RLIMIT_FSIZE), sys.dont_write_bytecode
    resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, hard))
    sys.dont_write_bytecode = True
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        sys.dont_write_bytecode = compiles


def test_a_file_is_written_and_replaced(tmp_path):
    write_text(tmp_path / "a", "één\n")
    write_bytes(tmp_path / "a", b"two\n")
    assert (tmp_path / "a").read_bytes() == b"two\n"
    assert list(tmp_path.iterdir()) == [tmp_path / "a"]


def test_a_full_disk_leaves_what_was_there_and_nothing_else(tmp_path):
    (tmp_path / "a").write_text("as it was", encoding="utf-8")
    with full_disk(), pytest.raises(SolveError) as caught:
        write_text(tmp_path / "a", "x" * 2 * LIMIT)
    assert str(tmp_path / "a") in str(caught.value) and "it needs 0.002 MB" in str(caught.value)
    with full_disk(), pytest.raises(SolveError):
        write_text(tmp_path / "b", "x" * 2 * LIMIT)
    assert list(tmp_path.iterdir()) == [tmp_path / "a"]
    assert (tmp_path / "a").read_text(encoding="utf-8") == "as it was"


def test_an_interruption_leaves_what_was_there(tmp_path, monkeypatch):
    def interrupted(descriptor):
        raise KeyboardInterrupt

    (tmp_path / "a").write_text("as it was", encoding="utf-8")
    monkeypatch.setattr(os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_text(tmp_path / "a", "new")
    assert list(tmp_path.iterdir()) == [tmp_path / "a"]
    assert (tmp_path / "a").read_text(encoding="utf-8") == "as it was"


def test_a_place_where_no_file_can_be_is_refused_with_its_path(tmp_path):
    (tmp_path / "file").touch()
    for path in (tmp_path / "none" / "a", tmp_path / "file" / "a", tmp_path):
        with pytest.raises(DesignError, match="cannot be written") as caught:
            write_text(path, "text")
        assert str(path) in str(caught.value)
    with pytest.raises(DesignError, match="cannot be written"):
        make_folder(tmp_path / "file" / "folder")


def test_permissions_and_links_stay(tmp_path):
    (tmp_path / "file").touch(mode=0o640)
    (tmp_path / "link").symlink_to("file")
    write_text(tmp_path / "link", "text")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "file").read_text(encoding="utf-8") == "text"
    assert stat.S_IMODE((tmp_path / "file").stat().st_mode) == 0o640


def test_a_new_file_has_the_permissions_of_the_mask(tmp_path):
    before = os.umask(0o027)
    try:
        write_text(tmp_path / "file", "text")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "file").stat().st_mode) == 0o640


def test_a_device_is_written_straight_and_stays():
    with pytest.raises(SolveError, match="/dev/full cannot be written: No space left on device"):
        write_text(Path("/dev/full"), "text")
    assert stat.S_ISCHR(Path("/dev/full").stat().st_mode)


EVERY_WRITER = """
import os, resource, sys
sys.dont_write_bytecode = True  # what is cut off would be kept, and loaded by the next who imports it
from gearwright.cli import main
commands = [
    "simulate single-planetary --duration 0.001 --output run.nc",
    "run single-planetary --duration 0.001 --out results",
    "report single-planetary --out report.html",
    "draw single-planetary --out sheets --format svg",
    "fly off-set-h2 --csv flight.csv",
    "mass --power-kw 500 --engine-rpm 30000 --propeller-rpm 2000 --report mass.html",
    "engines --csv engines.csv",
    "study power-density --csv study.csv",
    "study power-density --export study.nc",
    "compare single-planetary --figure compare.svg",
]
resource.setrlimit(resource.RLIMIT_FSIZE, (200, 200))
for command in commands:
    sys.argv = ["gearwright", *command.split()]
    try:
        main()
        code = 0
    except SystemExit as stop:
        code = stop.code
    print("ENDED", code, command, file=sys.stderr)
"""


def test_every_command_that_writes_says_what_a_full_disk_did_and_leaves_no_file(tmp_path):
    """In a process of its own, whose end is looked at too: HDF5 used to take the interpreter with it."""
    found = subprocess.run(
        [sys.executable, "-c", EVERY_WRITER], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert found.returncode == 0, found.stderr
    ended = [line for line in found.stderr.splitlines() if line.startswith("ENDED")]
    assert len(ended) == 10 and all(line.startswith("ENDED 1 ") for line in ended), found.stderr
    assert found.stderr.count("cannot be written: File too large; it needs") == len(ended), found.stderr
    assert "Traceback" not in found.stderr
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []
