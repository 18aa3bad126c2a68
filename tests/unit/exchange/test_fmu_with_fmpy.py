"""A simulator of others takes FMUs: FMPy holds them against the standard, runs them and compiles their sources."""

import ctypes
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import gearwright as gw
from driven_train import driven_train
from fmu_host import COMPILES, Instance, Unpacked, compile_in
from gearwright.exchange import fmu_of_system, to_fmu

pytestmark = [pytest.mark.extra("fmpy"), COMPILES]
ROOT = Path(__file__).parents[3]
FORCE = "first.sun-planet-1.force"
EXCHANGE = {
    f"fmi2{name}"
    for name in (
        "EnterEventMode", "NewDiscreteStates", "EnterContinuousTimeMode", "CompletedIntegratorStep", "SetTime",
        "SetContinuousStates", "GetDerivatives", "GetEventIndicators", "GetContinuousStates",
        "GetNominalsOfContinuousStates",
    )
}  # fmt: skip
"""Functions of model exchange, which FMI 2.0 asks of no FMU for co-simulation."""


@pytest.fixture(scope="module")
def paths(tmp_path_factory):
    """Return version -> FMU of a hybrid, on the disk."""
    sizing, folder = gw.size(gw.read("in-line-h2")), tmp_path_factory.mktemp("fmpy")
    made = {}
    for version in ("2.0", "3.0"):
        made[version] = folder / f"hybrid-{version[0]}.fmu"
        made[version].write_bytes(to_fmu(sizing, "cruise", version=version).content)
    return made


@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_descriptions_and_structures_are_valid(paths, version):
    from fmpy.validation import validate_fmu

    assert validate_fmu(str(paths[version])) == []


@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_a_driven_train_with_any_names_is_valid(version, tmp_path):
    from fmpy.validation import validate_fmu

    (tmp_path / "driven.fmu").write_bytes(fmu_of_system(driven_train(), version=version).content)
    assert validate_fmu(str(tmp_path / "driven.fmu")) == []


def test_both_versions_run_and_give_the_same_numbers_as_a_plain_host(paths, tmp_path):
    """Versions bit for bit, the host to 1e-9: it adds times up in another way."""
    import fmpy

    outputs = [FORCE, "electric.acting_torque", "propeller.speed"]
    start = {"electric.speed_is_given": True, "gas-turbine.torque": 900.0}
    runs = [
        fmpy.simulate_fmu(str(path), stop_time=2e-3, output_interval=2.0**-14, output=outputs, start_values=start)
        for path in paths.values()
    ]
    assert np.array_equal(runs[0], runs[1])
    one = Instance(Unpacked(paths["2.0"].read_bytes(), tmp_path)).begin(**start)
    plain = one.run(2.0**-14 * np.arange(30), outputs)
    one.free()
    np.testing.assert_allclose(np.transpose([runs[0][name][:30] for name in outputs]), plain, rtol=1e-9)


@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_a_binary_compiled_from_the_sources_inside_gives_the_same_numbers(paths, version, tmp_path):
    """As an importer on another platform does: without the packed binary; 1e-9, as its flags may contract products."""
    import fmpy
    from fmpy.build import build_platform_binary

    packed = fmpy.simulate_fmu(str(paths[version]), stop_time=1e-3, output_interval=1e-4, output=[FORCE])
    fmpy.extract(str(paths[version]), str(tmp_path))
    for binary in tmp_path.glob("binaries/*/*"):
        binary.unlink()
    (tmp_path / "build").mkdir()
    build_platform_binary(tmp_path, tmp_path / "build")
    built = fmpy.simulate_fmu(str(tmp_path), stop_time=1e-3, output_interval=1e-4, output=[FORCE])
    np.testing.assert_allclose(built[FORCE], packed[FORCE], rtol=1e-9)


@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_the_interface_is_that_of_the_headers_of_the_standard(paths, version, tmp_path):
    """A compiler refuses a definition whose declaration differs; every function that the headers declare is there."""
    import fmpy

    headers = Path(fmpy.__file__).parent / "c-code"
    fmpy.extract(str(paths[version]), str(tmp_path))
    major = version[0]
    said = compile_in(
        tmp_path / "sources", "-Wall", "-Wextra", "-Werror", "-DSTANDARD_HEADERS", f"-I{headers}", "-fPIC", "-shared",
        f"fmi{major}.c", "-o", "checked.so",
    )  # fmt: skip
    assert said.returncode == 0, said.stderr
    text = (headers / f"fmi{major}Functions.h").read_text(encoding="utf-8")
    declared = re.findall(rf"^#define (fmi{major}\w+) +fmi{major}FullName\(fmi", text, flags=re.MULTILINE)
    code = ctypes.CDLL(str(tmp_path / "sources" / "checked.so"))
    assert [name for name in declared if name not in EXCHANGE and not hasattr(code, name)] == []


def test_a_controller_in_python_holds_the_propeller_in_a_loop_with_the_gearbox(paths):
    """The example of the documentation: within 0.5 rad/s, and the motor gives what the turbine lost."""
    script = ROOT / "docs" / "examples" / "speed_control.py"
    words = [sys.executable, str(script), str(paths["2.0"])]
    said = subprocess.run(words, capture_output=True, text=True, check=True, env={"PYTHONPATH": ":".join(sys.path)})
    wanted, lowest, end = (float(word.split()[-1]) for word in said.stdout.split(" rad/s")[0].split(","))
    assert wanted - 0.5 < lowest < end < wanted
