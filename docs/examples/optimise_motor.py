"""OpenMDAO finds speed and size of the motor of In-Line H2: least mass of gearbox, motor and fuel with a given battery.

It needs gearwright with its extra openmdao. The motor's share s is that of the ratings and of the mission's powers.
Teeth are whole numbers, over which no gradient leads: a grid chooses them, and from its lightest, with their teeth
held, SLSQP finds speed and share by the component's partials. The motor is not to be built for more speed than the
teeth give it, which a sizing alone is free to do (teeth.speed_tolerance).
"""

import openmdao.api as om

import gearwright as gw
from gearwright.exchange.openmdao import component, variable

SPEED, SHAFT, ENERGY = "motors.electric.speed_rpm", "cases.rated.intermediate.speed", "fly.battery_energy"
PHASES = ", ".join(f"mission.phases.{name}.electric_share" for name in ("run-up", "take-off", "climb", "cruise"))
OF_SHARE = {  # what follows from the share: ratings and core of 2051 kW together, 1517 kW in cruise
    PHASES: "s",
    "motors.electric.power_kw": "2051 * s",
    "turbines.gas-turbine.power_kw": "2051 * (1 - s)",
    "mission.engine.thermal_power_kw": "4903 * (1 - s)",
    "cases.cruise.electric.power_kw": "1517 * s",
    "cases.cruise.gas-turbine.power_kw": "1517 * (1 - s)",
}
BATTERY = 500.0  # kWh that a flight may draw
FLOWN = {"battery.energy_kwh": 2000, "motor.overload": 1.06, "step_s": 30}
DESIGN, MISSION = gw.read("in-line-h2"), gw.edited_mission(gw.read_mission("thesis"), FLOWN)


def problem(speed, share, teeth):
    """Return mass of gearbox, motor and fuel over the motor's speed [rpm] and share, to begin at these."""
    start = {SPEED: speed} | {path: eval(text, {"s": share}) for path, text in OF_SHARE.items()}
    box = component(DESIGN, start, ["total_mass", "fly.fuel", ENERGY, SHAFT], teeth=teeth, mission=MISSION)
    units = {f"y{place}": {"units": "kW" if path.endswith("_kw") else None} for place, path in enumerate(OF_SHARE)}
    of_share = om.ExecComp([f"y{place} = {text}" for place, text in enumerate(OF_SHARE.values())], **units)
    kg, rpm = {"units": "kg"}, {"units": "rpm"}
    sums = om.ExecComp("mass = box + fuel", mass=kg, box=kg, fuel=kg)
    ahead = om.ExecComp("ahead = speed - shaft", ahead=rpm, speed=rpm, shaft=rpm)
    made = om.Problem(reports=False)
    made.model.add_subsystem("share", of_share, promotes_inputs=["s"])
    made.model.add_subsystem("box", box, promotes_inputs=[(variable(SPEED), "speed")])
    made.model.add_subsystem("sums", sums, promotes_outputs=["mass"])
    made.model.add_subsystem("speeds", ahead, promotes=["ahead", "speed"])
    for place, path in enumerate(OF_SHARE):
        made.model.connect(f"share.y{place}", f"box.{variable(path)}")
    made.model.connect("box.total_mass", "sums.box")
    made.model.connect("box.fly:fuel", "sums.fuel")
    made.model.connect(f"box.{variable(SHAFT)}", "speeds.shaft")
    made.model.set_input_defaults("speed", speed, units="rpm")
    made.model.add_design_var("speed", units="rpm", lower=0.97 * speed, upper=1.02 * speed, ref=1000.0)
    made.model.add_design_var("s", lower=share - 0.05, upper=share + 0.05, ref=0.1)
    made.model.add_objective("mass", ref=100.0)
    made.model.add_constraint("ahead", units="rpm", upper=0.0, ref=100.0)
    made.model.add_constraint(f"box.{variable(ENERGY)}", units="kW*h", upper=BATTERY, ref=100.0)
    made.driver = om.ScipyOptimizeDriver(optimizer="SLSQP", tol=1e-5, disp=False)
    made.setup()
    made.set_val("s", share)
    return made


def state(made):
    """Return mass [kg], speed and that above the shaft's [rpm], share, and energy of the battery [kWh]."""
    energy = made.get_val(f"box.{variable(ENERGY)}", units="kW*h")
    values = made.get_val("mass"), made.get_val("speed", units="rpm"), made.get_val("ahead"), made.get_val("s"), energy
    return tuple(float(value[0]) for value in values)


def grid(speeds, shares):
    """Return the states of a grid, the lightest first; where nothing can be sized there is none."""
    made, states = problem(5000.0, 0.3, "chosen"), []
    for speed in speeds:
        for share in shares:
            made.set_val("speed", speed, units="rpm")
            made.set_val("s", share)
            try:
                made.run_model()
            except om.AnalysisError:
                continue
            states.append((state(made), made.model.box.designed()))
    return sorted((entry for entry in states if entry[0][4] <= BATTERY), key=lambda entry: entry[0])


def told(words, mass, speed, ahead, share, energy):
    """Print a state in a line."""
    print(f"{words}: {mass:.2f} kg at {speed:.0f} rpm ({ahead:+.0f} to the shaft), share {share:.3f}, {energy:.0f} kWh")


if __name__ == "__main__":
    found = grid([5200.0 + 50.0 * k for k in range(15)], [0.24, 0.28, 0.32, 0.36])
    told("best of the grid", *next(entry for entry, _ in found if entry[2] <= 0.0))
    starts = {round(entry[1] - entry[2], 3): entry for entry, _ in reversed(found)}  # the lightest of equal teeth
    ends = []
    for entry in sorted(starts.values())[:4]:
        made = problem(entry[1], entry[3], "frozen")
        made.run_driver()
        ends.append((state(made), made.model.box.designed()))
    best, design = min((end for end in ends if end[0][2] <= 0.01), key=lambda end: end[0])
    told("SLSQP, teeth held", *best)
    print(gw.size(design))
