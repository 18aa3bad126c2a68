# %% [markdown]
# # Which architecture, how heavy, does it hold
#
# For preliminary design: a requirement, the masses of several architectures, one of them judged and flown.

# %%
from pathlib import Path

import gearwright as gw
from gearwright.units import RPM

# %% [markdown]
# What the gearbox of a 2051 kW turboprop weighs by statistics, before anything is drawn:

# %%
estimate = gw.mass(2051e3, 20204 * RPM, 1212 * RPM)
print(f"{estimate.taken.mass:.0f} kg, between {estimate.spread[0]:.0f} and {estimate.spread[1]:.0f} kg by method")

# %% [markdown]
# Two architectures for one engine, side by side:

# %%
designs = {name: gw.read(name) for name in ("in-line", "off-set")}
table = gw.compare(designs, power=1800e3)
table

# %% [markdown]
# One of them as it stands, and with another rule; a design does not change, `gw.edited` returns another one.

# %%
design = gw.read("in-line-h2")
sizing = gw.size(design)
faster = gw.size(gw.edited(design, {"motors.electric.speed_rpm": 5000}))
print(f"{sizing.mass:.1f} kg, with the faster motor {faster.mass:.1f} kg")
sizing

# %% [markdown]
# Does it hold? Every check there is, worst first, and a flight with what it burns:

# %%
mission = gw.read_mission("thesis")
review = gw.review(design, mission)
review

# %%
flight = gw.fly(sizing, mission)
flight

# %% [markdown]
# A study: motor speed against mass.

# %%
study = gw.study(gw.read_study("motor-speed"))
study

# %% [markdown]
# And the report for a colleague, one file that prints:

# %%
Path("report.html").write_text(gw.report(sizing), encoding="utf-8")
