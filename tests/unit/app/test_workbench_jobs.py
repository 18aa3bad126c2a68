"""What takes long in the workbench: the numbers of the public verbs, events, ends, and studies in the CLI's journal."""

import asyncio
import os
import sqlite3
from pathlib import Path

import numpy as np
import pytest
from asking import events_of

import gearwright as gw
from gearwright.dynamics.assembly import assemble

pytestmark = pytest.mark.extra("starlette", "httpx", "tomlkit", "uvicorn")
STUDY = """schema = 1
name = "Speeds"
designs = ["this"]
results = ["mass"]
[axes]
"motors.electric.speed_rpm" = {from = 4000, to = 5000}
[objectives]
mass = "minimum"
[sampling]
method = "sobol"
count = 64
"""


def text_of(name):
    return gw.shipped_design(name).read_text(encoding="utf-8")


def test_a_run_has_the_forces_and_the_spectrum_of_the_verb(asked):
    head, columns = asked.found("simulate", text=text_of("single-planetary"), duration=0.01)
    sizing = gw.size(gw.read("single-planetary"))
    outputs = gw.Outputs(start=0.0025, windows=((0.005, 0.01),))
    trace = gw.simulate(assemble(sizing, head["case"]), 0.01, outputs=outputs)
    for line in head["lines"]:
        name = line["name"]
        assert np.array_equal(columns[f"run {name}"], trace.samples.force(name).astype("f4"))
        assert np.array_equal(columns[f"end {name}"], trace.windows[-1].force(name).astype("f4"))
    name = head["lines"][-1]["name"]
    peak = columns["spectrum frequency"][1 + np.argmax(columns[f"spectrum {name}"][1:])]
    orders = [k * value for value in head["meshes"].values() for k in (1, 2, 3)]
    assert min(abs(peak - order) for order in orders) <= columns["spectrum frequency"][1]  # one line of the spectrum


def test_modes_and_critical_speeds_are_those_of_the_verbs(asked):
    sizing = gw.size(gw.read("in-line-h2"))
    told = asked.found("modes", text=text_of("in-line-h2"), case="cruise")[0]
    assert told["frequencies"] == [round(float(value), 6) for value in gw.modes(assemble(sizing, "cruise")).frequency]
    assert max(abs(turns[3]) for turns in told["shapes"].values()) == pytest.approx(1.0)
    head, columns = asked.found("campbell", text=text_of("in-line-h2"), case="cruise")
    (known,) = gw.critical_speeds(sizing, cases=["cruise"])
    assert len(head["critical_speeds"]) == len(known.critical)
    assert np.array_equal(columns["frequency"], known.campbell.frequency.T.ravel().astype("f4"))


def test_a_flight_has_the_fuel_of_the_verb_and_what_is_wrong_stands_at_its_line(asked):
    mission = gw.shipped_mission("thesis").read_text(encoding="utf-8")
    head, columns = asked.found("fly", text=text_of("in-line-h2"), mission=mission)
    flight = gw.fly(gw.size(gw.read("in-line-h2")), gw.read_mission(gw.shipped_mission("thesis")))
    assert head["fuel_kg"] == flight.fuel and head["sankey"].startswith("<svg")
    assert np.array_equal(columns["altitude"], (flight.history.altitude / 0.3048).astype("f4"))
    events, wrong = asked.job("mission", text="", mission=mission.replace("[battery]", "[batterie]"))
    assert events[-1]["status"] == wrong.status_code == 422
    line = mission.splitlines().index(next(row for row in mission.splitlines() if row.startswith("[battery]"))) + 1
    assert wrong.json()["problems"][0]["line"] == line


def test_what_moves_a_number_is_the_difference_of_two_sizings(asked):
    text = text_of("in-line-h2")
    told = asked.found("moved", text=text)[0]
    places = {one["path"]: k for k, one in enumerate(told["handles"])}
    before = gw.size(gw.parse(text))
    for path, changed in (
        ("motors.electric.speed_rpm", text.replace("speed_rpm = 4500", "speed_rpm = 4545.0")),
        ("planetaries.second.planets", text.replace("planets = 5", "planets = 6")),
    ):
        after = gw.size(gw.parse(changed))
        share = told["changes"]["mass_kg"][places[path]]
        assert share == pytest.approx(after.mass / before.mass - 1.0, rel=1e-3)  # told with four digits
        face = told["changes"]["gears.second.sun.face_width_mm"][places[path]]
        widths = [one.face_width for sizing in (before, after) for one in sizing.gears if one.name == "second.sun"]
        assert face == pytest.approx(widths[1] / widths[0] - 1.0, rel=1e-3, abs=1e-9)
    refused = told["handles"][places["cases.cruise.gas-turbine.power_kw"]]
    assert "1046 kW is its limit" in refused["why"]


