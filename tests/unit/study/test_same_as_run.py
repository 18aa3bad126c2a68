"""A case of a study is what `gearwright run` makes of the same design file (it reads and sizes), to the last bit."""

from __future__ import annotations

from pathlib import Path

from fault_studies import DESIGNS, NAME

from gearwright.shipped import shipped_design
from gearwright.sizing import named_results, size
from gearwright.spec import parse_study, read
from gearwright.study.running import run_study

STUDY = f"""
schema = 1
name = "same"
designs = ["{NAME}"]
results = ["mass", "total_mass", "worst_margin", "gears.first.sun.module", "shafts.output.diameter"]
[axes]
"motors.electric.speed_rpm" = {{from = 3500, to = 5500}}
"carriers.fill" = {{from = 0.4, to = 0.8}}
[sampling]
method = "sobol"
count = 16
"""


def test_every_case_is_what_run_makes_of_the_same_file(tmp_path: Path) -> None:
    """Workers have computed other cases before, and remember what they need: that must not show."""
    table = run_study(parse_study(STUDY), DESIGNS, workers=2, journal=tmp_path / "j")
    text = shipped_design(NAME).read_text(encoding="utf-8")
    for row in table.rows:
        speed, fill = row.inputs.values()
        (tmp_path / "case.toml").write_text(
            text.replace("speed_rpm = 4500", f"speed_rpm = {speed!r}") + f"\n[carriers]\nfill = {fill!r}\n",
            encoding="utf-8",
        )
        found = named_results(size(read(tmp_path / "case.toml")))
        assert row.results == {name: found[name] for name in table.results}
