"""Compiled code is kept between runs, read only where it can be trusted, and lost without harm."""

import ctypes
import errno
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from gearwright.dynamics import kept_code
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.codegen import assembler
from gearwright.dynamics.codegen.assembler import machine_code
from gearwright.dynamics.kept_code import VARIABLE


def doubled(values):
    return 2.0 * values.sum()


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """Hold a folder of this test's own for the cache."""
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    kept_code.folder.cache_clear()
    yield tmp_path / "cache"
    kept_code.folder.cache_clear()


def hits():
    """Return how often code for the function was found, after a call that must be right."""
    function = compiled(doubled)
    assert function(np.ones(3)) == 6.0
    return sum(function._cache_hits.values())


def test_code_is_compiled_once_and_found_again(cache):
    assert [hits(), hits()] == [0, 1]
    (kept,) = cache.glob("code-*/doubled-*")
    assert kept.parent.stat().st_mode & 0o077 == 0, "no one else reads or writes it"


def test_other_kinds_of_arguments_have_code_of_their_own(cache):
    function = compiled(doubled)
    assert function(np.ones(3)) == function(np.ones(3, dtype=np.float32)) == 6.0
    assert len(list(cache.glob("code-*/doubled-*"))) == 2


@pytest.mark.parametrize("where", [0, 20, 60, -1])
def test_damaged_code_is_compiled_again_and_replaced(cache, where):
    hits()
    (kept,) = cache.glob("code-*/doubled-*")
    damaged = bytearray(kept.read_bytes())
    damaged[where] ^= 1
    kept.write_bytes(damaged)
    assert [hits(), hits()] == [0, 1]


@pytest.mark.parametrize("length", [0, 30, 1000])
def test_code_that_is_cut_off_is_compiled_again(cache, length):
    hits()
    (kept,) = cache.glob("code-*/doubled-*")
    kept.write_bytes(kept.read_bytes()[:length])
    assert [hits(), hits()] == [0, 1]


def test_what_another_user_has_put_there_is_not_read(cache, monkeypatch):
    hits()
    kept_code.folder.cache_clear()
    monkeypatch.setattr(os, "geteuid", lambda: 12345)
    assert kept_code.folder() is None
    assert hits() == 0
    (kept,) = cache.glob("code-*/doubled-*")
    assert kept_code.read_code(kept) is None


def test_a_folder_that_others_may_write_is_not_used(cache):
    hits()
    (kept,) = cache.glob("code-*")
    kept.chmod(0o770)
    kept_code.folder.cache_clear()
    assert hits() == 0


def test_a_link_or_a_pipe_is_not_followed(cache, tmp_path):
    hits()
    (kept,) = cache.glob("code-*/doubled-*")
    kept.rename(tmp_path / "elsewhere")
    kept.symlink_to(tmp_path / "elsewhere")
    assert kept_code.read_code(kept) is None
    kept.unlink()
    os.mkfifo(kept)
    assert kept_code.read_code(kept) is None


def test_where_nothing_can_be_written_code_stays_in_memory(cache, monkeypatch):
    cache.touch()  # a file stands where the folder should be
    assert kept_code.folder() is None
    assert [hits(), hits()] == [0, 0]


def test_the_code_of_all_but_the_latest_versions_is_removed(cache):
    for number in range(kept_code.KEPT + 3):
        (cache / f"code-{number}").mkdir(parents=True)
        os.utime(cache / f"code-{number}", (number, number))
    hits()
    assert len(list(cache.glob("code-*"))) == kept_code.KEPT
    assert not (cache / "code-0").exists()


