"""What an FMU answers its simulator: instances, states, and what it refuses."""

import ctypes
import io
import math
import subprocess
import zipfile
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import gearwright as gw
from fmu_host import COMPILER, COMPILES, ERROR, OK, Instance, Unpacked, compile_in
from gearwright.dynamics import Model
from gearwright.errors import DesignError, SolveError
from gearwright.exchange import fmu as compiling, fmu_of_system, to_fmu
from gearwright.exchange.fmu import MachinePort

OUTPUTS = ["first.sun.speed", "first.sun-planet-1.force", "propeller.acting_torque"]


@pytest.fixture(scope="module")
def sizing():
    return gw.size(gw.read("single-planetary"))


@pytest.fixture(scope="module")
def fmu(sizing, tmp_path_factory):
    """Return the FMU of a small design in a folder."""
    return Unpacked(to_fmu(sizing).content, tmp_path_factory.mktemp("fmu"))


@COMPILES
def test_two_instances_do_not_disturb_each_other(fmu):
    """One alone gives the bits that it gives beside another with other torques."""
    times = np.linspace(0.0, 1e-3, 11)
    alone = Instance(fmu).begin().run(times, OUTPUTS)
    one, other = Instance(fmu, name="one").begin(), Instance(fmu, name="other").begin()
    together = [one.values(OUTPUTS)]
    for time, later in pairwise(times):
        other.put({"propeller.torque": 100.0 * later})
        assert one.step(time, later - time) == other.step(time, later - time) == OK
        together.append(one.values(OUTPUTS))
    assert np.array_equal(alone, together)
    assert not np.array_equal(other.values(OUTPUTS), together[-1])
    one.free()
    other.free()


@COMPILES
@pytest.mark.parametrize("stored", [False, True])
def test_a_state_that_is_restored_goes_on_as_it_went_before(fmu, stored):
    """Bit for bit, also of one that was written as bytes; the state in between is that of another torque."""
    one, state = Instance(fmu).begin(), ctypes.c_void_p()
    one.step(0.0, 3.3e-4)
    assert one.call("GetFMUstate", ctypes.byref(state)) == OK
    if stored:
        size = ctypes.c_size_t()
        one.call("SerializedFMUstateSize", state, ctypes.byref(size))
        text = (ctypes.c_char * size.value)()
        assert one.call("SerializeFMUstate", state, text, size) == OK
        assert one.call("FreeFMUstate", ctypes.byref(state)) == OK
        assert not state.value
        assert one.call("DeSerializeFMUstate", text, size, ctypes.byref(state)) == OK
        assert one.call("DeSerializeFMUstate", text, ctypes.c_size_t(size.value - 1), ctypes.byref(state)) == ERROR
    one.step(3.3e-4, 3.3e-4)
    wanted = one.values(OUTPUTS)
    one.put({"gas-turbine.torque": 0.0})
    one.step(6.6e-4, 1e-4)
    assert one.call("SetFMUstate", state) == OK
    assert one.step(3.3e-4, 3.3e-4) == OK
    assert np.array_equal(one.values(OUTPUTS), wanted)
    one.call("FreeFMUstate", ctypes.byref(state))
    one.free()


@COMPILES
@pytest.mark.parametrize(
    ("time", "length", "said"),
    [
        (1e-3, 0.0, "its length must be positive"),
        (1e-3, -1e-4, "its length must be positive"),
        (1e-3, math.nan, "its length must be positive"),
        (1e-3, math.inf, "its length must be positive"),
        (math.nan, 1e-4, "its length must be positive"),
        (0.0, 1e-4, "restore a state to go back"),
        (2e-3, 1e-4, "the motion stands at 0.001"),
        (1e-3, 1e-22, "lost in rounding"),
    ],
)
def test_a_step_that_cannot_be_is_refused_and_changes_nothing(fmu, time, length, said):
    one = Instance(fmu).begin()
    one.step(0.0, 1e-3)
    before = one.values(OUTPUTS)
    assert one.step(time, length) == ERROR
    assert said in one.said[-1]
    assert np.array_equal(one.values(OUTPUTS), before)
    assert one.step(1e-3, 1e-4) == OK
    one.free()