def test_a_study_that_is_paused_is_finished_by_the_command_line_with_the_same_rows(asked):
    text = text_of("in-line-h2")
    whole = asked.found("study", text=text, study=STUDY, journal="whole.journal")[0]

    async def paused():
        async with asked.client() as client:
            body = {"text": text, "study": STUDY, "journal": "paused.journal"}
            place = f"/api/jobs/{(await client.post('/api/jobs/study', json=body)).json()['job']}"
            await asyncio.sleep(0.15)
            await client.post(f"{place}/stop", json={})
            return events_of((await client.get(f"{place}/events")).text), (
                await client.get(f"{place}/result")
            ).status_code

    events, status = asked.runner.run(paused())
    assert "stopped" in events[-1] and status == 404
    journal = asked.folder / "paused.journal"
    from gearwright.study.journal import recorded
    from gearwright.study.running import resume

    try:
        recorded(journal)
    except gw.DesignError:  # stopped before the journal was begun, perhaps between its file and what stands in it
        asked.found("study", text=text, study=STUDY, journal="paused.journal")
    table = resume(journal)
    assert [row.shown("mass") for row in table.rows] == [row["results"]["mass_kg"] for row in whole["rows"]]
    known = asked.found("rows", text=text, journal="paused.journal")[0]
    assert known["done"] == known["total"] == 64 and known["rows"] == whole["rows"]
    best = min(whole["rows"], key=lambda row: row["results"]["mass_kg"])
    assert whole["front"] == [whole["rows"].index(best)]
    opened = asked.found("variant", text=text, design="this", changes=best["inputs"])[0]["text"]
    assert gw.size(gw.parse(opened)).mass == pytest.approx(best["results"]["mass_kg"], rel=1e-12)


@pytest.mark.parametrize(
    "name", ["../a.journal", "a.toml", "", "a/b.journal", ".journal", "link.journal", "pipe.journal"]
)
def test_a_journal_lies_in_the_folder_and_is_a_file(asked, name):
    if not (asked.folder / "link.journal").is_symlink():
        (asked.folder / "link.journal").symlink_to("/etc/hostname")
        os.mkfifo(asked.folder / "pipe.journal")
    for verb in ("rows", "resume", "study"):
        answer = asked.job(verb, text=text_of("single-planetary"), study=STUDY, journal=name)[1]
        assert answer.status_code == 422 and answer.json()["problems"], (verb, answer.text)


def test_a_journal_of_another_program_is_refused(asked):
    with sqlite3.connect(asked.folder / "other.journal") as database:
        database.execute("CREATE TABLE a (b)")
    assert asked.job("rows", text="", journal="other.journal")[1].status_code == 422


def test_a_computation_is_ended_with_its_process_and_the_next_one_is_answered(asked):
    async def asking():
        async with asked.client() as client:
            body = {"text": text_of("ec120b"), "page": "one"}
            place = f"/api/jobs/{(await client.post('/api/jobs/moved', json=body)).json()['job']}"
            await asyncio.sleep(0.5)
            jobs = asked.desk.jobs
            process = jobs.of(place.rpartition("/")[2]).worker._process
            await client.post(f"{place}/stop", json={})
            first = events_of((await client.get(f"{place}/events")).text)
            again = events_of(
                (await client.get(f"{place}/events", headers={"last-event-id": str(first[-1]["number"])})).text
            )
            return process, first, again

    process, first, again = asked.runner.run(asking())
    assert not process.is_alive() and "stopped" in first[-1] and again == []
    assert asked.found("modes", text=text_of("single-planetary"))[0]["rigid"] == 1


def test_too_many_computations_are_refused_and_those_of_a_window_replace_each_other(asked):
    text = text_of("single-planetary")

    async def asking():
        async with asked.client() as client:

            async def begun(verb, page):
                return await client.post(f"/api/jobs/{verb}", json={"text": text, "page": page})

            sent = [await begun("moved", str(k)) for k in range(40)]
            same = [(await begun("modes", "0")).status_code for _ in range(3)]
            for one in sent:
                if one.status_code == 200:
                    await client.post(f"/api/jobs/{one.json()['job']}/stop", json={})
            mine = [(await begun("modes", "0")).json()["job"] for _ in range(4)]
            ends = [events_of((await client.get(f"/api/jobs/{name}/events")).text)[-1] for name in mine]
            return [one.status_code for one in sent], same, ends

    statuses, same, ends = asked.runner.run(asking())
    assert set(statuses) == {200, 429} and statuses.count(200) <= 10 and set(same) <= {200, 429}
    assert all("replaced" in end for end in ends[:-1]) and ends[-1]["finished"]


def test_a_computation_that_nobody_began_is_not_there(asked):
    for place in ("nope/events", "nope/result", "%2e%2e/result"):
        assert asked.ask("GET", f"/api/jobs/{place}").status_code == 404
    assert asked.post("/api/jobs/nope/stop").status_code == 404
    assert asked.post("/api/jobs/nope", text="").status_code in (404, 405)


def test_the_peaks_of_a_window_are_tangential_and_its_curves_run_along_the_line_of_action(asked):
    """F_t = F cos α_wt: two numbers of one mesh, each under its own name, and the least of both margins."""
    short = '\n[windows.short]\nphase = "cruise"\nduration_s = 0.2\nevent = "motor-cut"\nevent_at_s = 0.1\n'
    mission = gw.shipped_mission("thesis").read_text(encoding="utf-8") + short
    head = asked.found("window", text=text_of("in-line-h2"), mission=mission, window="short")[0]
    ranges = {row["name"]: max(abs(row["minimum"]), abs(row["maximum"])) for row in head["ranges"]}
    angles = {mesh.name: mesh.working_pressure_angle for mesh in gw.size(gw.read("in-line-h2")).meshes}
    curves = {one["name"]: one.get("what") for one in head["series"]}
    for row in head["meshes"]:
        names = [name for name in curves if name.startswith(row["mesh"])]
        assert {curves[name] for name in names} == {"force along the line of action"}
        largest = max(ranges[name] for name in names)
        assert row["peak_force_n"] == pytest.approx(largest * np.cos(angles[row["mesh"]]), rel=1e-9)
    page = (Path(gw.__file__).parent / "app/static/flight/windows.js").read_text(encoding="utf-8")
    assert "peak tangential force F_t" in page and "Math.min(row.bending_margin, row.contact_margin)" in page
