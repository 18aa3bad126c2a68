# %% [markdown]
# # How a planetary set works
#
# For a student of machine elements: one set, its ratio by Willis, its forces by hand and by program.

# %%
import math

import gearwright as gw
from gearwright.units import RPM

# %%
design = gw.read("single-planetary")
design

# %% [markdown]
# gearwright chose teeth. With the ring at rest Willis' equation says $i = 1 + z_r/z_s$.

# %%
sizing = gw.size(design)
sun, ring = sizing.teeth["first.sun"], sizing.teeth["first.ring"]
speeds = sizing.flows["rated"].speeds
ratio = speeds["input"] / speeds["output"]
print(f"z_s = {sun}, z_r = {ring}: 1 + z_r/z_s = {1 + ring / sun:.4f}, input over output = {ratio:.4f}")
assert math.isclose(ratio, 1 + ring / sun)

# %% [markdown]
# The torque of the sun is power over speed; each planet takes its part of it at the sun's pitch radius.

# %%
torque = 2051e3 / abs(speeds["input"])
mesh = sizing.meshes[0]
gear = next(gear for gear in sizing.gears if gear.name == "first.sun")
by_hand = torque / design.planetaries["first"].planets / (gear.pitch_diameter / 2)
print(f"sun {torque:.0f} N m at {abs(speeds['input']) / RPM:.0f} rpm, by hand {by_hand / 1e3:.2f} kN in each mesh")
print(f"{mesh.name}: {mesh.tangential_force / 1e3:.2f} kN, with what the load factor adds")

# %% [markdown]
# What vibrates, and at which frequency:

# %%
system = gw.assemble(sizing)
gw.modes(system)

# %% [markdown]
# The force in a mesh over time: its mean is the force from statics, around it the teeth come and go.

# %%
trace = gw.simulate(system, 0.005)
force = trace.force.of("first.sun-planet-1")
print({name: f"{float(value[-1]) / 1e3:.2f} kN" for name, value in force.items()})
trace

# %% [markdown]
# Is what the program computes right? It says so itself, beside published numbers:

# %%
[(number.case, number.expected, round(number.got, 1)) for number in gw.validate("planetary set, N = 3")[:3]]