@COMPILES
def test_what_comes_at_the_wrong_time_or_means_nothing_is_refused_with_its_reason(fmu):
    one = Instance(fmu)
    assert one.step(0.0, 1e-4) == ERROR
    assert "DoStep may not be called in the state: instantiated" in one.said[-1]
    one.begin()
    assert one.put({"gas-turbine.torque": math.nan}) == ERROR
    assert "gas-turbine.torque is to be" in one.said[-1]
    assert one.put({"gas-turbine.speed_is_given": True}) == ERROR
    assert one.put({"first.sun.speed": 1.0}) == ERROR
    assert "is of no real input" in one.said[-1]
    none, number = (ctypes.c_uint * 1)(12345), (ctypes.c_double * 1)()
    assert one.call("GetReal", none, ctypes.c_size_t(1), number) == ERROR
    assert "no real variable with the reference 12345" in one.said[-1]
    assert one.call("Terminate") == OK
    assert one.step(0.0, 1e-4) == ERROR
    assert one.call("Reset") == OK
    assert one.begin().step(0.0, 1e-4) == OK
    one.free()


@COMPILES
def test_a_stranger_s_token_makes_no_instance(fmu):
    code = ctypes.CDLL(str(fmu.library))
    code.fmi2Instantiate.restype = ctypes.c_void_p
    assert not code.fmi2Instantiate(b"one", 1, b"{other}", None, None, 0, 0)
    assert not code.fmi2Instantiate(b"one", 0, fmu.description.get("guid").encode(), None, None, 0, 0)


@COMPILES
def test_the_start_is_the_equilibrium_of_the_case(fmu, sizing):
    """Mesh forces stand within the swing of their stiffness of those of the power flow: a tenth."""
    one = Instance(fmu).begin()
    case = sizing.flows["rated"]
    assert one.value("propeller.acting_torque") == case.machine_torques["propeller"]
    assert one.value("propeller.speed") == pytest.approx(case.speeds["output"], rel=1e-12)
    system = gw.assemble(sizing)
    wanted = gw.statics(system).force[system.labels.lines.index("first.sun-planet-1")]
    assert one.value("first.sun-planet-1.force") == pytest.approx(wanted, rel=0.1)
    one.free()


HOST = r"""
#include "%s"
#include <assert.h>
int main(void) {
    fmi2CallbackFunctions calls = {0};
    fmi2Component a = fmi2Instantiate("a", fmi2CoSimulation, TOKEN, 0, &calls, 0, 0);
    fmi2Component b = fmi2Instantiate(0, fmi2CoSimulation, TOKEN, 0, 0, 0, 0);
    fmi2FMUstate state = 0;
    size_t size;
    assert(a && b && fmi2EnterInitializationMode(a) == fmi2OK && fmi2ExitInitializationMode(a) == fmi2OK);
    for (int i = 0; i < 20; i++) assert(fmi2DoStep(a, i * 1e-4, 1e-4, 1) == fmi2OK);
    assert(fmi2GetFMUstate(a, &state) == fmi2OK && fmi2SerializedFMUstateSize(a, state, &size) == fmi2OK);
    char *bytes = malloc(size);
    assert(fmi2SerializeFMUstate(a, state, bytes, size) == fmi2OK && fmi2FreeFMUstate(a, &state) == fmi2OK && !state);
    assert(fmi2DeSerializeFMUstate(b, bytes, size, &state) == fmi2OK && fmi2SetFMUstate(b, state) == fmi2OK);
    assert(fmi2DoStep(b, 20 * 1e-4, 1e-4, 1) == fmi2OK && fmi2DoStep(b, 0.0, 0.0, 1) == fmi2Error);
    for (unsigned block = 0; block < 9; block++)
        for (unsigned number = 0; number < 200; number++) {
            fmi2ValueReference r = block << 20 | number;
            double x = 1.0;
            int on = 1;
            fmi2GetReal(a, &r, 1, &x);
            fmi2SetReal(a, &r, 1, &x);
            fmi2GetBoolean(a, &r, 1, &on);
        }
    assert(fmi2Reset(a) == fmi2OK && fmi2FreeFMUstate(b, &state) == fmi2OK);
    fmi2ValueReference last = (fmi2ValueReference)-1;
    double x;
    assert(fmi2GetReal(a, &last, 1, &x) == fmi2Error);
    free(bytes);
    fmi2FreeInstance(a);
    fmi2FreeInstance(b);
    fmi2FreeInstance(0);
    return 0;
}
"""
"""A host in C, for what looks into memory."""


@COMPILES
@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_the_sources_compile_without_a_warning(sizing, version, tmp_path):
    folder = Unpacked(to_fmu(sizing, version=version, binary=False).content, tmp_path).folder / "sources"
    said = compile_in(folder, "-Wall", "-Wextra", "-Werror", "-fsyntax-only", f"fmi{version[0]}.c")
    assert said.returncode == 0, said.stderr


