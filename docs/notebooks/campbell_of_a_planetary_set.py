# %% [markdown]
# # The Campbell diagram of your own planetary set
#
# For a researcher: from numbers in your head to natural frequencies against speed. Type `gw.` and let the editor
# complete the rest; everything is SI, but for the design's text, whose keys carry their units.

# %%
import numpy as np

import gearwright as gw

# %% [markdown]
# A set with three planets: the turbine drives the sun, the ring stands still, the carrier drives the propeller.
# Teeth and module are left out, so that gearwright chooses them; `teeth` and `module_mm` state your own.

# %%
design = gw.parse(
    """
schema = 1
name = "My planetary set"
shafts = ["input", "output"]

[turbines.turbine]
shaft = "input"
power_kw = 300
speed_rpm = 12000

[propellers.propeller]
shaft = "output"
speed_rpm = 2600
diameter_m = 2.4
blades = 4

[planetaries.set]
sun = "input"
ring = "ground"
carrier = "output"
planets = 3
"""
)
design

# %% [markdown]
# Sized, and assembled: bodies that turn, and lines between them.

# %%
sizing = gw.size(design)
sizing

# %%
system = gw.assemble(sizing)
modes = gw.modes(system)
modes

# %% [markdown]
# The diagram from a tenth to one and a half times the operating speed. Rays are what excites: meshes with their
# harmonics, and shafts that turn; dots are where the two meet.

# %%
diagram = gw.campbell(system)
diagram

# %% [markdown]
# Which meetings are excited, how strongly, and how far they are from the operating speed, worst first:

# %%
case = gw.critical_speeds(sizing)[0]
excited = [critical for critical in case.critical if critical.excited]
[f"{critical.order}: {critical.frequency:.0f} Hz, {critical.margin:+.1%}" for critical in excited[:5]]

# %% [markdown]
# The figure as a file, and the numbers for another program:

# %%
gw.figure(diagram).savefig("campbell.png")
np.savetxt("campbell.csv", np.column_stack([diagram.factor, diagram.frequency]), delimiter=",")

# %% [markdown]
# A run shows how large the forces become.

# %%
trace = gw.simulate(system, 0.01)
trace
