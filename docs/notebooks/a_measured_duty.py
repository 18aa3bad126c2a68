# %% [markdown]
# # From a measured torque to lives and cycles
#
# For a researcher with a record of a test bench: rotations under torque for gears, rainflow cycles for shafts.

# %%
from pathlib import Path

import numpy as np

import gearwright as gw
from gearwright.mission.lives import torque_cycles

# %% [markdown]
# A record of ten minutes, made up here so that the notebook needs no file: a mean that climbs, and a swing of 0.1 Hz.

# %%
time = np.arange(0.0, 600.0, 0.5)
torque = 1000.0 + 500.0 * time / 600.0 + 200.0 * np.sin(0.2 * np.pi * time)
rows = "\n".join(f"{t:.1f},{m:.1f},12000" for t, m in zip(time, torque, strict=True))
Path("bench.csv").write_text(f"time_s,torque_nm,speed_rpm\n{rows}\n", encoding="utf-8")
measured = gw.read_duty("bench.csv")
measured

# %%
spectrum = gw.duty(measured, classes=10)
print(spectrum.text("gas-turbine"))
spectrum

# %% [markdown]
# Ranges that close no loop count half, or the record is one period of many (ASTM E1049-85, 5.4.4 and 5.4.5):

# %%
for residue in ("half-cycles", "repeated"):
    cycles = torque_cycles(measured, residue=residue)
    count = sum(cycle.count for cycle in cycles)
    print(f"{residue}: {count:g} cycles, the largest {cycles[0].range:.0f} N m about {cycles[0].mean:.0f} N m")

# %% [markdown]
# What a swing of the torque costs: a gearbox whose shafts bear the largest cycle, beside one as it is.

# %%
design = gw.read("ec120b")
sizing = gw.size(design)
sizing

# %%
swing = max(cycle.range / 2.0 / cycle.mean for cycle in torque_cycles(measured, residue="repeated"))
swung = gw.size(gw.edited(design, {"service.torque_swing": round(swing, 3)}))
print(f"swing {swing:.3f}: {swung.mass:.2f} kg for {sizing.mass:.2f} kg at {design.service.torque_swing:g}")
swung