@COMPILES
def test_sanitizers_find_nothing_in_memory_and_no_undefined_step(fmu, tmp_path):
    (tmp_path / "host.c").write_text(HOST % "fmi2.c", encoding="utf-8")
    found = "-fsanitize=address,undefined", "-fno-sanitize-recover=all"
    (tmp_path / "try.c").write_text("int main(void) { return 0; }", encoding="utf-8")
    tried = compile_in(tmp_path, *found, "try.c", "-o", "try")
    if tried.returncode or subprocess.run([tmp_path / "try"], check=False).returncode:
        pytest.skip(f"{COMPILER} has no sanitizers here: {tried.stderr[:200]}")
    said = compile_in(tmp_path, *found, "-g", f"-I{fmu.folder / 'sources'}", "host.c", "-o", "host")
    assert said.returncode == 0, said.stderr
    run = subprocess.run([tmp_path / "host"], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_without_a_compiler_the_sources_are_packed_and_it_is_said(sizing, monkeypatch):
    monkeypatch.setattr(compiling.shutil, "which", lambda _: None)
    file = to_fmu(sizing)
    assert (file.platform, file.missing) == ("", "there is no C compiler (cc, gcc, clang)")
    with zipfile.ZipFile(io.BytesIO(file.content)) as archive:
        names = set(archive.namelist())
    assert {"modelDescription.xml", "sources/fmi2.c", "sources/numbers.h", "sources/README.txt"} <= names
    assert not any(name.startswith("binaries") for name in names)


def test_a_compiler_that_fails_is_told_and_the_sources_are_packed(sizing, monkeypatch, tmp_path):
    broken = Path(tmp_path, "cc")
    broken.write_text("#!/bin/sh\necho no space left >&2\nexit 1\n", encoding="utf-8")
    broken.chmod(0o755)
    monkeypatch.setattr(compiling.shutil, "which", lambda _: str(broken))
    file = to_fmu(sizing)
    assert not file.platform
    assert "no space left" in file.missing


def test_the_same_design_makes_the_same_file(sizing):
    one, other = (to_fmu(sizing, binary=False).content for _ in range(2))
    assert one == other


def test_versions_steps_starts_and_names_that_cannot_be_are_refused(sizing):
    system = gw.assemble(sizing)
    with pytest.raises(DesignError, match=r"there is no case 'cruse'"):
        to_fmu(sizing, "cruse")
    with pytest.raises(DesignError, match="outside what is stable"):
        to_fmu(sizing, step=1.0)
    with pytest.raises(DesignError, match=r"FMI 1.0 is not written"):
        fmu_of_system(system, version="1.0")
    with pytest.raises(DesignError, match="finite numbers each"):
        fmu_of_system(system, start=(np.zeros(2), np.zeros(2)))
    with pytest.raises(DesignError, match="nobody is no rotation"):
        fmu_of_system(system, [MachinePort("motor", "nobody", 1.0)])
    with pytest.raises(DesignError, match=r"motor.torque, .*: names of several variables"):
        fmu_of_system(system, [MachinePort("motor", "first.sun", 1.0)] * 2)


def test_bearings_whose_cross_terms_have_no_law_in_time_are_refused_by_name():
    model = Model()
    x, y = model.translation("x", mass=1.0), model.translation("y", mass=1.0)
    model.support("x support", x, stiffness=1e6)
    model.support("y support", y, stiffness=1e6)
    model.following({x: 1.0}, {y: 1.0}, stiffness=1e5, damping=0.0)
    with pytest.raises(SolveError, match="unequal cross terms"):
        fmu_of_system(model.build())


def test_awkward_names_are_those_of_the_variables(tmp_path):
    """In XML and, as a format, in C."""
    model = Model()
    model.rotation('a "b" <c> & %d ä\\', inertia=1.0, speed=1.0)
    model.rotation("second", inertia=1.0)
    model.shaft("s", 'a "b" <c> & %d ä\\', "second", stiffness=1.0)
    file = fmu_of_system(model.build(), [MachinePort('m "%s" ä??/', 'a "b" <c> & %d ä\\', 0.0)], step=1e-3)
    fmu = Unpacked(file.content, tmp_path)
    assert {'a "b" <c> & %d ä\\.speed', 'm "%s" ä??/.torque'} <= set(fmu.references)
    if COMPILER:
        assert file.platform, file.missing
        one = Instance(fmu).begin()
        assert one.put({'m "%s" ä??/.torque': math.nan}) == ERROR
        assert one.said[-1].startswith('m "%%s" ä??/.torque is to be')
        one.free()
