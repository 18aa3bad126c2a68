"""A motor's controller in Python beside the gearbox as an FMU: it holds the propeller's speed when the turbine weakens.

gearwright export in-line-h2 --to fmu --case cruise
python speed_control.py in-line-h2-gearbox.fmu

It needs FMPy (pip install fmpy), and not gearwright.
"""

import shutil
import sys

import fmpy
from fmpy.fmi2 import FMU2Slave

PERIOD, END, FAULT = 5e-4, 0.5, 0.1  # s: of the controller, of the run, when the turbine loses a tenth of its torque
GAIN, INTEGRAL, LARGEST = 400.0, 3000.0, 2000.0  # N m s/rad, N m/rad, N m

description = fmpy.read_model_description(sys.argv[1])
reference = {variable.name: variable.valueReference for variable in description.modelVariables}
folder = fmpy.extract(sys.argv[1])
identifier = description.coSimulation.modelIdentifier
gearbox = FMU2Slave(guid=description.guid, unzipDirectory=folder, modelIdentifier=identifier, instanceName="gearbox")
gearbox.instantiate()
gearbox.setupExperiment(startTime=0.0)
gearbox.setBoolean([reference["phases_follow"]], [True])
gearbox.enterInitializationMode()
gearbox.exitInitializationMode()


def value(name):
    return gearbox.getReal([reference[name]])[0]


wanted, turbine, motor = (value(name) for name in ("propeller.speed", "gas-turbine.torque", "electric.torque"))
total, lowest = 0.0, wanted
for count in range(round(END / PERIOD)):
    error = wanted - value("propeller.speed")
    total += error * PERIOD
    torque = min(max(motor + GAIN * error + INTEGRAL * total, -LARGEST), LARGEST)
    gearbox.setReal([reference["electric.torque"]], [torque])
    if count == round(FAULT / PERIOD):
        gearbox.setReal([reference["gas-turbine.torque"]], [0.9 * turbine])
    gearbox.doStep(currentCommunicationPoint=count * PERIOD, communicationStepSize=PERIOD)
    lowest = min(lowest, value("propeller.speed"))
print(f"propeller: wanted {wanted:.2f}, lowest {lowest:.2f}, at the end {value('propeller.speed'):.2f} rad/s")
print(f"motor: {motor:.0f} N m before, {value('electric.acting_torque'):.0f} N m at the end")
gearbox.terminate()
gearbox.freeInstance()
shutil.rmtree(folder)