def test_the_folder_follows_the_environment(monkeypatch, tmp_path):
    monkeypatch.delenv(VARIABLE, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CACHE_HOME", "relative/is/ignored")
    assert kept_code._home() == tmp_path / ".cache" / "gearwright"
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert kept_code._home() == tmp_path / "xdg" / "gearwright"
    monkeypatch.setenv(VARIABLE, str(tmp_path / "own"))
    assert kept_code._home() == tmp_path / "own"


RUN = """
from gearwright.dynamics import simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations.kernel import speed_factor
from gearwright.dynamics.model import Profile
import numpy as np
speed_factor(Profile(np.zeros(1), np.ones(1), np.zeros(1)), 0.1)
print(sum(speed_factor._cache_hits.values()))
"""


def test_another_process_finds_the_code_and_one_without_a_home_does_without(tmp_path):
    """As in a container that is read-only and knows no user."""
    nowhere = {**os.environ, "HOME": "/dev/null/none", VARIABLE: "", "XDG_CACHE_HOME": ""}
    somewhere = {**os.environ, VARIABLE: str(tmp_path)}

    def said(environment):
        return subprocess.run(
            [sys.executable, "-c", RUN], env=environment, capture_output=True, text=True, check=True
        ).stdout

    assert [said(nowhere), said(somewhere), said(somewhere)] == ["0\n", "0\n", "1\n"]


def test_no_code_is_kept_by_other_means():
    """numba's own cache reads whatever lies beside the sources, or in a folder that a variable names."""
    for path in Path(kept_code.__file__).parent.rglob("*.py"):
        assert "cache=True" not in path.read_text(encoding="utf-8"), path


ASSEMBLY = """declare double @given(double)
define double @answer(double %x) {
  %y = call double @given(double %x)
  %z = fadd double %y, 1.0
  ret double %z
}"""
GIVEN = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(lambda x: 3.0 * x)


def answer():
    """Return what a structure's code answers that calls a function of this process."""
    engine = machine_code(ASSEMBLY, {"given": ctypes.cast(GIVEN, ctypes.c_void_p).value})
    return ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(engine.get_function_address("answer"))(2.0)


def test_the_code_of_a_structure_is_kept_and_used(cache, monkeypatch):
    assert answer() == 7.0
    assert len(list(cache.glob("code-*/structure-*"))) == 1
    monkeypatch.setattr(assembler, "keep_code", lambda *_: pytest.fail("it was compiled again"))
    assert answer() == 7.0


def test_damaged_code_of_a_structure_is_compiled_again(cache):
    answer()
    (kept,) = cache.glob("code-*/structure-*")
    whole = kept.read_bytes()
    for damaged in (b"", whole[:100], whole[:-1] + b"?", b"?" + whole[1:]):
        kept.write_bytes(damaged)
        assert answer() == 7.0
        assert kept.read_bytes() == whole, "it is compiled and kept anew"


def test_code_of_another_processor_or_version_is_not_used(cache, monkeypatch):
    """The name of a file says for which processor, sources and compilers it holds: others have files of their own."""
    import llvmlite.binding as llvm

    answer()
    here = llvm.get_host_cpu_name()
    monkeypatch.setattr(llvm, "get_host_cpu_name", lambda: "x86-64" if here != "x86-64" else here)
    before = len(list(cache.glob("code-*/structure-*")))
    assert answer() == 7.0
    assert len(list(cache.glob("code-*/structure-*"))) == before + (here != "x86-64")
    monkeypatch.setattr(kept_code, "_stamp", lambda: "another version")
    kept_code.folder.cache_clear()
    assert answer() == 7.0
    assert sorted(len(list(one.glob("structure-*"))) for one in cache.glob("code-*")) == [1, before + 1]


def test_a_full_disk_keeps_nothing_and_harms_nothing(cache, monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    assert answer() == 7.0
    assert not list(cache.glob("code-*/structure-*"))


def test_only_the_latest_structures_are_kept(cache, monkeypatch):
    monkeypatch.setattr(kept_code, "STRUCTURES", 2)
    for number in range(4):
        kept_code.keep_code(f"{number}", b"code")
        os.utime(kept_code._structure(f"{number}"), (number, number))
    assert [kept_code.kept_code(f"{number}") for number in range(4)] == [None, None, b"code", b"code"]


TOGETHER = """
from gearwright.dynamics import Model, Periodic, simulate
model = Model()
model.rotation("a", inertia=1.0, speed=100.0)
model.rotation("b", inertia=1.0)
wave = Periodic({"a": 20}, (0.2,))
model.mesh("m", {"a": 0.1, "b": 0.1}, stiffness=1e8, damping=1e3, variation=wave)
model.load("a", constant=10.0)
model.load("b", constant=10.0)
print(simulate(model.build(), 0.01, step=1e-6).force.rms.tobytes().hex())
"""


def test_two_processes_that_compile_the_same_at_once_agree(tmp_path):
    """And a third that finds what they left, to the last bit."""
    environment = {**os.environ, VARIABLE: str(tmp_path)}
    command = [sys.executable, "-c", TOGETHER]
    both = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    said = [process.communicate()[0] for process in both]
    said.append(subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout)
    assert said[0] and len(set(said)) == 1
    assert not list(tmp_path.glob("code-*/.*.part"))


READ_ONLY = """
import errno, os, sys
closed = tuple(sys.argv[1:])
def refuse(event, args):
    if event in ("open", "os.mkdir", "os.rename") and str(args[0]).startswith(closed):
        if event != "open" or (isinstance(args[2], int) and args[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT)):
            raise OSError(errno.EROFS, "Read-only file system", str(args[0]))
sys.addaudithook(refuse)
"""


def test_an_install_and_a_cache_that_are_read_only_serve_what_was_compiled_before(tmp_path):
    """The first process writes nothing beside the sources; the second, nothing at all, and compiles nothing."""
    environment = {**os.environ, VARIABLE: str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"}
    package = str(Path(kept_code.__file__).parents[1])

    def run(*closed):
        command = [sys.executable, "-c", READ_ONLY + TOGETHER + RUN, *closed]
        said = subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout
        return said.split(), {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}

    (forces, hits), kept = run(package)
    assert hits == "0"
    assert any(path.name.startswith("structure-") for path in kept)
    assert run(package, str(tmp_path)) == ([forces, "1"], kept)
