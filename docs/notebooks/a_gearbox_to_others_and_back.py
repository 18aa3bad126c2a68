# %% [markdown]
# # A gearbox to other tools and back
#
# For a designer whose gearbox came from another tool: read it, hold its safeties beside
# ours, look at losses, hand it on.

# %%
from pathlib import Path

import gearwright as gw
from gearwright.exchange.tables import table_csv

# %%
sizing = gw.size(gw.read("e-axle"))
file = gw.to_rexs(sizing)
Path("e-axle.rexs").write_bytes(file.content)
file

# %% [markdown]
# What has no words in REXS is listed, and what is read says what it assumed:

# %%
print(*file.left_out, sep="\n")
imported = gw.from_rexs("e-axle.rexs")
assert imported.design == sizing.design
imported.design

# %% [markdown]
# Safeties that the file states, beside those that come out here:

# %%
again = gw.size(imported.design)
for stated in imported.stated:
    print(f"{stated.gear}: {stated.symbol} {stated.value:.3f} stated, {stated.ours(again):.3f} here")
    assert abs(stated.value - stated.ours(again)) < 1e-9
again

# %% [markdown]
# Where its power goes, and a table for the spreadsheet of a colleague:

# %%
gw.loss_balance(again)

# %%
Path("gears.csv").write_text(table_csv(again, "gears"), encoding="utf-8-sig")
